// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "core/cutting/Feed.h"
#include "core/servo/ServoTick.h"
#include "core/teeth/ToothBuilder.h"
#include "lab/CuttingTrials.h"
#include "tests/support/Checks.h"
#include "tests/support/Rig.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

using namespace core;
using support::Bench;
using support::between;
using support::blockTooth;
using support::kDegree;

namespace {

constexpr std::size_t kEnamel = 1;
constexpr std::size_t kDentin = 2;
const support::Block kDentinBlock{.dejMm = 10.0};
const support::Block kCariesBlock{.cariesFloorMm = -100.0};

/// Presses straight down with a constant force for some seconds and returns the removed volume of all materials.
double plunge(const support::Block& block, const char* bur, double newtons, double seconds,
              const core::servo::ServoSettings& settings = {})
{
    constexpr double kX = 0.013;
    constexpr double kY = 0.021;
    const Bench bench(blockTooth(block), bur, settings);
    bench.step({kX, kY, 1.0});
    double removed = 0.0;
    for (int tick = 0; tick < static_cast<int>(seconds * 1000.0); ++tick) {
        const double z = bench.state().anchorMm.z - (bench.state().tick < 5 ? 1.0 : newtons / 2.0);
        const terrain::PerMaterial& mm3 = bench.step({kX, kY, z}).removedMm3;
        removed = mm3[0] + mm3[1] + mm3[2] + mm3[3];
    }
    return removed;
}

}  // namespace

class TestDrill : public QObject
{
    Q_OBJECT
private slots:
    void volumeIsWhatTheMapsLost()
    {
        const Bench bench(blockTooth({.dejMm = -0.6}), "330");
        double z = 0.5;
        for (int tick = 0; tick < 3000; ++tick) {
            z -= (1.2 - glm::length(bench.state().forceN)) * 0.003;
            bench.step({1.2 * std::sin(tick * 0.004), 0.4 * std::cos(tick * 0.007), z});
        }
        const terrain::PerMaterial counted = bench.state().removedMm3;
        const terrain::PerMaterial lost = terrain::removedVolumes(bench.tooth->tooth());
        QVERIFY(counted[kEnamel] > 0.1);
        for (std::size_t m = 0; m < counted.size(); ++m)
            QVERIFY(between(counted[m] - lost[m], -1.0e-4, 1.0e-4));
    }

    void brushLeavesNoMark_data() { support::rows<QString>("bur", {"2", "330", "245", "57"}); }

    void brushLeavesNoMark()
    {
        // Dentists, 2011: an accidental brush leaves no mark. The brushes have 0.1 N at 100 mm/s, and 0.3 N for 20 ms,
        // moving and at rest.
        QFETCH(QString, bur);
        struct Brush
        {
            double newtons;
            double mmPerS;
            int ticks;
        };
        for (const double dej : {-100.0, 100.0})
            for (const Brush& brush : {Brush{0.1, 100.0, 20}, Brush{0.3, 100.0, 20}, Brush{0.3, 0.0, 20}}) {
                const Bench bench(blockTooth({.dejMm = dej}), qPrintable(bur));
                bench.step({-1.0, 0.0, 0.5});
                for (int tick = 0; tick < brush.ticks; ++tick) {
                    bench.step({-1.0 + 0.001 * brush.mmPerS * tick, 0.0, -brush.newtons / 2.0});
                    QVERIFY(bench.state().touching);
                }
                bench.step({1.0, 0.0, 0.5});
                const terrain::Tooth& tooth = bench.tooth->tooth();
                double deepest = 0.0;
                for (std::size_t k = 0; k < tooth.top.size(); ++k)
                    deepest = std::max(deepest,
                                       static_cast<double>(tooth.anatomy->top[k]) - static_cast<double>(tooth.top[k]));
                QVERIFY2(deepest < 0.002, qPrintable(QString("%1 N: %2 um").arg(brush.newtons).arg(1000.0 * deepest)));
            }
    }

    void rateIsLinearInForce()
    {
        // The bur runs at about 1 N. Its slowing under load bends the line by less than a user can feel, 7 to 10 % of
        // the force (docs/facts/haptics.md, section 7).
        const std::vector<double> newtons{0.5, 0.75, 1.0, 1.25, 1.5};
        std::vector<double> rates;
        double meanRate = 0.0;
        double slope = 0.0;
        for (const double force : newtons) {
            rates.push_back((plunge({}, "330", force, 1.5) - plunge({}, "330", force, 0.5)) / 1.0);
            meanRate += rates.back() / 5.0;
            slope += (force - 1.0) * rates.back() / 0.625;
        }
        for (std::size_t k = 0; k < rates.size(); ++k) {
            const double line = meanRate + slope * (newtons[k] - 1.0);
            QVERIFY(between((rates[k] - line) / rates[2], -0.03, 0.03));
        }
        // The rate is S (F - F0). S is less when a flat end is pushed along the axis: 0.40 of 0.7 mm3/(N s) in enamel.
        QVERIFY(between(rates[2] - 0.40 * 0.7 * 0.85, -0.01, 0.01));
    }

