// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/Pulp.h"

#include <algorithm>
#include <cmath>

#include "core/base/Rng.h"
#include "core/teeth/Lattice.h"

namespace core::teeth {
namespace {

constexpr float kDentinBesideMm = 1.2F;  ///< to the root and the side: 1 mm and what may lie between lattice nodes
constexpr float kDentinAboveMm = 1.5F;   ///< to the enamel; a CT molar has 1.85 at least
constexpr double kCanalRadiusMm = 0.4;

/// A point on a map, mm.
struct Spot
{
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
};

double squared(double value)
{
    return value * value;
}

/// Highest points of a field, each the highest within `apartMm`, highest first.
std::vector<Spot> peaks(const terrain::Grid& grid, const Lattice& lattice, std::span<const float> field, double apartMm,
                        double lowest, std::size_t most)
{
    std::vector<Spot> found;
    const int reach = static_cast<int>(apartMm / lattice.cellMm());
    for (int b = 0; b < lattice.side(); ++b) {
        for (int a = 0; a < lattice.side(); ++a) {
            const float here = field[lattice.index(a, b)];
            if (static_cast<double>(here) < lowest)
                continue;
            bool highest = true;
            for (int nb = std::max(0, b - reach); highest && nb <= std::min(lattice.side() - 1, b + reach); ++nb) {
                for (int na = std::max(0, a - reach); na <= std::min(lattice.side() - 1, a + reach); ++na) {
                    const float there = field[lattice.index(na, nb)];
                    // Of two equal nodes the earlier one counts.
                    if (there > here || (there == here && lattice.index(na, nb) < lattice.index(a, b))) {
                        highest = false;
                        break;
                    }
                }
            }
            if (highest)
                found.push_back({grid.originMm.x + a * lattice.cellMm(), grid.originMm.y + b * lattice.cellMm(),
                                 static_cast<double>(here)});
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const Spot& p, const Spot& q) { return p.z > q.z; });
    found.resize(std::min(found.size(), most));
    return found;
}

/// Marks the columns that end where the model was cut off flat, as a scan of a crown is, and not at a root's surface:
/// what lies on the lowest level, if that is a face and no tip, and the tooth is clearly shorter than it should be.
std::vector<std::uint8_t> cutColumns(const terrain::Grid& grid, std::span<const float> top,
                                     std::span<const float> bottom, const TissueFigures& figures)
{
    constexpr float kFlatMm = 0.05F;
    constexpr double kFaceShare = 0.04;  ///< of the outline
    constexpr double kRootShare = 0.75;
    std::vector<std::uint8_t> cut(grid.count(), 0);
    const float lowest = *std::min_element(bottom.begin(), bottom.end());
    const auto highest = static_cast<double>(*std::max_element(top.begin(), top.end()));
    if (highest - static_cast<double>(lowest) > figures.crownHeight + kRootShare * figures.sizes.rootLengthMm)
        return cut;
    double face = 0.0;
    double outline = 0.0;
    for (std::size_t k = 0; k < grid.count(); ++k) {
        if (!(top[k] > bottom[k]))
            continue;
        cut[k] = bottom[k] <= lowest + kFlatMm ? 1 : 0;
        face += cut[k];
        outline += 1.0;
    }
    if (face < kFaceShare * outline)
        std::fill(cut.begin(), cut.end(), std::uint8_t{0});
    return cut;
}

/// The chamber seen from above: how far inside its outline each node lies.
struct Footprint
{
    std::vector<float> insideMm;  ///< 0 outside, [side * side]
    double deepestMm = 0.0;
    double centreX = 0.0;
    double centreY = 0.0;
    double leftX = 0.0;
    double rightX = 0.0;
};

Footprint footprintOf(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
                      std::span<const float> cervixMm, std::span<const std::uint8_t> cut, double wallMm)
{
    std::vector<std::uint8_t> neck(grid.count());
    for (std::size_t k = 0; k < neck.size(); ++k)
        neck[k] = top[k] > cervixMm[k] && (bottom[k] < cervixMm[k] - 0.5F || cut[k] != 0) ? 1 : 0;
    Footprint print;
    print.insideMm = distanceInside(grid, neck);
    const double widest = static_cast<double>(*std::max_element(print.insideMm.begin(), print.insideMm.end()));
    // A slender neck (lower incisor) has less wall than a broad one, never less than dentin needs.
    const double wall = std::max(static_cast<double>(kDentinBesideMm), std::min(wallMm, 0.66 * widest));

    double sum = 0.0;
    print.leftX = 1.0e9;
    print.rightX = -1.0e9;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            float& inside = print.insideMm[grid.index(i, j)];
            inside = std::max(0.0F, inside - static_cast<float>(wall));
            if (inside <= 0.0F)
                continue;
            const glm::dvec2 at = grid.nodeMm(i, j);
            print.centreX += at.x;
            print.centreY += at.y;
            print.leftX = std::min(print.leftX, at.x);
            print.rightX = std::max(print.rightX, at.x);
            print.deepestMm = std::max(print.deepestMm, static_cast<double>(inside));
            sum += 1.0;
        }
    }
    if (sum > 0.0) {
        print.centreX /= sum;
        print.centreY /= sum;
    }
    return print;
}

