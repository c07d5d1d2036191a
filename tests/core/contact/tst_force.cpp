// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/contact/BurVibration.h"
#include "core/contact/ForceLaw.h"
#include "core/contact/VelocityEstimator.h"
#include "core/contact/WorkArea.h"
#include "core/servo/ServoState.h"
#include "tests/support/Checks.h"
#include "tests/support/Rig.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"

using namespace core;
using support::between;

namespace {

constexpr double kTickS = 0.001;
const glm::dvec3 kSurface{0.0, 0.0, 0.0};

double length(const glm::dvec3& v)
{
    return std::sqrt(glm::dot(v, v));
}

/// Returns the force after the hand has rested at a position for some ticks.
glm::dvec3 rested(contact::ForceLaw& law, const glm::dvec3& hand, const glm::dvec3& anchor = kSurface, int ticks = 400)
{
    glm::dvec3 force(0.0);
    for (int n = 0; n < ticks; ++n)
        force = law.update(hand, anchor, kTickS);
    return force;
}

/// Returns a position as the encoders of a device report it.
double counted(double mm)
{
    return 0.05 * std::round(mm / 0.05);
}

/// A hand that moves at `mmPerSPerN` times the force, beginning at `at`. Records the largest force and the largest jump
/// of the force.
struct LedHand
{
    glm::dvec3 at;
    double mmPerSPerN = 100.0;
    double mostN = 0.0;
    double jumpN = 0.0;
    glm::dvec3 forceN{0.0};

    void follow(contact::WorkArea& area, int ticks)
    {
        for (int n = 0; n < ticks; ++n) {
            at += forceN * (mmPerSPerN * kTickS);
            const glm::dvec3 now = area.update(at, kTickS);
            jumpN = std::max(jumpN, length(now - forceN));
            mostN = std::max(mostN, length(now));
            forceN = now;
        }
    }
};

}  // namespace

class TestForce : public QObject
{
    Q_OBJECT
private slots:
    void settingsHaveLimits()
    {
        const auto isSound = [](double fastDamping, double workArea, double vibration) {
            contact::ForceSettings settings;
            settings.fastDampingNSPerM = fastDamping;
            settings.workAreaMm = workArea;
            settings.vibrationN = vibration;
            return contact::check(settings).has_value();
        };
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(isSound(30.0, 0.0, 0.0));    // the default settings
        QVERIFY(isSound(30.0, 40.0, 0.05));  // Falcon
        QVERIFY(!isSound(101.0, 0.0, 0.0));
        QVERIFY(!isSound(-1.0, 0.0, 0.0));  // negative damping, which adds energy
        QVERIFY(!isSound(30.0, 9.0, 0.0));  // less than the way home
        QVERIFY(!isSound(30.0, nan, 0.0));
        QVERIFY(!isSound(30.0, 40.0, 0.3));
        QVERIFY(!isSound(30.0, 40.0, nan));
    }

    void restingHandFeelsTheSpringAlone()
    {
        contact::ForceLaw law({});
        QCOMPARE(rested(law, {0.0, 0.0, -1.0}), glm::dvec3(0.0, 0.0, contact::ForceSettings{}.stiffnessNPerMm));
    }

    void fastHandIsDampedMoreThanASlowOne()
    {
        // Returns the damping force per speed, N s/m: the hand moves from 1 mm above the tooth to 1 mm inside.
        const auto damping = [](double mmPerS) {
            contact::ForceSettings settings;
            settings.slewNPerS = 1.0e6;
            settings.clampN = 20.0;
            settings.brakeN = 0.0;
            contact::ForceLaw law(settings);
            double z = 1.0;
            glm::dvec3 force = rested(law, {0.0, 0.0, z}, {0.0, 0.0, z}, 300);
            for (; z > -1.0; z -= mmPerS * kTickS)
                force = law.update({0.0, 0.0, z}, {0.0, 0.0, std::max(0.0, z)}, kTickS);
            const double depth = -(z + mmPerS * kTickS);
            return 1000.0 * (force.z - settings.stiffnessNPerMm * depth) / mmPerS;
        };
        QVERIFY(between(damping(3.0), 2.9, 4.0));
        QVERIFY(between(damping(300.0), 28.0, 34.0));
    }

