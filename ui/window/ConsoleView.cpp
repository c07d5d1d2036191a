// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ConsoleView.h"

#include <algorithm>

#include <QAction>

#include "ui/console/Console.h"
#include "ui/console/WatchPanel.h"
#include "ui/kit/Actions.h"
#include "ui/kit/Theme.h"
#include "ui/practice/HandControls.h"
#include "ui/tooth/ToothView.h"
#include "ui/window/ExerciseView.h"
#include "ui/window/HardnessController.h"
#include "ui/window/PracticeRoom.h"

namespace ui::window {
namespace {

constexpr int kMostHeightPx = 260;

}  // namespace

ConsoleView::ConsoleView(PracticeRoom& room, kit::Actions& actions)
    : QObject(&room), m_actions(actions), m_watch(new console::WatchPanel(m_parameters, &room)),
      m_console(new console::Console(m_parameters, *m_watch, &room))
{
    connect(m_watch, &console::WatchPanel::resized, this, &ConsoleView::resized);
    connect(m_console, &console::Console::closeRequested, m_actions.console, &QAction::trigger);
    connect(m_actions.console, &QAction::triggered, this, [this] {
        if (m_console->isVisible()) {
            m_console->hide();
            emit closed();
        } else {
            m_console->open();
        }
        emit resized();
    });
}

void ConsoleView::addParameters(HardnessController& hardness, tooth::ToothView& view, practice::HandControls& hand,
                                const PracticeState& state, const ExerciseView& exercise)
{
    hardness.addTo(m_parameters);
    console::registerSwitch(m_parameters, "view.wet", m_actions.wetLook);
    console::registerSwitch(m_parameters, "view.bur_light", m_actions.burLight, true);
    console::registerSwitch(m_parameters, "view.neighbours", m_actions.neighbours);
    console::registerSwitch(m_parameters, "view.hand_place", m_actions.handPlace);
    console::registerSwitch(m_parameters, "view.every_eye", m_actions.distinctColours);
    console::registerSwitch(m_parameters, "view.less_motion", m_actions.reducedMotion);
    console::registerHand(
        m_parameters, view.hand(), [&hand](double mmPerS) { hand.setFeed(mmPerS); },
        [&view](double newtons) { view.setPushForce(newtons); });
    console::registerLive(
        m_parameters, [&state] { return state.servo; }, m_periods,
        [&state, &exercise] {
            const bool isBlind = exercise.isBlindfolded();
            return console::Told{state.aids.depthGauge && !isBlind, !isBlind};
        });
}

bool ConsoleView::isOpen() const
{
    return m_console->isVisible();
}

bool ConsoleView::isTypedIn(const QWidget* focused) const
{
    return isOpen() && m_console->isAncestorOf(focused);
}

bool ConsoleView::hideWatch()
{
    if (m_watch->names().isEmpty())
        return false;
    m_watch->forget({});
    return true;
}

void ConsoleView::placeIn(const QRect& area)
{
    m_console->setGeometry(area.x(), area.y(), area.width(), std::min(kMostHeightPx, area.height() / 2));
    const int below = isOpen() ? m_console->geometry().bottom() : area.top();
    m_watch->move(area.right() - kit::kSpace4 - m_watch->width(), below + kit::kSpace4);
    m_console->raise();
}

}  // namespace ui::window
