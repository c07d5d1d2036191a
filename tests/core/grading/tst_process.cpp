// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/Rng.h"
#include "core/grading/Process.h"
#include "core/recording/Replay.h"
#include "core/servo/ServoState.h"
#include "core/session/LiveAssessor.h"
#include "core/session/SessionChannels.h"
#include "tests/support/Allocations.h"
#include "tests/support/Checks.h"
#include "tests/support/Rig.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using core::servo::ServoState;
using grading::Process;
using grading::ProcessMeter;
using support::near;
using namespace std::chrono_literals;
using support::kPi;

namespace {

ServoState whileCutting(glm::dvec3 at = {0.0, 0.0, 0.0}, double newtons = 1.0)
{
    ServoState state;
    state.deviceMm = state.anchorMm = at;
    state.forceN = {0.0, 0.0, newtons};
    state.touching = state.drillOn = state.cutting = true;
    return state;
}

ServoState touching(bool drillOn, double newtons = 1.0)
{
    ServoState state = whileCutting({0.0, 0.0, 0.0}, newtons);
    state.cutting = false;
    state.drillOn = drillOn;
    return state;
}

ServoState inAir(bool drillOn)
{
    ServoState state;
    state.drillOn = drillOn;
    return state;
}

void give(ProcessMeter& meter, const ServoState& state, int ticks, std::chrono::microseconds dt = 1ms)
{
    for (int n = 0; n < ticks; ++n)
        meter.take(state, dt);
}

}  // namespace

class TestProcess : public QObject
{
    Q_OBJECT

private slots:
    void nothingHappened()
    {
        const ProcessMeter empty(2.0);
        QCOMPARE(empty.process(), Process{});
        ProcessMeter meter(2.0);
        give(meter, inAir(false), 1000);
        const Process p = meter.process();
        QVERIFY(near(p.totalS, 1.0));
        QVERIFY(!p.firstCutS && !p.strokeMm && !p.strokeS && !p.force && !p.jerkMmPerS3);
        QCOMPARE(p.strokes, 0);
        QCOMPARE(p.liftOffs, 0);
        QCOMPARE(p.drillInAirS, 0.0);
    }

    void timesAreSumsOfTicks()
    {
        ProcessMeter meter(2.0);
        for (const auto& [state, ticks, dt] : {std::tuple(inAir(false), 1000, 1ms),
                                               {inAir(true), 500, 1ms},
                                               {touching(true), 20, 1ms},
                                               {whileCutting(), 300, 1ms},
                                               {touching(false), 40, 1ms},
                                               {inAir(true), 1000, 2ms},
                                               {whileCutting(), 100, 1ms},
                                               {touching(true), 400, 1ms},
                                               {whileCutting(), 100, 1ms}})
            give(meter, state, ticks, dt);
        const Process p = meter.process();
        QVERIFY(near(p.totalS, 1.0 + 0.5 + 0.02 + 0.3 + 0.04 + 2.0 + 0.1 + 0.4 + 0.1));
        QVERIFY(near(p.firstCutS.value(), 1.521));
        QVERIFY(near(p.cuttingS, 0.5));
        QCOMPARE(p.strokes, 3);
        QVERIFY(near(p.strokeS.value(), 0.5 / 3.0));
        QVERIFY(near(p.longestPauseS, 2.04));
        QVERIFY(near(p.drillInAirS, 2.5));
        QVERIFY(near(p.contactBurOffS, 0.04));
    }

    void strokesEndWithAPause()
    {
        ProcessMeter meter(2.0);
        for (int n = 0; n < 10; ++n) {
            give(meter, whileCutting(), 100);
            give(meter, touching(true), 149);
        }
        QCOMPARE(meter.process().strokes, 1);
        QVERIFY(near(meter.process().cuttingS, 10 * 0.1 + 9 * 0.149));
        give(meter, touching(true), 1);
        give(meter, whileCutting(), 1);
        QCOMPARE(meter.process().strokes, 2);
        QVERIFY(near(meter.process().longestPauseS, 0.15));
        // An undo in the middle of a stroke ends the stroke.
        meter.undone();
        give(meter, whileCutting(), 1);
        QCOMPARE(meter.process().strokes, 3);
        QCOMPARE(meter.process().undos, 1);
    }

    void strokesAreThoseOfUndo()
    {
        support::Rig rig;
        rig.drill(support::makeBlock({}));
        ProcessMeter meter(2.0);
        Rng rng(5);
        const auto step = [&](const glm::vec3& to) {
            rig.device.tipMm = to;
            rig.run(1);
            meter.take(rig.servo->state(), 1ms);
        };
        for (int touch = 0; touch < 12; ++touch) {
            const int pressed = 30 + rng.below(200);
            const int away = 20 + rng.below(300);
            const double x = -2.0 + 0.3 * touch;
            step({x, 0.0, 0.1});
            for (int n = 1; n < pressed + away; ++n)
                step({x, 0.0, n < pressed ? rig.servo->state().anchorMm.z - 0.6 : 1.0});
        }
        for (int n = 0; n < 400; ++n)
            step(rig.device.tipMm);
        rig.settle();
        const int strokes = rig.uiLinks->session.latest().strokes;
        QVERIFY(strokes > 3 && strokes < 12);
        QCOMPARE(meter.process().strokes, strokes);
    }

