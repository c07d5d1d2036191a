// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <cmath>

#include "core/base/Rng.h"
#include "core/grading/IdealCavity.h"
#include "core/grading/LesionCut.h"
#include "core/grading/Measures.h"
#include "tests/support/Checks.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using namespace core::terrain;
using support::cut;
using support::cutThrough;

namespace {

/// Returns 64 x 64 cells of 0.1 mm with decay in the square 28 .. 35.
std::shared_ptr<ToothAnatomy> decayedBlock()
{
    return support::decayedSlab(28, 35);
}

grading::Measures measuresAfter(const support::Nodes& nodes, float toMm)
{
    Tooth tooth(decayedBlock());
    cut(tooth, nodes, toMm);
    return grading::measure(tooth);
}

bool isNear(double actual, double expected, double tolerance = 1e-6)
{
    return support::near(actual, expected, tolerance);
}

double removed(const grading::Measures& measures, Material material)
{
    return measures.removedMm3[static_cast<std::size_t>(material)];
}

}  // namespace

class TestMeasures : public QObject
{
    Q_OBJECT

private slots:
    void theIdealCavityTakesTheDecayAndNothingBeside()
    {
        const auto anatomy = decayedBlock();
        const grading::IdealTop ideal = grading::idealCavity(*anatomy);
        QVERIFY(ideal != nullptr);
        for (int j = 0; j < 64; ++j)
            for (int i = 0; i < 64; ++i)
                QCOMPARE((*ideal)[anatomy->grid.index(i, j)], i >= 28 && i <= 35 && j >= 28 && j <= 35 ? -3.0F : 0.0F);
        const grading::Measures measures = grading::measure(restored(anatomy, *ideal));
        QCOMPARE(measures.cariesLeftMm3, 0.0);
        QCOMPARE(measures.overcutMm3, 0.0);
        QVERIFY(isNear(removed(measures, Material::Caries), measures.lesionMm3));
        // Without a lesion there is no ideal cavity. A lesion through the tooth leaves nothing of its column, and a
        // lesion outside the tooth is ignored.
        QVERIFY(grading::idealCavity(*support::slab(-2.0F)) == nullptr);
        anatomy->layers[anatomy->grid.index(30, 30)].cariesFloor = -20.0F;
        anatomy->layers[anatomy->grid.index(2, 2)] = {6.0F, 4.0F, -2.0F, 0.0F, 0.0F};
        anatomy->layers[anatomy->grid.index(3, 3)] = {-12.0F, -14.0F, -2.0F, 0.0F, 0.0F};
        const grading::IdealTop again = grading::idealCavity(*anatomy);
        QCOMPARE((*again)[anatomy->grid.index(30, 30)], kEmptyTop);
        QCOMPARE((*again)[anatomy->grid.index(2, 2)], 0.0F);
        QCOMPARE((*again)[anatomy->grid.index(3, 3)], 0.0F);
    }

    void anUncutToothHasLostNothing()
    {
        const grading::Measures m = grading::measure(Tooth(decayedBlock()));
        QVERIFY(isNear(m.lesionMm3, 64 * 0.01 * 2.0));
        QVERIFY(isNear(m.cariesLeftMm3, m.lesionMm3));
        QVERIFY(isNear(m.cariesLeftPercent, 100.0));
        QVERIFY(isNear(m.largestIslandMm3, m.lesionMm3));
        QVERIFY(isNear(m.accessMm3, 64 * 0.01 * 1.0));
        QCOMPARE(m.overcutMm3, 0.0);
        QCOMPARE(m.deepestCutMm, 0.0);
        QCOMPARE(m.pulpExposedMm2, 0.0);
        QVERIFY(!m.hasRemainingOverPulp);
    }

