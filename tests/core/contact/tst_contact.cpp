// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/base/Rng.h"
#include "core/contact/BurHead.h"
#include "core/contact/ContactMethod.h"
#include "core/contact/Kernels.h"
#include "core/teeth/ToothBuilder.h"
#include "core/terrain/DecayZones.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticMolar.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

using namespace core;
using support::between;
using support::kDegree;

namespace {

/// A tooth, a contact method, and a bur at its start position.
struct Scene
{
    contact::LiveTooth tooth;
    std::unique_ptr<contact::ContactMethod> method;

    Scene(const terrain::Tooth& begun, std::size_t bur, const glm::dvec3& startMm, const char* name = "continuous")
        : tooth(begun), method(contact::makeContactMethod(name).value())
    {
        tooth.selectBur(bur);
        method->restart(startMm);
    }
    glm::dvec3 update(const glm::dvec3& device) { return method->update(tooth, device); }
};

/// Returns whether the bur at the anchor penetrates no column. The bur may be above or below the columns.
bool standsClear(contact::LiveTooth& tooth, const glm::dvec3& anchor)
{
    const glm::dvec2 at(anchor);
    const contact::Room room = tooth.roomAt(at, anchor.z);
    return anchor.z >= tooth.clearanceAt(at) - 1.0e-4 || anchor.z <= tooth.undersideAt(at) + 1.0e-4 ||
           (anchor.z >= room.floorMm - 1.0e-4 && anchor.z <= room.roofMm + 1.0e-4);
}

/// A plate, 1 mm thick, with air below it, so that its underside is an overhang.
const support::Block kPlate{.bottomMm = -1.0, .topMm = [](double x, double) { return x > 0.0 ? 0.0 : std::nan(""); }};

/// Slides a ball along and across a plane at 20 mm/s, pushed 0.4 mm into it. Returns the largest distance of a method's
/// anchor from the exact position, micrometres.
double worstOnPlaneUm(const char* method, double degrees)
{
    const double slope = std::tan(degrees * kDegree);
    const glm::dvec3 normal(-std::sin(degrees * kDegree), 0.0, std::cos(degrees * kDegree));
    const glm::dvec3 along(std::cos(degrees * kDegree), 0.0, std::sin(degrees * kDegree));
    const glm::dvec3 ballFromTip(0.0, 0.0, 0.5);
    const auto right = [&](double travel) {
        return normal * 0.5 - ballFromTip + (along * 0.4 + glm::dvec3(0.0, 0.2, 0.0)) * (0.5 * travel - 2.0);
    };
    Scene scene(support::blockTooth({.bottomMm = -40.0, .topMm = [slope](double x, double) { return slope * x; }}), 0,
                right(0.0) + normal, method);
    double worst = 0.0;
    for (int tick = 0; tick < 500; ++tick) {
        const double travel = tick < 100 ? 0.0 : 0.02 * (tick - 100);
        const double depth = 0.004 * std::min(tick, 100);
        const glm::dvec3 anchor = scene.update(right(travel) - normal * depth);
        if (tick > 120)
            worst = std::max(worst, glm::length(anchor - right(travel)));
    }
    return 1000.0 * worst;
}

/// Pushes the bur across a wall two cells thick with 3.9 N (2 N/mm). Returns how far past the middle of the wall it
/// gets, mm.
double crossedMm(const char* method)
{
    Scene scene(support::blockTooth({.topMm = [](double x, double) { return std::abs(x) < 0.08 ? 0.0 : -3.0; }}), 0,
                {-2.0, 0.0, -2.0}, method);
    glm::dvec3 anchor{};
    for (int tick = 0; tick < 600; ++tick)
        anchor = scene.update({std::min(-2.0 + 0.01 * tick, -0.57 + 1.95), 0.0, -2.0});
    return anchor.x;
}

/// Returns how much longer the leathery and the firm decay between two heights take to cut than soft decay would, in
/// seconds per mm2.
double harderSeconds(const terrain::ColumnLayers& column, float low, float high, const contact::RemovalTimes& times)
{
    const terrain::DecayZones zones = terrain::decayZonesOf(column);
    const auto overlap = [&](float from, float to) {
        return std::max(0.0, static_cast<double>(std::min(high, to)) - static_cast<double>(std::max(low, from)));
    };
    return overlap(zones.firmRoof, zones.leatheryRoof) * (times.leatheryDecay - times.ofMaterial[0]) +
           overlap(column.cariesFloor, zones.firmRoof) * (times.firmDecay - times.ofMaterial[0]);
}

}  // namespace

