// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imaging/Canals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace core::imaging {
namespace {

using terrain::ColumnLayers;
using terrain::Grid;
using terrain::ToothAnatomy;

constexpr double kLevelMm = 0.25;     ///< between two sections of a root
constexpr double kLeastRootMm = 2.5;  ///< what is shorter is no root but a bump of the under surface
constexpr double kTaper = 0.6;        ///< share of the area of its neck that the tip of a root has at most: a face that
                                      ///< a scan was cut off at is no apex
constexpr double kFurcationMm = 1.5;  ///< below a furcation roots widen towards each other, and canals do not
constexpr double kOverlapMm = 1.5;    ///< of a canal and the pulp of the model, in a tooth with one root
constexpr double kAboveApexMm = 0.9;  ///< where a canal ends
constexpr double kCanalAcross = 0.17;  ///< width of a canal at its orifice, as a share of the width of the root
constexpr double kCanalAlong = 0.24;   ///< the same along the longer axis: a flat root has a flat canal
constexpr double kApexShare = 0.35;    ///< size of a canal at the apex, as a share of its size at the orifice
constexpr double kLeastRadiusMm = 0.13;
constexpr double kMostRadiusMm = 0.6;
constexpr double kLeastDentinMm = 1.0;  ///< below a canal
constexpr double kJoinMm = 1.0;         ///< a canal that ends no further below the chamber is joined to it

/// The section of a root at one height.
struct RootSection
{
    double heightMm = 0.0;
    glm::dvec2 middleMm{0.0};
    glm::dvec2 halfMm{0.0};  ///< half axes of an ellipse with the same moments
};

/// From the apex up.
struct Root
{
    double apexMm = 0.0;
    std::vector<RootSection> sections;
};

/// Finds the roots of a tooth: a level rises from below, and the columns whose under surface lies below it form
/// islands. An island that is high enough when it meets another one is a root.
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
        const auto side = static_cast<std::size_t>(grid.side);
        double level = static_cast<double>(m_anatomy.bottom[order.front()]) + kLevelMm;
        for (const std::size_t k : order) {
            const auto height = static_cast<double>(m_anatomy.bottom[k]);
            for (; level <= height; level += kLevelMm)
                noteSections(level);
            m_parent[k] = k;
            m_islands[k] = Island{height, 1.0, grid.nodeMm(static_cast<int>(k % side), static_cast<int>(k / side))};
            m_islands[k].squares = m_islands[k].sum * m_islands[k].sum;
            m_alive.push_back(k);
            const std::size_t i = k % side;
            const std::size_t j = k / side;
            if (i > 0)
                join(k, k - 1, height);
            if (i + 1 < side)
                join(k, k + 1, height);
            if (j > 0)
                join(k, k - side, height);
            if (j + 1 < side)
                join(k, k + side, height);
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
        bool isTrunk = false;  ///< several roots have met
        std::vector<RootSection> sections = {};
    };
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    std::size_t find(std::size_t k)
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
        a = find(a);
        b = find(b);
        if (a == b)
            return;
        // A trunk takes in what meets it, and the deeper of two roots the other one.
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
    std::vector<Island> m_islands;     ///< by their root node
    std::vector<std::size_t> m_alive;  ///< root nodes
    std::vector<Root> m_roots;
};

/// Where a canal opens: the place of the pulp nearest to the root, so far inside that the canal lies under the chamber.
/// Nothing where no column has pulp.
std::optional<glm::dvec2> mouthOver(const ToothAnatomy& anatomy, glm::dvec2 rootMm)
{
    std::optional<glm::dvec2> nearest;
    glm::dvec2 sum(0.0);
    double count = 0.0;
    for (int j = 0; j < anatomy.grid.side; ++j) {
        for (int i = 0; i < anatomy.grid.side; ++i) {
            if (!terrain::hasPulp(anatomy, anatomy.grid.index(i, j)))
                continue;
            const glm::dvec2 at = anatomy.grid.nodeMm(i, j);
            sum += at;
            count += 1.0;
            if (!nearest || glm::distance(at, rootMm) < glm::distance(*nearest, rootMm))
                nearest = at;
        }
    }
    if (!nearest)
        return {};
    const glm::dvec2 inwards = sum / count - *nearest;
    const double far = glm::length(inwards);
    return far > 0.0 ? *nearest + inwards * std::min(1.0, kMostRadiusMm / far) : *nearest;
}

