// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/HomingMarks.h"

#include <algorithm>

#include <QPainter>

#include "ui/kit/LineIcon.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

constexpr int kRingPx = 36;
constexpr int kCaptionPx = 20;
constexpr int kColumnPx = 84;

}  // namespace

HomingMarks::HomingMarks(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("homingMarks"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    text::bindTranslation(this, [this] {
        describe();
        update();
    });
}

void HomingMarks::setHomed(const std::array<bool, 3>& homed)
{
    if (homed == m_homed)
        return;
    m_homed = homed;
    describe();
    update();
}

QSize HomingMarks::sizeHint() const
{
    return {3 * kColumnPx, kRingPx + kSpace1 + kCaptionPx};
}

void HomingMarks::describe()
{
    setAccessibleName(
        tr("%n of 3 arms homed", nullptr, static_cast<int>(std::count(m_homed.begin(), m_homed.end(), true))));
}

void HomingMarks::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const std::array<QString, 3> names{tr("Top arm"), tr("Right arm"), tr("Left arm")};
    for (std::size_t arm = 0; arm < m_homed.size(); ++arm) {
        const bool isHomed = m_homed.at(arm);
        const int left = static_cast<int>(arm) * kColumnPx;
        const QRectF ring(left + (kColumnPx - kRingPx) / 2.0 + 1.0, 1.0, kRingPx - 2.0, kRingPx - 2.0);
        painter.setPen(QPen(palette().color(isHomed ? QPalette::Highlight : QPalette::PlaceholderText), 2.0));
        painter.setBrush(isHomed ? QBrush(palette().color(QPalette::Highlight)) : QBrush(Qt::NoBrush));
        painter.drawEllipse(ring);
        if (isHomed)
            painter.drawPixmap(ring.center() - QPointF(10.0, 10.0),
                               linePixmap(QStringLiteral("tick"), Qt::white, 20, devicePixelRatioF()));
        painter.setFont(typeface(kSmall));
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QRect(left, kRingPx + kSpace1, kColumnPx, kCaptionPx), Qt::AlignHCenter | Qt::AlignTop,
                         painter.fontMetrics().elidedText(names.at(arm), Qt::ElideRight, kColumnPx));
    }
}

}  // namespace ui::devices
