// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/grading/Deviation.h"
#include "core/grading/Measures.h"
#include "core/preparation/OcclusalOutline.h"
#include "core/preparation/ToothPreparation.h"
#include "core/teeth/ToothGenerator.h"
#include "tests/support/Checks.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

using namespace core;
using namespace core::preparation;
using grading::Part;
using grading::Preparation;

namespace {

constexpr std::array<int, 8> kTeeth{24, 25, 26, 27, 34, 35, 36, 37};

std::shared_ptr<const terrain::ToothAnatomy> anatomyOf(int fdi, std::uint64_t seed = 0, int side = 150)
{
    return support::soundTooth(fdi, side, seed);
}

Result<Preparation> usual(Kind kind, int fdi, std::uint64_t seed = 0, int side = 150)
{
    const auto design = fittedDesign(kind, *anatomyOf(fdi, seed, side));
    if (!design)
        return tl::unexpected<Error>(design.error());
    return makePreparation(kind, *design, *anatomyOf(fdi, seed, side));
}

/// Measurements of a preparation, taken column by column.
struct Findings
{
    double volumeMm3 = 0.0;
    double areaMm2 = 0.0;
    double floorMm2 = 0.0;
    double shallowestMm = 1.0e9;  ///< depth of the floor below the surface with its fissures filled
    double deepestMm = 0.0;
    double meanMm = 0.0;
    double leastDentinMm = 1.0e9;  ///< least depth of the floor below the junction; negative: in enamel
    double mostDentinMm = -1.0e9;
    double inDentinShare = 0.0;  ///< share of the floor's area
    double ridgeMm = 1.0e9;      ///< from the cut to the mesial or distal outline
    double overPulpMm = 0.0;
    double highestFloorMm = -1.0e9;
    double lowestFloorMm = 1.0e9;
    int islands = 0;  ///< connected pieces of the cut
    int holes = 0;    ///< connected pieces of the uncut area, less one
};

/// Returns the number of connected parts of the cut area, or of the uncut area.
int piecesOf(const Preparation& ideal, const terrain::Grid& grid, bool cut)
{
    std::vector<std::uint8_t> left(grid.count());
    for (std::size_t k = 0; k < left.size(); ++k)
        left[k] = (ideal.parts[k] != Part::Keep) == cut ? 1 : 0;
    int pieces = 0;
    for (auto next = left.begin(); (next = std::find(next, left.end(), 1)) != left.end(); ++pieces) {
        std::vector<int> open(1, static_cast<int>(next - left.begin()));
        while (!open.empty()) {
            const int i = open.back() % grid.side;
            const int j = open.back() / grid.side;
            open.pop_back();
            for (const auto& [ni, nj] : {std::pair(i, j), {i + 1, j}, {i - 1, j}, {i, j + 1}, {i, j - 1}})
                if (grid.contains(ni, nj) && std::exchange(left[grid.index(ni, nj)], 0) != 0)
                    open.push_back(nj * grid.side + ni);
        }
    }
    return pieces;
}

Findings find(const Preparation& ideal, const terrain::ToothAnatomy& anatomy, const teeth::PosteriorForm* form)
{
    const terrain::Grid& grid = anatomy.grid;
    Findings found;
    // The proximal surfaces: the outline in the mesial and distal quarters.
    std::vector<glm::dvec2> proximal;
    if (form != nullptr)
        for (const glm::dvec2& p : form->outline(2000))
            if (std::abs(p.x) > std::abs(p.y))
                proximal.push_back(p);
    support::eachNode(grid, [&](std::size_t k, const glm::dvec2& at) {
        if (ideal.parts[k] == Part::Keep)
            return;
        const auto top = static_cast<double>(std::max((*ideal.top)[k], anatomy.bottom[k]));
        const auto area = static_cast<double>(anatomy.areaMm2[k]);
        found.areaMm2 += area;
        found.volumeMm3 += area * (static_cast<double>(anatomy.top[k]) - top);
        for (const glm::dvec2& p : proximal)
            found.ridgeMm = std::min(found.ridgeMm, glm::distance(p, at));
        if (ideal.parts[k] != Part::Floor)
            return;
        const double surface = form != nullptr ? form->mouthMm(at) : static_cast<double>(anatomy.top[k]);
        const double dentin = static_cast<double>(anatomy.layers[k].dej) - top;
        found.floorMm2 += area;
        found.shallowestMm = std::min(found.shallowestMm, surface - top);
        found.deepestMm = std::max(found.deepestMm, surface - top);
        found.meanMm += area * (surface - top);
        found.leastDentinMm = std::min(found.leastDentinMm, dentin);
        found.mostDentinMm = std::max(found.mostDentinMm, dentin);
        found.inDentinShare += dentin > 0.0 ? area : 0.0;
        found.highestFloorMm = std::max(found.highestFloorMm, top);
        found.lowestFloorMm = std::min(found.lowestFloorMm, top);
    });
    found.meanMm /= found.floorMm2;
    found.inDentinShare /= found.floorMm2;
    found.islands = piecesOf(ideal, grid, true);
    found.holes = piecesOf(ideal, grid, false) - 1;
    auto shared = std::make_shared<const terrain::ToothAnatomy>(anatomy);
    found.overPulpMm = grading::measure(terrain::restored(shared, *ideal.top)).remainingOverPulpMm;
    return found;
}

/// Returns the shortest run of cut columns across the isthmus.
double isthmusOf(const Preparation& ideal, const terrain::Grid& grid)
{
    const auto isCut = [&](glm::dvec2 p) {
        const glm::dvec2 at = grid.latticeOf(p);
        const int i = static_cast<int>(std::lround(at.x));
        const int j = static_cast<int>(std::lround(at.y));
        return grid.contains(i, j) && ideal.parts[grid.index(i, j)] != Part::Keep;
    };
    constexpr double kStep = 0.005;
    const glm::dvec2 across = ideal.isthmus->across;
    const glm::dvec2 along{-across.y, across.x};
    double narrowest = 1.0e9;
    for (double s = -ideal.isthmus->lengthMm; s <= ideal.isthmus->lengthMm; s += 0.02) {
        const glm::dvec2 middle = ideal.isthmus->atMm + along * s;
        double width = 0.0;
        for (const double sign : {-1.0, 1.0})
            for (double t = 0.0; isCut(middle + across * (sign * t)); t += kStep)
                width += kStep;
        narrowest = std::min(narrowest, width);
    }
    return narrowest;
}

/// Returns the deviation of one preparation, cut into the tooth, from another one as the ideal.
grading::Deviation deviationOf(const Preparation& cut, const Preparation& ideal,
                               const std::shared_ptr<const terrain::ToothAnatomy>& anatomy)
{
    return grading::measureDeviation(terrain::restored(anatomy, *cut.top), ideal).value();
}

}  // namespace

