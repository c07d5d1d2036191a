// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/base/Rng.h"
#include "core/imaging/Section.h"
#include "tests/support/Checks.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using namespace core::terrain;
using imaging::SectionPlane;

namespace {

constexpr double kRightAngle = std::numbers::pi / 2.0;

/// A block whose pulp is a box from -1.2 to 1.2, and whose decay is a box from -0.2 to 0.2.
std::shared_ptr<ToothAnatomy> blockWithPulp()
{
    return support::decayedSlab(30, 33);
}

bool isClose(double actual, double expected, double tolerance = 1e-5)
{
    return support::near(actual, expected, tolerance);
}

PerMaterial lengths(const MaterialSpans& spans)
{
    PerMaterial sum{};
    for (const MaterialSpan& span : spans)
        sum.at(static_cast<std::size_t>(span.material)) +=
            static_cast<double>(span.highMm) - static_cast<double>(span.lowMm);
    return sum;
}

/// Returns whether the lengths of all materials agree within the tolerance.
bool areNear(const PerMaterial& actual, const PerMaterial& expected, double tolerance = 1e-5)
{
    return std::equal(actual.begin(), actual.end(), expected.begin(),
                      [&](double a, double b) { return isClose(a, b, tolerance); });
}

}  // namespace

class TestSection : public QObject
{
    Q_OBJECT

private slots:
    void spansTellWhatAColumnIsMadeOf()
    {
        const ColumnLayers column{-1.0F, -3.0F, -2.0F, -5.0F, -7.0F};
        const std::vector<MaterialSpan> expected{{Material::Dentin, -10.0F, -7.0F},
                                                 {Material::Pulp, -7.0F, -5.0F},
                                                 {Material::Dentin, -5.0F, -3.0F},
                                                 {Material::Caries, -3.0F, -1.0F},
                                                 {Material::Enamel, -1.0F, 0.0F}};
        const MaterialSpans spans = spansBetween(column, -10.0F, 0.0F);
        QVERIFY(std::equal(spans.begin(), spans.end(), expected.begin(), expected.end()));
        QCOMPARE(spansBetween(column, -2.5F, -2.5F).count, 0);
        QCOMPARE(spansBetween(column, -2.5F, -1.5F).count, 1);
    }

    void spansAgreeWithTheRuleOfTheColumn()
    {
        Rng rng(11);
        for (int round = 0; round < 20000; ++round) {
            const auto height = [&] { return static_cast<float>(0.5 * rng.below(20)); };
            const ColumnLayers column{height(), height(), height(), height(), height()};
            const float low = height();
            const float high = low + height();
            const MaterialSpans spans = spansBetween(column, low, high);
            float from = low;
            for (const MaterialSpan& span : spans) {
                QCOMPARE(span.lowMm, from);
                QVERIFY(span.highMm > span.lowMm);
                for (const float z : {span.lowMm + 0.1F, 0.5F * (span.lowMm + span.highMm), span.highMm})
                    QCOMPARE(materialAt(column, z), span.material);
                from = span.highMm;
            }
            QCOMPARE(from, high);
            QVERIFY(areNear(lengths(spans), lengthsBetween(column, low, high)));
        }
    }

