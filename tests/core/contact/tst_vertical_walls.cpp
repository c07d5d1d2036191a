// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/bur/Bur.h"
#include "core/contact/ContactMethod.h"
#include "core/contact/LiveTooth.h"
#include "lab/Block.h"
#include "tests/support/Checks.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include <glm/geometric.hpp>

using core::contact::Edges;
using core::contact::LiveTooth;
using support::kDegree;

namespace {

constexpr double kWallMm = 3.0;

/// Returns a floor at 0 with a wall where `across` is positive.
LiveTooth wallAcross(glm::dvec2 across, glm::dvec2 shift = {0.0, 0.0})
{
    return LiveTooth{core::terrain::Tooth(
        lab::enamelBlock([across](glm::dvec2 at) { return glm::dot(at, across) > 0.0 ? kWallMm : 0.0; }, 150, shift))};
}

glm::dvec2 towards(double degrees)
{
    return {std::cos(degrees * kDegree), std::sin(degrees * kDegree)};
}

/// Returns how far along `across` a bur on the floor gets, mm, from where it is clear of the wall.
double stopsAt(LiveTooth& tooth, glm::dvec2 across, double aside, Edges edges)
{
    const glm::dvec2 along(-across.y, across.x);
    double low = -1.5;
    double high = 0.5;
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (low + high);
        (tooth.touchAt(across * middle + along * aside, 1.0e9, edges).heightMm > 0.01 ? high : low) = middle;
    }
    return low;
}

}  // namespace

class TestUprightSides : public QObject
{
    Q_OBJECT
private slots:
    void aSideStandsHalfACellBeforeItsNodes()
    {
        // A straight side: the nodes nearest to the wall at 0 are half a cell before and behind it.
        LiveTooth tooth = wallAcross({1.0, 0.0});
        QVERIFY(std::abs(stopsAt(tooth, {1.0, 0.0}, 0.0, Edges::Sides) + 0.5) < 1.0e-5);
        QVERIFY(std::abs(stopsAt(tooth, {1.0, 0.0}, 0.0, Edges::Columns) + 0.5 - 0.035) < 2.0e-3);
    }

    void aSideAcrossTheLatticeIsSmooth_data() { support::rows<double>("degrees", {7.0, 15.0, 26.0, 33.0, 45.0, 71.0}); }

    void aSideAcrossTheLatticeIsSmooth()
    {
        QFETCH(double, degrees);
        const glm::dvec2 across = towards(degrees);
        LiveTooth tooth = wallAcross(across, {0.1, 0.4});
        constexpr double kStepMm = 0.005;
        constexpr double kCellMm = 0.07;
        const auto steepest = [&](Edges edges) {
            double most = 0.0;
            double before = stopsAt(tooth, across, -2.0, edges);
            for (double aside = -2.0 + kStepMm; aside < 2.0; aside += kStepMm) {
                const double now = stopsAt(tooth, across, aside, edges);
                most = std::max(most, std::abs(now - before) / kStepMm);
                before = now;
            }
            return most;
        };
        for (double aside = -2.0; aside < 2.0; aside += 0.05) {
            const double off = stopsAt(tooth, across, aside, Edges::Sides) + 0.5;
            QVERIFY2(std::abs(off) < 0.55 * kCellMm, qPrintable(QString("%1 mm beside %2").arg(off).arg(aside)));
        }
        const double smooth = steepest(Edges::Sides);
        QVERIFY2(smooth < 0.2,
                 qPrintable(QString("slope %1, of columns %2").arg(smooth).arg(steepest(Edges::Columns))));
    }

    void everyBurIsStoppedAtItsRadius()
    {
        const glm::dvec2 across(0.8, 0.6);
        LiveTooth tooth = wallAcross(across);
        for (std::size_t bur = 0; bur < core::bur::burs().size(); ++bur) {
            tooth.selectBur(bur);
            for (double aside = -1.0; aside < 1.0; aside += 0.1) {
                const double off = stopsAt(tooth, across, aside, Edges::Sides) + tooth.mask().reachAt(kWallMm);
                QVERIFY2(std::abs(off) < 0.04, qPrintable(QString("bur %1: %2 mm").arg(bur).arg(off)));
            }
        }
    }

