// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/WindowLayout.h"

#include <QAction>
#include <QMainWindow>
#include <QSettings>

#include "ui/kit/Actions.h"
#include "ui/kit/AppSettings.h"
#include "ui/tooth/ToothView.h"
#include "ui/window/PracticeRoom.h"

namespace ui::window {
namespace {

const QString kGeometry = QStringLiteral("window/geometry");
const QString kPanel = QStringLiteral("window/panel");
const QString kSection = QStringLiteral("window/section");
const QString kLeftHanded = QStringLiteral("window/leftHanded");

}  // namespace

WindowLayout::WindowLayout(QMainWindow& window, PracticeRoom& room, kit::Actions& actions, tooth::ToothView& view)
    : QObject(&window), m_window(window), m_room(room), m_actions(actions), m_view(view)
{
    connect(m_actions.section, &QAction::triggered, this, [this](bool visible) {
        m_room.setSectionVisible(visible);
        kit::memory().setValue(kSection, visible);
        emit changed();
    });
    connect(m_actions.panel, &QAction::triggered, this, [this](bool visible) {
        m_room.setPanelVisible(visible);
        kit::memory().setValue(kPanel, visible);
    });
    connect(m_actions.fullScreen, &QAction::triggered, this,
            [this](bool full) { m_window.setWindowState(m_window.windowState().setFlag(Qt::WindowFullScreen, full)); });
    connect(m_actions.otherHand, &QAction::toggled, this, [this](bool left) {
        m_view.setLeftHanded(left);
        kit::memory().setValue(kLeftHanded, left);
    });
}

void WindowLayout::restore()
{
    const QSettings kept = kit::memory();
    static_cast<void>(m_window.restoreGeometry(kept.value(kGeometry).toByteArray()));
    m_window.setWindowState(m_window.windowState().setFlag(Qt::WindowFullScreen, false));
    m_actions.panel->setChecked(kit::recalled(kept, kPanel, true));
    m_room.setPanelVisible(m_actions.panel->isChecked());
    m_actions.section->setChecked(kit::recalled(kept, kSection, false));
    m_room.setSectionVisible(m_actions.section->isChecked());
    m_actions.otherHand->setChecked(kit::recalled(kept, kLeftHanded, false));
    m_view.setLeftHanded(m_actions.otherHand->isChecked());
}

void WindowLayout::saveGeometry() const
{
    kit::memory().setValue(kGeometry, m_window.saveGeometry());
}

}  // namespace ui::window
