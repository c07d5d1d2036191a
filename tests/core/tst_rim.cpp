// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <QTest>

#include <glm/geometric.hpp>

#include "core/base/Rng.h"
#include "core/terrain/Rim.h"
#include "core/terrain/Tooth.h"

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
    void averagesTopsAndBottomsOfItsNeighbours();
    void everySquareThatTouchesTheToothHasFourHeights();
    void patchingARectangleEqualsSewingAnew();
    void steepNormalBorrowsFromTheNearestGentleOne();
    void farFromTheSeamNothingChanges();
};

void TestRim::averagesTopsAndBottomsOfItsNeighbours()
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

void TestRim::everySquareThatTouchesTheToothHasFourHeights()
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

void TestRim::patchingARectangleEqualsSewingAnew()
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

void TestRim::steepNormalBorrowsFromTheNearestGentleOne()
{
    Maps maps;
    for (int j = 10; j < 50; ++j)
        for (int i = 10; i < 50; ++i)
            maps.fill(i, j, -2.0F, 0.0F);
    std::vector<float> sewn;
    sewRim(maps.grid, maps.top, maps.bottom, wholeOf(maps.grid), sewn);
    const glm::vec3 gentle = glm::normalize(glm::vec3(0.3F, 0.2F, 0.9F));
    const glm::vec3 steep = glm::normalize(glm::vec3(-0.9F, 0.5F, 0.1F));
    std::vector<glm::vec3> normals(maps.grid.count(), glm::vec3(0.0F));
    for (int j = 9; j <= 50; ++j)
        for (int i = 9; i <= 50; ++i)
            normals[maps.grid.index(i, j)] = i <= 10 ? steep : gentle;
    const std::size_t changed = repairRimNormals(maps.grid, sewn, wholeOf(maps.grid), normals);
    QCOMPARE(changed, std::size_t(2 * 42));
    const glm::vec3 repaired = normals[maps.grid.index(9, 30)];
    QVERIFY(std::abs(glm::length(repaired) - 1.0F) < 1e-6F);
    QVERIFY(glm::length(repaired - glm::normalize(glm::vec3(gentle.x, gentle.y, steep.z))) < 1e-6F);
    QVERIFY(normals[maps.grid.index(30, 30)] == gentle);
    QVERIFY(normals[maps.grid.index(2, 2)] == glm::vec3(0.0F));  // no surface, no normal
}

void TestRim::farFromTheSeamNothingChanges()
{
    Maps maps;
    for (int j = 10; j < 50; ++j)
        for (int i = 10; i < 50; ++i)
            maps.fill(i, j, -2.0F, 0.0F);
    std::vector<float> sewn;
    sewRim(maps.grid, maps.top, maps.bottom, wholeOf(maps.grid), sewn);
    const glm::vec3 steep(1.0F, 0.0F, 0.0F);
    std::vector<glm::vec3> normals(maps.grid.count(), glm::vec3(0.0F, 0.0F, 1.0F));
    normals[maps.grid.index(30, 30)] = steep;  // a real wall inside the tooth
    QCOMPARE(repairRimNormals(maps.grid, sewn, wholeOf(maps.grid), normals), std::size_t(0));
    QVERIFY(normals[maps.grid.index(30, 30)] == steep);
}

QTEST_APPLESS_MAIN(TestRim)
#include "tst_rim.moc"
