// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <cmath>

#include "core/base/Rng.h"
#include "core/grading/IdealCavity.h"
#include "core/grading/Measures.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using namespace core::terrain;

namespace {

/// A 64 x 64 block, cell 0.1 mm, top 0, bottom -10: enamel down to -2, pulp from -7 to -5 in the square 20 .. 43, decay
/// from -3 to -1 (roof 1 mm below the top) in the square 28 .. 35.
std::shared_ptr<ToothAnatomy> block()
{
    auto anatomy = support::slab(-2.0F);
    for (int j = 20; j <= 43; ++j)
        for (int i = 20; i <= 43; ++i) {
            anatomy->layers[anatomy->grid.index(i, j)].pulpRoof = -5.0F;
            anatomy->layers[anatomy->grid.index(i, j)].pulpFloor = -7.0F;
        }
    for (int j = 28; j <= 35; ++j)
        for (int i = 28; i <= 35; ++i) {
            anatomy->layers[anatomy->grid.index(i, j)].cariesRoof = -1.0F;
            anatomy->layers[anatomy->grid.index(i, j)].cariesFloor = -3.0F;
        }
    return anatomy;
}

void cut(Tooth& tooth, int lowI, int highI, int lowJ, int highJ, float to)
{
    for (int j = lowJ; j <= highJ; ++j)
        for (int i = lowI; i <= highI; ++i)
            tooth.top[tooth.grid().index(i, j)] = to;
}

bool near(double actual, double expected, double tolerance = 1e-6)
{
    if (std::abs(actual - expected) <= tolerance)
        return true;
    qWarning("%.9g is not %.9g", actual, expected);
    return false;
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
        const auto anatomy = block();
        const grading::IdealTop ideal = grading::idealCavity(*anatomy);
        QVERIFY(ideal != nullptr);
        for (int j = 0; j < 64; ++j)
            for (int i = 0; i < 64; ++i)
                QCOMPARE((*ideal)[anatomy->grid.index(i, j)], i >= 28 && i <= 35 && j >= 28 && j <= 35 ? -3.0F : 0.0F);
        const grading::Measures measures = grading::measure(restored(anatomy, *ideal));
        QCOMPARE(measures.cariesLeftMm3, 0.0);
        QCOMPARE(measures.overcutMm3, 0.0);
        QVERIFY(near(removed(measures, Material::Caries), measures.lesionMm3));
        // Without a lesion nothing is asked; one that goes through leaves nothing.
        QVERIFY(grading::idealCavity(*support::slab(-2.0F)) == nullptr);
        anatomy->layers[anatomy->grid.index(30, 30)].cariesFloor = -20.0F;
        QCOMPARE((*grading::idealCavity(*anatomy))[anatomy->grid.index(30, 30)], kEmptyTop);
        // A lesion outside the tooth is none.
        anatomy->layers[anatomy->grid.index(2, 2)] = {6.0F, 4.0F, -2.0F, 0.0F, 0.0F};
        anatomy->layers[anatomy->grid.index(3, 3)] = {-12.0F, -14.0F, -2.0F, 0.0F, 0.0F};
        const grading::IdealTop again = grading::idealCavity(*anatomy);
        QCOMPARE((*again)[anatomy->grid.index(2, 2)], 0.0F);
        QCOMPARE((*again)[anatomy->grid.index(3, 3)], 0.0F);
    }

    void anUncutToothHasLostNothing()
    {
        const grading::Measures m = grading::measure(Tooth(block()));
        QVERIFY(near(m.lesionMm3, 64 * 0.01 * 2.0));
        QVERIFY(near(m.cariesLeftMm3, m.lesionMm3));
        QVERIFY(near(m.cariesLeftPercent, 100.0));
        QVERIFY(near(m.largestIslandMm3, m.lesionMm3));
        QVERIFY(near(m.accessMm3, 64 * 0.01 * 1.0));
        QCOMPARE(m.overcutMm3, 0.0);
        QCOMPARE(m.deepestCutMm, 0.0);
        QCOMPARE(m.pulpExposedMm2, 0.0);
        QVERIFY(!m.hasRemainingOverPulp);
    }

