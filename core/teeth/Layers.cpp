// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/Layers.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/Rng.h"
#include "core/teeth/LaidSolid.h"
#include "core/teeth/Lattice.h"
#include "core/teeth/Pulp.h"
#include "core/teeth/TissueFigures.h"
#include "core/teeth/ValueNoise.h"

namespace core::teeth {
namespace {

constexpr double kThinnestMm = 0.2;         ///< enamel left under the deepest fissure
constexpr double kFissureHalfMouth = 0.35;  ///< a groove narrower than twice this is a fissure, not a fossa

double smoothstep(double low, double high, double value)
{
    const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Enamel thickness beside a surface point, and the height of the CEJ, for one tooth.
class Enamel
{
public:
    Enamel(const terrain::Grid& grid, std::span<const float> top, std::span<const float> sideMm,
           const TissueFigures& figures, std::uint64_t seed)
        : m_figures(figures), m_patches(seed, 2.5), m_middle(grid.middleMm())
    {
        Rng rng(seed ^ 0x656E616D656CULL);
        m_person = seed == 0 ? 1.0 : 1.0 + 0.05 * std::clamp(rng.normal(), -2.0, 2.0);
        m_highest = static_cast<double>(*std::max_element(top.begin(), top.end()));
        m_deepestSide = static_cast<double>(*std::max_element(sideMm.begin(), sideMm.end()));

        double left = 1.0e9;
        double right = -1.0e9;
        m_fossa = m_highest;
        for (int j = 0; j < grid.side; ++j) {
            for (int i = 0; i < grid.side; ++i) {
                const std::size_t k = grid.index(i, j);
                if (static_cast<double>(sideMm[k]) <= 0.0)
                    continue;
                left = std::min(left, grid.nodeMm(i, j).x);
                right = std::max(right, grid.nodeMm(i, j).x);
                if (static_cast<double>(sideMm[k]) > 0.5 * m_deepestSide)
                    m_fossa = std::min(m_fossa, static_cast<double>(top[k]));
            }
        }
        m_fossa = std::clamp(m_fossa, m_highest - 3.2, m_highest - 1.0);
        m_centreX = 0.5 * (left + right);
        m_halfWidth = std::max(grid.cellMm, 0.5 * (right - left));
    }

    /// Returns the height of the CEJ at a position. It is lowest on the facial and lingual side and rises towards the
    /// mesial (-x) and distal side.
    [[nodiscard]] double cervixAt(double x) const
    {
        const double u = std::clamp((x - m_centreX) / m_halfWidth, -1.0, 1.0);
        const double rise = (u < 0.0 ? m_figures.sizes.cejCurveMesialMm : m_figures.sizes.cejCurveDistalMm) * u * u;
        return m_highest - m_figures.crownHeight + (m_isSteepAside ? rise * u * u : rise);
    }

    /// Sets the neck from the sizes with which the program generated the tooth, instead of estimating it from the
    /// crown.
    void fitNeck(const ToothSizes& made)
    {
        m_figures.sizes = made;
        m_figures.crownHeight = made.crownHeightMm;
        m_halfWidth = 0.5 * made.cervixWidthMm;
        m_isSteepAside = m_figures.kind == ToothKind::Premolar || m_figures.kind == ToothKind::Molar;
    }

    /// Returns a factor near 1 for every thickness. It depends on the tooth's seed and the position.
    [[nodiscard]] double variation(double x, double y) const
    {
        return m_person * (1.0 + 0.08 * m_patches.at(x - m_middle.x, y - m_middle.y));
    }

    /// Returns the enamel on a side wall at a height above the CEJ (docs/teeth.md: within 0.12 of a CT molar).
    [[nodiscard]] double lateral(double aboveCervix) const
    {
        if (aboveCervix <= 0.0)
            return 0.0;
        return std::min(kEdge * std::min(1.0, aboveCervix / kEdgeHeight) + m_figures.enamelPerHeight * aboveCervix,
                        m_figures.cuspEnamel);
    }

    /// Returns the height above the CEJ at which lateral() equals `thickness`: at that height the junction meets a wall
    /// at that distance.
    [[nodiscard]] double heightOf(double thickness) const
    {
        const double low = thickness / (m_figures.enamelPerHeight + kEdge / kEdgeHeight);
        return low < kEdgeHeight ? low : (thickness - kEdge) / m_figures.enamelPerHeight;
    }

    /// Returns the enamel at an incisal edge, along the axis; 0 if there is none.
    [[nodiscard]] double edgeMm() const { return m_figures.edgeEnamel; }

    /// Returns the enamel under a surface point at height z over (x, y), at the distance `side` from the outline.
    [[nodiscard]] double thickness(double x, double y, double z, double side) const
    {
        const double above = z - cervixAt(x);
        const double wall = lateral(above);
        const bool hasTable = m_figures.kind == ToothKind::Premolar || m_figures.kind == ToothKind::Molar;
        if (!hasTable || above <= 0.0)
            return wall * variation(x, y);
        const double share = std::clamp((z - m_fossa) / (m_highest - m_fossa), 0.0, 1.0);
        const double table = m_figures.fossaEnamel + (m_figures.cuspEnamel - m_figures.fossaEnamel) * share * share;
        const double inner = smoothstep(0.2 * m_deepestSide, 0.45 * m_deepestSide, side);
        return (wall + (table - wall) * inner) * variation(x, y);
    }

private:
    static constexpr double kEdge = 0.05;
    static constexpr double kEdgeHeight = 0.2;

    TissueFigures m_figures;
    ValueNoise m_patches;  ///< relative to the middle of the tooth, so that the origin of the frame has no effect
    glm::dvec2 m_middle;
    double m_person = 1.0;
    double m_highest = 0.0;
    double m_fossa = 0.0;
    double m_deepestSide = 0.0;
    double m_centreX = 0.0;
    double m_halfWidth = 1.0;
    bool m_isSteepAside = false;  ///< towards the sides, the neck rises with the fourth power of the distance
};

/// Returns the most enamel at a place near a fissure: 1.2 below its mouth and 0.25 below its base (a cavity 1.5 mm deep
/// has its floor in dentin), and more with the distance. kNoValue far from any.
std::vector<float> limitBesideFissures(const Lattice& lattice, const terrain::Grid& grid, std::span<const float> top,
                                       std::uint64_t seed)
{
    constexpr float kFissureMm = 0.15F;  // a shallower groove has the enamel of the fossa
    constexpr double kUnderMouth = 1.2;
    constexpr double kUnderBase = 0.25;
    constexpr double kGrowth = 0.4;
    constexpr double kReachMm = 1.4;
    const std::vector<float> lowest = lattice.pickLowest(top, terrain::kEmptyTop);
    const std::vector<float> closed = lattice.close(lowest, kFissureHalfMouth, terrain::kEmptyTop);
    const ValueNoise noise(seed ^ (seed == 0 ? 0 : 0x66697373ULL), 1.2);
    const double halfWidth = grid.middleMm().x - grid.originMm.x;
    std::vector<float> limit(lattice.count(), kNoValue);
    const int reach = static_cast<int>(kReachMm / lattice.cellMm());
    for (int b = 0; b < lattice.side(); ++b) {
        for (int a = 0; a < lattice.side(); ++a) {
            const std::size_t k = lattice.index(a, b);
            if (lowest[k] <= terrain::kEmptyTop || closed[k] - lowest[k] < kFissureMm)
                continue;
            const double vary = noise.at(a * lattice.cellMm() - halfWidth, b * lattice.cellMm() - halfWidth);
            const double base =
                (1.0 + 0.2 * vary) * std::max(kUnderMouth, static_cast<double>(closed[k] - lowest[k]) + kUnderBase);
            for (int nb = std::max(0, b - reach); nb <= std::min(lattice.side() - 1, b + reach); ++nb) {
                for (int na = std::max(0, a - reach); na <= std::min(lattice.side() - 1, a + reach); ++na) {
                    const double aside =
                        lattice.cellMm() * std::sqrt(1.0 * ((na - a) * (na - a) + (nb - b) * (nb - b)));
                    float& most = limit[lattice.index(na, nb)];
                    most = std::min(most, static_cast<float>(base + kGrowth * aside));
                }
            }
        }
    }
    return limit;
}

/// Returns the lowest height of the junction under an incisal edge. A ridge of dentin follows the edge, with flanks
/// that fall to the sides. kNoValue far from an edge.
std::vector<float> ridgeUnderEdge(const Lattice& lattice, const terrain::Grid& grid, std::span<const float> surface,
                                  const Enamel& enamel, double edgeEnamelMm)
{
    constexpr float kBelowHighestMm = 2.0F;  // a lower place belongs to the cingulum
    constexpr double kNearMm = 0.5;
    constexpr double kAlongEdge = 0.15;  // within kNearMm, an edge falls by less than this and its sides by more
    constexpr double kOffEdge = 3.0;     // fall of the ridge per distance beyond the edge
    constexpr double kFlank = 2.5;
    constexpr double kReachMm = 1.0;
    std::vector<float> lowest(lattice.count(), kNoValue);
    if (edgeEnamelMm <= 0.0)
        return lowest;
    const float highest = *std::max_element(surface.begin(), surface.end());
    const auto around = [&](int a, int b, double reachMm, auto&& use) {
        const int reach = static_cast<int>(reachMm / lattice.cellMm());
        for (int nb = std::max(0, b - reach); nb <= std::min(lattice.side() - 1, b + reach); ++nb)
            for (int na = std::max(0, a - reach); na <= std::min(lattice.side() - 1, a + reach); ++na)
                use(lattice.index(na, nb), lattice.cellMm() * std::hypot(na - a, nb - b));
    };
    for (int b = 0; b < lattice.side(); ++b) {
        for (int a = 0; a < lattice.side(); ++a) {
            const float here = surface[lattice.index(a, b)];
            if (here < highest - kBelowHighestMm)
                continue;
            float near = here;
            around(a, b, kNearMm, [&](std::size_t k, double) { near = std::max(near, surface[k]); });
            const double off = std::max(0.0, static_cast<double>(near - here) - kAlongEdge);
            const double ridge = static_cast<double>(here) - kOffEdge * off -
                                 edgeEnamelMm * enamel.variation(grid.originMm.x + a * lattice.cellMm(),
                                                                 grid.originMm.y + b * lattice.cellMm());
            around(a, b, kReachMm, [&](std::size_t k, double aside) {
                const auto flank = static_cast<float>(ridge - kFlank * aside);
                lowest[k] = lowest[k] == kNoValue ? flank : std::max(lowest[k], flank);
            });
        }
    }
    return lowest;
}

/// Returns the vertical distance per distance along the normal of the underside.
double lengthPerDepth(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
                      std::span<const float> cervixMm, int i, int j)
{
    const auto rise = [&](int di, int dj) {
        float steepest = 0.0F;
        for (const int sign : {-1, 1}) {
            if (!grid.contains(i + sign * di, j + sign * dj))
                continue;
            const std::size_t k = grid.index(i + sign * di, j + sign * dj);
            // The root begins at the end of the underside.
            if (top[k] > bottom[k] && bottom[k] > cervixMm[k])
                steepest = std::max(steepest, std::abs(bottom[k] - bottom[grid.index(i, j)]));
        }
        return static_cast<double>(steepest);
    };
    const double x = rise(1, 0) / grid.cellMm;
    const double y = rise(0, 1) / grid.cellMm;
    return std::sqrt(1.0 + x * x + y * y);
}

void layEnamel(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
               std::span<const float> sideMm, std::span<const float> cervixMm, const Enamel& enamel, std::uint64_t seed,
               std::vector<terrain::ColumnLayers>& layers)
{
    const Lattice lattice(grid);
    const std::vector<float> closed =
        lattice.close(lattice.pick(top, terrain::kEmptyTop), kFissureHalfMouth, terrain::kEmptyTop);
    const std::vector<float> side = lattice.pick(sideMm, 0.0F);
    const std::vector<float> limit = limitBesideFissures(lattice, grid, top, seed);
    std::vector<float> centres(lattice.count(), kNoValue);
    std::vector<float> radius(lattice.count(), 0.0F);
    for (int b = 0; b < lattice.side(); ++b) {
        for (int a = 0; a < lattice.side(); ++a) {
            const std::size_t k = lattice.index(a, b);
            if (closed[k] <= terrain::kEmptyTop)
                continue;
            const double x = grid.originMm.x + a * lattice.cellMm();
            const double y = grid.originMm.y + b * lattice.cellMm();
            centres[k] = closed[k];
            const auto thickness = static_cast<float>(
                enamel.thickness(x, y, static_cast<double>(closed[k]), static_cast<double>(side[k])));
            radius[k] = std::min(thickness, limit[k]);
        }
    }
    const std::vector<float> under = lattice.ballsBelow(centres, radius);
    const std::vector<float> ridge = ridgeUnderEdge(lattice, grid, closed, enamel, enamel.edgeMm());

    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            if (!(top[k] > bottom[k]))
                continue;
            const glm::dvec2 at = grid.nodeMm(i, j);
            const auto surface = static_cast<double>(top[k]);
            const auto cervix = static_cast<double>(cervixMm[k]);
            const auto toSide = static_cast<double>(sideMm[k]);
            const double here = enamel.thickness(at.x, at.y, surface, toSide);
            const float below = lattice.at(under, i, j);
            double dej = below == kNoValue ? surface - here : static_cast<double>(below);
            if (const float least = lattice.at(ridge, i, j); least != kNoValue)
                dej = std::max(dej, static_cast<double>(least));
            // The enamel of a wall is vertical from its outline to the CEJ, and becomes thinner all the way.
            dej = std::min(dej, cervix + enamel.heightOf(toSide / enamel.variation(at.x, at.y)));
            dej = std::min(dej, surface - std::min({kThinnestMm, here, std::max(0.0, surface - cervix)}));
            if (static_cast<double>(bottom[k]) > cervix) {
                // The underside of a bulge has enamel too. It is measured along the normal, so it is thicker along a
                // column on a steeper flank, and such a column may have no dentin at all.
                const double beneath = enamel.lateral(static_cast<double>(bottom[k]) - cervix);
                if (dej - static_cast<double>(bottom[k]) < beneath * lengthPerDepth(grid, top, bottom, cervixMm, i, j))
                    dej = static_cast<double>(bottom[k]) - beneath;
            } else {
                dej = std::max(dej, std::min(cervix, surface));
            }
            layers[k].dej = static_cast<float>(dej);
        }
    }
}

/// Enamel of a tooth that lies on a side, for positions in the frame in which it is cut.
class LaidEnamel
{
public:
    LaidEnamel(const LaidTooth& laid, const TissueFigures& figures, std::uint64_t seed)
        : m_laid(laid), m_side(distanceInside(laid.own.grid, solidNodes(laid.own.top, laid.own.bottom))),
          m_enamel(laid.own.grid, laid.own.top, m_side, figures, seed)
    {
        if (laid.made)
            m_enamel.fitNeck(*laid.made);
    }

