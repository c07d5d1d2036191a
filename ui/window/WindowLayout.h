// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMainWindow;

namespace ui::kit {
class Actions;
}
namespace ui::tooth {
class ToothView;
}

namespace ui::window {

class PracticeRoom;

/// Saves the layout that the user chooses and restores it at the next run: size of the window, side panel, section, and
/// left or right hand.
class WindowLayout final : public QObject
{
    Q_OBJECT
public:
    WindowLayout(QMainWindow& window, PracticeRoom& room, kit::Actions& actions, tooth::ToothView& view);

    /// Restores the layout of the last run, but not the full screen.
    void restore();
    /// Saves the size and position of the window.
    void saveGeometry() const;

signals:
    /// Emitted when the section is shown or hidden.
    void changed();

private:
    QMainWindow& m_window;
    PracticeRoom& m_room;
    kit::Actions& m_actions;
    tooth::ToothView& m_view;
};

}  // namespace ui::window
