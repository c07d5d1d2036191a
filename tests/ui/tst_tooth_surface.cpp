// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <map>
#include <thread>

#include <glm/geometric.hpp>

#include <QTest>

#include "core/servo/ServoState.h"
#include "core/teeth/ToothBuilder.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticMolar.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"
#include "tests/ui/Pictures.h"
#include "ui/render/SolidMesh.h"
#include "ui/render/ToothSurface.h"
#include "ui/render/WholeSurface.h"
#include "ui/tooth/Camera.h"
#include "ui/tooth/Viewpoint.h"

using core::servo::kTileSide;
using core::servo::TilePatch;
using core::terrain::NodeRect;
using core::terrain::ToothAnatomy;
using pictures::cutTile;
using support::near;
using ui::render::Ray;
using ui::render::ToothSurface;
using ui::tooth::Camera;

namespace {

const glm::vec3 kLight = glm::normalize(glm::vec3(-0.4F, 0.4F, 0.8F));

/// Returns the number of edges of the drawn triangles that do not occur twice. Upper and lower surface are taken
/// together, and nodes are distinguished by height.
int openEdges(const ToothSurface& surface)
{
    std::map<std::array<std::pair<std::uint32_t, float>, 2>, int> edges;
    const auto& indices = surface.indices();
    for (std::size_t tile = 0; tile < surface.indexCounts().size(); ++tile) {
        const std::size_t first = tile * ToothSurface::kTileIndices;
        for (std::size_t k = first; k < first + static_cast<std::size_t>(surface.indexCounts()[tile]); k += 3) {
            for (const auto* heights : {&surface.tops(), &surface.bottoms()}) {
                for (std::size_t e = 0; e < 3; ++e) {
                    std::pair a{indices[k + e], (*heights)[indices[k + e]]};
                    std::pair b{indices[k + (e + 1) % 3], (*heights)[indices[k + (e + 1) % 3]]};
                    ++edges[{std::min(a, b), std::max(a, b)}];
                }
            }
        }
    }
    int open = 0;
    for (const auto& [edge, count] : edges)
        open += count != 2 ? 1 : 0;
    return open;
}

bool holds(const NodeRect& r, int i, int j)
{
    return i >= r.beginI && i < r.endI && j >= r.beginJ && j < r.endJ;
}

bool lightIsNear(const ToothSurface& a, const ToothSurface& b, std::size_t k)
{
    for (std::size_t channel = 0; channel < 4; ++channel)
        if (std::abs(a.light()[k][channel] - b.light()[k][channel]) > 1)
            return false;
    return true;
}

}  // namespace

class TestToothSurface : public QObject
{
    Q_OBJECT

private slots:
    // The coarsest grid, the default grid, and one that is drawn with fewer nodes than it has.
    void isClosedAlongTheRim_data() { support::rows<int>("side", {64, 150, 302}); }

    void isClosedAlongTheRim()
    {
        QFETCH(int, side);
        const ToothSurface surface(support::syntheticMolar(side), kLight);
        QCOMPARE(openEdges(surface), 0);
    }

    void fineGridsAreThinnedOut_data()
    {
        support::columns<int, int>("side", "drawn");
        QTest::newRow("default") << 150 << 150;
        QTest::newRow("every second") << 301 << 151;
        QTest::newRow("every third") << 640 << 214;
    }

    void fineGridsAreThinnedOut()
    {
        QFETCH(int, side);
        QFETCH(int, drawn);
        const auto tooth = support::syntheticMolar(side);
        ToothSurface surface(tooth, kLight);
        QCOMPARE(surface.lattice().side, drawn);
        // A cut of one tile of the fine grid appears in the drawn one at the same place.
        const glm::dvec2 place(1.7, 1.9);
        surface.write(cutTile(*tooth, place, -5.0F));
        surface.refresh();
        QVERIFY(near(surface.heightMm(place), -5.0, 1e-5));
    }