    void beyondTheFullLoadABurRemovesNoMore_data() { support::rows<QString>("bur", {"2", "330", "57"}); }

    /// Siegel & von Fraunhofer: the rate is proportional to the load up to 1.5 N and constant above.
    void beyondTheFullLoadABurRemovesNoMore()
    {
        QFETCH(QString, bur);
        const auto rate = [&](double newtons, const core::servo::ServoSettings& settings) {
            return plunge({}, qPrintable(bur), newtons, 1.5, settings) -
                   plunge({}, qPrintable(bur), newtons, 0.5, settings);
        };
        const double full = rate(1.5, {});
        for (const double newtons : {2.0, 3.0, 4.0})
            QVERIFY2(between(rate(newtons, {}) / full, 0.98, 1.02), qPrintable(QString::number(newtons)));
        core::servo::ServoSettings before;
        before.hardness = settings::withoutEndsAndFullLoad(before.hardness);
        QVERIFY(rate(2.0, before) > 1.1 * rate(1.5, before));
    }

    /// The end of a fissure bur has blades that cut badly. A round bur has blades all over.
    void flatEndsPlungeMoreSlowlyThanBalls()
    {
        for (const core::bur::Bur& bur : core::bur::burs())
            QCOMPARE(bur.hasFlatEnd(), !bur.outline.empty() && bur.undersideMm(0.1 * bur.headRadiusMm) == 0.0);
        for (const char* flat : {"330", "245", "57", "557", "701", "34", "836"})
            QVERIFY2(core::bur::burs()[core::bur::findBur(flat).value()].hasFlatEnd(), flat);
        for (const char* round : {"2", "8", "801", "1557", "856", "877", "379", "860"})
            QVERIFY2(!core::bur::burs()[core::bur::findBur(round).value()].hasFlatEnd(), round);
        const settings::HardnessPreset shipped;
        const settings::HardnessPreset before = settings::withoutEndsAndFullLoad(shipped);
        const auto feed = [](const settings::HardnessPreset& preset, const char* bur) {
            return core::cutting::feedMmPerS(preset, preset.material[kDentin], settings::Handpiece{},
                                             core::bur::burs()[core::bur::findBur(bur).value()], 1.0);
        };
        QCOMPARE(feed(shipped, "2"), feed(before, "2"));
        for (const char* flat : {"330", "245", "57"})
            QVERIFY(between(feed(shipped, flat) / feed(before, flat) * 0.65, 0.395, 0.405));
    }

    void loadSlowsTheBurToAStall()
    {
        // omega = omega0 (1 - T / Tstall), T = 0.4 F r (docs/facts/haptics.md, section 8.6). A round bur in the turbine
        // stalls at 1.1 / 0.2 N.
        const auto rpmAt = [](double newtons) {
            const Bench bench(blockTooth({}), "2");
            bench.step({0.0, 0.0, 1.0});
            for (int tick = 0; tick < 5; ++tick)
                bench.step({0.0, 0.0, bench.state().anchorMm.z - (tick == 0 ? 1.0 : newtons / 2.0)});
            return bench.state().burRpm;
        };
        const double freeRpm = settings::Handpiece{}.freeRpm;
        QVERIFY(between(rpmAt(1.0) / freeRpm - (1.0 - 0.2 / 1.1), -0.01, 0.01));
        QVERIFY(between(rpmAt(2.0) / freeRpm - (1.0 - 0.4 / 1.1), -0.01, 0.01));
        QCOMPARE(rpmAt(5.6), 0.0);
        QVERIFY(plunge({}, "2", 2.5, 0.5) > plunge({}, "2", 1.0, 0.5));
        QVERIFY(plunge({}, "2", 5.2, 0.5) < 0.5 * plunge({}, "2", 2.5, 0.5));

        const Bench bench(blockTooth({}), "2");
        bench.step({0.0, 0.0, 1.0});
        QCOMPARE(bench.state().burRpm, freeRpm);
        bench.servo->setDrill(false);
        bench.step({0.0, 0.0, 1.0});
        QCOMPARE(bench.state().burRpm, 0.0);
    }