class TestContact : public QObject
{
    Q_OBJECT
private slots:
    /// Cutting eight columns at a time gives the same result as cutting one by one.
    void cutsAsColumnByColumn()
    {
        Rng rng(11);
        const auto anatomy = support::syntheticMolar(150);
        terrain::Tooth thin(anatomy);
        for (std::size_t k = 0; k < thin.top.size(); k += 7)  // so that the bur also meets bottoms and holes
            if (thin.isSolid(k))
                thin.bottom[k] = thin.top[k] - 0.2F;
        const double cell = anatomy->grid.cellMm;
        const int side = anatomy->grid.side;
        for (int n = 0; n < support::trials(50, 400); ++n) {
            contact::LiveTooth tooth(thin);
            tooth.selectBur(static_cast<std::size_t>(n) % core::bur::burs().size());
            const core::bur::BurMask& mask = tooth.mask();
            const contact::BurHead head =
                contact::headAt(mask, cell, rng.uniform(-5.0, 155.0), rng.uniform(-5.0, 155.0));
            const contact::Descent descent{static_cast<float>(rng.uniform(-6.0, 0.0)), 0.5F};
            const float share = n % 3 == 0 ? 0.4F : 1.0F;
            const terrain::PerMaterial seconds{2.0, 7.0, 3.0, 1.0};
            const contact::RemovalTimes times{seconds, n % 2 == 1, 2.5, 4.0};
            std::vector<float> tops = thin.top;
            terrain::PerMaterial removed{};
            double spent = 0.0;
            for (int j = 0; j < side; ++j) {
                for (int i = 0; i < side; ++i) {
                    const std::size_t k = anatomy->grid.index(i, j);
                    const float r2 = contact::r2Of(i, contact::dy2Of(j, head), head);
                    const float limit = descent.tipMm + contact::underAt(r2, head);
                    if (!(thin.top[k] > limit) || !(descent.highestMm + contact::upperAt(r2, head) > thin.bottom[k]))
                        continue;
                    const float low = std::max(limit, thin.bottom[k]);
                    const float to = share < 1.0F ? thin.top[k] - share * (thin.top[k] - low) : limit;
                    tops[k] = to > thin.bottom[k] ? to : terrain::kEmptyTop;
                    const auto all = terrain::lengthsBetween(anatomy->layers[k], low, thin.top[k]);
                    const auto part =
                        terrain::lengthsBetween(anatomy->layers[k], std::max(to, thin.bottom[k]), thin.top[k]);
                    const double area = static_cast<double>(anatomy->areaMm2[k]);
                    if (times.hasDecayZones)
                        spent += area * harderSeconds(anatomy->layers[k], low, thin.top[k], times);
                    for (std::size_t m = 0; m < all.size(); ++m) {
                        spent += all[m] * static_cast<double>(anatomy->areaMm2[k]) * seconds[m];
                        removed[m] += part[m] * static_cast<double>(anatomy->areaMm2[k]);
                    }
                }
            }
            const contact::Reach reach{static_cast<double>(mask.radiusMm) / cell + 0.01, 1.0e-5F,
                                       descent.tipMm - 1.0e-5F};
            double firstSpent = 0.0;
            terrain::PerMaterial firstRemoved{};
            for (const contact::Kernels* kernels : {&contact::kernels(), &contact::kPlainKernels}) {
                std::vector<contact::Columns> room(1000);
                const std::size_t count = kernels->columnsUnder(tooth.view(), head, reach, room);
                QVERIFY(count <= room.size());
                if (count > 0)
                    QCOMPARE(kernels->columnsUnder(tooth.view(), head, reach, std::span(room).first(count - 1)), count);
                const std::span<contact::Columns> columns = std::span(room).first(count);
                const double took = kernels->secondsToRemove(columns, head, descent, times);
                QVERIFY2(std::abs(took - spent) <= 1.0e-6 * spent, qPrintable(QString::number(took - spent)));
                terrain::PerMaterial mm3{};
                kernels->remove(columns, head, descent, share, mm3);
                for (std::size_t m = 0; m < mm3.size(); ++m)
                    QVERIFY(std::abs(mm3[m] - removed[m]) <= 1.0e-6 * spent);
                if (kernels == &contact::kPlainKernels) {
                    QCOMPARE(took, firstSpent);
                    QCOMPARE(mm3, firstRemoved);
                }
                firstSpent = took;
                firstRemoved = mm3;
                if (kernels != &contact::kPlainKernels)
                    continue;
                for (const contact::Columns& eight : columns)
                    tooth.take(eight);
                for (std::size_t k = 0; k < tops.size(); ++k)
                    QVERIFY2(tooth.tooth().top[k] == tops[k], qPrintable(QString::number(k)));
            }
        }
    }

