// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/Pulp.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/base/Rng.h"
#include "core/teeth/Lattice.h"

namespace core::teeth {
namespace {

constexpr float kDentinBesideMm = 1.2F;  ///< towards the root and the side: 1 mm, plus the distance of lattice nodes
constexpr float kDentinAboveMm = 1.5F;   ///< towards the enamel; a CT molar has at least 1.85
constexpr double kCanalRadiusMm = 0.4;
constexpr double kLeastHorn = 0.35;  ///< height of the lowest horn of a molar, as a share of the highest

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

/// Returns the peaks of a field, in descending order. A peak is the highest point within `apartMm`.
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
                    // Of two nodes of equal height, the first one counts.
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

/// Marks the columns that end where the model was cut off flat, like the scan of a crown, instead of at the surface of
/// a root. They are on the lowest level, if that level is a face and not a tip, and if the tooth is clearly too short.
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

/// The chamber seen from above, as the distance of each node inside its outline.
struct Footprint
{
    std::vector<float> insideMm;  ///< 0 outside, [side * side]
    double deepestMm = 0.0;
    double centreX = 0.0;
    double centreY = 0.0;
    double leftX = 0.0;
    double rightX = 0.0;
};

/// Moves the mesial and the distal wall of a footprint to their places in the figures. At least kDentinBesideMm of
/// dentin remain.
/// @param inNeckMm  distance of each node inside the neck's outline, [side * side]
void shiftWalls(const terrain::Grid& grid, std::span<const float> inNeckMm, const TissueFigures& figures,
                std::vector<float>& insideMm)
{
    const int from = static_cast<int>(std::lround((figures.distalWall - figures.pulpWall) / grid.cellMm));
    const int to = static_cast<int>(std::lround((figures.pulpWall - figures.mesialWall) / grid.cellMm));
    if (to < from || (from == 0 && to == 0))
        return;
    const std::vector<float> before = insideMm;
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            float& inside = insideMm[grid.index(i, j)];
            inside = 0.0F;
            for (int distal = i + from; distal <= i + to; ++distal)
                if (grid.contains(distal, j))
                    inside = std::max(inside, before[grid.index(distal, j)]);
            inside = std::max(0.0F, std::min(inside, inNeckMm[grid.index(i, j)] - kDentinBesideMm));
        }
}

/// Makes the buccal and the lingual side of a footprint converge distally, so that it becomes a trapezoid.
void taper(const terrain::Grid& grid, double degrees, std::vector<float>& insideMm)
{
    if (degrees <= 0.0)
        return;
    double left = 1.0e9;
    double low = 1.0e9;
    double high = -1.0e9;
    for (std::size_t k = 0; k < grid.count(); ++k) {
        if (insideMm[k] <= 0.0F)
            continue;
        const glm::dvec2 at = grid.nodeMm(k);
        left = std::min(left, at.x);
        low = std::min(low, at.y);
        high = std::max(high, at.y);
    }
    const double slope = std::tan(degrees * std::numbers::pi / 180.0);
    const double shorter = 1.0 / std::sqrt(1.0 + slope * slope);
    for (std::size_t k = 0; k < grid.count(); ++k) {
        const glm::dvec2 at = grid.nodeMm(k);
        const double side = 0.5 * (high - low) - std::abs(at.y - 0.5 * (high + low)) - slope * (at.x - left);
        insideMm[k] = std::max(0.0F, std::min(insideMm[k], static_cast<float>(side * shorter)));
    }
}

Footprint footprintOf(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
                      std::span<const float> cervixMm, std::span<const std::uint8_t> cut, const TissueFigures& figures,
                      double wallChangeMm)
{
    std::vector<std::uint8_t> neck(grid.count());
    for (std::size_t k = 0; k < neck.size(); ++k)
        neck[k] = top[k] > cervixMm[k] && (bottom[k] < cervixMm[k] - 0.5F || cut[k] != 0) ? 1 : 0;
    Footprint print;
    const std::vector<float> inNeck = distanceInside(grid, neck);
    print.insideMm = inNeck;
    const double widest = static_cast<double>(*std::max_element(print.insideMm.begin(), print.insideMm.end()));
    // A slender neck (lower incisor) has a thinner wall than a broad one, but never thinner than the least dentin.
    const double wall =
        std::max(static_cast<double>(kDentinBesideMm), std::min(figures.pulpWall + wallChangeMm, 0.66 * widest));
    for (float& inside : print.insideMm)
        inside = std::max(0.0F, inside - static_cast<float>(wall));
    shiftWalls(grid, inNeck, figures, print.insideMm);
    taper(grid, figures.pulpTaperDeg, print.insideMm);

    double sum = 0.0;
    print.leftX = 1.0e9;
    print.rightX = -1.0e9;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const float inside = print.insideMm[grid.index(i, j)];
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

/// Returns the position that is nearest to (x, y) and at least `marginMm` inside the outline of the footprint.
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

/// Returns the central fossa of a molar: the lowest place of its surface, with fissures filled, near the middle of its
/// outline.
std::optional<Spot> centralFossa(const terrain::Grid& grid, const Lattice& lattice, std::span<const float> top,
                                 const TissueFigures& figures)
{
    constexpr double kFissureHalfMouth = 0.35;
    constexpr double kNear = 0.3;  // share of half the width of the crown
    if (figures.fossaToPulp <= 0.0)
        return std::nullopt;
    glm::dvec2 low(1.0e9);
    glm::dvec2 high(-1.0e9);
    for (std::size_t k = 0; k < grid.count(); ++k)
        if (top[k] > terrain::kEmptyTop) {
            low = glm::min(low, grid.nodeMm(k));
            high = glm::max(high, grid.nodeMm(k));
        }
    const glm::dvec2 middle = 0.5 * (low + high);
    const glm::dvec2 reach = 0.5 * kNear * (high - low);
    const std::vector<float> filled =
        lattice.close(lattice.pick(top, terrain::kEmptyTop), kFissureHalfMouth, terrain::kEmptyTop);
    std::optional<Spot> fossa;
    for (int b = 0; b < lattice.side(); ++b)
        for (int a = 0; a < lattice.side(); ++a) {
            const Spot spot{grid.originMm.x + a * lattice.cellMm(), grid.originMm.y + b * lattice.cellMm(),
                            static_cast<double>(filled[lattice.index(a, b)])};
            const glm::dvec2 aside = (glm::dvec2(spot.x, spot.y) - middle) / reach;
            if (spot.z > static_cast<double>(terrain::kEmptyTop) && glm::dot(aside, aside) < 1.0 &&
                (!fossa || spot.z < fossa->z))
                fossa = spot;
        }
    return fossa;
}

/// Returns the points towards which the horns of the pulp grow: cusp tips, or the thirds of an incisal edge.
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

/// Divides the canal of the mesial root of a lower molar, which has two canals: a buccal and a lingual one.
void divideMesial(const terrain::Grid& grid, const Footprint& print, const TissueFigures& figures,
                  std::vector<Spot>& canals)
{
    constexpr double kAsideMm = 1.5;
    if (figures.mesialCanals < 2 || canals.size() < 2)
        return;
    const auto mesial =
        std::min_element(canals.begin(), canals.end(), [](const Spot& a, const Spot& b) { return a.x < b.x; });
    const Spot middle = *mesial;
    *mesial = pulledInside(grid, print, middle.x, middle.y - kAsideMm, 0.3);
    canals.push_back(pulledInside(grid, print, middle.x, middle.y + kAsideMm, 0.3));
}

/// Draws the deviation of a measure of one tooth from the mean. It is zero for seed 0.
class Variation
{
public:
    explicit Variation(std::uint64_t seed) : m_rng(seed ^ 0x70756C70ULL), m_isMean(seed == 0) {}
    double operator()(double deviation) { return m_isMean ? 0.0 : deviation * std::clamp(m_rng.normal(), -2.0, 2.0); }

private:
    Rng m_rng;
    bool m_isMean;
};

struct Horn
{
    Spot at;
    double apex = 0.0;
};

/// The form of a pulp, before the dentin around it limits it.
struct PulpForm
{
    Footprint print;
    double chamberHeight = 0.0;  ///< 0: no separate chamber, as in front teeth
    std::vector<Horn> horns;
    double roofMid = 0.0;  ///< height of the roof between the horns
    std::optional<Spot> fossa;
    double fossaToPulp = 0.0;
    double deepest = 0.0;  ///< height of the deepest end of a root
    std::vector<Spot> canals;
};

/// Sets the horns of a pulp and the height of its roof.
void raiseRoof(const terrain::Grid& grid, const Lattice& lattice, std::span<const float> top,
               const TissueFigures& figures, double tipToHorn, Variation& vary, PulpForm& form)
{
    const double highest = static_cast<double>(*std::max_element(top.begin(), top.end()));
    for (const Spot& target : hornTargets(grid, lattice, top, figures, form.print, highest)) {
        Horn horn{pulledInside(grid, form.print, target.x, target.y, 0.35), 0.0};
        const double aside = squared(horn.at.x - target.x) + squared(horn.at.y - target.y);
        const double reach = tipToHorn + vary(0.12);
        horn.apex = target.z - std::sqrt(std::max(squared(0.8 * reach), squared(reach) - aside));
        form.roofMid += horn.apex;
        form.horns.push_back(horn);
    }
    form.roofMid = form.horns.empty() ? highest - tipToHorn : form.roofMid / static_cast<double>(form.horns.size());
    form.roofMid -= figures.hornHeight;
    form.fossa = centralFossa(grid, lattice, top, figures);
    form.fossaToPulp = figures.fossaToPulp + (form.fossa ? vary(0.1) : 0.0);
    if (!form.fossa)
        return;
    // Under a deep fossa, the whole roof and its horns are lower. A low cusp has a low horn.
    form.roofMid = std::min(form.roofMid, form.fossa->z - form.fossaToPulp);
    double tallest = form.roofMid;
    for (const Horn& horn : form.horns)
        tallest = std::max(tallest, horn.apex);
    for (Horn& horn : form.horns)
        horn.apex = std::max(horn.apex - std::max(0.0, tallest - form.roofMid - figures.hornHeight),
                             form.roofMid + kLeastHorn * figures.hornHeight);
}

/// Sets where the canals of a pulp leave its chamber: over the deepest places of the under surface, one per root. If
/// the roots are cut off, it is over the middle of the section of each, and towards the place where its end would be.
/// @param minusBottom  see dentinUnder()
void openCanals(const terrain::Grid& grid, const Lattice& lattice, std::span<const float> top,
                std::span<const float> bottom, const std::vector<std::uint8_t>& cut,
                const std::vector<float>& minusBottom, const TissueFigures& figures, PulpForm& form)
{
    const double highest = static_cast<double>(*std::max_element(top.begin(), top.end()));
    const bool isCut = std::find(cut.begin(), cut.end(), 1) != cut.end();
    form.deepest = highest;
    for (std::size_t k = 0; k < grid.count(); ++k)
        if (top[k] > bottom[k])
            form.deepest = std::min(form.deepest, static_cast<double>(bottom[k]));
    if (isCut)
        form.deepest = std::min(form.deepest, highest - figures.crownHeight - figures.sizes.rootLengthMm);
    if (form.chamberHeight <= 0.0)
        return;
    const std::vector<float> section = isCut ? distanceInside(grid, cut) : minusBottom;
    const double least = isCut ? 0.6 * static_cast<double>(*std::max_element(section.begin(), section.end()))
                               : -(highest + 0.75 * (form.deepest - highest));
    for (const Spot& apex : peaks(grid, lattice, lattice.pick(section, terrain::kEmptyTop), 1.5, least, 4))
        form.canals.push_back(pulledInside(grid, form.print, apex.x, apex.y, 0.3));
    divideMesial(grid, form.print, figures, form.canals);
}

/// Returns the heights of roof and floor of a pulp, mm, at a position that is `inside` mm within its outline.
/// @param neck  height of the enamel-cement junction there
std::pair<double, double> roofAndFloor(const PulpForm& form, const glm::dvec2& at, double inside, double neck)
{
    const double deepestInside = form.print.deepestMm;
    const double roundMm = form.chamberHeight > 0.0 ? std::min(0.8, deepestInside) : deepestInside;
    const double hornWidth = std::max(0.5, 0.55 * deepestInside);
    const double dome = 1.0 - squared(1.0 - std::min(1.0, inside / roundMm));
    double roof = 0.0;
    double floor = 0.0;
    if (form.chamberHeight > 0.0) {
        roof = form.roofMid - 0.4 * (1.0 - dome);
        floor = form.roofMid - form.chamberHeight + 0.4 * (1.0 - dome);
        for (const Spot& canal : form.canals) {
            const double aside = std::sqrt(squared(at.x - canal.x) + squared(at.y - canal.y)) / kCanalRadiusMm;
            if (aside < 1.0)
                floor = std::min(floor, floor + (form.deepest + 1.5 - floor) * (1.0 - aside));
        }
    } else {
        roof = neck - 1.0 + (form.roofMid - (neck - 1.0)) * dome;
        const double depth = inside / deepestInside;
        floor = neck - 1.0 + (form.deepest + 1.5 - (neck - 1.0)) * depth * std::sqrt(depth);
    }
    for (const Horn& horn : form.horns) {
        const double aside = std::sqrt(squared(at.x - horn.at.x) + squared(at.y - horn.at.y)) / hornWidth;
        if (aside < 1.0)
            roof = std::max(roof, roof + (horn.apex - roof) * squared(1.0 - aside) * (1.0 + 2.0 * aside));
    }
    if (form.fossa) {
        const double away = squared(at.x - form.fossa->x) + squared(at.y - form.fossa->y);
        roof = std::min(roof, form.fossa->z - std::sqrt(std::max(0.0, squared(form.fossaToPulp) - away)));
    }
    return {roof, floor};
}

/// Returns the upper end of the dentin in each column. Outside the tooth it is so low that there is no pulp beside it.
std::vector<float> dentinOver(std::span<const float> top, std::span<const float> bottom,
                              const std::vector<terrain::ColumnLayers>& layers)
{
    std::vector<float> junction(top.size());
    for (std::size_t k = 0; k < top.size(); ++k)
        junction[k] = top[k] > bottom[k] ? std::max(layers[k].dej, bottom[k]) : terrain::kEmptyTop;
    return junction;
}

/// Returns the negated lower end of the dentin in each column. Where the model was cut off, the dentin has no end.
std::vector<float> dentinUnder(std::span<const float> top, std::span<const float> bottom,
                               const std::vector<std::uint8_t>& cut)
{
    std::vector<float> minusBottom(top.size());
    for (std::size_t k = 0; k < top.size(); ++k)
        minusBottom[k] = !(top[k] > bottom[k]) ? terrain::kEmptyTop : cut[k] != 0 ? kNoValue : -bottom[k];
    return minusBottom;
}

}  // namespace

void hollowPulp(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
                std::span<const float> cervixMm, const TissueFigures& figures, std::uint64_t seed,
                std::vector<terrain::ColumnLayers>& layers)
{
    Variation vary(seed);
    const double tipToHorn = figures.tipToHorn + vary(0.35);
    PulpForm form;
    form.chamberHeight = figures.chamberHeight > 0.0 ? figures.chamberHeight + vary(0.25) : 0.0;
    const std::vector<std::uint8_t> cut = cutColumns(grid, top, bottom, figures);
    form.print = footprintOf(grid, top, bottom, cervixMm, cut, figures, vary(0.15));
    if (form.print.deepestMm < 0.1)
        return;

    // The pulp extends as far as the dentin on every side has its least thickness.
    const Lattice lattice(grid);
    const std::vector<float> minusBottom = dentinUnder(top, bottom, cut);
    const std::vector<float> above(lattice.count(), kDentinAboveMm);
    const std::vector<float> beside(lattice.count(), kDentinBesideMm);
    const std::vector<float> ceiling =
        lattice.ballsBelow(lattice.pick(dentinOver(top, bottom, layers), terrain::kEmptyTop), above);
    const std::vector<float> minusGround = lattice.ballsBelow(lattice.pick(minusBottom, terrain::kEmptyTop), beside);

    raiseRoof(grid, lattice, top, figures, tipToHorn, vary, form);
    openCanals(grid, lattice, top, bottom, cut, minusBottom, figures, form);
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            const auto inside = static_cast<double>(form.print.insideMm[k]);
            if (inside <= 0.0)
                continue;
            const auto [roof, floor] = roofAndFloor(form, grid.nodeMm(i, j), inside, static_cast<double>(cervixMm[k]));
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
