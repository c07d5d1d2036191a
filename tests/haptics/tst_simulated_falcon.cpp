// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "haptics/falcon/Kinematics.h"
#include "haptics/simulated/SimulatedFalcon.h"
#include "tests/support/Allocations.h"
#include "tests/support/Locks.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

using haptics::FalconFigures;
using haptics::HandFigures;
using haptics::SimulatedFalcon;

namespace {

constexpr double kPeriodS = 0.001;
constexpr double kStiffestTried = 20.0;  ///< N/mm
constexpr HandFigures kNoHand{"none", 0.0, 0.0, 0.0, 0.0, 0.0};

/// Returns a device with mass only: no friction, no lag, no delay.
FalconFigures bare()
{
    FalconFigures figures;
    figures.viscousNSPerM = 0.0;
    figures.coulombN = 0.0;
    figures.motorLagS = 0.0;
    figures.delayS = 0.0;
    figures.delayJitterS = 0.0;
    return figures;
}

HandFigures steady(HandFigures hand)
{
    hand.tremorMm = 0.0;
    hand.driftMm = 0.0;
    return hand;
}

void run(SimulatedFalcon& falcon, int ticks, const glm::dvec3& forceN = glm::dvec3(0.0))
{
    for (int n = 0; n < ticks; ++n)
        falcon.exchange(forceN);
}

/// Returns whether one axis of a hand that leans on a wall with 2 N comes to rest after meeting it at 50 mm/s from 2 mm
/// away (docs/facts/haptics.md, section 2.2: less than 0.15 mm from peak to peak in the last 0.5 s of 2 s). Its motors
/// have no lag.
bool comesToRest(double stiffnessNPerMm, double dampingNSPerM, double coulombN, const HandFigures& hand, double delayS)
{
    FalconFigures figures = bare();
    figures.viscousNSPerM = 0.8;
    figures.coulombN = coulombN;
    figures.delayS = delayS;
    SimulatedFalcon falcon(figures, steady(hand), kPeriodS, 1, {0.0, 0.0, 2.0});
    falcon.follow({0.0, 0.0, -2000.0 / hand.stiffnessNPerM});
    falcon.push({0.0, 0.0, -50.0});
    double low = 1.0e9;
    double high = -1.0e9;
    double before = 2.0;
    double speed = 0.0;  // mm/s, through two poles at 150 Hz
    double halfway = 0.0;
    const double share = 1.0 - std::exp(-2.0 * std::numbers::pi * 150.0 * kPeriodS);
    glm::dvec3 wall(0.0);
    for (int tick = 0; tick < 2000; ++tick) {
        const double z = falcon.exchange(wall).tipInToothMm.z;
        halfway += ((z - std::exchange(before, z)) / kPeriodS - halfway) * share;
        speed += (halfway - speed) * share;
        wall.z = z < 0.0 ? std::max(0.0, -stiffnessNPerMm * z - 0.001 * dampingNSPerM * speed) : 0.0;
        if (tick >= 1500) {
            low = std::min(low, falcon.tipMm().z);
            high = std::max(high, falcon.tipMm().z);
        }
    }
    return high - low < 0.15;
}

}  // namespace

class TestSimulatedFalcon : public QObject
{
    Q_OBJECT
private slots:
    void coastingGripOnlyLosesEnergy()
    {
        SimulatedFalcon falcon({}, kNoHand, kPeriodS, 1, glm::dvec3(0.0));
        falcon.push({60.0, -40.0, 80.0});
        double before = 1.0e9;
        for (int tick = 0; tick < 500; ++tick) {
            const glm::dvec3 from = falcon.tipMm();
            run(falcon, 1);
            const double speed = glm::length(falcon.tipMm() - from) / kPeriodS;
            QVERIFY(speed < before || speed == 0.0);
            before = speed;
        }
        QCOMPARE(before, 0.0);
    }

    /// v = v0 exp(-b t / m), so the distance is m v0 / b (1 - exp(-b t / m)).
    void viscousFrictionBrakesExponentially()
    {
        FalconFigures figures = bare();
        figures.viscousNSPerM = 0.8;
        SimulatedFalcon falcon(figures, kNoHand, kPeriodS, 1, glm::dvec3(0.0));
        falcon.push({100.0, 0.0, 0.0});
        run(falcon, 200);
        const double rate = figures.viscousNSPerM / figures.massKg;
        const double way = 100.0 / rate * (1.0 - std::exp(-rate * 0.2));
        QVERIFY2(std::abs(falcon.tipMm().x / way - 1.0) < 1.0e-3, qPrintable(QString::number(falcon.tipMm().x)));
    }

