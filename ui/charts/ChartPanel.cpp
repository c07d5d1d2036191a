// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/ChartPanel.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <QChart>
#include <QChartView>
#include <QGraphicsEllipseItem>
#include <QGraphicsScene>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/charts/Drawing.h"
#include "ui/charts/SaveButton.h"
#include "ui/shell/Announce.h"
#include "ui/shell/Theme.h"

namespace ui::charts {
namespace {

using namespace ui::shell;

constexpr double kRingPx = 8.0;
constexpr double kReachPx = 40.0;  ///< from the pointer to a value
constexpr int kCalloutPx = 300;
constexpr std::chrono::seconds kSaidFor{6};

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
    : QWidget(parent), m_title(label(kBody, QFont::DemiBold, QPalette::WindowText, this)),
      m_note(label(kSmall, QFont::Normal, QPalette::PlaceholderText, this)),
      m_save(new SaveButton([this] { return m_chart; }, this)), m_view(new QChartView(this)),
      m_empty(label(kBody, QFont::Normal, QPalette::PlaceholderText, this)),
      m_callout(label(kSmall, QFont::Normal, QPalette::WindowText, this)),
      m_saved(label(kSmall, QFont::Normal, QPalette::PlaceholderText, this)), m_forSaved(new QTimer(this))
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_title->setObjectName(QStringLiteral("chartTitle"));
    m_empty->setObjectName(QStringLiteral("chartEmpty"));
    m_callout->setObjectName(QStringLiteral("chartCallout"));
    m_saved->setObjectName(QStringLiteral("chartSaved"));

    m_view->setRenderHint(QPainter::Antialiasing);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setFocusPolicy(Qt::NoFocus);
    m_view->setBackgroundBrush(Qt::NoBrush);
    m_view->setStyleSheet(QStringLiteral("background: transparent"));
    m_view->setMinimumSize(1, 1);
    m_view->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);  // else it asks for what it had before
    m_view->viewport()->setMouseTracking(true);
    m_view->viewport()->installEventFilter(this);
    m_empty->setAlignment(Qt::AlignCenter);
    m_callout->setProperty("kind", "card");
    m_callout->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_callout->setContentsMargins(kSpace2, kSpace1, kSpace2, kSpace1);
    m_callout->hide();
    // Over the foot of the chart: nothing moves when it comes and goes, and no room is kept for it. So it does not
    // stay.
    m_saved->setAutoFillBackground(true);
    m_saved->setBackgroundRole(QPalette::Base);
    m_saved->hide();
    m_forSaved->setSingleShot(true);
    m_forSaved->setInterval(kSaidFor);
    connect(m_forSaved, &QTimer::timeout, m_saved, &QLabel::hide);

    connect(m_save, &SaveButton::told, this, &ChartPanel::saySaved);

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
    column->addWidget(m_view, 1);
    column->addWidget(m_empty, 1);
    redraw();
    showWords();
}

void ChartPanel::setChart(const Chart& chart)
{
    if (chart == m_chart)
        return;
    m_chart = chart;
    m_stops = stopsOf(chart);
    m_stop.reset();
    showWords();
    redrawSoon();
    tell();
}

void ChartPanel::showWords()
{
    m_title->setText(m_chart.title);
    m_note->setText(m_chart.note);
    m_note->setVisible(!m_chart.note.isEmpty());
    m_empty->setText(m_chart.emptyWords);
    m_empty->setVisible(m_stops.isEmpty());
    m_view->setVisible(!m_stops.isEmpty());
    m_save->setVisible(!m_stops.isEmpty());
    m_save->nameIt();
    m_saved->hide();
    setAccessibleName(m_chart.title);
    m_view->setAccessibleName(m_chart.title);
    m_view->viewport()->setAccessibleName(m_chart.title);
}

void ChartPanel::redrawSoon()
{
    if (!m_isStale)
        redrawWhenSeen();
    m_isStale = true;
}

void ChartPanel::redrawWhenSeen()
{
    QMetaObject::invokeMethod(
        this,
        [this] {
            if (isVisible())
                redrawIfStale();
        },
        Qt::QueuedConnection);
}

void ChartPanel::redrawIfStale()
{
    if (m_isStale)
        redraw();
}

void ChartPanel::redraw()
{
    m_isStale = false;
    QChart* const old = m_view->chart();
    m_shown = fitted(m_chart, rowsFor(m_chart, m_view->size()));
    m_stops = stopsOf(m_shown);
    if (m_stop && *m_stop >= m_stops.size())
        m_stop.reset();
    m_drawn = new QChart;
    m_drawn->setAnimationOptions(QChart::NoAnimation);
    m_drawn->setMinimumSize(1.0, 1.0);  // QChartView would never become smaller than what it showed last
    if (!m_stops.isEmpty())
        draw(m_shown, inkOf(palette()), *m_drawn, m_view->size());
    m_view->setChart(m_drawn);
    delete old;
    m_ring = new QGraphicsEllipseItem(m_drawn);
    m_ring->setPen(QPen(palette().color(QPalette::WindowText), 2.0));
    m_ring->setBrush(Qt::NoBrush);
    m_ring->setZValue(100.0);
    connect(m_drawn, &QChart::plotAreaChanged, this, &ChartPanel::tell);
    tell();
}

QPointF ChartPanel::placeOf(const Dot& dot) const
{
    const Frame frame = frameOf(m_shown);
    const QRectF plot = m_drawn->plotArea();
    return {plot.left() + plot.width() * (dot.x - frame.xLow) / (frame.xHigh - frame.xLow),
            plot.bottom() - plot.height() * (dot.y - frame.yLow) / (frame.yHigh - frame.yLow)};
}

