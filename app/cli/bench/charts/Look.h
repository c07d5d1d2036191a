// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBrush>
#include <QColor>
#include <QFont>
#include <QScatterSeries>

#include "app/cli/bench/charts/Chart.h"

/// How charts look: dark on light, letters that are read at arm's length, and no method told apart by colour alone.
namespace app::cli::bench {

inline constexpr int kChartWidth = 1600;
inline constexpr int kChartHeight = 1000;
inline constexpr int kTitlePx = 36;
inline constexpr int kTextPx = 22;
inline constexpr int kNotePx = 18;

struct Look
{
    QColor colour;
    QScatterSeries::MarkerShape marker;
    Qt::PenStyle line;
    Qt::BrushStyle hatching;
};
[[nodiscard]] const Look& lookOf(LookIndex index);

/// Inter, or DejaVu Sans where there is none.
[[nodiscard]] QFont chartFont(int pixels, bool bold = false);

[[nodiscard]] QColor inkColour();    ///< of titles and figures
[[nodiscard]] QColor quietColour();  ///< of what is less important: still 4.5 : 1
[[nodiscard]] QColor gridColour();
[[nodiscard]] QColor limitColour();

}  // namespace app::cli::bench
