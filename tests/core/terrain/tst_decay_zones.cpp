// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <memory>

#include "core/grading/IdealCavity.h"
#include "core/grading/LesionCut.h"
#include "core/grading/Measures.h"
#include "core/imaging/Section.h"
#include "core/recording/Format.h"
#include "core/recording/Replay.h"
#include "core/settings/FeelPreset.h"
#include "core/terrain/DecayZones.h"
#include "core/terrain/Resample.h"
#include "tests/support/Checks.h"
#include "tests/support/Rig.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using support::between;
using terrain::ToothAnatomy;

namespace {

/// Returns a slab with enamel down to -1 mm and decay from -0.5 mm to -3.5 mm in the square 20 .. 43 (0.1 mm a cell).
/// In the columns from 32 on the pulp begins at -4.2 mm; the others have no pulp.
std::shared_ptr<ToothAnatomy> decayedSlab(bool hasZones = true)
{
    auto anatomy = support::slab(-1.0F);
    anatomy->hasDecayZones = hasZones;
    for (int j = 20; j <= 43; ++j) {
        for (int i = 20; i <= 43; ++i) {
            terrain::ColumnLayers& column = anatomy->layers[anatomy->grid.index(i, j)];
            column.cariesRoof = -0.5F;
            column.cariesFloor = -3.5F;
            if (i >= 32) {
                column.pulpRoof = -4.2F;
                column.pulpFloor = -6.0F;
            }
        }
    }
    return anatomy;
}

/// Returns a block with decay in dentin from the top down to -1.5 mm: soft to -0.5 mm, leathery to -1.0 mm, then firm.
terrain::Tooth decayedBlock(bool hasZones)
{
    auto block = std::make_shared<ToothAnatomy>(*support::makeBlock({.dejMm = 10.0, .cariesFloorMm = -1.5}));
    block->hasDecayZones = hasZones;
    return terrain::Tooth(std::move(block));
}

core::servo::ServoSettings settingsFor(settings::DecayKind decay)
{
    core::servo::ServoSettings settings;
    settings.hardness = settings::hardnessFor({}, {false, decay});
    return settings;
}

/// Presses a fissure bur down with 1 N and returns its speed between two depths, mm/s.
double paceBetween(const terrain::Tooth& tooth, const core::servo::ServoSettings& settings, double fromMm, double toMm)
{
    const support::Bench bench(tooth, "57", settings);
    bench.step({0.013, 0.021, 0.5});
    int ticks = 0;
    for (int tick = 0; tick < 20'000 && bench.state().anchorMm.z > toMm; ++tick) {
        ticks += bench.state().anchorMm.z < fromMm ? 1 : 0;
        bench.step({0.013, 0.021, bench.state().anchorMm.z - (tick < 5 ? 1.0 : 0.5)});
    }
    return (fromMm - toMm) / (0.001 * ticks);
}

grading::LesionCut lesionCut(const std::shared_ptr<const ToothAnatomy>& anatomy, const std::vector<float>& top)
{
    return grading::measureLesionCut(terrain::restored(anatomy, top)).value();
}

}  // namespace

class TestDecayZones : public QObject
{
    Q_OBJECT
private slots:
    void zonesLieInDentinFromTheFloorUp()
    {
        const auto zones = [](float roof, float floor, float dej) {
            return terrain::decayZonesOf(terrain::ColumnLayers{roof, floor, dej, 0.0F, 0.0F});
        };
        QCOMPARE(zones(0.0F, -3.0F, -1.0F).firmRoof, -2.5F);
        QCOMPARE(zones(0.0F, -3.0F, -1.0F).leatheryRoof, -2.0F);
        // Too little dentin for all zones; decay in enamel alone; no decay.
        QCOMPARE(zones(0.0F, -1.75F, -1.0F).leatheryRoof, -1.0F);
        QCOMPARE(zones(0.0F, -1.25F, -1.0F).firmRoof, -1.0F);
        QCOMPARE(zones(0.0F, -0.5F, -1.0F).leatheryRoof, -0.5F);
        QCOMPARE(zones(-2.0F, -2.25F, -1.0F).firmRoof, -2.0F);
        QCOMPARE(zones(2.0F, 2.0F, -1.0F).leatheryRoof, 2.0F);
        const auto without = decayedSlab(false);
        const std::size_t middle = without->grid.index(32, 32);
        QCOMPARE(terrain::decayZonesOf(*without, middle).leatheryRoof, -3.5F);
        QVERIFY(!terrain::isSameTooth(*without, *decayedSlab()));
        QVERIFY(terrain::resampled(*decayedSlab(), terrain::Sampling::Half)->hasDecayZones);
    }