    /// In cut ground the columns count: a bur can return to any place where it has cut, also at the top edge of a wall.
    void thePocketOfABurHoldsTheBur()
    {
        LiveTooth tooth = wallAcross({1.0, 0.0});
        const auto& bur = core::bur::burs()[0];
        const glm::dvec2 axis(-0.4, 0.013);
        for (int j = 0; j < tooth.grid().side; ++j)
            for (int i = 0; i < tooth.grid().side; ++i) {
                const double r = glm::distance(tooth.grid().nodeMm(i, j), axis);
                if (r <= bur.headRadiusMm + 1.0e-6 && tooth.tooth().top[tooth.grid().index(i, j)] > 1.0F)
                    tooth.lower(i, j, static_cast<float>(bur.undersideMm(std::min(r, bur.headRadiusMm))));
            }
        for (const Edges edges : {Edges::Columns, Edges::Sides}) {
            const double heldAt = tooth.touchAt(axis, 1.0e9, edges).heightMm;
            QVERIFY2(heldAt < 1.0e-3, qPrintable(QString("held at %1 mm").arg(heldAt)));
        }
    }

    void slopesAndGroovesHaveNone()
    {
        for (const double slope : {0.5, 1.0, 3.7})
            for (const bool groove : {false, true}) {
                LiveTooth tooth{core::terrain::Tooth(lab::enamelBlock([&](glm::dvec2 at) {
                    const double u = 0.8 * at.x + 0.6 * at.y;
                    return slope * (groove ? std::abs(u) : u);
                }))};
                for (double x = -2.0; x < 2.0; x += 0.11)
                    for (double y = -2.0; y < 2.0; y += 0.13)
                        QVERIFY(!tooth.touchAt({x, y}, 1.0e9, Edges::Sides).isSide());
            }
    }

    void beneathTheRimOfAToothTheWayIsFree()
    {
        LiveTooth tooth{core::terrain::Tooth(support::builtTooth(36))};
        int found = 0;
        for (double angle = 0.0; angle < 360.0; angle += 5.0)
            for (double r = 8.0; r > 2.0; r -= 0.01) {
                const core::contact::Touch touch = tooth.touchAt(towards(angle) * r, 1.0e9, Edges::Sides);
                if (!touch.isSide())
                    continue;
                ++found;
                QVERIFY(touch.roofMm < touch.heightMm);
                QVERIFY(std::abs(glm::dot(touch.outwards, touch.outwards) - 1.0) < 1e-9);
                QVERIFY(glm::dot(touch.outwards, towards(angle)) > 0.0);
                break;
            }
        QVERIFY2(found > 60, qPrintable(QString::number(found)));
    }

    void aBurGoesRoundATooth_data() { support::rows<int, int>("fdi", {36, 21}, "side", {100, 150, 300}); }

    /// The hand is 0.1 to 0.5 mm inside the tooth, at all heights of the crown, beside it and under its overhang. No
    /// bur falls behind.
    void aBurGoesRoundATooth()
    {
        QFETCH(int, fdi);
        QFETCH(int, side);
        LiveTooth tooth{core::terrain::Tooth(support::builtTooth(fdi, side))};
        tooth.selectBur(1);
        // The outline as a smoothed radius over the angle.
        constexpr int kAngles = 360;
        std::array<double, kAngles> outline{};
        for (int k = 0; k < kAngles; ++k)
            for (double r = 0.0; r < 9.0; r += 0.02) {
                const glm::ivec2 node(tooth.grid().latticeOf(towards(k) * r) + 0.5);
                if (tooth.grid().contains(node.x, node.y) && tooth.tooth().isSolid(tooth.grid().index(node.x, node.y)))
                    outline[static_cast<std::size_t>(k)] = r;
            }
        const auto radiusAt = [&](double degrees) {
            double sum = 0.0;
            for (int k = -8; k <= 8; ++k)
                sum += outline[static_cast<std::size_t>((static_cast<int>(degrees) + k + kAngles) % kAngles)];
            return sum / 17.0;
        };
        const double radius = core::bur::burs()[1].headRadiusMm;
        for (const double z : {-2.0, -3.0, -5.0, -7.0})
            for (const double depth : {0.1, 0.3, 0.5}) {
                const auto contact = core::contact::makeContactMethod("continuous").value();
                contact->restart({radiusAt(0.0) + radius + 1.0, 0.0, z});
                double most = 0.0;
                for (int tick = -200; tick < 3600; ++tick) {  // 10 mm/s
                    const double degrees = 0.1 * std::max(0, tick);
                    const double in = depth - (tick < 0 ? -0.005 * tick : 0.0);
                    const glm::dvec3 device(towards(degrees) * (radiusAt(degrees) + radius - in), z);
                    most = std::max(most, glm::distance(contact->update(tooth, device), device));
                }
                // The tolerance is the smoothing of the outline and a cell or two for a detour around a column.
                QVERIFY2(most < depth + 0.6,
                         qPrintable(QString("z %1, %2 mm in: %3 mm behind").arg(z).arg(depth).arg(most)));
            }
    }
};

CUSP_TEST(TestUprightSides)
#include "tst_vertical_walls.moc"
