// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/grading/Measures.h"
#include "core/preparation/OcclusalOutline.h"
#include "core/preparation/ToothPreparation.h"
#include "core/teeth/ToothBuilder.h"
#include "core/teeth/ToothGenerator.h"
#include "tests/support/Solids.h"

using namespace core;
using namespace core::preparation;
using grading::Part;
using grading::Preparation;

namespace {

constexpr std::array<int, 8> kTeeth{24, 25, 26, 27, 34, 35, 36, 37};

std::shared_ptr<const terrain::ToothAnatomy> anatomyOf(int fdi, std::uint64_t seed = 0, int side = 150)
{
    static std::map<std::tuple<int, std::uint64_t, int>, std::shared_ptr<const terrain::ToothAnatomy>> made;
    auto& anatomy = made[{fdi, seed, side}];
    if (!anatomy) {
        teeth::BuildOptions options;
        options.gridSide = side;
        options.seed = seed;
        options.caries.reset();
        anatomy = teeth::buildTooth({fdi}, options)->anatomy;
    }
    return anatomy;
}

Result<Preparation> usual(Kind kind, int fdi, std::uint64_t seed = 0, int side = 150)
{
    const auto design = fittedDesign(kind, *anatomyOf(fdi, seed, side));
    if (!design)
        return tl::unexpected<Error>(design.error());
    return makePreparation(kind, *design, *anatomyOf(fdi, seed, side));
}

/// What is cut, found column by column.
struct Findings
{
    double volumeMm3 = 0.0;
    double areaMm2 = 0.0;
    double floorMm2 = 0.0;
    double shallowestMm = 1.0e9;  ///< floor below the surface, fissures filled
    double deepestMm = 0.0;
    double meanMm = 0.0;
    double leastDentinMm = 1.0e9;  ///< of floor in dentin, below the junction; negative: in enamel
    double mostDentinMm = -1.0e9;
    double inDentinShare = 0.0;  ///< of the floor's area
    double ridgeMm = 1.0e9;      ///< from what is cut to the mesial or distal outline
    double overPulpMm = 0.0;
    double highestFloorMm = -1.0e9;
    double lowestFloorMm = 1.0e9;
    int islands = 0;  ///< connected pieces of what is cut
    int holes = 0;    ///< connected pieces of what is not, less one
};

int piecesOf(const terrain::Grid& grid, const std::vector<std::uint8_t>& in)
{
    std::vector<std::uint8_t> seen(in.size(), 0);
    int pieces = 0;
    std::vector<std::size_t> open;
    for (std::size_t start = 0; start < in.size(); ++start) {
        if (in[start] == 0 || seen[start] != 0)
            continue;
        ++pieces;
        open.assign(1, start);
        seen[start] = 1;
        while (!open.empty()) {
            const std::size_t k = open.back();
            open.pop_back();
            const int i = static_cast<int>(k % static_cast<std::size_t>(grid.side));
            const int j = static_cast<int>(k / static_cast<std::size_t>(grid.side));
            for (const auto& [di, dj] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)})
                if (grid.contains(i + di, j + dj))
                    if (const std::size_t n = grid.index(i + di, j + dj); in[n] != 0 && seen[n] == 0) {
                        seen[n] = 1;
                        open.push_back(n);
                    }
        }
    }
    return pieces;
}

Findings find(const Preparation& ideal, const terrain::ToothAnatomy& anatomy, const teeth::PosteriorForm* form)
{
    const terrain::Grid& grid = anatomy.grid;
    Findings found;
    std::vector<std::uint8_t> cut(grid.count(), 0);
    std::vector<std::uint8_t> kept(grid.count(), 0);
    // The proximal surfaces: what of the outline lies in the mesial and distal quarter.
    std::vector<glm::dvec2> proximal;
    if (form != nullptr)
        for (const glm::dvec2& p : form->outline(2000))
            if (std::abs(p.x) > std::abs(p.y))
                proximal.push_back(p);
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            cut[k] = ideal.parts[k] != Part::Keep ? 1 : 0;
            kept[k] = 1 - cut[k];
            if (cut[k] == 0)
                continue;
            const glm::dvec2 at = grid.nodeMm(i, j);
            const auto top = static_cast<double>(std::max((*ideal.top)[k], anatomy.bottom[k]));
            const auto area = static_cast<double>(anatomy.areaMm2[k]);
            found.areaMm2 += area;
            found.volumeMm3 += area * (static_cast<double>(anatomy.top[k]) - top);
            for (const glm::dvec2& p : proximal)
                found.ridgeMm = std::min(found.ridgeMm, glm::distance(p, at));
            if (ideal.parts[k] != Part::Floor)
                continue;
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
        }
    found.meanMm /= found.floorMm2;
    found.inDentinShare /= found.floorMm2;
    found.islands = piecesOf(grid, cut);
    found.holes = piecesOf(grid, kept) - 1;
    auto shared = std::make_shared<const terrain::ToothAnatomy>(anatomy);
    found.overPulpMm = grading::measure(terrain::restored(shared, *ideal.top)).remainingOverPulpMm;
    return found;
}

/// Shortest run of cut columns across the isthmus.
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

}  // namespace

class TestToothPreparation : public QObject
{
    Q_OBJECT

private slots:
    void figures();
};

/// Prints what the usual preparations come to.
void TestToothPreparation::figures()
{
    for (const std::uint64_t seed : {0, 1, 2, 3, 4, 5})
        for (const Kind kind : {Kind::ClassOne, Kind::ClassTwoMesial, Kind::ClassTwoDistal})
            for (const int fdi : kTeeth) {
                if (seed != 0 && kind != Kind::ClassOne)
                    continue;
                const auto ideal = usual(kind, fdi, seed);
                if (!ideal) {
                    qWarning("%d seed %d %s: %s", fdi, static_cast<int>(seed), kindId(kind).data(),
                             ideal.error().detail.c_str());
                    continue;
                }
                const auto form = teeth::posteriorForm(fdi, seed);
                const Findings f = find(*ideal, *anatomyOf(fdi, seed), &*form);
                qInfo("%d seed %d %-14s width %.2f depth %.2f (%.2f..%.2f) dentin %.2f..%.2f (%.0f %%) ridge %.2f pulp "
                      "%.2f "
                      "volume %.2f pieces %d holes %d",
                      fdi, static_cast<int>(seed), kindId(kind).data(),
                      ideal->isthmus ? isthmusOf(*ideal, anatomyOf(fdi, seed)->grid) : 0.0, f.meanMm, f.shallowestMm,
                      f.deepestMm, f.leastDentinMm, f.mostDentinMm, 100.0 * f.inDentinShare, f.ridgeMm, f.overPulpMm,
                      f.volumeMm3, f.islands, f.holes);
            }
}

QTEST_GUILESS_MAIN(TestToothPreparation)
#include "tst_tooth_preparation.moc"
