// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/ButtonLights.h"

#include <QPainter>
#include <QStringList>

#include "ui/devices/DeviceWords.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

constexpr std::size_t kGripButtons = 4;

bool isHeld(std::uint8_t held, std::size_t button)
{
    return (held >> button & 1U) != 0;
}

}  // namespace

ButtonLights::ButtonLights(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("gripButtons"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    text::bindTranslation(this, [this] {
        describe();
        update();
    });
}

void ButtonLights::setHeld(std::uint8_t held)
{
    if (held == m_held)
        return;
    m_held = held;
    describe();
    update();
}

void ButtonLights::describe()
{
    QStringList held;
    for (std::size_t button = 0; button < kGripButtons; ++button)
        if (isHeld(m_held, button))
            held << gripButtonName(button);
    setAccessibleName(held.isEmpty() ? tr("No grip button is pressed")
                                     //: %1: names of buttons
                                     : tr("Pressed: %1").arg(held.join(QStringLiteral(", "))));
}

void ButtonLights::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(typeface(kSmall, QFont::Medium));
    const double wide = (width() - 3.0 * kSpace1) / static_cast<double>(kGripButtons);
    for (std::size_t button = 0; button < kGripButtons; ++button) {
        const bool isDown = isHeld(m_held, button);
        const QRectF light(static_cast<double>(button) * (wide + kSpace1) + 1.0, 1.0, wide - 2.0, height() - 2.0);
        painter.setPen(QPen(palette().color(isDown ? QPalette::Highlight : QPalette::Mid), 1.0));
        painter.setBrush(isDown ? QBrush(palette().color(QPalette::Highlight)) : QBrush(Qt::NoBrush));
        painter.drawRoundedRect(light, kRadius, kRadius);
        painter.setPen(palette().color(isDown ? QPalette::HighlightedText : QPalette::WindowText));
        painter.drawText(light, Qt::AlignCenter,
                         painter.fontMetrics().elidedText(gripButtonName(button), Qt::ElideRight,
                                                          static_cast<int>(light.width()) - 2 * kSpace1));
    }
}

}  // namespace ui::devices