/// The lowest point of the pulp.
glm::dvec3 lowestPulp(const ToothAnatomy& anatomy)
{
    glm::dvec3 lowest(0.0, 0.0, std::numeric_limits<double>::max());
    for (int j = 0; j < anatomy.grid.side; ++j) {
        for (int i = 0; i < anatomy.grid.side; ++i) {
            const std::size_t k = anatomy.grid.index(i, j);
            if (const auto floor = static_cast<double>(anatomy.layers[k].pulpFloor);
                terrain::hasPulp(anatomy, k) && floor < lowest.z)
                lowest = {anatomy.grid.nodeMm(i, j), floor};
        }
    }
    return lowest;
}

/// Sections of the canal in a root, from the apex up to `topMm`, where it opens into the chamber.
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

/// Lowest and highest point of a canal on the vertical line through a place; the first is the higher one if it does not
/// meet the canal.
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
    const Grid& grid = anatomy.grid;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            if (!(anatomy.top[k] > anatomy.bottom[k]))
                continue;
            auto [low, high] = rangeOf(canal, grid.nodeMm(i, j));
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
}

std::shared_ptr<const ToothAnatomy> made(const std::shared_ptr<const ToothAnatomy>& anatomy, double reachMm)
{
    std::vector<std::vector<RootSection>> canals;
    std::vector<Root> roots = RootFinder(*anatomy, reachMm).find();
    const bool isSingle = roots.size() == 1;
    for (Root& root : roots) {
        const auto mouth = mouthOver(*anatomy, root.sections.back().middleMm);
        if (!mouth)
            continue;
        // In a single root the pulp of the model is the canal as well, as far as it comes.
        const glm::dvec3 lowest = lowestPulp(*anatomy);
        const double topMm = isSingle ? std::min(reachMm, lowest.z + kOverlapMm) : reachMm;
        const double neckMm = std::min(root.sections.back().heightMm, topMm) - kFurcationMm;
        while (root.sections.size() > 1 && root.sections.back().heightMm > neckMm)
            root.sections.pop_back();
        canals.push_back(canalIn(root, isSingle ? glm::dvec2(lowest) : *mouth, topMm));
    }
    if (canals.empty())
        return anatomy;
    auto pictured = std::make_shared<ToothAnatomy>(*anatomy);
    for (const std::vector<RootSection>& canal : canals)
        add(*pictured, canal, reachMm);
    return pictured;
}

}  // namespace

std::shared_ptr<const ToothAnatomy> withCanals(const std::shared_ptr<const ToothAnatomy>& anatomy, double reachMm)
{
    struct Known
    {
        std::weak_ptr<const ToothAnatomy> of;
        std::shared_ptr<const ToothAnatomy> pictured;
    };
    static std::mutex guard;
    static std::map<const ToothAnatomy*, Known> known;
    const std::lock_guard lock(guard);
    std::erase_if(known, [](const auto& entry) { return entry.second.of.expired(); });
    const auto found = known.find(anatomy.get());
    if (found != known.end())
        return found->second.pictured;
    auto pictured = made(anatomy, reachMm);
    // Itself would keep itself alive.
    if (pictured != anatomy)
        known.emplace(anatomy.get(), Known{anatomy, pictured});
    return pictured;
}

terrain::Tooth withCanals(const terrain::Tooth& tooth, double reachMm)
{
    terrain::Tooth pictured = tooth;
    pictured.anatomy = withCanals(tooth.anatomy, reachMm);
    return pictured;
}

}  // namespace core::imaging
