// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <QTest>

#include <glm/geometric.hpp>

#include "core/base/Rng.h"
#include "core/terrain/Rim.h"
#include "core/terrain/Tooth.h"
#include "tests/support/Suite.h"

using namespace core::terrain;

namespace {

struct Maps
{
    Grid grid{64, 0.1, {0.0, 0.0}};
    std::vector<float> top = std::vector<float>(grid.count(), kEmptyTop);
    std::vector<float> bottom = std::vector<float>(grid.count(), kEmptyBottom);

    void fill(int i, int j, float low, float high)
    {
        top[grid.index(i, j)] = high;
        bottom[grid.index(i, j)] = low;
    }
    void empty(int i, int j) { fill(i, j, kEmptyBottom, kEmptyTop); }
    [[nodiscard]] bool solid(int i, int j) const
    {
        return grid.contains(i, j) && top[grid.index(i, j)] > bottom[grid.index(i, j)];
    }
};

}  // namespace

class TestRim : public QObject
{
    Q_OBJECT

private slots:
    void averagesTopsAndBottomsOfItsNeighbours()
    {
        Maps maps;
        maps.fill(10, 10, 1.0F, 3.0F);
        maps.fill(11, 10, 2.0F, 6.0F);
        std::vector<float> sewn;
        QCOMPARE(sewRim(maps.grid, maps.top, maps.bottom, wholeOf(maps.grid), sewn), std::size_t(10));
        QCOMPARE(sewn[maps.grid.index(9, 10)], 2.0F);
        QCOMPARE(sewn[maps.grid.index(12, 10)], 4.0F);
        QCOMPARE(sewn[maps.grid.index(10, 11)], 3.0F);
        QCOMPARE(sewn[maps.grid.index(10, 10)], kEmptyTop);  // solid
        QCOMPARE(sewn[maps.grid.index(30, 30)], kEmptyTop);  // far away
    }

    void everySquareThatTouchesTheToothHasFourHeights()
    {
        core::Rng rng(3);
        Maps maps;
        for (int k = 0; k < 400; ++k)
            maps.fill(rng.below(64), rng.below(64), -1.0F, static_cast<float>(rng.uniform()));
        std::vector<float> sewn;
        sewRim(maps.grid, maps.top, maps.bottom, wholeOf(maps.grid), sewn);
        for (int j = 0; j + 1 < 64; ++j)
            for (int i = 0; i + 1 < 64; ++i) {
                const bool touches =
                    maps.solid(i, j) || maps.solid(i + 1, j) || maps.solid(i, j + 1) || maps.solid(i + 1, j + 1);
                for (int corner = 0; touches && corner < 4; ++corner) {
                    const int ci = i + corner % 2;
                    const int cj = j + corner / 2;
                    QVERIFY(maps.solid(ci, cj) != (sewn[maps.grid.index(ci, cj)] != kEmptyTop));
                }
            }
    }

    void patchingARectangleEqualsSewingAnew()
    {
        core::Rng rng(11);
        Maps maps;
        for (int j = 5; j < 60; ++j)
            for (int i = 5; i < 60; ++i)
                maps.fill(i, j, -2.0F, static_cast<float>(rng.uniform()));
        std::vector<float> patched;
        sewRim(maps.grid, maps.top, maps.bottom, wholeOf(maps.grid), patched);
        for (int round = 0; round < 50; ++round) {
            const int i = rng.below(56);
            const int j = rng.below(56);
            const NodeRect hole{i, j, i + 1 + rng.below(7), j + 1 + rng.below(7)};
            for (int b = hole.beginJ; b < hole.endJ; ++b)
                for (int a = hole.beginI; a < hole.endI; ++a)
                    maps.empty(a, b);
            sewRim(maps.grid, maps.top, maps.bottom, hole, patched);
            std::vector<float> anew;
            sewRim(maps.grid, maps.top, maps.bottom, wholeOf(maps.grid), anew);
            QVERIFY(patched == anew);
        }
    }

    void steepNormalsAreCalmed()
    {
        // A steep ring whose normals are disturbed as by the lattice.
        const Grid grid{64, 0.1, {0.0, 0.0}};
        core::Rng rng(7);
        std::vector<glm::vec3> truth(grid.count(), glm::vec3(0.0F));
        std::vector<glm::vec3> shaken = truth;
        const auto shake = [&] { return 0.01F * static_cast<float>(rng.below(101) - 50); };
        for (int j = 0; j < 64; ++j)
            for (int i = 0; i < 64; ++i) {
                const glm::vec2 away(static_cast<float>(i) - 31.5F, static_cast<float>(j) - 31.5F);
                if (glm::length(away) < 18.0F || glm::length(away) > 24.0F)
                    continue;
                const std::size_t k = grid.index(i, j);
                truth[k] = glm::normalize(glm::vec3(glm::normalize(away), 0.25F));
                shaken[k] = glm::normalize(truth[k] + glm::vec3(shake(), shake(), 0.2F * shake()));
            }
        std::vector<glm::vec3> calm(grid.count(), glm::vec3(0.0F));
        calmSteepNormals(grid, shaken, wholeOf(grid), calm);
        float before = 0.0F;
        float after = 0.0F;
        for (std::size_t k = 0; k < grid.count(); ++k) {
            before += glm::distance(shaken[k], truth[k]);
            after += glm::distance(calm[k], truth[k]);
            QVERIFY(truth[k] == glm::vec3(0.0F) ? calm[k] == glm::vec3(0.0F)
                                                : std::abs(glm::length(calm[k]) - 1.0F) < 1e-5F);
        }
        QVERIFY2(after < 0.35F * before, qPrintable(QString("%1 of %2").arg(after).arg(before)));
    }

    void gentleNormalsStayAsTheyAre()
    {
        const Grid grid{16, 0.1, {0.0, 0.0}};
        core::Rng rng(3);
        std::vector<glm::vec3> normals;
        for (std::size_t k = 0; k < grid.count(); ++k)
            normals.push_back(glm::normalize(glm::vec3(rng.below(3) - 1, rng.below(3) - 1, 2)));
        normals[grid.index(8, 8)] = {1.0F, 0.0F, 0.0F};
        std::vector<glm::vec3> calm = normals;
        calmSteepNormals(grid, normals, wholeOf(grid), calm);
        QVERIFY2(calm == normals, "one wall alone has nobody to borrow from, and the rest is not steep");
    }

    void theWallsOfASlitDoNotMix()
    {
        const Grid grid{16, 0.1, {0.0, 0.0}};
        std::vector<glm::vec3> normals(grid.count(), glm::vec3(0.0F, 0.0F, 1.0F));
        for (int j = 0; j < 16; ++j) {
            normals[grid.index(7, j)] = glm::normalize(glm::vec3(1.0F, 0.0F, 0.1F));
            normals[grid.index(8, j)] = glm::normalize(glm::vec3(-1.0F, 0.0F, 0.1F));
        }
        std::vector<glm::vec3> calm(grid.count(), glm::vec3(0.0F));
        calmSteepNormals(grid, normals, {4, 4, 12, 12}, calm);
        for (const int i : {7, 8})
            QVERIFY(glm::distance(calm[grid.index(i, 8)], normals[grid.index(i, 8)]) < 1e-5F);
        QVERIFY2(calm[grid.index(7, 2)] == glm::vec3(0.0F), "outside the rectangle nothing is written");
    }
};

CUSP_TEST(TestRim)
#include "tst_rim.moc"
