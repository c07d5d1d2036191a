// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/base/Rng.h"
#include "haptics/simulated/TickTimes.h"
#include "tests/support/Suite.h"

class TestTickTimes : public QObject
{
    Q_OBJECT
private slots:
    void agreesWithSorting()
    {
        core::Rng rng(2);
        const auto times = std::make_unique<haptics::TickTimes>();
        std::vector<double> sorted;
        for (int n = 0; n < 20000; ++n) {
            sorted.push_back(std::exp(rng.uniform(-1.0, 6.0)));
            times->add(sorted.back());
        }
        std::sort(sorted.begin(), sorted.end());
        for (const double share : {0.01, 0.5, 0.99, 0.999}) {
            const double right = sorted[static_cast<std::size_t>(share * 20000.0)];
            QVERIFY2(std::abs(times->percentileUs(share) / right - 1.0) < 0.005,
                     qPrintable(QString("%1: %2, not %3").arg(share).arg(times->percentileUs(share)).arg(right)));
        }
        QCOMPARE(times->longestUs(), sorted.back());
    }

    void takesAnyTime()
    {
        const auto times = std::make_unique<haptics::TickTimes>();
        QCOMPARE(times->percentileUs(0.5), 0.0);
        for (const double us : {0.0, -1.0, 1.0e-9, 1.0e12})
            times->add(us);
        QVERIFY(times->percentileUs(0.5) <= 0.02);
        QCOMPARE(times->longestUs(), 1.0e12);
    }
};

CUSP_TEST(TestTickTimes)
#include "tst_tick_times.moc"