std::optional<qsizetype> ChartPanel::nearest(const QPointF& at) const
{
    const QPointF here = m_view->mapToScene(at.toPoint());
    if (!m_drawn->plotArea().adjusted(-kReachPx, -kReachPx, kReachPx, kReachPx).contains(here))
        return std::nullopt;
    const bool isBars = std::holds_alternative<Bars>(m_chart.content);
    const bool isColumns = std::holds_alternative<Histogram>(m_chart.content);
    std::optional<qsizetype> best;
    double bestPx = isBars || isColumns ? 1.0e9 : kReachPx;
    for (qsizetype k = 0; k < m_stops.size(); ++k) {
        const QPointF there = placeOf(m_stops[k]);
        // A bar is met at any length, a column at any height.
        const double away = isBars      ? std::abs(there.y() - here.y())
                            : isColumns ? std::abs(there.x() - here.x())
                                        : std::hypot(there.x() - here.x(), there.y() - here.y());
        if (away < bestPx) {
            bestPx = away;
            best = k;
        }
    }
    return best;
}

void ChartPanel::setStop(std::optional<qsizetype> stop)
{
    redrawIfStale();
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

/// The ring around the value, and its words beside it.
void ChartPanel::tell()
{
    m_ring->setVisible(m_stop.has_value());
    m_callout->setVisible(m_stop.has_value());
    setAccessibleDescription(m_stop ? said() : m_chart.note);
    if (!m_stop)
        return;
    const QPointF at = placeOf(m_stops[*m_stop]);
    m_ring->setRect(at.x() - kRingPx, at.y() - kRingPx, 2.0 * kRingPx, 2.0 * kRingPx);
    m_callout->setText(said());
    m_callout->setWordWrap(false);
    QSize size = m_callout->sizeHint();
    const int widest = std::min(kCalloutPx, width() - 2 * kSpace2);
    if (size.width() > widest) {
        m_callout->setWordWrap(true);
        size = {widest, m_callout->heightForWidth(widest)};
    }
    const QPoint corner = m_view->pos() + m_view->mapFromScene(at);
    QRect box({corner.x() - size.width() / 2, corner.y() - size.height() - static_cast<int>(kRingPx) - kSpace2}, size);
    if (box.top() < 0)
        box.moveTop(corner.y() + static_cast<int>(kRingPx) + kSpace2);
    box.moveLeft(std::clamp(box.left(), 0, std::max(0, width() - box.width())));
    m_callout->setGeometry(box);
    m_callout->raise();
}

void ChartPanel::open()
{
    if (m_stop && m_stops[*m_stop].id != 0)
        emit chosen(m_stops[*m_stop].id);
}

bool ChartPanel::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && !m_stops.isEmpty()) {
        switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Right:
        case Qt::Key_Left:
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_Home:
        case Qt::Key_End:
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
            event->accept();
            return true;
        default:
            break;
        }
    }
    return QWidget::event(event);
}

void ChartPanel::keyPressEvent(QKeyEvent* event)
{
    redrawIfStale();
    const qsizetype last = m_stops.size() - 1;
    if (last < 0)
        return QWidget::keyPressEvent(event);
    switch (event->key()) {
    case Qt::Key_Right:
    case Qt::Key_Down:
        return setStop(m_stop ? std::min(*m_stop + 1, last) : 0);
    case Qt::Key_Left:
    case Qt::Key_Up:
        return setStop(m_stop ? std::max(*m_stop - 1, qsizetype{0}) : last);
    case Qt::Key_Home:
        return setStop(0);
    case Qt::Key_End:
        return setStop(last);
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
        return open();
    default:
        QWidget::keyPressEvent(event);
    }
}

bool ChartPanel::eventFilter(QObject* watched, QEvent* event)
{
    // Names and the key have a share of the room; the view gets it after the panel, or when it is shown first.
    if (event->type() == QEvent::Resize)
        redrawSoon();
    if (event->type() == QEvent::MouseMove || event->type() == QEvent::MouseButtonPress)
        redrawIfStale();
    if (event->type() == QEvent::MouseMove) {
        setStop(nearest(static_cast<QMouseEvent*>(event)->position()));
    } else if (event->type() == QEvent::MouseButtonPress) {
        setFocus(Qt::MouseFocusReason);
        if (const auto at = nearest(static_cast<QMouseEvent*>(event)->position())) {
            setStop(at);
            open();
        }
        return true;
    } else if (event->type() == QEvent::Leave && !hasFocus()) {
        setStop({});
    }
    return QWidget::eventFilter(watched, event);
}

void ChartPanel::paintEvent(QPaintEvent*)
{
    if (!hasFocus())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Link), 2.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), kRadius, kRadius);
}

void ChartPanel::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void ChartPanel::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    setStop({});
    update();
}

void ChartPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LanguageChange)
        redrawSoon();
}

void ChartPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    redrawWhenSeen();
}

void ChartPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    placeSaved();
    tell();
}

void ChartPanel::placeSaved()
{
    const int wide = std::max(1, width() - 2 * kSpace2);
    const int high = m_saved->hasHeightForWidth() ? m_saved->heightForWidth(wide) : m_saved->sizeHint().height();
    m_saved->setGeometry(kSpace2, height() - kSpace2 - high, wide, high);
}

bool ChartPanel::save(const QString& path)
{
    return m_save->save(path);
}

void ChartPanel::saySaved(const QString& sentence, bool isSaved)
{
    m_forSaved->stop();
    if (isSaved)
        m_forSaved->start();
    m_saved->setText(sentence);
    placeSaved();
    m_saved->show();
    m_saved->raise();
    announce(*m_saved);
}

}  // namespace ui::charts