    /// The distance to the stop is v0^2 m / (2 fc). Then a force below fc has no effect, and a larger one moves the
    /// grip with the remainder.
    void dryFrictionBrakesEvenlyAndHolds()
    {
        FalconFigures figures = bare();
        figures.coulombN = 0.25;
        SimulatedFalcon falcon(figures, kNoHand, kPeriodS, 1, glm::dvec3(0.0));
        falcon.push({0.0, 50.0, 0.0});
        run(falcon, 100);
        const double way = 0.5 * 50.0 * 50.0 * figures.massKg / figures.coulombN / 1000.0;
        QVERIFY2(std::abs(falcon.tipMm().y / way - 1.0) < 1.0e-3, qPrintable(QString::number(falcon.tipMm().y)));
        const glm::dvec3 rest = falcon.tipMm();
        run(falcon, 500, {0.17, 0.0, 0.18});
        QCOMPARE(falcon.tipMm(), rest);
        run(falcon, 100, {0.0, 0.0, 0.35});
        const double pulled = 0.5 * (0.35 - 0.25) / figures.massKg * 0.1 * 0.1 * 1000.0;
        QVERIFY2(std::abs((falcon.tipMm().z - rest.z) / pulled - 1.0) < 2.0e-3, qPrintable(QString::number(pulled)));
    }

    void handGivesWayByItsStiffness_data()
    {
        support::columns<int, double>("hand", "rateHz");
        for (int hand = 0; hand < 3; ++hand)
            for (const double rateHz : {250.0, 1000.0, 4000.0})
                QTest::addRow("%s, %g Hz", haptics::kHands[static_cast<std::size_t>(hand)].name.data(), rateHz)
                    << hand << rateHz;
    }

    void handGivesWayByItsStiffness()
    {
        QFETCH(int, hand);
        QFETCH(double, rateHz);
        const HandFigures figures = steady(haptics::kHands[static_cast<std::size_t>(hand)]);
        FalconFigures slippery;
        slippery.coulombN = 0.0;
        SimulatedFalcon falcon(slippery, figures, 1.0 / rateHz, 1, glm::dvec3(0.0));
        run(falcon, static_cast<int>(5.0 * rateHz), {0.6, 0.0, -0.8});
        const glm::dvec3 given = glm::dvec3(0.6, 0.0, -0.8) * 1000.0 / figures.stiffnessNPerM;
        QVERIFY2(glm::length(falcon.tipMm() - given) < 1.0e-4 * glm::length(given),
                 qPrintable(QString::number(falcon.tipMm().z)));
    }

    void forceComesAfterTheDelay_data() { support::rows<double>("delayMs", {0.0, 0.5, 1.0, 2.2, 4.0, 20.0}); }

    /// From then on the distance is 1/2 F / m t^2, which shows when the force began.
    void forceComesAfterTheDelay()
    {
        QFETCH(double, delayMs);
        FalconFigures figures = bare();
        figures.delayS = delayMs * 0.001;
        SimulatedFalcon falcon(figures, kNoHand, kPeriodS, 1, glm::dvec3(0.0));
        constexpr int kTicks = 50;
        run(falcon, kTicks, {0.0, 0.0, 1.0});
        const double acting = std::sqrt(2.0 * figures.massKg * falcon.tipMm().z * 0.001);
        QVERIFY2(std::abs(kTicks * kPeriodS - acting - figures.delayS) < 0.02e-3, qPrintable(QString::number(acting)));
    }

    void jitterStaysWithinItsBounds()
    {
        FalconFigures figures = bare();
        figures.delayS = 0.001;
        figures.delayJitterS = 0.003;  // longer than a period, so that forces must queue
        double least = 1.0;
        double most = 0.0;
        for (std::uint64_t seed = 1; seed <= 300; ++seed) {
            SimulatedFalcon falcon(figures, kNoHand, kPeriodS, seed, glm::dvec3(0.0));
            run(falcon, 1, {0.0, 0.0, 1.0});
            run(falcon, 19, {0.0, 0.0, 1.0});
            const double began = 0.020 - std::sqrt(2.0 * figures.massKg * falcon.tipMm().z * 0.001);
            least = std::min(least, began);
            most = std::max(most, began);
        }
        QVERIFY2(least > 0.00098 && least < 0.0012, qPrintable(QString::number(least)));
        QVERIFY2(most < 0.00402 && most > 0.0030, qPrintable(QString::number(most)));
    }