    void clearingTheLesionExactlyIsNoOvercut()
    {
        Tooth tooth(block());
        cut(tooth, 28, 35, 28, 35, -3.0F);
        const grading::Measures m = grading::measure(tooth);
        QVERIFY(near(m.cariesLeftMm3, 0.0));
        QVERIFY(near(m.overcutMm3, 0.0));
        QVERIFY(near(removed(m, Material::Caries), m.lesionMm3));
        QVERIFY(near(removed(m, Material::Enamel), m.accessMm3));
        QVERIFY(near(m.deepestCutMm, 3.0));
        QVERIFY(m.hasRemainingOverPulp);
        QVERIFY(near(m.remainingOverPulpMm, 2.0));
    }

    void whatLiesBesideAndBelowTheLesionIsOvercut()
    {
        Tooth tooth(block());
        cut(tooth, 27, 35, 28, 35, -3.5F);  // one column wide beside it, half a millimetre below
        const grading::Measures m = grading::measure(tooth);
        QVERIFY(near(m.overcutMm3, 0.01 * (8 * 3.5 + 64 * 0.5)));
        const double sound = removed(m, Material::Enamel) + removed(m, Material::Dentin);
        QVERIFY(near(sound, m.overcutMm3 + m.accessMm3));
    }

    void countsTheLargestIsland()
    {
        Tooth tooth(block());
        cut(tooth, 31, 31, 28, 35, -3.0F);  // a slot: 3 columns of decay on one side, 4 on the other
        const grading::Measures m = grading::measure(tooth);
        QVERIFY(near(m.cariesLeftMm3, 0.01 * 56 * 2.0));
        QVERIFY(near(m.largestIslandMm3, 0.01 * 32 * 2.0));
    }

    void islandsThatDoNotOverlapInHeightAreTwo()
    {
        auto anatomy = block();
        for (int j = 28; j <= 35; ++j)
            for (int i = 32; i <= 35; ++i) {
                anatomy->layers[anatomy->grid.index(i, j)].cariesRoof = -3.5F;
                anatomy->layers[anatomy->grid.index(i, j)].cariesFloor = -4.0F;
            }
        const grading::Measures m = grading::measure(Tooth(anatomy));
        QVERIFY(near(m.largestIslandMm3, 0.01 * 32 * 2.0));
    }

    void remainingIsTheShortestWayInAnyDirection()
    {
        Tooth above(block());
        cut(above, 30, 30, 30, 30, -4.25F);
        QVERIFY(near(grading::measure(above).remainingOverPulpMm, 0.75));

        // A shaft 4 columns beside the pulp, deeper than its roof: sideways counts.
        Tooth beside(block());
        cut(beside, 16, 16, 30, 30, -6.0F);
        QVERIFY(near(grading::measure(beside).remainingOverPulpMm, 0.4));

        // Slanting: 3 columns aside, 0.4 mm above the roof.
        Tooth slanting(block());
        cut(slanting, 17, 17, 30, 30, -4.6F);
        QVERIFY(near(grading::measure(slanting).remainingOverPulpMm, 0.5));

        Tooth far(block());
        cut(far, 0, 0, 0, 0, -0.1F);
        QVERIFY(near(grading::measure(far).remainingOverPulpMm, 5.0));
    }

