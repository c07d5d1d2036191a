// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <QTest>

#include "core/servo/ServoState.h"
#include "tests/support/Suite.h"
#include "ui/tooth/PoseTrack.h"

using core::servo::Pose;
using core::servo::ServoState;
using ui::tooth::FrameClock;
using ui::tooth::poseAt;

namespace {

constexpr std::int64_t kMs = 1'000'000;

/// Returns the state of a bur that moves along x at `mmPerS`, read once per millisecond up to a time.
ServoState movingUntil(std::int64_t ns, double mmPerS)
{
    ServoState state;
    const auto count = static_cast<std::int64_t>(state.trail.size());
    const std::int64_t last = ns / kMs;
    for (std::int64_t tick = last - count + 1; tick <= last; ++tick) {
        if (tick <= 0)
            continue;
        const double x = mmPerS * 1.0e-3 * static_cast<double>(tick);
        state.trail[static_cast<std::size_t>(tick % count)] = {tick * kMs, {x, 1.0, 0.0}, {x, 0.0, 0.0}};
    }
    return state;
}

}  // namespace

class TestPoseTrack : public QObject
{
    Q_OBJECT

private slots:
    void liesBetweenTheReadingsAroundAMoment()
    {
        const ServoState state = movingUntil(200 * kMs, 40.0);
        const Pose pose = poseAt(state, 190 * kMs + kMs / 4);
        QCOMPARE(pose.takenNs, 190 * kMs + kMs / 4);
        QVERIFY(std::abs(pose.anchorMm.x - 40.0e-3 * 190.25) < 1.0e-9);
        QVERIFY(std::abs(pose.deviceMm.x - 40.0e-3 * 190.25) < 1.0e-9);
        QCOMPARE(pose.deviceMm.y, 1.0);
    }

    void staysWhereTheBurHasBeen()
    {
        const ServoState state = movingUntil(200 * kMs, 40.0);
        QCOMPARE(poseAt(state, 250 * kMs).takenNs, 200 * kMs);
        QVERIFY(std::abs(poseAt(state, 250 * kMs).anchorMm.x - 8.0) < 1.0e-9);
        QCOMPARE(poseAt(state, kMs).takenNs, 185 * kMs);  // the oldest of 16
    }

    void withoutATrailIsWhatTheStateHolds()
    {
        ServoState state;
        state.anchorMm = {1.0, 2.0, 3.0};
        state.deviceMm = {4.0, 5.0, 6.0};
        const Pose pose = poseAt(state, 77);
        QCOMPARE(pose.takenNs, std::int64_t{77});
        QVERIFY(pose.anchorMm == state.anchorMm && pose.deviceMm == state.deviceMm);
    }

    /// Frames at 60 Hz are painted up to 3 ms early or late. Without a correction, a bur at 30 mm/s would jitter by
    /// 0.07 mm from frame to frame.
    void evenMotionIsDrawnInEvenSteps()
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> early(-3.0, 3.0);
        FrameClock clock;
        std::vector<double> steps;
        std::vector<double> asPainted;
        double before = 0.0;
        double paintedBefore = 0.0;
        for (int frame = 1; frame <= 400; ++frame) {
            const auto painted = static_cast<std::int64_t>((frame * 1000.0 / 60.0 + 100.0 + early(random)) * kMs);
            const ServoState state = movingUntil(painted, 30.0);
            const double x = poseAt(state, clock.momentFor(painted)).anchorMm.x;
            const double newest = poseAt(state, painted).anchorMm.x;
            if (frame > 100) {
                steps.push_back(x - before);
                asPainted.push_back(newest - paintedBefore);
            }
            before = x;
            paintedBefore = newest;
        }
        const auto tremble = [](const std::vector<double>& way) {
            double sum = 0.0;
            for (const double step : way)
                sum += (step - 0.5) * (step - 0.5);
            return std::sqrt(sum / static_cast<double>(way.size()));
        };
        QVERIFY2(tremble(asPainted) > 0.06, qPrintable(QString::number(tremble(asPainted))));
        QVERIFY2(tremble(steps) < 0.25 * tremble(asPainted), qPrintable(QString::number(tremble(steps))));
    }

    void isNeverLateByMoreThanSixMs()
    {
        std::mt19937 random(3);
        std::uniform_int_distribution<int> beats(1, 5);
        FrameClock clock;
        std::int64_t painted = 1000 * kMs;
        std::int64_t moment = 0;
        for (int frame = 0; frame < 2000; ++frame) {
            painted += beats(random) * 7 * kMs;
            const std::int64_t next = clock.momentFor(painted);
            QVERIFY(next > moment);
            QVERIFY(next < painted);
            QVERIFY2(painted - next <= 6 * kMs, qPrintable(QString::number((painted - next) / kMs)));
            moment = next;
        }
    }

    void startsAnewAfterAPause()
    {
        FrameClock clock;
        static_cast<void>(clock.momentFor(1000 * kMs));
        QCOMPARE(clock.momentFor(5000 * kMs), 5000 * kMs - FrameClock::kBehindNs);
    }
};

CUSP_TEST(TestPoseTrack)
#include "tst_pose_track.moc"