    void handpiecesCutAsFastAsTheyTurn()
    {
        const auto rate = [](const settings::Handpiece& handpiece, double newtons) {
            core::servo::ServoSettings settings;
            settings.handpieces = {handpiece};
            return plunge(kCariesBlock, "2", newtons, 0.5, settings);
        };
        const settings::Handpiece motor = settings::findHandpiece("electric").value();
        const double turbine = rate(settings::findHandpiece("turbine").value(), 1.0);
        const double electric = rate(motor, 1.0);
        const double slow = rate(settings::findHandpiece("low-speed").value(), 1.0);
        QVERIFY2(electric < turbine && slow < 0.12 * electric && slow > 0.0,
                 qPrintable(QString("%1, %2, %3 mm3").arg(turbine).arg(electric).arg(slow)));
        // The motor holds its speed at a force at which the turbine nearly stalls.
        QVERIFY(rate(motor, 5.0) > rate(settings::Handpiece{}, 5.0));
        QVERIFY(!settings::findHandpiece("chisel"));

        core::servo::ServoSettings settings;
        settings.handpieces.front().stallTorqueNmm = 0.0;
        QCOMPARE(core::servo::makeServoTick(settings).error().code, ErrorCode::OutOfRange);
    }

    void ratesAreThoseOfTheTissues()
    {
        // The reference values of docs/method.md: occlusal work with the side of a 330 at 1 N, mm3/s, and a plunge into
        // enamel.
        const auto rate = [](terrain::Material material) {
            lab::PaceTrial trial;
            trial.material = material;
            trial.towards = lab::feed(20.0, 0.0);
            trial.seconds = 0.5;
            return lab::removedMm3(trial) / trial.seconds;
        };
        const double enamel = rate(terrain::Material::Enamel);
        const double dentin = rate(terrain::Material::Dentin);
        QVERIFY(between(enamel, 0.3, 0.6));
        QVERIFY(between(dentin, 1.0, 2.0));
        QVERIFY(between(rate(terrain::Material::Caries), 3.0, 6.0));
        QVERIFY(between(dentin / enamel, 3.0, 6.0));
        lab::PaceTrial plunged;
        plunged.seconds = 10.0;
        QVERIFY(between(lab::secondsTo(1.5, plunged), 2.0, 4.0));
    }

    void aNewtonCutsSteadily_data() { support::rows<QString>("bur", {"2", "330", "245", "57"}); }

    /// Dentists, 2011: about 1 N cuts steadily. Every tenth of a second removes the same volume.
    void aNewtonCutsSteadily()
    {
        QFETCH(QString, bur);
        std::vector<double> steps;
        for (double seconds = 1.0; seconds < 2.05; seconds += 0.1)
            steps.push_back(plunge({}, qPrintable(bur), 1.0, seconds));
        const double mean = (steps.back() - steps.front()) / static_cast<double>(steps.size() - 1);
        QVERIFY(mean > 0.01);
        for (std::size_t k = 1; k < steps.size(); ++k)
            QVERIFY(between((steps[k] - steps[k - 1]) / mean, 0.9, 1.1));
    }

    void tenLightStrokesMakeATrenchThatHolds_data() { support::rows<QString>("bur", {"2", "330"}); }

    void tenLightStrokesMakeATrenchThatHolds()
    {
        // Dentists, 2011: ten strokes of 5 mm with 0.5 N, 20 mm/s.
        QFETCH(QString, bur);
        const Bench bench(blockTooth({}), qPrintable(bur));
        bench.step({-2.5, 0.0, 0.5});
        glm::dvec3 anchor{};
        for (int stroke = 0; stroke < 10; ++stroke)
            for (int tick = 0; tick <= 250; ++tick) {
                const double x = (stroke % 2 == 0 ? -1.0 : 1.0) * (2.5 - 0.02 * tick);
                anchor = bench.step({x, 0.0, bench.state().anchorMm.z - 0.25}).anchorMm;
            }
        bench.servo->setDrill(false);
        for (int tick = 0; tick < 200; ++tick)
            anchor = bench.step({0.0, 0.0, anchor.z - 0.1}).anchorMm;
        const double bottom = anchor.z;
        QVERIFY(between(bottom, -8.0, -0.08));
        // The walls hold the bur: the hand pushes 0.3 N sideways and 0.3 N down, then only keeps its height.
        for (int tick = 0; tick < 400; ++tick)
            anchor = bench.step({0.0, 0.15 * std::min(1.0, tick / 100.0), anchor.z - 0.15}).anchorMm;
        QVERIFY(between(anchor.y, -1.0, 0.12));
        for (int tick = 0; tick < 400; ++tick)
            anchor = bench.step({0.0, 0.15, bottom}).anchorMm;
        QVERIFY(between(anchor.y, -1.0, 0.12));
        QVERIFY(between(anchor.z, -8.0, -0.03));
    }

