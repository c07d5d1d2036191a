// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/ScoreBar.h"

#include <algorithm>

#include <QPainter>

#include "ui/shell/Theme.h"

namespace ui::shell {

ScoreBar::ScoreBar(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ScoreBar::setScore(int score, int passMark)
{
    m_score = score;
    m_passMark = passMark;
    //: A score bar for the screen reader
    setAccessibleName(tr("%1 of 100, pass mark %2").arg(score).arg(passMark));
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
    const double share = std::clamp(m_score, 0, 100) / 100.0;
    if (share > 0) {
        painter.setBrush(m_score >= m_passMark ? tone.accent : tone.attention);
        painter.drawRoundedRect(QRectF(0, 0, std::max(8.0, share * width()), 8), 4, 4);
    }
    const double mark = m_passMark / 100.0 * width();
    painter.setBrush(palette().color(QPalette::WindowText));
    painter.drawRect(QRectF(mark - 1, -2, 2, 14));
    painter.setFont(typeface(kSmall));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const QString words = tr("pass mark %1").arg(m_passMark);
    const double wide = painter.fontMetrics().horizontalAdvance(words);
    painter.drawText(QPointF(std::clamp(mark - wide / 2, 0.0, width() - wide), 28), words);
}

}  // namespace ui::shell
