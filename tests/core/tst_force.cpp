// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/contact/BurVibration.h"
#include "core/contact/ForceLaw.h"
#include "core/contact/PaceMeter.h"
#include "core/contact/WorkArea.h"
#include "core/session/ServoTick.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"

using namespace core;
using namespace std::chrono_literals;

namespace {

constexpr double kTickS = 0.001;
const glm::dvec3 kSurface{0.0, 0.0, 0.0};

double length(const glm::dvec3& v)
{
    return std::sqrt(glm::dot(v, v));
}

/// Where a device with encoders tells that it is.
double counted(double mm)
{
    return 0.05 * std::round(mm / 0.05);
}

/// A hand that goes evenly as it is pulled, `mmPerSPerN`, from `at`, for `ticks`; the largest jump of the force.
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
    void settingsHaveLimits_data()
    {
        support::columns<double, double, double, bool>("fastDamping", "workArea", "vibration", "sound");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("as shipped") << 30.0 << 0.0 << 0.0 << true;
        QTest::newRow("Falcon") << 30.0 << 40.0 << 0.05 << true;
        QTest::newRow("damper too strong") << 101.0 << 0.0 << 0.0 << false;
        QTest::newRow("damper that drives") << -1.0 << 0.0 << 0.0 << false;
        QTest::newRow("work area smaller than the way home") << 30.0 << 9.0 << 0.0 << false;
        QTest::newRow("work area that is no number") << 30.0 << nan << 0.0 << false;
        QTest::newRow("vibration too strong") << 30.0 << 40.0 << 0.3 << false;
        QTest::newRow("vibration that is no number") << 30.0 << 40.0 << nan << false;
    }

    void settingsHaveLimits()
    {
        QFETCH(double, fastDamping);
        QFETCH(double, workArea);
        QFETCH(double, vibration);
        QFETCH(bool, sound);
        contact::ForceSettings settings;
        settings.fastDampingNSPerM = fastDamping;
        settings.workAreaMm = workArea;
        settings.vibrationN = vibration;
        QCOMPARE(contact::check(settings).has_value(), sound);
    }

    void restingHandFeelsTheSpringAlone()
    {
        contact::ForceLaw law({});
        glm::dvec3 force(0.0);
        for (int n = 0; n < 400; ++n)
            force = law.update({0.0, 0.0, -1.0}, kSurface, kTickS);
        QCOMPARE(force, glm::dvec3(0.0, 0.0, contact::ForceSettings{}.stiffnessNPerMm));
    }

    void fastHandIsDampedMoreThanASlowOne()
    {
        // What is pushed back with beyond the spring, a mm/s: from 1 mm above the tooth to 1 mm inside.
        const auto damping = [](double mmPerS) {
            contact::ForceSettings settings;
            settings.slewNPerS = 1.0e6;
            settings.clampN = 20.0;
            settings.brakeN = 0.0;
            contact::ForceLaw law(settings);
            glm::dvec3 force(0.0);
            double z = 1.0;
            for (int n = 0; n < 300; ++n)
                force = law.update({0.0, 0.0, z}, {0.0, 0.0, z}, kTickS);
            for (; z > -1.0; z -= mmPerS * kTickS)
                force = law.update({0.0, 0.0, z}, {0.0, 0.0, std::max(0.0, z)}, kTickS);
            const double depth = -(z + mmPerS * kTickS);
            return 1000.0 * (force.z - settings.stiffnessNPerMm * depth) / mmPerS;
        };
        const double slow = damping(3.0);
        const double fast = damping(300.0);
        QVERIFY2(slow > 2.9 && slow < 4.0, qPrintable(QString::number(slow)));
        QVERIFY2(fast > 28.0 && fast < 34.0, qPrintable(QString::number(fast)));
    }