    /// With a first-order lag the motion trails that of the unlagged force: in the end the speed is F / m (t - lag).
    void motorsLag()
    {
        FalconFigures figures = bare();
        figures.motorLagS = 0.001;
        SimulatedFalcon falcon(figures, kNoHand, kPeriodS, 1, glm::dvec3(0.0));
        run(falcon, 20, {1.0, 0.0, 0.0});
        const double from = falcon.tipMm().x;
        run(falcon, 1, {1.0, 0.0, 0.0});
        const double speed = (falcon.tipMm().x - from) / kPeriodS;  // in the middle of the tick
        QVERIFY2(std::abs(speed / (1000.0 / figures.massKg * (0.0205 - 0.001)) - 1.0) < 2.0e-3,
                 qPrintable(QString::number(speed)));
    }

    void forceLimitKeepsTheDirection()
    {
        SimulatedFalcon falcon(bare(), kNoHand, kPeriodS, 1, glm::dvec3(0.0));
        const glm::dvec3 asked(20.0, -30.0, 60.0);
        run(falcon, 20, asked);
        const double newtons = 2.0 * glm::length(falcon.tipMm()) * 0.001 * FalconFigures{}.massKg / (0.02 * 0.02);
        QVERIFY2(std::abs(newtons - 8.9) < 0.02, qPrintable(QString::number(newtons)));
        QVERIFY(glm::length(glm::normalize(falcon.tipMm()) - glm::normalize(asked)) < 1.0e-9);
    }

    /// Every reading is a multiple of the counts of all three arms, as close to the true position as those allow.
    void positionIsReadInCounts()
    {
        SimulatedFalcon falcon(bare(), steady(haptics::kHands[1]), kPeriodS, 1, glm::dvec3(0.0));
        double sum = 0.0;
        double most = 0.0;
        constexpr int kTicks = 4000;
        for (int tick = 0; tick < kTicks; ++tick) {
            const double t = tick * kPeriodS;
            falcon.follow({4.0 * std::sin(3.0 * t), 3.0 * std::sin(5.0 * t), 3.0 * std::sin(7.0 * t)});
            const glm::dvec3 read(falcon.exchange(glm::dvec3(0.0)).tipInToothMm);
            const glm::dvec3 angle = haptics::falcon::armsAt(haptics::falcon::deviceFromTooth(read))->angleRad;
            QVERIFY(glm::length(angle - haptics::falcon::roundedToCounts(angle)) < 1.0e-7);  // float millimetres
            const double error = glm::length(read - falcon.tipMm());
            sum += error * error;
            most = std::max(most, error);
        }
        const double rmsUm = 1000.0 * std::sqrt(sum / kTicks / 3.0);
        QVERIFY2(rmsUm > 8.0 && rmsUm < 16.0, qPrintable(QString::number(rmsUm)));  // an axis; docs/facts/haptics.md, 5
        QVERIFY2(most < 0.06, qPrintable(QString::number(most)));
    }

    /// With a free, stiff hand the grip follows the tremor.
    void handTremblesAsAsked()
    {
        HandFigures hand{"stiff", 0.0, 200.0, 100000.0, 0.04, 0.0};
        const auto rms = [&] {
            SimulatedFalcon falcon(bare(), hand, kPeriodS, 7, glm::dvec3(0.0));
            run(falcon, 1000);
            constexpr int kTicks = 60000;
            glm::dvec3 sum(0.0);
            for (int tick = 0; tick < kTicks; ++tick) {
                run(falcon, 1);
                sum += falcon.tipMm() * falcon.tipMm();
            }
            return glm::sqrt(sum / static_cast<double>(kTicks));
        };
        const glm::dvec3 tremor = rms();
        QVERIFY2(std::abs(tremor.x / 0.04 - 1.0) < 0.05, qPrintable(QString::number(tremor.x)));
        QVERIFY2(std::abs(tremor.y / 0.04 - 1.0) < 0.05, qPrintable(QString::number(tremor.y)));
        QVERIFY2(tremor.z < 1.0e-6, qPrintable(QString::number(tremor.z)));
        hand.tremorMm = 0.0;
        hand.driftMm = 0.075;
        const glm::dvec3 drift = rms();
        for (const int axis : {0, 1, 2})
            QVERIFY2(std::abs(drift[axis] / 0.075 - 1.0) < 0.1, qPrintable(QString::number(drift[axis])));
    }

