// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include <QPainter>
#include <QPolygonF>
#include <QString>

namespace ui::tooth {

/// A point of the tooth that is to be touched, or one with a name, which is shown until it is cut.
struct PointMark
{
    glm::dvec2 placeMm{0.0};  ///< tooth frame, seen from above
    double reachMm = 0.6;
    bool isTouched = false;
    QString name = {};
    bool operator==(const PointMark&) const = default;
};

/// A pad of a block whose outline is seen and nothing else of it.
struct PadMark
{
    QString name;
    glm::dvec2 fromMm{0.0};  ///< two opposite corners, tooth frame, at its top z = 0
    glm::dvec2 toMm{0.0};
    bool operator==(const PadMark&) const = default;
};

/// What an exercise paints over the tooth.
struct ExerciseMarks
{
    std::vector<PointMark> points;
    std::vector<PadMark> pads;  ///< not empty: the view is blindfolded, and these outlines are all that is seen
    /// A scale tells how high the bur stands: what a hand would feel of itself, for who has only a mouse.
    bool showsHeight = false;
    bool operator==(const ExerciseMarks&) const = default;
};

/// Touched: a filled disc with a tick. Else a ring; broken where the tooth lies before it.
void paintPoint(QPainter& painter, QPointF at, double radiusPx, bool isTouched, bool isHidden);

/// A place that is spoken of: a needle with a round head whose tip is at the place; hollow where the tooth lies before
/// it.
void paintPin(QPainter& painter, QPointF at, bool isHidden);

/// Nothing but a plain ground.
void paintBlindfold(QPainter& painter, const QRectF& view);
void paintPad(QPainter& painter, const QPolygonF& outline, const QString& name);
/// The bur over the pads: a ring in the air, filled where it touches.
void paintBurSpot(QPainter& painter, QPointF at, bool isTouching);
/// In the upper left corner of a view.
/// @param heightMm  of the tip over the pads' tops
void paintHeight(QPainter& painter, QSizeF view, double heightMm);

}  // namespace ui::tooth
