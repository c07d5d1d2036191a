// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <cmath>

#include "lessons/GridSensitivity.h"
#include "lessons/LessonCatalog.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Trials.h"

using namespace lessons;

namespace {

/// Returns a lesson in which only the removed volume costs points.
Assignment volumeAlone(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, double spanMm3)
{
    Assignment assignment = practiceOn(anatomy).value();
    assignment.rubric.criteria.resize(1);
    assignment.rubric.criteria[0].measure = "removed_mm3";
    assignment.rubric.criteria[0].tolerance = 0.0;
    assignment.rubric.criteria[0].span = spanMm3;
    assignment.rubric.criteria[0].weightTenths = 1000;
    return assignment;
}

}  // namespace

class TestGridNoise : public QObject
{
    Q_OBJECT

private slots:
    void smoothWorkHardlyDependsOnTheGrid()
    {
        const auto anatomy = support::wavyDisc(150, 0.07);
        Assignment assignment = practiceOn(anatomy).value();
        assignment.rubric.criteria.resize(2);
        assignment.rubric.criteria[0].measure = "removed_mm3";
        assignment.rubric.criteria[0].tolerance = 0.0;
        assignment.rubric.criteria[0].span = 10.0;
        assignment.rubric.criteria[1].measure = "deepest_cut_mm";
        assignment.rubric.criteria[1].tolerance = 0.0;
        assignment.rubric.criteria[1].allowance.reset();
        assignment.rubric.criteria[1].span = 4.0;
        const GridSensitivity noise = gridNoise(assignment, support::hollowed(anatomy, 1.2)).value();
        QVERIFY(noise.own.totalTenths > 100 && noise.own.totalTenths < 900);
        QVERIFY(noise.twice.has_value());
        QVERIFY(std::abs(noise.half.totalTenths - noise.own.totalTenths) <= 8);
        QVERIFY(std::abs(noise.twice->totalTenths - noise.own.totalTenths) <= 4);
    }

    /// A scratch one cell wide is either on a node of the coarse grid or between two: its volume doubles or vanishes.
    void aCutUnderOneCellDoes()
    {
        const auto anatomy = support::wavyDisc(150, 0.07);
        const Assignment assignment = volumeAlone(anatomy, 1.0);
        for (const int row : {74, 75}) {
            std::vector<float> top = anatomy->top;
            for (int i = 60; i < 90; ++i)
                top[anatomy->grid.index(i, row)] -= 1.0F;
            const GridSensitivity noise = gridNoise(assignment, core::terrain::restored(anatomy, top)).value();
            const int lost = 1000 - noise.own.totalTenths;
            QVERIFY(lost > 100);
            QCOMPARE(1000 - noise.half.totalTenths > 3 * lost / 2, row == 74);
            if (row == 75)
                QCOMPARE(noise.half.totalTenths, 1000);
            QVERIFY(std::abs(1000 - noise.twice->totalTenths - lost) < lost / 5);
        }
    }

    void itSaysWhenThePassMarkLiesBetween()
    {
        const auto anatomy = support::wavyDisc(150, 0.07);
        Assignment assignment = volumeAlone(anatomy, 10.0);
        std::vector<float> top = support::hollowed(anatomy, 1.2).top;
        for (int i = 40; i < 110; ++i)
            top[anatomy->grid.index(i, 20)] -= 1.0F;  // the coarse grid counts this row twice
        const core::terrain::Tooth tooth = core::terrain::restored(anatomy, top);
        const GridSensitivity first = gridNoise(assignment, tooth).value();
        QVERIFY(first.half.totalTenths < first.own.totalTenths - 10);
        assignment.rubric.passMarkTenths = first.own.totalTenths - 5;
        const GridSensitivity near = gridNoise(assignment, tooth).value();
        QVERIFY(near.own.passed && !near.half.passed && near.isUncertain());
        assignment.rubric.passMarkTenths = first.half.totalTenths - 50;
        QVERIFY(!gridNoise(assignment, tooth)->isUncertain());
    }

    /// A perfect preparation passes on every grid.
    void idealWorkStaysGoodAtEveryGrid()
    {
        const Conduct blameless;
        int lesson = 0;
        for (const CatalogEntry& entry : readCatalog({})) {
            if (!entry.read.lesson || entry.read.lesson->task == Task::RemoveDecay ||
                isExercise(entry.read.lesson->task) || !support::isTried(lesson++))
                continue;
            const Assignment assignment = assign(*entry.read.lesson).value().assignment;
            const GridSensitivity noise =
                gridNoise(assignment, core::terrain::restored(assignment.anatomy, *assignment.ideal->top), blameless)
                    .value();
            QCOMPARE(noise.own.totalTenths, 1000);
            QVERIFY(!noise.isUncertain());
        }
    }

    void theLargestGridHasNoDouble()
    {
        const auto anatomy = support::wavyDisc(600, 0.0175);
        const Assignment assignment = practiceOn(anatomy).value();
        QVERIFY(!gridNoise(assignment, support::hollowed(anatomy, 1.0))->twice.has_value());
    }
};

CUSP_TEST(TestGridNoise)
#include "tst_grid_sensitivity.moc"
