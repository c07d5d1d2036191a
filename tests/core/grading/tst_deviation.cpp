// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/base/Rng.h"
#include "core/bur/Bur.h"
#include "core/contact/LiveTooth.h"
#include "core/cutting/Drill.h"
#include "core/grading/Deviation.h"
#include "core/grading/IdealCavity.h"
#include "core/teeth/ToothBuilder.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

using namespace core;
using grading::Deviation;
using grading::Part;
using grading::Placed;
using grading::Preparation;
using grading::Side;
using support::kDegree;
using support::lowered;
using support::near;
using support::nodeAt;
using support::Surface;

namespace {

constexpr double kExtentMm = 10.5;
Surface turnedSurface(const Surface& surface, double degrees)
{
    const double c = std::cos(degrees * kDegree);
    const double s = std::sin(degrees * kDegree);
    return [=](glm::dvec2 p) { return surface({c * p.x + s * p.y, c * p.y - s * p.x}); };
}

/// Returns the surface, lowered by `byMm` wherever it is cut.
Surface changed(const Surface& surface, const Surface& byMm)
{
    return [=](glm::dvec2 p) {
        const double z = surface(p);
        return z > 0.0 ? z : z + byMm(p);
    };
}

Surface movedBy(const Surface& surface, glm::dvec3 by)
{
    return changed([=](glm::dvec2 p) { return surface(p - glm::dvec2(by)); }, [=](glm::dvec2) { return by.z; });
}

/// Returns the height `inMm` inside the edge of a cavity with a level floor. The walls lean by `degrees` from the
/// vertical.
double leaning(double inMm, double depth, double degrees)
{
    if (inMm <= 0.0)
        return 1.0;
    return degrees == 0.0 ? -depth : -std::min(depth, inMm / std::tan(degrees * kDegree));
}

Surface box(double length, double width, double depth, double degrees = 0.0)
{
    return [=](glm::dvec2 p) {
        return leaning(std::min(0.5 * length - std::abs(p.x), 0.5 * width - std::abs(p.y)), depth, degrees);
    };
}

Surface round(double radius, double depth, double degrees)
{
    return [=](glm::dvec2 p) { return leaning(radius - glm::length(p), depth, degrees); };
}

/// Returns a ramp from 0 at x = -length / 2 down to -depth at the other end, which is vertical.
Surface wedge(double length, double width, double depth)
{
    return [=](glm::dvec2 p) {
        const bool isInside = std::abs(p.x) < 0.5 * length && std::abs(p.y) < 0.5 * width;
        return isInside ? -depth * (p.x / length + 0.5) : 1.0;
    };
}

/// Returns a trench with round ends, a level floor and leaning sides.
Surface trench(double length, double radius, double depth, double degrees)
{
    return [=](glm::dvec2 p) {
        const glm::dvec2 beyond(std::max(0.0, std::abs(p.x) - 0.5 * length), p.y);
        return leaning(radius - glm::length(beyond), depth, degrees);
    };
}

double boxMm3(double length, double width, double depth, double degrees)
{
    const double in = 2.0 * depth * std::tan(degrees * kDegree);
    return depth / 6.0 *
           (length * width + (length - in) * (width - in) + 4.0 * (length - 0.5 * in) * (width - 0.5 * in));
}

double roundMm3(double radius, double depth, double degrees)
{
    const double foot = radius - depth * std::tan(degrees * kDegree);
    return std::numbers::pi * depth / 3.0 * (radius * radius + radius * foot + foot * foot);
}

double trenchMm3(double length, double radius, double depth, double degrees)
{
    const double foot = radius - depth * std::tan(degrees * kDegree);
    return roundMm3(radius, depth, degrees) + length * depth * (radius + foot);
}

/// Returns a slab on a grid that is shifted under the scene.
std::shared_ptr<const terrain::ToothAnatomy> slabOf(int side, glm::dvec2 shiftInCells = {0.0, 0.0},
                                                    double dejMm = -100.0)
{
    const double cellMm = kExtentMm / side;
    return support::makeBlock({.side = side, .cellMm = cellMm, .shiftMm = shiftInCells * cellMm, .dejMm = dejMm});
}

/// Returns the surface as a preparation: lowered columns are Floor where they are at the lowest height, otherwise Wall.
Preparation ideal(const terrain::ToothAnatomy& anatomy, const Surface& surface)
{
    Preparation preparation;
    std::vector<float> top = support::loweredTop(anatomy, surface);
    const float lowest = *std::min_element(top.begin(), top.end());
    preparation.parts.assign(top.size(), Part::Keep);
    for (std::size_t k = 0; k < top.size(); ++k)
        if (top[k] < anatomy.top[k])
            preparation.parts[k] = top[k] <= lowest + 1.0e-6F ? Part::Floor : Part::Wall;
    preparation.top = std::make_shared<const std::vector<float>>(std::move(top));
    return preparation;
}

Deviation measured(const terrain::Tooth& tooth, const Preparation& preparation)
{
    return grading::measureDeviation(tooth, preparation).value();
}

/// Returns the deviation of a tooth that is cut to the surface `done` from the surface `wanted`.
Deviation compared(const std::shared_ptr<const terrain::ToothAnatomy>& anatomy, const Surface& done,
                   const Surface& wanted)
{
    return measured(lowered(anatomy, done), ideal(*anatomy, wanted));
}

std::vector<glm::dvec2> lies(int count)
{
    Rng rng(2026);
    std::vector<glm::dvec2> all;
    for (int n = 0; n < count; ++n) {
        const double x = rng.uniform();
        all.emplace_back(x, rng.uniform());
    }
    return all;
}

/// Returns the tooth after a bur has moved along a path without resistance.
terrain::Tooth drilled(const std::shared_ptr<const terrain::ToothAnatomy>& anatomy, const char* bur,
                       const std::vector<glm::dvec3>& way)
{
    contact::LiveTooth live{terrain::Tooth(anatomy)};
    live.selectBur(core::bur::findBur(bur).value());
    settings::HardnessPreset yielding;
    yielding.material.fill({settings::kMaxRateMm3PerNs, 0.0});
    core::cutting::Drill drill(yielding, {});
    constexpr double kStepMm = 0.02;
    glm::dvec3 tip = way.front();
    for (const glm::dvec3& corner : way) {
        const int steps = static_cast<int>(std::ceil(glm::length(corner - tip) / kStepMm));
        const glm::dvec3 from = tip;
        for (int n = 1; n <= steps; ++n) {
            const glm::dvec3 next = from + (corner - from) * (static_cast<double>(n) / steps);
            (void)drill.cut(live, tip, next, 1.0, 1.0);
            tip = next;
        }
    }
    return live.tooth();
}

}  // namespace

