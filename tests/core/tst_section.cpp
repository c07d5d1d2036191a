// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/base/Rng.h"
#include "core/imaging/Section.h"
#include "core/teeth/ToothBuilder.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"

using namespace core;
using namespace core::terrain;
using imaging::SectionPlane;

namespace {

constexpr double kQuarter = std::numbers::pi / 2.0;

/// A block of 64 x 64 cells of 0.1 mm around the origin, top 0, bottom -10: enamel down to -2, pulp from -7 to -5 in
/// the nodes 20 .. 43 (a box from -1.2 to 1.2), decay from -3 to -1 in the nodes 30 .. 33 (from -0.2 to 0.2).
std::shared_ptr<ToothAnatomy> block()
{
    auto anatomy = support::slab(-2.0F);
    for (int j = 20; j <= 43; ++j)
        for (int i = 20; i <= 43; ++i) {
            ColumnLayers& column = anatomy->layers[anatomy->grid.index(i, j)];
            column.pulpRoof = -5.0F;
            column.pulpFloor = -7.0F;
            if (i >= 30 && i <= 33 && j >= 30 && j <= 33) {
                column.cariesRoof = -1.0F;
                column.cariesFloor = -3.0F;
            }
        }
    return anatomy;
}

bool near(double actual, double expected, double tolerance = 1e-5)
{
    if (std::abs(actual - expected) <= tolerance)
        return true;
    qWarning("%.9g is not %.9g", actual, expected);
    return false;
}

PerMaterial lengths(const MaterialSpans& spans)
{
    PerMaterial sum{};
    for (const MaterialSpan& span : spans)
        sum.at(static_cast<std::size_t>(span.material)) +=
            static_cast<double>(span.highMm) - static_cast<double>(span.lowMm);
    return sum;
}

}  // namespace