class TestToothPreparation : public QObject
{
    Q_OBJECT

private slots:
    void classOneIsWhatTheBooksAskFor_data()
    {
        support::columns<int, int>("fdi", "seed");
        for (const int fdi : kTeeth)
            for (const int seed : {0, 1, 2, 3, 4, 5})
                if (support::isTried(fdi + seed))
                    QTest::addRow("%d seed %d", fdi, seed) << fdi << seed;
    }

    /// The limits are those of docs/teeth.md. Depths are those of every column of the floor, not of the groove alone.
    void classOneIsWhatTheBooksAskFor()
    {
        QFETCH(int, fdi);
        QFETCH(int, seed);
        const auto number = static_cast<std::uint64_t>(seed);
        const auto anatomy = anatomyOf(fdi, number);
        const auto design = fittedDesign(Kind::ClassOne, *anatomy);
        QVERIFY(support::succeeds(design));
        const auto ideal = makePreparation(Kind::ClassOne, *design, *anatomy);
        QVERIFY(support::succeeds(ideal));
        const auto form = teeth::posteriorForm(fdi, number);
        const Findings found = find(*ideal, *anatomy, &*form);
        const bool isTwo = fdi == 26 || fdi == 27 || fdi == 34;
        QCOMPARE(found.islands, isTwo ? 2 : 1);
        QCOMPARE(found.holes, 0);
        const double width = ideal->isthmus ? isthmusOf(*ideal, anatomy->grid) : 0.0;
        if (fdi != 34) {
            QVERIFY(ideal->isthmus.has_value());
            // A short isthmus is widened by the rounding into its dovetails.
            QVERIFY2(width > design->isthmusMm - anatomy->grid.cellMm && width < design->isthmusMm + 0.6,
                     qPrintable(QString::number(width)));
        }
        QVERIFY(found.meanMm > 1.4 && found.meanMm < 2.2);
        QVERIFY(found.shallowestMm > 0.85 && found.deepestMm < 3.0);
        // The pits of 34 are close to its lingual side, where enamel fills the column.
        QVERIFY(found.mostDentinMm < 1.25 && found.inDentinShare > (fdi == 34 ? 0.25 : 0.6));
        QVERIFY(found.ridgeMm >= design->ridgeMm - 0.01 && design->ridgeMm >= 0.8 - 1e-9);
        QVERIFY(found.overPulpMm >= 1.2);
        if (!isTwo)
            QCOMPARE(found.highestFloorMm, found.lowestFloorMm);
        for (std::size_t k = 0; k < ideal->parts.size(); ++k)
            if (ideal->parts[k] == Part::Keep)
                QVERIFY((*ideal->top)[k] == anatomy->top[k]);
            else
                QVERIFY((*ideal->top)[k] < anatomy->top[k]);
    }

