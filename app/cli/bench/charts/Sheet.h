// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QGraphicsScene>
#include <QRectF>

#include "app/cli/bench/charts/Chart.h"
#include "app/cli/bench/charts/Look.h"

namespace app::cli::bench {

/// A chart as the bytes of its two files.
struct Pictures
{
    QByteArray svg;
    QByteArray png;  ///< kChartWidth x kChartHeight
};

/// Draws a chart with title and footer. Needs a QApplication, but no display: the platform "offscreen" does.
/// @param footer  where, when and with what it was measured; one line
[[nodiscard]] Pictures draw(const Chart& chart, const QString& footer);

// One function per kind of chart, each in its own file: puts the content into a part of the scene.
void add(QGraphicsScene& scene, const QRectF& place, const CurveChart& content);
void add(QGraphicsScene& scene, const QRectF& place, const BarChart& content);
void add(QGraphicsScene& scene, const QRectF& place, const MapChart& content);

/// Puts a line of text into the scene: with its left, middle or right at `at.x`, and its middle at `at.y`.
QGraphicsItem* addText(QGraphicsScene& scene, const QString& text, const QFont& font, const QColor& colour, QPointF at,
                       Qt::Alignment alignment = Qt::AlignLeft);

}  // namespace app::cli::bench