    void stiffSpringIsDampedStraightIn()
    {
        // Returns the force beyond spring and friction, N, on a hand that moves at 100 mm/s and is 0.4 mm inside a
        // surface of 7.5 N/mm.
        const auto beyond = [](const glm::dvec3& mmPerS) {
            contact::ForceSettings settings;
            settings.stiffnessNPerMm = 7.5;
            settings.dampingNSPerM = 0.0;
            settings.brakeN = 0.0;
            settings.friction = 0.0;
            settings.clampN = 20.0;
            contact::ForceLaw law(settings);
            glm::dvec3 force(0.0);
            for (int n = -100; n <= 0; ++n) {
                const glm::dvec3 at = glm::dvec3(0.0, 0.0, -0.4) + mmPerS * (kTickS * n);
                force = law.update(at, {at.x, at.y, std::max(0.0, at.z)}, kTickS);
            }
            return force.z - 7.5 * 0.4;
        };
        // The spring is three times as stiff as 2.5 N/mm. So the prompt damper has twice 30 N s/m, and a third of the
        // 30 N s/m of the slow damper remains: 70 N s/m together, or 7 N at 100 mm/s.
        QVERIFY(between(beyond({0.0, 0.0, -100.0}), 6.0, 7.5));
        QVERIFY(between(beyond({100.0, 0.0, 0.0}), -1.0e-6, 1.0e-6));
        // A hand that leaves is not held back: the damper reduces the spring's force, at most to zero.
        const double out = beyond({0.0, 0.0, 40.0});
        QVERIFY2(out < 0.0 && out >= -3.0, qPrintable(QString::number(out)));
    }

    void groundThatVanishesIsFeltOverMilliseconds()
    {
        // docs/facts/haptics.md, section 4, scene 8: the hand presses with 2 N, then the ground vanishes in one tick.
        contact::ForceLaw law({});
        const glm::dvec3 hand(0.0, 0.0, -1.0);
        glm::dvec3 force = rested(law, hand);
        int ticks = 0;
        for (; length(force) > 0.02 && ticks < 100; ++ticks) {
            const glm::dvec3 now = law.update(hand, hand, kTickS);
            QVERIFY(between(length(now - force), -1.0, 0.4));
            force = now;
        }
        QVERIFY(ticks >= 5 && ticks <= 20);
        QCOMPARE(law.update(hand, hand, kTickS), glm::dvec3(0.0));
    }

    void anAnchorThatSlipsIsNoMotionToBeDamped()
    {
        // The bur slips up a step while the hand does not move. The force must not jump by more than the rotation of
        // the spring.
        contact::ForceLaw law({});
        const glm::dvec3 hand(0.0, 0.0, -0.5);
        glm::dvec3 force = rested(law, hand, {-0.22, 0.0, 0.0});
        for (double x = -0.22; x < 0.0; x += 0.08) {
            const glm::dvec3 now = law.update(hand, {x, 0.0, 0.05}, kTickS);
            QVERIFY(between(length(now - force), -1.0, 0.3));
            force = now;
        }
    }

    void aSpringThatTurnsInAGrooveIsNoImpact()
    {
        // A hand 0.3 mm below the sides of a groove of 45 degrees moves from one side to the other at 50 mm/s: the
        // anchor comes down one side, rests on the ground and goes up the other. Measures how much the force changes
        // beyond the spring's own change.
        contact::ForceLaw law({});
        const glm::dvec3 sides[] = {glm::normalize(glm::dvec3(1.0, 0.0, 1.0)),
                                    glm::normalize(glm::dvec3(-1.0, 0.0, 1.0))};
        glm::dvec3 force(0.0);
        glm::dvec3 spring(0.0);
        double beyond = 0.0;
        for (int n = -300; n <= 40; ++n) {
            const double x = 0.05 * std::max(n, -40);
            const glm::dvec3 hand(x, 0.0, std::abs(x) - 0.3);
            const glm::dvec3& side = sides[x < 0.0 ? 0 : 1];
            glm::dvec3 anchor = hand - side * glm::dot(hand, side);
            if (anchor.x * x <= 0.0)
                anchor = glm::dvec3(0.0);
            const glm::dvec3 nowSpring = contact::ForceSettings{}.stiffnessNPerMm * (anchor - hand);
            const glm::dvec3 now = law.update(hand, anchor, kTickS);
            if (n > -40)
                beyond = std::max(beyond, length(now - force) - length(nowSpring - spring));
            force = now;
            spring = nowSpring;
        }
        QVERIFY2(beyond < 0.25, qPrintable(QString::number(beyond)));
    }

