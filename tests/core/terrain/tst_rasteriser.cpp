// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>

#include <QTest>

#include <glm/common.hpp>

#include "core/base/Rng.h"
#include "core/terrain/Rasteriser.h"
#include "core/terrain/Tooth.h"
#include "tests/support/Checks.h"
#include "tests/support/Scenes.h"
#include "tests/support/Solids.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"

using namespace core::terrain;
using core::mesh::TriangleMesh;
using support::kPi;

namespace {

Grid gridAround(const TriangleMesh& mesh, int side)
{
    glm::dvec2 low(1.0e9);
    glm::dvec2 high(-1.0e9);
    for (const glm::vec3& v : mesh.vertices) {
        low = glm::min(low, glm::dvec2(v.x, v.y));
        high = glm::max(high, glm::dvec2(v.x, v.y));
    }
    return fitGrid(low, high, side);
}

double silhouetteOf(const HeightMaps& maps)
{
    return std::accumulate(maps.areaMm2.begin(), maps.areaMm2.end(), 0.0);
}

/// A slow reference: tests every triangle at every node by the signs of three determinants in long double, edges
/// included.
std::optional<std::pair<double, double>> heightsAt(const TriangleMesh& mesh, glm::dvec2 p)
{
    double top = -1.0e9;
    double bottom = 1.0e9;
    for (const auto& t : mesh.triangles) {
        long double w[3];
        long double area = 0.0L;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3& a = mesh.vertices[t[(k + 1) % 3]];
            const glm::vec3& b = mesh.vertices[t[(k + 2) % 3]];
            w[k] = (static_cast<long double>(b.x) - a.x) * (p.y - a.y) -
                   (static_cast<long double>(b.y) - a.y) * (p.x - a.x);
            area += w[k];
        }
        if (area == 0.0L || w[0] * area < 0.0L || w[1] * area < 0.0L || w[2] * area < 0.0L)
            continue;
        const auto z = static_cast<double>(
            (w[0] * mesh.vertices[t[0]].z + w[1] * mesh.vertices[t[1]].z + w[2] * mesh.vertices[t[2]].z) / area);
        top = std::max(top, z);
        bottom = std::min(bottom, z);
    }
    return top >= bottom ? std::optional(std::pair(top, bottom)) : std::nullopt;
}

}  // namespace

class TestRasteriser : public QObject
{
    Q_OBJECT

private slots:
    void volumeWithinHalfAPercent_data()
    {
        support::columns<TriangleMesh, double>("mesh", "volume");
        const double pi = kPi;
        // Sizes and positions share no factor with the cell, so that nothing is aligned with the grid.
        for (const double angle : {0.0, 0.1, 0.5, pi / 4}) {
            const auto add = [&](const char* name, const TriangleMesh& mesh, double volume) {
                QTest::addRow("%s turned by %.2f", name, angle)
                    << support::moved(support::turned(mesh, angle), {1.2345F, -0.777F, 0.3F}) << volume;
            };
            add("box", support::box(10.0F, 6.1F, 3.7F), 10.0 * 6.1 * 3.7);
            add("cone", support::cone(4.3F, 5.1F), pi * 4.3 * 4.3 * 5.1 / 3.0);
            add("hemisphere", support::sphereCap(4.7F, 4.7F), 2.0 / 3.0 * pi * 4.7 * 4.7 * 4.7);
            add("flat cap", support::sphereCap(9.0F, 1.3F), pi * 1.3 * 1.3 * (9.0 - 1.3 / 3.0));
            add("wedge", support::wedge(9.1F, 7.3F, 4.2F), 9.1 * 7.3 * 4.2 / 2.0);
        }
    }

    void volumeWithinHalfAPercent()
    {
        QFETCH(TriangleMesh, mesh);
        QFETCH(double, volume);
        const HeightMaps maps = rasterise(mesh, gridAround(mesh, 150));
        const double percent = 100.0 * (volumeOf(maps) / volume - 1.0);
        QVERIFY2(std::abs(percent) < 0.5, qPrintable(QString::number(percent)));
    }

