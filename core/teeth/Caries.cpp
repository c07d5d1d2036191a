// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/Caries.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "core/base/Rng.h"
#include "core/teeth/Lattice.h"
#include "core/teeth/ValueNoise.h"

namespace core::teeth {
namespace {

constexpr float kOverPulpMm = 0.5F;       ///< dentin spared by every lesion (Murray 2003: less dentin harms the pulp)
constexpr double kJunctionAt = 0.25;      ///< severity at which a lesion has passed through the enamel
constexpr double kValleyRadiusMm = 0.7;   ///< half the width of a groove between two inclines
constexpr double kFissureRadiusMm = 0.3;  ///< half the width of the fissure in it
constexpr double kTableShare = 0.36;      ///< of the greatest distance from the outline: further inside is the occlusal
                                          ///< table
constexpr double kPitShare = 0.55;        ///< further inside are the pits in which a lesion begins
constexpr float kBelowTipsMm = 1.0F;      ///< and this far below the highest cusp
constexpr double kWallShare = 0.2;        ///< further outside is the wall, which these lesions spare
constexpr double kLongestMm = 3.5;        ///< longest path from the pit to either end
constexpr float kValleyMm = 0.06F;        ///< a place deeper than this below its shoulders is a valley

/// The tooth a lesion grows in.
struct Ground
{
    const terrain::Grid& grid;
    std::span<const float> top;
    std::span<const float> bottom;
    std::vector<terrain::ColumnLayers>& layers;
    Lattice lattice;
    std::vector<float> sideMm;  ///< [side * side]
    std::vector<float> limit;   ///< minus the lowest height for a lesion, on the lattice; kNoValue: no pulp near
    double broadestMm = 0.0;    ///< greatest distance from the outline

    [[nodiscard]] bool solid(std::size_t k) const { return top[k] > bottom[k]; }

    /// Returns the lowest height that a lesion may reach in a column.
    [[nodiscard]] float lowest(int i, int j) const
    {
        const std::size_t k = grid.index(i, j);
        const float minusLimit = lattice.at(limit, i, j);
        const float ground = bottom[k] + kOverPulpMm;
        return minusLimit == kNoValue ? ground : std::max(ground, -minusLimit);
    }
};

Ground survey(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
              std::vector<terrain::ColumnLayers>& layers)
{
    Ground ground{grid, top, bottom, layers, Lattice(grid), {}, {}, 0.0};
    std::vector<float> minusRoof(grid.count(), kNoValue);
    for (std::size_t k = 0; k < grid.count(); ++k)
        if (ground.solid(k) && layers[k].pulpRoof > layers[k].pulpFloor)
            minusRoof[k] = -layers[k].pulpRoof;
    ground.sideMm = distanceInside(grid, solidNodes(top, bottom));
    ground.broadestMm = static_cast<double>(*std::max_element(ground.sideMm.begin(), ground.sideMm.end()));
    // A ball with the radius of the spared dentin around the pulp, plus the distance between nodes of the lattice.
    const float radius = kOverPulpMm + 1.5F * static_cast<float>(ground.lattice.cellMm());
    ground.limit = ground.lattice.ballsBelow(ground.lattice.pick(minusRoof, kNoValue),
                                             std::vector<float>(ground.lattice.count(), radius));
    return ground;
}

/// A place on the path of a fissure lesion, and its distance from the pit where the lesion began.
struct Stop
{
    int a = 0;
    int b = 0;
    double fromPitMm = 0.0;
    int alongA = 0;  ///< the step that led here
    int alongB = 0;
};

class FissureMap
{
public:
    FissureMap(const terrain::Grid& grid, std::span<const float> top, std::span<const float> sideMm)
        : m_lattice(grid), m_broadestMm(static_cast<double>(*std::max_element(sideMm.begin(), sideMm.end())))
    {
        m_top = m_lattice.pick(top, terrain::kEmptyTop);
        m_side = m_lattice.pick(sideMm, 0.0F);
        const std::vector<float> lowest = m_lattice.pickLowest(top, terrain::kEmptyTop);
        const std::vector<float> mouths = m_lattice.close(lowest, kFissureRadiusMm, terrain::kEmptyTop);
        m_valley = m_lattice.close(lowest, kValleyRadiusMm, terrain::kEmptyTop);
        for (std::size_t k = 0; k < m_valley.size(); ++k)
            m_valley[k] = inTable(k) ? m_valley[k] - lowest[k] + 3.0F * (mouths[k] - lowest[k]) : 0.0F;
    }

