// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imaging/Canals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/bur/Reach.h"

namespace core::imaging {
namespace {

using terrain::ColumnLayers;
using terrain::Grid;
using terrain::ToothAnatomy;

constexpr double kLevelMm = 0.25;     ///< between two sections of a root
constexpr double kLeastRootMm = 2.5;  ///< a shorter one is a bump of the under surface, not a root
// Largest share of the area of its neck that a root has near its tip. A root of a scan that ends in a flat face has no
// apex.
constexpr double kTaper = 0.6;
constexpr double kFurcationMm = 1.5;   ///< below a furcation, where roots widen towards each other but canals do not
constexpr double kOverlapMm = 1.5;     ///< length of a canal inside the pulp of the model, in a tooth with one root
constexpr double kAboveApexMm = 0.5;   ///< distance between the end of a canal and the apex: the apical constriction
constexpr double kCanalAcross = 0.17;  ///< width of a canal at its orifice, as a share of the width of the root
constexpr double kCanalAlong = 0.24;   ///< the same along the longer axis: a flat root has a flat canal
constexpr double kApexShare = 0.35;    ///< size of a canal at the apex, as a share of its size at the orifice
constexpr double kLeastRadiusMm = 0.13;
constexpr double kMostRadiusMm = 0.6;
constexpr double kLeastDentinMm = 0.55;  ///< least thickness of the dentin below a canal
/// Of two canals in a root, the distance of each from its middle, as a share of half the width of the root; and the
/// width of each, as a share of that of a single canal.
constexpr double kAsideShare = 0.5;
constexpr double kOfTwoShare = 0.55;
constexpr double kJoinMm = 6.0;  ///< a canal that ends at most this far below the chamber is joined to it

/// The section of a root at one height.
struct RootSection
{
    double heightMm = 0.0;
    glm::dvec2 middleMm{0.0};
    glm::dvec2 halfMm{0.0};  ///< half axes of an ellipse with the same moments
};

/// A root, with its sections from the apex up.
struct Root
{
    double apexMm = 0.0;
    std::vector<RootSection> sections;
};

/// Finds the roots of a tooth. A level rises from below, and the columns whose under surface is below it form islands.
/// An island that is high enough when it meets another one is a root.
class RootFinder
{
public:
    RootFinder(const ToothAnatomy& anatomy, double topMm) : m_anatomy(anatomy), m_topMm(topMm) {}

    [[nodiscard]] std::vector<Root> find()
    {
        const Grid& grid = m_anatomy.grid;
        std::vector<std::size_t> order;
        for (std::size_t k = 0; k < grid.count(); ++k)
            if (m_anatomy.top[k] > m_anatomy.bottom[k] && static_cast<double>(m_anatomy.bottom[k]) < m_topMm)
                order.push_back(k);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return m_anatomy.bottom[a] < m_anatomy.bottom[b]; });
        if (order.empty())
            return {};
        m_parent.assign(grid.count(), kNone);
        m_islands.assign(grid.count(), {});
        const int side = grid.side;
        double level = static_cast<double>(m_anatomy.bottom[order.front()]) + kLevelMm;
        for (const std::size_t k : order) {
            const auto height = static_cast<double>(m_anatomy.bottom[k]);
            for (; level <= height; level += kLevelMm)
                noteSections(level);
            m_parent[k] = k;
            m_islands[k] = Island{height, 1.0, grid.nodeMm(k)};
            m_islands[k].squares = m_islands[k].sum * m_islands[k].sum;
            m_alive.push_back(k);
            const int i = static_cast<int>(k) % side;
            const int j = static_cast<int>(k) / side;
            for (const auto& [x, y] : {std::pair(i - 1, j), {i + 1, j}, {i, j - 1}, {i, j + 1}})
                if (grid.contains(x, y))
                    join(k, grid.index(x, y), height);
        }
        for (; level <= m_topMm; level += kLevelMm)
            noteSections(level);
        for (const std::size_t island : m_alive)
            finish(m_islands[island], m_topMm);
        return std::move(m_roots);
    }

private:
    struct Island
    {
        double apexMm = 0.0;
        double count = 0.0;
        glm::dvec2 sum{0.0};
        glm::dvec2 squares{0.0};
        bool isTrunk = false;  ///< the trunk of the tooth, where several roots have met
        std::vector<RootSection> sections = {};
    };
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    /// Returns the representative node of the island of a node.
    std::size_t islandOf(std::size_t k)
    {
        while (m_parent[k] != k) {
            m_parent[k] = m_parent[m_parent[k]];
            k = m_parent[k];
        }
        return k;
    }