class TestDeviation : public QObject
{
    Q_OBJECT

private slots:
    void volumesOfSolids_data()
    {
        support::columns<Surface, double>("surface", "mm3");
        const auto add = [](const char* name, const Surface& surface, double mm3) {
            QTest::newRow(name) << surface << mm3;
        };
        add("box", turnedSurface(box(3.0, 2.0, 1.5), 17.0), 9.0);
        add("box, 8 degrees", box(3.0, 2.0, 1.5, 8.0), boxMm3(3.0, 2.0, 1.5, 8.0));
        add("cone", round(1.6, 1.6, 45.0), roundMm3(1.6, 1.6, 45.0));
        add("frustum, 10 degrees", round(1.6, 1.5, 10.0), roundMm3(1.6, 1.5, 10.0));
        add("wedge", turnedSurface(wedge(3.0, 2.0, 2.0), 28.0), 6.0);
        add("trench", turnedSurface(trench(3.0, 0.6, 1.5, 0.0), 17.0), trenchMm3(3.0, 0.6, 1.5, 0.0));
        add("trench, 6 degrees", trench(3.0, 0.6, 1.5, 6.0), trenchMm3(3.0, 0.6, 1.5, 6.0));
    }

    void volumesOfSolids()
    {
        // The surface is sampled at the nodes: 0.5 % at 150, about four times as much at 64 and a quarter at 300.
        QFETCH(Surface, surface);
        QFETCH(double, mm3);
        for (const auto& [side, percent] : {std::pair(64, 2.0), std::pair(150, 0.5), std::pair(300, 0.15)}) {
            double worst = 0.0;
            for (const glm::dvec2 shift : lies(support::trials(3, 12))) {
                const Deviation d = compared(slabOf(side, shift), surface, surface);
                worst = std::max(worst, 100.0 * std::abs(d.removedMm3 / mm3 - 1.0));
                QCOMPARE(d.idealMm3, d.removedMm3);
            }
            QVERIFY2(worst < percent, qPrintable(QStringLiteral("%1: %2 %").arg(side).arg(worst)));
        }
    }

    void anUprightBoxAlongTheLatticeIsRightOnTheAverage()
    {
        if (support::kSanitized)
            QSKIP("four hundred cuts like those of volumesOfSolids");
        // A whole row of columns counts or does not, so each dimension has an error of up to a cell.
        const double cell = kExtentMm / 150;
        double mean = 0.0;
        for (const glm::dvec2 shift : lies(400)) {
            const Surface wanted = box(3.0, 2.0, 1.5);
            const double mm3 = compared(slabOf(150, shift), wanted, wanted).removedMm3;
            mean += mm3 / 400.0;
            QVERIFY(mm3 > 1.5 * (3.0 - cell) * (2.0 - cell) && mm3 < 1.5 * (3.0 + cell) * (2.0 + cell));
        }
        QVERIFY2(std::abs(mean / 9.0 - 1.0) < 0.005, qPrintable(QString::number(mean)));
    }

    void volumesAreExactWhereColumnsHoldTheMeanOfTheirCell()
    {
        // Expects the height of a column to represent its cell: the share of the cell under the box, in closed form.
        for (const glm::dvec2 shift : lies(12)) {
            const auto anatomy = slabOf(150, shift);
            const double cell = anatomy->grid.cellMm;
            const auto covered = [&](double at, double half) {
                return std::clamp((std::min(at + 0.5 * cell, half) - std::max(at - 0.5 * cell, -half)) / cell, 0.0,
                                  1.0);
            };
            const Surface mean = [&](glm::dvec2 p) { return -1.5 * covered(p.x, 1.5) * covered(p.y, 1.0); };
            QVERIFY(near(compared(anatomy, mean, mean).removedMm3, 9.0, 9.0e-6));
        }
    }

    void overcutAndUndercutOfAMovedBox()
    {
        // The ideal is 3 x 2 x 1.5. The cut box is 0.2 mm aside, 0.1 mm along its width and 0.25 deeper.
        const double common = 2.8 * 1.9 * 1.5;
        const double all = 3.0 * 2.0 * 1.75;
        for (const glm::dvec2 shift : lies(8)) {
            const Surface wanted = turnedSurface(box(3.0, 2.0, 1.5), 17.0);
            const Surface done = turnedSurface(movedBy(box(3.0, 2.0, 1.5), {0.2, -0.1, -0.25}), 17.0);
            const Deviation d = compared(slabOf(150, shift), done, wanted);
            QVERIFY(near(d.overcutMm3(), all - common, 0.005 * 9.0));
            QVERIFY(near(d.overcutBelowMm3, 2.8 * 1.9 * 0.25, 0.005 * 9.0));
            QVERIFY(near(d.undercutMm3, 9.0 - common, 0.005 * 9.0));
            QVERIFY(near(d.dice.value(), 2.0 * common / (all + 9.0), 0.003));
            QVERIFY(near(d.iou.value(), common / (all + 9.0 - common), 0.003));
            // The volumes balance up to rounding.
            QVERIFY(near(d.removedMm3 - d.overcutMm3(), d.idealMm3 - d.undercutMm3, 1.0e-9));
        }
    }

