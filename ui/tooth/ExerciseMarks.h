// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include <QPainter>
#include <QPolygonF>
#include <QString>

namespace ui::tooth {

/// A point to touch, or a named point that is shown until it is cut.
struct PointMark
{
    glm::dvec2 placeMm{0.0};  ///< tooth frame, seen from above
    double reachMm = 0.6;
    bool isTouched = false;
    QString name = {};
    bool operator==(const PointMark&) const = default;
};

/// A pad of a block of which only the outline is shown.
struct PadMark
{
    QString name;
    glm::dvec2 fromMm{0.0};  ///< two opposite corners, tooth frame, at its top z = 0
    glm::dvec2 toMm{0.0};
    bool operator==(const PadMark&) const = default;
};

/// The marks of an exercise, painted over the tooth.
struct ExerciseMarks
{
    std::vector<PointMark> points;
    std::vector<PadMark> pads;  ///< if not empty, the view is blindfolded and shows only these outlines
    /// Shows a scale of the bur's height, for users of a mouse, who cannot feel it.
    bool showsHeight = false;
    bool operator==(const ExerciseMarks&) const = default;
};

/// Paints a point: a filled disc with a tick if it was touched, otherwise a ring; dashed if the tooth hides it.
void paintPoint(QPainter& painter, QPointF at, double radiusPx, bool isTouched, bool isHidden);

/// Paints a pin with its tip at the place that a comment is about; hollow if the tooth hides it.
void paintPin(QPainter& painter, QPointF at, bool isHidden);

/// Paints a plain background that hides the tooth.
void paintBlindfold(QPainter& painter, const QRectF& view);
void paintPad(QPainter& painter, const QPolygonF& outline, const QString& name);
/// Paints the bur over the pads: a ring in the air, filled when it touches.
void paintBurSpot(QPainter& painter, QPointF at, bool isTouching);
/// Paints the scale of the bur's height in the upper left corner of a view.
/// @param heightMm  of the tip above the tops of the pads
void paintHeight(QPainter& painter, QSizeF view, double heightMm);

}  // namespace ui::tooth