class TestSection : public QObject
{
    Q_OBJECT

private slots:
    void spansTellWhatAColumnIsMadeOf()
    {
        const ColumnLayers column{-1.0F, -3.0F, -2.0F, -5.0F, -7.0F};
        const MaterialSpans spans = spansBetween(column, -10.0F, 0.0F);
        QCOMPARE(spans.count, 5);
        QVERIFY((spans.span[0] == MaterialSpan{Material::Dentin, -10.0F, -7.0F}));
        QVERIFY((spans.span[1] == MaterialSpan{Material::Pulp, -7.0F, -5.0F}));
        QVERIFY((spans.span[2] == MaterialSpan{Material::Dentin, -5.0F, -3.0F}));
        QVERIFY((spans.span[3] == MaterialSpan{Material::Caries, -3.0F, -1.0F}));
        QVERIFY((spans.span[4] == MaterialSpan{Material::Enamel, -1.0F, 0.0F}));
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
            const PerMaterial expected = lengthsBetween(column, low, high);
            for (std::size_t m = 0; m < expected.size(); ++m)
                QVERIFY(near(lengths(spans)[m], expected[m]));
        }
    }

    void onANodeItSaysWhatTheColumnSays()
    {
        const auto built = teeth::buildTooth({36}, {});
        QVERIFY(built.has_value());
        Tooth tooth(built->anatomy);
        Rng rng(5);
        for (float& top : tooth.top)
            if (top > kEmptyTop)
                top -= static_cast<float>(rng.uniform(0.0, 3.0));
        const Grid& grid = tooth.grid();
        const int j = grid.side / 2 + 3;
        const glm::dvec2 first = grid.nodeMm(0, j);
        const glm::dvec2 last = grid.nodeMm(grid.side - 1, j);
        // A hair beside the row, so that rounding does not choose its neighbour.
        const imaging::Section section = imaging::sectionOf(tooth, {first, 0.0}, first.x, last.x, grid.side);
        int solid = 0;
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            const imaging::SectionSample& sample = section.samples.at(static_cast<std::size_t>(i));
            QCOMPARE(sample.wasTooth, built->anatomy->top[k] > built->anatomy->bottom[k]);
            if (!tooth.isSolid(k))
                continue;
            ++solid;
            QVERIFY(near(sample.originalTopMm, built->anatomy->top[k]));
            const PerMaterial expected = lengthsBetween(built->anatomy->layers[k], tooth.bottom[k], tooth.top[k]);
            for (std::size_t m = 0; m < expected.size(); ++m)
                QVERIFY(near(lengths(sample.present)[m], expected[m], 1e-4));
        }
        QVERIFY(solid > 100);
    }

    void betweenNodesHeightsAreLinear()
    {
        const auto anatomy = block();
        Tooth tooth(anatomy);
        // A ramp of 30 degrees or so along a direction that is no axis.
        for (int j = 0; j < 64; ++j)
            for (int i = 0; i < 64; ++i) {
                const glm::dvec2 at = anatomy->grid.nodeMm(i, j);
                tooth.top[anatomy->grid.index(i, j)] = static_cast<float>(-1.0 + 0.5 * at.x - 0.25 * at.y);
            }
        const SectionPlane plane{{0.013, -0.4}, 0.7};
        const imaging::Section section = imaging::sectionOf(tooth, plane, -2.0, 2.0, 81);
        for (int k = 0; k <= 80; ++k) {
            const glm::dvec2 at = plane.pointMm(section.fromMm + k * section.stepMm);
            const MaterialSpans& spans = section.samples.at(static_cast<std::size_t>(k)).present;
            QVERIFY(spans.count > 0);
            QVERIFY(
                near(spans.span.at(static_cast<std::size_t>(spans.count - 1)).highMm, -1.0 + 0.5 * at.x - 0.25 * at.y));
            QVERIFY(near(section.samples.at(static_cast<std::size_t>(k)).originalTopMm, 0.0));
        }
    }

    void aPlaneRunsWhereItsAngleSays_data()
    {
        support::columns<double, double, double, double>("angleRad", "x", "y", "along");
        QTest::newRow("mesio-distal") << 0.0 << 1.5 << -0.7 << 1.5;
        QTest::newRow("bucco-lingual") << kQuarter << 0.4 << 2.5 << 2.5;
        QTest::newRow("half way") << kQuarter / 2 << 0.9 << 0.1 << 1.0 / std::numbers::sqrt2;
    }

    void aPlaneRunsWhereItsAngleSays()
    {
        QFETCH(double, angleRad);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, along);
        // All of these lie in the plane through (0.4, -0.7), turned.
        const SectionPlane plane{angleRad == kQuarter ? glm::dvec2(0.4, -0.7)
                                 : angleRad == 0.0    ? glm::dvec2(0.4, -0.7)
                                                      : glm::dvec2(0.4, -0.4),
                                 angleRad};
        QVERIFY(near(plane.alongMm({x, y}), along));
        QVERIFY(near(plane.pointMm(along).x, x));
        QVERIFY(near(plane.pointMm(along).y, y));
    }

    void parallelSectionsAddUpToTheVolumes()
    {
        const auto built = teeth::buildTooth({36}, {});
        QVERIFY(built.has_value());
        Tooth tooth(built->anatomy);
        for (int j = 60; j < 90; ++j)
            for (int i = 50; i < 100; ++i)
                if (float& top = tooth.top[tooth.grid().index(i, j)]; top > kEmptyTop)
                    top = std::min(top, -4.0F);
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
        for (std::size_t m = 0; m < sum.size(); ++m) {
            qInfo("material %zu: sections %.2f mm3, columns %.2f mm3", m, sum[m], expected[m]);
            QVERIFY(near(sum[m], expected[m], 0.01 * expected[m] + 0.02));
        }
    }

    void theIdealSurfaceIsCutAsTheOthers()
    {
        const auto anatomy = block();
        const Tooth tooth(anatomy);
        std::vector<float> ideal = anatomy->top;
        for (int j = 0; j < 64; ++j)
            for (int i = 0; i < 64; ++i)
                ideal[anatomy->grid.index(i, j)] -= 0.01F * static_cast<float>(i);
        for (int j = 0; j < 64; ++j)
            ideal[anatomy->grid.index(40, j)] = kEmptyTop;
        const glm::dvec2 at = anatomy->grid.nodeMm(10, 32);
        const double half = 0.5 * anatomy->grid.cellMm;
        const imaging::Section section = imaging::sectionOf(tooth, {at, 0.0}, at.x, at.x + half, 2, &ideal);
        QVERIFY(near(section.samples[0].idealTopMm, section.samples[0].originalTopMm - 0.1F, 1e-5));
        QVERIFY(near(section.samples[1].idealTopMm, section.samples[1].originalTopMm - 0.105F, 1e-5));
        // What is to be cut through has no height, and gives its neighbours none.
        const glm::dvec2 hole = anatomy->grid.nodeMm(40, 32);
        const imaging::Section through = imaging::sectionOf(tooth, {hole, 0.0}, hole.x - 0.8 * half, hole.x, 2, &ideal);
        QCOMPARE(through.samples[1].idealTopMm, kEmptyTop);
        QCOMPARE(imaging::sectionOf(tooth, {at, 0.0}, at.x, at.x + half, 2).samples[0].idealTopMm, anatomy->top[0]);
    }

    void whereItIsCutThroughNothingIsLeft()
    {
        const auto anatomy = block();
        Tooth tooth(anatomy);
        for (int j = 0; j < 64; ++j) {
            tooth.top[anatomy->grid.index(10, j)] = kEmptyTop;
            tooth.bottom[anatomy->grid.index(10, j)] = kEmptyBottom;
        }
        const glm::dvec2 hole = anatomy->grid.nodeMm(10, 32);
        const imaging::Section section = imaging::sectionOf(tooth, {hole, 0.0}, hole.x - 0.1, hole.x + 0.1, 3);
        QVERIFY(section.samples[1].wasTooth);
        QCOMPARE(section.samples[1].present.count, 0);
        QVERIFY(section.samples[0].present.count > 0);
        QVERIFY(section.samples[2].present.count > 0);
        const imaging::Section beside = imaging::sectionOf(tooth, {hole, 0.0}, -20.0, -10.0, 5);
        for (const imaging::SectionSample& sample : beside.samples)
            QVERIFY(!sample.wasTooth && sample.present.count == 0);
    }

    void nearestPulpIsFoundInEveryDirection_data()
    {
        support::columns<double, double, double, double>("x", "y", "z", "distance");
        QTest::newRow("above") << 0.3 << -0.8 << -1.5 << 3.5;
        QTest::newRow("below") << 0.0 << 0.0 << -9.0 << 2.0;
        QTest::newRow("beside") << 2.2 << 0.5 << -6.0 << 1.0;
        QTest::newRow("over an edge") << -1.5 << 0.0 << -4.6 << 0.5;
        QTest::newRow("over a corner") << 1.4 << 1.5 << -4.4 << 0.7;
        QTest::newRow("inside") << 1.1 << -1.1 << -6.9 << 0.0;
    }

    void nearestPulpIsFoundInEveryDirection()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        QFETCH(double, distance);
        const imaging::PulpChamber pulp(*block());
        const glm::dvec3 point(x, y, z);
        QVERIFY(near(glm::length(pulp.nearest(point).value() - point), distance));
    }

    void nearestPulpAgreesWithASlowSearch()
    {
        const auto built = teeth::buildTooth({36}, {});
        QVERIFY(built.has_value());
        const ToothAnatomy& anatomy = *built->anatomy;
        const imaging::PulpChamber pulp(anatomy);
        // The slow way: the pulp as points, a third of a cell apart sideways and 0.02 mm up and down.
        std::vector<glm::dvec3> points;
        for (int j = 0; j < anatomy.grid.side; ++j)
            for (int i = 0; i < anatomy.grid.side; ++i) {
                const std::size_t k = anatomy.grid.index(i, j);
                for (double z = -14.0; z < 0.0; z += 0.02)
                    if (z > static_cast<double>(anatomy.bottom[k]) && z <= static_cast<double>(anatomy.top[k]) &&
                        materialAt(anatomy.layers[k], static_cast<float>(z)) == Material::Pulp)
                        points.emplace_back(anatomy.grid.nodeMm(i, j), z);
            }
        QVERIFY(points.size() > 10000);
        Rng rng(3);
        for (int round = 0; round < 60; ++round) {
            const glm::dvec3 from(rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0), rng.uniform(-9.0, 1.0));
            double least = 1.0e9;
            for (const glm::dvec3& point : points)
                least = std::min(least, glm::length(point - from));
            const double found = glm::length(pulp.nearest(from).value() - from);
            // Half the diagonal of a cell is what the points miss sideways.
            QVERIFY2(found <= least + 1.0e-6 && found >= least - 0.75 * anatomy.grid.cellMm - 0.02,
                     qPrintable(QString("%1, slowly %2").arg(found).arg(least)));
        }
    }

    void depthIsReadUnderTheTip()
    {
        const auto anatomy = block();
        Tooth tooth(anatomy);
        const imaging::PulpChamber pulp(*anatomy);
        // Over the middle, beside the decay: a cut down to -2.5 leaves 2.5 mm of dentin over the pulp.
        const glm::dvec2 at = anatomy->grid.nodeMm(25, 32);
        tooth.top[anatomy->grid.index(25, 32)] = -2.5F;
        imaging::DepthReading reading = imaging::readDepth(tooth, pulp, {at, -2.5});
        QVERIFY(reading.overTooth);
        QVERIFY(near(reading.depthMm, 2.5));
        QVERIFY(near(reading.dentinOverPulpMm.value(), 2.5));
        QVERIFY(near(reading.downToPulpMm.value(), 2.5));
        QVERIFY(near(reading.toPulpMm.value(), 2.5));
        // Decay between is no dentin: under it 2 mm are left, 4 mm down from -1.
        const glm::dvec2 decay = anatomy->grid.nodeMm(31, 31);
        reading = imaging::readDepth(tooth, pulp, {decay, -1.0});
        QVERIFY(near(reading.dentinOverPulpMm.value(), 2.0));
        QVERIFY(near(reading.downToPulpMm.value(), 4.0));
        // In the pulp nothing is left.
        tooth.top[anatomy->grid.index(25, 32)] = -5.5F;
        reading = imaging::readDepth(tooth, pulp, {at, -5.5});
        QCOMPARE(reading.dentinOverPulpMm.value(), 0.0);
        QCOMPARE(reading.downToPulpMm.value(), 0.0);
        QCOMPARE(reading.toPulpMm.value(), 0.0);
        // Where no pulp lies below, there is only the way in any direction: 1 mm sideways and 1 mm down from here.
        const glm::dvec2 beside = anatomy->grid.nodeMm(9, 32);
        reading = imaging::readDepth(tooth, pulp, {beside.x - 0.05, beside.y, -4.0});
        QVERIFY(reading.overTooth);
        QVERIFY(!reading.dentinOverPulpMm && !reading.downToPulpMm);
        QVERIFY(near(reading.toPulpMm.value(), std::sqrt(1.1 * 1.1 + 1.0)));
    }

    void besideTheToothNothingIsRead()
    {
        const auto anatomy = block();
        const Tooth tooth(anatomy);
        const imaging::PulpChamber pulp(*anatomy);
        const imaging::DepthReading reading = imaging::readDepth(tooth, pulp, {12.0, 0.0, 1.0});
        QVERIFY(!reading.overTooth);
        QVERIFY(!reading.dentinOverPulpMm);
        QVERIFY(reading.toPulpMm.has_value());
        auto sound = block();
        for (ColumnLayers& column : sound->layers)
            column.pulpRoof = column.pulpFloor = 0.0F;
        QVERIFY(imaging::PulpChamber(*sound).isEmpty());
        QVERIFY(!imaging::readDepth(Tooth(sound), imaging::PulpChamber(*sound), {0.0, 0.0, 0.0}).toPulpMm);
    }
};

QTEST_APPLESS_MAIN(TestSection)
#include "tst_section.moc"