    void volumesAgreeWithCountedSlices()
    {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            Rng rng(seed);
            const auto anatomy = support::slab(-2.0F);
            terrain::Tooth tooth(anatomy);
            Preparation preparation = ideal(*anatomy, [](glm::dvec2) { return 1.0; });
            std::vector<float> wanted = anatomy->top;
            for (std::size_t k = 0; k < wanted.size(); ++k) {
                tooth.top[k] = static_cast<float>(std::min(0.0, rng.uniform(-9.9, 3.0)));
                wanted[k] = static_cast<float>(std::min(0.0, rng.uniform(-9.9, 3.0)));
            }
            preparation.top = std::make_shared<const std::vector<float>>(wanted);
            double over = 0.0;
            double under = 0.0;
            for (std::size_t k = 0; k < wanted.size(); ++k)
                for (int slice = 0; slice < 1000; ++slice) {
                    const float z = -0.005F - 0.01F * static_cast<float>(slice);
                    over += z > tooth.top[k] && z < wanted[k] ? 1.0e-4 : 0.0;
                    under += z < tooth.top[k] && z > wanted[k] ? 1.0e-4 : 0.0;
                }
            const Deviation d = measured(tooth, preparation);
            QVERIFY2(near(d.overcutMm3(), over, 0.05) && near(d.undercutMm3, under, 0.05),
                     qPrintable(QStringLiteral("seed %1").arg(seed)));
            QVERIFY(d == measured(tooth, preparation));
        }
    }

    void theFloorsErrorIsSignedAndFound()
    {
        // The floor slopes from 0.3 too deep at one end to 0.1 too high at the other over 4 mm. A margin of 0.2 at each
        // end is not measured.
        const auto slope = [](double x) { return -0.1 + 0.1 * x; };
        for (const int side : {64, 150, 300})
            for (const glm::dvec2 shift : lies(6)) {
                const auto anatomy = slabOf(side, shift);
                const Surface wanted = box(4.0, 2.0, 1.5);
                const Surface done = changed(wanted, [&](glm::dvec2 p) { return slope(p.x); });
                const grading::DepthError e = compared(anatomy, done, wanted).depth.value();
                const double reach = 1.8;  // to the margin, or up to two cells less
                const double cell = kExtentMm / side;
                QVERIFY(near(e.signedMm, -0.1, 0.01 + 0.05 * cell));
                // |slope| is above 0 beyond x = 1: this is the mean of the absolute error.
                const auto under = [&](double x) { return x * -0.1 + 0.05 * x * x; };
                const double size = (-(under(1.0) - under(-reach)) + (under(reach) - under(1.0))) / (2.0 * reach);
                QVERIFY(near(e.meanMm, size, 0.01 + 0.05 * cell));
                QVERIFY(near(e.p95Mm, 0.1 + 0.1 * (reach - 0.05 * 2.0 * reach), 0.01 + 0.2 * cell));
                QVERIFY(near(e.tooDeepMm.value, 0.28, 0.01 + 0.2 * cell));
                QVERIFY(near(e.tooShallowMm.value, 0.08, 0.01 + 0.2 * cell));
                QVERIFY(near(anatomy->grid.nodeMm(e.tooDeepMm.node).x, -reach, 2.0 * cell));
                QVERIFY(near(anatomy->grid.nodeMm(e.tooShallowMm.node).x, reach, 2.0 * cell));
            }
    }

    void aWallASmallWayAsideIsNoErrorOfDepth()
    {
        const auto anatomy = slabOf(150);
        const Surface wanted = box(3.0, 2.0, 1.5);
        const Deviation aside = compared(anatomy, movedBy(wanted, {0.15, 0.0, -0.1}), wanted);
        QVERIFY(near(aside.depth->meanMm, 0.1, 1.0e-5));
        QVERIFY(near(aside.depth->tooDeepMm.value, 0.1, 1.0e-5));
        QCOMPARE(aside.depth->tooShallowMm.value, 0.0);
        // An area that was left uncut counts.
        const Deviation half = compared(anatomy, movedBy(box(1.5, 2.0, 1.5), {-0.75, 0.0, 0.0}), wanted);
        QVERIFY(near(half.depth->tooShallowMm.value, 1.5, 1.0e-5));
        // A floor narrower than its margins is measured as a whole.
        QVERIFY(near(compared(anatomy, box(3.0, 0.3, 1.4), box(3.0, 0.3, 1.5)).depth->signedMm, 0.1, 1.0e-5));
    }

    void aTiltedFloorHasASlopeAndNoStep()
    {
        for (const double degrees : {0.5, 3.0, 10.0})
            for (const glm::dvec2 shift : lies(4)) {
                const Surface wanted = turnedSurface(box(3.0, 2.0, 1.5), 30.0);
                const Surface tilt = [&](glm::dvec2 p) {
                    return std::tan(degrees * kDegree) * (0.6 * p.x + 0.8 * p.y);
                };
                const grading::FloorForm form =
                    compared(slabOf(150, shift), changed(wanted, tilt), wanted).floor.value();
                QVERIFY(near(form.slopeDeg, degrees, 1.0e-4));
                QVERIFY(near(form.flatnessMm, 0.0, 1.0e-5));
                QVERIFY(near(form.stepMm.value, 0.0, 1.0e-5));
            }
    }

    void aGougeIsWhatHalfASquareMillimetreLiesTooDeep()
    {
        const auto anatomy = slabOf(150);
        const Surface wanted = box(4.0, 2.0, 1.5);
        const auto dug = [&](double radiusMm) {
            const Surface done = changed(wanted, [radiusMm](glm::dvec2 p) {
                return glm::length(p - glm::dvec2(0.5, 0.2)) < radiusMm ? -0.7 : -0.05;
            });
            return compared(anatomy, done, wanted);
        };
        const Deviation gouged = dug(0.5);  // 0.79 mm2
        QVERIFY(near(gouged.depth->gougeMm.value, 0.7, 1.0e-5));
        QVERIFY(glm::length(anatomy->grid.nodeMm(gouged.depth->gougeMm.node) - glm::dvec2(0.5, 0.2)) < 0.5);
        QVERIFY(near(gouged.depth->shallowP95Mm, 0.0, 1.0e-5));
        QVERIFY(near(gouged.floor->slopeDeg, 0.0, 1.0e-4));
        // A hole of 0.2 mm2 does not count, because it is at most 5 percent of a floor of 8 mm2.
        QVERIFY(near(dug(0.25).depth->gougeMm.value, 0.05, 1.0e-5));
        QVERIFY(near(dug(0.25).depth->deepP95Mm, 0.05, 1.0e-5));
        // A gouge in a floor too narrow for margins, and a floor that is too high.
        const Surface narrow = box(4.0, 0.5, 1.5);
        QVERIFY(near(compared(anatomy, movedBy(narrow, {0.0, 0.0, -0.3}), narrow).depth->gougeMm.value, 0.3, 1.0e-5));
        const Deviation high = compared(anatomy, movedBy(wanted, {0.0, 0.0, 0.3}), wanted);
        QVERIFY(near(high.depth->gougeMm.value, 0.0, 1.0e-5) && near(high.depth->shallowP95Mm, 0.3, 1.0e-5));
    }

    void aWavyWallIsRoughAndAMisplacedOneIsNot()
    {
        const auto anatomy = slabOf(150);
        const Surface wanted = box(5.0, 2.0, 1.5);
        const auto roughness = [&](const Surface& done) {
            return compared(anatomy, done, wanted).outline->roughnessMm.value;
        };
        // The long walls, 10 of 14 mm, have waves of 0.15 mm amplitude.
        const auto waves = [&](double lengthMm) {
            return [=](glm::dvec2 p) {
                const double out = 0.15 * std::sin(2.0 * std::numbers::pi * p.x / lengthMm);
                return std::abs(p.x) < 2.5 && std::abs(p.y) < 1.0 + (p.y > 0.0 ? out : -out) ? -1.5 : 0.0;
            };
        };
        const double expected = 0.15 / std::sqrt(2.0) * std::sqrt(10.0 / 14.0);
        QVERIFY(near(roughness(waves(1.0)), expected, 0.02));
        QVERIFY(roughness(waves(1.6)) > 0.8 * expected);
        QVERIFY(roughness(wanted) < 1.0e-9);
        QVERIFY(roughness(box(5.4, 2.4, 1.5)) < 0.02);
        QVERIFY(roughness(movedBy(wanted, {0.2, 0.0, 0.0})) < 0.03);
    }

    void theWorstOfSeveralPitsIsNamed()
    {
        const auto anatomy = slabOf(150);
        const auto pits = [](double left, double right) -> Surface {
            return [=](glm::dvec2 p) {
                const bool isLeft = glm::length(p - glm::dvec2(-2.0, 0.0)) < 0.7;
                const bool isRight = glm::length(p - glm::dvec2(2.0, 0.0)) < 0.7;
                return isLeft ? -left : isRight ? -right : 1.0;
            };
        };
        const Surface wanted = pits(0.5, 1.5);
        Preparation both = ideal(*anatomy, wanted);
        std::replace(both.parts.begin(), both.parts.end(), Part::Wall, Part::Floor);
        const auto worst = [&](const Surface& done) {
            return measured(lowered(anatomy, done), both).depth->worstPiece;
        };
        const auto deep = worst(pits(0.6, 1.8));
        QVERIFY(deep && near(deep->meanMm, -0.3, 1.0e-5) && near(deep->depthMm, 1.5, 1.0e-5));
        QVERIFY(anatomy->grid.nodeMm(deep->node).x > 1.0);
        const auto shallow = worst(pits(0.1, 1.6));
        QVERIFY(shallow && near(shallow->meanMm, 0.4, 1.0e-5) && near(shallow->depthMm, 0.5, 1.0e-5));
        // A hole in the middle that is too narrow counts with its depth, and a missing one with its full depth.
        const Surface narrow = [](glm::dvec2 p) { return glm::length(p - glm::dvec2(-2.0, 0.0)) < 0.5 ? -0.5 : 1.0; };
        const auto missing = worst(narrow);
        QVERIFY(missing && near(missing->meanMm, 1.5, 1.0e-5));
        QVERIFY(!compared(anatomy, box(3.0, 2.0, 1.4), box(3.0, 2.0, 1.5)).depth->worstPiece);
    }

    void whatIsCutElsewhereIsBeyondTheIdeal()
    {
        const auto anatomy = slabOf(150);
        const Surface wanted = box(3.0, 2.0, 1.5);
        const auto alsoCut = [&](glm::dvec2 place, double radiusMm, double depthMm) {
            const Surface done = [=](glm::dvec2 p) {
                return glm::length(p - place) < radiusMm ? std::min(wanted(p), -depthMm) : wanted(p);
            };
            return compared(anatomy, done, wanted).beyondMm.value;
        };
        // The far edge of a hole of 1 mm is 3.5 - 1.5 + 0.5 away, less the last 0.1 mm2.
        const double hole = alsoCut({3.5, 0.0}, 0.5, 0.6);
        QVERIFY2(hole > 2.2 && hole < 2.5, qPrintable(QString::number(hole)));
        QVERIFY(near(alsoCut({3.5, 0.0}, 0.5, 0.15), 0.0, 1.0e-5));  // a scratch
        QVERIFY(near(alsoCut({3.5, 0.0}, 0.12, 0.6), 0.0, 1.0e-5));  // smaller than 0.1 mm2
        QVERIFY(alsoCut({0.0, 0.0}, 0.5, 2.0) < 0.1);                // inside
    }

    void aLedgeIsAStep()
    {
        // The right half is 0.3 mm lower: the step is the difference between the halves, less what a tilted plane
        // explains. Each half is level.
        const auto anatomy = slabOf(150);
        const Surface wanted = box(4.0, 2.0, 1.5);
        const Surface done = changed(wanted, [](glm::dvec2 p) { return p.x > 0.0 ? -0.3 : 0.0; });
        const grading::FloorForm form = compared(anatomy, done, wanted).floor.value();
        // Over 3.6 mm, the slope of the best line through a step of height h is 1.5 h / length.
        const double slope = 1.5 * 0.3 / 3.6;
        QVERIFY(near(form.slopeDeg, 0.0, 1.0e-4));
        QVERIFY(near(form.stepMm.value, 0.3 - slope * 0.2, 0.01));
        QVERIFY(near(anatomy->grid.nodeMm(form.stepMm.node).x, 0.0, 0.21));
        QVERIFY(near(form.flatnessMm, 0.15 * std::sqrt(1.0 - 0.75), 0.002));
        QVERIFY(!form.intoDentinMm.has_value());
        // A staircase in the ideal does not count as a step.
        Preparation staircase = ideal(*anatomy, done);
        for (Part& part : staircase.parts)
            part = part == Part::Wall ? Part::Floor : part;
        const grading::FloorForm asked = measured(lowered(anatomy, done), staircase).floor.value();
        QCOMPARE(asked.stepMm.value, 0.0);
        QCOMPARE(asked.flatnessMm, 0.0);
    }

    void flatnessIsTheRestOfAWave()
    {
        // Ten whole waves of 0.05 mm: rms 0.05 / sqrt 2.
        const Surface wanted = box(4.0, 4.0, 1.5);
        const Surface wave = [](glm::dvec2 p) { return 0.05 * std::sin(2.0 * std::numbers::pi * p.x / 0.36); };
        const grading::FloorForm form = compared(slabOf(300), changed(wanted, wave), wanted).floor.value();
        QVERIFY(near(form.flatnessMm, 0.05 / std::numbers::sqrt2, 0.001));
        QVERIFY(near(form.slopeDeg, 0.0, 0.2));
    }

    void outlinesOfMovedAndWidenedCircles()
    {
        // The position of an upright wall is known to half a cell, a distance of two walls to a cell. Along an outline
        // that changes its direction the errors average out.
        for (const int side : {64, 150, 300}) {
            const double cell = kExtentMm / side;
            for (const glm::dvec2 shift : lies(8)) {
                const auto anatomy = slabOf(side, shift);
                const Surface wanted = round(1.6, 1.5, 0.0);

                const auto wide = compared(anatomy, round(1.9, 1.5, 0.0), wanted).outline.value();
                QVERIFY(near(wide.meanMm, 0.3, 0.1 * cell));
                QVERIFY(near(wide.signedMm, 0.3, 0.1 * cell));
                QVERIFY(near(wide.p95Mm, 0.3, 0.7 * cell));
                QVERIFY(near(wide.overMm.value, 0.3, cell));
                QCOMPARE(wide.underMm.value, 0.0);

                const auto narrow = compared(anatomy, round(1.4, 1.5, 0.0), wanted).outline.value();
                QVERIFY(near(narrow.signedMm, -0.2, 0.1 * cell));
                QVERIFY(near(narrow.underMm.value, 0.2, cell));
                QCOMPARE(narrow.overMm.value, 0.0);

                // The outline is moved by 0.2: at an angle to the direction of the move, the error is 0.2 times the
                // cosine.
                const auto moved = compared(anatomy, movedBy(wanted, {0.2, 0.0, 0.0}), wanted).outline;
                QVERIFY(near(moved->signedMm, 0.0, 0.1 * cell));
                QVERIFY(near(moved->meanMm, 0.2 * 2.0 / std::numbers::pi, 0.2 * cell));
                QVERIFY(near(moved->overMm.value, 0.2, cell));
                QVERIFY(near(moved->underMm.value, 0.2, cell));
                QVERIFY(anatomy->grid.nodeMm(moved->overMm.node).x > 1.3);
                QVERIFY(anatomy->grid.nodeMm(moved->underMm.node).x < -1.0);
            }
        }
    }

    void aMissingArmAndAnExtraOneBothCount()
    {
        const auto anatomy = slabOf(150);
        const Surface bar = box(4.0, 1.0, 1.5);
        const Surface cross = [&](glm::dvec2 p) { return std::min(bar(p), bar({p.y, p.x})); };
        const auto missing = compared(anatomy, bar, cross).outline.value();
        QVERIFY(near(missing.underMm.value, 1.5, 0.06));
        QCOMPARE(missing.overMm.value, 0.0);
        QVERIFY(near(std::abs(anatomy->grid.nodeMm(missing.underMm.node).y), 2.0, 0.1));
        const auto extra = compared(anatomy, cross, bar).outline.value();
        QVERIFY(near(extra.overMm.value, 1.5, 0.06));
        QCOMPARE(extra.underMm.value, 0.0);
    }

    void aScratchIsNoOutline()
    {
        const Surface wanted = box(2.0, 2.0, 1.5);
        const Surface done = [&](glm::dvec2 p) { return p.x > 2.0 && std::abs(p.y) < 0.5 ? -0.05 : wanted(p); };
        const Deviation d = compared(slabOf(150), done, wanted);
        QCOMPARE(d.outline->overMm.value, 0.0);
        QVERIFY(d.overcutMm3() > 0.1);
    }

    void wallAngles_data()
    {
        support::columns<Surface, double, double>("surface", "degrees", "tolerance");
        const auto add = [](const QString& name, const Surface& surface, double degrees, double tolerance = 1.0) {
            QTest::newRow(qPrintable(name)) << surface << degrees << tolerance;
        };
        for (const double degrees : {0.0, 2.0, 4.0, 6.0, 8.0, 10.0, 15.0, 30.0}) {
            const QString angle = QString::number(degrees);
            add("box, turned, " + angle, turnedSurface(box(3.0, 2.4, 1.5, degrees), 17.0), degrees);
            add("box, a little askew, " + angle, turnedSurface(box(3.0, 2.4, 1.5, degrees), 3.0), degrees);
            add("trench, " + angle, turnedSurface(trench(3.0, 1.2, 1.5, degrees), -21.0), degrees);
            add("cone, " + angle, round(1.6, 1.5, degrees), degrees);
            // Along the lattice, every row of columns has the same share of the wall. A wall steeper than 7 degrees may
            // have a single column on its slope, which determines the slope only to half a cell or worse.
            add("box along the lattice, " + angle, box(3.0, 2.4, 1.5, degrees), degrees,
                degrees > 0.0 && degrees < 7.0 ? 4.0 : 1.0);
            add("box across the lattice, " + angle, turnedSurface(box(3.0, 2.4, 1.5, degrees), 45.0), degrees,
                degrees > 0.0 && degrees < 6.0 ? 4.0 : 1.0);
        }
        add("cone, 45", round(1.6, 1.5, 45.0), 45.0);
    }

    void wallAngles()
    {
        QFETCH(Surface, surface);
        QFETCH(double, degrees);
        QFETCH(double, tolerance);
        for (const auto& [side, count] :
             {std::pair(150, support::trials(2, 10)), std::pair(300, support::trials(1, 2))})
            for (const glm::dvec2 shift : lies(count)) {
                const Deviation d = compared(slabOf(side, shift), surface, surface);
                for (const std::optional<Placed>& wall : d.form.wallDeg) {
                    QVERIFY(wall.has_value());
                    QVERIFY(near(wall->value, degrees, tolerance));
                }
                QVERIFY(d.outline->roughnessMm.value < 1.0e-9);
                QVERIFY(d.form == d.idealForm);
            }
    }

    void eachWallIsNamedByItsSide()
    {
        // Four walls with different angles, each half of x or y leaning by its own.
        const std::array<double, 4> degrees{6.0, 12.0, 20.0, 9.0};  // -x, +x, -y, +y
        const Surface cavity = [&](glm::dvec2 p) {
            const double west = leaning(p.x + 2.0, 1.5, degrees[0]);
            const double east = leaning(2.0 - p.x, 1.5, degrees[1]);
            const double south = leaning(p.y + 1.8, 1.5, degrees[2]);
            const double north = leaning(1.8 - p.y, 1.5, degrees[3]);
            return std::max({west, east, south, north});
        };
        const auto anatomy = slabOf(150, {0.3, 0.1});
        const Surface askew = turnedSurface(cavity, 8.0);
        const Deviation d = compared(anatomy, askew, askew);
        for (std::size_t side = 0; side < 4; ++side)
            QVERIFY(near(d.form.wallDeg.at(side)->value, degrees.at(side), 1.0));
        QVERIFY(anatomy->grid.nodeMm(d.form.wallDeg[static_cast<std::size_t>(Side::PlusX)]->node).x > 1.5);
        QVERIFY(anatomy->grid.nodeMm(d.form.wallDeg[static_cast<std::size_t>(Side::MinusY)]->node).y < -1.3);
        QCOMPARE(d.buccalSign, 0);
    }

    void isthmusIsTheShortestRunAcross()
    {
        // Two rooms joined by a passage that is 1.1 mm wide in the middle and wider towards the rooms.
        const Surface rooms = [](glm::dvec2 p) {
            const double half = 0.55 + 0.25 * p.x * p.x;
            const double room =
                std::min(box(1.5, 3.0, 1.5)(p - glm::dvec2(2.0, 0.0)), box(1.5, 3.0, 1.5)(p + glm::dvec2(2.0, 0.0)));
            return std::min(room, std::abs(p.x) < 2.0 && std::abs(p.y) < half ? -1.5 : 1.0);
        };
        for (const double angle : {0.0, 17.0, 45.0}) {
            double worst = 0.0;
            for (const glm::dvec2 shift : lies(8)) {
                const auto anatomy = slabOf(150, shift);
                const Surface surface = turnedSurface(rooms, angle);
                Preparation preparation = ideal(*anatomy, surface);
                preparation.isthmus =
                    Preparation::Isthmus{{0.0, 0.0}, {-std::sin(angle * kDegree), std::cos(angle * kDegree)}, 1.0};
                // Cuts 0.1 mm wider and 0.3 mm aside.
                const Surface done = turnedSurface(
                    [&](glm::dvec2 p) {
                        return rooms({p.x, (p.y - 0.3) * 1.1 / 1.2});
                    },
                    angle);
                const Deviation d = measured(lowered(anatomy, done), preparation);
                worst = std::max(worst, std::abs(d.idealForm.isthmusMm->value - 1.1));
                worst = std::max(worst, std::abs(d.form.isthmusMm->value - 1.2));
            }
            // Along the lattice a width is a whole number of cells.
            QVERIFY(worst < (angle == 17.0 ? 0.04 : kExtentMm / 150 + 1.0e-6));
        }
    }

    void anInterruptedIsthmusHasNoWidth()
    {
        const auto anatomy = slabOf(150);
        Preparation preparation = ideal(*anatomy, box(4.0, 1.2, 1.5));
        preparation.isthmus = Preparation::Isthmus{};
        const Surface halves = [](glm::dvec2 p) { return std::abs(p.x) < 0.3 ? 1.0 : box(4.0, 1.2, 1.5)(p); };
        const Deviation d = measured(lowered(anatomy, halves), preparation);
        QCOMPARE(d.form.isthmusMm->value, 0.0);
        QVERIFY(near(d.idealForm.isthmusMm->value, 1.2, kExtentMm / 150));
        QVERIFY(!measured(terrain::Tooth(anatomy), preparation).form.isthmusMm.has_value());
        preparation.isthmus.reset();
        QVERIFY(!measured(lowered(anatomy, halves), preparation).form.isthmusMm.has_value());
    }

    void ridgesOfAGeneratedTooth()
    {
        const auto built = teeth::buildTooth(teeth::parseSource("36"), {});
        QVERIFY(built.has_value());
        const auto& anatomy = built->anatomy;
        const terrain::Grid& grid = anatomy->grid;
        for (const glm::dvec2 ends : {glm::dvec2(-3.0, 2.6), glm::dvec2(-2.03, 3.31)}) {
            const terrain::Tooth tooth = lowered(anatomy, [&](glm::dvec2 p) {
                return p.x > ends.x && p.x < ends.y && std::abs(p.y) < 0.7 ? -5.0 : 100.0;
            });
            // The expected value: the columns of each of these rows from the rim to the cut, in whole cells plus the
            // rim's share.
            double mesial = 100.0;
            double distal = 100.0;
            for (int j = 0; j < grid.side; ++j) {
                if (std::abs(grid.nodeMm(0, j).y) >= 0.7)
                    continue;
                double left = 0.0;
                double right = 0.0;
                for (int i = 0; i < grid.side; ++i) {
                    const std::size_t k = grid.index(i, j);
                    const double wide = static_cast<double>(anatomy->areaMm2[k]) / grid.cellMm;
                    (grid.nodeMm(i, j).x < 0.0 ? left : right) += tooth.top[k] == anatomy->top[k] ? wide : 0.0;
                }
                mesial = std::min(mesial, left);
                distal = std::min(distal, right);
            }
            Preparation preparation = ideal(*anatomy, [](glm::dvec2) { return 100.0; });
            const Deviation d = measured(tooth, preparation);
            QCOMPARE(d.buccalSign, -1);  // a lower tooth: +y is lingual
            QVERIFY(near(d.form.ridgeMesialMm->value, mesial, 0.02));
            QVERIFY(near(d.form.ridgeDistalMm->value, distal, 0.02));
            QVERIFY(near(grid.nodeMm(d.form.ridgeMesialMm->node).x, ends.x, 0.11));
            QVERIFY(!measured(terrain::Tooth(anatomy), preparation).form.ridgeMesialMm.has_value());
        }
    }

    void enamelWhoseRodsWereCutIsUnsupported()
    {
        // A wall at x = 0 with the cavity to its left and 1 mm of enamel. To the right the junction falls with slope g,
        // so a rod perpendicular to it has its foot further left. Above x, enamel higher than x (1 + g^2) / g over the
        // junction is unsupported: a triangle of height 1 at the wall and of length g.
        for (const double g : {0.0, 0.3, 0.6, -0.4})
            for (const double depth : {3.0, 0.5}) {
                support::Block made{.cellMm = kExtentMm / 150, .bottomMm = -9.0};
                auto anatomy = std::make_shared<terrain::ToothAnatomy>(*support::makeBlock(made));
                support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
                    anatomy->layers[k].dej = static_cast<float>(-1.0 - g * at.x);
                });
                const Surface surface = [&](glm::dvec2 p) {
                    return p.x < 0.0 && p.x > -1.0 && std::abs(p.y) < 2.0 ? -depth : 1.0;
                };
                const Deviation d = compared(anatomy, surface, surface);
                // A cut that stays in enamel undermines only rods that reach its wall above its floor. Where the
                // junction rises at this wall, it falls at the one at x = -1, under 1 - g of enamel.
                const double high = std::min(g >= 0.0 ? 1.0 : 1.0 - g, depth);
                const double expected = 4.0 * 0.5 * std::abs(g) * high * high;
                QVERIFY2(near(d.unsupportedEnamelMm3->value, expected, 0.03 + 0.06 * expected),
                         qPrintable(QStringLiteral("slope %1, depth %2").arg(g).arg(depth)));
                if (g > 0.0)
                    QVERIFY(near(anatomy->grid.nodeMm(d.unsupportedEnamelMm3->node).x, 0.0, 0.1));
            }
    }

    void rodsOfATooth()
    {
        if (support::kSanitized)
            QSKIP("the search it is compared with would take most of the time of all tests");
        // A slot through a molar with an oblique ridge, compared with a search of all feet for every 0.05 mm of enamel.
        teeth::BuildOptions options;
        options.gridSide = 64;
        options.caries.reset();
        const auto built = teeth::buildTooth(teeth::parseSource("26"), options);
        QVERIFY(built.has_value());
        const terrain::ToothAnatomy& anatomy = *built->anatomy;
        const terrain::Grid& grid = anatomy.grid;
        const terrain::Tooth tooth = lowered(
            built->anatomy, [](glm::dvec2 p) { return std::abs(p.x) < 2.9 && std::abs(p.y) < 0.8 ? -3.2 : 100.0; });
        const auto hasJunction = [&](std::size_t k) {
            const float dej = anatomy.layers[k].dej;
            return anatomy.top[k] > anatomy.bottom[k] && dej > anatomy.bottom[k] && dej < anatomy.top[k];
        };
        double mm3 = 0.0;
        for (std::size_t k = 0; k < grid.count(); ++k) {
            if (!tooth.isSolid(k) || !hasJunction(k))
                continue;
            const glm::dvec3 column(grid.nodeMm(k), 0.0);
            for (auto z = static_cast<double>(anatomy.layers[k].dej) + 0.025; z < static_cast<double>(tooth.top[k]);
                 z += 0.05) {
                const glm::dvec3 place = column + glm::dvec3(0.0, 0.0, z);
                glm::dvec3 foot = place;
                double nearest = 1.0e9;
                for (std::size_t n = 0; n < grid.count(); ++n) {
                    if (!hasJunction(n))
                        continue;
                    const glm::dvec3 there(grid.nodeMm(n), anatomy.layers[n].dej);
                    if (const double apart = glm::length(there - place); apart < nearest) {
                        nearest = apart;
                        foot = there;
                    }
                }
                bool stands = true;
                for (int step = 1; step <= 100 && stands; ++step) {
                    const glm::dvec3 on = place + (foot - place) * (0.01 * step);
                    const std::size_t n = nodeAt(grid, glm::dvec2(on));
                    stands = static_cast<double>(tooth.top[n]) >= on.z || on.z > static_cast<double>(anatomy.top[n]);
                }
                if (!stands)
                    mm3 += 0.05 * static_cast<double>(anatomy.areaMm2[k]);
            }
        }
        const Preparation preparation = ideal(anatomy, [](glm::dvec2) { return 100.0; });
        const double found = measured(tooth, preparation).unsupportedEnamelMm3->value;
        qInfo("%.3f mm3 by searching, %.3f mm3 found", mm3, found);
        QVERIFY(mm3 > 0.5);
        QVERIFY(near(found, mm3, 0.03 * mm3));
    }

    void enamelAboveDecayIsUnsupported()
    {
        const auto anatomy = support::slab(-2.0F);
        // In both directions, nodes 28 to 35 are within 0.4 mm of the middle.
        const auto isDecayed = [](glm::dvec2 at) { return std::abs(at.x) < 0.4 && std::abs(at.y) < 0.4; };
        support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            if (isDecayed(at)) {
                anatomy->layers[k].cariesRoof = -1.5F;
                anatomy->layers[k].cariesFloor = -3.0F;
            }
        });
        const Preparation preparation{grading::idealCavity(*anatomy), std::vector<Part>(64 * 64, Part::Keep), {}};
        const auto unsupported = [&](double leftMm, double rightMm) {
            const auto cut = [&](glm::dvec2 at) { return isDecayed(at) ? (at.x < 0.0 ? leftMm : rightMm) : 0.0; };
            return measured(lowered(anatomy, cut), preparation).unsupportedEnamelMm3->value;
        };
        QVERIFY(near(unsupported(0.0, 0.0), 64 * 0.01 * 1.5, 1.0e-6));
        QVERIFY(near(unsupported(-3.0, 0.0), 32 * 0.01 * 1.5, 1.0e-6));
        QVERIFY(near(unsupported(-3.0, -0.5), 32 * 0.01 * 1.0, 1.0e-6));
        // Without enamel on dentin, the volume is not measured.
        const auto plain = slabOf(64);
        QVERIFY(!measured(terrain::Tooth(plain), ideal(*plain, box(2.0, 2.0, 1.0))).unsupportedEnamelMm3.has_value());
    }

    void zonesOfThePracticePad()
    {
        // The target is 3 x 2 x 1.5 with a leeway of 0.3 to the sides and 0.2 below. The cut is 3.9 x 2 and 1.9 deep,
        // beyond the leeway in both directions.
        const grading::Leeway leeway{0.3, 0.2};
        for (const glm::dvec2 shift : lies(8)) {
            const auto anatomy = slabOf(150, shift);
            const Surface wanted = turnedSurface(box(3.0, 2.0, 1.5), 17.0);
            const Surface done = turnedSurface(box(3.9, 2.0, 1.9), 17.0);
            const auto d = grading::measureDeviation(lowered(anatomy, done), ideal(*anatomy, wanted), leeway);
            const grading::Zones& z = d->zones.value();
            const double sides = 1.7 * (2.0 * 0.3 * (3.0 + 2.0) + std::numbers::pi * 0.09);
            QVERIFY(near(z.targetMm3, 9.0, 0.05));
            QVERIFY(near(z.targetRemovedMm3, z.targetMm3, 1.0e-9));
            QVERIFY(near(z.leewayBottomMm3, 6.0 * 0.2, 0.01));
            QVERIFY(near(z.leewayBottomRemovedMm3, z.leewayBottomMm3, 1.0e-9));
            QVERIFY(near(z.leewaySidesMm3, sides, 0.03 * sides));
            QVERIFY(near(z.leewaySidesRemovedMm3, 1.7 * 2.0 * 2.0 * 0.3, 0.1));
            QVERIFY(near(z.containerBottomMm3.value, 0.2 * 2.0 * 3.6, 0.03));
            QVERIFY(near(z.containerSidesMm3.value, 1.9 * 2.0 * 0.3, 0.1));
            QVERIFY(!z.targetLeftNode.has_value());
            QVERIFY(std::abs(glm::dot(anatomy->grid.nodeMm(z.containerSidesMm3.node),
                                      glm::dvec2(std::cos(17.0 * kDegree), std::sin(17.0 * kDegree)))) > 1.75);
            // The parts add up to the removed volume.
            QVERIFY(near(z.targetRemovedMm3 + z.leewayBottomRemovedMm3 + z.leewaySidesRemovedMm3 +
                             z.containerBottomMm3.value + z.containerSidesMm3.value,
                         d->removedMm3, 1.0e-9));
        }
        const auto anatomy = slabOf(150);
        const auto untouched =
            grading::measureDeviation(terrain::Tooth(anatomy), ideal(*anatomy, box(3.0, 2.0, 1.5)), leeway);
        QCOMPARE(untouched->zones->targetRemovedMm3, 0.0);
        QVERIFY(untouched->zones->targetLeftNode.has_value());
        QVERIFY(!grading::measureDeviation(terrain::Tooth(anatomy), ideal(*anatomy, box(3.0, 2.0, 1.5)))->zones);
    }

    void aBurLeavesTheFormThatItWasLedIn()
    {
        // A straight fissure bur, 1 mm wide with an edge of 0.1 mm, moves along a line of 3 mm at a depth of 1.5 mm: a
        // trench with vertical walls.
        for (const double angle : {0.0, 17.0})
            for (const glm::dvec2 shift : lies(3)) {
                const auto anatomy = slabOf(150, shift);
                const glm::dvec2 along(std::cos(angle * kDegree), std::sin(angle * kDegree));
                const glm::dvec3 end(1.5 * along, 0.0);
                const glm::dvec3 down(0.0, 0.0, -1.5);
                const terrain::Tooth tooth = drilled(anatomy, "57", {-end, -end + down, end + down});
                const Surface wanted = turnedSurface(trench(3.0, 0.5, 1.5, 0.0), angle);
                Preparation preparation = ideal(*anatomy, wanted);
                preparation.isthmus = Preparation::Isthmus{{0.0, 0.0}, {-along.y, along.x}, 1.0};
                const Deviation d = measured(tooth, preparation);
                // The rounded edge leaves a fillet of 0.1 mm along the whole wall, with an area of 0.01 (1 - pi / 4)
                // per side.
                const double fillet = (6.0 + std::numbers::pi) * 0.01 * (1.0 - std::numbers::pi / 4.0);
                const double expected = trenchMm3(3.0, 0.5, 1.5, 0.0) - fillet;
                QVERIFY(near(d.removedMm3, expected, (angle == 0.0 ? 0.08 : 0.01) * expected));
                QVERIFY(near(d.depth->signedMm, 0.0, 0.01));
                QVERIFY(near(d.depth->p95Mm, 0.0, 0.01));
                QVERIFY(near(d.outline->meanMm, 0.0, 0.02));
                QVERIFY(near(d.outline->p95Mm, 0.0, 0.06));
                QVERIFY(near(d.form.isthmusMm->value, 1.0, 0.08));
                for (const std::optional<Placed>& wall : d.form.wallDeg)
                    QVERIFY(near(wall.value().value, 0.0, 1.0));
                QVERIFY(near(d.floor->flatnessMm, 0.0, 0.005));
                QVERIFY(near(d.floor->slopeDeg, 0.0, 0.2));
            }
    }

    void aTaperMilledInRings()
    {
        // The same bur moves in rings that narrow downwards: a frustum of 10 degrees whose wall has steps of 0.03 mm.
        const auto anatomy = slabOf(150, {0.4, 0.7});
        std::vector<glm::dvec3> way{{0.0, 0.0, 0.2}};
        for (double z = -0.03; z > -1.51; z -= 0.03)
            for (int n = 0; n <= 60; ++n) {
                const double out = 1.6 - 0.5 + z * std::tan(10.0 * kDegree);
                const double turn = 2.0 * std::numbers::pi * n / 60;
                way.emplace_back(out * std::cos(turn), out * std::sin(turn), z);
            }
        for (double radius = 0.6; radius > 0.0; radius -= 0.25)
            for (int n = 0; n <= 60; ++n) {
                const double turn = 2.0 * std::numbers::pi * n / 60;
                way.emplace_back(radius * std::cos(turn), radius * std::sin(turn), -1.5);
            }
        const terrain::Tooth tooth = drilled(anatomy, "57", way);
        const Deviation d = measured(tooth, ideal(*anatomy, round(1.6, 1.5, 10.0)));
        for (const std::optional<Placed>& wall : d.form.wallDeg)
            QVERIFY(near(wall.value().value, 10.0, 1.0));
        QVERIFY(d.outline->roughnessMm.value < 0.02);
        QVERIFY(near(d.depth->signedMm, 0.0, 0.01));
        QVERIFY(near(d.outline->meanMm, 0.0, 0.02));
    }

    void theIdealItselfHasNoDeviation()
    {
        const auto anatomy = slabOf(150, {0.2, 0.6}, -1.2);
        const Preparation preparation = ideal(*anatomy, turnedSurface(box(3.0, 2.0, 1.5, 6.0), 11.0));
        const Deviation d = measured(terrain::restored(anatomy, *preparation.top), preparation);
        QCOMPARE(d.overcutMm3(), 0.0);
        QCOMPARE(d.undercutMm3, 0.0);
        QCOMPARE(d.dice.value(), 1.0);
        QCOMPARE(d.iou.value(), 1.0);
        QVERIFY(!d.overcutNode && !d.undercutNode);
        QCOMPARE(d.depth->meanMm, 0.0);
        QCOMPARE(d.depth->p95Mm, 0.0);
        QVERIFY(d.outline->overMm.value < 1.0e-9 && d.outline->underMm.value < 1.0e-9);
        QCOMPARE(d.floor->flatnessMm, 0.0);
        QVERIFY(d.form == d.idealForm);
        QCOMPARE(d.unsupportedEnamelMm3->value, 0.0);
        QVERIFY(near(d.floor->intoDentinMm.value(), 0.3, 1.0e-6));
    }

    void nothingCut()
    {
        const auto anatomy = slabOf(150);
        const Deviation d = measured(terrain::Tooth(anatomy), ideal(*anatomy, box(3.0, 2.0, 1.5)));
        QCOMPARE(d.removedMm3, 0.0);
        QCOMPARE(d.overcutMm3(), 0.0);
        QCOMPARE(d.undercutMm3, d.idealMm3);
        QCOMPARE(d.dice.value(), 0.0);
        QCOMPARE(d.iou.value(), 0.0);
        QVERIFY(near(d.depth->signedMm, 1.5, 1.0e-6));
        QVERIFY(!d.outline);
        QVERIFY(!d.floor);
        for (const std::optional<Placed>& wall : d.form.wallDeg)
            QVERIFY(!wall);
    }

    void everythingCut()
    {
        const auto anatomy = slabOf(150, {0.0, 0.0}, -1.0);
        terrain::Tooth tooth(anatomy);
        tooth.top.assign(tooth.top.size(), terrain::kEmptyTop);
        tooth.bottom.assign(tooth.bottom.size(), terrain::kEmptyBottom);
        const auto d = grading::measureDeviation(tooth, ideal(*anatomy, box(3.0, 2.0, 1.5)), grading::Leeway{});
        QVERIFY(near(d->removedMm3, 6.0 * kExtentMm * kExtentMm, 0.01));
        QVERIFY(near(d->overcutMm3(), d->removedMm3 - d->idealMm3, 1.0e-6));
        QCOMPARE(d->undercutMm3, 0.0);
        QVERIFY(near(d->depth->tooDeepMm.value, 4.5, 1.0e-5));
        QCOMPARE(d->unsupportedEnamelMm3->value, 0.0);
        QVERIFY(near(d->zones->targetRemovedMm3, d->idealMm3, 1.0e-9));
    }

    void anEmptyIdeal()
    {
        const auto anatomy = slabOf(64);
        const Preparation nothing = ideal(*anatomy, [](glm::dvec2) { return 1.0; });
        const Deviation untouched = measured(terrain::Tooth(anatomy), nothing);
        QVERIFY(!untouched.dice && !untouched.iou && !untouched.depth && !untouched.outline && !untouched.floor);
        const Deviation cutAll = measured(lowered(anatomy, box(2.0, 2.0, 1.0)), nothing);
        QCOMPARE(cutAll.dice.value(), 0.0);
        QCOMPARE(cutAll.overcutBesideMm3, cutAll.removedMm3);
        // An ideal above the tooth removes nothing, and one below the underside removes the whole column.
        Preparation beyond = nothing;
        std::vector<float> top(anatomy->top.size(), 5.0F);
        top[100] = terrain::kEmptyTop;
        beyond.top = std::make_shared<const std::vector<float>>(top);
        QVERIFY(near(measured(terrain::Tooth(anatomy), beyond).idealMm3, 6.0 * std::pow(kExtentMm / 64, 2), 1.0e-6));
    }

    void refusesWhatIsNoIdealForThisTooth()
    {
        const auto anatomy = slabOf(150);
        const terrain::Tooth tooth(anatomy);
        const Preparation good = ideal(*anatomy, box(3.0, 2.0, 1.5));
        const auto isRefused = [&](const Preparation& preparation, ErrorCode code,
                                   const std::optional<grading::Leeway>& leeway = {}) {
            return support::isRefused(grading::measureDeviation(tooth, preparation, leeway), code);
        };
        QVERIFY(grading::measureDeviation(tooth, good).has_value());
        QVERIFY(isRefused(ideal(*slabOf(64), box(3.0, 2.0, 1.5)), ErrorCode::BadStructure));
        QVERIFY(isRefused({}, ErrorCode::BadStructure));
        Preparation partless = good;
        partless.parts.pop_back();
        QVERIFY(isRefused(partless, ErrorCode::BadStructure));
        Preparation broken = good;
        std::vector<float> top = *good.top;
        top[77] = std::numeric_limits<float>::quiet_NaN();
        broken.top = std::make_shared<const std::vector<float>>(top);
        QVERIFY(isRefused(broken, ErrorCode::BadNumber));
        terrain::Tooth spoilt(anatomy);
        spoilt.top[5] = std::numeric_limits<float>::quiet_NaN();
        QVERIFY(support::isRefused(grading::measureDeviation(spoilt, good), ErrorCode::BadNumber));
        for (const glm::dvec2 across : {glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 1.0), glm::dvec2(std::nan(""), 1.0)}) {
            Preparation crooked = good;
            crooked.isthmus = Preparation::Isthmus{{0.0, 0.0}, across, 1.0};
            QVERIFY(isRefused(crooked, ErrorCode::OutOfRange));
        }
        QVERIFY(isRefused(good, ErrorCode::OutOfRange, grading::Leeway{-0.1, 0.2}));
        QVERIFY(isRefused(good, ErrorCode::OutOfRange, grading::Leeway{0.1, std::nan("")}));
    }
};

CUSP_TEST(TestDeviation)
#include "tst_deviation.moc"
