// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/Chart.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

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

QList<Dot> stops(const Map& map)
{
    QList<Dot> made;
    for (qsizetype row = 0; row < map.cells.size(); ++row)
        for (qsizetype k = 0; k < map.cells[row].size(); ++k)
            made << Dot{static_cast<double>(k) + 0.5, -0.5 - static_cast<double>(row), map.cells[row][k].note};
    return made;
}

std::pair<Axis, Axis> axes(const Curve& curve)
{
    constexpr double kEdgeShare = 0.05;
    Axis y = curve.y;
    const auto hasMarkAt = [&](double end) {
        return std::any_of(curve.lines.begin(), curve.lines.end(), [&](const Line& line) {
            return line.mark != Mark::None && line.mark != Mark::Plain &&
                   std::any_of(line.dots.begin(), line.dots.end(),
                               [&](const Dot& dot) { return std::abs(curve.y.shareOf(dot.y) - end) < kEdgeShare; });
        });
    };
    if (hasMarkAt(0.0))
        y.low = curve.y.valueAt(-kEdgeShare);
    if (hasMarkAt(1.0))
        y.high = curve.y.valueAt(1.0 + kEdgeShare);
    return {curve.x, y};
}

std::pair<Axis, Axis> axes(const Bars& bars)
{
    return {bars.value, {{}, 0.5 - static_cast<double>(std::max(qsizetype{1}, bars.bars.size())), 0.5}};
}

std::pair<Axis, Axis> axes(const Histogram& histogram)
{
    return {histogram.x, histogram.count};
}

std::pair<Axis, Axis> axes(const Map& map)
{
    return {{{}, 0.0, static_cast<double>(map.groups.size() * map.columns.size())},
            {{}, -static_cast<double>(map.rows.size()), 0.0}};
}

}  // namespace

double Axis::shareOf(double value) const
{
    return base > 0.0 ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

double Axis::valueAt(double share) const
{
    return base > 0.0 ? low * std::pow(high / low, share) : low + share * (high - low);
}

Chart fitted(const Chart& chart, int rows)
{
    const auto* const bars = std::get_if<Bars>(&chart.content);
    if (bars == nullptr || bars->bars.size() <= rows)
        return chart;
    Bars few = *bars;
    const qsizetype shown = std::max(1, rows - 1);
    QStringList left;
    for (qsizetype k = shown; k < bars->bars.size(); ++k)
        left << bars->bars[k].words;
    few.bars.resize(shown);
    const auto count = static_cast<int>(left.size());
    //: Bars of a chart that there is no room for
    const QString rest = QCoreApplication::translate("Chart", "and %n more", nullptr, count);
    few.bars << Bars::Bar{rest, 0.0, left.join(QStringLiteral("; "))};
    Chart made = chart;
    made.content = few;
    return made;
}

QList<Dot> stopsOf(const Chart& chart)
{
    return std::visit([](const auto& content) { return stops(content); }, chart.content);
}

std::pair<Axis, Axis> axesOf(const Chart& chart)
{
    return std::visit([](const auto& content) { return axes(content); }, chart.content);
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