    /// Each zone is cut at the rate of its own row, and the firm zone as if all decay were firm.
    void aBurGoesSlowerFromZoneToZone()
    {
        const core::servo::ServoSettings graded = settingsFor(settings::DecayKind::Graded);
        const terrain::Tooth tooth = decayedBlock(true);
        const double soft = paceBetween(tooth, graded, -0.1, -0.4);
        const double leathery = paceBetween(tooth, graded, -0.6, -0.9);
        const double firm = paceBetween(tooth, graded, -1.1, -1.4);
        QVERIFY(between(leathery / soft, 0.8 * (0.935 / 0.95) - 0.02, 0.8 * (0.935 / 0.95) + 0.02));
        const core::servo::ServoSettings allFirm = settingsFor(settings::DecayKind::Firm);
        QVERIFY(between(firm / paceBetween(decayedBlock(false), allFirm, -1.1, -1.4), 0.98, 1.02));
        QVERIFY(firm < 0.85 * leathery);
    }

    /// Zones require a tooth and a preset that have them. Otherwise decay is cut as before zones existed, to the bit.
    void withoutZonesDecayIsCutAsBefore()
    {
        const auto hashAfter = [](bool hasZones, settings::DecayKind decay) {
            const support::Bench bench(decayedBlock(hasZones), "330", settingsFor(decay));
            for (int tick = 0; tick < 600; ++tick)
                bench.step({0.0004 * tick, 0.0, 0.2 - 0.004 * tick});
            return terrain::stateHash(bench.tooth->tooth());
        };
        const std::uint64_t before = hashAfter(false, settings::DecayKind::Soft);
        QCOMPARE(hashAfter(true, settings::DecayKind::Soft), before);
        QCOMPARE(hashAfter(false, settings::DecayKind::Graded), before);
        QVERIFY(hashAfter(true, settings::DecayKind::Graded) != before);
    }

    void aRecordingKeepsTheZones()
    {
        support::Rig rig(settingsFor(settings::DecayKind::Graded));
        rig.drill(decayedBlock(true).anatomy);
        rig.lean(0.0, 0.0, 2.0, 400);
        rig.lift();
        const recording::Recording made = rig.session->recordingSoFar().value();
        const std::string bytes = made.toBytes();
        QCOMPARE(bytes[8], static_cast<char>(9));
        const auto read = recording::Recording::fromBytes(bytes);
        QVERIFY(support::succeeds(read));
        QVERIFY(read->anatomy()->hasDecayZones);
        QVERIFY(read->settings() == made.settings());
        const auto outcome = recording::replay(*read);
        QVERIFY(support::succeeds(outcome));
        QCOMPARE(outcome->stateHash, rig.liveHash());
        // Nothing is added to a tooth without zones, and the byte has only one valid value.
        const std::string tooth = recording::toothBytes(*made.anatomy());
        QCOMPARE(recording::toothBytes(*decayedBlock(false).anatomy), tooth.substr(0, tooth.size() - 1));
        QVERIFY(recording::toothFrom(tooth.substr(0, tooth.size() - 1) + '\2') == nullptr);
        QVERIFY(recording::toothFrom(tooth + '\1') == nullptr);
        const std::string settings = recording::settingsBytes(made.settings());
        QVERIFY(!recording::settingsFrom(settings.substr(0, settings.size() - 1)));
    }