    void clearingTheLesionExactlyIsNoOvercut()
    {
        const grading::Measures m = measuresAfter({28, 35, 28, 35}, -3.0F);
        QVERIFY(isNear(m.cariesLeftMm3, 0.0));
        QVERIFY(isNear(m.overcutMm3, 0.0));
        QVERIFY(isNear(removed(m, Material::Caries), m.lesionMm3));
        QVERIFY(isNear(removed(m, Material::Enamel), m.accessMm3));
        QVERIFY(isNear(m.deepestCutMm, 3.0));
        QVERIFY(m.hasRemainingOverPulp);
        QVERIFY(isNear(m.remainingOverPulpMm, 2.0));
    }

    void whatLiesBesideAndBelowTheLesionIsOvercut()
    {
        // Cuts one column too wide on one side, and half a millimetre too deep.
        const grading::Measures m = measuresAfter({27, 35, 28, 35}, -3.5F);
        QVERIFY(isNear(m.overcutMm3, 0.01 * (8 * 3.5 + 64 * 0.5)));
        const double sound = removed(m, Material::Enamel) + removed(m, Material::Dentin);
        QVERIFY(isNear(sound, m.overcutMm3 + m.accessMm3));
    }

    void aCutIsMeasuredAgainstItsLesion()
    {
        const auto anatomy = decayedBlock();  // a block without an FDI number has no ridges
        const auto after = [&](const std::vector<std::pair<support::Nodes, float>>& cuts) {
            Tooth tooth(anatomy);
            for (const auto& [nodes, toMm] : cuts)
                cut(tooth, nodes, toMm);
            return grading::measureLesionCut(tooth).value();
        };
        const grading::LesionCut clean = after({{{28, 35, 28, 35}, -3.0F}});
        QVERIFY(clean == grading::LesionCut{});
        const double junction = static_cast<double>(anatomy->layers[anatomy->grid.index(30, 30)].dej);
        // Leaves decay on the floor of all columns, and in two of them up to the junction.
        const float onFloor = static_cast<float>(junction - grading::kAtJunctionMm - 0.1);
        const grading::LesionCut left = after({{{28, 35, 28, 34}, onFloor}, {{28, 33, 35, 35}, onFloor}});
        QVERIFY(onFloor > -3.0F);
        QVERIFY(isNear(left.junctionMm2.value, 0.02) && isNear(left.floorMm2.value, 0.62));
        // Cuts half a millimetre deeper over 1 mm2, and a hole 2 mm away.
        QVERIFY(isNear(after({{{26, 37, 26, 37}, -3.5F}}).belowMm.value, 0.5));
        QVERIFY(isNear(after({{{30, 33, 30, 33}, -3.5F}}).belowMm.value, 0.0));  // 0.16 mm2
        const double away = after({{{28, 35, 28, 35}, -3.0F}, {{55, 58, 30, 33}, -0.5F}}).beyondMm.value;
        QVERIFY2(away > 1.9 && away < 2.3, qPrintable(QString::number(away)));
        QVERIFY(isNear(after({{{28, 35, 28, 35}, -3.0F}, {{55, 58, 30, 33}, -0.1F}}).beyondMm.value, 0.0));
        QVERIFY(!grading::measureLesionCut(Tooth(support::slab(-2.0F))).has_value());
    }

    void theRidgesAreMeasuredInAToothWithDecay()
    {
        const auto anatomy = support::builtTooth(36);
        const auto widened = [&](double halfMm) {
            return grading::measureLesionCut(support::lowered(anatomy,
                                                              [halfMm](glm::dvec2 p) {
                                                                  return std::abs(p.x) < halfMm && std::abs(p.y) < 1.0
                                                                             ? -3.0
                                                                             : 10.0;
                                                              }))
                .value();
        };
        const grading::LesionCut narrow = widened(1.5);
        const grading::LesionCut wide = widened(2.5);
        QVERIFY(isNear(narrow.ridgeMesialMm->value - wide.ridgeMesialMm->value, 1.0, 0.15));
        QVERIFY(isNear(wide.ridgeLostMm.value - narrow.ridgeLostMm.value, 1.0, 0.15));
        QVERIFY(isNear(narrow.ridgeDistalMm->value - wide.ridgeDistalMm->value, 1.0, 0.15));
        QVERIFY(!grading::measureLesionCut(Tooth(anatomy))->ridgeMesialMm.has_value());
    }