    [[nodiscard]] const Lattice& lattice() const { return m_lattice; }

    /// Returns the path of a lesion: a pit, and the fissure on both sides of it.
    [[nodiscard]] std::vector<Stop> walk(std::uint64_t seed, double longestMm) const
    {
        Rng rng(seed ^ 0x66697373757265ULL);
        const Stop pit = choosePit(seed, rng);
        std::vector<Stop> path{pit};
        std::vector<std::uint8_t> taken(m_lattice.count(), 0);
        take(taken, pit);
        for (int arm = 0; arm < 2; ++arm) {
            Stop at = pit;
            if (arm == 1 && path.size() > 1) {  // away from the first arm
                at.alongA = -path[1].alongA;
                at.alongB = -path[1].alongB;
            }
            while (at.fromPitMm < longestMm && step(at, taken, rng))
                path.push_back(at);
        }
        return path;
    }

private:
    static constexpr int kReach = 4;  ///< nodes on each side of the path that stay blocked

    [[nodiscard]] bool inTable(std::size_t k) const
    {
        return m_top[k] > terrain::kEmptyTop && static_cast<double>(m_side[k]) > kTableShare * m_broadestMm;
    }

    [[nodiscard]] Stop choosePit(std::uint64_t seed, Rng& rng) const
    {
        const float deepest = *std::max_element(m_valley.begin(), m_valley.end());
        const float tip = *std::max_element(m_top.begin(), m_top.end());
        std::vector<Stop> pits;
        const int apart = static_cast<int>(1.0 / m_lattice.cellMm());
        for (int b = 0; b < m_lattice.side(); ++b) {
            for (int a = 0; a < m_lattice.side(); ++a) {
                const std::size_t k = m_lattice.index(a, b);
                if (m_valley[k] < std::max(kValleyMm, 0.5F * deepest) ||
                    static_cast<double>(m_side[k]) < kPitShare * m_broadestMm || m_top[k] > tip - kBelowTipsMm)
                    continue;
                bool highest = true;
                for (int nb = std::max(0, b - apart); nb <= std::min(m_lattice.side() - 1, b + apart); ++nb)
                    for (int na = std::max(0, a - apart); na <= std::min(m_lattice.side() - 1, a + apart); ++na)
                        highest = highest &&
                                  (m_valley[m_lattice.index(na, nb)] < m_valley[k] || m_lattice.index(na, nb) >= k);
                if (highest)
                    pits.push_back({a, b});
            }
        }
        if (pits.empty())
            return lowestInside();
        if (seed != 0)
            return pits[static_cast<std::size_t>(rng.below(static_cast<int>(pits.size())))];
        return *std::max_element(pits.begin(), pits.end(), [&](const Stop& p, const Stop& q) {
            return m_side[m_lattice.index(p.a, p.b)] < m_side[m_lattice.index(q.a, q.b)];
        });
    }

    /// Returns, for a crown without a fissure, the lowest place well inside the outline.
    [[nodiscard]] Stop lowestInside() const
    {
        Stop best{m_lattice.side() / 2, m_lattice.side() / 2};
        float lowest = kNoValue;
        for (int b = 0; b < m_lattice.side(); ++b) {
            for (int a = 0; a < m_lattice.side(); ++a) {
                const std::size_t k = m_lattice.index(a, b);
                if (m_top[k] <= terrain::kEmptyTop || static_cast<double>(m_side[k]) < kPitShare * m_broadestMm)
                    continue;
                if (m_top[k] < lowest) {
                    lowest = m_top[k];
                    best = {a, b};
                }
            }
        }
        return best;
    }