    void onANodeItSaysWhatTheColumnSays()
    {
        const auto anatomy = support::builtTooth(36);
        Tooth tooth(anatomy);
        Rng rng(5);
        for (float& top : tooth.top)
            if (top > kEmptyTop)
                top -= static_cast<float>(rng.uniform(0.0, 3.0));
        const Grid& grid = tooth.grid();
        const int j = grid.side / 2 + 3;
        const glm::dvec2 first = grid.nodeMm(0, j);
        const glm::dvec2 last = grid.nodeMm(grid.side - 1, j);
        const imaging::Section section = imaging::sectionOf(tooth, {first, 0.0}, first.x, last.x, grid.side);
        int solid = 0;
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            const imaging::SectionSample& sample = section.samples.at(static_cast<std::size_t>(i));
            QCOMPARE(sample.wasTooth, anatomy->top[k] > anatomy->bottom[k]);
            if (!tooth.isSolid(k))
                continue;
            ++solid;
            QVERIFY(isClose(sample.originalTopMm, anatomy->top[k]));
            QVERIFY(areNear(lengths(sample.present), lengthsBetween(anatomy->layers[k], tooth.bottom[k], tooth.top[k]),
                            1e-4));
        }
        QVERIFY(solid > 100);
    }

    void betweenNodesHeightsAreLinear()
    {
        const auto anatomy = blockWithPulp();
        Tooth tooth(anatomy);
        // A ramp of about 30 degrees in a direction that is not along an axis.
        const auto ramp = [](glm::dvec2 at) { return -1.0 + 0.5 * at.x - 0.25 * at.y; };
        support::eachNode(anatomy->grid,
                          [&](std::size_t k, const glm::dvec2& at) { tooth.top[k] = static_cast<float>(ramp(at)); });
        const SectionPlane plane{{0.013, -0.4}, 0.7};
        const imaging::Section section = imaging::sectionOf(tooth, plane, -2.0, 2.0, 81);
        for (std::size_t k = 0; k <= 80; ++k) {
            const glm::dvec2 at = plane.pointMm(section.fromMm + static_cast<double>(k) * section.stepMm);
            const imaging::SectionSample& sample = section.samples.at(k);
            QVERIFY(sample.present.count > 0);
            QVERIFY(isClose(std::prev(sample.present.end())->highMm, ramp(at)));
            QVERIFY(isClose(sample.originalTopMm, 0.0));
        }
    }

    void aPlaneRunsWhereItsAngleSays()
    {
        // Mesio-distal, bucco-lingual, and half-way between.
        for (const auto& [angleRad, throughY, point, along] :
             {std::tuple(0.0, -0.7, glm::dvec2(1.5, -0.7), 1.5),
              {kRightAngle, -0.7, glm::dvec2(0.4, 2.5), 2.5},
              {kRightAngle / 2, -0.4, glm::dvec2(0.9, 0.1), 1.0 / std::numbers::sqrt2}}) {
            const SectionPlane plane{{0.4, throughY}, angleRad};
            QVERIFY(isClose(plane.alongMm(point), along));
            QVERIFY(isClose(glm::distance(plane.pointMm(along), point), 0.0));
        }
    }

    void parallelSectionsAddUpToTheVolumes()
    {
        Tooth tooth(support::builtTooth(36));
        support::eachOf(tooth.grid(), {50, 99, 60, 89}, [&](std::size_t k) {
            if (tooth.isSolid(k))
                tooth.top[k] = std::min(tooth.top[k], -4.0F);
        });
        const PerMaterial expected = volumes(tooth);
        const double angle = 0.52;
        const glm::dvec2 square(-std::sin(angle), std::cos(angle));
        constexpr double kApart = 0.08;
        PerMaterial sum{};
        for (double offset = -8.0; offset <= 8.0; offset += kApart) {
            const imaging::Section section = imaging::sectionOf(tooth, {offset * square, angle}, -8.0, 8.0, 321);
            for (const imaging::SectionSample& sample : section.samples) {
                const PerMaterial here = lengths(sample.present);
                for (std::size_t m = 0; m < sum.size(); ++m)
                    sum[m] += here[m] * section.stepMm * kApart;
            }
        }
        for (std::size_t m = 0; m < sum.size(); ++m)
            QVERIFY(isClose(sum[m], expected[m], 0.01 * expected[m] + 0.02));
    }

    void theIdealSurfaceIsCutAsTheOthers()
    {
        const auto anatomy = blockWithPulp();
        const Tooth tooth(anatomy);
        std::vector<float> ideal = anatomy->top;
        for (int i = 0; i < 64; ++i)
            support::eachOf(anatomy->grid, {i, i, 0, 63}, [&](std::size_t k) {
                ideal[k] = i == 40 ? kEmptyTop : ideal[k] - 0.01F * static_cast<float>(i);
            });
        const glm::dvec2 at = anatomy->grid.nodeMm(10, 32);
        const double half = 0.5 * anatomy->grid.cellMm;
        const imaging::Section section = imaging::sectionOf(tooth, {at, 0.0}, at.x, at.x + half, 2, &ideal);
        QVERIFY(isClose(section.samples[0].idealTopMm, section.samples[0].originalTopMm - 0.1F));
        QVERIFY(isClose(section.samples[1].idealTopMm, section.samples[1].originalTopMm - 0.105F));
        // A column that the ideal cuts through has no height, and does not contribute to its neighbours.
        const glm::dvec2 hole = anatomy->grid.nodeMm(40, 32);
        const imaging::Section through = imaging::sectionOf(tooth, {hole, 0.0}, hole.x - 0.8 * half, hole.x, 2, &ideal);
        QCOMPARE(through.samples[1].idealTopMm, kEmptyTop);
        QCOMPARE(imaging::sectionOf(tooth, {at, 0.0}, at.x, at.x + half, 2).samples[0].idealTopMm, anatomy->top[0]);
    }

    void whereItIsCutThroughNothingIsLeft()
    {
        Tooth tooth(blockWithPulp());
        support::eachOf(tooth.grid(), {10, 10, 0, 63}, [&](std::size_t k) { support::cutThrough(tooth, k); });
        const glm::dvec2 hole = tooth.grid().nodeMm(10, 32);
        const imaging::Section section = imaging::sectionOf(tooth, {hole, 0.0}, hole.x - 0.1, hole.x + 0.1, 3);
        QVERIFY(section.samples[1].wasTooth);
        QCOMPARE(section.samples[1].present.count, 0);
        QVERIFY(section.samples[0].present.count > 0);
        QVERIFY(section.samples[2].present.count > 0);
        for (const imaging::SectionSample& sample : imaging::sectionOf(tooth, {hole, 0.0}, -20.0, -10.0, 5).samples)
            QVERIFY(!sample.wasTooth && sample.present.count == 0);
    }

    void nearestPulpIsFoundInEveryDirection()
    {
        const imaging::PulpChamber pulp(*blockWithPulp());
        for (const auto& [where, point, distance] : {std::tuple("above", glm::dvec3(0.3, -0.8, -1.5), 3.5),
                                                     {"below", glm::dvec3(0.0, 0.0, -9.0), 2.0},
                                                     {"beside", glm::dvec3(2.2, 0.5, -6.0), 1.0},
                                                     {"over an edge", glm::dvec3(-1.5, 0.0, -4.6), 0.5},
                                                     {"over a corner", glm::dvec3(1.4, 1.5, -4.4), 0.7},
                                                     {"inside", glm::dvec3(1.1, -1.1, -6.9), 0.0}})
            QVERIFY2(isClose(glm::distance(pulp.nearest(point).value(), point), distance), where);
    }

    void nearestPulpAgreesWithASlowSearch()
    {
        const ToothAnatomy& anatomy = *support::builtTooth(36);
        const imaging::PulpChamber pulp(anatomy);
        // A slow search for the distance: the pulp as points, one cell apart sideways and 0.02 mm in height.
        std::vector<glm::dvec3> points;
        support::eachNode(anatomy.grid, [&](std::size_t k, const glm::dvec2& at) {
            for (double z = -14.0; z < 0.0; z += 0.02)
                if (z > static_cast<double>(anatomy.bottom[k]) && z <= static_cast<double>(anatomy.top[k]) &&
                    materialAt(anatomy.layers[k], static_cast<float>(z)) == Material::Pulp)
                    points.emplace_back(at, z);
        });
        QVERIFY(points.size() > 10000);
        Rng rng(3);
        for (int round = 0; round < 60; ++round) {
            const glm::dvec3 from(rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0), rng.uniform(-9.0, 1.0));
            double least = 1.0e9;
            for (const glm::dvec3& point : points)
                least = std::min(least, glm::length(point - from));
            const double found = glm::length(pulp.nearest(from).value() - from);
            // The points may miss the nearest place by half the diagonal of a cell sideways.
            QVERIFY2(found <= least + 1.0e-6 && found >= least - 0.75 * anatomy.grid.cellMm - 0.02,
                     qPrintable(QString("%1, slowly %2").arg(found).arg(least)));
        }
    }

    void depthIsReadUnderTheTip()
    {
        const auto anatomy = blockWithPulp();
        Tooth tooth(anatomy);
        const imaging::PulpChamber pulp(*anatomy);
        // Expects the dentin above the pulp, the distance straight down to the pulp and the shortest one. Without a
        // value: there is no pulp below.
        const auto reads = [&](const glm::dvec3& tip, std::optional<double> dentin, std::optional<double> down,
                               double shortest) {
            const imaging::DepthReading found = imaging::readDepth(tooth, pulp, tip);
            return found.overTooth && found.dentinOverPulpMm.has_value() == dentin.has_value() &&
                   found.downToPulpMm.has_value() == down.has_value() &&
                   isClose(found.dentinOverPulpMm.value_or(0.0), dentin.value_or(0.0)) &&
                   isClose(found.downToPulpMm.value_or(0.0), down.value_or(0.0)) &&
                   isClose(found.toPulpMm.value(), shortest);
        };
        // Above the middle, beside the decay, a cut down to -2.5 leaves 2.5 mm of dentin over the pulp.
        const glm::dvec2 at = anatomy->grid.nodeMm(25, 32);
        float& top = tooth.top[anatomy->grid.index(25, 32)];
        top = -2.5F;
        QVERIFY(reads({at, -2.5}, 2.5, 2.5, 2.5));
        QVERIFY(isClose(imaging::readDepth(tooth, pulp, {at, -2.5}).depthMm, 2.5));
        // Decay in between does not count as dentin: under it 2 mm are left, 4 mm down from -1.
        QVERIFY(reads({anatomy->grid.nodeMm(31, 31), -1.0}, 2.0, 4.0, 4.0));
        // In the pulp, no distance is left.
        top = -5.5F;
        QVERIFY(reads({at, -5.5}, 0.0, 0.0, 0.0));
        // Where there is no pulp below, only the shortest distance is known: 1 mm sideways and 1 mm down from here.
        const glm::dvec2 beside = anatomy->grid.nodeMm(9, 32) - glm::dvec2(0.05, 0.0);
        QVERIFY(reads({beside, -4.0}, std::nullopt, std::nullopt, std::sqrt(1.1 * 1.1 + 1.0)));
        // Where the pulp is beside the bur, its head, a ball of 0.5 mm, is nearer to it than the tip.
        QVERIFY(isClose(imaging::readDepth(tooth, pulp, {beside, -5.5}, 0.5).toPulpMm.value(), 0.6));
    }

    void besideTheToothNothingIsRead()
    {
        const auto anatomy = blockWithPulp();
        const imaging::PulpChamber pulp(*anatomy);
        const imaging::DepthReading reading = imaging::readDepth(Tooth(anatomy), pulp, {12.0, 0.0, 1.0});
        QVERIFY(!reading.overTooth);
        QVERIFY(!reading.dentinOverPulpMm);
        QVERIFY(reading.toPulpMm.has_value());
        const auto sound = support::slab(-2.0F);
        QVERIFY(imaging::PulpChamber(*sound).isEmpty());
        QVERIFY(!imaging::readDepth(Tooth(sound), imaging::PulpChamber(*sound), {0.0, 0.0, 0.0}).toPulpMm);
    }
};

CUSP_TEST(TestSection)
#include "tst_section.moc"