    void sameSeedSameBits()
    {
        const auto pathOf = [](std::uint64_t seed) {
            SimulatedFalcon falcon({}, haptics::kHands[1], kPeriodS, seed, {0.0, 0.0, 1.0});
            std::vector<glm::vec3> path;
            for (int tick = 0; tick < 2000; ++tick) {
                falcon.follow({0.0, 0.0, -0.004 * tick});
                const double depth = path.empty() ? 0.0 : std::max(0.0, -static_cast<double>(path.back().z));
                path.push_back(falcon.exchange({0.0, 0.0, 1.0 * depth}).tipInToothMm);
            }
            return path;
        };
        QVERIFY(pathOf(3) == pathOf(3));
        QVERIFY(pathOf(3) != pathOf(4));
    }

    void stopsEndTheWorkArea()
    {
        SimulatedFalcon falcon({}, steady(haptics::kHands[2]), kPeriodS, 1, glm::dvec3(0.0));
        falcon.follow({0.0, 90.0, 120.0});
        run(falcon, 2000);
        QVERIFY(std::abs(glm::length(falcon.tipMm()) - haptics::falcon::kReachMm) < 1.0e-6);
        const glm::vec3 read = falcon.exchange(glm::dvec3(0.0)).tipInToothMm;
        QVERIFY2(glm::length(glm::dvec3(read) - falcon.tipMm()) < 0.1, qPrintable(QString::number(read.z)));
        falcon.follow(glm::dvec3(0.0));
        run(falcon, 2000);
        QVERIFY2(glm::length(falcon.tipMm()) < 0.5, qPrintable(QString::number(glm::length(falcon.tipMm()))));
    }

    void exchangeNeitherAllocatesNorLocks()
    {
        if (support::kSanitized)
            QSKIP("sanitizers bring their own allocator and locks");
        FalconFigures figures;
        figures.delayJitterS = 0.005;
        SimulatedFalcon falcon(figures, haptics::kHands[1], kPeriodS, 1, glm::dvec3(0.0));
        const long allocations = support::allocationsOnThisThread();
        const long locks = support::locksOnThisThread();
        for (int tick = 0; tick < 2000; ++tick) {
            falcon.follow({0.002 * tick, 0.0, -0.001 * tick});
            falcon.exchange({0.0, 0.001 * tick, 1.0});
        }
        QCOMPARE(support::allocationsOnThisThread() - allocations, 0L);
        QCOMPARE(support::locksOnThisThread() - locks, 0L);
    }

    /// The limits are within 15 % of the table in docs/facts/haptics.md, section 2.2, which an independent simulation
    /// found.
    void stiffestWallsAreThoseOfTheTable_data()
    {
        support::columns<double, int, double, double, double>("coulombN", "hand", "dampingNSPerM", "delayMs", "nPerMm");
        const auto row = [](double coulombN, int hand, double damping, const std::array<double, 4>& limits) {
            const std::array<double, 4> delays{0.0, 1.0, 2.0, 4.0};
            for (std::size_t n = 0; n < delays.size(); ++n)
                QTest::addRow("%g N, %s, %g N s/m, %g ms", coulombN,
                              haptics::kHands[static_cast<std::size_t>(hand)].name.data(), damping, delays[n])
                    << coulombN << hand << damping << delays[n] << limits[n];
        };
        row(0.0, 1, 0.0, {5.090, 1.460, 0.834, 0.426});
        row(0.0, 1, 5.0, {14.371, 4.827, 2.861, 1.548});
        row(0.25, 0, 0.0, {15.099, 2.986, 1.479, 0.684});
        row(0.25, 0, 5.0, {kStiffestTried, 6.855, 3.711, 1.864});
        row(0.25, 1, 0.0, {kStiffestTried, 6.460, 3.306, 1.595});
        row(0.25, 2, 0.0, {kStiffestTried, 12.610, 6.660, 3.332});
        row(0.5, 1, 0.0, {kStiffestTried, 13.123, 6.207, 2.727});
    }

    void stiffestWallsAreThoseOfTheTable()
    {
        QFETCH(double, coulombN);
        QFETCH(int, hand);
        QFETCH(double, dampingNSPerM);
        QFETCH(double, delayMs);
        QFETCH(double, nPerMm);
        const auto holdsAt = [&](double stiffness) {
            return comesToRest(stiffness, dampingNSPerM, coulombN, haptics::kHands[static_cast<std::size_t>(hand)],
                               delayMs * 0.001);
        };
        QVERIFY(holdsAt(0.85 * nPerMm));
        if (nPerMm < kStiffestTried)
            QVERIFY(!holdsAt(1.15 * nPerMm));
    }
};

CUSP_TEST(TestSimulatedFalcon)
#include "tst_simulated_falcon.moc"
