// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

#include "app/LoopThread.h"
#include "app/ReplayLoop.h"
#include "core/recording/Replay.h"
#include "tests/support/Rig.h"
#include "tests/support/SyntheticTooth.h"

using namespace std::chrono_literals;

namespace {

/// Counts its beats, and oversleeps when told to.
class CountingLoop final : public core::rt::Loop
{
public:
    std::atomic<int> begins{0};
    std::atomic<int> ticks{0};
    std::atomic<int> ends{0};
    std::atomic<long long> toldUs{0};
    std::atomic<long long> largestUs{0};
    std::atomic<bool> onlyWhole{true};
    std::atomic<int> sleepMsOnce{0};

    void begin() override { ++begins; }
    void tick(std::chrono::microseconds dt) override
    {
        ++ticks;
        toldUs += dt.count();
        if (dt.count() > largestUs)
            largestUs = dt.count();
        if (dt.count() <= 0 || dt.count() % 1000 != 0)
            onlyWhole = false;
        if (const int ms = sleepMsOnce.exchange(0); ms > 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(ms));
    }
    void end() override { ++ends; }
};

}  // namespace

class TestLoopThread : public QObject
{
    Q_OBJECT
private slots:
    void beatsUntilItIsAskedToStop();
    void missedBeatsAreToldAndNotMadeUpFor();
    void replayLoopShowsWhatWasRecorded();
    void replayLoopShowsLargeChangesToo();
    void replayLoopHoldsWhilePaused();
    void replayLoopPlaysFaster();
};

void TestLoopThread::beatsUntilItIsAskedToStop()
{
    CountingLoop loop;
    {
        app::LoopThread thread(loop, 1ms, app::LoopThread::Urgency::RealTime);
        thread.start();
        QTRY_VERIFY(loop.ticks > 50);
        QCOMPARE(loop.begins.load(), 1);
        QCOMPARE(loop.ends.load(), 0);
    }  // asks and waits
    QCOMPARE(loop.ends.load(), 1);
    QVERIFY(loop.onlyWhole);
    const int stopped = loop.ticks;
    std::this_thread::sleep_for(20ms);
    QCOMPARE(loop.ticks.load(), stopped);
}

void TestLoopThread::missedBeatsAreToldAndNotMadeUpFor()
{
    CountingLoop loop;
    app::LoopThread thread(loop, 1ms, app::LoopThread::Urgency::Normal);
    const auto start = std::chrono::steady_clock::now();
    thread.start();
    QTRY_VERIFY(loop.ticks > 20);
    loop.sleepMsOnce = 100;
    QTRY_VERIFY(loop.largestUs >= 100000);
    const int ticks = loop.ticks;
    QTRY_VERIFY(loop.ticks > ticks + 20);
    thread.requestInterruption();
    thread.wait();
    const auto passed = std::chrono::steady_clock::now() - start;
    // Every period is told once: the ticks missed came as one longer step, not as a burst.
    QVERIFY(loop.toldUs <= std::chrono::duration_cast<std::chrono::microseconds>(passed).count() + 2000);
    QVERIFY(loop.ticks <= passed / 1ms - 90);
    QVERIFY(loop.onlyWhole);
}

void TestLoopThread::replayLoopShowsWhatWasRecorded()
{
    support::Block block;
    block.side = 64;
    block.cellMm = 0.12;
    const auto anatomy = support::makeBlock(block);
    support::Rig rig;
    rig.open(anatomy);
    rig.send(core::session::SetDrill{true});
    rig.lean(0.0, 0.0, 2.0, 200);
    rig.lift();
    rig.send(core::session::SetBur{3});
    rig.lean(1.0, 0.0, 2.0, 200);
    rig.lift();
    rig.send(core::session::Undo{});
    rig.run(100);
    const auto recording = rig.session->recordingSoFar().value();

    core::session::UiLinks links;
    auto loop = app::ReplayLoop::make(recording, links, 5).value();
    core::history::TiledHeights view(anatomy->grid, anatomy->top);
    for (int n = 0; n < 1000 && !loop->isFinished(); ++n) {
        loop->tick(10ms);
        for (core::session::TilePatch patch; links.patches.tryPop(patch);) {
            QCOMPARE(patch.toothGeneration, 5U);
            view.setTile(patch.tileX, patch.tileY, patch.top);
        }
    }
    QVERIFY(loop->isFinished());
    QCOMPARE(view.flat(), rig.live().top);
    QCOMPARE(links.servo.latest().tick, rig.servo->state().tick);
    const core::terrain::PerMaterial removed = core::terrain::removedVolumes(rig.live());
    for (std::size_t m = 0; m < removed.size(); ++m)
        QVERIFY(std::abs(links.session.latest().removedMm3[m] - removed[m]) < 1.0e-9);
}

