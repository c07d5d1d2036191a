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

/// The colours a chart is drawn in. Lines and areas differ by stroke and shape besides.
struct Ink
{
    QColor words;
    QColor quiet;  ///< of axes and the pass mark
    QColor grid;
    QColor ground;  ///< inside hollow marks
    QColor first;   ///< of the first line, of bars
    QColor second;
    QColor band;
};

[[nodiscard]] Ink inkOf(const QPalette& palette);
/// Black and greys on white.
[[nodiscard]] Ink paperInk();

/// So many bars have room for their names, in two lines where one is not enough for one of them.
[[nodiscard]] int rowsFor(const Chart& chart, const QSizeF& roomPx);

/// The names of bars as they are written beside an axis of this height: folded, and shortened where they must be.
[[nodiscard]] QStringList namesOf(const Bars& bars, const QSizeF& roomPx);

/// Where values lie between the axes.
struct Plot
{
    QRectF px;
    Axis x;
    Axis y;
    [[nodiscard]] QPointF at(double xValue, double yValue) const;
    [[nodiscard]] double xAt(double atPx) const;
};
[[nodiscard]] Plot plotOf(const Chart& chart, const QRectF& area);

/// The chart alone, with its axes and its key.
void draw(QPainter& painter, const QRectF& area, const Chart& chart, const Ink& ink);

/// Title, chart and note. Needs a QApplication, and no window. Letters have the size they have on the screen when one
/// unit of the painter is a pixel of it.
void paint(QPainter& painter, const QRectF& area, const Chart& chart, const Ink& ink);

/// A picture file in light colours on white. Empty for a chart without values.
[[nodiscard]] QByteArray png(const Chart& chart);
[[nodiscard]] QByteArray svg(const Chart& chart);

}  // namespace ui::charts
