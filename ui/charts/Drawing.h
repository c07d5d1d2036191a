// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QColor>
#include <QPalette>
#include <QRectF>
#include <QSizeF>

#include "ui/charts/Chart.h"

class QChart;
class QPainter;

namespace ui::charts {

/// The colours a chart is drawn in. Lines and areas differ by stroke, shape and hatching besides.
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

inline constexpr int kMostTicks = 6;
/// So many of the upright axis have room on a chart of this height.
[[nodiscard]] int ticksFor(double heightPx);
/// So many bars have room for their names, in two lines where one is not enough for one of them.
[[nodiscard]] int rowsFor(const Chart& chart, const QSizeF& roomPx);

/// Fills an empty chart with axes and series. Everything lies linearly between the ends of frameOf(chart).
/// @param roomPx  what there is for axes, names of bars and the rest
void draw(const Chart& content, const Ink& ink, QChart& into, const QSizeF& roomPx);

/// Title, chart and note. Needs a QApplication, and no window. Letters have the size they have on the screen when one
/// unit of the painter is a pixel of it.
void paint(QPainter& painter, const QRectF& area, const Chart& chart, const Ink& ink);

/// A picture file in light colours on white. Empty for a chart without values.
[[nodiscard]] QByteArray png(const Chart& chart);
[[nodiscard]] QByteArray svg(const Chart& chart);

}  // namespace ui::charts