    void take(std::vector<std::uint8_t>& taken, const Stop& at) const { taken[m_lattice.index(at.a, at.b)] = 1; }

    /// Returns whether the path passes within kReach of (a, b). Ignores the surroundings of `at`.
    [[nodiscard]] bool touchesPath(int a, int b, const Stop& at, const std::vector<std::uint8_t>& taken) const
    {
        for (int nb = std::max(0, b - kReach); nb <= std::min(m_lattice.side() - 1, b + kReach); ++nb)
            for (int na = std::max(0, a - kReach); na <= std::min(m_lattice.side() - 1, a + kReach); ++na)
                if (taken[m_lattice.index(na, nb)] != 0 && std::max(std::abs(na - at.a), std::abs(nb - at.b)) > kReach)
                    return true;
        return false;
    }

    /// Moves to the deepest neighbour in the valley. Returns false at the end of the valley.
    bool step(Stop& at, std::vector<std::uint8_t>& taken, Rng& rng) const
    {
        Stop next = at;
        double best = 0.0;
        for (int db = -1; db <= 1; ++db) {
            for (int da = -1; da <= 1; ++da) {
                const int a = at.a + da;
                const int b = at.b + db;
                if (a < 0 || b < 0 || a >= m_lattice.side() || b >= m_lattice.side())
                    continue;
                const std::size_t k = m_lattice.index(a, b);
                const double wander = rng.uniform(0.8, 1.2);
                if (taken[k] != 0 || m_valley[k] < kValleyMm || touchesPath(a, b, at, taken))
                    continue;
                // Prefers a straight direction to a corner, and never turns back.
                const int turn = da * at.alongA + db * at.alongB;
                if (turn < 0)
                    continue;
                const double worth = (wander + 0.2 * turn) * static_cast<double>(m_valley[k]);
                if (worth > best) {
                    best = worth;
                    next = {a, b, at.fromPitMm + m_lattice.cellMm() * std::sqrt(1.0 * (da * da + db * db)), da, db};
                }
            }
        }
        if (best == 0.0)
            return false;
        // The other candidates of this step are blocked for later steps.
        for (int db = -1; db <= 1; ++db)
            for (int da = -1; da <= 1; ++da)
                if (at.a + da >= 0 && at.b + db >= 0 && at.a + da < m_lattice.side() && at.b + db < m_lattice.side())
                    taken[m_lattice.index(at.a + da, at.b + db)] = 1;
        at = next;
        take(taken, at);
        return true;
    }