    void kernelsAgreeToTheBit()
    {
        if (contact::kernels().name == contact::kPlainKernels.name)
            QSKIP("this processor has the plain kernels only");
        Rng rng(7);
        contact::LiveTooth tooth(
            support::blockTooth({.topMm = [&rng](double, double) { return rng.uniform(-2.0, 0.0); }}));
        std::vector<float> blocks(19 * 19 + contact::kBlock, terrain::kEmptyTop);
        std::vector<float> lowest(blocks.size(), terrain::kEmptyBottom);
        for (int j = 0; j < 150; ++j)
            for (int i = 0; i < 150; ++i) {
                const std::size_t k = tooth.grid().index(i, j);
                const auto at = static_cast<std::size_t>(j / 8 * 19 + i / 8);
                blocks[at] = std::max(blocks[at], tooth.tooth().top[k]);
                lowest[at] = std::min(lowest[at], tooth.tooth().bottom[k]);
            }
        const std::vector<float> unknown(blocks.size(), 0.0F);
        const contact::HeightView top{tooth.tooth().top.data(), 150, blocks.data()};
        const contact::HeightView topAlone{tooth.tooth().top.data(), 150, unknown.data()};
        const contact::HeightView bottom{tooth.tooth().bottom.data(), 150, lowest.data()};
        const auto highestOf = [](const contact::Peaks& peaks) {
            return *std::max_element(peaks.begin(), peaks.end(),
                                     [](const auto& a, const auto& b) { return a.value < b.value; });
        };
        for (std::size_t bur = 0; bur < core::bur::burs().size(); ++bur) {
            tooth.selectBur(bur);
            const core::bur::BurMask& mask = tooth.mask();
            for (int n = 0; n < (bur < core::bur::kCommonBurs ? 5000 : 400); ++n) {
                const double u = rng.uniform(-8.0, 158.0);
                const double v = rng.uniform(-8.0, 158.0);
                const auto& fast = contact::kernels();
                const auto& plain = contact::kPlainKernels;
                const auto beneath = fast.lowestAtPoint(bottom, mask, 0.07, u, v, {});
                const auto above = fast.highestAtPoint(top, mask, 0.07, u, v, {});
                for (std::size_t k = 0; k < above.size(); ++k) {
                    QCOMPARE(beneath[k].value, plain.lowestAtPoint(bottom, mask, 0.07, u, v, {})[k].value);
                    QCOMPARE(above[k].value, plain.highestAtPoint(top, mask, 0.07, u, v, {})[k].value);
                }
                // The skipped blocks contain no higher column.
                const contact::Peak peak = highestOf(above);
                QCOMPARE(peak.value, highestOf(fast.highestAtPoint(topAlone, mask, 0.07, u, v, {})).value);
                if (peak.i < 0)
                    continue;
                // A cached peak must have the same value as in the full search, and no column may be higher.
                const contact::BurHead head = contact::headAt(mask, 0.07, u, v);
                const auto heightOver = [&](int p, int q) {
                    return contact::valueOver<contact::Side::Above>(tooth.tooth().top[tooth.grid().index(p, q)], p,
                                                                    contact::dy2Of(q, head), head);
                };
                QCOMPARE(heightOver(peak.i, peak.j), peak.value);
                QVERIFY(heightOver(rng.below(150), rng.below(150)) <= peak.value);
            }
        }
    }

    /// The blocks and the cached last query save work and do not change any result.
    void roomIsThatOfEveryColumn()
    {
        Rng rng(5);
        const auto anatomy = support::syntheticMolar(150);
        const terrain::Grid& grid = anatomy->grid;
        terrain::Tooth begun(anatomy);
        for (std::size_t k = 0; k < begun.top.size(); ++k)  // a roof with holes above the bur
            if (begun.isSolid(k) && rng.below(30) != 0)
                begun.bottom[k] = std::max(begun.bottom[k], begun.top[k] - static_cast<float>(rng.uniform(0.3, 2.0)));
        contact::LiveTooth tooth(begun);
        for (int n = 0; n < 4000; ++n) {
            if (n % 4 == 0) {
                const int i = 20 + static_cast<int>(rng.below(110));
                const int j = 20 + static_cast<int>(rng.below(110));
                const float top = tooth.tooth().top[grid.index(i, j)];
                tooth.lower(i, j, top - static_cast<float>(rng.uniform(0.0, 1.0)));
                if (n % 8 == 0)
                    tooth.refreshBlocks(i, j, i, j);
            }
            if (n % 100 == 0)
                tooth.selectBur(static_cast<std::size_t>(n / 100) % core::bur::burs().size());
            const glm::dvec2 p(rng.uniform(-5.5, 5.5), rng.uniform(-5.5, 5.5));
            const double z = rng.uniform(-6.0, 0.0);
            const glm::dvec2 lattice = grid.latticeOf(p);
            const contact::BurHead head = contact::headAt(tooth.mask(), grid.cellMm, lattice.x, lattice.y);
            float floor = terrain::kEmptyTop;
            float roof = terrain::kEmptyBottom;
            float lowest = core::bur::BurMask::kAbsent;
            for (int j = 0; j < grid.side; ++j) {
                for (int i = 0; i < grid.side; ++i) {
                    const std::size_t k = grid.index(i, j);
                    const float dy2 = contact::dy2Of(j, head);
                    const float beneath =
                        -contact::valueOver<contact::Side::Beneath>(tooth.tooth().bottom[k], i, dy2, head);
                    lowest = std::min(lowest, beneath);
                    const float above = contact::valueOver<contact::Side::Above>(tooth.tooth().top[k], i, dy2, head);
                    if (!tooth.tooth().isSolid(k) || above <= beneath)
                        continue;
                    if (2.0F * static_cast<float>(z) >= above + beneath)
                        floor = std::max(floor, above);
                    else
                        roof = std::min(roof, beneath);
                }
            }
            const contact::Room room = tooth.roomAt(p, z);
            if (floor <= roof) {
                QCOMPARE(room.floorMm, static_cast<double>(floor));
                QCOMPARE(room.roofMm, static_cast<double>(roof));
            } else {
                QVERIFY(room.floorMm > room.roofMm);
            }
            const contact::Room least{z + 0.1, z - 0.1};
            const contact::Room enough = tooth.roomAt(p, z, least);
            const bool fits = floor <= roof && static_cast<double>(floor) <= least.floorMm &&
                              static_cast<double>(roof) >= least.roofMm;
            QCOMPARE(enough.floorMm <= enough.roofMm && enough.floorMm <= least.floorMm &&
                         enough.roofMm >= least.roofMm,
                     fits);
            if (std::abs(lowest) < core::bur::BurMask::kAbsent / 2.0F)
                QCOMPARE(tooth.undersideAt(p), static_cast<double>(lowest));
        }
    }

