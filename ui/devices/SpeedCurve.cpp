// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/SpeedCurve.h"

#include <QPainter>
#include <QPainterPath>

#include "ui/shell/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::shell;

constexpr int kCurveSteps = 60;
constexpr double kCurveMarginPx = 6.0;
constexpr double kCurvePointPx = 5.0;

}  // namespace

SpeedCurve::SpeedCurve(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("speedCurve"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    text::inEveryLanguage(this, [this] {
        setAccessibleName(tr("Speed of the bur over the travel of the pedal"));
        setToolTip(accessibleName());
    });
}

void SpeedCurve::setShape(const core::settings::PedalSettings& shape)
{
    m_shape = shape;
    update();
}

void SpeedCurve::setReading(std::optional<double> reading)
{
    if (reading == m_reading)
        return;
    m_reading = reading;
    update();
}

void SpeedCurve::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(kCurveMarginPx, kCurveMarginPx, -kCurveMarginPx, -kCurveMarginPx);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(box);
    const auto pointAt = [&](double travel) {
        return QPointF(box.left() + travel * box.width(), box.bottom() - m_shape.speedAt(travel) * box.height());
    };
    QPainterPath curve(pointAt(0.0));
    for (int k = 1; k <= kCurveSteps; ++k)
        curve.lineTo(pointAt(static_cast<double>(k) / kCurveSteps));
    painter.setPen(QPen(tones(palette()).accent, 2.0));
    painter.drawPath(curve);
    if (!m_reading)
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::WindowText));
    painter.drawEllipse(pointAt(m_shape.travelAt(*m_reading)), kCurvePointPx, kCurvePointPx);
}

}  // namespace ui::devices