/// The place of the footprint nearest to (x, y) that lies at least `marginMm` inside its outline.
Spot pulledInside(const terrain::Grid& grid, const Footprint& print, double x, double y, double marginMm)
{
    const double margin = std::min(marginMm, 0.8 * print.deepestMm);
    Spot best;
    double nearest = 1.0e18;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            if (static_cast<double>(print.insideMm[grid.index(i, j)]) < margin)
                continue;
            const glm::dvec2 at = grid.nodeMm(i, j);
            const double distance = squared(at.x - x) + squared(at.y - y);
            if (distance < nearest) {
                nearest = distance;
                best = {at.x, at.y, 0.0};
            }
        }
    }
    return best;
}

/// What the pulp grows towards from above: cusp tips, or the thirds of an incisal edge.
std::vector<Spot> hornTargets(const terrain::Grid& grid, const Lattice& lattice, std::span<const float> top,
                              const TissueFigures& figures, const Footprint& print, double highest)
{
    if (figures.kind == ToothKind::Incisor) {
        const double third = 0.3 * (print.rightX - print.leftX);
        return {{print.centreX - third, print.centreY, highest},
                {print.centreX, print.centreY, highest},
                {print.centreX + third, print.centreY, highest}};
    }
    const std::vector<float> surface = lattice.pick(top, terrain::kEmptyTop);
    const std::vector<float> smooth = lattice.smooth(surface, 0.45, terrain::kEmptyTop);
    const std::size_t most = figures.kind == ToothKind::Canine ? 1 : figures.kind == ToothKind::Premolar ? 3 : 5;
    return peaks(grid, lattice, smooth, 1.3, highest - 3.2, most);
}

}  // namespace

