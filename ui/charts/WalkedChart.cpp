// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/WalkedChart.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "ui/kit/Theme.h"

namespace ui::charts {
namespace {

std::optional<Step> stepOf(const QEvent* event)
{
    switch (static_cast<const QKeyEvent*>(event)->key()) {
    case Qt::Key_Left:
    case Qt::Key_Up:
        return Step::Back;
    case Qt::Key_Right:
    case Qt::Key_Down:
        return Step::On;
    case Qt::Key_Home:
        return Step::First;
    case Qt::Key_End:
        return Step::Last;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
        return Step::Open;
    default:
        return std::nullopt;
    }
}

}  // namespace

WalkedChart::WalkedChart(QWidget* parent) : QWidget(parent), m_view(new QWidget(this))
{
    setFocusPolicy(Qt::StrongFocus);
    m_view->setObjectName(QStringLiteral("chartView"));
    m_view->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_view->setMouseTracking(true);
    m_view->installEventFilter(this);
}

void WalkedChart::setDrawn(const Chart& chart)
{
    m_drawn = chart;
    m_view->setAccessibleName(chart.title);
    m_view->update();
}

Plot WalkedChart::plot() const
{
    return plotOf(m_drawn, QRectF(m_view->rect()));
}

double WalkedChart::stepped(Step step, double from, double by, double most)
{
    const double to = step == Step::First ? 0.0 : step == Step::Last ? most : step == Step::On ? from + by : from - by;
    return std::clamp(by * std::round(to / by), 0.0, most);
}

bool WalkedChart::takes(Step step) const
{
    return step != Step::Open && !stopsOf(m_drawn).isEmpty();
}

bool WalkedChart::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride)
        if (const auto step = stepOf(event); step && takes(*step)) {
            event->accept();
            return true;
        }
    if (event->type() == QEvent::LanguageChange)
        m_view->update();
    return QWidget::event(event);
}

void WalkedChart::keyPressEvent(QKeyEvent* event)
{
    if (const auto step = stepOf(event); step && takes(*step))
        walk(*step);
    else
        QWidget::keyPressEvent(event);
}

void WalkedChart::paintEvent(QPaintEvent*)
{
    if (!hasFocus())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Link), 2.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), kit::kRadius, kit::kRadius);
}

bool WalkedChart::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::Paint: {
        QPainter painter(m_view);
        draw(painter, QRectF(m_view->rect()), m_drawn, inkOf(palette()));
        paintOver(painter);
        return true;
    }
    case QEvent::Resize:
        viewResized();
        break;
    case QEvent::MouseMove:
        point(static_cast<QMouseEvent*>(event)->position());
        break;
    case QEvent::MouseButtonPress:
        setFocus(Qt::MouseFocusReason);
        point(static_cast<QMouseEvent*>(event)->position());
        if (takes(Step::Open))
            walk(Step::Open);
        return true;
    case QEvent::Leave:
        if (!hasFocus())
            point(std::nullopt);
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace ui::charts
