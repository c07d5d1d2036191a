// SPDX-License-Identifier: GPL-3.0-or-later
#include <QBarCategoryAxis>
#include <QBarSeries>
#include <QBarSet>
#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsRectItem>
#include <QLegend>
#include <QValueAxis>

#include "app/cli/bench/charts/Sheet.h"

namespace app::cli::bench {
namespace {

constexpr double kLegendHeight = 44.0;
constexpr double kGroupTitleHeight = 34.0;
constexpr double kSwatchPx = 26.0;
constexpr double kBarShare = 0.86;  ///< of the width of its group that all bars have

void dressAxis(QAbstractAxis& axis)
{
    axis.setTitleFont(chartFont(kTextPx, true));
    axis.setTitleBrush(inkColour());
    axis.setLabelsFont(chartFont(kTextPx));
    axis.setLabelsBrush(inkColour());
    axis.setLinePen(QPen(inkColour(), 1.5));
    axis.setGridLinePen(QPen(gridColour(), 1.0));
}

QBrush fillOf(LookIndex look)
{
    return {lookOf(look).colour, lookOf(look).hatching};
}

void addLegend(QGraphicsScene& scene, const QRectF& place, const QList<BarChart::Bars>& bars)
{
    double left = place.left() + 100.0;
    const double middle = place.top() + 0.4 * kLegendHeight;
    for (const BarChart::Bars& method : bars) {
        scene.addRect(left, middle - 0.5 * kSwatchPx, kSwatchPx, kSwatchPx, QPen(lookOf(method.look).colour, 2.0),
                      fillOf(method.look));
        const auto* const text =
            addText(scene, method.name, chartFont(kTextPx), inkColour(), {left + kSwatchPx + 10.0, middle});
        left += kSwatchPx + text->boundingRect().width() + 60.0;
    }
}

void addPanel(QGraphicsScene& scene, const QRectF& place, const BarChart& content, const BarChart::Panel& panel)
{
    auto* const chart = new QChart;
    scene.addItem(chart);
    chart->setMargins(QMargins(0, 0, 10, 0));
    chart->layout()->setContentsMargins(0.0, 0.0, 0.0, 0.0);
    chart->setBackgroundVisible(false);
    chart->legend()->hide();
    auto* const series = new QBarSeries;
    series->setBarWidth(kBarShare);
    for (const BarChart::Bars& method : panel.bars) {
        auto* const set = new QBarSet(method.name);
        set->setBrush(fillOf(method.look));
        set->setPen(QPen(lookOf(method.look).colour, 2.0));
        for (const double value : method.values)
            set->append(value);
        series->append(set);
    }
    chart->addSeries(series);
    auto* const groups = new QBarCategoryAxis;
    groups->append(content.groups);
    auto* const values = new QValueAxis;
    values->setRange(0.0, content.most);
    values->setTickType(QValueAxis::TicksDynamic);
    values->setTickInterval(content.interval);
    values->setLabelFormat(QStringLiteral("%g"));
    values->setTitleText(content.valueTitle);
    dressAxis(*groups);
    groups->setGridLineVisible(false);
    dressAxis(*values);
    chart->addAxis(groups, Qt::AlignBottom);
    chart->addAxis(values, Qt::AlignLeft);
    series->attachAxis(groups);
    series->attachAxis(values);
    chart->setGeometry(place);
    chart->layout()->activate();

    const QRectF plot = chart->mapRectToScene(chart->plotArea());
    addText(scene, panel.title, chartFont(kTextPx, true), inkColour(), {plot.right() - 12.0, plot.top() + 18.0},
            Qt::AlignRight);
    const double groupWidth = plot.width() / static_cast<double>(content.groups.size());
    const double barWidth = kBarShare * groupWidth / static_cast<double>(panel.bars.size());
    for (int k = 0; k < panel.bars.size(); ++k)
        for (int g = 0; g < panel.bars[k].values.size(); ++g) {
            const double height = plot.height() * panel.bars[k].values[g] / content.most;
            const double x = plot.left() + (g + 0.5 * (1.0 - kBarShare)) * groupWidth + (k + 0.5) * barWidth;
            addText(scene, panel.bars[k].notes[g], chartFont(kNotePx), inkColour(), {x, plot.bottom() - height - 14.0},
                    Qt::AlignHCenter);
        }
}

}  // namespace

void add(QGraphicsScene& scene, const QRectF& place, const BarChart& content)
{
    addLegend(scene, place, content.panels.front().bars);
    const double height =
        (place.height() - kLegendHeight - kGroupTitleHeight) / static_cast<double>(content.panels.size());
    for (int k = 0; k < content.panels.size(); ++k)
        addPanel(scene, {place.left(), place.top() + kLegendHeight + k * height, place.width(), height}, content,
                 content.panels[k]);
    addText(scene, content.groupTitle, chartFont(kTextPx, true), inkColour(),
            {place.center().x(), place.bottom() - 0.5 * kGroupTitleHeight}, Qt::AlignHCenter);
}

}  // namespace app::cli::bench
