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

/// The letters at the ends of a tooth's axes: -x, +x, -y, +y, -z, +z. Empty: that end is not drawn.
using GizmoLetters = std::array<QString, 6>;

/// Paints the three axes of a tooth as a small cross for orientation, with a letter at each end. Axes that point away
/// are small and faint.
/// @param eyeFromTooth  rotation, mirrored for a mirrored tooth
/// @param radiusPx      of the whole cross
void paintGizmo(QPainter& painter, QPointF centre, double radiusPx, const glm::dmat3& eyeFromTooth,
                const GizmoLetters& letters);

/// Returns the axis end that is painted at a point, preferring the one nearest to the eye. Empty if there is none. The
/// other parameters are those of paintGizmo().
[[nodiscard]] std::optional<std::size_t> gizmoEndAt(QPointF point, QPointF centre, double radiusPx,
                                                    const glm::dmat3& eyeFromTooth, const GizmoLetters& letters);

}  // namespace ui::render
