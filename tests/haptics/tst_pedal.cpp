// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <QTest>

#include "core/settings/PedalLearner.h"
#include "haptics/pedal/PedalShape.h"
#include "tests/support/Suite.h"

using core::settings::PedalLearner;
using core::settings::PedalSettings;
using haptics::PedalShape;

namespace {

constexpr double kBeatS = 0.004;

/// Holds a reading for this many seconds and returns the last speed.
int held(PedalShape& shape, double reading, double seconds)
{
    int percent = 0;
    for (double t = 0.0; t < seconds; t += kBeatS)
        percent = shape.update(reading, kBeatS);
    return percent;
}

}  // namespace

class TestPedal : public QObject
{
    Q_OBJECT
private slots:
    void travelBecomesSpeed_data()
    {
        QTest::addColumn<double>("rest");
        QTest::addColumn<double>("full");
        QTest::addColumn<bool>("isInverted");
        QTest::addColumn<double>("curve");
        QTest::addColumn<double>("reading");
        QTest::addColumn<int>("percent");
        QTest::newRow("released") << -1.0 << 1.0 << false << 1.0 << -1.0 << 0;
        QTest::newRow("in the dead zone") << -1.0 << 1.0 << false << 1.0 << -0.9 << 0;
        QTest::newRow("half") << -1.0 << 1.0 << false << 1.0 << 0.05 << 50;
        QTest::newRow("full") << -1.0 << 1.0 << false << 1.0 << 1.0 << 100;
        QTest::newRow("nearly full") << -1.0 << 1.0 << false << 1.0 << 0.96 << 100;
        QTest::newRow("beyond its end") << -0.5 << 0.5 << false << 1.0 << 1.0 << 100;
        QTest::newRow("runs downwards") << 1.0 << -1.0 << false << 1.0 << -1.0 << 100;
        QTest::newRow("half of an axis") << 0.0 << 1.0 << false << 1.0 << 0.525 << 50;
        QTest::newRow("curved") << -1.0 << 1.0 << false << 2.0 << 0.05 << 25;
    }
    void travelBecomesSpeed()
    {
        QFETCH(const double, rest);
        QFETCH(const double, full);
        QFETCH(const bool, isInverted);
        QFETCH(const double, curve);
        QFETCH(const double, reading);
        QFETCH(const int, percent);
        PedalSettings settings{rest, full, isInverted};
        settings.curve = curve;
        PedalShape shape(settings);
        QCOMPARE(held(shape, rest, 0.1), 0);
        QVERIFY(shape.hasRested());
        QCOMPARE(held(shape, reading, 0.1), percent);
        QCOMPARE(shape.update(rest, kBeatS), 0);
    }

    void anInvertedPedalRunsTheBurWhileItIsReleased()
    {
        PedalShape shape({-1.0, 1.0, true});
        QCOMPARE(held(shape, -1.0, 0.5), 0);  // not before it was seen pressed
        QCOMPARE(held(shape, 1.0, 0.1), 0);
        QCOMPARE(held(shape, -1.0, 0.1), 100);
    }

    void aPedalThatIsPressedAtTheStartDoesNothingUntilItWasReleased()
    {
        PedalShape shape(PedalSettings{});
        QCOMPARE(held(shape, 1.0, 10.0), 0);
        QCOMPARE(held(shape, 0.2, 10.0), 0);
        QVERIFY(!shape.hasRested());
        QCOMPARE(held(shape, -1.0, 0.01), 0);
        QVERIFY(shape.hasRested());
        QCOMPARE(held(shape, 1.0, 0.1), 100);
    }

    void noiseDoesNotStartTheBur()
    {
        std::mt19937 random(35);
        std::normal_distribution<double> noise(0.0, 0.04);
        std::uniform_int_distribution<int> seldom(0, 199);
        PedalShape shape(PedalSettings{});
        for (int k = 0; k < 100'000; ++k)
            QCOMPARE(shape.update(-1.0 + std::abs(noise(random)) + (seldom(random) == 0 ? 1.0 : 0.0), kBeatS), 0);
    }

    void noiseChangesTheSpeedSeldom()
    {
        std::mt19937 random(36);
        std::uniform_real_distribution<double> noise(-0.008, 0.008);
        PedalShape shape(PedalSettings{});
        held(shape, -1.0, 0.1);
        int percent = held(shape, 0.3, 0.1);
        int changes = 0;
        for (int k = 0; k < 10'000; ++k) {
            const int next = shape.update(0.3 + noise(random), kBeatS);
            changes += next == percent ? 0 : 1;
            percent = next;
        }
        QVERIFY2(changes <= 2, qPrintable(QString::number(changes)));
    }

    void theBurStopsAtOnce()
    {
        PedalShape shape(PedalSettings{});
        held(shape, -1.0, 0.1);
        QCOMPARE(held(shape, 1.0, 1.0), 100);
        QCOMPARE(shape.update(-1.0, kBeatS), 0);
    }

    void readingsThatAreNoNumbersStopTheBur_data()
    {
        QTest::addColumn<double>("reading");
        QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
        QTest::newRow("minus infinite") << -std::numeric_limits<double>::infinity();
    }
    void readingsThatAreNoNumbersStopTheBur()
    {
        QFETCH(const double, reading);
        PedalShape shape(PedalSettings{});
        QCOMPARE(held(shape, reading, 1.0), 0);
        QVERIFY(!shape.hasRested());
        held(shape, -1.0, 0.1);
        held(shape, 1.0, 0.1);
        QCOMPARE(shape.update(reading, kBeatS), 0);
    }

    void aPedalWithoutTravelDoesNothing()
    {
        PedalShape shape({0.2, 0.2});
        QCOMPARE(held(shape, 1.0, 1.0), 0);
        QCOMPARE(held(shape, -1.0, 1.0), 0);
    }

    void aPressTeachesAxisRestAndFullTravel_data()
    {
        QTest::addColumn<float>("rest");
        QTest::addColumn<float>("full");
        QTest::newRow("upwards") << -1.0F << 0.9F;
        QTest::newRow("downwards") << 0.8F << -0.7F;
        QTest::newRow("from the middle") << 0.0F << 1.0F;
    }
    void aPressTeachesAxisRestAndFullTravel()
    {
        QFETCH(const float, rest);
        QFETCH(const float, full);
        PedalLearner learner;
        std::optional<PedalLearner::Learnt> learnt;
        const auto hold = [&](float pedal, int beats) {
            for (int k = 0; k < beats && !learnt; ++k)
                learnt = learner.update(std::vector{k % 2 == 0 ? 0.05F : 0.0F, pedal}, 0.03);
        };
        hold(rest, 60);
        QCOMPARE(learner.movedAxis(), -1);
        hold(0.5F * (rest + full), 1);
        hold(full, 60);
        QVERIFY(!learnt);
        QCOMPARE(learner.movedAxis(), 1);
        hold(rest, 60);
        QVERIFY(learnt);
        QCOMPARE(learnt->axis, 1);
        QVERIFY(std::abs(learnt->restReading - static_cast<double>(rest)) < 1e-6);
        QVERIFY(std::abs(learnt->fullReading - static_cast<double>(full)) < 1e-6);
    }

    void noiseTeachesNothing()
    {
        std::mt19937 random(37);
        std::uniform_real_distribution<float> noise(-0.1F, 0.1F);
        PedalLearner learner;
        for (int k = 0; k < 1000; ++k)
            QVERIFY(!learner.update(std::vector{noise(random), std::numeric_limits<float>::quiet_NaN()}, 0.03));
    }
};

CUSP_TEST(TestPedal)
#include "tst_pedal.moc"