    void perforatedColumnIsGoneFromBothMaps()
    {
        const Bench bench(blockTooth({.bottomMm = -0.4}), "57");
        double z = bench.step({0.0, 0.0, 0.5}).anchorMm.z;
        for (int tick = 0; tick < 4000; ++tick) {
            z = std::max(z - 0.002, bench.state().anchorMm.z - 1.0);
            bench.step({0.0, 0.0, std::max(z, -3.0)});
        }
        const terrain::Tooth& tooth = bench.tooth->tooth();
        int gone = 0;
        for (std::size_t k = 0; k < tooth.top.size(); ++k) {
            const bool topGone = tooth.top[k] <= terrain::kEmptyTop;
            QCOMPARE(tooth.bottom[k] >= terrain::kEmptyBottom, topGone);
            gone += topGone ? 1 : 0;
        }
        // A hole as wide as the bur: pi * 0.5^2 mm2 in cells of 0.07 mm.
        QVERIFY(between(gone * 0.0049 - 0.25 * std::numbers::pi, -0.06, 0.06));
        // The removed volume ends with the plate: nothing is counted below its bottom.
        QVERIFY(between(bench.state().removedMm3[kEnamel] - gone * 0.0049 * 0.4, -0.02, 0.02));
        // The bur went through.
        QVERIFY(bench.state().anchorMm.z < -2.0);
    }

    void pressedBurNeverStalls_data()
    {
        support::columns<QString, int, int>("method", "side", "bur");
        for (const QString& method : {QString("continuous"), QString("lattice")})
            for (const int side : {80, 150, 300})
                for (int bur = 0; bur < 4; ++bur)
                    QTest::addRow("%s, grid %d, bur %d", qPrintable(method), side, bur) << method << side << bur;
    }

    void pressedBurNeverStalls()
    {
        // A bur that is pressed down with 3 N beside the bottom of a pit first slides down, then cuts into it. It must
        // not come to rest where contact is felt between the nodes but no column can be cut.
        QFETCH(QString, method);
        QFETCH(int, side);
        QFETCH(int, bur);
        const support::Block block{
            .side = side, .cellMm = 10.0 / side, .bottomMm = -8.0, .topMm = [](double x, double y) {
                return 0.6 * std::sin(2.5 * x) * std::cos(2.0 * y) - 1.5 * std::exp(-4.0 * (x * x + y * y));
            }};
        for (const glm::dvec2 at : {glm::dvec2(0.3, -0.1), glm::dvec2(1.4, 1.1)}) {
            core::servo::ServoSettings settings;
            settings.method = method.toStdString();
            const Bench bench(blockTooth(block), "2", settings);
            bench.servo->setBur(static_cast<std::size_t>(bur));
            bench.step({at.x, at.y, 2.0});
            int idle = 0;
            for (int tick = 0; tick < 1200; ++tick) {
                const auto& state = bench.step({at.x, at.y, bench.state().anchorMm.z - 1.5});
                idle = state.cutting || tick < 100 ? 0 : idle + 1;
                QVERIFY2(idle < 100, qPrintable(QString("at %1: nothing cut since tick %2").arg(at.x).arg(tick - 100)));
            }
        }
    }

    void handpieceStopsTheBur()
    {
        // The bur goes through a plate and far below it, then moves around beneath it. It goes only as deep as it
        // sticks out of its chuck, the crown bears the rest of the force, and the bur does not come up through the
        // plate.
        const Bench bench(blockTooth({.bottomMm = -2.0}), "330");
        bench.step({0.0, 0.0, 0.5});
        for (int tick = 0; tick < 6000; ++tick)
            bench.step({0.0, 0.0, std::max(bench.state().anchorMm.z - 1.0, -30.0)});
        QCOMPARE(bench.state().anchorMm.z, -core::bur::kChuckMm);
        QVERIFY(bench.state().forceN.z > 1.0);

        const terrain::PerMaterial before = bench.state().removedMm3;
        for (int tick = 0; tick < 500; ++tick)
            bench.step({0.0, 0.0, -30.0});
        QCOMPARE(bench.state().removedMm3, before);

        double deepest = 0.0;
        for (int tick = 0; tick < 2000; ++tick) {
            const double z = bench.state().anchorMm.z;
            const auto& state = bench.step({0.5 * std::sin(0.01 * tick), 0.5 * std::cos(0.01 * tick), -30.0});
            QVERIFY(between(state.anchorMm.z - z, -0.5, 0.5));
            deepest = std::min(deepest, state.anchorMm.z);
        }
        QVERIFY(deepest >= -core::bur::kChuckMm);
    }

