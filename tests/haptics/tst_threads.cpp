// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "core/recording/Replay.h"
#include "core/servo/ServoState.h"
#include "core/session/JournalLoop.h"
#include "core/session/SessionChannels.h"
#include "tests/support/Rig.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using namespace core::session;
using namespace core::servo;
using namespace std::chrono_literals;

namespace {

/// Waits between two ticks of a thread.
void rest(std::chrono::microseconds time)
{
    std::this_thread::sleep_for(time);  // the periods of the threads mix their ticks
}

/// The ui thread of a simulated user: it polls, sends commands and looks at the attempt.
class Person
{
public:
    Person(support::Rig& rig, JournalLoop& journal, std::shared_ptr<const terrain::ToothAnatomy> anatomy)
        : m_rig(rig), m_journal(journal), m_anatomy(std::move(anatomy))
    {}

    /// Polls the channels like a view.
    void look()
    {
        const ServoState& state = m_rig.uiLinks->servo.latest();
        if (state.toothGeneration == m_lastGeneration && state.tick < m_lastTick)
            ++m_backwards;
        m_lastTick = state.tick;
        m_lastGeneration = state.toothGeneration;
        static_cast<void>(m_rig.uiLinks->session.latest().undoSteps);
        for (TilePatch patch; m_rig.uiLinks->patches.tryPop(patch);) {
        }
    }

    /// Sends one random command, or none. Returns false if a command could not be sent.
    bool act()
    {
        if (const std::uint64_t version = m_rig.uiLinks->session.latest().historyVersion; version != m_version) {
            m_version = version;
            m_history = m_rig.session->historySoFar();
        }
        const auto anyMoment = [&] {
            return m_history.empty()
                       ? history::MomentId{}
                       : m_history[static_cast<std::size_t>(m_rng.below(static_cast<int>(m_history.size())))].id;
        };
        const int what = m_rng.below(40);
        bool sent = true;
        if (what < 3)
            sent = m_rig.uiLinks->commands.tryPush(Undo{});
        else if (what == 3)
            sent = m_rig.uiLinks->commands.tryPush(Redo{});
        else if (what == 4)
            sent = m_rig.uiLinks->commands.tryPush(SetBur{static_cast<std::uint8_t>(m_rng.below(4))});
        else if (what == 5)
            sent = m_rig.uiLinks->commands.tryPush(Reload{});
        else if (what == 6)
            static_cast<void>(m_rig.session->toothSoFar());
        else if (what == 7)
            static_cast<void>(m_rig.session->recordingSoFar());
        else if (what == 8)
            sent = m_rig.uiLinks->commands.tryPush(GoTo{anyMoment()});
        else if (what == 9)
            static_cast<void>(m_rig.session->momentHeights(anyMoment()));
        else if (what == 10)
            sent = m_rig.uiLinks->commands.tryPush(AddNote{m_rng.next()});
        else if (what == 11)
            static_cast<void>(m_journal.failure());
        else if (what == 12 && m_generation < 4) {
            sent = m_rig.uiLinks->commands.tryPush(
                ReplaceTooth{std::make_unique<terrain::Tooth>(m_anatomy), m_generation + 1});
            m_generation += sent ? 1 : 0;
        }
        return sent;
    }

    /// Returns how often a state of the servo was older than the one before.
    [[nodiscard]] int backwards() const { return m_backwards; }
    [[nodiscard]] std::uint64_t teeth() const { return m_generation; }

private:
    support::Rig& m_rig;
    JournalLoop& m_journal;
    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    Rng m_rng{17};
    std::uint64_t m_generation = 1;
    std::uint64_t m_version = 0;
    std::uint64_t m_lastTick = 0;
    std::uint64_t m_lastGeneration = 0;
    int m_backwards = 0;
    std::vector<history::MomentInfo> m_history;
};

}  // namespace

/// Runs the five threads of the program at full speed, for ThreadSanitizer. It uses only std::thread, because Qt's
/// threads are not instrumented.
class TestThreads : public QObject
{
    Q_OBJECT
private slots:
    void theThreadsAgreeAfterwards()
    {
        const auto anatomy = support::smallBlock();
        support::Rig rig;
        const QTemporaryDir folder;
        JournalLoop journal(*rig.session, folder.path().toStdString());
        rig.send(ReplaceTooth{std::make_unique<terrain::Tooth>(anatomy), 1});
        rig.send(SetDrill{true});

        std::atomic<bool> stop{false};
        std::atomic<bool> servoDone{false};
        std::thread servo([&] {
            support::RestlessHand hand(6, 2.0);
            while (!stop) {
                rig.device.tipMm = hand.next();
                rig.servo->tick(1ms);
                rest(100us);
            }
            rig.device.tipMm = {0.0F, 0.0F, 5.0F};
            for (int n = 0; n < 400; ++n) {
                rig.servo->tick(1ms);
                rest(100us);
            }
            servoDone = true;
        });
        std::thread session([&] {
            while (!servoDone) {
                rig.session->tick(10ms);
                rest(1ms);
            }
            rig.session->tick(10ms);
        });
        std::atomic<bool> sessionDone{false};
        std::thread writer([&] {
            while (!sessionDone) {
                journal.tick(JournalLoop::kPeriod);
                rest(2ms);
            }
            journal.tick(JournalLoop::kPeriod);
        });
        std::thread syncer([&] {
            while (!sessionDone) {
                journal.syncing().tick(JournalLoop::kPeriod);
                rest(2ms);
            }
        });

        // This is the ui thread.
        Person person(rig, journal, anatomy);
        for (int round = 0; round < 600; ++round) {
            person.look();
            QVERIFY(person.act());
            rest(5ms);
        }
        stop = true;
        servo.join();
        session.join();
        sessionDone = true;
        writer.join();
        syncer.join();
        journal.end();

        QCOMPARE(person.backwards(), 0);
        QCOMPARE(rig.uiLinks->servo.latest().health & kRecordGap, 0U);
        QCOMPARE(rig.mirrorHash(), rig.liveHash());
        const auto outcome = recording::replay(rig.session->recordingSoFar().value());
        QVERIFY(outcome);
        QVERIFY(outcome->agreesWithWitness);
        QCOMPARE(outcome->stateHash, rig.liveHash());
        QVERIFY(!journal.failure());
        QCOMPARE(journal.eventsWritten(), rig.session->recordingSoFar()->events());
        qInfo("%llu ticks, %llu teeth", static_cast<unsigned long long>(rig.servo->state().tick),
              static_cast<unsigned long long>(person.teeth()));
    }
};

QTEST_APPLESS_MAIN(TestThreads)
#include "tst_threads.moc"