    void clearanceIsTheSlowObviousMaximum()
    {
        Rng rng(3);
        contact::LiveTooth tooth(support::blockTooth({.topMm = [&rng](double x, double y) {
            return std::hypot(x, y) > 4.0 ? std::nan("") : rng.uniform(-2.0, 0.0);
        }}));
        for (std::size_t b = 0; b < core::bur::burs().size(); ++b) {
            tooth.selectBur(b);
            const core::bur::Bur& bur = core::bur::burs()[b];
            for (int n = 0; n < (b < core::bur::kCommonBurs ? 300 : 30); ++n) {
                const int i = rng.below(150);
                const int j = rng.below(150);
                double slow = -1.0e9;
                for (int q = 0; q < 150; ++q)
                    for (int p = 0; p < 150; ++p) {
                        const double r = 0.07 * std::hypot(p - i, q - j);
                        // Leaves out half a cell at the rim, where the mask is supersampled and gives a slightly lower
                        // height.
                        if (r <= bur.headRadiusMm - 0.05)
                            slow = std::max(slow, static_cast<double>(tooth.tooth().top[tooth.grid().index(p, q)]) -
                                                      bur.undersideMm(r));
                    }
                const double fast = tooth.clearanceAt(tooth.grid().nodeMm(i, j));
                QVERIFY2(fast >= slow - 1.0e-5,
                         qPrintable(QString("bur %1 at %2 %3: %4 < %5").arg(b).arg(i).arg(j).arg(fast).arg(slow)));
            }
        }
    }

    void anchorStandsOnPlanes_data()
    {
        support::columns<double, double>("degrees", "allowedUm");
        QTest::newRow("flat") << 0.0 << 1.0;
        QTest::newRow("10") << 10.0 << 2.0;
        QTest::newRow("27") << 27.0 << 2.0;
        QTest::newRow("45") << 45.0 << 2.0;
        QTest::newRow("60") << 60.0 << 15.0;
    }

    void anchorStandsOnPlanes()
    {
        QFETCH(double, degrees);
        QFETCH(double, allowedUm);
        QVERIFY(between(worstOnPlaneUm("continuous", degrees), -1.0, allowedUm));
    }

    void flatBurStandsOnItsRim_data()
    {
        support::columns<double, double>("degrees", "turn");
        for (const double degrees : {10.0, 30.0, 45.0, 60.0})
            for (const double turn : {0.0, 15.0, 45.0})
                QTest::addRow("%g degrees, turned %g", degrees, turn) << degrees << turn;
    }

