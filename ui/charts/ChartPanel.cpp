// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/ChartPanel.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include "ui/charts/SaveButton.h"
#include "ui/kit/Accessibility.h"
#include "ui/kit/Theme.h"

namespace ui::charts {
namespace {

using namespace ui::kit;

constexpr double kRingPx = 8.0;
constexpr double kReachPx = 40.0;  ///< distance from the pointer to a value
constexpr int kCalloutPx = 300;

QLabel* label(int size, QFont::Weight weight, QPalette::ColorRole role, QWidget* parent)
{
    auto* made = new QLabel(parent);
    made->setTextFormat(Qt::PlainText);
    made->setFont(typeface(size, weight));
    made->setForegroundRole(role);
    made->setWordWrap(true);
    return made;
}

}  // namespace

ChartPanel::ChartPanel(QWidget* parent)
    : WalkedChart(parent), m_title(label(kBody, QFont::DemiBold, QPalette::WindowText, this)),
      m_note(label(kSmall, QFont::Normal, QPalette::PlaceholderText, this)),
      m_save(new SaveButton([this] { return m_chart; }, this)),
      m_empty(label(kBody, QFont::Normal, QPalette::PlaceholderText, this)),
      m_callout(label(kSmall, QFont::Normal, QPalette::WindowText, this))
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_title->setObjectName(QStringLiteral("chartTitle"));
    m_empty->setObjectName(QStringLiteral("chartEmpty"));
    m_callout->setObjectName(QStringLiteral("chartCallout"));

    view()->setMinimumSize(1, 1);
    view()->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    m_empty->setAlignment(Qt::AlignCenter);
    m_callout->setProperty("kind", "card");
    m_callout->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_callout->setContentsMargins(kSpace2, kSpace1, kSpace2, kSpace1);
    m_callout->hide();
    connect(m_save, &SaveButton::told, this, [this](const QString& sentence) {
        setStop({});
        say(sentence, {width() / 2, height()});
        announce(*m_callout);
    });

    auto* head = new QHBoxLayout;
    head->setSpacing(kSpace2);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(m_title);
    words->addWidget(m_note);
    head->addLayout(words, 1);
    head->addWidget(m_save, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace2, kSpace2, kSpace2, kSpace2);
    column->setSpacing(kSpace1);
    column->addLayout(head);
    column->addWidget(view(), 1);
    column->addWidget(m_empty, 1);
    fit();
    showWords();
}

void ChartPanel::setChart(const Chart& chart)
{
    if (chart == m_chart)
        return;
    m_chart = chart;
    m_stop.reset();
    fit();
    showWords();
}

void ChartPanel::showWords()
{
    m_title->setText(m_chart.title);
    m_note->setText(m_chart.note);
    m_note->setVisible(!m_chart.note.isEmpty());
    m_empty->setText(m_chart.emptyWords);
    m_empty->setVisible(m_stops.isEmpty());
    view()->setVisible(!m_stops.isEmpty());
    m_save->setVisible(!m_stops.isEmpty());
    m_save->nameIt();
    setAccessibleName(m_chart.title);
}

void ChartPanel::fit()
{
    setDrawn(fitted(m_chart, rowsFor(m_chart, view()->size())));
    m_stops = stopsOf(drawn());
    if (m_stop && *m_stop >= m_stops.size())
        m_stop.reset();
    tell();
}

std::optional<qsizetype> ChartPanel::nearest(const QPointF& at) const
{
    const Plot plot = this->plot();
    if (!plot.px.adjusted(-kReachPx, -kReachPx, kReachPx, kReachPx).contains(at))
        return std::nullopt;
    const bool isBars = std::holds_alternative<Bars>(m_chart.content);
    const bool isColumns = std::holds_alternative<Histogram>(m_chart.content);
    std::optional<qsizetype> best;
    double bestPx = isBars || isColumns ? 1.0e9 : kReachPx;
    for (qsizetype k = 0; k < m_stops.size(); ++k) {
        const QPointF away = plot.at(m_stops[k].x, m_stops[k].y) - at;
        // A horizontal bar is hit at any x, a column at any y.
        const double awayPx = isBars      ? std::abs(away.y())
                              : isColumns ? std::abs(away.x())
                                          : std::hypot(away.x(), away.y());
        if (awayPx < bestPx) {
            bestPx = awayPx;
            best = k;
        }
    }
    return best;
}

void ChartPanel::setStop(std::optional<qsizetype> stop)
{
    if (stop && (*stop < 0 || *stop >= m_stops.size()))
        stop.reset();
    if (stop == m_stop)
        return;
    m_stop = stop;
    tell();
    if (hasFocus())
        announce(*this);
}

QString ChartPanel::said() const
{
    return m_stop ? m_stops[*m_stop].words : QString();
}

void ChartPanel::paintOver(QPainter& painter)
{
    if (!m_stop)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::WindowText), 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(plot().at(m_stops[*m_stop].x, m_stops[*m_stop].y), kRingPx, kRingPx);
}

/// Shows a ring around the selected value and a label beside it.
void ChartPanel::tell()
{
    view()->update();
    setAccessibleDescription(m_stop ? said() : m_chart.note);
    m_callout->hide();
    if (m_stop)
        say(said(), view()->pos() + plot().at(m_stops[*m_stop].x, m_stops[*m_stop].y).toPoint());
}

void ChartPanel::say(const QString& words, const QPoint& at)
{
    m_callout->setText(words);
    m_callout->setWordWrap(false);
    QSize size = m_callout->sizeHint();
    const int widest = std::min(kCalloutPx, width() - 2 * kSpace2);
    if (size.width() > widest) {
        m_callout->setWordWrap(true);
        size = {widest, m_callout->heightForWidth(widest)};
    }
    QRect box({at.x() - size.width() / 2, at.y() - size.height() - static_cast<int>(kRingPx) - kSpace2}, size);
    if (box.top() < 0)
        box.moveTop(at.y() + static_cast<int>(kRingPx) + kSpace2);
    box.moveLeft(std::clamp(box.left(), 0, std::max(0, width() - box.width())));
    m_callout->setGeometry(box);
    m_callout->show();
    m_callout->raise();
}

bool ChartPanel::takes(Step) const
{
    return !m_stops.isEmpty();
}

void ChartPanel::walk(Step step)
{
    const qsizetype last = m_stops.size() - 1;
    switch (step) {
    case Step::On:
        return setStop(m_stop ? std::min(*m_stop + 1, last) : 0);
    case Step::Back:
        return setStop(m_stop ? std::max(*m_stop - 1, qsizetype{0}) : last);
    case Step::First:
        return setStop(0);
    case Step::Last:
        return setStop(last);
    case Step::Open:
        if (m_stop && m_stops[*m_stop].id != 0)
            emit chosen(m_stops[*m_stop].id);
    }
}

void ChartPanel::point(std::optional<QPointF> at)
{
    setStop(at ? nearest(*at) : std::nullopt);
}

void ChartPanel::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    setStop({});
}

void ChartPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    tell();
}

}  // namespace ui::charts
