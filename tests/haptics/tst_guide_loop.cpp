// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated Falcon guides a hand along a path. Tests the strength and steadiness of the force, and its release.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "haptics/GuideLoop.h"
#include "haptics/simulated/SimulatedFalcon.h"
#include "tests/support/Allocations.h"
#include "tests/support/Rig.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using namespace std::chrono_literals;
using core::contact::PathGuide;
using haptics::GuideAim;
using haptics::GuideLinks;
using haptics::GuideLoop;
using haptics::GuideState;

namespace {

constexpr double kTickS = 0.001;
constexpr int kTicksAnAim = 10;

/// Motion of a typical student: round, up and down, at 20 to 40 mm/s.
glm::dvec3 path(double t)
{
    const double w = 2.0 * std::numbers::pi;
    return {2.5 * std::sin(w * 1.1 * t), 2.0 * std::sin(w * 0.9 * t + 0.5), 1.0 + 0.6 * std::sin(w * 2.0 * t)};
}

/// A simulated Falcon, guided tick by tick, in a simulated hand without tremor.
struct Led
{
    Led(const haptics::HandFigures& hand, double delayMs, const glm::dvec3& from)
        : falcon(figures(delayMs), steady(hand), kTickS, 1, from), loop(falcon, links)
    {
        falcon.follow(from);
        aim(from);
        // The hand rests and resists the guidance.
        tick(from, 20);
    }
    static haptics::FalconFigures figures(double delayMs)
    {
        haptics::FalconFigures made;
        made.delayS = 0.001 * delayMs;
        made.delayJitterS = 0.0;
        return made;
    }
    static haptics::HandFigures steady(haptics::HandFigures hand)
    {
        hand.tremorMm = 0.0;
        hand.driftMm = 0.0;
        return hand;
    }

    void aim(const glm::dvec3& place) { links.aim.publish({++number, place}); }
    /// @param wants  the position that the hand aims at
    void tick(const glm::dvec3& wants, int ticks = 1)
    {
        for (int n = 0; n < ticks; ++n) {
            falcon.follow(wants);
            const glm::dvec3 before = falcon.tipMm();
            loop.tick(1ms);
            const GuideState& now = links.state.latest();
            mostN = std::max(mostN, glm::length(now.forceN));
            jumpN = std::max(jumpN, glm::length(now.forceN - state.forceN));
            fastestMmPerS = std::max(fastestMmPerS, glm::length(falcon.tipMm() - before) / kTickS);
            state = now;
        }
    }
    /// The hand follows the guidance.
    void goAlong(int ticks, const std::function<glm::dvec3(double)>& where)
    {
        for (int n = 0; n < ticks; ++n) {
            if (beat++ % kTicksAnAim == 0)
                aim(where(kTickS * beat));
            tick(falcon.tipMm());
        }
    }

    GuideLinks links;
    haptics::SimulatedFalcon falcon;
    GuideLoop loop;
    GuideState state;
    std::uint64_t number = 0;
    int beat = 0;
    double mostN = 0.0;
    double jumpN = 0.0;
    double fastestMmPerS = 0.0;
};

}  // namespace

class TestGuideLoop : public QObject
{
    Q_OBJECT
private slots:
    void leadsAnyHandAlongThePath_data() { handsAndDelays(); }

    void leadsAnyHandAlongThePath()
    {
        QFETCH(int, hand);
        QFETCH(double, delayMs);
        Led led(haptics::kHands.at(static_cast<std::size_t>(hand)), delayMs, {14.0, -9.0, 9.0});
        led.links.wanted = true;
        led.goAlong(50, path);
        QVERIFY(led.state.leading);
        QVERIFY2(led.mostN < 0.4, qPrintable(QString("comes up softly: %1 N after 50 ms").arg(led.mostN)));
        led.goAlong(1950, path);
        double farthest = 0.0;
        for (int n = 0; n < 2000; ++n) {
            led.goAlong(1, path);
            farthest = std::max(farthest, glm::length(led.falcon.tipMm() - path(kTickS * led.beat)));
        }
        QVERIFY(led.state.leading);
        QVERIFY2(led.mostN <= PathGuide::kMostN + 1.0e-9, qPrintable(QString("%1 N").arg(led.mostN)));
        QVERIFY2(led.jumpN < 0.2, qPrintable(QString("%1 N a tick").arg(led.jumpN)));
        QVERIFY2(led.fastestMmPerS < 100.0, qPrintable(QString("%1 mm/s").arg(led.fastestMmPerS)));
        QVERIFY2(farthest < 1.5, qPrintable(QString("%1 mm behind").arg(farthest)));
    }

    void isStillWhereThePathIs_data() { handsAndDelays(); }

