// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/Chart.h"

#include <algorithm>
#include <cmath>

namespace ui::charts {
namespace {

QList<Dot> stops(const Curve& curve)
{
    QList<Dot> made;
    for (const Line& line : curve.lines)
        if (line.mark != Mark::None)
            made += line.dots;
    if (made.isEmpty())
        for (const Slice& slice : curve.band.slices)
            made << Dot{slice.x, slice.middle, slice.words, 0};
    std::stable_sort(made.begin(), made.end(), [](const Dot& a, const Dot& b) { return a.x < b.x; });
    return made;
}

QList<Dot> stops(const Bars& bars)
{
    QList<Dot> made;
    for (qsizetype k = 0; k < bars.bars.size(); ++k)
        made << Dot{bars.bars[k].value, -static_cast<double>(k), bars.bars[k].words, 0};
    return made;
}

QList<Dot> stops(const Histogram& histogram)
{
    QList<Dot> made;
    for (const Histogram::Bin& bin : histogram.bins)
        made << Dot{0.5 * (bin.from + bin.to), static_cast<double>(bin.count), bin.words, 0};
    return made;
}

Frame frame(const Curve& curve)
{
    return {curve.x.low, curve.x.high, curve.y.low, curve.y.high};
}

Frame frame(const Bars& bars)
{
    return {bars.value.low, bars.value.high, 0.5 - static_cast<double>(std::max(qsizetype{1}, bars.bars.size())), 0.5};
}

Frame frame(const Histogram& histogram)
{
    return {histogram.x.low, histogram.x.high, histogram.count.low, histogram.count.high};
}

}  // namespace

QList<Dot> stopsOf(const Chart& chart)
{
    return std::visit([](const auto& content) { return stops(content); }, chart.content);
}

Frame frameOf(const Chart& chart)
{
    return std::visit([](const auto& content) { return frame(content); }, chart.content);
}

double roundEnd(double value)
{
    if (!(value > 0.0))
        return 1.0;
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 2.5, 5.0})
        if (value <= step * decade)
            return step * decade;
    return 10.0 * decade;
}

}  // namespace ui::charts
