// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/PlacementPicture.h"

#include <algorithm>
#include <array>

#include <QPainter>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using core::session::DeviceSetup;
using namespace ui::kit;

// The drawings are made in a square of this side.
constexpr double kSquare = 160.0;
constexpr double kBodyRadius = 30.0;
constexpr double kArmPx = 34.0;  ///< distance from the front of the body to the grip
constexpr double kGripRadius = 7.0;
constexpr double kTableY = 132.0;

QPen drawnWith(const QColor& colour, double widthPx)
{
    return {colour, widthPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

/// Paints the device's body, with its arms along +x and the grip at their end.
void paintDevice(QPainter& painter, const QPalette& palette)
{
    const QColor words = palette.color(QPalette::WindowText);
    painter.setBrush(palette.color(QPalette::Midlight));
    painter.setPen(drawnWith(words, 1.6));
    painter.drawEllipse(QPointF(), kBodyRadius, kBodyRadius);
    painter.setBrush(Qt::NoBrush);
    const QPointF grip(kBodyRadius + kArmPx, 0.0);
    for (const double side : {-1.0, 0.0, 1.0}) {
        const QPointF shoulder(kBodyRadius * 0.75, side * kBodyRadius * 0.6);
        const QPointF elbow(kBodyRadius + 0.45 * kArmPx, side * kBodyRadius * 0.75);
        painter.drawPolyline(std::array{shoulder, elbow, grip}.data(), 3);
    }
    painter.setBrush(tones(palette).accent);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(grip, kGripRadius, kGripRadius);
}

void paintCaption(QPainter& painter, const QPalette& palette, const QString& words, const QRectF& where)
{
    painter.setFont(typeface(kSmall));
    painter.setPen(palette.color(QPalette::PlaceholderText));
    painter.drawText(where, Qt::AlignHCenter | Qt::AlignVCenter | Qt::TextWordWrap, words);
}

}  // namespace

PlacementPicture::PlacementPicture(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("placement"));
    text::bindTranslation(this, [this] { describe(); });
}

void PlacementPicture::setSetup(const DeviceSetup& setup)
{
    if (setup == m_setup)
        return;
    m_setup = setup;
    describe();
    update();
}

void PlacementPicture::describe()
{
    const QString stand = m_setup.stand == DeviceSetup::Stand::Upright
                              ? tr("It stands on its base, and the arms point away from its front.")
                              : tr("It lies on its back, and the arms point up.");
    const QString side = m_setup.side == DeviceSetup::Side::Right  ? tr("It stands at your right hand and faces left.")
                         : m_setup.side == DeviceSetup::Side::Left ? tr("It stands at your left hand and faces right.")
                                                                   : tr("It stands in front of you and faces you.");
    setAccessibleName(tr("How to place the device"));
    setAccessibleDescription(stand + u' ' + side);
    setToolTip(stand + u' ' + side);
}

void PlacementPicture::paintFromTheSide(QPainter& painter) const
{
    const QColor words = palette().color(QPalette::WindowText);
    painter.setPen(drawnWith(palette().color(QPalette::Mid), 3.0));
    painter.drawLine(QPointF(8.0, kTableY), QPointF(kSquare - 8.0, kTableY));
    painter.save();
    if (m_setup.stand == DeviceSetup::Stand::Upright) {
        // The foot below the middle of the body.
        painter.setPen(drawnWith(words, 1.6));
        painter.setBrush(palette().color(QPalette::Base));
        const QPolygonF foot{
            {46.0, kTableY - 34.0}, {74.0, kTableY - 34.0}, {88.0, kTableY - 2.0}, {32.0, kTableY - 2.0}};
        painter.drawPolygon(foot);
        painter.translate(60.0, kTableY - 52.0);
    } else {
        painter.translate(kSquare / 2.0, kTableY - kBodyRadius - 2.0);
        painter.rotate(-90.0);
    }
    paintDevice(painter, palette());
    painter.restore();
    paintCaption(painter, palette(), tr("From the side"), {0.0, kTableY + 4.0, kSquare, 24.0});
}

void PlacementPicture::paintFromAbove(QPainter& painter) const
{
    const QColor words = palette().color(QPalette::WindowText);
    painter.setPen(drawnWith(words, 1.6));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(44.0, 4.0, 72.0, 9.0), 2.0, 2.0);  // the screen
    const QPointF user(kSquare / 2.0, kTableY - 14.0);
    painter.drawRoundedRect(QRectF(user.x() - 27.0, user.y() - 8.0, 54.0, 17.0), 8.0, 8.0);
    painter.drawEllipse(user, 10.0, 10.0);
    painter.save();
    const bool isFlat = m_setup.stand == DeviceSetup::Stand::OnItsBack;
    constexpr double kSmaller = 0.6;
    switch (m_setup.side) {
    case DeviceSetup::Side::Front:
        painter.translate(kSquare / 2.0, isFlat ? 62.0 : 44.0);
        painter.rotate(90.0);
        break;
    case DeviceSetup::Side::Right:
        painter.translate(isFlat ? 132.0 : 138.0, 66.0);
        painter.rotate(180.0);
        break;
    case DeviceSetup::Side::Left:
        painter.translate(isFlat ? 28.0 : 22.0, 66.0);
        break;
    }
    painter.scale(kSmaller, kSmaller);
    if (isFlat) {  // the arms point at the viewer
        painter.setBrush(palette().color(QPalette::Midlight));
        painter.setPen(drawnWith(words, 1.6 / kSmaller));
        painter.drawEllipse(QPointF(), kBodyRadius, kBodyRadius);
        for (const double turn : {0.0, 120.0, 120.0}) {
            painter.rotate(turn);
            painter.drawLine(QPointF(kBodyRadius * 0.85, 0.0), QPointF());
        }
        painter.setBrush(tones(palette()).accent);
        painter.setPen(Qt::NoPen);
        painter.drawEllipse(QPointF(), kGripRadius * 1.3, kGripRadius * 1.3);
    } else {
        paintDevice(painter, palette());
    }
    painter.restore();
    paintCaption(painter, palette(), tr("From above"), {0.0, kTableY + 4.0, kSquare, 24.0});
}

void PlacementPicture::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double side = std::min(0.5 * (width() - kSpace4), static_cast<double>(height()));
    const double scale = side / kSquare;
    const double left = 0.5 * (width() - 2.0 * side - kSpace4);
    const double top = 0.5 * (height() - side);
    for (const bool fromAbove : {false, true}) {
        painter.save();
        painter.translate(left + (fromAbove ? side + kSpace4 : 0.0), top);
        painter.scale(scale, scale);
        if (fromAbove)
            paintFromAbove(painter);
        else
            paintFromTheSide(painter);
        painter.restore();
    }
}

}  // namespace ui::devices
