// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/PositionView.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

constexpr int kNamePx = 20;
constexpr double kDotPx = 6.0;

}  // namespace

PositionView::PositionView(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("position"));
    text::bindTranslation(this, [this] {
        describe();
        update();
    });
}

void PositionView::setTip(const glm::vec3& tipMm, double reachMm)
{
    if (tipMm == m_tipMm && reachMm == m_reachMm)
        return;
    m_tipMm = tipMm;
    m_reachMm = reachMm;
    describe();
    update();
}

void PositionView::describe()
{
    const auto number = [](float mm) { return text::number(static_cast<double>(mm), 1); };
    //: %1, %2, %3: millimetres to the right, away from the user and up
    setAccessibleName(
        tr("Position: %1 mm right, %2 mm away, %3 mm up").arg(number(m_tipMm.x), number(m_tipMm.y), number(m_tipMm.z)));
}

void PositionView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double side = std::min(0.5 * (width() - kSpace4), static_cast<double>(height() - kNamePx));
    for (const bool fromAbove : {true, false}) {
        const QRectF area(fromAbove ? 0.0 : side + kSpace4, 0.0, side, side);
        const QPointF middle = area.center();
        painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
        painter.setBrush(palette().color(QPalette::Window));
        painter.drawEllipse(area.adjusted(1.0, 1.0, -1.0, -1.0));
        painter.drawLine(QPointF(area.left() + 1.0, middle.y()), QPointF(area.right() - 1.0, middle.y()));
        painter.drawLine(QPointF(middle.x(), area.top() + 1.0), QPointF(middle.x(), area.bottom() - 1.0));
        const double scale = 0.5 * side / std::max(1.0, m_reachMm);
        const double up = static_cast<double>(fromAbove ? m_tipMm.y : m_tipMm.z);
        QPointF way = QPointF(static_cast<double>(m_tipMm.x), -up) * scale;
        const double length = std::hypot(way.x(), way.y());
        if (const double most = 0.5 * side - kDotPx; length > most)
            way *= most / length;
        painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
        painter.setBrush(tones(palette()).accent);
        painter.drawEllipse(middle + way, kDotPx, kDotPx);
        painter.setFont(typeface(kSmall));
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(QRectF(area.left(), side, side, kNamePx), Qt::AlignHCenter | Qt::AlignBottom,
                         fromAbove ? tr("From above") : tr("From the front"));
    }
}

}  // namespace ui::devices