    void countsTheLargestIsland()
    {
        // A slot through the decay leaves three columns on one side and four on the other.
        const grading::Measures m = measuresAfter({31, 31, 28, 35}, -3.0F);
        QVERIFY(isNear(m.cariesLeftMm3, 0.01 * 56 * 2.0));
        QVERIFY(isNear(m.largestIslandMm3, 0.01 * 32 * 2.0));
        // Neighbouring columns whose decay does not overlap in height are two islands.
        auto anatomy = decayedBlock();
        support::eachOf(anatomy->grid, {32, 35, 28, 35}, [&](std::size_t k) {
            anatomy->layers[k].cariesRoof = -3.5F;
            anatomy->layers[k].cariesFloor = -4.0F;
        });
        QVERIFY(isNear(grading::measure(Tooth(anatomy)).largestIslandMm3, 0.01 * 32 * 2.0));
    }

    void remainingIsTheShortestWayInAnyDirection()
    {
        // Cuts above the pulp; 4 columns beside it and deeper than its roof; 3 columns beside it and 0.4 mm above its
        // roof; far away.
        QVERIFY(isNear(measuresAfter({30, 30, 30, 30}, -4.25F).remainingOverPulpMm, 0.75));
        QVERIFY(isNear(measuresAfter({16, 16, 30, 30}, -6.0F).remainingOverPulpMm, 0.4));
        QVERIFY(isNear(measuresAfter({17, 17, 30, 30}, -4.6F).remainingOverPulpMm, 0.5));
        QVERIFY(isNear(measuresAfter({0, 0, 0, 0}, -0.1F).remainingOverPulpMm, 5.0));
    }