void TestLoopThread::replayLoopShowsLargeChangesToo()
{
    // Everything at once: more tiles than the queue to the view holds, and a view that takes them late.
    support::Block block;
    block.side = 512;
    block.cellMm = 0.02;
    block.bottomMm = -0.01;  // so thin that the first touch of the bur bores through
    const auto anatomy = support::makeBlock(block);
    core::session::ServoSettings settings;
    settings.hardness.material.fill({100.0, 0.0});
    core::recording::Recording recording(settings, anatomy);
    recording.append({core::session::ServoEvent::Kind::Drill, 0, {}, 1});
    recording.append({core::session::ServoEvent::Kind::Tick, 1000, {-4.5F, 4.5F, 1.0F}, 0});
    for (int n = 0; n < 4000; ++n)
        recording.append({core::session::ServoEvent::Kind::Tick,
                          1000,
                          {-4.5F + 0.6F * std::floor(static_cast<float>(n) / 250.0F),
                           4.5F - 0.036F * static_cast<float>(n % 250), -1.0F},
                          0});
    const auto outcome = core::recording::replay(recording);
    core::session::UiLinks links;
    auto loop = app::ReplayLoop::make(recording, links, 1).value();
    loop->tick(60s);
    core::history::TiledHeights view(anatomy->grid, anatomy->top);
    int patches = 0;
    for (int n = 0; n < 20 && !loop->isFinished(); ++n) {
        for (core::session::TilePatch patch; links.patches.tryPop(patch); ++patches)
            view.setTile(patch.tileX, patch.tileY, patch.top);
        loop->tick(10ms);
    }
    for (core::session::TilePatch patch; links.patches.tryPop(patch); ++patches)
        view.setTile(patch.tileX, patch.tileY, patch.top);
    QVERIFY2(patches > 512, qPrintable(QString::number(patches)));
    QVERIFY(loop->isFinished());
    QCOMPARE(view.flat(), outcome->tooth.top);
    QVERIFY(links.session.latest().perforated);
}

void TestLoopThread::replayLoopHoldsWhilePaused()
{
    support::Rig rig;
    rig.open(support::makeBlock({}));
    rig.run(1000);
    core::session::UiLinks links;
    auto loop = app::ReplayLoop::make(rig.session->recordingSoFar().value(), links, 1).value();
    for (int n = 0; n < 20; ++n)
        loop->tick(10ms);
    loop->setPaused(true);
    for (int n = 0; n < 200; ++n)
        loop->tick(10ms);
    QVERIFY(std::abs(links.session.latest().recordedS - 0.2) < 1.0e-9);
    QVERIFY(!loop->isFinished());
    loop->setPaused(false);
    for (int n = 0; n < 100; ++n)
        loop->tick(10ms);
    QVERIFY(loop->isFinished());
}

void TestLoopThread::replayLoopPlaysFaster()
{
    support::Rig rig;
    rig.open(support::makeBlock({}));
    rig.run(1000);
    core::session::UiLinks links;
    auto loop = app::ReplayLoop::make(rig.session->recordingSoFar().value(), links, 1).value();
    loop->setSpeed(8);
    for (int n = 0; n < 10; ++n)
        loop->tick(10ms);
    QVERIFY(std::abs(links.session.latest().recordedS - 0.8) < 1.0e-9);
}

QTEST_GUILESS_MAIN(TestLoopThread)
#include "tst_loop_thread.moc"