    Lattice m_lattice;
    double m_broadestMm;  ///< greatest distance from the outline
    std::vector<float> m_top;
    std::vector<float> m_side;
    std::vector<float> m_valley;  ///< depth below the shoulders, mm
};

/// Extends a column's lesion to include [floor, roof].
void addInterval(terrain::ColumnLayers& column, float roof, float floor)
{
    if (!(roof > floor))
        return;
    if (column.cariesRoof > column.cariesFloor) {
        roof = std::max(roof, column.cariesRoof);
        floor = std::min(floor, column.cariesFloor);
    }
    column.cariesRoof = roof;
    column.cariesFloor = floor;
}

/// Returns the height of the enamel-dentin junction at a place (in cells; whole numbers on nodes), bilinear over the
/// surrounding solid nodes; empty if there is none.
std::optional<double> junctionAt(const Ground& ground, glm::dvec2 at)
{
    const int i0 = static_cast<int>(std::floor(at.x));
    const int j0 = static_cast<int>(std::floor(at.y));
    double sum = 0.0;
    double weights = 0.0;
    for (int j = j0; j <= j0 + 1; ++j)
        for (int i = i0; i <= i0 + 1; ++i) {
            const double weight = (1.0 - std::abs(at.x - i)) * (1.0 - std::abs(at.y - j));
            if (weight <= 0.0 || !ground.grid.contains(i, j) || !ground.solid(ground.grid.index(i, j)))
                continue;
            sum += weight * static_cast<double>(ground.layers[ground.grid.index(i, j)].dej);
            weights += weight;
        }
    return weights > 0.0 ? std::optional(sum / weights) : std::nullopt;
}

/// Grows the lesion of one severity (0 .. 1) at one stop. Every length increases with the severity, so that a smaller
/// lesion is always inside a larger one.
void growAt(Ground& ground, const LesionStop& stop, double severity)
{
    const terrain::Grid& grid = ground.grid;
    glm::dvec2 centre = grid.latticeOf(stop.atMm);
    const glm::dvec2 node(std::round(centre.x), std::round(centre.y));
    if (std::abs(centre.x - node.x) + std::abs(centre.y - node.y) < 1.0e-6)
        centre = node;  // the stop was found on this grid
    const auto junctionHere = junctionAt(ground, centre);
    if (!junctionHere)
        return;
    const double through = std::min(1.0, severity / kJunctionAt);
    const double deep = std::max(0.0, (severity - kJunctionAt) / (1.0 - kJunctionAt));
    const double mouth = 0.22 * through + 0.08 * deep;
    const double base = mouth + 0.15 * through + 1.4 * deep * (2.0 - deep);
    const double room = std::min(2.8, stop.roomMm);
    const double depth = std::max(0.0, 0.95 * room * deep * (2.0 - deep));

    const double reach = std::max(0.75, base / grid.cellMm);
    const auto lowestJunction = static_cast<float>(*junctionHere) - 1.0F;
    const auto first = [&](double at) { return std::max(0, static_cast<int>(std::ceil(at - reach))); };
    const auto last = [&](double at) { return std::min(grid.side - 1, static_cast<int>(std::floor(at + reach))); };
    for (int j = first(centre.y); j <= last(centre.y); ++j) {
        for (int i = first(centre.x); i <= last(centre.x); ++i) {
            const std::size_t k = grid.index(i, j);
            terrain::ColumnLayers& column = ground.layers[k];
            const double aside =
                grid.cellMm * std::sqrt((i - centre.x) * (i - centre.x) + (j - centre.y) * (j - centre.y));
            // The nearest node always belongs to the mouth of the lesion, even on a fine grid.
            const bool isNearest = i == static_cast<int>(node.x) && j == static_cast<int>(node.y);
            // If enamel fills the whole column, the lesion has no junction to follow, and none down the wall.
            if (!ground.solid(k) || (aside > base && !isNearest) || column.dej - ground.bottom[k] < 0.3F ||
                column.dej < lowestJunction || static_cast<double>(ground.sideMm[k]) < kWallShare * ground.broadestMm)
                continue;
            const auto surface = static_cast<double>(ground.top[k]);
            const double junction = std::min(surface, static_cast<double>(column.dej));
            const double enamel = surface - junction;
            double roof = surface;
            double floor = surface;
            if (aside <= mouth || isNearest)
                floor = surface - through * enamel * (1.0 - (mouth > 0.0 ? 0.6 * std::min(1.0, aside / mouth) : 0.0));
            if (deep > 0.0) {
                const double out = aside / base;
                floor = std::min(floor, junction - depth * (1.0 - out) * (1.0 + 0.5 * out));
                if (aside > mouth) {
                    const double under = 1.0 - (aside - mouth) / (base - mouth);
                    roof = junction + enamel * under * under * under;
                }
            }
            addInterval(column, static_cast<float>(roof), std::max(static_cast<float>(floor), ground.lowest(i, j)));
        }
    }
}

std::vector<LesionStop> walk(const Ground& ground, std::uint64_t seed)
{
    const FissureMap map(ground.grid, ground.top, ground.sideMm);
    std::vector<LesionStop> line;
    for (const Stop& stop : map.walk(seed, kLongestMm)) {
        const int i = stop.a * map.lattice().stride();
        const int j = stop.b * map.lattice().stride();
        if (!ground.grid.contains(i, j))
            continue;
        const float junction = ground.layers[ground.grid.index(i, j)].dej;
        line.push_back({ground.grid.nodeMm(i, j), stop.fromPitMm, static_cast<double>(junction - ground.lowest(i, j))});
    }
    return line;
}

void growAlong(Ground& ground, std::span<const LesionStop> line, double extent)
{
    constexpr double kFading = 0.5;  ///< severity lost from the pit to the end of the longest line
    for (const LesionStop& stop : line) {
        const double severity = extent - kFading * stop.fromPitMm / kLongestMm;
        if (severity > 0.0)
            growAt(ground, stop, std::min(1.0, severity));
    }
}

/// Grows the decay of a smooth surface. Every length increases with the extent, so that a smaller lesion is always
/// inside a larger one.
void growOnSurface(Ground& ground, const SurfaceLesion& lesion, double extent)
{
    constexpr double kSmallest = 0.45;    ///< share of the half lengths at the start of decay
    constexpr double kDeepestMm = 2.2;    ///< below the junction
    constexpr double kSecondCone = 0.85;  ///< half lengths of the cone in dentin, share of the outline's
    constexpr double kThickestMm = 1.6;   ///< thickest enamel that decay passes through; in thicker enamel, it ends
                                          ///< there
    const terrain::Grid& grid = ground.grid;
    const glm::dvec2 half = lesion.halfMm * (kSmallest + (1.0 - kSmallest) * extent);
    const double through = std::min(1.0, extent / kJunctionAt);
    const double deep = std::max(0.0, (extent - kJunctionAt) / (1.0 - kJunctionAt));
    const auto junctionHere = junctionAt(ground, grid.latticeOf(lesion.atMm));
    if (!junctionHere)
        return;
    const glm::dvec2 middle = glm::round(grid.latticeOf(lesion.atMm));
    const double room =
        *junctionHere - static_cast<double>(ground.lowest(static_cast<int>(middle.x), static_cast<int>(middle.y)));
    const double depth = std::clamp(0.95 * room, 0.0, kDeepestMm) * deep * (2.0 - deep);
    for (std::size_t k = 0; k < grid.count(); ++k) {
        const glm::dvec2 away = (grid.nodeMm(k) - lesion.atMm) / half;
        const double out = std::sqrt(away.x * away.x + away.y * away.y);
        if (out >= 1.0 || !ground.solid(k))
            continue;
        const auto surface = static_cast<double>(ground.top[k]);
        const auto bottom = static_cast<double>(ground.bottom[k]);
        const double junction =
            std::clamp(static_cast<double>(ground.layers[k].dej), std::max(bottom, surface - kThickestMm), surface);
        const double share = std::min(1.0, through * (1.0 - out) * (1.0 + 4.0 * deep));
        double floor = surface - share * (surface - junction);
        if (deep > 0.0 && out < kSecondCone && junction == static_cast<double>(ground.layers[k].dej))
            floor = std::min(floor, junction - depth * (1.0 - out / kSecondCone) * (1.0 + 0.5 * out / kSecondCone));
        const int i = static_cast<int>(k % static_cast<std::size_t>(grid.side));
        const int j = static_cast<int>(k / static_cast<std::size_t>(grid.side));
        addInterval(ground.layers[k], ground.top[k], std::max(static_cast<float>(floor), ground.lowest(i, j)));
    }
}

/// Grows decay by the rule of 2011: from the lowest point near the centre, depth first, the lower neighbour first.
void fillLowPoints(Ground& ground, double extent, std::uint64_t seed)
{
    constexpr double kLargestMm2 = 12.0;
    constexpr float kLowMm = 1.2F;  ///< height above the start up to which a point is low
    const terrain::Grid& grid = ground.grid;
    Rng rng(seed ^ 0x6C6F77ULL);
    double x = 0.0;
    double y = 0.0;
    double columns = 0.0;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            if (!ground.solid(grid.index(i, j)))
                continue;
            x += i;
            y += j;
            columns += 1.0;
        }
    }
    const double astray = seed == 0 ? 0.0 : 0.5 / grid.cellMm;
    x = x / columns + rng.uniform(-astray, astray);
    y = y / columns + rng.uniform(-astray, astray);