    void isStillWhereThePathIs()
    {
        QFETCH(int, hand);
        QFETCH(double, delayMs);
        const glm::dvec3 place(1.0, -1.0, 2.0);
        Led led(haptics::kHands.at(static_cast<std::size_t>(hand)), delayMs, {5.0, -1.0, 2.0});
        led.links.wanted = true;
        const auto held = [&](double) { return place; };
        led.goAlong(1500, held);
        led.falcon.push({0.0, 80.0, -40.0});  // an impact
        led.goAlong(500, held);
        glm::dvec3 least(1.0e9);
        glm::dvec3 most(-1.0e9);
        glm::dvec3 meanN(0.0);
        double rippleN = 0.0;
        constexpr int kTicks = 1000;
        std::vector<glm::dvec3> forces;
        for (int n = 0; n < kTicks; ++n) {
            led.goAlong(1, held);
            least = glm::min(least, led.falcon.tipMm());
            most = glm::max(most, led.falcon.tipMm());
            meanN += led.state.forceN / static_cast<double>(kTicks);
            forces.push_back(led.state.forceN);
        }
        for (const glm::dvec3& force : forces)
            rippleN = std::max(rippleN, glm::length(force - meanN));
        QVERIFY(led.state.leading);
        QVERIFY2(glm::length(most - least) < 0.1, qPrintable(QString("swings %1 mm").arg(glm::length(most - least))));
        QVERIFY2(rippleN < 0.1, qPrintable(QString("ripple %1 N").arg(rippleN)));
        QVERIFY2(glm::length(led.falcon.tipMm() - place) < 1.0,
                 qPrintable(QString("rests %1 mm beside").arg(glm::length(led.falcon.tipMm() - place))));
    }

    void aHandThatGoesAheadIsNotHeldBack_data() { handsAndDelays(); }

    void aHandThatGoesAheadIsNotHeldBack()
    {
        QFETCH(int, hand);
        QFETCH(double, delayMs);
        const glm::dvec3 from(10.0, -6.0, 9.0);
        Led led(haptics::kHands.at(static_cast<std::size_t>(hand)), delayMs, from);
        const glm::dvec3 place = path(0.0);
        led.aim(place);
        led.links.wanted = true;
        // The hand arrives after 0.15 s. Guidance alone would take half a second.
        for (int n = 0; n < 1000; ++n) {
            led.tick(glm::mix(from, place, std::min(1.0, n / 150.0)));
            QVERIFY2(led.state.leading, qPrintable(QString("let go after %1 ms").arg(n)));
        }
        QVERIFY2(led.jumpN < 0.2, qPrintable(QString("%1 N a tick").arg(led.jumpN)));
        QVERIFY(glm::length(led.falcon.tipMm() - place) < 1.0);
    }

    void letsGoOfAHandThatPushes_data() { handsAndDelays(); }

    void letsGoOfAHandThatPushes()
    {
        QFETCH(int, hand);
        QFETCH(double, delayMs);
        const haptics::HandFigures& figures = haptics::kHands.at(static_cast<std::size_t>(hand));
        Led led(figures, delayMs, {3.0, 0.0, 2.0});
        led.links.wanted = true;
        led.goAlong(1500, path);
        QVERIFY(led.state.leading);
        // The hand aims at a place some 4 mm away, far enough that its own spring still pulls with 3 N against the
        // strongest guidance. It moves there in 0.2 s.
        const glm::dvec3 from = led.falcon.tipMm();
        const glm::dvec3 way(0.0, 4.0 + 3000.0 / figures.stiffnessNPerM, 0.0);
        int pressed = -1;
        int freed = -1;
        for (int n = 0; n < 1000 && freed < 0; ++n) {
            led.tick(from + way * std::min(1.0, n / 200.0));
            if (pressed < 0 && glm::length(led.state.forceN) >= PathGuide::kPushN)
                pressed = n;
            if (!led.state.leading)
                freed = n;
        }
        QVERIFY(pressed >= 0);
        QVERIFY2(freed > pressed && freed <= pressed + 150, qPrintable(QString("%1 to %2 ms").arg(pressed).arg(freed)));
        QVERIFY(led.state.wasPushed);
        QVERIFY(led.mostN <= PathGuide::kMostN + 1.0e-9);
        led.tick(from + way, 250);
        QCOMPARE(led.state.forceN, glm::dvec3(0.0));
        QVERIFY2(led.jumpN < 0.2, qPrintable(QString("%1 N a tick").arg(led.jumpN)));
        // The hand stays free until guidance is requested again.
        led.goAlong(500, path);
        QCOMPARE(led.state.forceN, glm::dvec3(0.0));
        led.links.wanted = false;
        led.goAlong(2, path);
        led.links.wanted = true;
        led.goAlong(2500, path);
        QVERIFY(led.state.leading);
        QVERIFY(glm::length(led.falcon.tipMm() - path(kTickS * led.beat)) < 1.5);
    }

