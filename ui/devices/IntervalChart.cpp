// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/IntervalChart.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::devices {
namespace {

using core::session::ExchangeFigures;
using namespace ui::kit;

constexpr int kScalePx = 18;
constexpr double kWholeMs = static_cast<double>(ExchangeFigures::kBins) * ExchangeFigures::kBinUs / 1000.0;

}  // namespace

IntervalChart::IntervalChart(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("intervals"));
    text::bindTranslation(this, [this] {
        setAccessibleName(tr("Intervals between answers"));
        setToolTip(brokenIntoLines(tr(
            "Number of answers in the last second for each interval. The last bar contains all longer intervals. The "
            "height is logarithmic, so that a single late answer is visible.")));
        describe();
        update();
    });
}

void IntervalChart::describe()
{
    setAccessibleDescription(tr("%1 answers in a second").arg(text::number(m_figures.rateHz, 0)));
}

void IntervalChart::setFigures(const ExchangeFigures& figures)
{
    m_figures = figures;
    describe();
    update();
}

void IntervalChart::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QRectF area(0.0, 2.0, width(), height() - kScalePx - 2.0);
    const double barPx = area.width() / static_cast<double>(ExchangeFigures::kBins);
    const double most = std::log1p(
        std::max(1.0, static_cast<double>(*std::max_element(m_figures.intervals.begin(), m_figures.intervals.end()))));
    const Tones tone = tones(palette());
    for (std::size_t bin = 0; bin < ExchangeFigures::kBins; ++bin) {
        const auto count = static_cast<double>(m_figures.intervals.at(bin));
        if (count == 0.0)
            continue;
        const double high = std::max(2.0, area.height() * std::log1p(count) / most);
        // The last bar is hatched, because it also counts all longer intervals.
        const bool isLast = bin + 1 == ExchangeFigures::kBins;
        painter.fillRect(
            QRectF(static_cast<double>(bin) * barPx, area.bottom() - high, std::max(1.0, barPx - 1.0), high),
            isLast ? QBrush(tone.attention, Qt::Dense4Pattern) : QBrush(tone.accent));
    }
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    painter.setFont(typeface(kSmall));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const QRectF scale(0.0, area.bottom(), width(), kScalePx);
    painter.drawText(scale, Qt::AlignLeft | Qt::AlignBottom, QStringLiteral("0"));
    painter.drawText(scale, Qt::AlignHCenter | Qt::AlignBottom,
                     text::number(0.5 * kWholeMs, 0) + QStringLiteral(" ms"));
    painter.drawText(scale, Qt::AlignRight | Qt::AlignBottom, text::number(kWholeMs, 0) + QStringLiteral(" ms"));
}

}  // namespace ui::devices