    void join(std::size_t a, std::size_t b, double level)
    {
        if (m_parent[b] == kNone)
            return;
        a = islandOf(a);
        b = islandOf(b);
        if (a == b)
            return;
        // A trunk absorbs an island that meets it, and the deeper of two roots absorbs the other one.
        if (!m_islands[a].isTrunk && (m_islands[b].isTrunk || m_islands[b].apexMm < m_islands[a].apexMm))
            std::swap(a, b);
        Island& into = m_islands[a];
        Island& from = m_islands[b];
        const bool isRoot = level - from.apexMm >= kLeastRootMm && !from.isTrunk;
        if (isRoot) {
            finish(from, level);
            finish(into, level);
            into.isTrunk = true;
        }
        into.apexMm = std::min(into.apexMm, from.apexMm);
        into.count += from.count;
        into.sum += from.sum;
        into.squares += from.squares;
        m_parent[b] = a;
        m_alive.erase(std::find(m_alive.begin(), m_alive.end(), b));
    }

    void noteSections(double level)
    {
        for (const std::size_t k : m_alive) {
            Island& island = m_islands[k];
            if (island.isTrunk)
                continue;
            const glm::dvec2 middle = island.sum / island.count;
            const glm::dvec2 variance = glm::max(island.squares / island.count - middle * middle, glm::dvec2(0.0));
            island.sections.push_back({level, middle, 2.0 * glm::sqrt(variance)});
        }
    }

    void finish(Island& island, double level)
    {
        std::vector<RootSection> sections = std::exchange(island.sections, {});
        if (island.isTrunk || level - island.apexMm < kLeastRootMm || sections.size() < 3)
            return;
        const auto area = [](const RootSection& section) { return section.halfMm.x * section.halfMm.y; };
        if (area(sections[1]) < kTaper * area(sections.back()))
            m_roots.push_back({island.apexMm, std::move(sections)});
    }

    const ToothAnatomy& m_anatomy;
    double m_topMm;
    std::vector<std::size_t> m_parent;
    std::vector<Island> m_islands;     ///< by islandOf()
    std::vector<std::size_t> m_alive;  ///< islands that no other one has absorbed
    std::vector<Root> m_roots;
};

/// Returns where a canal opens into the chamber: at the point of the pulp nearest to the root, shifted inwards so that
/// the canal is under the chamber.
/// @param pulp  the points of the floor of the pulp, not empty
glm::dvec2 mouthOver(const std::vector<glm::dvec3>& pulp, glm::dvec2 rootMm)
{
    glm::dvec2 sum(0.0);
    glm::dvec2 nearest(pulp.front());
    for (const glm::dvec3& point : pulp) {
        const glm::dvec2 at(point);
        sum += at;
        if (glm::distance(at, rootMm) < glm::distance(nearest, rootMm))
            nearest = at;
    }
    const glm::dvec2 inwards = sum / static_cast<double>(pulp.size()) - nearest;
    const double far = glm::length(inwards);
    return far > 0.0 ? nearest + inwards * std::min(1.0, kMostRadiusMm / far) : nearest;
}

/// Returns the half of a root, buccal or lingual, that contains one of its two canals.
/// @param side  -1 or 1, along y
Root halfOf(Root root, double side)
{
    for (RootSection& section : root.sections) {
        section.middleMm.y += side * kAsideShare * section.halfMm.y;
        section.halfMm.y *= kOfTwoShare;
    }
    return root;
}

/// Returns for each canal the root, or the part of a root, that contains it. The mesial root of a lower first or second
/// molar usually has two canals; every other root has one.
std::vector<Root> canalRoots(const std::vector<Root>& roots, int fdi)
{
    const bool isLowerMolar = fdi == 36 || fdi == 37 || fdi == 46 || fdi == 47;
    if (!isLowerMolar || roots.size() < 2)
        return roots;
    const auto neckX = [](const Root& root) { return root.sections.back().middleMm.x; };
    const auto mesial =
        std::min_element(roots.begin(), roots.end(), [&](const Root& a, const Root& b) { return neckX(a) < neckX(b); });
    std::vector<Root> parts;
    for (auto root = roots.begin(); root != roots.end(); ++root) {
        if (root != mesial) {
            parts.push_back(*root);
            continue;
        }
        for (const double side : {-1.0, 1.0})
            parts.push_back(halfOf(*root, side));
    }
    return parts;
}

/// Returns sections of the canal in a root, from the apex up to `topMm`, where it opens into the chamber.
std::vector<RootSection> canalIn(const Root& root, glm::dvec2 mouthMm, double topMm)
{
    std::vector<RootSection> canal;
    const RootSection& neck = root.sections.back();
    const double from = root.apexMm + kAboveApexMm;
    const auto add = [&](double height, glm::dvec2 middle, glm::dvec2 half) {
        const double share = kApexShare + (1.0 - kApexShare) * std::clamp((height - from) / (topMm - from), 0.0, 1.0);
        const bool isWideX = half.x > half.y;
        const glm::dvec2 part(isWideX ? kCanalAlong : kCanalAcross, isWideX ? kCanalAcross : kCanalAlong);
        canal.push_back(
            {height, middle, glm::clamp(share * part * half, glm::dvec2(kLeastRadiusMm), glm::dvec2(kMostRadiusMm))});
    };
    for (const RootSection& section : root.sections)
        if (section.heightMm >= from)
            add(section.heightMm, section.middleMm, section.halfMm);
    for (double height = neck.heightMm + kLevelMm; height < topMm + kLevelMm; height += kLevelMm) {
        const double way = std::clamp((height - neck.heightMm) / std::max(topMm - neck.heightMm, kLevelMm), 0.0, 1.0);
        add(height, glm::mix(neck.middleMm, mouthMm, way), neck.halfMm);
    }
    return canal;
}

