// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/ResponseCurve.h"

#include <utility>

#include <QPainter>
#include <QPainterPath>

#include "ui/kit/Theme.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

constexpr int kCurveSteps = 60;
constexpr double kCurveMarginPx = 6.0;
constexpr double kCurvePointPx = 5.0;

}  // namespace

ResponseCurve::ResponseCurve(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("responseCurve"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void ResponseCurve::setCurve(Curve curve)
{
    m_curve = std::move(curve);
    update();
}

void ResponseCurve::setInput(std::optional<double> input)
{
    if (input == m_input)
        return;
    m_input = input;
    update();
}

void ResponseCurve::setName(const QString& name)
{
    setAccessibleName(name);
    setToolTip(name);
}

void ResponseCurve::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(kCurveMarginPx, kCurveMarginPx, -kCurveMarginPx, -kCurveMarginPx);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(box);
    if (!m_curve)
        return;
    const auto pointAt = [&](double input) {
        return QPointF(box.left() + input * box.width(), box.bottom() - m_curve(input) * box.height());
    };
    QPainterPath path(pointAt(0.0));
    for (int k = 1; k <= kCurveSteps; ++k)
        path.lineTo(pointAt(static_cast<double>(k) / kCurveSteps));
    painter.setPen(QPen(tones(palette()).accent, 2.0));
    painter.drawPath(path);
    if (!m_input)
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::WindowText));
    painter.drawEllipse(pointAt(*m_input), kCurvePointPx, kCurvePointPx);
}

}  // namespace ui::devices