    void gridHasItsMarginAndHoldsTheMesh()
    {
        for (const int side : {64, 150, 1024}) {
            const Grid grid = fitGrid({-3.0, 2.0}, {7.0, 5.0}, side);
            QCOMPARE(grid.side, side);
            const glm::dvec2 low = grid.latticeOf({-3.0, 2.0});
            const glm::dvec2 high = grid.latticeOf({7.0, 5.0});
            QVERIFY(std::abs(low.x - kGridMargin) < 1e-9);
            QVERIFY(std::abs(high.x - (side - 1 - kGridMargin)) < 1e-9);
            QVERIFY(low.y >= kGridMargin && high.y <= side - 1 - kGridMargin);
            QVERIFY(std::abs(low.y + high.y - (side - 1)) < 1e-9);  // in the middle
        }
    }

    void heightIsThePlaneOfTheCoveringTriangle()
    {
        core::Rng rng(20261120);
        for (int round = 0; round < 20; ++round) {
            TriangleMesh mesh;
            for (int k = 0; k < 60; ++k)
                mesh.vertices.emplace_back(rng.uniform(0.0, 8.0), rng.uniform(0.0, 8.0), rng.uniform(-5.0, 5.0));
            const auto corner = [&] { return static_cast<std::uint32_t>(rng.below(60)); };
            for (int k = 0; k < 40; ++k)
                mesh.triangles.push_back({corner(), corner(), corner()});
            const HeightMaps maps = rasterise(mesh, gridAround(mesh, 64));
            support::eachNode(maps.grid, [&](std::size_t k, const glm::dvec2& at) {
                const auto expected = heightsAt(mesh, at);
                if (!expected || expected->first - expected->second < 1e-4)
                    return;  // a single sheet has no volume
                QVERIFY(std::abs(static_cast<double>(maps.top[k]) - expected->first) < 2e-5);
                QVERIFY(std::abs(static_cast<double>(maps.bottom[k]) - expected->second) < 2e-5);
            });
        }
    }

    void everyNodeOfAFineRandomMeshIsCovered()
    {
        // A sheet of 300 x 300 jittered squares: many nodes are close to edges and corners.
        core::Rng rng(7);
        constexpr int n = 300;
        TriangleMesh mesh;
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                const bool edge = i == 0 || j == 0 || i == n || j == n;
                const double dx = edge ? 0.0 : rng.uniform(-0.012, 0.012);
                const double dy = edge ? 0.0 : rng.uniform(-0.012, 0.012);
                mesh.vertices.emplace_back(i * 0.03 + dx, j * 0.03 + dy, 1.0 + rng.uniform(0.0, 0.01));
            }
        const auto at = [](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        for (const int side : {64, 150, 500}) {
            const HeightMaps maps = rasterise(mesh, gridAround(mesh, side), 0.0);
            // Leaves out the nodes on the rim of the sheet, because it is undefined which of them belong to it.
            const int last = side - kGridMargin - 2;
            support::eachOf(maps.grid, {kGridMargin + 1, last, kGridMargin + 1, last}, [&](std::size_t k) {
                QVERIFY2(maps.top[k] > 0.99F && maps.bottom[k] == 0.0F, qPrintable(QString::number(k)));
            });
        }
    }