/// Returns the lowest and the highest point of a canal on a vertical line. If the line does not meet the canal, the
/// first value is higher than the second.
std::pair<double, double> rangeOf(const std::vector<RootSection>& canal, glm::dvec2 atMm)
{
    std::pair<double, double> range{1.0e9, -1.0e9};
    double before = -1.0;
    for (std::size_t k = 0; k < canal.size(); ++k) {
        const glm::dvec2 away = (atMm - canal[k].middleMm) / canal[k].halfMm;
        const double inside = 1.0 - glm::length(away);
        const auto note = [&](double height) {
            range = {std::min(range.first, height), std::max(range.second, height)};
        };
        if (inside >= 0.0)
            note(canal[k].heightMm);
        if (k > 0 && (inside >= 0.0) != (before >= 0.0))
            note(canal[k - 1].heightMm + (canal[k].heightMm - canal[k - 1].heightMm) * before / (before - inside));
        before = inside;
    }
    return range;
}

void add(ToothAnatomy& anatomy, const std::vector<RootSection>& canal, double reachMm)
{
    for (std::size_t k = 0; k < anatomy.grid.count(); ++k) {
        if (!(anatomy.top[k] > anatomy.bottom[k]))
            continue;
        auto [low, high] = rangeOf(canal, anatomy.grid.nodeMm(k));
        low = std::max(low, static_cast<double>(anatomy.bottom[k]) + kLeastDentinMm);
        high = std::min(high, reachMm);
        if (!(high > low))
            continue;
        ColumnLayers& column = anatomy.layers[k];
        if (!terrain::hasPulp(anatomy, k)) {
            column.pulpRoof = static_cast<float>(high);
            column.pulpFloor = static_cast<float>(low);
        } else if (high >= static_cast<double>(column.pulpFloor) - kJoinMm) {
            column.pulpFloor = std::min(column.pulpFloor, static_cast<float>(low));
        }
    }
}

/// Returns an anatomy with canals, or the same one if it has no pulp or no roots.
std::shared_ptr<const ToothAnatomy> made(const std::shared_ptr<const ToothAnatomy>& anatomy)
{
    const double reachMm = bur::lowestTipMm(*anatomy);
    std::vector<glm::dvec3> pulp;
    for (std::size_t k = 0; k < anatomy->grid.count(); ++k)
        if (terrain::hasPulp(*anatomy, k))
            pulp.emplace_back(anatomy->grid.nodeMm(k), static_cast<double>(anatomy->layers[k].pulpFloor));
    std::vector<Root> roots = canalRoots(RootFinder(*anatomy, reachMm).find(), anatomy->fdi);
    if (pulp.empty() || roots.empty())
        return anatomy;
    const glm::dvec3 lowest =
        *std::min_element(pulp.begin(), pulp.end(), [](const glm::dvec3& a, const glm::dvec3& b) { return a.z < b.z; });
    const bool isSingle = roots.size() == 1;
    auto pictured = std::make_shared<ToothAnatomy>(*anatomy);
    for (Root& root : roots) {
        const glm::dvec2 mouth = isSingle ? glm::dvec2(lowest) : mouthOver(pulp, root.sections.back().middleMm);
        // In a tooth with one root, the pulp of the model is also the canal, as far as it extends.
        const double topMm = isSingle ? std::min(reachMm, lowest.z + kOverlapMm) : reachMm;
        const double neckMm = std::min(root.sections.back().heightMm, topMm) - kFurcationMm;
        while (root.sections.size() > 1 && root.sections.back().heightMm > neckMm)
            root.sections.pop_back();
        add(*pictured, canalIn(root, mouth, topMm), reachMm);
    }
    return pictured;
}

}  // namespace

terrain::Tooth withCanals(terrain::Tooth tooth)
{
    if (!tooth.anatomy->lying.isUpright())
        return tooth;
    struct Known
    {
        std::weak_ptr<const ToothAnatomy> of;
        std::shared_ptr<const ToothAnatomy> pictured;  ///< null: the anatomy itself, because it must not own itself
    };
    static std::mutex guard;
    static std::map<const ToothAnatomy*, Known> known;
    const std::lock_guard lock(guard);
    std::erase_if(known, [](const auto& entry) { return entry.second.of.expired(); });
    const auto [found, isNew] = known.try_emplace(tooth.anatomy.get());
    if (isNew) {
        auto pictured = made(tooth.anatomy);
        found->second = {tooth.anatomy, pictured == tooth.anatomy ? nullptr : std::move(pictured)};
    }
    if (found->second.pictured)
        tooth.anatomy = found->second.pictured;
    return tooth;
}

}  // namespace core::imaging
