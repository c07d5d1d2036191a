// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/ScoreBar.h"

#include <algorithm>

#include <QPainter>

#include "ui/kit/Theme.h"
#include "ui/text/Texts.h"

namespace ui::kit {

ScoreBar::ScoreBar(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ScoreBar::setScore(int scoreTenths, int passMarkTenths)
{
    m_scoreTenths = scoreTenths;
    m_passMarkTenths = passMarkTenths;
    //: A score bar for the screen reader
    setAccessibleName(tr("%1 of 100, pass mark %2").arg(text::points(scoreTenths), text::points(passMarkTenths)));
    update();
}

void ScoreBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Mid));
    const QRectF groove(0, 0, width(), 8);
    painter.drawRoundedRect(groove, 4, 4);
    const Tones tone = tones(palette());
    const double share = std::clamp(m_scoreTenths, 0, 1000) / 1000.0;
    if (share > 0) {
        painter.setBrush(m_scoreTenths >= m_passMarkTenths ? tone.accent : tone.attention);
        painter.drawRoundedRect(QRectF(0, 0, std::max(8.0, share * width()), 8), 4, 4);
    }
    const double mark = m_passMarkTenths / 1000.0 * width();
    painter.setBrush(palette().color(QPalette::WindowText));
    painter.drawRect(QRectF(mark - 1, -2, 2, 14));
    painter.setFont(typeface(kSmall));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const QString words = tr("pass mark %1").arg(text::points(m_passMarkTenths));
    const double wide = painter.fontMetrics().horizontalAdvance(words);
    painter.drawText(QPointF(std::clamp(mark - wide / 2, 0.0, width() - wide), 28), words);
}

}  // namespace ui::kit