    /// A device that exchanges with the hardware in its own thread receives its force at the end of the tick.
    void theForceIsGivenInTheSameTick()
    {
        class Asynchronous final : public haptics::HapticDevice
        {
        public:
            haptics::DeviceSample exchange(const glm::dvec3& /*forceOnHandN*/) noexcept override
            {
                return {glm::vec3(2.0F, 0.0F, 0.0F)};
            }
            void give(const glm::dvec3& forceOnHandN) noexcept override { givenN = forceOnHandN; }
            glm::dvec3 givenN{0.0};
        };
        Asynchronous device;
        GuideLinks links;
        GuideLoop loop(device, links);
        links.aim.publish({1, glm::dvec3(0.0)});
        links.wanted = true;
        for (int n = 0; n < 2000; ++n)
            loop.tick(1ms);
        QVERIFY(glm::length(device.givenN) > 0.1);
        QCOMPARE(device.givenN, links.state.latest().forceN);
        loop.end();
        QCOMPARE(device.givenN, glm::dvec3(0.0));
    }

    /// Moving in circles around a held place gives the hand no energy, at any speed.
    void makesNoEnergy()
    {
        for (const double hertz : {0.5, 2.0, 5.0, 10.0}) {
            support::HeldDevice device;
            device.tipMm = {0.5F, 0.0F, 0.0F};
            GuideLinks links;
            GuideLoop loop(device, links);
            links.aim.publish({1, glm::dvec3(0.0)});
            links.wanted = true;
            double doneJ = 0.0;
            const auto ticksALoop = static_cast<int>(std::lround(1000.0 / hertz));
            for (int n = 0; n < 1000 + 4 * ticksALoop; ++n) {
                const double angle = 2.0 * std::numbers::pi * n / ticksALoop;
                const glm::dvec3 before(device.tipMm);
                const glm::dvec3 forceN = device.forceN;
                device.tipMm = glm::vec3(0.5 * std::cos(angle), 0.8 * std::sin(angle), 0.3 * std::sin(2.0 * angle));
                if (n >= 1000)  // the guidance has reached full strength
                    doneJ += 0.001 * glm::dot(forceN, glm::dvec3(device.tipMm) - before);
                loop.tick(1ms);
            }
            QVERIFY(links.state.latest().leading);
            QVERIFY2(doneJ < 1.0e-6,
                     qPrintable(QString("%1 Hz: %2 uJ given to the hand").arg(hertz).arg(1.0e6 * doneJ)));
        }
    }

    void aLostDeviceIsLetGoAtOnce()
    {
        support::HeldDevice device;
        GuideLinks links;
        GuideLoop loop(device, links);
        links.aim.publish({1, glm::dvec3(2.0, 0.0, 5.0)});
        links.wanted = true;
        const auto run = [&](int ticks) {
            for (int n = 0; n < ticks; ++n)
                loop.tick(1ms);
            return glm::length(links.state.latest().forceN);
        };
        QVERIFY(run(500) > 0.5 || !links.state.latest().leading);
        links.wanted = false;
        run(300);
        links.wanted = true;
        QVERIFY(run(80) > 0.1);
        device.present = false;
        QVERIFY(run(9) > 0.1);
        QCOMPARE(run(1), 0.0);
        QVERIFY(!links.state.latest().leading && !links.state.latest().present);
        device.present = true;
        QCOMPARE(run(200), 0.0);  // guidance was not requested again
        // An aim that the device cannot represent counts as no aim.
        links.wanted = false;
        run(1);
        links.wanted = true;
        QVERIFY(run(80) > 0.1);
        device.tipMm.x = std::nanf("");
        QCOMPARE(run(10), 0.0);
        loop.end();
        QCOMPARE(device.forceN, glm::dvec3(0.0));
    }

    void nothingIsForcedUnasked()
    {
        support::HeldDevice device;
        GuideLinks links;
        GuideLoop loop(device, links);
        links.wanted = true;  // there is no aim yet
        for (int n = 0; n < 50; ++n)
            loop.tick(1ms);
        QCOMPARE(device.forceN, glm::dvec3(0.0));
        links.wanted = false;
        links.aim.publish({1, glm::dvec3(3.0)});
        for (int n = 0; n < 500; ++n)
            loop.tick(1ms);
        QCOMPARE(device.forceN, glm::dvec3(0.0));
        QVERIFY(links.state.latest().present);
    }

    void neverAllocates()
    {
        Led led(haptics::kHands[1], 1.0, {3.0, 0.0, 2.0});
        led.links.wanted = true;
        const long before = support::allocationsOnThisThread();
        for (int n = 0; n < 2000; ++n) {
            if (n % kTicksAnAim == 0)
                led.aim(path(kTickS * n));
            led.loop.tick(1ms);
        }
        QCOMPARE(support::allocationsOnThisThread() - before, 0L);
    }

private:
    static void handsAndDelays()
    {
        support::columns<int, double>("hand", "delayMs");
        for (int hand = 0; hand < static_cast<int>(haptics::kHands.size()); ++hand)
            for (const double delayMs : {0.0, 1.0, 2.0, 4.0})
                QTest::addRow("hand %d, %g ms", hand, delayMs) << hand << delayMs;
    }
};

CUSP_TEST(TestGuideLoop)
#include "tst_guide_loop.moc"
