// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/KeyFilter.h"

#include <utility>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>

namespace ui::window {
namespace {

bool isLetterOrSpace(const QKeyEvent& key)
{
    return !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) && !key.text().isEmpty() &&
           (key.text().at(0).isLetterOrNumber() || key.text().at(0) == u' ');
}

/// Returns the search field that Esc would clear; null if there is none.
QLineEdit* fieldToClear(QObject* focused, const QKeyEvent& key)
{
    auto* field = qobject_cast<QLineEdit*>(focused);
    const bool isSearch = field != nullptr && field->isClearButtonEnabled() && !field->text().isEmpty();
    return isSearch && key.key() == Qt::Key_Escape ? field : nullptr;
}

}  // namespace

KeyFilter::KeyFilter(const QStackedWidget& pages, const QWidget& room, QList<const QWidget*> offices, QObject* parent)
    : QObject(parent), m_pages(pages), m_room(room), m_offices(std::move(offices))
{
    qApp->installEventFilter(this);
}

/// Returns whether the widget with the focus gets a key although the key is a shortcut.
bool KeyFilter::belongsToWidget(const QKeyEvent& key, const QObject& focused) const
{
    if (key.key() == Qt::Key_Escape && QApplication::activePopupWidget() != nullptr)
        return true;
    if (key.key() == Qt::Key_Space && qobject_cast<const QAbstractButton*>(&focused) != nullptr)
        return true;
    if (!focused.isWidgetType() || !isLetterOrSpace(key))
        return false;
    const QWidget* const page = m_pages.currentWidget();
    return m_offices.contains(page) || qobject_cast<const QComboBox*>(&focused) != nullptr ||
           (page != &m_room && qobject_cast<const QAbstractItemView*>(&focused) != nullptr);
}

bool KeyFilter::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::FocusIn) {
        if (auto* button = qobject_cast<QPushButton*>(watched))
            button->setAutoDefault(true);
    } else if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
        const auto& key = *static_cast<const QKeyEvent*>(event);
        QLineEdit* const field = fieldToClear(watched, key);
        const bool isShortcut = event->type() == QEvent::ShortcutOverride;
        if (field != nullptr || (isShortcut && belongsToWidget(key, *watched))) {
            if (field != nullptr && !isShortcut)
                field->clear();
            event->accept();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace ui::window