    void flatBurStandsOnItsRim()
    {
        // The end of bur 57 is a disc of 0.5 mm radius with a corner of 0.1 mm. On a slope it rests on its corner.
        QFETCH(double, degrees);
        QFETCH(double, turn);
        const double slope = std::tan(degrees * kDegree);
        const glm::dvec2 up(std::cos(turn * kDegree), std::sin(turn * kDegree));
        contact::LiveTooth tooth(support::blockTooth(
            {.bottomMm = -40.0, .topMm = [&](double x, double y) { return slope * (up.x * x + up.y * y); }}));
        tooth.selectBur(core::bur::findBur("57").value());
        const double stands = 0.4 * slope + 0.1 * (std::sqrt(1.0 + slope * slope) - 1.0);
        Rng rng(3);
        for (int n = 0; n < 2000; ++n) {
            const glm::dvec2 at(rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0));
            const double lack = slope * (up.x * at.x + up.y * at.y) + stands - tooth.clearanceAt(at);
            QVERIFY(between(lack, -1.0e-5, 1.0e-5));
        }
    }

    void meetsAWallThatEndsTheGrid()
    {
        // A tooth that fills its grid to the edge. The ball comes from outside the grid.
        const auto anatomy = support::makeBlock({.bottomMm = -8.0});
        const double wall = anatomy->grid.nodeMm(anatomy->grid.side - 1, 0).x;
        glm::dvec3 device(wall + 2.0, 0.0, -3.0);
        Scene scene(terrain::Tooth(anatomy), 0, device);
        double before = device.x;
        for (; device.x > wall - 1.0; device.x -= 0.005) {
            const glm::dvec3 anchor = scene.update(device);
            QVERIFY2(anchor.x > wall + 0.5 - 0.01, qPrintable(QString("the bur is at %1").arg(anchor.x - wall)));
            QVERIFY2(std::abs(anchor.x - before) < 0.02, "the bur jumped");
            QVERIFY(std::abs(anchor.z - device.z) < 0.1);
            before = anchor.x;
        }
    }

    void latticeSticksOnSlopes()
    {
        // On a slope that is not 0, 45 or 90 degrees no single lattice step both improves and is free, so the anchor
        // stays behind by far more than a cell (docs/facts/haptics.md, section 3.3).
        QVERIFY(worstOnPlaneUm("lattice", 0.0) < 120.0);
        QVERIFY(between(worstOnPlaneUm("lattice", 27.0), 100.0, 1.0e9));
    }

    void burIsNeverInsideTheTooth_data() { support::rows<QString>("method", {"continuous", "lattice"}); }

    void burIsNeverInsideTheTooth()
    {
        QFETCH(QString, method);
        Rng rng(11);
        const support::Block block{.topMm = [](double x, double y) {
            return std::hypot(x, y) > 4.5 ? std::nan("")
                                          : -0.15 * (x * x + y * y) + 0.4 * std::sin(3.0 * x) * std::sin(2.0 * y);
        }};
        glm::dvec3 device(0.0, 0.0, 3.0);
        glm::dvec3 speed(0.0);
        Scene scene(support::blockTooth(block), 0, device, qPrintable(method));
        for (int tick = 0; tick < 20000; ++tick) {
            for (int axis = 0; axis < 3; ++axis)
                speed[axis] = 0.98 * speed[axis] + rng.uniform(-0.01, 0.01);
            device += speed;
            device = glm::clamp(device, glm::dvec3(-5.0, -5.0, -5.0), glm::dvec3(5.0, 5.0, 2.0));
            const glm::dvec3 anchor = scene.update(device);
            QVERIFY(std::isfinite(anchor.x) && std::isfinite(anchor.y) && std::isfinite(anchor.z));
            QVERIFY2(standsClear(scene.tooth, anchor), qPrintable(QString("tick %1: z %2").arg(tick).arg(anchor.z)));
        }
    }

    void thinRidgeIsCrossedByAPenaltyAlone()
    {
        QVERIFY(between(crossedMm("continuous"), -1.0e9, -0.4));
        QVERIFY(crossedMm("lattice") < -0.3);
        // The known weakness of the penalty method: past the middle, the nearest normal points to the other side.
        QVERIFY(between(crossedMm("penalty"), 0.4, 1.0e9));
    }

    void burFitsThePocketItMade()
    {
        // A hole exactly as wide as the bur, with its axis between nodes, so that the clearance of no node shows it.
        const glm::dvec2 axis(0.021, -0.013);
        Scene scene(support::lowered(support::makeBlock({}),
                                     [&](glm::dvec2 at) { return glm::length(at - axis) <= 0.5 ? -1.5 : 1.0; }),
                    3, {axis.x, axis.y, 1.0});  // flat end, radius 0.5
        glm::dvec3 anchor{};
        for (int tick = 0; tick < 300; ++tick)
            anchor = scene.update({axis.x, axis.y, std::max(1.0 - 0.02 * tick, -2.0)});
        QVERIFY(support::near(anchor.z, -1.5, 1.0e-3));
        // The walls hold the bur.
        for (int tick = 0; tick < 100; ++tick)
            anchor = scene.update({axis.x + 0.5, axis.y, -1.6});
        QVERIFY(support::near(anchor.x, axis.x, 0.05));
        QVERIFY(anchor.z < -1.4);
    }

    void freeBurFollowsTheDevice()
    {
        const glm::dvec3 device(0.313, -1.77, 0.25);
        for (const char* method : {"penalty", "continuous"})
            QCOMPARE(Scene(support::blockTooth({}), 0, {0.0, 0.0, 5.0}, method).update(device), device);
    }

    void burGoesUnderAnOverhang()
    {
        // The head of bur 330 is 1.6 mm high, its neck 0.2 mm.
        Scene scene(support::blockTooth(kPlate), 1, {-1.0, 0.0, -3.0});
        glm::dvec3 anchor{};
        for (int tick = 0; tick < 300; ++tick)
            anchor = scene.update({std::min(-1.0 + 0.01 * tick, 0.05), 0.0, -3.0});
        // The edge of the head is beneath the plate, though not the neck.
        QVERIFY(between(anchor.x, -0.25, 1.0e9));
        // Pulled up, the bur slides out along its tapered shoulder and only then rises. It never passes through the
        // plate.
        for (int tick = 0; tick < 400; ++tick) {
            const glm::dvec3 before = anchor;
            anchor = scene.update({0.0, 0.0, std::min(-3.0 + 0.01 * tick, 0.5)});
            const bool above = anchor.z >= scene.tooth.clearanceAt({anchor.x, anchor.y}) - 1.0e-4;
            const bool beneath = anchor.z <= scene.tooth.undersideAt({anchor.x, anchor.y}) + 1.0e-4;
            QVERIFY(above || beneath);
            QVERIFY2(before.z > -1.0 || anchor.z < -1.0 || anchor.x < -0.3,
                     qPrintable(QString("tick %1: %2 %3").arg(tick).arg(anchor.x).arg(anchor.z)));
        }
    }

    void theRimOfAToothIsRound_data()
    {
        support::columns<std::size_t, double>("bur", "mmPerS");
        for (std::size_t bur = 0; bur < core::bur::burs().size(); ++bur)
            if (core::bur::BurMask(core::bur::burs()[bur], 0.07).steepMm < 1.0)  // a rounder bur climbs onto the disc
                for (const double mmPerS : {20.0, 100.0})
                    QTest::addRow("bur %zu, %g mm/s", bur, mmPerS) << bur << mmPerS;
    }

    /// Moves the bur around a disc, 8 mm wide and 3 mm thick, pushed in by 0.4 mm. It must follow the rim as exactly as
    /// a straight wall.
    void theRimOfAToothIsRound()
    {
        QFETCH(std::size_t, bur);
        QFETCH(double, mmPerS);
        constexpr double kDiscMm = 4.0;
        constexpr double kCellUm = 70.0;
        // The bur meets the edge at the height where the disc is.
        const double right = kDiscMm + core::bur::BurMask(core::bur::burs()[bur], 0.07).reachAt(1.0);
        Scene scene(
            support::blockTooth(
                {.bottomMm = -3.0,
                 .shiftMm = {0.013, -0.022},
                 .topMm = [](double x, double y) { return std::sqrt(x * x + y * y) < kDiscMm ? 0.0 : std::nan(""); }}),
            bur, {right + 0.5, 0.0, -1.0});
        double sum2 = 0.0;
        double most = 0.0;
        double jump = 0.0;
        int count = 0;
        glm::dvec3 before(0.0);
        const int turn = static_cast<int>(2.0 * std::numbers::pi * right / (mmPerS * 0.001));
        for (int tick = -100; tick < turn; ++tick) {
            const double angle = 2.0 * std::numbers::pi * std::max(0, tick) / turn;
            const glm::dvec3 out(std::cos(angle), std::sin(angle), 0.0);
            const double depth = 0.4 * std::min(1.0, 1.0 + tick / 90.0);
            const glm::dvec3 level(0.0, 0.0, -1.0);
            const glm::dvec3 off = scene.update(out * (right - depth) + level) - (out * right + level);
            if (tick >= 0) {
                const double far = 1000.0 * glm::length(off);
                sum2 += far * far;
                most = std::max(most, far);
                jump = std::max(jump, 2.0 * glm::length(off - before));
                ++count;
            }
            before = off;
        }
        const QString told =
            QString("rms %1 um, most %2 um, jump %3 N").arg(std::sqrt(sum2 / count)).arg(most).arg(jump);
        // At 100 mm/s the bur moves 0.1 mm per tick, more than a cell, which is 0.2 N.
        const bool isFast = mmPerS > 50.0;
        constexpr double kThinMm = 0.35;
        if (core::bur::burs()[bur].hasCone() || core::bur::burs()[bur].headRadiusMm < kThinMm) {
            // A tapered side has no vertical plane, and few columns surround a thin bur. Such burs feel more of the
            // steps between columns, and a fast hand sometimes gets ahead of them at a column.
            QVERIFY2(std::sqrt(sum2 / count) < (isFast ? 110.0 : 30.0) && most < (isFast ? 420.0 : 110.0),
                     qPrintable(told));
            QVERIFY2(jump < (isFast ? 0.9 : 0.2), qPrintable(told));
            return;
        }
        QVERIFY2(std::sqrt(sum2 / count) < 0.5 * kCellUm && most < (isFast ? 100.0 : kCellUm), qPrintable(told));
        QVERIFY2(jump < (isFast ? 0.2 : 0.1), qPrintable(told));
    }

    void theFlanksOfAToothDoNotClick_data()
    {
        support::columns<int, int>("fdi", "bur");
        for (const int fdi : {36, 24, 21})
            for (const int bur : {0, 1})
                QTest::addRow("tooth %d, bur %d", fdi, bur) << fdi << bur;
    }

    void theFlanksOfAToothDoNotClick()
    {
        QFETCH(int, fdi);
        QFETCH(int, bur);
        const auto built = teeth::buildTooth({fdi}, {}).value();
        contact::LiveTooth tooth{terrain::Tooth(built.anatomy)};
        tooth.selectBur(static_cast<std::size_t>(bur));
        const double highest = tooth.floorMm() + core::bur::kChuckMm;
        // Moves around the crown at 20 mm/s, 0.3 mm inside the bur's outline at that height, smoothed over 9 degrees.
        constexpr int kDegrees = 360;
        int ticks = 0;
        int clicks = 0;
        double worstN = 0.0;
        for (const double down : {0.5, 1.1, 1.7, 2.3, 2.9, 3.5}) {
            const double z = highest - down;
            std::array<double, kDegrees> outline{};
            for (int k = 0; k < kDegrees; ++k) {
                const glm::dvec2 towards(std::cos(k * kDegree), std::sin(k * kDegree));
                double radius = 8.0;
                while (radius > 0.2 && tooth.touchAt(radius * towards, 1.0e9, contact::Edges::Sides).heightMm <= z)
                    radius -= 0.02;
                outline.at(static_cast<std::size_t>(k)) = radius;
            }
            const auto handAt = [&](double angle, double depth) {
                double mean = 0.0;
                for (int n = -4; n <= 4; ++n)
                    mean +=
                        outline.at(static_cast<std::size_t>(static_cast<int>(angle) + n + kDegrees) % kDegrees) / 9.0;
                const double radius = std::max(0.1, mean - depth);
                return glm::dvec3(radius * std::cos(angle * kDegree), radius * std::sin(angle * kDegree), z);
            };
            const auto contact = contact::makeContactMethod("continuous").value();
            contact->restart(handAt(0.0, -3.0));
            for (double depth = -3.0; depth < 0.3; depth += 0.02)
                static_cast<void>(contact->update(tooth, handAt(0.0, depth)));
            glm::dvec3 hand = handAt(0.0, 0.3);
            glm::dvec3 stretch = contact->update(tooth, hand) - hand;
            for (double angle = 0.0; angle < kDegrees; ++ticks) {
                const glm::dvec3 now = handAt(angle, 0.3);
                const double movedMm = glm::length(now - hand);
                hand = now;
                const glm::dvec3 next = contact->update(tooth, hand) - hand;
                const double jumpN = 2.0 * std::max(0.0, glm::length(next - stretch) - 2.0 * movedMm);
                stretch = next;
                clicks += jumpN > 0.1 ? 1 : 0;
                worstN = std::max(worstN, jumpN);
                angle += 0.02 / std::max(1.0, glm::length(glm::dvec2(hand))) / kDegree;
            }
        }
        const QString found = QStringLiteral("%1 of %2 ticks, %3 N").arg(clicks).arg(ticks).arg(worstN);
        // Where a steep slope meets the upright rim, a step between columns remains in 1 of 100 ticks.
        QVERIFY2(clicks < ticks / 100, qPrintable(found));
        QVERIFY2(worstN < 1.0, qPrintable(found));
    }

    void noWalkLeadsIntoATooth_data() { support::rows<int>("fdi", {31, 36, 21, 24}); }

    /// The hand moves around and through a tooth at 5 to 300 mm/s and stays within 1 mm of the bur. The bur must never
    /// get into the tooth.
    void noWalkLeadsIntoATooth()
    {
        QFETCH(int, fdi);
        constexpr int kWalks = 6;
        constexpr int kTicks = 1500;
        constexpr double kBeyondMm = 1.0;
        const terrain::Tooth uncut(teeth::buildTooth({fdi}, {}).value().anatomy);
        for (std::size_t bur = 0; bur < core::bur::burs().size(); ++bur) {
            for (int walk = 0; walk < (bur < core::bur::kCommonBurs ? kWalks : 1); ++walk) {
                core::Rng rng(100 * bur + static_cast<std::uint64_t>(walk));
                const auto within = [&](double low, double high) { return low + (high - low) * rng.uniform(); };
                const double from = within(0.0, 360.0) * kDegree;
                glm::dvec3 hand(7.0 * std::cos(from), 7.0 * std::sin(from), within(-6.0, 4.0));
                Scene scene(uncut, bur, hand);
                glm::dvec3 anchor = scene.update(hand);
                glm::dvec3 goal(0.0);
                glm::dvec3 pace(0.0);
                double fastest = 0.05;
                for (int tick = 0; tick < kTicks; ++tick) {
                    if (tick % 100 == 0) {
                        goal = {within(-5.0, 5.0), within(-5.0, 5.0), within(-6.0, 1.0)};
                        fastest = within(0.005, 0.3);
                    }
                    pace += 0.05 * (glm::normalize(goal - hand) * fastest - pace);
                    hand += pace;
                    const double beyond = glm::length(hand - anchor);
                    if (beyond > kBeyondMm)
                        hand = anchor + (hand - anchor) * (kBeyondMm / beyond);
                    hand.z = std::max(hand.z, scene.tooth.floorMm());
                    anchor = scene.update(hand);
                    QVERIFY2(standsClear(scene.tooth, anchor),
                             qPrintable(QStringLiteral("bur %1, walk %2, tick %3").arg(bur).arg(walk).arg(tick)));
                }
            }
        }
    }

    /// Pulls the head of bur 330 up under the edge of a plate. Its shoulder meets the bottom of the plate, column by
    /// column.
    void theShoulderStopsBeneathAnOverhang()
    {
        const core::bur::Bur& bur = core::bur::burs()[1];
        for (const double x : {-0.23, -0.26, -0.30, -0.34}) {
            Scene scene(support::blockTooth(kPlate), 1, {x, 0.0, -4.0});
            // The hand holds the bur where it is and pulls it up gently.
            glm::dvec3 anchor{};
            for (int tick = 0; tick < 400; ++tick)
                anchor = scene.update({x, 0.0, std::min(-4.0 + 0.01 * tick, -2.45)});
            // The edge of the plate is half a cell before its first nodes, so that much less of the head is under it.
            const double highest = -1.0 - bur.upperSideMm(std::min(bur.headRadiusMm, 0.035 - x));
            QVERIFY2(anchor.z < highest + 0.05 && anchor.z > -2.7,
                     qPrintable(QString("at %1: %2, may be %3").arg(x).arg(anchor.z).arg(highest)));
            QVERIFY(anchor.z <= scene.tooth.undersideAt({anchor.x, anchor.y}) + 1.0e-4);
        }
    }

    /// Bur 330, 0.8 mm wide, passes through a hole 0.9 mm wide in a plate 1 mm thick, and the wall of the hole holds
    /// it.
    void aPerforationLetsTheBurThroughAndHoldsIt()
    {
        constexpr double kHoleMm = 0.45;
        Scene scene(support::blockTooth({.bottomMm = -1.0}), 1, {0.0, 0.0, 1.0});
        const terrain::Grid& grid = scene.tooth.grid();
        for (int j = 0; j < grid.side; ++j)
            for (int i = 0; i < grid.side; ++i)
                if (glm::length(grid.nodeMm(i, j)) < kHoleMm)
                    scene.tooth.lower(i, j, -1.0F);
        glm::dvec3 anchor{};
        for (int tick = 0; tick < 400; ++tick)
            anchor = scene.update({0.0, 0.0, 1.0 - 0.01 * tick});
        QVERIFY(support::near(anchor.z, -2.99, 1.0e-6));
        // Half-way through, with parts of the head above and below the plate, the bur is pushed 0.5 mm to every side.
        for (int tick = 0; tick < 300; ++tick)
            anchor = scene.update({0.0, 0.0, std::min(-2.99 + 0.01 * tick, -1.2)});
        glm::dvec3 before = anchor;
        for (int tick = 0; tick < 2000; ++tick) {
            const double angle = 2.0 * std::numbers::pi * tick / 1000.0;
            const double push = 0.5 * std::min(1.0, tick / 200.0);
            anchor = scene.update({push * std::cos(angle), push * std::sin(angle), -1.2});
            const double aside = glm::length(glm::dvec2(anchor));
            QVERIFY2(aside < kHoleMm - 0.4 + 0.08, qPrintable(QString("tick %1: %2 mm aside").arg(tick).arg(aside)));
            QVERIFY2(std::isfinite(anchor.z) && std::abs(anchor.z + 1.2) < 0.3, qPrintable(QString::number(anchor.z)));
            QVERIFY2(2.0 * glm::length(anchor - before) < 0.5, "jump");
            before = anchor;
        }
        // Pulls the bur out the way it went in.
        for (int tick = 0; tick < 400; ++tick)
            anchor = scene.update({0.0, 0.0, std::min(-1.2 + 0.01 * tick, 1.0)});
        QCOMPARE(anchor.z, 1.0);
    }

    void unknownMethodIsRefused()
    {
        const auto method = contact::makeContactMethod("magic");
        QVERIFY(support::isRefused(method, ErrorCode::UnknownName));
        QVERIFY(method.error().detail.find("continuous") != std::string::npos);
    }
};

CUSP_TEST(TestContact)
#include "tst_contact.moc"