    void remainingAgreesWithASlowSearch()
    {
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            Rng rng(seed);
            auto anatomy = decayedBlock();
            for (ColumnLayers& column : anatomy->layers)
                if (column.pulpRoof > column.pulpFloor)
                    column.pulpRoof = static_cast<float>(rng.uniform(-6.5, -4.5));
            Tooth tooth(anatomy);
            for (int hole = 0; hole < 20; ++hole)
                tooth.top[static_cast<std::size_t>(rng.below(64 * 64))] = static_cast<float>(rng.uniform(-4.4, -0.1));
            double slow = 5.0;
            for (std::size_t p = 0; p < tooth.top.size(); ++p)
                for (std::size_t q = 0; q < tooth.top.size() && hasPulp(*anatomy, p); ++q) {
                    if (!(tooth.top[q] < 0.0F))
                        continue;
                    const double over =
                        static_cast<double>(tooth.top[q]) - static_cast<double>(anatomy->layers[p].pulpRoof);
                    const glm::dvec2 way = anatomy->grid.nodeMm(p) - anatomy->grid.nodeMm(q);
                    slow = std::min(slow, std::hypot(way.x, way.y, std::max(0.0, over)));
                }
            QVERIFY2(isNear(grading::measure(tooth).remainingOverPulpMm, slow),
                     qPrintable(QStringLiteral("seed %1").arg(seed)));
        }
    }

    void exposureIsTheAreaCutDownToPulp()
    {
        const grading::Measures m =
            measuresAfter({18, 23, 20, 20}, -5.5F);  // two of the six columns are beside the pulp
        QVERIFY(isNear(m.pulpExposedMm2, 0.04));
        QVERIFY(isNear(removed(m, Material::Pulp), 0.04 * 0.5));
        QCOMPARE(m.remainingOverPulpMm, 0.0);
    }

    void aColumnCutThroughCountsToItsBottom()
    {
        Tooth tooth(decayedBlock());
        cutThrough(tooth, tooth.grid().index(30, 30));
        const grading::Measures m = grading::measure(tooth);
        QVERIFY(isNear(m.deepestCutMm, 10.0));
        QVERIFY(isNear(m.pulpExposedMm2, 0.01));
        QVERIFY(isNear(m.cariesLeftMm3, m.lesionMm3 - 0.02));
        QVERIFY(isNear(m.overcutMm3, 0.01 * (10.0 - 3.0 - 2.0)));
    }

    void aPerforationIsTheAreaOfItsHole()
    {
        Tooth tooth(decayedBlock());
        for (int i = 10; i < 13; ++i)
            cutThrough(tooth, tooth.grid().index(i, 50));
        QVERIFY(isNear(grading::measure(tooth).perforatedMm2, 0.03));
        cut(tooth, {40, 45, 40, 45}, -9.5F);  // deep, but not through
        QVERIFY(isNear(grading::measure(tooth).perforatedMm2, 0.03));

        // Where the ideal goes through the tooth, a hole does not count, nor does a hole connected with it. A hole
        // elsewhere counts.
        auto ideal = std::make_shared<std::vector<float>>(tooth.anatomy->top);
        (*ideal)[tooth.grid().index(11, 50)] = kEmptyTop;
        QVERIFY(isNear(grading::measure(tooth, ideal).perforatedMm2, 0.0));
        cutThrough(tooth, tooth.grid().index(30, 30));
        QVERIFY(isNear(grading::measure(tooth, ideal).perforatedMm2, 0.01));
        QVERIFY(isNear(grading::measure(tooth).perforatedMm2, 0.04));
    }

    void aToothWithoutLesionOrPulpGivesZeros()
    {
        Tooth tooth(support::slab(-2.0F));
        cut(tooth, {10, 20, 10, 20}, -9.0F);
        const grading::Measures m = grading::measure(tooth);
        QCOMPARE(m.lesionMm3, 0.0);
        QCOMPARE(m.cariesLeftPercent, 0.0);
        QCOMPARE(m.largestIslandMm3, 0.0);
        QCOMPARE(m.pulpExposedMm2, 0.0);
        QVERIFY(!m.hasRemainingOverPulp);
        QVERIFY(isNear(m.overcutMm3, 0.01 * 121 * 9.0, 1e-5));
    }

    void volumesAddUpOnRandomCuts()
    {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            Rng rng(seed);
            Tooth tooth(decayedBlock());
            for (float& top : tooth.top)
                top = static_cast<float>(rng.uniform(-9.9, 0.0));
            const grading::Measures m = grading::measure(tooth);
            double slow = 0.0;  // overcut, summed over slices of 10 um
            for (std::size_t k = 0; k < tooth.top.size(); ++k) {
                const ColumnLayers& column = tooth.anatomy->layers[k];
                const bool lesion = column.cariesRoof > column.cariesFloor;
                for (int slice = 0; slice < 1000; ++slice) {
                    const float z = -0.005F - 0.01F * static_cast<float>(slice);
                    const Material material = materialAt(column, z);
                    const bool sound = material == Material::Enamel || material == Material::Dentin;
                    if (z > tooth.top[k] && sound && !(lesion && z > column.cariesFloor))
                        slow += 0.01 * 0.01;
                }
            }
            QVERIFY2(isNear(m.overcutMm3, slow, 0.05), qPrintable(QStringLiteral("seed %1").arg(seed)));
            QVERIFY(isNear(removed(m, Material::Caries) + m.cariesLeftMm3, m.lesionMm3, 1e-4));
            QVERIFY(m.largestIslandMm3 <= m.cariesLeftMm3 + 1e-9);
            QVERIFY(m == grading::measure(tooth));
        }
    }
};

CUSP_TEST(TestMeasures)
#include "tst_measures.moc"