    void onlyABurThatHasCutLiftsOff()
    {
        ProcessMeter meter(2.0);
        give(meter, touching(true), 100);
        give(meter, inAir(true), 100);
        QCOMPARE(meter.process().liftOffs, 0);
        for (int n = 0; n < 3; ++n) {
            give(meter, whileCutting(), 20);
            give(meter, inAir(true), 49);  // a hop
            give(meter, whileCutting(), 20);
            give(meter, inAir(true), 200);
        }
        QCOMPARE(meter.process().liftOffs, 3);
        give(meter, touching(true), 50);
        give(meter, inAir(true), 200);
        QCOMPARE(meter.process().liftOffs, 3);
    }

    void pathOfACircle()
    {
        ProcessMeter meter(2.0);
        for (int n = 0; n <= 2000; ++n) {
            const double turn = 2.0 * kPi * n / 2000;
            meter.take(whileCutting({2.0 * std::cos(turn), 2.0 * std::sin(turn), 0.0}), 1ms);
        }
        // The path is measured in chords of 0.1 mm on a radius of 2 mm; less than one chord remains.
        QVERIFY(near(meter.process().pathMm, 4.0 * kPi, 0.11));
        QVERIFY(near(meter.process().cuttingPathMm, meter.process().pathMm, 0.11));
        QVERIFY(near(meter.process().strokeMm.value(), meter.process().cuttingPathMm));
    }