    void armsAreWeakerSideways()
    {
        contact::ForceSettings settings;
        settings.lateralGain = 0.5;
        contact::ForceLaw law(settings);
        QCOMPARE(rested(law, {-0.6, 0.0, -0.8}), settings.stiffnessNPerMm * glm::dvec3(0.3, 0.0, 0.8));
    }

    void unequalGainsMakeEnergyOnASlope()
    {
        // Moves in circles into and out of a plane of 45 degrees, without friction or damping. Returns the energy that
        // the hand gains each time.
        const auto given = [](double lateral, double vertical) {
            contact::ForceSettings settings;
            settings.lateralGain = lateral;
            settings.verticalGain = vertical;
            settings.friction = 0.0;
            settings.dampingNSPerM = 0.0;
            settings.fastDampingNSPerM = 0.0;
            settings.brakeN = 0.0;
            contact::ForceLaw law(settings);
            const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 0.0, 1.0));
            constexpr int kRound = 1000;
            glm::dvec3 force(0.0);
            glm::dvec3 before(0.0);
            double worstMj = -1.0e9;
            for (const double way : {1.0, -1.0}) {
                double mj = 0.0;
                for (int n = 0; n <= 2 * kRound; ++n) {
                    const double turn = way * 2.0 * std::numbers::pi * n / kRound;
                    const glm::dvec3 hand = 0.3 * glm::dvec3(std::cos(turn), 0.0, std::sin(turn));
                    if (n > kRound)
                        mj += glm::dot(force, hand - before);
                    force = law.update(hand, hand - normal * std::min(0.0, glm::dot(hand, normal)), kTickS);
                    before = hand;
                }
                worstMj = std::max(worstMj, mj);
            }
            return worstMj;
        };
        QVERIFY(between(given(1.0, 1.0), -1.0e9, 0.001));
        QVERIFY(between(given(0.5, 0.5), -1.0e9, 0.001));
        QVERIFY(between(given(0.5, 1.0), 0.05, 1.0e9));
    }

    void anAnchorThatHangsForATickIsNoWall()
    {
        // Brushes at 120 mm/s over ground with an edge on which the anchor sticks for one tick. The hand must feel no
        // click.
        contact::ForceLaw law({});
        glm::dvec3 force(0.0);
        for (int n = 0; n < 200; ++n) {
            const double x = 0.12 * n;
            const double hangs = n == 150 ? 0.12 : 0.02;
            const glm::dvec3 now = law.update({x, 0.0, -0.25}, {x - hangs, 0.0, 0.0}, kTickS);
            if (n > 100)
                QVERIFY(between(length(now - force), -1.0, 0.4));
            force = now;
        }
    }

    void airAfterALossDoesNotEndTheRamp()
    {
        contact::ForceLaw law({});
        const glm::dvec3 hand(0.0, 0.0, -1.0);
        rested(law, hand);
        law.drop();
        law.update({0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, kTickS);  // one tick in the air
        glm::dvec3 force(0.0);
        for (int n = 0; n < 50; ++n) {
            force = law.update(hand, kSurface, kTickS);
            QVERIFY(between(length(force), -1.0, 0.6));
        }
        QVERIFY(length(rested(law, hand, kSurface, 200)) > 1.99);
    }

    void paceOfCountsIsSteady()
    {
        // 5 mm/s in counts of 0.05 mm: a backward difference gives 0 or 50 mm/s, an error of up to 45.
        contact::VelocityEstimator meter;
        meter.restart(glm::dvec3(0.0));
        for (int n = 0; n < 400; ++n) {
            meter.add({counted(0.005 * n), 0.0, 0.0}, kTickS);
            if (n > 40)
                QVERIFY(between(meter.mmPerS().x, 5.0 - 6.0, 5.0 + 6.0));
        }
        // At rest on the boundary between two counts.
        for (int n = 0; n < 400; ++n) {
            meter.add({2.0 + 0.05 * (n % 2), 0.0, 0.0}, kTickS);
            if (n > 40)
                QVERIFY(between(meter.mmPerS().x, -4.0, 4.0));
        }
    }

    void paceOfAFastHandIsKnownAtOnce()
    {
        contact::VelocityEstimator meter;
        meter.restart(glm::dvec3(0.0));
        for (int n = 1; n <= 5; ++n)
            meter.add({0.0, 0.0, counted(-0.3 * n)}, kTickS);
        QVERIFY(between(meter.mmPerS().z, -330.0, -270.0));
    }

    void provenPaceIsKnownSooner()
    {
        // An oscillation of 0.15 mm at 20 Hz, as at a stiff wall. Measures the delay of both velocities.
        constexpr double kRadPerS = 2.0 * std::numbers::pi * 20.0;
        contact::VelocityEstimator meter;
        meter.restart(glm::dvec3(0.0));
        glm::dvec2 late(0.0);  // in phase with the velocity, and a quarter period behind
        glm::dvec2 proven(0.0);
        for (int n = 1; n <= 1000; ++n) {
            const double turn = kRadPerS * kTickS * n;
            meter.add({0.0, 0.0, counted(0.15 * std::sin(turn))}, kTickS);
            late += meter.mmPerS().z * glm::dvec2(std::cos(turn), std::sin(turn));
            proven += meter.provenMmPerS(kTickS).z * glm::dvec2(std::cos(turn), std::sin(turn));
        }
        const auto lateMs = [](const glm::dvec2& pace) { return 1000.0 * std::atan2(pace.y, pace.x) / kRadPerS; };
        QVERIFY(between(lateMs(late), 4.0, 1000.0));
        QVERIFY(between(lateMs(proven), -1000.0, 2.0));
    }

    void restAndCreepProveNoPace()
    {
        // One arm is on the boundary between two counts, and the device moves at 5 mm/s: a backward difference gives 45
        // mm/s.
        contact::VelocityEstimator meter;
        meter.restart(glm::dvec3(0.0));
        for (int n = 0; n < 100; ++n) {
            meter.add({0.045 * (n % 2), 0.0, 0.045 * std::floor(0.005 * n / 0.045)}, kTickS);
            QVERIFY(between(length(meter.provenMmPerS(kTickS)), -1.0, 1.0e-9));
        }
    }

    void wallGrowsBeyondTheWorkArea()
    {
        contact::WorkArea area(40.0);
        // The force is not sudden if the device is found beyond the boundary.
        QVERIFY(length(area.update({0.0, 45.0, 0.0}, kTickS)) < 0.05);
        for (int n = 0; n < 300; ++n)
            QCOMPARE(area.update({0.0, 39.9, 0.0}, kTickS), glm::dvec3(0.0));
        QVERIFY(length(area.update({0.0, 42.0, 0.0}, kTickS)) <= 1.0);  // even if a reading jumps
        const glm::dvec3 force = area.update({0.0, 42.0, 0.0}, kTickS);
        QVERIFY(support::near(force.y, -2.0 * contact::WorkArea::kWallNPerMm, 0.02));
        QVERIFY(length(area.update({0.0, 60.0, 0.0}, kTickS)) <= contact::WorkArea::kWallMostN + 0.1);
    }

    void mouseHasNoWall()
    {
        contact::WorkArea area(0.0);
        area.bringHome();
        for (const double mm : {0.0, 50.0, 500.0})
            QCOMPARE(area.update({mm, 0.0, 0.0}, kTickS), glm::dvec3(0.0));
        QVERIFY(!area.isLeading());
    }

    void handThatLeftIsLedHome()
    {
        // From a place beside the tooth and below its surface, the hand is led upwards first.
        contact::WorkArea area(40.0);
        LedHand hand{{39.0, 0.0, -8.0}};
        hand.follow(area, 1);
        QVERIFY(!area.isLeading());
        hand.at = {39.3, 0.0, -8.0};
        hand.follow(area, 1);
        QVERIFY(area.isLeading());
        for (int n = 0; n < 3000 && area.isLeading(); ++n) {
            hand.follow(area, 1);
            QVERIFY(hand.at.z > 0.0 || hand.at.x > 20.0);
        }
        QVERIFY(!area.isLeading());
        hand.follow(area, 400);
        QCOMPARE(hand.forceN, glm::dvec3(0.0));
        QVERIFY(between(length(hand.at - glm::dvec3(0.0, 0.0, contact::WorkArea::kHomeMm)), -1.0, 6.0));
        QVERIFY(between(hand.mostN, -1.0, 2.0));
        QVERIFY(between(hand.jumpN, -1.0, 0.2));
    }

    void handThatHoldsBackIsLetGo()
    {
        contact::WorkArea area(40.0);
        area.bringHome();
        LedHand hand{{20.0, 0.0, 5.0}, 0.0};
        hand.follow(area, 200);
        QVERIFY(area.isLeading());
        QVERIFY(hand.mostN > 0.9);
        hand.follow(area, 500);
        QVERIFY(!area.isLeading());
        QCOMPARE(hand.forceN, glm::dvec3(0.0));
        QVERIFY(between(hand.mostN, -1.0, 2.0));
        QVERIFY(between(hand.jumpN, -1.0, 0.2));
    }

    void handThatPullsAwayFeelsLessThanTwoNewtons()
    {
        for (const double mmPerS : {100.0, 200.0, 500.0}) {
            contact::WorkArea area(150.0);
            glm::dvec3 at(20.0, 0.0, 12.0);
            area.bringHome();
            for (int n = 0; n < 100; ++n)
                static_cast<void>(area.update(at, kTickS));
            double mostN = 0.0;
            for (int n = 0; n < 200; ++n) {
                at.x += mmPerS * kTickS;
                mostN = std::max(mostN, length(area.update(at, kTickS)));
            }
            QVERIFY(between(mostN, 1.0, 2.0));
        }
    }

    void centringEndsWithTheDevice()
    {
        contact::WorkArea area(40.0);
        area.bringHome();
        LedHand hand{{20.0, 0.0, 5.0}};
        hand.follow(area, 200);
        area.drop();
        QCOMPARE(area.update(hand.at, kTickS), glm::dvec3(0.0));
        QVERIFY(!area.isLeading());
    }

    void vibrationHasNoMean_data() { support::rows<int>("ticksIn50Ms", {13, 25, 50, 200}); }

    void vibrationHasNoMean()
    {
        QFETCH(int, ticksIn50Ms);  // about 250 Hz, to 4 kHz
        const double tickS = 0.05 / ticksIn50Ms;
        contact::BurVibration vibration(0.05);
        glm::dvec3 window(0.0);
        double square = 0.0;
        constexpr int kTicks = 20000;
        for (int n = 1; n <= kTicks; ++n) {
            const glm::dvec3 force = vibration.update(true, tickS);
            QCOMPARE(force.z, 0.0);
            window += force;
            square += glm::dot(force, force);
            if (n % ticksIn50Ms == 0) {
                // The sum is that of four numbers at any rate. A window of few ticks averages over fewer ticks.
                QVERIFY(between(length(window) / ticksIn50Ms, -1.0, 0.3 / std::min(ticksIn50Ms, 50)));
                window = glm::dvec3(0.0);
            }
        }
        QVERIFY(between(std::sqrt(square / kTicks), 0.04, 0.06));
    }

    void vibrationIsTheSameEveryTime()
    {
        contact::BurVibration one(0.05);
        contact::BurVibration two(0.05);
        for (int n = 0; n < 500; ++n)
            QCOMPARE(one.update(n > 20, kTickS), two.update(n > 20, kTickS));
    }

    void vibrationEndsWithTheBur()
    {
        contact::BurVibration vibration(0.05);
        for (int n = 0; n < 500; ++n)
            static_cast<void>(vibration.update(true, kTickS));
        for (int n = 0; n < 50; ++n)
            static_cast<void>(vibration.update(false, kTickS));
        for (int n = 0; n < 100; ++n)
            QCOMPARE(vibration.update(false, kTickS), glm::dvec3(0.0));
    }

    void vibrationNeitherCutsNorTouches()
    {
        core::servo::ServoSettings settings;
        settings.force.vibrationN = 0.05;
        const support::Bench bench(support::blockTooth({}), "2", settings);
        const glm::dvec3 above(0.0, 0.0, bench.tooth->clearanceAt({0.0, 0.0}) + 0.001);
        double square = 0.0;
        for (int n = 0; n < 1000; ++n) {
            const core::servo::ServoState& state = bench.step(above);
            QVERIFY(!state.touching && !state.cutting);
            square += glm::dot(state.forceN, state.forceN);
        }
        QVERIFY(std::sqrt(square / 1000.0) > 0.03);
        QCOMPARE(bench.state().removedMm3, terrain::PerMaterial{});
        bench.servo->setDrill(false);
        for (int n = 0; n < 60; ++n)
            bench.step(above);
        QCOMPARE(bench.state().forceN, glm::dvec3(0.0));
    }
};

CUSP_TEST(TestForce)
#include "tst_force.moc"