    void obliqueRidgeIsNeverCrossed()
    {
        for (const int fdi : {26, 27})
            for (const std::uint64_t seed : {0U, 1U, 2U, 3U, 7U, 11U, 42U}) {
                const auto ideal = usual(Kind::ClassOne, fdi, seed);
                QVERIFY(support::succeeds(ideal));
                const std::vector<glm::dvec2> crest = obliqueCrest(fdi, *teeth::posteriorForm(fdi, seed));
                QVERIFY(crest.size() > 50);
                double nearest = 1.0e9;
                support::eachNode(anatomyOf(fdi, seed)->grid, [&](std::size_t k, const glm::dvec2& at) {
                    if (ideal->parts[k] != Part::Keep)
                        for (const glm::dvec2& p : crest)
                            nearest = std::min(nearest, glm::distance(p, at));
                });
                // Where two strokes join, the rounding removes a little of the ridge that each of them leaves.
                QVERIFY2(nearest > usualDesign(Kind::ClassOne, fdi)->obliqueMm - 0.2,
                         qPrintable(QString("%1 seed %2: %3 mm").arg(fdi).arg(seed).arg(nearest)));
            }
    }

    void outlineIsTheSameOnEveryGrid_data()
    {
        QTest::addColumn<int>("fdi");
        for (int n = 0; const int fdi : kTeeth)
            if (support::isTried(n++))
                QTest::addRow("%d", fdi) << fdi;
    }