    void aTremblingCountIsNoPath()
    {
        ProcessMeter meter(2.0);
        Rng rng(1);
        for (int n = 0; n < 10'000; ++n)
            meter.take(whileCutting({0.05 * rng.below(2), 0.05 * rng.below(2), 0.0}), 1ms);
        QCOMPARE(meter.process().pathMm, 0.0);
    }

    void pathInStrokes()
    {
        // Moves 3 mm cutting, 3 mm through the air, and 2 mm cutting.
        ProcessMeter meter(2.0);
        const auto go = [&](double from, double to, bool cuts) {
            for (int n = 0; n <= 1000; ++n) {
                ServoState state = whileCutting({from + (to - from) * n / 1000, 0.0, 0.0});
                state.cutting = state.touching = cuts;
                meter.take(state, 1ms);
            }
        };
        go(0.0, 3.0, true);
        go(3.0, 6.0, false);
        go(6.0, 8.0, true);
        const Process p = meter.process();
        QCOMPARE(p.strokes, 2);
        QVERIFY(near(p.pathMm, 8.0, 0.1));
        QVERIFY(near(p.cuttingPathMm, 5.0, 0.2));
        QVERIFY(near(p.strokeMm.value(), 2.5, 0.1));
        QVERIFY(near(p.longestPauseS, 1.001));
    }

    void forceOverTime()
    {
        // 1 N for 5 s, 2 N for 3.6 s, 4 N for 0.4 s: the percentile is over time, not over ticks.
        for (const auto& [limitN, overS] : {std::pair(0.5, 9.0), {1.5, 4.0}, {9.0, 0.0}}) {
            ProcessMeter meter(limitN);
            give(meter, whileCutting({}, 1.0), 2500, 2ms);
            give(meter, inAir(true), 777);
            give(meter, touching(false, 2.0), 3600);
            give(meter, whileCutting({}, 4.0), 400);
            const Process p = meter.process();
            const double mean = (5.0 + 7.2 + 1.6) / 9.0;
            QVERIFY(near(p.force->meanN, mean));
            QVERIFY(near(p.force->sdN, std::sqrt((5.0 + 14.4 + 6.4) / 9.0 - mean * mean)));
            QVERIFY(near(p.force->largestN, 4.0));
            QVERIFY(near(p.force->p95N, 2.0, 0.02));  // one bin of the histogram
            QVERIFY(near(p.overLimitS, overS));
            give(meter, whileCutting({}, 4.0), 200);  // now more than 5 % of the time
            QVERIFY(near(meter.process().force->p95N, 4.0, 0.02));
        }
        // A force beyond the histogram.
        ProcessMeter strong(2.0);
        give(strong, whileCutting({}, 25.0), 100);
        QVERIFY(near(strong.process().force->largestN, 25.0));
        QVERIFY(near(strong.process().force->p95N, 25.0));
    }

    /// An oscillation of 1 mm, also as read in counts. The jerk is omega^3 A cos, and its root mean square omega^3 A /
    /// sqrt 2. A backward difference of counts of 0.05 mm at 1 kHz would give 10^7 mm/s3.
    void jerkOfASwing()
    {
        for (const auto& [hertz, countMm, share] :
             {std::tuple(1.0, 0.0, 0.03), {2.0, 0.0, 0.1}, {1.0, 0.05, 0.06}, {2.0, 0.05, 0.1}}) {
            ProcessMeter meter(2.0);
            const double omega = 2.0 * kPi * hertz;
            for (int n = 0; n < 20'000; ++n) {
                const double x = std::sin(omega * 0.001 * n);
                meter.take(whileCutting({countMm > 0.0 ? countMm * std::round(x / countMm) : x, 3.0, 0.0}), 1ms);
            }
            const double expected = omega * omega * omega / std::numbers::sqrt2;
            QVERIFY(near(meter.process().jerkMmPerS3.value(), expected, share * expected));
        }
    }

    void evenMotionHasNoJerk()
    {
        ProcessMeter meter(2.0);
        for (int n = 0; n < 5000; ++n)
            meter.take(whileCutting({0.005 * n, -0.002 * n, 0.0}), 1ms);
        QVERIFY(near(meter.process().jerkMmPerS3.value(), 0.0, 1.0e-4));
        // Movements while the drill is off do not count.
        ServoState away = inAir(false);
        away.deviceMm = {90.0, 0.0, 0.0};
        give(meter, away, 100);
        give(meter, whileCutting(), 1000);
        QVERIFY(near(meter.process().jerkMmPerS3.value(), 0.0, 1.0e-4));
    }

    void ticksThatTellNothingAreTimeAlone()
    {
        ProcessMeter meter(2.0);
        give(meter, whileCutting(), 100);
        ServoState lost = inAir(true);
        lost.health = core::servo::kDeviceLost;
        give(meter, lost, 1000);
        QVERIFY(near(meter.process().totalS, 1.1));
        QCOMPARE(meter.process().liftOffs, 0);
        QCOMPARE(meter.process().drillInAirS, 0.0);
        // Values that are not finite numbers.
        ProcessMeter odd(2.0);
        give(odd, whileCutting({}, std::nan("")), 100);
        give(odd, whileCutting({std::numeric_limits<double>::infinity(), 0.0, 0.0}), 100);
        QVERIFY(near(odd.process().totalS, 0.2));
        QVERIFY(!odd.process().force.has_value());
        QCOMPARE(odd.process().strokes, 0);
    }

    void takesNoMemory()
    {
        ProcessMeter meter(2.0);
        const long before = support::allocationsOnThisThread();
        for (int n = 0; n < 1000; ++n)
            meter.take(n % 400 < 200 ? whileCutting({0.01 * n, 0.0, 0.0}) : inAir(true), 1ms);
        (void)meter.process();
        QCOMPARE(support::allocationsOnThisThread() - before, 0L);
    }

    void aReplayGivesTheSameBits()
    {
        support::Rig rig;
        rig.drill(support::makeBlock({}));
        ProcessMeter live(1.0);
        live.take(rig.servo->state(), 1ms);  // open() has recorded one tick
        support::RestlessHand hand(11);
        for (int n = 0; n < 4000; ++n) {
            rig.device.tipMm = hand.next();
            rig.run(1);
            live.take(rig.servo->state(), 1ms);
        }
        rig.settle();
        const auto recording = rig.session->recordingSoFar();
        QVERIFY(recording.has_value());
        ProcessMeter replayed(1.0);
        const auto outcome =
            recording::replay(*recording, [&](const core::servo::ServoEvent& event, const recording::Replayer& servo) {
                if (recording::isStep(event))
                    replayed.take(servo.state(), 1ms);
            });
        QVERIFY(outcome.has_value());
        QVERIFY(live.process().strokes > 0);
        QVERIFY(live.process().force.has_value());
        QVERIFY(live.process() == replayed.process());
    }

    void timeAwayFromTheWorkIsNone()
    {
        support::Rig rig;
        const auto block = support::makeBlock({});
        rig.open(block);
        const auto wait = [&rig](std::uint64_t note, int ticks) {
            rig.settle();
            rig.send(session::AddNote{note});
            rig.settle();
            rig.device.tipMm = {5.0, 5.0, 5.0};
            rig.run(ticks);
            rig.settle();
            return std::chrono::duration<double>(rig.session->recordingSoFar()->duration()).count();
        };
        const double before = wait(core::servo::kWorkNote, 500);
        const double away = wait(core::servo::kRestNote, 2000) - before;
        QVERIFY(away >= 2.0);
        const double all = wait(core::servo::kWorkNote, 300);
        session::LiveAssessor examiner({}, block);
        QVERIFY(recording::replay(*rig.session->recordingSoFar(),
                                  [&](const core::servo::ServoEvent& event, const recording::Replayer& servo) {
                                      examiner.take(event, servo);
                                  }));
        QVERIFY(near(examiner.process().totalS, all - away, 0.1));
    }
};

CUSP_TEST(TestProcess)
#include "tst_process.moc"