    const auto allowed = [&](int i, int j) {
        return grid.contains(i, j) && ground.solid(grid.index(i, j)) &&
               static_cast<double>(ground.sideMm[grid.index(i, j)]) > kTableShare * ground.broadestMm;
    };
    const auto height = [&](int i, int j) { return ground.top[grid.index(i, j)]; };
    // If two directions are about equally low, the seed decides.
    const ValueNoise lure(seed, 0.8);
    const auto pull = [&](const std::pair<int, int>& at) {
        if (!allowed(at.first, at.second))
            return static_cast<double>(kNoValue);
        const glm::dvec2 place = grid.nodeMm(at.first, at.second) - grid.middleMm();
        return static_cast<double>(height(at.first, at.second)) + 0.15 * lure.at(place.x, place.y);
    };
    int i0 = static_cast<int>(std::lround(x));
    int j0 = static_cast<int>(std::lround(y));
    const double nearMm = 1.5;
    const int near = static_cast<int>(nearMm / grid.cellMm);
    float lowest = kNoValue;
    const int ci = i0;
    const int cj = j0;
    for (int j = cj - near; j <= cj + near; ++j) {
        for (int i = ci - near; i <= ci + near; ++i) {
            if (allowed(i, j) && height(i, j) < lowest) {
                lowest = height(i, j);
                i0 = i;
                j0 = j;
            }
        }
    }
    if (lowest == kNoValue)
        return;