void hollowPulp(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
                std::span<const float> cervixMm, const TissueFigures& figures, std::uint64_t seed,
                std::vector<terrain::ColumnLayers>& layers)
{
    Rng rng(seed ^ 0x70756C70ULL);
    const auto vary = [&](double deviation) {
        return seed == 0 ? 0.0 : deviation * std::clamp(rng.normal(), -2.0, 2.0);
    };
    const double highest = static_cast<double>(*std::max_element(top.begin(), top.end()));
    const double tipToHorn = figures.tipToHorn + vary(0.35);
    const double chamberHeight = figures.chamberHeight > 0.0 ? figures.chamberHeight + vary(0.25) : 0.0;
    const std::vector<std::uint8_t> cut = cutColumns(grid, top, bottom, figures);
    const bool isCut = std::find(cut.begin(), cut.end(), 1) != cut.end();
    const Footprint print = footprintOf(grid, top, bottom, cervixMm, cut, figures.pulpWall + vary(0.15));
    if (print.deepestMm < 0.1)
        return;

    // How far the pulp may go before dentin gets thinner than its least on any side.
    const Lattice lattice(grid);
    std::vector<float> junction(grid.count(), kNoValue);
    std::vector<float> minusBottom(grid.count(), kNoValue);
    for (std::size_t k = 0; k < grid.count(); ++k) {
        if (top[k] > bottom[k]) {
            junction[k] = std::max(layers[k].dej, bottom[k]);
            minusBottom[k] = cut[k] != 0 ? kNoValue : -bottom[k];  // a cut bounds no dentin
        } else {
            junction[k] = terrain::kEmptyTop;  // outside: no pulp beside it at any height
            minusBottom[k] = terrain::kEmptyTop;
        }
    }
    const std::vector<float> above(lattice.count(), kDentinAboveMm);
    const std::vector<float> beside(lattice.count(), kDentinBesideMm);
    const std::vector<float> ceiling = lattice.ballsBelow(lattice.pick(junction, terrain::kEmptyTop), above);
    const std::vector<float> minusGround = lattice.ballsBelow(lattice.pick(minusBottom, terrain::kEmptyTop), beside);

    struct Horn
    {
        Spot at;
        double apex = 0.0;
    };
    std::vector<Horn> horns;
    double roofMid = 0.0;
    for (const Spot& target : hornTargets(grid, lattice, top, figures, print, highest)) {
        Horn horn{pulledInside(grid, print, target.x, target.y, 0.35), 0.0};
        const double aside = squared(horn.at.x - target.x) + squared(horn.at.y - target.y);
        const double reach = tipToHorn + vary(0.2);
        horn.apex = target.z - std::sqrt(std::max(squared(0.8 * reach), squared(reach) - aside));
        roofMid += horn.apex;
        horns.push_back(horn);
    }
    roofMid = horns.empty() ? highest - tipToHorn : roofMid / static_cast<double>(horns.size());
    roofMid -= figures.hornHeight;

    // Canals open under the deepest places of the under surface: one to a root. Where the roots are cut off: over the
    // middle of each one's section, and towards where its end would be.
    double deepest = highest;
    for (std::size_t k = 0; k < grid.count(); ++k)
        if (top[k] > bottom[k])
            deepest = std::min(deepest, static_cast<double>(bottom[k]));
    if (isCut)
        deepest = std::min(deepest, highest - figures.crownHeight - figures.sizes.rootLengthMm);
    std::vector<Spot> canals;
    if (chamberHeight > 0.0) {
        const std::vector<float> section = isCut ? distanceInside(grid, cut) : minusBottom;
        const double least = isCut ? 0.6 * static_cast<double>(*std::max_element(section.begin(), section.end()))
                                   : -(highest + 0.75 * (deepest - highest));
        for (const Spot& apex : peaks(grid, lattice, lattice.pick(section, terrain::kEmptyTop), 1.5, least, 4))
            canals.push_back(pulledInside(grid, print, apex.x, apex.y, 0.3));
    }

    const double roundMm = chamberHeight > 0.0 ? std::min(0.8, print.deepestMm) : print.deepestMm;
    const double hornWidth = std::max(0.5, 0.55 * print.deepestMm);
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            const auto inside = static_cast<double>(print.insideMm[k]);
            if (inside <= 0.0)
                continue;
            const glm::dvec2 at = grid.nodeMm(i, j);
            const double dome = 1.0 - squared(1.0 - std::min(1.0, inside / roundMm));
            const auto neck = static_cast<double>(cervixMm[k]);

            double roof = 0.0;
            double floor = 0.0;
            if (chamberHeight > 0.0) {
                roof = roofMid - 0.6 * (1.0 - dome);
                floor = roofMid - chamberHeight + 0.4 * (1.0 - dome);
                for (const Spot& canal : canals) {
                    const double aside = std::sqrt(squared(at.x - canal.x) + squared(at.y - canal.y)) / kCanalRadiusMm;
                    if (aside < 1.0)
                        floor = std::min(floor, floor + (deepest + 1.5 - floor) * (1.0 - aside));
                }
            } else {
                roof = neck - 1.0 + (roofMid - (neck - 1.0)) * dome;
                const double depth = inside / print.deepestMm;
                floor = neck - 1.0 + (deepest + 1.5 - (neck - 1.0)) * depth * std::sqrt(depth);
            }
            for (const Horn& horn : horns) {
                const double aside = std::sqrt(squared(at.x - horn.at.x) + squared(at.y - horn.at.y)) / hornWidth;
                if (aside < 1.0)
                    roof = std::max(roof, roof + (horn.apex - roof) * squared(1.0 - aside) * (1.0 + 2.0 * aside));
            }

            const float highLimit = lattice.at(ceiling, i, j);
            const float lowLimit = -lattice.at(minusGround, i, j);
            const float pulpRoof = std::min(static_cast<float>(roof), highLimit);
            const float pulpFloor = std::max({static_cast<float>(floor), lowLimit, bottom[k]});
            if (pulpRoof - pulpFloor > 0.05F) {
                layers[k].pulpRoof = pulpRoof;
                layers[k].pulpFloor = pulpFloor;
            }
        }
    }
}

}  // namespace core::teeth
