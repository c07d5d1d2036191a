// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/WatchPanel.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <QPainter>
#include <QPainterPath>

#include "ui/console/ParameterWords.h"
#include "ui/kit/Theme.h"

namespace ui::console {
namespace {

constexpr int kBeatMs = 50;
constexpr int kWidthPx = 300;
constexpr int kLinePx = 22;
constexpr int kPlotPx = 56;

double secondsNow()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

WatchPanel::WatchPanel(const core::settings::Parameters& parameters, QWidget* parent)
    : QWidget(parent), m_parameters(parameters)
{
    setPalette(kit::roomPalette());
    setAttribute(Qt::WA_TransparentForMouseEvents);
    m_beat.setInterval(kBeatMs);
    connect(&m_beat, &QTimer::timeout, this, [this] { sample(secondsNow()); });
    hide();
}

bool WatchPanel::watch(const QString& name, bool plotted)
{
    const auto found = std::find_if(m_rows.begin(), m_rows.end(), [&](const Row& row) { return row.name == name; });
    if (found != m_rows.end()) {
        found->isPlotted = plotted;
    } else {
        if (m_rows.size() >= kMost)
            return false;
        m_rows.push_back({name, plotted, 0.0, {}});
    }
    sample(secondsNow());
    m_beat.start();
    fit();
    return true;
}

void WatchPanel::forget(const QString& name)
{
    std::erase_if(m_rows, [&](const Row& row) { return name.isEmpty() || row.name == name; });
    if (m_rows.empty())
        m_beat.stop();
    fit();
}

QStringList WatchPanel::names() const
{
    QStringList all;
    for (const Row& row : m_rows)
        all << row.name;
    return all;
}

std::vector<double> WatchPanel::plotted(const QString& name) const
{
    std::vector<double> values;
    for (const Row& row : m_rows)
        if (row.name == name)
            for (const Point& point : row.points)
                values.push_back(point.value);
    return values;
}

std::optional<charts::Chart> WatchPanel::chart(const QString& name) const
{
    const auto row =
        std::find_if(m_rows.begin(), m_rows.end(), [&](const Row& one) { return one.name == name && one.isPlotted; });
    const core::settings::Parameter* parameter = m_parameters.find(name.toStdString());
    if (row == m_rows.end() || parameter == nullptr)
        return std::nullopt;
    charts::Curve curve;
    curve.x = {tr("Seconds before now"), -kPlottedS, 0.0};
    const QString unit = QString::fromStdString(parameter->unit);
    curve.y.title = unit.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, unit);
    const auto [low, high] = row->range().value_or(std::pair(0.0, 1.0));
    curve.y.low = low;
    curve.y.high = high > low ? high : low + 1.0;
    charts::Line line{name, {}, charts::Mark::Plain};
    for (const Point& point : row->points)
        if (std::isfinite(point.value))
            line.dots << charts::Dot{point.seconds - row->points.back().seconds, point.value,
                                     valueWords(*parameter, point.value)};
    curve.lines << line;
    return charts::Chart{name, {}, {}, curve};
}

std::optional<std::pair<double, double>> WatchPanel::Row::range() const
{
    std::optional<std::pair<double, double>> range;
    for (const Point& point : points) {
        if (!std::isfinite(point.value))
            continue;
        range = range ? std::pair(std::min(range->first, point.value), std::max(range->second, point.value))
                      : std::pair(point.value, point.value);
    }
    return range;
}

void WatchPanel::sample(double seconds)
{
    for (Row& row : m_rows) {
        const core::settings::Parameter* parameter = m_parameters.find(row.name.toStdString());
        row.now = parameter != nullptr ? parameter->read() : std::nan("");
        if (parameter != nullptr && !withheldWords(*parameter).isEmpty())
            row.points.clear();  // deletes its earlier values as well
        if (!row.isPlotted)
            continue;
        row.points.push_back({seconds, row.now});
        while (row.points.front().seconds < seconds - kPlottedS)
            row.points.pop_front();
    }
    update();
}

void WatchPanel::fit()
{
    int height = kit::kSpace2;
    for (const Row& row : m_rows)
        height += kLinePx + (row.isPlotted ? kPlotPx : 0);
    setFixedSize(kWidthPx, height + kit::kSpace2);
    setVisible(!m_rows.empty());
    raise();
    emit resized();
}

void WatchPanel::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& p = palette();
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 22, 23, 215));
    painter.drawRoundedRect(rect(), kit::kRadius, kit::kRadius);
    int y = kit::kSpace2;
    for (const Row& row : m_rows) {
        const QRect lineRect(kit::kSpace2, y, width() - 2 * kit::kSpace2, kLinePx);
        const core::settings::Parameter* parameter = m_parameters.find(row.name.toStdString());
        painter.setFont(kit::typeface(kit::kSmall));
        painter.setPen(p.color(QPalette::PlaceholderText));
        painter.drawText(lineRect, Qt::AlignLeft | Qt::AlignVCenter, row.name);
        painter.setFont(kit::typeface(kit::kBody, QFont::DemiBold));
        painter.setPen(p.color(QPalette::WindowText));
        if (parameter != nullptr)
            painter.drawText(lineRect, Qt::AlignRight | Qt::AlignVCenter, valueWords(*parameter, row.now));
        y += kLinePx;
        if (!row.isPlotted)
            continue;
        QRectF plot(kit::kSpace2, y, width() - 2.0 * kit::kSpace2, kPlotPx - kit::kSpace1);
        y += kPlotPx;
        const auto range = row.range();
        if (!range || parameter == nullptr)
            continue;
        const auto [low, high] = *range;
        const double span = high > low ? high - low : 1.0;
        // The panel ignores the mouse, so the limits are written beside the curve instead of in a tooltip.
        const QString lowWords = valueWords(*parameter, low);
        const QString highWords = high > low ? valueWords(*parameter, high) : QString();
        painter.setFont(kit::typeface(kit::kSmall));
        painter.setPen(p.color(QPalette::PlaceholderText));
        painter.drawText(plot, Qt::AlignLeft | Qt::AlignTop, highWords);
        painter.drawText(plot, Qt::AlignLeft | Qt::AlignBottom, lowWords);
        const QFontMetrics metrics = painter.fontMetrics();
        plot.setLeft(plot.left() + kit::kSpace2 +
                     std::max(metrics.horizontalAdvance(lowWords), metrics.horizontalAdvance(highWords)));
        painter.setPen(QPen(p.color(QPalette::Mid), 1.0));
        painter.drawLine(plot.bottomLeft(), plot.bottomRight());
        QPainterPath path;
        bool isDown = false;
        for (const Point& point : row.points) {
            if (!std::isfinite(point.value)) {
                isDown = false;
                continue;
            }
            const double x = plot.right() - (row.points.back().seconds - point.seconds) / kPlottedS * plot.width();
            const QPointF at(x, plot.bottom() - 2.0 - (point.value - low) / span * (plot.height() - 6.0));
            isDown ? path.lineTo(at) : path.moveTo(at);
            isDown = true;
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(p.color(QPalette::Link), 1.6));
        painter.drawPath(path);
    }
}

}  // namespace ui::console
