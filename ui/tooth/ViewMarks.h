// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QString>

#include "ui/render/Gizmo.h"
#include "ui/render/Presenter.h"
#include "ui/render/ToothSurface.h"

namespace ui::tooth {

// Marks painted over the picture of a tooth.

/// Radius of the gizmo, and its margin in the upper left corner, pixels.
inline constexpr int kGizmoPx = 36;
inline constexpr int kGizmoInPx = 16;

/// Returns the letters at the ends of the gizmo for a tooth of the left half; empty for no tooth.
[[nodiscard]] render::GizmoLetters gizmoLetters(int fdi);

/// Paints a translucent red arrow from the bur towards a handpiece outside the view. Paints nothing if the handpiece is
/// in view.
void paintArrowOut(QPainter& painter, QSizeF view, QPointF from, QPointF towards);

/// Paints the scale of the depth colours at the right, or at the left while the bur is at the right.
void paintDepthScale(QPainter& painter, QSizeF view, const render::Look& look, const render::Presentation& how,
                     const std::optional<QPointF>& bur = {});

/// Returns the cut depth at a place in words, with the meaning of that scale.
[[nodiscard]] QString depthWords(const render::ToothSurface& surface, const glm::dvec3& pointMm,
                                 render::DepthColours colours);

/// Paints a short text on a dark plate beside a place, or on its other side if the view has no room for it.
/// @param gapPx  between the place and the plate; kOffBurPx beside the bur
void paintPlate(QPainter& painter, QSizeF view, QPointF place, double gapPx, const QString& text, bool onTheLeft);

}  // namespace ui::tooth