    void stiffSpringIsDampedStraightIn()
    {
        // Of 7.5 N/mm, 0.4 mm inside: what a hand of 100 mm/s is pushed back with beyond spring and friction, N.
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
        // Three times as stiff as 2.5 N/mm: twice 30 N s/m more, and a third of it on the pace that is known late.
        const double in = beyond({0.0, 0.0, -100.0});
        QVERIFY2(in > 6.0 && in < 7.5, qPrintable(QString::number(in)));
        const double along = beyond({100.0, 0.0, 0.0});
        QVERIFY2(std::abs(along) < 1.0e-6, qPrintable(QString::number(along)));
        // What leaves is not held back: the damper takes from the spring, and no more than there is.
        const double out = beyond({0.0, 0.0, 40.0});
        QVERIFY2(out < 0.0 && out >= -3.0, qPrintable(QString::number(out)));
    }

    void groundThatVanishesIsFeltOverMilliseconds()
    {
        // haptics.md section 4, scene 8: pressed on with 2 N, then the support is gone in a tick.
        contact::ForceLaw law({});
        const glm::dvec3 hand(0.0, 0.0, -1.0);
        glm::dvec3 force(0.0);
        for (int n = 0; n < 400; ++n)
            force = law.update(hand, kSurface, kTickS);
        int ticks = 0;
        for (; length(force) > 0.02 && ticks < 100; ++ticks) {
            const glm::dvec3 now = law.update(hand, hand, kTickS);
            QVERIFY2(length(now - force) < 0.4, qPrintable(QString::number(length(now - force))));
            force = now;
        }
        QVERIFY2(ticks >= 5 && ticks <= 20, qPrintable(QString::number(ticks)));
        QCOMPARE(law.update(hand, hand, kTickS), glm::dvec3(0.0));
    }

    void anAnchorThatSlipsIsNoMotionToBeDamped()
    {
        // A bur that slips up a step under a hand that does not move: no kick beyond what the spring turns by.
        contact::ForceLaw law({});
        const glm::dvec3 hand(0.0, 0.0, -0.5);
        glm::dvec3 force(0.0);
        for (int n = 0; n < 400; ++n)
            force = law.update(hand, {-0.22, 0.0, 0.0}, kTickS);
        for (double x = -0.22; x < 0.0; x += 0.08) {
            const glm::dvec3 now = law.update(hand, {x, 0.0, 0.05}, kTickS);
            QVERIFY2(length(now - force) < 0.3, qPrintable(QString::number(length(now - force))));
            force = now;
        }
    }

    void armsAreWeakerSideways()
    {
        contact::ForceSettings settings;
        settings.lateralGain = 0.5;
        contact::ForceLaw law(settings);
        glm::dvec3 force(0.0);
        for (int n = 0; n < 400; ++n)
            force = law.update({-0.6, 0.0, -0.8}, kSurface, kTickS);
        QCOMPARE(force, settings.stiffnessNPerMm * glm::dvec3(0.3, 0.0, 0.8));
    }

    void unequalGainsMakeEnergyOnASlope()
    {
        // Rounds into a plane of 45 degrees and out of it, without friction or damping: what the hand gets for each,
        // mJ.
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
        QVERIFY2(given(1.0, 1.0) < 0.001, qPrintable(QString::number(given(1.0, 1.0))));
        QVERIFY2(given(0.5, 0.5) < 0.001, qPrintable(QString::number(given(0.5, 0.5))));
        QVERIFY2(given(0.5, 1.0) > 0.05, qPrintable(QString::number(given(0.5, 1.0))));
    }

    void anAnchorThatHangsForATickIsNoWall()
    {
        // Brushed at 120 mm/s over ground with an edge on which the anchor hangs for a tick: no click.
        contact::ForceLaw law({});
        glm::dvec3 force(0.0);
        for (int n = 0; n < 200; ++n) {
            const double x = 0.12 * n;
            const double hangs = n == 150 ? 0.12 : 0.02;
            const glm::dvec3 now = law.update({x, 0.0, -0.25}, {x - hangs, 0.0, 0.0}, kTickS);
            if (n > 100)
                QVERIFY2(length(now - force) < 0.4, qPrintable(QString("%1: %2 N").arg(n).arg(length(now - force))));
            force = now;
        }
    }