    /// Returns the thickness under a point of the outer surface.
    [[nodiscard]] double thickness(const glm::dvec3& cutMm) const
    {
        const glm::dvec3 own = m_laid.ownMm(cutMm);
        return m_enamel.thickness(own.x, own.y, own.z, insideTable(own));
    }

private:
    /// Returns how far a surface point is inside the outline of the upright tooth; 0 on a wall below the outline.
    [[nodiscard]] double insideTable(const glm::dvec3& own) const
    {
        constexpr double kOnTopMm = 0.5;
        const terrain::Grid& grid = m_laid.own.grid;
        const glm::dvec2 at = glm::round(grid.latticeOf(glm::dvec2(own)));
        if (!grid.contains(static_cast<int>(at.x), static_cast<int>(at.y)))
            return 0.0;
        const std::size_t k = grid.index(static_cast<int>(at.x), static_cast<int>(at.y));
        return static_cast<double>(m_laid.own.top[k]) - own.z < kOnTopMm ? static_cast<double>(m_side[k]) : 0.0;
    }

    const LaidTooth& m_laid;
    std::vector<float> m_side;
    Enamel m_enamel;
};

void layLaidEnamel(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
                   const LaidEnamel& enamel, std::uint64_t seed, std::vector<terrain::ColumnLayers>& layers)
{
    const Lattice lattice(grid);
    const std::vector<float> closed =
        lattice.close(lattice.pick(top, terrain::kEmptyTop), kFissureHalfMouth, terrain::kEmptyTop);
    const std::vector<float> limit = limitBesideFissures(lattice, grid, top, seed);
    std::vector<float> centres(lattice.count(), kNoValue);
    std::vector<float> radius(lattice.count(), 0.0F);
    for (int b = 0; b < lattice.side(); ++b) {
        for (int a = 0; a < lattice.side(); ++a) {
            const std::size_t k = lattice.index(a, b);
            if (closed[k] <= terrain::kEmptyTop)
                continue;
            const glm::dvec2 at = grid.originMm + lattice.cellMm() * glm::dvec2(a, b);
            centres[k] = closed[k];
            radius[k] = std::min(static_cast<float>(enamel.thickness(glm::dvec3(at, closed[k]))), limit[k]);
        }
    }
    const std::vector<float> under = lattice.ballsBelow(centres, radius);
    const std::vector<float> sideMm = distanceInside(grid, solidNodes(top, bottom));
    // In a laid tooth no side of the model is the root, where the enamel of the underside would end. Its thickness
    // decides where it ends.
    const std::vector<float> noNeck(grid.count(), terrain::kEmptyTop);
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            if (!(top[k] > bottom[k]))
                continue;
            const auto surface = static_cast<double>(top[k]);
            const auto ground = static_cast<double>(bottom[k]);
            const double here = enamel.thickness(glm::dvec3(grid.nodeMm(i, j), surface));
            const float below = lattice.at(under, i, j);
            if (here <= 0.0) {  // cementum
                layers[k].dej = top[k];
                continue;
            }
            double dej = below == kNoValue ? surface - here : static_cast<double>(below);
            dej = std::min(dej, surface - std::min(kThinnestMm, here));
            const double beneath = enamel.thickness(glm::dvec3(grid.nodeMm(i, j), ground));
            // Beside a wall parallel to the bur, the whole column is enamel.
            const double wall = enamel.thickness(glm::dvec3(grid.nodeMm(i, j), 0.5 * (surface + ground)));
            if (static_cast<double>(sideMm[k]) < wall ||
                dej - ground < beneath * lengthPerDepth(grid, top, bottom, noNeck, i, j))
                dej = ground - beneath;
            layers[k].dej = static_cast<float>(dej);
        }
    }
}

