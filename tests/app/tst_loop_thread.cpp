// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <atomic>
#include <thread>

#include "app/threads/LoopThread.h"

using namespace std::chrono_literals;

namespace {

/// Counts its ticks, and takes too long for one when told to.
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
            std::this_thread::sleep_for(std::chrono::milliseconds(ms));  // a tick that takes too long
    }
    void end() override { ++ends; }
};

}  // namespace

class TestLoopThread : public QObject
{
    Q_OBJECT
private slots:
    void beatsUntilItIsAskedToStop()
    {
        CountingLoop loop;
        {
            app::LoopThread thread(loop, 1ms, app::LoopThread::Urgency::RealTime);
            thread.start();
            QTRY_VERIFY(loop.ticks > 50);
            QCOMPARE(loop.begins.load(), 1);
            QCOMPARE(loop.ends.load(), 0);
        }  // the destructor requests the stop and waits
        QCOMPARE(loop.ends.load(), 1);
        QVERIFY(loop.onlyWhole);
        const int stopped = loop.ticks;
        std::this_thread::sleep_for(20ms);  // long enough for 20 ticks
        QCOMPARE(loop.ticks.load(), stopped);
    }

    void missedBeatsAreToldAndNotMadeUpFor()
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
        // The steps add up to the time that has passed: the missed ticks came as one longer step, not as a burst.
        QVERIFY(loop.toldUs <= std::chrono::duration_cast<std::chrono::microseconds>(passed).count() + 2000);
        QVERIFY(loop.ticks <= passed / 1ms - 90);
        QVERIFY(loop.onlyWhole);
    }
};

QTEST_GUILESS_MAIN(TestLoopThread)
#include "tst_loop_thread.moc"
