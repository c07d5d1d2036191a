// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <thread>

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

/// Between two beats of a thread.
void rest(std::chrono::microseconds time)
{
    std::this_thread::sleep_for(time);  // the threads' periods make the mix that is tested
}

}  // namespace

/// The five threads of the program at full speed, for ThreadSanitizer: std::thread only, since Qt's are not
/// instrumented.

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

        // This is the ui thread: it polls, sends commands, looks at the attempt.
        Rng rng(17);
        std::uint64_t generation = 1;
        std::uint64_t lastTick = 0;
        std::uint64_t lastGeneration = 0;
        std::uint64_t lastVersion = 0;
        std::vector<history::MomentInfo> history;
        int backwards = 0;
        for (int round = 0; round < 600; ++round) {
            const ServoState& state = rig.uiLinks->servo.latest();
            if (state.toothGeneration == lastGeneration && state.tick < lastTick)
                ++backwards;
            lastTick = state.tick;
            lastGeneration = state.toothGeneration;
            static_cast<void>(rig.uiLinks->session.latest().undoSteps);
            for (TilePatch patch; rig.uiLinks->patches.tryPop(patch);) {
            }
            if (const std::uint64_t version = rig.uiLinks->session.latest().historyVersion; version != lastVersion) {
                lastVersion = version;
                history = rig.session->historySoFar();
            }
            const auto anyMoment = [&] {
                return history.empty()
                           ? history::MomentId{}
                           : history[static_cast<std::size_t>(rng.below(static_cast<int>(history.size())))].id;
            };
            const int what = rng.below(40);
            bool sent = true;
            if (what < 3)
                sent = rig.uiLinks->commands.tryPush(Undo{});
            else if (what == 3)
                sent = rig.uiLinks->commands.tryPush(Redo{});
            else if (what == 4)
                sent = rig.uiLinks->commands.tryPush(SetBur{static_cast<std::uint8_t>(rng.below(4))});
            else if (what == 5)
                sent = rig.uiLinks->commands.tryPush(Reload{});
            else if (what == 6)
                static_cast<void>(rig.session->toothSoFar());
            else if (what == 7)
                static_cast<void>(rig.session->recordingSoFar());
            else if (what == 8)
                sent = rig.uiLinks->commands.tryPush(GoTo{anyMoment()});
            else if (what == 9)
                static_cast<void>(rig.session->momentHeights(anyMoment()));
            else if (what == 10)
                sent = rig.uiLinks->commands.tryPush(AddNote{rng.next()});
            else if (what == 11)
                static_cast<void>(journal.failure());
            else if (what == 12 && generation < 4) {
                sent = rig.uiLinks->commands.tryPush(
                    ReplaceTooth{std::make_unique<terrain::Tooth>(anatomy), generation + 1});
                generation += sent ? 1 : 0;
            }
            QVERIFY(sent);
            rest(5ms);
        }
        stop = true;
        servo.join();
        session.join();
        sessionDone = true;
        writer.join();
        syncer.join();
        journal.end();

        QCOMPARE(backwards, 0);
        QCOMPARE(rig.uiLinks->servo.latest().health & kRecordGap, 0U);
        QCOMPARE(rig.mirrorHash(), rig.liveHash());
        const auto outcome = recording::replay(rig.session->recordingSoFar().value());
        QVERIFY(outcome);
        QVERIFY(outcome->agreesWithWitness);
        QCOMPARE(outcome->stateHash, rig.liveHash());
        QVERIFY(!journal.failure());
        QCOMPARE(journal.eventsWritten(), rig.session->recordingSoFar()->events());
        qInfo("%llu ticks, %llu teeth", static_cast<unsigned long long>(rig.servo->state().tick),
              static_cast<unsigned long long>(generation));
    }
};

QTEST_APPLESS_MAIN(TestThreads)
#include "tst_threads.moc"
