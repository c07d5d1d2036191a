// SPDX-License-Identifier: GPL-3.0-or-later
// The drill runs only while the tooth is visible and drilling is allowed, and returns to its previous state afterwards.
#include <memory>

#include <QTest>
#include <QWidget>

#include "core/session/SessionChannels.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticMolar.h"
#include "ui/kit/Actions.h"
#include "ui/kit/MessageBar.h"
#include "ui/window/BurControl.h"
#include "ui/window/CommandSender.h"

using lessons::Task;

namespace {

struct Rig
{
    Rig() { state.tooth = support::syntheticMolar(); }

    /// Switches the drill by its action, as the user does.
    void press()
    {
        actions.drill->setChecked(!actions.drill->isChecked());
        control.switchDrill(actions.drill->isChecked());
        answer();
    }
    /// Returns the requests to the drill since the last call.
    QList<bool> requests()
    {
        QList<bool> all;
        for (core::session::SessionCommand c; links->commands.tryPop(c);)
            if (const auto* drill = std::get_if<core::servo::SetDrill>(&c))
                all << drill->on;
        return all;
    }
    /// Executes the requests as the servo does, and reports the result. Returns the requests.
    QList<bool> answer()
    {
        const QList<bool> all = requests();
        core::servo::ServoState servo;
        servo.tick = 1;
        servo.drillSwitchedOn = all.isEmpty() ? actions.drill->isChecked() : all.back();
        control.show(servo);
        return all;
    }

    QWidget window;
    ui::kit::Actions actions{&window};
    ui::kit::MessageBar messages{&window};
    std::unique_ptr<core::session::UiChannels> links = std::make_unique<core::session::UiChannels>();
    ui::window::CommandSender sender{*links, messages};
    ui::window::PracticeState state;
    ui::window::BurControl control{sender, actions, state};
};

}  // namespace

class TestBurControl : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_rig = std::make_unique<Rig>();
        m_rig->press();
        QVERIFY(m_rig->actions.drill->isChecked());
    }

    void pausesOnOtherPages()
    {
        m_rig->control.setInRoom(false, false);
        QCOMPARE(m_rig->answer(), QList<bool>{false});
        m_rig->control.setInRoom(true, false);
        QCOMPARE(m_rig->answer(), QList<bool>{true});
        m_rig->control.setInRoom(true, false);
        QCOMPARE(m_rig->answer(), QList<bool>());
    }

    void waitsForTheAnswerToABreach()
    {
        m_rig->control.stopForBreach(true);
        QCOMPARE(m_rig->answer(), QList<bool>{false});
        m_rig->control.stopForBreach(false);  // another violation before the answer
        m_rig->answer();
        m_rig->control.continueAfterBreach();
        QCOMPARE(m_rig->answer(), QList<bool>{true});
        m_rig->control.continueAfterBreach();
        QCOMPARE(m_rig->answer(), QList<bool>());
    }

    void doesNotStartAgainAfterAnExam()
    {
        m_rig->control.setInRoom(false, false);
        m_rig->answer();
        m_rig->state.isOver = true;
        m_rig->control.stopAtEnd();
        m_rig->answer();
        m_rig->control.setInRoom(true, false);
        QCOMPARE(m_rig->answer(), QList<bool>());
        // The next attempt begins like this one.
        m_rig->state.isOver = false;
        m_rig->control.beginTask(Task::CutIdeal);
        QCOMPARE(m_rig->answer(), QList<bool>{true});
    }

    void restsInExercisesWithoutCutting()
    {
        m_rig->control.beginTask(Task::TouchPoints);
        QCOMPARE(m_rig->answer(), QList<bool>{false});
        m_rig->control.beginTask(Task::RemoveDecay);
        QCOMPARE(m_rig->answer(), QList<bool>{true});
    }

    void unchecksTheActionIfTheQueueIsFull()
    {
        while (m_rig->links->commands.tryPush(core::session::Undo{})) {
        }
        m_rig->actions.drill->setChecked(false);
        m_rig->control.switchDrill(false);
        QVERIFY(m_rig->actions.drill->isChecked());
        QVERIFY(!m_rig->messages.sentence().isEmpty());
    }

private:
    std::unique_ptr<Rig> m_rig;
};

CUSP_TEST(TestBurControl)
#include "tst_bur_control.moc"