    void outlineIsTheSameOnEveryGrid()
    {
        QFETCH(int, fdi);
        const auto fine = anatomyOf(fdi, 0, 300);
        const auto onFine = usual(Kind::ClassOne, fdi, 0, 300);
        QVERIFY(onFine);
        const auto form = teeth::posteriorForm(fdi, 0);
        const Findings best = find(*onFine, *fine, &*form);
        for (const int side : {64, 100, 150}) {
            const auto anatomy = anatomyOf(fdi, 0, side);
            QVERIFY(*fittedDesign(Kind::ClassOne, *anatomy) == *fittedDesign(Kind::ClassOne, *fine));
            const auto ideal = usual(Kind::ClassOne, fdi, 0, side);
            QVERIFY(ideal);
            const Findings found = find(*ideal, *anatomy, &*form);
            QCOMPARE(found.lowestFloorMm, best.lowestFloorMm);
            QCOMPARE(found.highestFloorMm, best.highestFloorMm);
            QVERIFY(std::abs(found.areaMm2 / best.areaMm2 - 1.0) < (side == 64 ? 0.08 : 0.04));
            QVERIFY(std::abs(found.volumeMm3 / best.volumeMm3 - 1.0) < (side == 64 ? 0.08 : 0.04));
            // A node may be cut on one grid and its neighbour on the other not, but only next to the outline.
            support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& node) {
                const bool isCut = ideal->parts[k] != Part::Keep;
                const glm::ivec2 at(glm::round(fine->grid.latticeOf(node)));
                const support::Nodes beside = support::around(fine->grid, at.x, at.y, 1);
                // At the edge, some neighbours are outside the grid, where nothing is cut.
                bool same = beside.highI - beside.lowI < 2 || beside.highJ - beside.lowJ < 2;
                support::eachOf(fine->grid, beside,
                                [&](std::size_t n) { same = same || (onFine->parts[n] != Part::Keep) == isCut; });
                QVERIFY(same);
            });
        }
    }

    void endsBalanceEachOther()
    {
        for (const int fdi : {25, 35, 36, 37}) {
            const auto anatomy = anatomyOf(fdi);
            const auto ideal = usual(Kind::ClassOne, fdi);
            double mesial = 0.0;
            double distal = 0.0;
            support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
                if (ideal->parts[k] != Part::Keep)
                    (at.x < 0.0 ? mesial : distal) += static_cast<double>(anatomy->areaMm2[k]);
            });
            QVERIFY(std::abs(mesial - distal) < 0.3 * (mesial + distal));
        }
    }

    void figuresDoWhatTheySay()
    {
        const auto anatomy = anatomyOf(37, 0, 300);
        const auto form = teeth::posteriorForm(37, 0);
        const ToothDesign usual = *usualDesign(Kind::ClassOne, 37);
        const auto made = [&](double ToothDesign::*value, double figure) {
            ToothDesign design = usual;
            design.*value = figure;
            return *makePreparation(Kind::ClassOne, design, *anatomy);
        };
        const auto found = [&](double ToothDesign::*value, double figure) {
            return find(made(value, figure), *anatomy, &*form);
        };
        for (const double width : {1.2, 1.6, 2.2}) {
            const double wide = isthmusOf(made(&ToothDesign::isthmusMm, width), anatomy->grid);
            // The rounding into grooves and dovetails widens the isthmus slightly.
            QVERIFY2(wide > width - anatomy->grid.cellMm && wide < width + 0.15,
                     qPrintable(QString("%1, not %2").arg(wide).arg(width)));
        }
        const double at15 = found(&ToothDesign::depthMm, 1.5).lowestFloorMm;
        QVERIFY(support::near(at15 - found(&ToothDesign::depthMm, 1.8).lowestFloorMm, 0.3, 1e-5));
        for (const double ridge : {2.3, 2.6})
            QVERIFY(found(&ToothDesign::ridgeMm, ridge).ridgeMm >= ridge - 0.01);
        const auto widensBy = [&](double ToothDesign::*value, double figure) {
            return found(value, figure).areaMm2 - found(value, 0.0).areaMm2;
        };
        QVERIFY(widensBy(&ToothDesign::dovetailMm, 0.6) > 0.5);
        QVERIFY(widensBy(&ToothDesign::grooveMm, 1.5) > 1.0);
    }

    /// Along the groove from the mesial end, the wall rises at the specified angle.
    void endWallsLeanAsAsked()
    {
        const auto anatomy = anatomyOf(37, 0, 600);
        const terrain::Grid& grid = anatomy->grid;
        for (const double degrees : {0.0, 5.0, 10.0}) {
            ToothDesign design = *usualDesign(Kind::ClassOne, 37);
            design.divergeDeg = degrees;
            const auto ideal = makePreparation(Kind::ClassOne, design, *anatomy);
            QVERIFY(ideal);
            // Finds the row that reaches furthest to the mesial side.
            int first = grid.side;
            int j = 0;
            for (int k = 0; k < grid.side * grid.side; ++k)
                if (ideal->parts[static_cast<std::size_t>(k)] != Part::Keep && k % grid.side < first) {
                    first = k % grid.side;
                    j = k / grid.side;
                }
            std::vector<std::pair<double, double>> wall;
            const double floor = find(*ideal, *anatomy, nullptr).lowestFloorMm;
            for (int i = first; i < grid.side / 2; ++i) {
                const double z = static_cast<double>((*ideal->top)[grid.index(i, j)]);
                if (ideal->parts[grid.index(i, j)] == Part::Wall && z > floor + design.lineAngleMm + 1e-4)
                    wall.emplace_back(grid.nodeMm(i, j).x, z);
            }
            if (degrees == 0.0) {
                QVERIFY(wall.size() <= 1);
                continue;
            }
            QVERIFY(wall.size() >= 4);
            const double run = wall.back().first - wall.front().first;
            const double rise = wall.front().second - wall.back().second;
            const double found = std::atan2(run, rise) * 180.0 / std::numbers::pi;
            QVERIFY2(std::abs(found - degrees) < 1.0, qPrintable(QString::number(found)));
        }
    }

    void floorCanFollowTheJunction()
    {
        const auto anatomy = anatomyOf(36);
        ToothDesign design = *usualDesign(Kind::ClassOne, 36);
        design.followsJunction = 1.0;
        design.intoDentinMm = 0.25;
        const auto ideal = makePreparation(Kind::ClassOne, design, *anatomy);
        QVERIFY(ideal);
        const Findings found = find(*ideal, *anatomy, nullptr);
        QVERIFY(std::abs(found.leastDentinMm - 0.25) < 1e-4 && std::abs(found.mostDentinMm - 0.25) < 1e-4);
        QVERIFY(found.highestFloorMm - found.lowestFloorMm > 0.2);
        QCOMPARE(found.islands, 1);
    }

    void boxOpensOutOfTheTooth_data()
    {
        support::columns<int, bool>("fdi", "isMesial");
        for (const int fdi : kTeeth)
            for (const bool isMesial : {true, false})
                QTest::addRow("%d %s", fdi, isMesial ? "mesial" : "distal") << fdi << isMesial;
    }

    void boxOpensOutOfTheTooth()
    {
        QFETCH(int, fdi);
        QFETCH(bool, isMesial);
        const Kind kind = isMesial ? Kind::ClassTwoMesial : Kind::ClassTwoDistal;
        const auto anatomy = anatomyOf(fdi);
        const auto design = fittedDesign(kind, *anatomy);
        const auto ideal = usual(kind, fdi);
        QVERIFY(support::succeeds(ideal));
        const auto form = teeth::posteriorForm(fdi, 0);
        const Findings found = find(*ideal, *anatomy, &*form);
        QVERIFY(found.overPulpMm >= 0.5);
        QVERIFY(found.highestFloorMm - found.lowestFloorMm > design->boxFloorMm - 1e-4);
        // On the side of the box the outermost columns are cut, on the other side they are not.
        double reach[2] = {0.0, 0.0};
        double tooth[2] = {0.0, 0.0};
        double gingivalMm2 = 0.0;
        double lowest = 0.0;
        for (std::size_t k = 0; k < ideal->parts.size(); ++k)
            if (ideal->parts[k] == Part::Floor && (*ideal->top)[k] > terrain::kEmptyTop)
                lowest = std::min(lowest, static_cast<double>((*ideal->top)[k]));
        support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            if (!(anatomy->top[k] > anatomy->bottom[k]))
                return;
            const int side = (at.x < 0.0) == isMesial ? 0 : 1;
            tooth[side] = std::max(tooth[side], std::abs(at.x));
            if (ideal->parts[k] == Part::Keep)
                return;
            reach[side] = std::max(reach[side], std::abs(at.x));
            if (std::abs(static_cast<double>((*ideal->top)[k]) - lowest) < 1e-4)
                gingivalMm2 += static_cast<double>(anatomy->areaMm2[k]);
        });
        QVERIFY(reach[0] > tooth[0] - 0.5);
        QVERIFY(reach[1] < tooth[1] - 0.9);
        // The columns of the box under the bulge, whose bottom is higher than the gingival floor, are cut through
        // completely.
        const double plan = design->boxWidthMm * design->boxAxialMm;
        QVERIFY2(gingivalMm2 > 0.15 * plan && gingivalMm2 < 1.1 * plan,
                 qPrintable(QString::number(gingivalMm2 / plan)));
        QVERIFY(!notModelled(kind).empty());
    }

    void aSlotIsABoxAlone_data() { boxOpensOutOfTheTooth_data(); }

    void aSlotIsABoxAlone()
    {
        QFETCH(int, fdi);
        QFETCH(bool, isMesial);
        const auto anatomy = anatomyOf(fdi);
        const auto ideal = usual(isMesial ? Kind::SlotMesial : Kind::SlotDistal, fdi);
        QVERIFY(support::succeeds(ideal));
        QVERIFY(ideal->box && !ideal->isthmus);
        const auto form = teeth::posteriorForm(fdi, 0);
        const Findings found = find(*ideal, *anatomy, &*form);
        QCOMPARE(found.islands, 1);
        QVERIFY(found.overPulpMm >= 2.0);
        // The cut is within the box, which is open to its side, and its floor is 0.5 below the widest part of the
        // tooth.
        const grading::Preparation::Box& box = *ideal->box;
        QVERIFY(box.outwards.x * (isMesial ? -1.0 : 1.0) > 0.9);
        const glm::dvec2 across{-box.outwards.y, box.outwards.x};
        double outermost = -1.0e9;
        double widestMm = 0.0;
        double cutOutermost = -1.0e9;
        support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            const double out = glm::dot(at - box.atMm, box.outwards);
            const double aside = std::abs(glm::dot(at - box.atMm, across));
            if (ideal->parts[k] != Part::Keep) {
                QVERIFY(aside < 0.5 * box.widthMm + 0.05 && out > -1.6);
                cutOutermost = std::max(cutOutermost, out);
            }
            if (anatomy->top[k] > anatomy->bottom[k] && aside < 0.3 && out > outermost) {
                outermost = out;
                widestMm = static_cast<double>(anatomy->top[k]);
            }
        });
        QVERIFY(cutOutermost > outermost - 0.1);
        QVERIFY2(box.floorMm < widestMm - 0.5, qPrintable(QString::number(widestMm - box.floorMm)));
        const auto axial = deviationOf(*ideal, *ideal, anatomy).form.axialDepthMm;
        QVERIFY(axial && axial->value > 1.2 && axial->value < 1.5);
    }

    void aBuccalExtensionOpensTheBuccalSurface_data()
    {
        support::columns<int, int>("fdi", "seed");
        for (const int fdi : {36, 37})
            for (const int seed : {0, 1, 2, 3, 4, 5})
                if (support::isTried(fdi + seed))
                    QTest::addRow("%d seed %d", fdi, seed) << fdi << seed;
    }

    void aBuccalExtensionOpensTheBuccalSurface()
    {
        QFETCH(int, fdi);
        QFETCH(int, seed);
        const auto anatomy = anatomyOf(fdi, static_cast<std::uint64_t>(seed));
        const auto ideal = usual(Kind::ClassOneBuccal, fdi, static_cast<std::uint64_t>(seed));
        QVERIFY(support::succeeds(ideal));
        QVERIFY(ideal->box && ideal->isthmus);
        const auto form = teeth::posteriorForm(fdi, static_cast<std::uint64_t>(seed));
        const Findings found = find(*ideal, *anatomy, &*form);
        QCOMPARE(found.islands, 1);
        QVERIFY(found.overPulpMm >= 2.0);
        const grading::Preparation::Box& box = *ideal->box;
        QVERIFY(box.outwards.y * form->ySign > 0.9);
        const terrain::Grid& grid = anatomy->grid;
        const auto idealAt = [&](glm::dvec2 place) {
            const glm::ivec2 node(grid.latticeOf(place) + 0.5);
            return static_cast<double>((*ideal->top)[grid.index(node.x, node.y)]);
        };
        QVERIFY(std::abs(idealAt(box.atMm - box.outwards * 0.5) - box.floorMm) < 1.0e-4);
        const double boxFloorMm = usualDesign(Kind::ClassOneBuccal, fdi)->boxFloorMm;
        QVERIFY(std::abs(idealAt(ideal->isthmus->atMm) - box.floorMm - boxFloorMm) < 1.0e-4);
        const grading::Deviation deviation = deviationOf(*ideal, *ideal, anatomy);
        QVERIFY(deviation.form.axialDepthMm->value > 1.0 && deviation.form.axialDepthMm->value < 1.5);
        QVERIFY(deviation.form.ridgeMesialMm->value > 1.9 && deviation.form.ridgeDistalMm->value > 1.9);
    }

    void aBoxIsMeasuredAgainstItsIdeal_data()
    {
        QTest::addColumn<int>("kind");
        QTest::newRow("Class II") << static_cast<int>(Kind::ClassTwoMesial);
        QTest::newRow("slot") << static_cast<int>(Kind::SlotDistal);
        QTest::newRow("step to the buccal") << static_cast<int>(Kind::ClassOneBuccal);
    }

    /// A cut 0.3 mm farther in, or 0.4 mm lower, has exactly that error and no other.
    void aBoxIsMeasuredAgainstItsIdeal()
    {
        QFETCH(int, kind);
        const auto boxed = static_cast<Kind>(kind);
        const auto anatomy = anatomyOf(36, 4);
        const ToothDesign design = *fittedDesign(boxed, *anatomy);
        const Preparation ideal = *makePreparation(boxed, design, *anatomy);
        const auto errorsOf = [&](double ToothDesign::*value, double more) {
            ToothDesign other = design;
            other.*value += more;
            const auto deviation = deviationOf(*makePreparation(boxed, other, *anatomy), ideal, anatomy);
            return std::pair(deviation.form.axialDepthMm->value - deviation.idealForm.axialDepthMm->value,
                             deviation.gingivalFloorErrorMm->value);
        };
        const auto [inwards, level] = errorsOf(&ToothDesign::boxAxialMm, 0.3);
        QVERIFY2(std::abs(inwards - 0.3) < 0.04 && level < 1.0e-4, qPrintable(QString::number(inwards)));
        const auto [depth, lower] = errorsOf(&ToothDesign::boxFloorMm, 0.4);
        QVERIFY2(std::abs(lower - 0.4) < 0.01 && std::abs(depth) < 0.04, qPrintable(QString::number(lower)));
        const auto [shallow, higher] = errorsOf(&ToothDesign::boxFloorMm, -0.2);
        QVERIFY2(std::abs(higher - 0.2) < 0.01 && std::abs(shallow) < 0.15, qPrintable(QString::number(shallow)));
    }

    /// The shell that is left before the neighbour does not count as an axial wall.
    void aShellBeforeABoxIsNoWall()
    {
        const auto anatomy = anatomyOf(36);
        const Preparation ideal = *usual(Kind::ClassTwoMesial, 36);
        std::vector<float> top = *ideal.top;
        support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            if (glm::dot(at - ideal.box->atMm, ideal.box->outwards) > -0.4)
                top[k] = anatomy->top[k];
        });
        const auto whole = deviationOf(ideal, ideal, anatomy).form.axialDepthMm;
        const auto shelled = grading::measureDeviation(terrain::restored(anatomy, top), ideal)->form.axialDepthMm;
        QCOMPARE(shelled->value, whole->value);
        QCOMPARE(grading::measureDeviation(terrain::Tooth(anatomy), ideal)->form.axialDepthMm->value, 0.0);
    }

    void theObliqueRidgeIsMeasuredAcross()
    {
        for (const int fdi : {26, 27}) {
            const auto anatomy = anatomyOf(fdi);
            const Preparation ideal = *usual(Kind::ClassOne, fdi);
            QVERIFY(!ideal.obliqueCrest.empty());
            const auto left = deviationOf(ideal, ideal, anatomy).form.obliqueRidgeMm;
            QVERIFY(left && left->value > 2.0 * usualDesign(Kind::ClassOne, fdi)->obliqueMm - 0.1);
            // If the cut is 0.2 mm wider on both sides, the ridge is narrower by as much. A trench across the ridge
            // leaves nothing of it.
            std::vector<float> wider = *ideal.top;
            std::vector<float> through = *ideal.top;
            const glm::dvec2 middle = ideal.obliqueCrest[ideal.obliqueCrest.size() / 2];
            support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
                if (glm::distance(at, middle) < 0.4)
                    through[k] = anatomy->top[k] - 1.0F;
                const glm::ivec2 node(anatomy->grid.latticeOf(at) + 0.5);
                support::eachOf(anatomy->grid, support::around(anatomy->grid, node.x, node.y, 3), [&](std::size_t n) {
                    if (ideal.parts[n] != Part::Keep && glm::distance(at, anatomy->grid.nodeMm(n)) < 0.2)
                        wider[k] = std::min(wider[k], anatomy->top[k] - 1.0F);
                });
            });
            const auto measured = [&](const std::vector<float>& top) {
                return grading::measureDeviation(terrain::restored(anatomy, top), ideal)->form.obliqueRidgeMm;
            };
            QVERIFY(std::abs(measured(wider)->value - (left->value - 0.4)) < 0.1);
            QCOMPARE(measured(through)->value, 0.0);
            QVERIFY(!measured(anatomy->top));
        }
        QVERIFY(usual(Kind::ClassOne, 36)->obliqueCrest.empty());
    }

    void accessTakesTheWholeRoofAndNoFloor()
    {
        for (const std::uint64_t seed : {0U, 1U, 2U, 3U})
            for (const int side : {100, 150, 300}) {
                const auto anatomy = anatomyOf(36, seed, side);
                const auto ideal = usual(Kind::Access, 36, seed, side);
                QVERIFY(support::succeeds(ideal));
                double highest = -1.0e9;
                for (std::size_t k = 0; k < ideal->parts.size(); ++k)
                    if (terrain::hasPulp(*anatomy, k))
                        highest = std::max(highest, static_cast<double>(anatomy->layers[k].pulpRoof));
                double roofMm2 = 0.0;
                for (std::size_t k = 0; k < ideal->parts.size(); ++k) {
                    if (!terrain::hasPulp(*anatomy, k))
                        continue;
                    const terrain::ColumnLayers& column = anatomy->layers[k];
                    // The roof over the chamber is removed completely, and its floor is not cut.
                    if (static_cast<double>(column.pulpRoof) > highest - 2.0) {
                        roofMm2 += static_cast<double>(anatomy->areaMm2[k]);
                        QVERIFY((*ideal->top)[k] <= column.pulpRoof);
                    }
                    QVERIFY((*ideal->top)[k] >= column.pulpFloor);
                }
                QVERIFY(roofMm2 > 8.0);
                const Findings found = find(*ideal, *anatomy, nullptr);
                QCOMPARE(found.islands, 1);
                QCOMPARE(found.holes, 0);
                QVERIFY(found.areaMm2 < 0.5 * 10.5 * 11.0);
            }
    }

    void accessOfAnIncisorSparesItsEdge()
    {
        for (const std::uint64_t seed : {0U, 1U, 2U, 3U}) {
            const auto anatomy = anatomyOf(21, seed);
            const auto ideal = usual(Kind::Access, 21, seed);
            QVERIFY(support::succeeds(ideal));
            double opened = 0.0;
            for (std::size_t k = 0; k < ideal->parts.size(); ++k) {
                if (ideal->parts[k] == Part::Keep)
                    continue;
                QVERIFY(anatomy->top[k] < -1.2F);
                const auto& column = anatomy->layers[k];
                if (terrain::hasPulp(*anatomy, k) && (*ideal->top)[k] < column.pulpRoof) {
                    opened += static_cast<double>(anatomy->areaMm2[k]);
                    QVERIFY((*ideal->top)[k] >= column.pulpFloor);
                }
            }
            const Findings found = find(*ideal, *anatomy, nullptr);
            QCOMPARE(found.islands, 1);
            QCOMPARE(found.holes, 0);
            QVERIFY(opened > 0.8);
        }
    }

    void reductionFollowsTheCusps_data()
    {
        QTest::addColumn<int>("fdi");
        for (const int fdi : kTeeth)
            QTest::newRow(std::to_string(fdi).c_str()) << fdi;
    }

    /// The reduction is 2.0 mm over functional cusps, and 1.5 mm over the others and over the mouth of the central
    /// groove.
    void reductionFollowsTheCusps()
    {
        QFETCH(int, fdi);
        for (const std::uint64_t seed : {0U, 1U, 2U}) {
            const auto anatomy = anatomyOf(fdi, seed);
            const auto ideal = usual(Kind::OcclusalReduction, fdi, seed);
            QVERIFY(support::succeeds(ideal));
            const auto form = teeth::posteriorForm(fdi, seed);
            const auto depthAt = [&](glm::dvec2 designMm) {
                const std::size_t k = support::nodeAt(anatomy->grid, form->toTooth(designMm));
                return static_cast<double>(anatomy->top[k] - (*ideal->top)[k]);
            };
            for (const teeth::Lobe& lobe : form->crown.design().lobes) {
                using teeth::Cusp;
                if (lobe.cusp == Cusp::None)
                    continue;
                const bool isBuccal =
                    lobe.cusp == Cusp::B || lobe.cusp == Cusp::MB || lobe.cusp == Cusp::DB || lobe.cusp == Cusp::D;
                const double asked = isBuccal == (fdi > 30) ? 2.0 : 1.5;
                QVERIFY2(
                    support::near(depthAt({lobe.x, lobe.y}), asked, 0.15),
                    qPrintable(
                        QString("seed %1, cusp %2: %3").arg(seed).arg(int(lobe.cusp)).arg(depthAt({lobe.x, lobe.y}))));
            }
            // Measures along the central groove, from its mouth.
            double sumMm = 0.0;
            int count = 0;
            for (double x = -1.5; x <= 1.5; x += 0.1, ++count) {
                glm::dvec2 groove(x, -2.0);
                for (double y = -2.0; y <= 2.0; y += 0.05)
                    if (form->mouthMm({x, y}) < form->mouthMm(groove))
                        groove.y = y;
                const std::size_t k = support::nodeAt(anatomy->grid, groove);
                sumMm += form->mouthMm(groove) - static_cast<double>((*ideal->top)[k]);
            }
            QVERIFY2(support::near(sumMm / count, 1.5, 0.2), qPrintable(QString::number(sumMm / count)));
            // Nothing is steeper than 45 degrees and no fissure is left: no place is lower than both its sides.
            const terrain::Grid& grid = anatomy->grid;
            const int run = static_cast<int>(std::ceil(0.3 / grid.cellMm));
            const auto floorAt = [&](int i, int j) -> std::optional<double> {
                const std::size_t k = grid.index(i, j);
                if (ideal->parts[k] != Part::Floor || !((*ideal->top)[k] > terrain::kEmptyTop))
                    return {};
                return static_cast<double>((*ideal->top)[k]);
            };
            for (int j = run; j < grid.side - run; ++j)
                for (int i = run; i < grid.side - run; ++i)
                    for (const auto& [di, dj] : {std::pair(run, 0), {0, run}}) {
                        const auto here = floorAt(i, j);
                        const auto one = floorAt(i - di, j - dj);
                        const auto other = floorAt(i + di, j + dj);
                        if (!here || !one || !other)
                            continue;
                        QVERIFY(std::abs(*here - *one) <= 1.01 * run * grid.cellMm);
                        QVERIFY(0.5 * (*one + *other) - *here < 0.1);
                    }
            const Findings found = find(*ideal, *anatomy, nullptr);
            QCOMPARE(found.islands, 1);
            QVERIFY(found.overPulpMm >= 0.5);
        }
        const double fine =
            find(*usual(Kind::OcclusalReduction, fdi, 0, 300), *anatomyOf(fdi, 0, 300), nullptr).volumeMm3;
        const double coarse = find(*usual(Kind::OcclusalReduction, fdi), *anatomyOf(fdi), nullptr).volumeMm3;
        QVERIFY(std::abs(coarse / fine - 1.0) < 0.03);
    }

    void everyKindAndFieldHasAName()
    {
        for (const Kind kind : {Kind::ClassOne, Kind::ClassOneBuccal, Kind::ClassTwoMesial, Kind::ClassTwoDistal,
                                Kind::SlotMesial, Kind::SlotDistal, Kind::Access, Kind::OcclusalReduction}) {
            QCOMPARE(*findKind(kindId(kind)), kind);
            QVERIFY(!notModelled(kind).empty());
            const ToothDesign usual = *usualDesign(kind, 36);
            QVERIFY(validate(kind, usual) && !notModelled(kind).empty());
            for (const auto& field : fieldsOf(kind)) {
                for (const double wrong : {field.minimum - 1.0, field.maximum + 1.0, std::nan("")}) {
                    ToothDesign design = usual;
                    design.*field.value = wrong;
                    QVERIFY(support::isRefused(validate(kind, design), field.id));
                }
            }
        }
        QVERIFY(!findKind("class9"));
    }

    void impossibleWishesAreRefused()
    {
        // The fissures of a scan are unknown.
        auto scan = std::make_shared<terrain::ToothAnatomy>(*anatomyOf(36));
        scan->name = "molar.stl";
        QVERIFY(support::isRefused(makePreparation(Kind::ClassOne, {}, *scan), "molar.stl"));
        QVERIFY(support::isRefused(fittedDesign(Kind::ClassOne, *scan), "fissures"));
        QVERIFY(support::isRefused(usualDesign(Kind::ClassOne, 21), "24"));
        QVERIFY(support::isRefused(makePreparation(Kind::Access, {}, *anatomyOf(26)), "21, 36"));
        for (const auto& [fdi, value, wish, about] : {std::tuple(36, &ToothDesign::isthmusMm, 0.7, "isthmus_mm"),
                                                      {36, &ToothDesign::lineAngleMm, 0.6, "line_angle_mm"},
                                                      {24, &ToothDesign::ridgeMm, 3.0, "ridge_mm"}}) {
            ToothDesign design = *usualDesign(Kind::ClassOne, fdi);
            design.*value = wish;
            QVERIFY(support::isRefused(makePreparation(Kind::ClassOne, design, *anatomyOf(fdi)), about));
        }
        ToothDesign deep = *usualDesign(Kind::ClassTwoMesial, 36);
        deep.boxAxialMm = 3.0;
        deep.boxFloorMm = 3.0;
        QVERIFY(support::isRefused(makePreparation(Kind::ClassTwoMesial, deep, *anatomyOf(36)), "pulp"));
    }
};

CUSP_TEST(TestToothPreparation)
#include "tst_tooth_preparation.moc"
