// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grading/Measures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/grading/Columns.h"
#include "core/grading/Perforation.h"

namespace core::grading {
namespace {

using terrain::ColumnLayers;
using terrain::hasPulp;
using terrain::Material;
using terrain::PerMaterial;
using terrain::Tooth;
using terrain::ToothAnatomy;

constexpr double kFarMm = 5.0;

double of(const PerMaterial& lengths, Material material)
{
    return lengths[static_cast<std::size_t>(material)];
}

double soundOf(const PerMaterial& lengths)
{
    return of(lengths, Material::Enamel) + of(lengths, Material::Dentin);
}

/// Returns the height to which a column has to be cut to remove its decay, mm; its top if no decay has to be removed.
float neededDownTo(const ToothAnatomy& anatomy, std::size_t k)
{
    const ColumnLayers& column = anatomy.layers[k];
    const float down = std::max(anatomy.bottom[k], decayGoesDownTo(anatomy, k));
    const bool decayed = of(terrain::lengthsBetween(column, down, anatomy.top[k]), Material::Caries) > 0.0;
    return decayed ? down : anatomy.top[k];
}

double largestIsland(const Tooth& tooth)
{
    const terrain::Grid& grid = tooth.grid();
    std::vector<std::uint8_t> seen(grid.count(), 0);
    std::vector<std::size_t> open;
    double largest = 0.0;
    for (std::size_t start = 0; start < grid.count(); ++start) {
        if (seen[start] != 0 || !decayIn(tooth, start).any())
            continue;
        double volume = 0.0;
        open.assign(1, start);
        seen[start] = 1;
        while (!open.empty()) {
            const std::size_t k = open.back();
            open.pop_back();
            const Decay here = decayIn(tooth, k);
            volume += (static_cast<double>(here.roof) - static_cast<double>(here.floor)) *
                      static_cast<double>(tooth.anatomy->areaMm2[k]);
            const int i = static_cast<int>(k % static_cast<std::size_t>(grid.side));
            const int j = static_cast<int>(k / static_cast<std::size_t>(grid.side));
            const auto visit = [&](int ni, int nj) {
                if (!grid.contains(ni, nj) || seen[grid.index(ni, nj)] != 0)
                    return;
                const Decay there = decayIn(tooth, grid.index(ni, nj));
                if (!there.any() || std::min(here.roof, there.roof) < std::max(here.floor, there.floor))
                    return;
                seen[grid.index(ni, nj)] = 1;
                open.push_back(grid.index(ni, nj));
            };
            visit(i + 1, j);
            visit(i - 1, j);
            visit(i, j + 1);
            visit(i, j - 1);
        }
        largest = std::max(largest, volume);
    }
    return largest;
}

constexpr int kTileSide = 8;

/// A square of columns with its extreme height: the lowest end, or the highest roof.
struct Tile
{
    int i = 0;
    int j = 0;
    double heightMm = 0.0;
};

/// Returns the tiles in which `heightOf` has a value that is not NaN. With `sign` -1 they store lowest heights.
template <class HeightOf>
std::vector<Tile> tilesWith(const terrain::Grid& grid, double sign, HeightOf heightOf)
{
    std::vector<Tile> tiles;
    for (int j0 = 0; j0 < grid.side; j0 += kTileSide) {
        for (int i0 = 0; i0 < grid.side; i0 += kTileSide) {
            double most = -std::numeric_limits<double>::infinity();
            for (int j = j0; j < std::min(grid.side, j0 + kTileSide); ++j)
                for (int i = i0; i < std::min(grid.side, i0 + kTileSide); ++i)
                    if (const double height = heightOf(grid.index(i, j)); !std::isnan(height))
                        most = std::max(most, sign * height);
            if (std::isfinite(most))
                tiles.push_back({i0, j0, sign * most});
        }
    }
    return tiles;
}

struct NearestPulp
{
    double mm = kFarMm;
    std::optional<std::size_t> node;  ///< the cut column
};

/// Returns the shortest distance from any cut surface to any pulp, at most kFarMm. Pairs of tiles that cannot contain a
/// shorter one are skipped; the others are compared column by column.
NearestPulp remainingOverPulp(const Tooth& tooth)
{
    const ToothAnatomy& anatomy = *tooth.anatomy;
    const terrain::Grid& grid = tooth.grid();
    const auto roofOf = [&](std::size_t k) {
        return hasPulp(anatomy, k) ? static_cast<double>(anatomy.layers[k].pulpRoof) : std::nan("");
    };
    const auto cutEnd = [&](std::size_t k) {
        return isCut(tooth, k) ? static_cast<double>(endOf(tooth, k)) : std::nan("");
    };
    const std::vector<Tile> pulps = tilesWith(grid, 1.0, roofOf);
    const std::vector<Tile> cuts = tilesWith(grid, -1.0, cutEnd);

    const auto apart = [&](int di, int dj, double over) {
        return std::sqrt(grid.cellMm * grid.cellMm * (1.0 * di * di + 1.0 * dj * dj) + over * over);
    };
    const auto least = [&](const Tile& pulp, const Tile& cut) {
        const int di = std::max(0, std::abs(pulp.i - cut.i) - (kTileSide - 1));
        const int dj = std::max(0, std::abs(pulp.j - cut.j) - (kTileSide - 1));
        return apart(di, dj, std::max(0.0, cut.heightMm - pulp.heightMm));
    };
    NearestPulp nearest;
    const auto compare = [&](const Tile& pulp, const Tile& cut) {
        for (int j = pulp.j; j < std::min(grid.side, pulp.j + kTileSide); ++j) {
            for (int i = pulp.i; i < std::min(grid.side, pulp.i + kTileSide); ++i) {
                const double roof = roofOf(grid.index(i, j));
                if (std::isnan(roof))
                    continue;
                for (int nj = cut.j; nj < std::min(grid.side, cut.j + kTileSide); ++nj) {
                    for (int ni = cut.i; ni < std::min(grid.side, cut.i + kTileSide); ++ni) {
                        const double end = cutEnd(grid.index(ni, nj));
                        if (std::isnan(end))
                            continue;
                        if (const double mm = apart(ni - i, nj - j, std::max(0.0, end - roof)); mm < nearest.mm)
                            nearest = {mm, grid.index(ni, nj)};
                    }
                }
            }
        }
    };

    // Starts with the pair of tiles that has the shortest bound: its result excludes nearly all others.
    const Tile* bestPulp = nullptr;
    const Tile* bestCut = nullptr;
    double promise = kFarMm;
    for (const Tile& pulp : pulps) {
        for (const Tile& cut : cuts) {
            if (least(pulp, cut) < promise) {
                promise = least(pulp, cut);
                bestPulp = &pulp;
                bestCut = &cut;
            }
        }
    }
    if (bestPulp == nullptr)
        return nearest;
    compare(*bestPulp, *bestCut);
    for (const Tile& pulp : pulps)
        for (const Tile& cut : cuts)
            if (least(pulp, cut) < nearest.mm)
                compare(pulp, cut);
    return nearest;
}

}  // namespace

double overcutOf(const ToothAnatomy& anatomy, std::size_t k, float top)
{
    const float now = std::max(top, anatomy.bottom[k]);
    if (!wasSolid(anatomy, k) || !(now < anatomy.top[k]))
        return 0.0;
    const float needed = neededDownTo(anatomy, k);
    if (!(now < needed))
        return 0.0;
    return soundOf(terrain::lengthsBetween(anatomy.layers[k], now, needed)) * static_cast<double>(anatomy.areaMm2[k]);
}

Measures measure(const Tooth& tooth, const IdealTop& ideal)
{
    const ToothAnatomy& anatomy = *tooth.anatomy;
    Measures result;
    result.removedMm3 = terrain::removedVolumes(tooth);
    bool anyCut = false;
    bool anyPulp = false;
    double mostOvercutMm3 = 0.0;
    double mostCariesMm3 = 0.0;
    double deepestInPulpMm = -1.0;
    const std::vector<std::uint8_t> holes = perforationsBeside(tooth, ideal);
    for (std::size_t k = 0; k < anatomy.top.size(); ++k) {
        if (!wasSolid(anatomy, k))
            continue;
        const ColumnLayers& column = anatomy.layers[k];
        const auto area = static_cast<double>(anatomy.areaMm2[k]);
        const float top = anatomy.top[k];
        const float bottom = anatomy.bottom[k];
        const float now = endOf(tooth, k);

        const double lesion = of(terrain::lengthsBetween(column, bottom, top), Material::Caries);
        result.lesionMm3 += lesion * area;
        const float needed = neededDownTo(anatomy, k);
        result.accessMm3 += soundOf(terrain::lengthsBetween(column, needed, top)) * area;
        if (anatomy.hasDecayZones)
            result.decayToKeepMm3 += of(terrain::lengthsBetween(column, bottom, needed), Material::Caries) * area;
        if (tooth.isSolid(k)) {
            const double left =
                of(terrain::lengthsBetween(column, tooth.bottom[k], tooth.top[k]), Material::Caries) * area;
            result.cariesLeftMm3 += left;
            if (left > mostCariesMm3) {
                mostCariesMm3 = left;
                result.cariesLeftNode = k;
            }
        }
        anyPulp = anyPulp || hasPulp(anatomy, k);
        if (!(now < top))
            continue;
        anyCut = true;
        if (const double depth = static_cast<double>(top) - static_cast<double>(now); depth > result.deepestCutMm) {
            result.deepestCutMm = depth;
            result.deepestCutNode = k;
        }
        const double overcut = overcutOf(anatomy, k, now);
        result.overcutMm3 += overcut;
        if (overcut > mostOvercutMm3) {
            mostOvercutMm3 = overcut;
            result.overcutNode = k;
        }
        if (const double exposed = pulpExposedMm2(anatomy, k, now); exposed > 0.0) {
            result.pulpExposedMm2 += exposed;
            if (const double in = static_cast<double>(column.pulpRoof) - static_cast<double>(now);
                in > deepestInPulpMm) {
                deepestInPulpMm = in;
                result.pulpNode = k;
            }
        }
        if (!holes.empty() && holes[k] != 0)
            result.perforatedMm2 += area;
    }
    if (result.lesionMm3 > 0.0) {
        result.cariesLeftPercent = 100.0 * (result.cariesLeftMm3 / result.lesionMm3);
        result.largestIslandMm3 = largestIsland(tooth);
    }
    result.hasRemainingOverPulp = anyCut && anyPulp;
    if (result.hasRemainingOverPulp && !result.pulpNode) {
        const NearestPulp nearest = remainingOverPulp(tooth);
        result.remainingOverPulpMm = nearest.mm;
        result.pulpNode = nearest.node;
    }
    return result;
}

}  // namespace core::grading
