// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/HoldGauge.h"

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QPainterPath>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::practice {
namespace {

using namespace ui::kit;

constexpr double kFollow = 0.25;  ///< share of the distance to the newest force that the pointer moves in a frame
constexpr double kBarTop = 14.0;
constexpr double kBarHigh = 20.0;
constexpr double kInPx = 10.0;  ///< margin of the bar at both ends, for the pointer

}  // namespace

HoldGauge::HoldGauge(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setObjectName(QStringLiteral("holdGauge"));
    text::bindTranslation(this, [this] { sayBand(); });
}

void HoldGauge::setAsked(const core::grading::ForceToHold& asked)
{
    m_asked = asked;
    m_forceN = 0.0;
    sayBand();
    update();
}

void HoldGauge::sayBand()
{
    setAccessibleName(
        tr("Force in relation to the range from %1 to %2 N")
            .arg(text::number(m_asked.forceN - m_asked.withinN, 1), text::number(m_asked.forceN + m_asked.withinN, 1)));
}

void HoldGauge::setForce(double newtons)
{
    const double next = m_forceN + kFollow * (newtons - m_forceN);
    if (std::abs(next - m_forceN) < 0.0005)
        return;
    m_forceN = next;
    update();
}

/// Returns the x position of a force. The band is in the middle.
double HoldGauge::placeOf(double newtons) const
{
    const double share = std::clamp(newtons / (2.0 * m_asked.forceN), 0.0, 1.0);
    return kInPx + share * (width() - 2.0 * kInPx);
}

void HoldGauge::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tones tone = tones(palette());
    const double low = m_asked.forceN - m_asked.withinN;
    const double high = m_asked.forceN + m_asked.withinN;
    const bool isIn = m_forceN >= low && m_forceN <= high;
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Mid));
    painter.drawRoundedRect(QRectF(kInPx, kBarTop, width() - 2.0 * kInPx, kBarHigh), kRadius, kRadius);
    const QRectF band(placeOf(low), kBarTop - 4.0, placeOf(high) - placeOf(low), kBarHigh + 8.0);
    painter.setPen(QPen(palette().color(QPalette::Link), 2.0));
    painter.setBrush(isIn ? tone.accent : palette().color(QPalette::Midlight));
    painter.drawRoundedRect(band, 3.0, 3.0);
    painter.setFont(typeface(kSmall));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    for (const double newtons : {low, high}) {
        const QString words = text::number(newtons, 1);
        const QRectF room(placeOf(newtons) - 24.0, kBarTop + kBarHigh + 6.0, 48.0, 16.0);
        painter.drawText(room, Qt::AlignCenter, words);
    }
    const double x = placeOf(m_forceN);
    QPainterPath pointer(QPointF(x, kBarTop + 4.0));
    pointer.lineTo(x - 7.0, 1.0);
    pointer.lineTo(x + 7.0, 1.0);
    pointer.closeSubpath();
    pointer.addRect(QRectF(x - 1.5, 1.0, 3.0, kBarTop + kBarHigh + 3.0));
    pointer.setFillRule(Qt::WindingFill);
    painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
    painter.setBrush(palette().color(QPalette::WindowText));
    painter.drawPath(pointer.simplified());
}

}  // namespace ui::practice