    /// The ideal leaves firm decay, and leathery decay over the pulp; at the junction it leaves none.
    void theIdealStopsAtFirmDentin()
    {
        const auto anatomy = decayedSlab();
        const auto at = [&](int i, int j) { return anatomy->grid.index(i, j); };
        anatomy->layers[at(25, 25)].cariesFloor = -1.4F;
        anatomy->layers[at(26, 25)].cariesFloor = -1.8F;
        anatomy->layers[at(27, 25)].pulpRoof = -5.2F;
        anatomy->layers[at(27, 25)].pulpFloor = -6.0F;
        anatomy->layers[at(28, 25)].cariesRoof = -3.2F;  // firm throughout
        const grading::IdealTop ideal = grading::idealCavity(*anatomy);
        QCOMPARE((*ideal)[at(24, 24)], -3.0F);
        QCOMPARE((*ideal)[at(40, 24)], -2.5F);
        QCOMPARE((*ideal)[at(25, 25)], -1.4F);
        QVERIFY(support::near(static_cast<double>((*ideal)[at(26, 25)]), -1.5, 2e-4));
        QCOMPARE((*ideal)[at(27, 25)], -3.0F);
        QCOMPARE((*ideal)[at(28, 25)], 0.0F);
        QVERIFY(grading::isOverPulp(*anatomy, at(40, 24)) && !grading::isOverPulp(*anatomy, at(27, 25)));
    }

    void theIdealCostsNothingAndIsTheSmallestCavity()
    {
        const auto anatomy = decayedSlab();
        const std::vector<float> ideal = *grading::idealCavity(*anatomy);
        const grading::Measures measures = grading::measure(terrain::restored(anatomy, ideal));
        const double area = 24 * 24 * 0.01;
        QVERIFY(support::near(measures.decayToKeepMm3, area * 0.75, 1e-5));
        QVERIFY(support::near(measures.cariesLeftMm3, measures.decayToKeepMm3, 1e-5));
        QVERIFY(support::near(measures.lesionMm3, area * 3.0, 1e-5));
        QVERIFY(support::near(measures.accessMm3, area * 0.5, 1e-5));
        QCOMPARE(measures.overcutMm3, 0.0);
        // The nearest column is beside the pulp, one cell away.
        QVERIFY(support::near(measures.remainingOverPulpMm, std::hypot(1.2, 0.1), 1e-5));
        const grading::LesionCut cut = lesionCut(anatomy, ideal);
        QCOMPARE(cut.zones->softPercent.value, 0.0);
        QCOMPARE(cut.zones->leatheryMm2.value, 0.0);
        QCOMPARE(cut.junctionMm2.value, 0.0);
        QCOMPARE(cut.belowMm.value, 0.0);
        QVERIFY(!lesionCut(decayedSlab(false), ideal).zones);
    }

    void whatIsLeftIsToldByZone()
    {
        const auto anatomy = decayedSlab();
        QVERIFY(support::near(lesionCut(anatomy, anatomy->top).zones->softPercent.value, 100.0, 1e-9));
        // 0.2 mm of leathery decay is left in all columns. Half of them are over the pulp, where it may stay.
        std::vector<float> top = *grading::idealCavity(*anatomy);
        for (float& height : top)
            height = height == -3.0F ? -2.8F : height;
        const grading::LesionCut leathery = lesionCut(anatomy, top);
        QCOMPARE(leathery.zones->softPercent.value, 0.0);
        QVERIFY(support::near(leathery.zones->leatheryMm2.value, 12 * 24 * 0.01, 1e-5));
        QVERIFY(!grading::isOverPulp(*anatomy, leathery.zones->leatheryMm2.node));
        // Removed firm decay is not sound tissue, but counts as too deep.
        for (float& height : top)
            height = height < 0.0F ? -3.5F : height;
        QCOMPARE(grading::measure(terrain::restored(anatomy, top)).overcutMm3, 0.0);
        QVERIFY(support::near(lesionCut(anatomy, top).belowMm.value, 1.0, 1e-5));
    }

    void aSectionShowsTheZones()
    {
        const auto anatomy = decayedSlab();
        const imaging::SectionPlane plane{{0.0, 0.0}, 0.0};
        const auto sampleOf = [&](const std::shared_ptr<const ToothAnatomy>& tooth) {
            return imaging::sectionOf(terrain::Tooth(tooth), plane, -0.5, 0.5, 3).samples.at(1);
        };
        QVERIFY(sampleOf(anatomy).zones.has_value());
        QCOMPARE(sampleOf(anatomy).zones->firmRoof, -3.0F);
        QCOMPARE(sampleOf(anatomy).zones->leatheryRoof, -2.5F);
        QVERIFY(!sampleOf(decayedSlab(false)).zones);
    }
};

CUSP_TEST(TestDecayZones)
#include "tst_decay_zones.moc"