    void nodesOnSharedEdgesAndCornersAreNotMissed()
    {
        // Sixty-four thin slices whose tip is a node and whose edges run through nodes.
        const Grid grid{64, 0.125, {-4.0, -4.0}};
        TriangleMesh mesh;
        mesh.vertices.emplace_back(0.0F, 0.0F, 1.0F);
        mesh.vertices.emplace_back(0.0F, 0.0F, 0.0F);
        constexpr std::uint32_t n = 64;
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::uint32_t side = k / 16;
            const float along = -2.0F + 0.25F * static_cast<float>(k % 16);
            const glm::vec2 p = side == 0   ? glm::vec2(along, -2.0F)
                                : side == 1 ? glm::vec2(2.0F, along)
                                : side == 2 ? glm::vec2(-along, 2.0F)
                                            : glm::vec2(-2.0F, -along);
            mesh.vertices.emplace_back(p.x, p.y, 1.0F);
            mesh.vertices.emplace_back(p.x, p.y, 0.0F);
        }
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::uint32_t a = 2 + 2 * k;
            const std::uint32_t b = 2 + 2 * ((k + 1) % n);
            mesh.triangles.push_back({0, a, b});
            mesh.triangles.push_back({1, b + 1, a + 1});
        }
        const HeightMaps maps = rasterise(mesh, grid);
        support::eachNode(grid, [&](std::size_t k, const glm::dvec2& p) {
            const bool inside = std::abs(p.x) <= 2.0 && std::abs(p.y) <= 2.0;
            QCOMPARE(maps.top[k], inside ? 1.0F : kEmptyTop);
            QCOMPARE(maps.bottom[k], inside ? 0.0F : kEmptyBottom);
        });
    }

    void areaIsTheSilhouette()
    {
        const double pi = kPi;
        for (const double angle : {0.0, 0.3, 0.7}) {
            const auto area = [&](const TriangleMesh& mesh, int side) {
                const TriangleMesh t = support::turned(mesh, angle);
                return silhouetteOf(rasterise(t, gridAround(t, side)));
            };
            QVERIFY(std::abs(area(support::box(8.3F, 5.9F, 2.0F), 150) / (8.3 * 5.9) - 1.0) < 0.002);
            QVERIFY(std::abs(area(support::sphereCap(5.0F, 5.0F), 150) / (pi * 25.0) - 1.0) < 0.002);
            QVERIFY(std::abs(area(support::sphereCap(5.0F, 5.0F), 64) / (pi * 25.0) - 1.0) < 0.005);
        }
        const TriangleMesh cap = support::sphereCap(5.0F, 5.0F);
        const HeightMaps maps = rasterise(cap, gridAround(cap, 150));
        const auto cell = static_cast<float>(maps.grid.cellMm * maps.grid.cellMm);
        for (std::size_t k = 0; k < maps.top.size(); ++k) {
            const bool isSolid = maps.top[k] > maps.bottom[k];
            QCOMPARE(maps.areaMm2[k] > 0.0F, isSolid);
            QVERIFY(maps.areaMm2[k] < 3.0F * cell);
            QVERIFY(isSolid || (maps.top[k] == kEmptyTop && maps.bottom[k] == kEmptyBottom));
        }
        QCOMPARE(maps.areaMm2[maps.grid.index(75, 75)], cell);
    }

    void verticalSheetAloneGivesNothing()
    {
        TriangleMesh mesh = support::box(4.0F, 4.0F, 1.0F);
        mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 4);  // only the walls are left
        const HeightMaps maps = rasterise(mesh, gridAround(mesh, 64));
        QCOMPARE(volumeOf(maps), 0.0);
        QCOMPARE(silhouetteOf(maps), 0.0);
    }

    void openBowlIsClosedAtTheGivenHeight()
    {
        const TriangleMesh mesh = support::withoutBase(support::box(4.0F, 3.0F, 2.0F));
        QCOMPARE(volumeOf(rasterise(mesh, gridAround(mesh, 100))), 0.0);
        QVERIFY(std::abs(volumeOf(rasterise(mesh, gridAround(mesh, 100), 0.0)) - 24.0) < 0.1);
        QVERIFY(std::abs(volumeOf(rasterise(mesh, gridAround(mesh, 100), 1.0)) - 12.0) < 0.05);
    }

    void overhangKeepsItsUndersideBesideAnOpening()
    {
        // The upper part of a ball, cut off 1 below its equator and open there.
        const TriangleMesh mesh = support::withoutBase(support::sphereCap(3.0F, 4.0F, 360, 100));
        const auto rim = static_cast<double>(mesh.vertices.front().z);
        const HeightMaps maps = rasterise(mesh, gridAround(mesh, 150), rim);
        const double exact = kPi * 16.0 * (3.0 - 4.0 / 3.0);
        QVERIFY2(std::abs(volumeOf(maps) / exact - 1.0) < 0.005, qPrintable(QString::number(volumeOf(maps))));
        support::eachNode(maps.grid, [&](std::size_t k, const glm::dvec2& at) {
            const double aside = std::hypot(at.x, at.y);
            if (maps.top[k] == kEmptyTop || std::abs(aside - std::sqrt(8.0)) < 0.02 || aside > 2.97)
                return;
            const double expected = aside < std::sqrt(8.0) ? rim : rim + 1.0 - std::sqrt(9.0 - aside * aside);
            QVERIFY(std::abs(static_cast<double>(maps.bottom[k]) - expected) < 0.02);
        });
    }
};

CUSP_TEST(TestRasteriser)
#include "tst_rasteriser.moc"