/// Adds layers by the rule of 2011: parallel to the top, and walls at a constant distance inside the outline.
void layConstantDepth(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
                      std::span<const float> sideMm, std::vector<terrain::ColumnLayers>& layers)
{
    constexpr float kEnamelMm = 2.0F;
    constexpr float kEnamelSideMm = 1.5F;
    constexpr float kPulpDepthMm = 6.0F;
    constexpr float kPulpSideMm = 3.2F;
    constexpr float kPulpHeightMm = 2.0F;
    for (std::size_t k = 0; k < grid.count(); ++k) {
        if (!(top[k] > bottom[k]))
            continue;
        layers[k].dej = sideMm[k] < kEnamelSideMm ? bottom[k] : std::max(bottom[k], top[k] - kEnamelMm);
        if (sideMm[k] >= kPulpSideMm && top[k] - kPulpDepthMm - kPulpHeightMm > bottom[k] + 1.0F) {
            layers[k].pulpRoof = top[k] - kPulpDepthMm;
            layers[k].pulpFloor = layers[k].pulpRoof - kPulpHeightMm;
        }
    }
}

}  // namespace

std::vector<terrain::ColumnLayers> buildLayers(const terrain::Grid& grid, std::span<const float> top,
                                               std::span<const float> bottom, const LayerOptions& options)
{
    std::vector<terrain::ColumnLayers> layers(grid.count());
    const std::vector<std::uint8_t> solid = solidNodes(top, bottom);
    if (std::find(solid.begin(), solid.end(), 1) == solid.end())
        return layers;
    const std::vector<float> side = distanceInside(grid, solid);
    if (options.rule == LayerRule::ConstantDepth2011) {
        layConstantDepth(grid, top, bottom, side, layers);
        return layers;
    }

    const TissueFigures figures = figuresFor(options.fdi, grid, top);
    const Enamel enamel(grid, top, side, figures, options.seed);
    std::vector<float> cervix(grid.count());
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i)
            cervix[grid.index(i, j)] = static_cast<float>(enamel.cervixAt(grid.nodeMm(i, j).x));
    layEnamel(grid, top, bottom, side, cervix, enamel, options.seed, layers);
    // Uses positions relative to the grid's corner, so that the origin of the frame does not change even their last
    // bits. Of two equally near positions, the same one is then always chosen.
    terrain::Grid fromCorner = grid;
    fromCorner.originMm = {0.0, 0.0};
    hollowPulp(fromCorner, top, bottom, cervix, figures, options.seed, layers);
    return layers;
}

std::vector<terrain::ColumnLayers> buildLaidLayers(const LaidTooth& laid, const terrain::Grid& grid,
                                                   std::span<const float> top, std::span<const float> bottom,
                                                   const LayerOptions& options)
{
    std::vector<terrain::ColumnLayers> layers(grid.count());
    if (options.rule == LayerRule::ConstantDepth2011) {
        layConstantDepth(grid, top, bottom, distanceInside(grid, solidNodes(top, bottom)), layers);
        return layers;
    }
    const TissueFigures figures = figuresFor(options.fdi, laid.own.grid, laid.own.top);
    layLaidEnamel(grid, top, bottom, LaidEnamel(laid, figures, options.seed), options.seed, layers);
    const LaidSolid pulp(laid, &terrain::ColumnLayers::pulpRoof, &terrain::ColumnLayers::pulpFloor);
    for (std::size_t k = 0; k < grid.count(); ++k) {
        if (!(top[k] > bottom[k]))
            continue;
        if (const auto met = pulp.along(grid.nodeMm(k), top[k], bottom[k])) {
            layers[k].pulpRoof = met->first;
            layers[k].pulpFloor = met->second;
        }
    }
    return layers;
}

}  // namespace core::teeth
