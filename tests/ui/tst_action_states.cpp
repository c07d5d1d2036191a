// SPDX-License-Identifier: GPL-3.0-or-later
// Each action is enabled only where it has an effect.
#include <QTest>
#include <QWidget>

#include "tests/support/Suite.h"
#include "tests/support/SyntheticMolar.h"
#include "ui/kit/Actions.h"
#include "ui/practice/ViewMenu.h"
#include "ui/window/ActionStates.h"

using ui::window::PracticeState;
using ui::window::WindowFacts;

class TestActionStates : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_state = {};
        m_state.tooth = support::syntheticMolar();
        m_state.session.undoSteps = 1;
        m_facts = {};
        m_facts.isInRoom = m_facts.isViewUsable = true;
    }

    void practiceMayCutAndUndo()
    {
        enable();
        QVERIFY(m_actions.drill->isEnabled() && m_actions.undo->isEnabled() && m_actions.grade->isEnabled());
        QVERIFY(!m_actions.redo->isEnabled() && !m_actions.pauseReplay->isVisible());
    }

    void anExamCannotBeUndone()
    {
        beginExam();
        enable();
        QVERIFY(m_actions.drill->isEnabled() && m_actions.grade->isEnabled());
        QVERIFY(!m_actions.undo->isEnabled() && !m_actions.reload->isEnabled() && !m_actions.history->isEnabled());
        QVERIFY(!m_actions.saveRecording->isEnabled());
        m_state.isOver = true;
        enable();
        QVERIFY(!m_actions.drill->isEnabled() && m_actions.reload->isEnabled());
        m_state.isUsedUp = true;
        enable();
        QVERIFY(!m_actions.reload->isEnabled());
    }

    void aReplayIsWatchedOnly()
    {
        m_state.isReplaying = true;
        enable();
        QVERIFY(!m_actions.drill->isEnabled() && !m_actions.undo->isEnabled());
        QVERIFY(m_actions.pauseReplay->isEnabled() && m_actions.pauseReplay->isVisible());
        QVERIFY(!m_actions.along->isVisible());
        m_facts.canLead = true;
        enable();
        QVERIFY(m_actions.along->isVisible());
    }

    void aidsNeedTheLesson()
    {
        enable();
        QVERIFY(m_actions.section->isEnabled() && m_actions.mirror->isEnabled());
        m_state.aids.section = m_state.aids.mirror = false;
        enable();
        QVERIFY(!m_actions.section->isEnabled() && !m_actions.mirror->isEnabled());
    }

    void theLoginPageLocksEverythingElse()
    {
        m_facts.isInRoom = false;
        m_facts.isAtLogin = true;
        enable();
        QVERIFY(m_actions.quit->isEnabled() && !m_actions.back->isEnabled() && !m_actions.lessons->isEnabled());
        m_facts.mayLeaveLogin = true;
        enable();
        QVERIFY(m_actions.back->isEnabled() && !m_actions.lessons->isEnabled());
    }

private:
    void enable() { ui::window::enableActions(m_actions, m_menu, m_state, m_facts); }
    void beginExam()
    {
        m_state.assignment.emplace();
        m_state.assignment->lesson.emplace();
        m_state.assignment->lesson->exam = true;
    }

    QWidget m_window;
    ui::kit::Actions m_actions{&m_window};
    ui::practice::ViewMenu m_menu{m_actions, &m_window};
    PracticeState m_state;
    WindowFacts m_facts;
};

CUSP_TEST(TestActionStates)
#include "tst_action_states.moc"
