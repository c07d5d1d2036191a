// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QColor>
#include <QPalette>
#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "ui/charts/Chart.h"

class QPainter;

namespace ui::charts {

/// The colours of a chart. Lines and areas also differ by stroke and shape.
struct Ink
{
    QColor words;
    QColor quiet;  ///< axes and the pass mark
    QColor grid;
    QColor ground;  ///< inside hollow marks
    QColor first;   ///< the first line, and bars
    QColor second;
    QColor band;
};

[[nodiscard]] Ink inkOf(const QPalette& palette);
/// Returns black and greys on white.
[[nodiscard]] Ink paperInk();

/// Returns the number of bars that fit with their names, in two lines if one name needs two.
[[nodiscard]] int rowsFor(const Chart& chart, const QSizeF& roomPx);

/// Returns the names of bars for an axis of this height, wrapped and elided as needed.
[[nodiscard]] QStringList namesOf(const Bars& bars, const QSizeF& roomPx);

/// The rectangle of the axes, for conversion between values and pixels.
struct Plot
{
    QRectF px;
    Axis x;
    Axis y;
    [[nodiscard]] QPointF at(double xValue, double yValue) const;
    [[nodiscard]] double xAt(double atPx) const;
};
[[nodiscard]] Plot plotOf(const Chart& chart, const QRectF& area);

/// Paints the chart alone, with its axes and its legend.
void draw(QPainter& painter, const QRectF& area, const Chart& chart, const Ink& ink);

/// Paints title, chart and note. Needs a QApplication, but no window. If one unit of the painter is one pixel, font
/// sizes equal those of the screen.
void paint(QPainter& painter, const QRectF& area, const Chart& chart, const Ink& ink);

/// Returns an image file in light colours on white. Empty for a chart without values.
[[nodiscard]] QByteArray png(const Chart& chart);
[[nodiscard]] QByteArray svg(const Chart& chart);

}  // namespace ui::charts
