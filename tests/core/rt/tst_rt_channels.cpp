// SPDX-License-Identifier: GPL-3.0-or-later
// Stress tests of the two channels between threads, with one writer and one reader.
#include <QTest>

#include <array>
#include <cstdint>
#include <thread>

#include "core/rt/SpscQueue.h"
#include "core/rt/TripleBuffer.h"

class TestRtChannels : public QObject
{
    Q_OBJECT

private slots:
    void aFullQueueRefusesAndKeepsWhatItHas()
    {
        core::rt::SpscQueue<int, 4> queue;
        for (int k = 0; k < 4; ++k)
            QVERIFY(queue.tryPush(k));
        QCOMPARE(queue.space(), std::size_t(0));
        QVERIFY(!queue.tryPush(99));
        for (int k = 0; k < 4; ++k) {
            int value = -1;
            QVERIFY(queue.tryPop(value));
            QCOMPARE(value, k);
        }
        int untouched = 7;
        QVERIFY(!queue.tryPop(untouched));
        QCOMPARE(untouched, 7);
    }

    void aQueueDeliversEverythingInOrder()
    {
        constexpr int kItems = 50'000;
        core::rt::SpscQueue<int, 64> queue;
        std::thread writer([&] {
            for (int k = 0; k < kItems;) {
                if (queue.tryPush(k))
                    ++k;
                else
                    std::this_thread::yield();
            }
        });
        int wrong = 0;
        for (int expected = 0; expected < kItems;) {
            int value = -1;
            if (queue.tryPop(value))
                wrong += value != expected++;
            else
                std::this_thread::yield();
        }
        writer.join();
        QCOMPARE(wrong, 0);
    }

    void aTripleBufferIsNeverTornNorOlderThanBefore()
    {
        // All words of a published value are the same number, which reveals a torn read.
        using Value = std::array<std::uint64_t, 32>;
        constexpr std::uint64_t kRounds = 50'000;
        core::rt::TripleBuffer<Value> buffer;
        std::thread writer([&] {
            for (std::uint64_t k = 1; k <= kRounds; ++k) {
                buffer.back().fill(k);
                buffer.publish();
            }
        });
        int torn = 0;
        int older = 0;
        for (std::uint64_t last = 0; last < kRounds;) {
            const Value& seen = buffer.latest();
            for (const std::uint64_t word : seen)
                torn += word != seen.front();
            older += seen.front() < last;
            last = seen.front();
        }
        writer.join();
        QCOMPARE(torn, 0);
        QCOMPARE(older, 0);
    }
};

QTEST_GUILESS_MAIN(TestRtChannels)
#include "tst_rt_channels.moc"
