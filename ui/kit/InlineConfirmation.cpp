// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/InlineConfirmation.h"

#include <utility>

#include <QEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QStyleHints>

namespace ui::kit {

InlineConfirmation::InlineConfirmation(QWidget& part) : QObject(&part)
{
    part.installEventFilter(this);
}

void InlineConfirmation::ask()
{
    m_isAsked = true;
    m_sinceAsked.start();
}

bool InlineConfirmation::mayBeAnswered() const
{
    return m_isAsked && m_sinceAsked.elapsed() >= 2 * QGuiApplication::styleHints()->mouseDoubleClickInterval();
}

void InlineConfirmation::end()
{
    m_isAsked = false;
}

bool InlineConfirmation::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    const bool isEscape = isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
    if (m_isAsked && event->type() == QEvent::ShortcutOverride && isEscape) {
        event->accept();  // otherwise Escape would leave the page
        return true;
    }
    const bool isNo = isEscape || event->type() == QEvent::Hide;
    if (isNo && std::exchange(m_isAsked, false)) {
        emit withdrawn();
        return isEscape;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace ui::kit
