// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/cutting/BreakOff.h"
#include "core/recording/Replay.h"
#include "tests/support/Checks.h"
#include "tests/support/Rig.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"

using namespace core;
using support::between;

namespace {

constexpr double kDeepMm = 1.0;

/// Returns settings for a tooth that yields at once, so that the cut is where the path is.
/// @param on  whether thin fins break off
core::servo::ServoSettings yielding(bool on)
{
    core::servo::ServoSettings settings;
    settings.hardness.material.fill({settings::kMaxRateMm3PerNs, 0.0});
    settings.breakOff.on = on;
    return settings;
}

double sum(const terrain::PerMaterial& volumes)
{
    return volumes[0] + volumes[1] + volumes[2] + volumes[3];
}

/// A tooth with two trenches of a fissure bur, 1 mm deep and 2 mm long, and a fin between them.
struct TwoTrenches : support::Bench
{
    TwoTrenches(const support::Block& block, double finMm, const core::servo::ServoSettings& settings)
        : Bench(support::blockTooth(block), "57", settings)
    {
        const double y = core::bur::burs()[tooth->burIndex()].headRadiusMm + 0.5 * finMm;
        for (const double aside : {-y, y}) {
            step({-1.0, aside, 0.5});
            for (int tick = 0; tick < 300; ++tick)
                step({-1.0, aside, 0.2 - (kDeepMm + 0.25) * std::min(1.0, tick / 250.0)});
            for (int tick = 0; tick <= 500; ++tick)
                step({-1.0 + 0.004 * tick, aside, -kDeepMm - 0.05});
            step({1.0, aside, 0.5});
        }
    }
    /// Returns the height of the highest column on the middle line of the fin, away from its ends.
    [[nodiscard]] double finTopMm() const
    {
        double highest = -100.0;
        support::eachNode(tooth->grid(), [&](std::size_t k, const glm::dvec2& at) {
            if (std::abs(at.x) < 0.5 && std::abs(at.y) < 0.2)
                highest = std::max(highest, static_cast<double>(tooth->tooth().top[k]));
        });
        return highest;
    }
};

}  // namespace

class TestBreakOff : public QObject
{
    Q_OBJECT
private slots:
    void thinFinBreaksAndThickOneStays_data()
    {
        support::columns<int, double, bool>("side", "finMm", "breaks");
        for (const int side : {100, 150, 300}) {
            QTest::addRow("thin, grid %d", side) << side << 0.08 << true;
            QTest::addRow("thick, grid %d", side) << side << 0.4 << false;
        }
    }

    void thinFinBreaksAndThickOneStays()
    {
        QFETCH(int, side);
        QFETCH(double, finMm);
        QFETCH(bool, breaks);
        const TwoTrenches cut({.side = side, .cellMm = 10.5 / side}, finMm, yielding(true));
        QCOMPARE(sum(cut.state().brokenMm3) > 0.0, breaks);
        // What broke while the second trench was still shallow leaves a stump that is not too high for its width.
        if (breaks)
            QVERIFY(between(cut.finTopMm(), -100.0, -0.5 * kDeepMm));
        else
            QCOMPARE(cut.finTopMm(), 0.0);
    }

    void finAcrossTheLatticeBreaksToo()
    {
        // A fin that cuts leave at any angle consists of the columns whose middles are in a strip.
        for (const double degrees : {0.0, 20.0, 45.0, 70.0}) {
            const glm::dvec2 across(-std::sin(degrees * 0.017453292519943), std::cos(degrees * 0.017453292519943));
            contact::LiveTooth tooth{support::blockTooth({})};
            const terrain::Grid& grid = tooth.grid();
            core::cutting::CutRect changed{40, 40, 110, 110};
            for (int j = changed.j0; j <= changed.j1; ++j)
                for (int i = changed.i0; i <= changed.i1; ++i) {
                    const glm::dvec2 at = grid.nodeMm(i, j);
                    if (std::abs(at.x * across.x + at.y * across.y) > 0.05)
                        tooth.lower(i, j, -1.2F);
                }
            const terrain::PerMaterial broken = core::cutting::breakOff(tooth, 6.0, changed);
            int standing = 0;
            for (int j = 45; j <= 105; ++j)
                for (int i = 45; i <= 105; ++i)
                    standing += tooth.tooth().top[grid.index(i, j)] > -1.0F ? 1 : 0;
            QVERIFY(sum(broken) > 0.3);
            QCOMPARE(standing, 0);
        }
    }

    void whatBrokeIsTheFinAndIsCounted()
    {
        const TwoTrenches with({}, 0.08, yielding(true));
        const TwoTrenches without({}, 0.08, yielding(false));
        QCOMPARE(sum(without.state().brokenMm3), 0.0);
        QCOMPARE(without.finTopMm(), 0.0);
        // The removed volume is the change of the maps, and includes the broken volume.
        const double lost = sum(terrain::removedVolumes(with.tooth->tooth()));
        QVERIFY(between(sum(with.state().removedMm3) - lost, -1.0e-4, 1.0e-4));
        const double more = lost - sum(terrain::removedVolumes(without.tooth->tooth()));
        // The sliver before the bur's round front breaks as well. The bur would have cut it a little later.
        QVERIFY(more > 0.15);
        QVERIFY(between(sum(with.state().brokenMm3), 0.9 * more, 2.0 * more));
        // Columns that stay uncut without the rule also stay uncut with it, except in the fin.
        const std::vector<float>& top = with.tooth->tooth().top;
        support::eachNode(with.tooth->grid(), [&](std::size_t k, const glm::dvec2& at) {
            if (std::abs(at.y) > 0.1 && without.tooth->tooth().top[k] == 0.0F)
                QCOMPARE(top[k], 0.0F);
        });
    }

    void cuspDoesNotBreak()
    {
        // A cusp of 65 degrees between two trenches that cut its flanks away, 0.5 mm apart at its base.
        const TwoTrenches cut(
            {.topMm = [](double x, double y) { return std::max(-2.0, -2.1 * std::sqrt(x * x + y * y)); }}, 0.5,
            yielding(true));
        QVERIFY(sum(cut.state().removedMm3) > 0.02);
        QCOMPARE(sum(cut.state().brokenMm3), 0.0);
        QVERIFY(cut.finTopMm() > -0.15);
    }

    void replaysToTheSameBits()
    {
        core::servo::ServoSettings settings;
        settings.hardness.material.fill({30.0, 0.0});
        settings.handpieces = {settings::findHandpiece("electric").value()};
        settings.breakOff = {true, 5.0};
        support::Rig rig(settings);
        rig.drill(support::makeBlock({}));
        support::RestlessHand hand(3);
        rig.follow(hand, 6000);
        rig.lift();
        const auto stored = recording::Recording::fromBytes(rig.session->recordingSoFar().value().toBytes());
        QVERIFY(stored);
        QCOMPARE(stored->settings(), settings);
        const auto replayed = recording::replay(*stored);
        QVERIFY(replayed);
        QCOMPARE(replayed->stateHash, rig.liveHash());
        QVERIFY2(sum(replayed->state.brokenMm3) > 0.0, "nothing broke in this attempt");
    }

    void badSlendernessIsRefused()
    {
        core::servo::ServoSettings settings;
        settings.breakOff.slenderness = 1.0;
        QCOMPARE(core::servo::makeServoTick(settings).error().code, ErrorCode::OutOfRange);
    }
};

CUSP_TEST(TestBreakOff)
#include "tst_break_off.moc"