    const auto budget = static_cast<std::size_t>(std::ceil(extent * kLargestMm2 / (grid.cellMm * grid.cellMm)));
    std::vector<std::uint8_t> seen(grid.count(), 0);
    std::vector<std::pair<int, int>> open{{i0, j0}};
    std::size_t filled = 0;
    while (!open.empty() && filled < budget) {
        const auto [i, j] = open.back();
        open.pop_back();
        const std::size_t k = grid.index(i, j);
        if (seen[k] != 0)
            continue;
        seen[k] = 1;
        ++filled;
        terrain::ColumnLayers& column = ground.layers[k];
        const float deepest = ground.lowest(i, j);
        const float junction = std::min(ground.top[k], column.dej);
        const float into = static_cast<float>(0.7 * extent) * std::max(0.0F, junction - deepest);
        addInterval(column, ground.top[k], std::max(deepest, junction - std::min(2.0F, into)));

        std::pair<int, int> neighbours[4] = {{i + 1, j}, {i - 1, j}, {i, j + 1}, {i, j - 1}};
        std::stable_sort(std::begin(neighbours), std::end(neighbours),
                         [&](const auto& p, const auto& q) { return pull(p) > pull(q); });
        for (const auto& [ni, nj] : neighbours)
            if (allowed(ni, nj) && seen[grid.index(ni, nj)] == 0 && height(ni, nj) < lowest + kLowMm)
                open.emplace_back(ni, nj);
    }
}

}  // namespace

std::vector<LesionStop> fissureLine(const terrain::Grid& grid, std::span<const float> top,
                                    std::span<const float> bottom, std::vector<terrain::ColumnLayers> layers,
                                    std::uint64_t seed)
{
    return walk(survey(grid, top, bottom, layers), seed);
}

void addCaries(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
               std::vector<terrain::ColumnLayers>& layers, const CariesOptions& options)
{
    const double extent = std::clamp(options.extent, 0.0, 1.0);
    Ground ground = survey(grid, top, bottom, layers);
    if (!(extent > 0.0) || ground.broadestMm <= 0.0)
        return;
    if (options.surface)
        growOnSurface(ground, *options.surface, extent);
    else if (options.rule == CariesRule::LowPointFill2011)
        fillLowPoints(ground, extent, options.seed);
    else if (options.line.empty())
        growAlong(ground, walk(ground, options.seed), extent);
    else
        growAlong(ground, options.line, extent);
}

}  // namespace core::teeth
