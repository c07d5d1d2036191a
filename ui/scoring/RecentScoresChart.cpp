// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/RecentScoresChart.h"

#include <algorithm>

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/kit/Theme.h"
#include "ui/text/Texts.h"

namespace ui::scoring {
namespace {

constexpr double kWidestBarPx = 44.0;
constexpr double kBarGapPx = 8.0;
constexpr double kNumberGapPx = 4.0;

}  // namespace

RecentScoresChart::RecentScoresChart(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void RecentScoresChart::setScores(const QList<Score>& oldestFirst, int passMarkTenths)
{
    m_scores = oldestFirst;
    m_passMarkTenths = passMarkTenths;
    QStringList words;
    for (const Score& score : oldestFirst)
        words << RecentScoresChart::words(score);
    setAccessibleName(tr("Last grades, oldest first: %1").arg(words.join(QStringLiteral(", "))));
    update();
}

QString RecentScoresChart::words(const Score& score)
{
    return score.isComparable ? text::points(score.tenths)
                              : tr("%1 with another rubric").arg(text::points(score.tenths));
}

QString RecentScoresChart::passMarkWords() const
{
    return tr("pass mark %1").arg(text::points(m_passMarkTenths));
}

double RecentScoresChart::marginPx() const
{
    return QFontMetricsF(kit::typeface(kit::kSmall)).horizontalAdvance(passMarkWords()) + 2.0 * kBarGapPx;
}

double RecentScoresChart::stepPx() const
{
    const double room = (width() - marginPx()) / static_cast<double>(std::max<qsizetype>(1, m_scores.size()));
    return std::clamp(room, 1.0, kWidestBarPx + kBarGapPx);
}

bool RecentScoresChart::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto at = m_scores.isEmpty() ? -1 : static_cast<qsizetype>(help->pos().x() / stepPx());
    if (at < 0 || at >= m_scores.size()) {
        QToolTip::hideText();
        event->ignore();
        return true;
    }
    const Score& score = m_scores[at];
    const QString points = words(score);
    //: %1: date and time; %2: what the grade of then came to
    QToolTip::showText(help->globalPos(), score.when.isEmpty() ? points : tr("%1: %2").arg(score.when, points), this);
    return true;
}

void RecentScoresChart::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& p = palette();
    const double base = height() - 1.0;
    const auto heightOf = [&](int tenths) { return (base - 1.0) * std::clamp(tenths, 0, 1000) / 1000.0; };
    const double mark = base - heightOf(m_passMarkTenths);
    painter.setPen(QPen(p.color(QPalette::Mid), 1));
    painter.drawLine(QPointF(0, base), QPointF(width(), base));
    painter.setPen(QPen(p.color(QPalette::PlaceholderText), 1, Qt::DashLine));
    painter.drawLine(QPointF(0, mark), QPointF(width(), mark));
    painter.setFont(kit::typeface(kit::kSmall));
    const double margin = marginPx();
    // The text is above its line, or below it if there is no room.
    const double line = painter.fontMetrics().height();
    const double top = mark - line - 2.0 >= 0.0 ? mark - line - 2.0 : mark + 2.0;
    painter.drawText(QRectF(width() - margin, top, margin, line), Qt::AlignRight | Qt::AlignVCenter, passMarkWords());
    if (m_scores.isEmpty())
        return;

    const double step = stepPx();
    const double column = std::max(3.0, step - kBarGapPx);
    painter.setFont(kit::typeface(kit::kSmall, QFont::DemiBold));
    for (qsizetype k = 0; k < m_scores.size(); ++k) {
        const bool newest = k + 1 == m_scores.size();
        const double tall = heightOf(m_scores[k].tenths);
        const QRectF bar(static_cast<double>(k) * step, base - tall, column, tall);
        const QColor fill = p.color(newest ? QPalette::Highlight : QPalette::Mid);
        const bool hatched = !m_scores[k].isComparable;
        painter.setPen(hatched ? QPen(fill, 1) : QPen(Qt::NoPen));
        painter.setBrush(QBrush(fill, hatched ? Qt::BDiagPattern : Qt::SolidPattern));
        painter.drawRect(hatched ? bar.adjusted(0.5, 0.5, -0.5, -0.5) : bar);
        const QString number = text::points(m_scores[k].tenths);
        const double numberPx = painter.fontMetrics().height();
        if (painter.fontMetrics().horizontalAdvance(number) > step)  // would overlap the next number
            continue;
        // The number is inside the column if it fits, otherwise above it.
        const bool inside = tall > numberPx + 2.0 * kNumberGapPx;
        painter.setPen(p.color(inside && newest ? QPalette::HighlightedText : QPalette::WindowText));
        const double at = inside ? bar.top() + kNumberGapPx : bar.top() - kNumberGapPx - numberPx;
        painter.drawText(QRectF(bar.center().x() - 0.5 * step, at, step, numberPx), Qt::AlignCenter, number);
    }
}

}  // namespace ui::scoring
