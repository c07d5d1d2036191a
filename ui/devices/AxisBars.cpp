// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/AxisBars.h"

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QStringList>

#include "ui/devices/ControllerSettings.h"
#include "ui/devices/ControllerWords.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

constexpr int kAxisRowPx = 26;
constexpr int kAxisNamePx = 170;
constexpr int kAxisBarPx = 12;
constexpr int kLeastAxisPx = 140;
constexpr int kLightPx = 40;
constexpr int kLightColumns = 8;

}  // namespace

AxisBars::AxisBars(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("axisBars"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    text::bindTranslation(this, [this] {
        describe();
        update();
    });
}

void AxisBars::setController(const core::session::Controller& controller, int pedalAxis)
{
    if (controller == m_controller && pedalAxis == m_pedalAxis)
        return;
    const bool isOther = controller.instance != m_controller.instance;
    m_controller = controller;
    m_pedalAxis = pedalAxis;
    if (isOther)
        updateGeometry();
    describe();
    update();
}

QSize AxisBars::sizeHint() const
{
    const auto axes = static_cast<int>(m_controller.axes.size());
    const auto lights = (static_cast<int>(m_controller.presses.size()) + kLightColumns - 1) / kLightColumns;
    return {kAxisNamePx + kLeastAxisPx, axes * kAxisRowPx + (lights > 0 ? kSpace2 : 0) + lights * kAxisRowPx};
}

void AxisBars::describe()
{
    QStringList held;
    for (std::size_t button = 0; button < m_controller.presses.size(); ++button)
        if (m_controller.isHeld(button))
            held << buttonName(m_controller, button);
    setAccessibleName(held.isEmpty() ? tr("Axes and buttons. No button is pressed.")
                                     //: %1: names of buttons
                                     : tr("Axes and buttons. Pressed: %1").arg(held.join(QStringLiteral(", "))));
}

void AxisBars::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t axis = 0; axis < m_controller.axes.size(); ++axis)
        paintAxis(painter, axis);
    for (std::size_t button = 0; button < m_controller.presses.size(); ++button)
        paintButton(painter, button);
}

void AxisBars::paintAxis(QPainter& painter, std::size_t axis) const
{
    const double top = static_cast<double>(axis) * kAxisRowPx;
    const bool isPedal = static_cast<int>(axis) == m_pedalAxis;
    painter.setFont(typeface(kSmall, isPedal ? QFont::DemiBold : QFont::Normal));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(
        QRectF(0.0, top, kAxisNamePx - kSpace2, kAxisRowPx), Qt::AlignVCenter | Qt::AlignLeft,
        painter.fontMetrics().elidedText(axisName(m_controller, axis), Qt::ElideRight, kAxisNamePx - kSpace2));
    const QRectF bar(kAxisNamePx, top + 0.5 * (kAxisRowPx - kAxisBarPx), width() - kAxisNamePx - 2.0, kAxisBarPx);
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(bar, 3.0, 3.0);
    const double raw = static_cast<double>(m_controller.axes[axis]);
    const double reading = std::isfinite(raw) ? std::clamp(raw, -1.0, 1.0) : 0.0;
    // A stick rests in the middle of its bar, a trigger at one end.
    const bool isTrigger = m_controller.isGamepad && axis >= core::session::kLeftTrigger;
    const double lowest = isTrigger ? 0.0 : -1.0;
    const double rest = m_controller.isGamepad ? 0.0 : -1.0;
    const auto xOf = [&](double at) {
        return bar.left() + 1.0 + std::clamp((at - lowest) / (1.0 - lowest), 0.0, 1.0) * (bar.width() - 2.0);
    };
    const Tones colours = tones(palette());
    const auto [left, right] = std::minmax({xOf(rest), xOf(reading)});
    painter.fillRect(QRectF(left, bar.top() + 1.0, right - left, kAxisBarPx - 2.0),
                     isPedal ? colours.accent : palette().color(QPalette::PlaceholderText));
}

void AxisBars::paintButton(QPainter& painter, std::size_t button) const
{
    const int row = static_cast<int>(button) / kLightColumns;
    const int column = static_cast<int>(button) % kLightColumns;
    const double wide = std::min<double>(kLightPx, static_cast<double>(width()) / kLightColumns);
    const double top = static_cast<double>(m_controller.axes.size()) * kAxisRowPx + kSpace2 + row * kAxisRowPx;
    const QRectF light(column * wide + 1.0, top + 1.0, wide - 3.0, kAxisRowPx - 3.0);
    const bool isDown = m_controller.isHeld(button);
    painter.setPen(QPen(palette().color(isDown ? QPalette::Highlight : QPalette::Mid), 1.0));
    painter.setBrush(isDown ? QBrush(palette().color(QPalette::Highlight)) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(light, kRadius, kRadius);
    painter.setFont(typeface(kSmall, QFont::Medium));
    painter.setPen(palette().color(isDown ? QPalette::HighlightedText : QPalette::WindowText));
    painter.drawText(light, Qt::AlignCenter,
                     painter.fontMetrics().elidedText(buttonName(m_controller, button), Qt::ElideRight,
                                                      static_cast<int>(light.width()) - 2));
}

}  // namespace ui::devices