    void airAfterALossDoesNotEndTheRamp()
    {
        contact::ForceLaw law({});
        const glm::dvec3 hand(0.0, 0.0, -1.0);
        for (int n = 0; n < 400; ++n)
            law.update(hand, kSurface, kTickS);
        law.drop();
        law.update({0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, kTickS);  // a tick in the air
        glm::dvec3 force(0.0);
        for (int n = 0; n < 50; ++n) {
            force = law.update(hand, kSurface, kTickS);
            QVERIFY2(length(force) < 0.6, qPrintable(QString::number(length(force))));
        }
        for (int n = 0; n < 200; ++n)
            force = law.update(hand, kSurface, kTickS);
        QVERIFY(length(force) > 1.99);
    }

    void paceOfCountsIsSteady()
    {
        // 5 mm/s in counts of 0.05 mm: a backward difference says 0 or 50, and is 45 off.
        contact::PaceMeter meter;
        meter.restart(glm::dvec3(0.0));
        for (int n = 0; n < 400; ++n) {
            meter.add({counted(0.005 * n), 0.0, 0.0}, kTickS);
            if (n > 40)
                QVERIFY2(std::abs(meter.mmPerS().x - 5.0) < 6.0, qPrintable(QString::number(meter.mmPerS().x)));
        }
        // At rest on the edge of a count.
        for (int n = 0; n < 400; ++n) {
            meter.add({2.0 + 0.05 * (n % 2), 0.0, 0.0}, kTickS);
            if (n > 40)
                QVERIFY2(std::abs(meter.mmPerS().x) < 4.0, qPrintable(QString::number(meter.mmPerS().x)));
        }
    }

    void paceOfAFastHandIsKnownAtOnce()
    {
        contact::PaceMeter meter;
        meter.restart(glm::dvec3(0.0));
        for (int n = 1; n <= 5; ++n)
            meter.add({0.0, 0.0, counted(-0.3 * n)}, kTickS);
        QVERIFY2(std::abs(meter.mmPerS().z + 300.0) < 30.0, qPrintable(QString::number(meter.mmPerS().z)));
    }

    void provenPaceIsKnownSooner()
    {
        // A swing of 0.15 mm with 20 Hz, as a stiff wall makes it: by how much is either pace late?
        constexpr double kRadPerS = 2.0 * 3.14159265358979 * 20.0;
        contact::PaceMeter meter;
        meter.restart(glm::dvec3(0.0));
        glm::dvec2 late(0.0);  // in phase with the pace and a quarter behind
        glm::dvec2 proven(0.0);
        for (int n = 1; n <= 1000; ++n) {
            const double turn = kRadPerS * kTickS * n;
            meter.add({0.0, 0.0, counted(0.15 * std::sin(turn))}, kTickS);
            late += meter.mmPerS().z * glm::dvec2(std::cos(turn), std::sin(turn));
            proven += meter.provenMmPerS(kTickS).z * glm::dvec2(std::cos(turn), std::sin(turn));
        }
        const auto lateMs = [](const glm::dvec2& pace) { return 1000.0 * std::atan2(pace.y, pace.x) / kRadPerS; };
        QVERIFY2(lateMs(late) > 4.0, qPrintable(QString::number(lateMs(late))));
        QVERIFY2(lateMs(proven) < 2.0, qPrintable(QString::number(lateMs(proven))));
    }

    void restAndCreepProveNoPace()
    {
        // On the edge of a count of one arm, and at 5 mm/s: a backward difference says 45 mm/s.
        contact::PaceMeter meter;
        meter.restart(glm::dvec3(0.0));
        for (int n = 0; n < 100; ++n) {
            meter.add({0.045 * (n % 2), 0.0, 0.045 * std::floor(0.005 * n / 0.045)}, kTickS);
            QVERIFY2(length(meter.provenMmPerS(kTickS)) < 1.0e-9, qPrintable(QString::number(n)));
        }
    }

    void wallGrowsBeyondTheWorkArea()
    {
        contact::WorkArea area(40.0);
        // A device that comes back beyond it is not thrown.
        QVERIFY(length(area.update({0.0, 45.0, 0.0}, kTickS)) < 0.05);
        for (int n = 0; n < 300; ++n)
            QCOMPARE(area.update({0.0, 39.9, 0.0}, kTickS), glm::dvec3(0.0));
        QVERIFY(length(area.update({0.0, 42.0, 0.0}, kTickS)) <= 1.0);  // even a reading that leaps is no blow
        const glm::dvec3 force = area.update({0.0, 42.0, 0.0}, kTickS);
        QVERIFY2(std::abs(force.y + 2.0 * contact::WorkArea::kWallNPerMm) < 0.02, qPrintable(QString::number(force.y)));
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
        // From beside the tooth, below its surface: up first.
        contact::WorkArea area(40.0);
        LedHand hand{{39.0, 0.0, -8.0}};
        hand.follow(area, 1);
        QVERIFY(!area.isLeading());
        hand.at = {39.3, 0.0, -8.0};
        hand.follow(area, 1);
        QVERIFY(area.isLeading());
        for (int n = 0; n < 3000 && area.isLeading(); ++n) {
            hand.follow(area, 1);
            QVERIFY2(hand.at.z > 0.0 || hand.at.x > 20.0, qPrintable(QString("%1 %2").arg(hand.at.x).arg(hand.at.z)));
        }
        QVERIFY(!area.isLeading());
        hand.follow(area, 400);
        QCOMPARE(hand.forceN, glm::dvec3(0.0));
        QVERIFY2(length(hand.at - glm::dvec3(0.0, 0.0, contact::WorkArea::kHomeMm)) < 6.0,
                 qPrintable(QString("%1 %2").arg(hand.at.x).arg(hand.at.z)));
        QVERIFY2(hand.mostN < 2.0, qPrintable(QString::number(hand.mostN)));
        QVERIFY2(hand.jumpN < 0.2, qPrintable(QString::number(hand.jumpN)));
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
        QVERIFY2(hand.mostN < 2.0, qPrintable(QString::number(hand.mostN)));
        QVERIFY2(hand.jumpN < 0.2, qPrintable(QString::number(hand.jumpN)));
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
            QVERIFY2(mostN > 1.0 && mostN < 2.0, qPrintable(QStringLiteral("%1 mm/s: %2 N").arg(mmPerS).arg(mostN)));
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

    void vibrationHasNoMean_data()
    {
        QTest::addColumn<int>("ticksIn50Ms");
        for (const int ticks : {13, 25, 50, 200})  // 250 Hz, nearly, to 4 kHz
            QTest::addRow("%d ticks", ticks) << ticks;
    }

    void vibrationHasNoMean()
    {
        QFETCH(int, ticksIn50Ms);
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
                const double mean = length(window) / ticksIn50Ms;
                // Of four numbers, whatever the rate: a window of few ticks averages them over fewer.
                QVERIFY2(mean < 0.3 / std::min(ticksIn50Ms, 50), qPrintable(QString::number(mean)));
                window = glm::dvec3(0.0);
            }
        }
        const double rms = std::sqrt(square / kTicks);
        QVERIFY2(rms > 0.04 && rms < 0.06, qPrintable(QString::number(rms)));
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
        session::ServoSettings settings;
        settings.force.vibrationN = 0.05;
        const auto servo = session::makeServoTick(settings).value();
        support::Block made;
        contact::LiveTooth tooth{terrain::Tooth(support::makeBlock(made))};
        servo->swapTooth(&tooth, true);
        servo->setDrill(true);
        const double top = tooth.clearanceAt({0.0, 0.0});
        const glm::vec3 above(0.0F, 0.0F, static_cast<float>(top) + 0.001F);
        double square = 0.0;
        for (int n = 0; n < 1000; ++n) {
            servo->step(&above, 1ms);
            QVERIFY(!servo->state().touching && !servo->state().cutting);
            square += glm::dot(servo->state().forceN, servo->state().forceN);
        }
        QVERIFY(std::sqrt(square / 1000.0) > 0.03);
        for (const double mm3 : servo->state().removedMm3)
            QCOMPARE(mm3, 0.0);
        servo->setDrill(false);
        for (int n = 0; n < 60; ++n)
            servo->step(&above, 1ms);
        QCOMPARE(servo->state().forceN, glm::dvec3(0.0));
    }
};

QTEST_APPLESS_MAIN(TestForce)
#include "tst_force.moc"