    void remainingAgreesWithASlowSearch()
    {
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            Rng rng(seed);
            auto anatomy = block();
            for (ColumnLayers& column : anatomy->layers)
                if (column.pulpRoof > column.pulpFloor)
                    column.pulpRoof = static_cast<float>(rng.uniform(-6.5, -4.5));
            Tooth tooth(anatomy);
            for (int hole = 0; hole < 20; ++hole)
                tooth.top[static_cast<std::size_t>(rng.below(64 * 64))] = static_cast<float>(rng.uniform(-4.4, -0.1));
            double slow = 5.0;
            for (int p = 0; p < 64 * 64; ++p) {
                const ColumnLayers& column = anatomy->layers[static_cast<std::size_t>(p)];
                for (int q = 0; q < 64 * 64 && column.pulpRoof > column.pulpFloor; ++q) {
                    if (!(tooth.top[static_cast<std::size_t>(q)] < 0.0F))
                        continue;
                    const double over = static_cast<double>(tooth.top[static_cast<std::size_t>(q)]) -
                                        static_cast<double>(column.pulpRoof);
                    const int rows = p / 64 - q / 64;
                    slow = std::min(slow, std::hypot(0.1 * (p % 64 - q % 64), 0.1 * rows, std::max(0.0, over)));
                }
            }
            QVERIFY2(near(grading::measure(tooth).remainingOverPulpMm, slow),
                     qPrintable(QStringLiteral("seed %1").arg(seed)));
        }
    }

    void exposureIsTheAreaCutDownToPulp()
    {
        Tooth tooth(block());
        cut(tooth, 18, 23, 20, 20, -5.5F);  // two of the six columns lie beside the pulp
        const grading::Measures m = grading::measure(tooth);
        QVERIFY(near(m.pulpExposedMm2, 0.04));
        QVERIFY(near(removed(m, Material::Pulp), 0.04 * 0.5));
        QCOMPARE(m.remainingOverPulpMm, 0.0);
    }

    void aColumnCutThroughCountsToItsBottom()
    {
        Tooth tooth(block());
        tooth.top[tooth.grid().index(30, 30)] = kEmptyTop;
        tooth.bottom[tooth.grid().index(30, 30)] = kEmptyBottom;
        const grading::Measures m = grading::measure(tooth);
        QVERIFY(near(m.deepestCutMm, 10.0));
        QVERIFY(near(m.pulpExposedMm2, 0.01));
        QVERIFY(near(m.cariesLeftMm3, m.lesionMm3 - 0.02));
        QVERIFY(near(m.overcutMm3, 0.01 * (10.0 - 3.0 - 2.0)));
    }

    void aPerforationIsTheAreaOfItsHole()
    {
        Tooth tooth(block());
        const auto goThrough = [&](int i, int j) {
            tooth.top[tooth.grid().index(i, j)] = kEmptyTop;
            tooth.bottom[tooth.grid().index(i, j)] = kEmptyBottom;
        };
        for (int i = 10; i < 13; ++i)
            goThrough(i, 50);
        QVERIFY(near(grading::measure(tooth).perforatedMm2, 0.03));
        cut(tooth, 40, 45, 40, 45, -9.5F);  // deep, not through
        QVERIFY(near(grading::measure(tooth).perforatedMm2, 0.03));

        // Where the ideal goes through, a hole is none, nor is what hangs together with it; one elsewhere is.
        auto ideal = std::make_shared<std::vector<float>>(tooth.anatomy->top);
        (*ideal)[tooth.grid().index(11, 50)] = kEmptyTop;
        QVERIFY(near(grading::measure(tooth, ideal).perforatedMm2, 0.0));
        goThrough(30, 30);
        QVERIFY(near(grading::measure(tooth, ideal).perforatedMm2, 0.01));
        QVERIFY(near(grading::measure(tooth).perforatedMm2, 0.04));
    }

    void aToothWithoutLesionOrPulpGivesZeros()
    {
        auto anatomy = block();
        anatomy->layers.assign(anatomy->grid.count(), ColumnLayers{0.0F, 0.0F, -2.0F, 0.0F, 0.0F});
        Tooth tooth(anatomy);
        cut(tooth, 10, 20, 10, 20, -9.0F);
        const grading::Measures m = grading::measure(tooth);
        QCOMPARE(m.lesionMm3, 0.0);
        QCOMPARE(m.cariesLeftPercent, 0.0);
        QCOMPARE(m.largestIslandMm3, 0.0);
        QCOMPARE(m.pulpExposedMm2, 0.0);
        QVERIFY(!m.hasRemainingOverPulp);
        QVERIFY(near(m.overcutMm3, 0.01 * 121 * 9.0, 1e-5));
    }

    void volumesAddUpOnRandomCuts()
    {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            Rng rng(seed);
            Tooth tooth(block());
            for (float& top : tooth.top)
                top = static_cast<float>(rng.uniform(-9.9, 0.0));
            const grading::Measures m = grading::measure(tooth);
            double slow = 0.0;  // overcut, counted in slices of 10 um
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
            QVERIFY2(near(m.overcutMm3, slow, 0.05), qPrintable(QStringLiteral("seed %1").arg(seed)));
            QVERIFY(near(removed(m, Material::Caries) + m.cariesLeftMm3, m.lesionMm3, 1e-4));
            QVERIFY(m.largestIslandMm3 <= m.cariesLeftMm3 + 1e-9);
            QVERIFY(m == grading::measure(tooth));
        }
    }
};

QTEST_GUILESS_MAIN(TestMeasures)
#include "tst_measures.moc"
