// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/WalkedChart.h"

#include <QKeyEvent>
#include <QPainter>

#include "ui/shell/Theme.h"

namespace ui::charts {

WalkedChart::WalkedChart(double step, double most, QWidget* parent) : QWidget(parent), m_step(step), m_most(most)
{
    setFocusPolicy(Qt::StrongFocus);
}

bool WalkedChart::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Right:
        case Qt::Key_Left:
        case Qt::Key_Home:
        case Qt::Key_End:
            event->accept();
            return true;
        default:
            break;
        }
    }
    return QWidget::event(event);
}

void WalkedChart::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Right:
        return walkTo(told() + m_step);
    case Qt::Key_Left:
        return walkTo(told() - m_step);
    case Qt::Key_Home:
        return walkTo(0.0);
    case Qt::Key_End:
        return walkTo(m_most);
    default:
        QWidget::keyPressEvent(event);
    }
}

void WalkedChart::paintEvent(QPaintEvent*)
{
    if (!hasFocus())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Link), 2.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), shell::kRadius, shell::kRadius);
}

void WalkedChart::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void WalkedChart::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    update();
}

}  // namespace ui::charts
