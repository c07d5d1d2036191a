// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace ui::tooth {

// What is painted over the picture of a tooth.

/// An arrow from the bur towards a handpiece that has left the view: red, and seen through.
void paintArrowOut(QPainter& painter, QSizeF view, QPointF from, QPointF towards);

/// The scale of the depth colours with its figures, in the lower left corner.
void paintDepthScale(QPainter& painter, QSizeF view, double endMm);

/// A short text on a dark plate beside a place.
void paintPlate(QPainter& painter, QPointF beside, const QString& text, bool onTheLeft);

}  // namespace ui::tooth
