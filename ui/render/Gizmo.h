// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <glm/mat3x3.hpp>

#include <QPointF>
#include <QString>

class QPainter;

namespace ui::render {

/// What the ends of a tooth's axes are called: -x, +x, -y, +y, -z, +z. Empty: that end is not drawn.
using GizmoLetters = std::array<QString, 6>;

/// Paints a little cross of the three axes of a tooth as they are seen, with a letter at each end: which way round one
/// is looking. What points away is small and faint.
/// @param eyeFromTooth  rotation, mirrored for a tooth that stands mirrored
/// @param radiusPx      of the whole
void paintGizmo(QPainter& painter, QPointF centre, double radiusPx, const glm::dmat3& eyeFromTooth,
                const GizmoLetters& letters);

/// Returns which end of an axis is painted at a point, the nearest to the eye first; nothing if there is none. Other
/// arguments as for paintGizmo().
[[nodiscard]] std::optional<std::size_t> gizmoEndAt(QPointF point, QPointF centre, double radiusPx,
                                                    const glm::dmat3& eyeFromTooth, const GizmoLetters& letters);

}  // namespace ui::render
