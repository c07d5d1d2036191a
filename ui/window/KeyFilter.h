// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QKeyEvent;
class QStackedWidget;
class QWidget;

namespace ui::window {

/// Passes keys to the widget with the keyboard focus that would otherwise trigger a shortcut of the window.
///
/// - Space presses the button with the focus. Otherwise it switches the drill.
/// - Esc closes an open list or clears a search field. Otherwise it opens the previous page.
/// - Letters, digits and space are no shortcuts on pages of people, classes and settings, nor in lists and combo boxes.
/// - Enter presses the button with the focus on every page. Qt does that only in dialogs.
class KeyFilter final : public QObject
{
    Q_OBJECT
public:
    /// Filters the events of the whole program.
    /// @param pages    the pages of the window
    /// @param room     the page on which a letter is a shortcut even if a list has the focus
    /// @param offices  the pages on which letters are no shortcuts
    KeyFilter(const QStackedWidget& pages, const QWidget& room, QList<const QWidget*> offices, QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool belongsToWidget(const QKeyEvent& key, const QObject& focused) const;

    const QStackedWidget& m_pages;
    const QWidget& m_room;
    QList<const QWidget*> m_offices;
};

}  // namespace ui::window