    void cutChangesOnlyItsSurroundings()
    {
        const auto tooth = support::syntheticMolar();
        ToothSurface surface(tooth, kLight);
        const ToothSurface whole = surface;
        surface.write(cutTile(*tooth, {0.0, 0.5}, -4.0F));
        const ToothSurface::Changes changes = surface.refresh();
        const int side = surface.lattice().side;
        QVERIFY(changes.heights.endI - changes.heights.beginI <= kTileSide + 2 * ui::render::SteepGround::kReach);
        QVERIFY(changes.normals.endI - changes.normals.beginI < side / 2);
        QVERIFY(changes.light.endI - changes.light.beginI < side);
        int lowered = 0;
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                const std::size_t k = surface.lattice().index(i, j);
                lowered += surface.tops()[k] < whole.tops()[k] ? 1 : 0;
                QVERIFY(holds(changes.heights, i, j) || surface.tops()[k] == whole.tops()[k]);
                QVERIFY(holds(changes.normals, i, j) || surface.topNormals()[k] == whole.topNormals()[k]);
                QVERIFY(holds(changes.light, i, j) || surface.light()[k] == whole.light()[k]);
            }
        }
        QVERIFY(lowered >= kTileSide * kTileSide);
        QVERIFY(surface.refresh().heights.isEmpty());
    }

    /// One opened column is smaller than anything that can be seen; the point of blood around it is not.
    void anOpenedPulpBleeds()
    {
        const auto tooth = support::syntheticMolar();
        const core::terrain::Grid& grid = tooth->grid;
        std::size_t opened = 0;
        for (std::size_t k = 0; k < grid.count(); ++k)
            if (hasPulp(*tooth, k) && (opened == 0 || tooth->layers[k].pulpRoof > tooth->layers[opened].pulpRoof))
                opened = k;
        const int side = grid.side;
        const int i = static_cast<int>(opened) % side;
        const int j = static_cast<int>(opened) / side;
        ToothSurface surface(tooth, kLight);
        const auto bleeding = [&] { return std::count(surface.blood().begin(), surface.blood().end(), 255); };
        // The floor of a cavity, a hundredth of a millimetre above the pulp.
        std::vector<float> top = tooth->top;
        for (int y = j - 10; y <= j + 10; ++y)
            for (int x = i - 10; x <= i + 10; ++x)
                top[grid.index(x, y)] = tooth->layers[opened].pulpRoof + 0.01F;
        surface.write(top);
        QVERIFY(surface.refresh().blood.isEmpty());
        QCOMPARE(bleeding(), 0);

        top[opened] -= 0.01F;
        surface.write(top);
        QVERIFY(!surface.refresh().blood.isEmpty());
        const double widthMm = 2.0 * static_cast<double>(ui::render::Bleeding::kReachMm);
        QVERIFY(bleeding() > 1);
        for (std::size_t k = 0; k < grid.count(); ++k) {
            const auto distance =
                glm::length(grid.nodeMm(static_cast<int>(k) % side, static_cast<int>(k) / side) - grid.nodeMm(i, j));
            if (distance > 0.5 * widthMm)
                QCOMPARE(surface.blood()[k], std::uint8_t{0});
            else if (distance < 0.25 * widthMm)
                QCOMPARE(surface.blood()[k], std::uint8_t{255});
        }
        // It goes with the opening.
        surface.write(tooth->top);
        QVERIFY(!surface.refresh().blood.isEmpty());
        QCOMPARE(std::count(surface.blood().begin(), surface.blood().end(), 0),
                 static_cast<std::ptrdiff_t>(grid.count()));
    }

    void refreshedPartsEqualAWholeNewSurface()
    {
        // Cut by cut, the last one through the whole flank, compared with all cuts at once.
        const auto tooth = support::syntheticMolar();
        ToothSurface surface(tooth, kLight);
        ToothSurface whole(tooth, kLight);
        for (const auto& [x, y, floor] : {std::array{0.0, 0.5, -4.0}, {1.5, 0.4, -3.0}, {-4.0, 3.0, -20.0}}) {
            const TilePatch patch = cutTile(*tooth, {x, y}, static_cast<float>(floor));
            surface.write(patch);
            surface.refresh();
            whole.write(patch);
        }
        for (const auto& [x, y] : {std::array{-5.7, -5.7}, {5.7, 5.7}})
            whole.write(cutTile(*tooth, {x, y}, 100.0F));
        whole.refresh();
        int different = 0;
        for (std::size_t k = 0; k < surface.tops().size(); ++k) {
            const int i = static_cast<int>(k) % surface.lattice().side;
            const int j = static_cast<int>(k) / surface.lattice().side;
            QCOMPARE(surface.isSolid(i, j), whole.isSolid(i, j));
            if (!surface.isSolid(i, j))
                continue;
            QCOMPARE(surface.tops()[k], whole.tops()[k]);
            const bool same = surface.topNormals()[k] == whole.topNormals()[k] &&
                              surface.bottomNormals()[k] == whole.bottomNormals()[k] && lightIsNear(surface, whole, k);
            different += same ? 0 : 1;
        }
        QCOMPARE(different, 0);
        QCOMPARE(surface.indexCounts(), whole.indexCounts());
    }

    void aSweepBringsAllLightUpToDate()
    {
        const auto tooth = support::syntheticMolar();
        ToothSurface swept(tooth, kLight);
        ToothSurface atOnce(tooth, kLight);
        int sweeps = 0;
        for (const glm::dvec2 at : {glm::dvec2(0.0, 0.5), glm::dvec2(0.9, 0.6)}) {
            const TilePatch patch = cutTile(*tooth, at, -4.5F);
            swept.write(patch);
            atOnce.write(patch);
            const NodeRect near = swept.refresh(true).light;
            QVERIFY(swept.isBehind());
            // A sweep updates some rows, and the next cut arrives during the sweep.
            const NodeRect some = swept.sweepLight().light;
            QVERIFY(some.endJ - some.beginJ < near.endJ - near.beginJ + 20);
            QVERIFY(swept.isSweeping());
            ++sweeps;
        }
        while (swept.isBehind()) {
            static_cast<void>(swept.sweepLight());
            QVERIFY(++sweeps < 200);
        }
        QVERIFY(sweeps > 4);
        atOnce.refresh();
        for (std::size_t k = 0; k < swept.light().size(); ++k)
            QVERIFY(lightIsNear(swept, atOnce, k));
    }

    /// In another thread, for another light, and after the shown surface was cut.
    void whatWasWorkedOutBeforehandIsTheSame()
    {
        const auto tooth = support::syntheticMolar(150);
        const glm::vec3 otherLight(-kLight.x, kLight.y, kLight.z);
        std::thread([&] { ui::render::workOutSurface(tooth, otherLight); }).join();
        const ToothSurface whole(tooth, kLight);
        const auto isWhole = [&](const ToothSurface& shown) {
            return shown.anatomyPointer() == tooth && shown.tops() == whole.tops() &&
                   shown.bottoms() == whole.bottoms() && shown.places() == whole.places() &&
                   shown.topNormals() == whole.topNormals() && shown.bottomNormals() == whole.bottomNormals() &&
                   shown.light() == whole.light() && shown.upperLayers() == whole.upperLayers() &&
                   shown.lowerLayers() == whole.lowerLayers() && shown.indices() == whole.indices() &&
                   !shown.isBehind();
        };
        const auto shown = ui::render::wholeSurface(tooth, kLight);
        QVERIFY(isWhole(*shown));
        shown->write(cutTile(*tooth, {0.0, 0.5}, -4.0F));
        shown->refresh();
        QVERIFY(shown->tops() != whole.tops());
        // Shown again it is uncut, also after others have replaced it in the cache.
        QVERIFY(isWhole(*ui::render::wholeSurface(tooth, kLight)));
        for (const int side : {100, 110, 120})
            ui::render::workOutSurface(support::syntheticMolar(side), kLight);
        QVERIFY(isWhole(*ui::render::wholeSurface(tooth, kLight)));
    }

    void perforationOpensASewnHole()
    {
        const auto tooth = support::syntheticMolar();
        ToothSurface surface(tooth, kLight);
        const glm::dvec2 place(0.5, 0.5);
        surface.write(cutTile(*tooth, place, core::terrain::kEmptyTop));
        surface.refresh();
        const glm::dvec2 at = surface.lattice().latticeOf(place);
        QVERIFY(!surface.isSolid(static_cast<int>(at.x), static_cast<int>(at.y)));
        QCOMPARE(openEdges(surface), 0);
        for (const float top : surface.tops())
            QVERIFY(std::abs(top) < 100.0F);
    }

    void emptyToothIsEmpty()
    {
        support::Block nothing;
        nothing.topMm = [](double, double) { return std::nan(""); };
        const ToothSurface surface(support::makeBlock(nothing), kLight);
        for (const int count : surface.indexCounts())
            QCOMPARE(count, 0);
        glm::dvec3 point;
        QVERIFY(surface.meet({{1.0, 1.0, 20.0}, {0.0, 0.0, -1.0}}, point));
    }

    void rayMeetsTheTopOrTheRestingPlane()
    {
        const auto tooth = support::syntheticMolar();
        const ToothSurface surface(tooth, kLight);
        glm::dvec3 point;
        const Ray slanted{{-10.0, 0.3, 9.0}, glm::normalize(glm::dvec3(1.0, 0.0, -1.0))};
        QVERIFY(surface.meet(slanted, point));
        QVERIFY(near(point.z, surface.heightMm({point.x, point.y}), 1e-3));
        QVERIFY(near(point.x + 10.0, 9.0 - point.z, 1e-6));
        // No part of the tooth is above the ray before that point.
        for (double t = 0.0; t < 0.99; t += 0.01) {
            const glm::dvec3 before = glm::mix(slanted.originMm, point, t);
            QVERIFY(before.z > surface.heightMm({before.x, before.y}));
        }
        QVERIFY(surface.meet({{30.0, 0.0, 9.0}, {0.0, 0.0, -1.0}}, point));
        QVERIFY(near(point.z, surface.restingHeightMm(), 1e-5));
        QVERIFY(!surface.meet({{0.0, 0.0, -9.0}, {0.0, 0.0, 1.0}}, point));
        QVERIFY(!surface.meet({{0.0, 0.0, 9.0}, {1.0, 0.0, 0.0}}, point));
    }

    void fossaIsToothAndTheFlankIsBeside()
    {
        const ToothSurface surface(support::syntheticMolar(), kLight);
        QVERIFY(surface.heightMm({0.0, 0.0}) < -2.0);
        // The flank is tooth as well, far below.
        QVERIFY(surface.topMm({5.3, 0.0}).value() < surface.restingHeightMm());
        QVERIFY(!surface.topMm({9.0, 0.0}));
        QVERIFY(near(surface.heightMm({5.5, 0.0}), surface.restingHeightMm(), 1e-5));
        QVERIFY(surface.highestWithinMm({-2.6, -2.6}, 0.5) > surface.heightMm({-2.2, -2.2}));
    }

    void everyDecayIsWorkedOn_data()
    {
        QTest::addColumn<int>("fdi");
        for (const int quadrant : {20, 30})
            for (int place = 1; place <= 8; ++place)
                QTest::addRow("%d", quadrant + place) << quadrant + place;
    }

    /// Where a lesion is open, the bur follows the tooth and not a plane above it. The initial camera sees the lesion:
    /// rays from the eye must not be blocked from many of its columns while another side shows many.
    void everyDecayIsWorkedOn()
    {
        QFETCH(int, fdi);
        const auto built = core::teeth::buildTooth({fdi}, {});
        QVERIFY(built);
        const ToothAnatomy& anatomy = *built->anatomy;
        const ToothSurface surface(built->anatomy, kLight);
        Camera camera;
        camera.setViewport({640.0, 480.0});
        ui::tooth::showWhole(camera, surface);
        Camera behind = camera;
        behind.turn(180.0, 0.0);
        const auto sees = [&](const Camera& from, const glm::dvec3& point) {
            const auto met = surface.meetTooth(from.rayThrough(from.pixelOf(point)));
            return met && glm::length(*met - point) < 0.2 ? 1 : 0;
        };
        int open = 0;
        int here = 0;
        int there = 0;
        support::eachNode(anatomy.grid, [&](std::size_t k, glm::dvec2 place) {
            const core::terrain::ColumnLayers& column = anatomy.layers[k];
            if (column.cariesRoof <= column.cariesFloor || column.cariesRoof < anatomy.top[k])
                return;
            ++open;
            QCOMPARE(surface.heightMm(place), static_cast<double>(anatomy.top[k]));
            const glm::dvec3 point(place, anatomy.top[k]);
            here += sees(camera, point);
            there += sees(behind, point);
        });
        QVERIFY(open > 20);
        QVERIFY2(here + there > 0 && 3 * here >= there,
                 qPrintable(QString("%1 seen, %2 from behind").arg(here).arg(there)));
    }

    void aWallTellsHowDeepItIs()
    {
        const auto tooth = support::syntheticMolar();
        ToothSurface surface(tooth, kLight);
        const glm::dvec2 middle = pictures::tileMiddle(tooth->grid, {0.0, 1.0});
        const double whole = surface.topMm(middle).value();
        surface.write(cutTile(*tooth, middle, static_cast<float>(whole - 1.5)));
        surface.refresh();
        // A flat ray meets the wall on the far side half-way down.
        const double half = 0.5 * (core::servo::kTileSide - 1) * tooth->grid.cellMm;
        const glm::dvec3 wall(middle.x + half + 0.5 * tooth->grid.cellMm, middle.y, whole - 0.7);
        const glm::dvec3 from = wall + glm::dvec3(-1.0, 0.0, 1.2) * 8.0;
        const auto met = surface.meetTooth({from, glm::normalize(wall - from)});
        QVERIFY(met);
        QVERIFY2(glm::length(*met - wall) < 0.06, qPrintable(QString::number(glm::length(*met - wall))));
        const double before = ToothSurface(tooth, kLight).topMm(glm::dvec2(*met)).value();
        QVERIFY(before - met->z > 0.3);
        QVERIFY(near(surface.belowUncutMm(*met), before - met->z, 1e-5));
        QVERIFY(near(surface.belowUncutMm({middle, whole - 1.5}), 1.5, 1e-4));
        // With an ideal, the depth is measured from the ideal.
        auto ideal = std::make_shared<std::vector<float>>(tooth->top);
        for (float& top : *ideal)
            top -= 1.0F;
        surface.setIdeal(ideal);
        QVERIFY(near(surface.belowIdealMm({middle, whole - 1.5}), 0.5, 1e-4));
        QVERIFY(near(surface.belowIdealMm({middle, whole}), -1.0, 1e-4));
    }

    void theOutlineOfAnIdealIsNoStaircase()
    {
        constexpr double kRadiusMm = 2.0;
        const auto tooth = support::makeBlock({});
        const auto ideal = std::make_shared<std::vector<float>>(
            support::loweredTop(*tooth, [](glm::dvec2 at) { return glm::length(at) < kRadiusMm ? -1.5 : 0.0; }));
        ToothSurface surface(tooth, kLight);
        surface.setIdeal(ideal);
        const core::terrain::Grid& lattice = surface.lattice();
        double mostOffMm = 0.0;
        int told = 0;
        for (int j = 0; j < lattice.side; ++j)
            for (int i = 0; i < lattice.side; ++i) {
                const double awayMm = static_cast<double>(surface.ideal()[lattice.index(i, j)].y);
                if (std::abs(awayMm) > 0.15)
                    continue;
                ++told;
                mostOffMm = std::max(mostOffMm, std::abs(awayMm - (glm::length(lattice.nodeMm(i, j)) - kRadiusMm)));
            }
        QVERIFY(told > 50);
        QVERIFY2(mostOffMm < 0.5 * lattice.cellMm, qPrintable(QString::number(mostOffMm)));
        surface.setIdeal(nullptr);
        QVERIFY(surface.ideal() == std::vector(lattice.count(), glm::vec2(0.0F, ToothSurface::kOutlineFarMm)));
    }

    void metalMeshesAreWholeAndFaceOutwards()
    {
        std::vector<ui::render::SolidMesh> meshes{ui::render::handpieceMesh()};
        for (const core::bur::Bur& bur : core::bur::burs()) {
            meshes.push_back(ui::render::shankMesh(bur));
            constexpr float kRing = 5.0F;
            const auto& shank = meshes.back().vertices;
            const bool hasRing = std::any_of(shank.begin(), shank.end(), [](const ui::render::MetalVertex& vertex) {
                return vertex.finish == kRing;
            });
            QCOMPARE(hasRing, bur.isDiamond());
            meshes.push_back(ui::render::burMesh(bur));
            float widest = 0.0F;
            float lowest = 1.0F;
            for (const ui::render::MetalVertex& vertex : meshes.back().vertices) {
                if (vertex.position.z <= static_cast<float>(bur.headLengthMm))
                    widest = std::max(widest, glm::length(glm::vec2(vertex.position)));
                lowest = std::min(lowest, vertex.position.z);
            }
            QCOMPARE(lowest, 0.0F);
            QVERIFY(std::abs(widest - static_cast<float>(bur.headRadiusMm)) < 1e-4F);
        }
        for (const ui::render::SolidMesh& mesh : meshes) {
            int inwards = 0;
            for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
                const auto& a = mesh.vertices[mesh.indices[k]];
                const auto& b = mesh.vertices[mesh.indices[k + 1]];
                const auto& c = mesh.vertices[mesh.indices[k + 2]];
                QVERIFY(std::abs(glm::length(a.normal) - 1.0F) < 1e-3F);
                const glm::vec3 across = glm::cross(b.position - a.position, c.position - a.position);
                if (glm::length(across) > 1e-6F && glm::dot(across, a.normal + b.normal + c.normal) < 0.0F)
                    ++inwards;
            }
            QCOMPARE(inwards, 0);
        }
    }
};

CUSP_TEST(TestToothSurface)
#include "tst_tooth_surface.moc"
