// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the voxel model with closed forms and with the height stack, as it is in the charts.
#include <QTest>

#include <cmath>
#include <numbers>
#include <numeric>

#include <glm/common.hpp>

#include "core/teeth/ToothBuilder.h"
#include "lab/Block.h"
#include "lab/ModelCost.h"
#include "lab/VoxelTooth.h"
#include "tests/support/Suite.h"

namespace {

double sum(const core::terrain::PerMaterial& mm3)
{
    return std::accumulate(mm3.begin(), mm3.end(), 0.0);
}

const core::bur::Bur& burNamed(const char* id)
{
    return core::bur::burs()[core::bur::findBur(id).value()];
}

std::shared_ptr<const core::terrain::ToothAnatomy> tooth36(int side)
{
    core::teeth::BuildOptions options;
    options.gridSide = side;
    return core::teeth::buildTooth({36}, options)->anatomy;
}

}  // namespace

class TestVoxelTooth : public QObject
{
    Q_OBJECT
private slots:
    void aBallSunkByItsRadiusTakesHalfASphere()
    {
        const lab::VoxelBur ball(burNamed("2"));
        constexpr int kLies = 16;
        constexpr double kCellMm = lab::kBlockExtentMm / 150;
        const double radius = ball.radiusMm();
        const double right = 2.0 / 3.0 * std::numbers::pi * radius * radius * radius;
        double mean = 0.0;
        for (int lie = 0; lie < kLies; ++lie) {
            // The surface is at any height within the cubes, and the bur anywhere above them.
            const glm::dvec3 part = glm::fract(glm::dvec3(0.8192, 0.6710, 0.5497) * (lie + 0.5)) * kCellMm;
            lab::VoxelTooth tooth(*lab::enamelBlock([&](glm::dvec2) { return part.z; }, 150));
            const glm::dvec3 tip(part.x, part.y, part.z - radius);
            const core::terrain::PerMaterial gone = tooth.remove(ball, tip);
            QVERIFY(gone[static_cast<std::size_t>(core::terrain::Material::Enamel)] > 0.0);
            QCOMPARE(gone[static_cast<std::size_t>(core::terrain::Material::Dentin)], 0.0);
            // The tolerance is half a layer of cubes at the surface, and the staircase of the sphere.
            QVERIFY2(std::abs(sum(gone) / right - 1.0) < 0.12, qPrintable(QString::number(sum(gone) / right - 1.0)));
            mean += sum(gone) / kLies;
        }
        QVERIFY2(std::abs(mean / right - 1.0) < 0.01, qPrintable(QString::number(mean / right - 1.0)));
    }

    void contactBeginsAtTheSurfaceAndEndsWithRemoval()
    {
        const auto block = lab::enamelBlock([](glm::dvec2) { return 0.0; }, 150);
        lab::VoxelTooth tooth(*block);
        const lab::VoxelBur fissure(burNamed("57"));
        const double before = tooth.volumeMm3();
        QCOMPARE(tooth.overlap(fissure, {0.0, 0.0, 0.001}), std::size_t{0});
        const std::size_t there = tooth.overlap(fissure, {0.0, 0.0, -0.3});
        QVERIFY(there > 0);
        const double gone = sum(tooth.remove(fissure, {0.0, 0.0, -0.3}));
        const double cube = std::pow(block->grid.cellMm, 3.0);
        QVERIFY(std::abs(gone - static_cast<double>(there) * cube) < 1.0e-9);
        QVERIFY(std::abs(before - tooth.volumeMm3() - gone) < 1.0e-6);
        QCOMPARE(tooth.overlap(fissure, {0.0, 0.0, -0.3}), std::size_t{0});
    }

    void whatIsAboveABallStays()
    {
        // A ball that sinks 2 mm and moves aside by more than its radius leaves a roof above its path. A height map
        // cannot represent that.
        const auto block = lab::enamelBlock([](glm::dvec2) { return 0.0; }, 150);
        lab::VoxelTooth tooth(*block);
        const lab::VoxelBur ball(burNamed("2"));
        for (double z = 0.0; z > -2.0; z -= 0.02)
            static_cast<void>(tooth.remove(ball, {0.0, 0.0, z}));
        for (double x = 0.0; x < 1.0; x += 0.02)
            static_cast<void>(tooth.remove(ball, {x, 0.0, -2.0}));
        const lab::VoxelBur fissure(burNamed("57"));
        QVERIFY(tooth.overlap(fissure, {1.0, 0.0, -0.9}) > 0);
        QCOMPARE(tooth.overlap(ball, {0.7, 0.0, -2.0}), std::size_t{0});
    }

    void volumesAreThoseOfTheHeightStack()
    {
        const auto anatomy = tooth36(150);
        const double heights = sum(core::terrain::volumes(core::terrain::Tooth(anatomy)));
        const double voxels = lab::VoxelTooth(*anatomy).volumeMm3();
        QVERIFY2(std::abs(voxels / heights - 1.0) < 0.01,
                 qPrintable(QString("%1 and %2 mm3").arg(voxels).arg(heights)));
    }

    void slotsTakeWhatTheHeightStackLoses()
    {
        const auto anatomy = tooth36(150);
        const std::size_t fissure = core::bur::findBur("57").value();
        const lab::ModelCost heights = lab::millHeightStack(anatomy, fissure);
        const lab::ModelCost voxels = lab::millVoxels(*anatomy, fissure);
        for (std::size_t k = 0; k < lab::kSlots; ++k)
            QVERIFY2(
                std::abs(voxels.removedMm3[k] / heights.removedMm3[k] - 1.0) < 0.02,
                qPrintable(
                    QString("slot %1: %2 and %3 mm3").arg(k).arg(voxels.removedMm3[k]).arg(heights.removedMm3[k])));
        QVERIFY(voxels.bytes > heights.bytes);
        QVERIFY(lab::volumeErrorPercent(voxels, heights) < 2.0);
        QCOMPARE(lab::volumeErrorPercent(heights, heights), 0.0);
    }
};

CUSP_TEST(TestVoxelTooth)
#include "tst_voxel_tooth.moc"
