// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include <QAreaSeries>
#include <QCategoryAxis>
#include <QChart>
#include <QGraphicsLayout>
#include <QLegendMarker>
#include <QLineSeries>
#include <QLogValueAxis>
#include <QScatterSeries>
#include <QValueAxis>

#include "app/cli/bench/charts/Sheet.h"

namespace app::cli::bench {
namespace {

constexpr double kMarkerPx = 20.0;
constexpr double kLinePx = 3.5;

QAbstractAxis* axisOf(const Axis& axis)
{
    QAbstractAxis* made = nullptr;
    if (axis.base > 0.0) {
        auto* const logarithmic = new QLogValueAxis;
        logarithmic->setBase(axis.base);
        logarithmic->setMinorTickCount(axis.base > 2.0 ? 8 : 0);
        logarithmic->setLabelFormat(QStringLiteral("%g"));
        made = logarithmic;
    } else if (!axis.labels.isEmpty()) {
        auto* const labelled = new QCategoryAxis;
        labelled->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
        for (qsizetype k = 0; k < axis.labels.size(); ++k)
            labelled->append(axis.labels[k], static_cast<double>(k));
        made = labelled;
    } else {
        auto* const linear = new QValueAxis;
        linear->setLabelFormat(QStringLiteral("%g"));
        linear->setTickType(QValueAxis::TicksDynamic);
        linear->setTickInterval(axis.interval);
        made = linear;
    }
    made->setRange(axis.low, axis.high);
    made->setTitleText(axis.title);
    made->setTitleFont(chartFont(kTextPx, true));
    made->setTitleBrush(inkColour());
    made->setLabelsFont(chartFont(kTextPx));
    made->setLabelsBrush(inkColour());
    made->setLinePen(QPen(inkColour(), 1.5));
    made->setGridLinePen(QPen(gridColour().darker(110), 1.5));
    made->setMinorGridLinePen(QPen(gridColour(), 0.75));
    return made;
}

/// Series belong to the chart, and are hidden from its legend.
template <typename Series>
Series* adopt(QChart& chart, Series* series)
{
    chart.addSeries(series);
    for (QAbstractAxis* axis : chart.axes())
        series->attachAxis(axis);
    for (QLegendMarker* marker : chart.legend()->markers(series))
        marker->setVisible(false);
    return series;
}

void shadeGoodCorner(QChart& chart, const CurveChart& content)
{
    double right = content.x.high;
    double top = content.y.high;
    for (const Limit& limit : content.limits)
        (limit.isVertical ? right : top) = std::min(limit.isVertical ? right : top, limit.at);
    auto* const upper = new QLineSeries(&chart);
    upper->append(content.x.low, top);
    upper->append(right, top);
    auto* const lower = new QLineSeries(&chart);
    lower->append(content.x.low, content.y.low);
    lower->append(right, content.y.low);
    auto* const area = new QAreaSeries(upper, lower);
    area->setPen(Qt::NoPen);
    area->setBrush(QColor(0xE4, 0xF1, 0xEF));
    adopt(chart, area);
}

/// Finds for each text a place beside its point where nothing else is, as far as there is one.
class Notes
{
public:
    Notes(QGraphicsScene& scene, const QRectF& within) : m_scene(scene), m_within(within) {}

    void keepFree(const QRectF& place) { m_taken << place; }

    /// Beside a point.
    void add(const QString& text, const QColor& colour, QPointF point)
    {
        constexpr double kFarCost = 80.0;  // px2 of something else covered, rather than farther by a marker
        auto* const item = addText(m_scene, text, chartFont(kNotePx), colour, {0.0, 0.0});
        const QSizeF size = item->boundingRect().size();
        QList<Candidate> candidates;
        for (const double far : {0.6, 1.2, 2.0})
            for (const auto& [x, y] : {std::pair(1, 0), {1, -1}, {1, 1}, {-1, 0}, {-1, -1}, {-1, 1}, {0, -1}, {0, 1}})
                candidates << Candidate{around(point + QPointF(x * (far * kMarkerPx + 0.5 * size.width()),
                                                               y * (far * kMarkerPx + 0.4 * size.height())),
                                               size),
                                        kFarCost * far};
        put(*item, candidates);
    }

    /// Along a line across the plot, at one of its ends.
    void addLimit(const QString& text, QPointF left, QPointF right)
    {
        auto* const item = addText(m_scene, text, chartFont(kNotePx), limitColour(), {0.0, 0.0});
        const QSizeF size = item->boundingRect().size();
        const double in = 0.5 * size.width() + 12.0;
        const double off = 0.5 * size.height() + 3.0;
        put(*item, {{around(left + QPointF(in, -off), size), 0.0},
                    {around(right + QPointF(-in, -off), size), 1.0},
                    {around(left + QPointF(in, off), size), 2.0},
                    {around(right + QPointF(-in, off), size), 3.0}});
    }

private:
    struct Candidate
    {
        QRectF place;
        double cost;  ///< what else speaks against it, px2
    };

    static QRectF around(QPointF middle, QSizeF size)
    {
        return {middle - QPointF(0.5 * size.width(), 0.5 * size.height()), size};
    }

    void put(QGraphicsItem& item, const QList<Candidate>& candidates)
    {
        const auto costs = [&](const Candidate& one) { return covered(one.place) + one.cost; };
        const QRectF best = std::min_element(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
                                return costs(a) < costs(b);
                            })->place;
        item.setPos(best.topLeft());
        keepFree(best);
    }

