// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/PenField.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

constexpr double kFieldRadiusPx = 6.0;
constexpr double kPenBarPx = 8.0;

}  // namespace

PenField::PenField(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("penField"));
    setTabletTracking(true);
    text::bindTranslation(this, [this] {
        //: In a field in which the user tries the pen of a graphics tablet
        m_words = tr("Press the pen here");
        setAccessibleName(m_words);
        update();
    });
}

void PenField::tabletEvent(QTabletEvent* event)
{
    const bool isDown = event->type() != QEvent::TabletRelease && event->buttons().testFlag(Qt::LeftButton);
    const double pressure = isDown && std::isfinite(event->pressure()) ? event->pressure() : 0.0;
    m_pressure = std::clamp(pressure, 0.0, 1.0);
    update();
    emit penMoved(m_pressure);
    event->accept();
}

void PenField::mousePressEvent(QMouseEvent* event)
{
    event->accept();
    emit mousePressed();
}

void PenField::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF field = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0, Qt::DashLine));
    painter.setBrush(palette().color(QPalette::Window));
    painter.drawRoundedRect(field, kFieldRadiusPx, kFieldRadiusPx);
    QRectF bar(field.left() + kSpace2, field.bottom() - kSpace2 - kPenBarPx, field.width() - 2 * kSpace2, kPenBarPx);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Mid));
    painter.drawRect(bar);
    bar.setWidth(bar.width() * m_pressure);
    painter.setBrush(tones(palette()).accent);
    painter.drawRect(bar);
    painter.setFont(typeface(kBody));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(field.adjusted(kSpace2, 0.0, -kSpace2, -kSpace2 - kPenBarPx), Qt::AlignCenter | Qt::TextWordWrap,
                     m_words);
}

}  // namespace ui::devices