    void cutsInFromTheSideWithoutAJump_data() { support::rows<int>("fdi", {24, 26, 36}); }

    void cutsInFromTheSideWithoutAJump()
    {
        // Cutting in beneath the bulge, the bur soon has floor under one side and overhang above the other. Whatever it
        // cuts, the anchor must not move away from the hand that pulls it.
        QFETCH(int, fdi);
        const auto built = teeth::buildTooth({fdi}, {});
        QVERIFY(built);
        for (int approach = 0; approach < 24; ++approach) {
            if (!support::isTried(approach + fdi))
                continue;
            const double angle = approach * 30.0 * kDegree;
            const double z = approach < 12 ? -5.0 : -6.0;
            const Bench bench(terrain::Tooth(built->anatomy), "2");
            bench.servo->setBur(static_cast<std::size_t>(approach % 4));
            double before = 1.0e9;
            double radius = 9.0;
            for (int tick = 0; tick < 5000; ++tick) {
                radius = std::max(1.0, radius - 0.0016);
                const glm::dvec3 device(radius * std::cos(angle), radius * std::sin(angle), z);
                const double stretch = glm::length(bench.step(device).anchorMm - device);
                QVERIFY2(stretch < before + 0.1, qPrintable(QString("approach %1, tick %2: %3 mm, then %4")
                                                                .arg(approach)
                                                                .arg(tick)
                                                                .arg(before)
                                                                .arg(stretch)));
                before = stretch;
            }
            QVERIFY(bench.state().removedMm3[kEnamel] + bench.state().removedMm3[kDentin] > 0.5);
        }
    }

    void drillOffRemovesNothing()
    {
        const Bench bench(blockTooth({}), "330");
        bench.servo->setDrill(false);
        const std::uint64_t before = terrain::stateHash(bench.tooth->tooth());
        bench.step({-2.5, 0.0, 1.0});
        for (int tick = 0; tick < 500; ++tick)
            bench.step({0.01 * tick - 2.5, 0.0, -1.0});
        QCOMPARE(terrain::stateHash(bench.tooth->tooth()), before);
        QVERIFY(glm::length(bench.state().forceN) > 1.5);
    }

    void heightsOnlyGoDown()
    {
        const Bench bench(blockTooth({.dejMm = -0.5}), "245");
        std::vector<float> before = bench.tooth->tooth().top;
        for (int tick = 0; tick < 2000; ++tick) {
            bench.step({std::sin(tick * 0.01), std::cos(tick * 0.013), bench.state().anchorMm.z - 0.6});
            const std::vector<float>& now = bench.tooth->tooth().top;
            if (tick % 50 == 0) {
                for (std::size_t k = 0; k < now.size(); ++k)
                    QVERIFY(now[k] <= before[k]);
                before = now;
            }
        }
        QVERIFY(bench.state().removedMm3[kDentin] > 0.0);
    }

    void feedIsThatOfAFlatBur_data() { support::rows<double>("newtons", {0.3, 0.6, 1.0, 1.5, 2.5}); }

    /// The presets page draws the rate at which a straight fissure bur sinks into enamel. It must be the rate of the
    /// drill.
    void feedIsThatOfAFlatBur()
    {
        QFETCH(double, newtons);
        const core::bur::Bur& bur = core::bur::burs()[core::bur::findBur("57").value()];
        const double seconds = 1.0;
        const settings::HardnessPreset preset;
        const double told =
            core::cutting::feedMmPerS(preset, preset.material[kEnamel], settings::Handpiece{}, bur, newtons);
        const double sunk =
            plunge({}, "57", newtons, seconds) / (std::numbers::pi * bur.headRadiusMm * bur.headRadiusMm) / seconds;
        QVERIFY(between(sunk / told, 0.95, 1.05));
    }

    void badPresetIsRefused()
    {
        core::servo::ServoSettings settings;
        settings.hardness.material[kEnamel].rateMm3PerNs = std::nan("");
        const auto servo = core::servo::makeServoTick(settings);
        QVERIFY(support::isRefused(servo, ErrorCode::OutOfRange));
        QVERIFY(servo.error().detail.find("enamel") != std::string::npos);
    }
};

CUSP_TEST(TestDrill)
#include "tst_drill.moc"