    [[nodiscard]] double covered(const QRectF& place) const
    {
        const auto area = [](const QRectF& r) { return r.width() * r.height(); };
        double sum = area(place) - area(place.intersected(m_within));
        for (const QRectF& taken : m_taken)
            sum += area(place.intersected(taken));
        return sum;
    }

    QGraphicsScene& m_scene;
    QRectF m_within;
    QList<QRectF> m_taken;
};

/// What is written into the plot: the names of limits and of the good corner, and what is beside points.
void addNotes(QGraphicsScene& scene, QChart& chart, QAbstractSeries& any, const CurveChart& content)
{
    const auto inScene = [&](QPointF value) { return chart.mapToScene(chart.mapToPosition(value, &any)); };
    Notes notes(scene, chart.mapRectToScene(chart.plotArea()));
    const QPointF half(0.5 * kMarkerPx, 0.5 * kMarkerPx);
    constexpr double kLineStepPx = 8.0;
    for (const Curve& curve : content.curves)
        for (qsizetype n = 0; n < curve.points.size(); ++n) {
            const QPointF point = inScene(curve.points[n]);
            notes.keepFree({point - half, point + half});
            const QLineF line(point, inScene(curve.points[std::max<qsizetype>(n - 1, 0)]));
            for (double along = 0.0; along < line.length(); along += kLineStepPx)
                notes.keepFree(QRectF(-4.0, -4.0, 8.0, 8.0).translated(line.pointAt(along / line.length())));
        }
    for (const Limit& limit : content.limits) {
        if (limit.isVertical) {
            auto* const text = addText(scene, limit.text, chartFont(kNotePx), limitColour(), {0.0, 0.0});
            text->setRotation(90.0);
            text->setPos(inScene({limit.at, content.y.high}) + QPointF(-6.0, 12.0));
            notes.keepFree(text->sceneBoundingRect());
            notes.keepFree({inScene({limit.at, content.y.high}) - QPointF(2.0, 0.0),
                            inScene({limit.at, content.y.low}) + QPointF(2.0, 0.0)});
        } else {
            notes.keepFree({inScene({content.x.low, limit.at}) - QPointF(0.0, 2.0),
                            inScene({content.x.high, limit.at}) + QPointF(0.0, 2.0)});
            notes.addLimit(limit.text, inScene({content.x.low, limit.at}), inScene({content.x.high, limit.at}));
        }
    }
    if (!content.goodCorner.isEmpty()) {
        const auto* const text = addText(scene, content.goodCorner, chartFont(kNotePx, true), QColor(0x0B, 0x60, 0x61),
                                         inScene({content.x.low, content.y.low}) + QPointF(14.0, -20.0));
        notes.keepFree(text->sceneBoundingRect());
    }
    for (const Curve& curve : content.curves)
        for (qsizetype n = 0; n < curve.notes.size(); ++n)
            notes.add(curve.notes[n], lookOf(curve.look).colour.darker(150), inScene(curve.points[n]));
}

}  // namespace

void add(QGraphicsScene& scene, const QRectF& place, const CurveChart& content)
{
    auto* const chart = new QChart;
    scene.addItem(chart);
    chart->setMargins(QMargins(0, 0, 30, 0));
    chart->layout()->setContentsMargins(0.0, 0.0, 0.0, 0.0);
    chart->setBackgroundVisible(false);
    chart->addAxis(axisOf(content.x), Qt::AlignBottom);
    chart->addAxis(axisOf(content.y), Qt::AlignLeft);
    chart->legend()->setAlignment(Qt::AlignTop);
    chart->legend()->setFont(chartFont(kTextPx));
    chart->legend()->setLabelColor(inkColour());
    chart->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
    if (!content.goodCorner.isEmpty())
        shadeGoodCorner(*chart, content);
    for (const Limit& limit : content.limits) {
        auto* const line = new QLineSeries;
        QPen pen(limitColour(), 2.0);
        pen.setDashPattern({8.0, 4.0});
        line->setPen(pen);
        if (limit.isVertical)
            *line << QPointF(limit.at, content.y.low) << QPointF(limit.at, content.y.high);
        else
            *line << QPointF(content.x.low, limit.at) << QPointF(content.x.high, limit.at);
        adopt(*chart, line);
    }
    QList<QScatterSeries*> shown;
    for (const Curve& curve : content.curves) {
        const Look& look = lookOf(curve.look);
        auto* const line = new QLineSeries;
        line->setPen(QPen(look.colour, kLinePx, look.line));
        line->append(curve.points);
        adopt(*chart, line);
        auto* const markers = new QScatterSeries;
        markers->setName(curve.name + QString(6, QChar::Nbsp));  // keeps the entries of the legend apart
        markers->setMarkerShape(look.marker);
        markers->setMarkerSize(kMarkerPx);
        markers->setColor(look.colour);
        markers->setBorderColor(Qt::white);
        markers->append(curve.points);
        adopt(*chart, markers);
        for (QLegendMarker* marker : chart->legend()->markers(markers))
            marker->setVisible(true);
        shown << markers;
    }
    chart->setGeometry(place);
    chart->layout()->activate();

    addNotes(scene, *chart, *shown.front(), content);
}

}  // namespace app::cli::bench
