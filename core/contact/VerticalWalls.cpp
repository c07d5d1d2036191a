// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/VerticalWalls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace core::contact {
namespace {

/// A rise from one node to the next is an edge if it is at least this many cells, and the ground on either side is
/// gentler by as much.
constexpr double kLeastRise = 0.75;
constexpr double kGentler = 3.0;

/// The top of one side differs from node to node by no more than this many cells a cell.
constexpr double kTopSlope = 2.0;

/// Nodes farther from the axis, in radii, do not count: a radius, half a cell and a chord.
constexpr double kReachShare = 2.0;

constexpr double kLengthRounding = 1.0e-9;

/// Longest chord, in cells, and as a share of the bur's radius. Wall points farther apart are on two sides of a corner
/// that contains the bur.
constexpr double kChordCells = 4.25;
constexpr double kChordShare = 0.75;

/// A line is fitted to the edges within this many cells. It is valid if none of them is farther from it than
/// kFitsCells.
constexpr double kFitCells = 5.5;
constexpr double kFitsCells = 0.75;

double lengthOf(glm::dvec2 v)
{
    return std::sqrt(v.x * v.x + v.y * v.y);
}

/// Returns whether the ground drops vertically from node (i, j) towards (i + di, j + dj).
bool fallsOff(const terrain::ToothAnatomy& anatomy, int i, int j, int di, int dj)
{
    const terrain::Grid& grid = anatomy.grid;
    const auto topAt = [&](int step) {
        const int atI = i + step * di;
        const int atJ = j + step * dj;
        return grid.contains(atI, atJ) ? static_cast<double>(anatomy.top[grid.index(atI, atJ)])
                                       : static_cast<double>(terrain::kEmptyTop);
    };
    const double drop = topAt(0) - topAt(1);
    if (!(drop >= kLeastRise * grid.cellMm))
        return false;
    const double behind = std::abs(topAt(-1) - topAt(0));
    const double before = std::abs(topAt(1) - topAt(2));
    return kGentler * behind <= drop && kGentler * before <= drop;
}

}  // namespace

std::vector<VerticalWalls::Fall> VerticalWalls::fallsOf(const terrain::ToothAnatomy& anatomy)
{
    std::vector<Fall> falls;
    const terrain::Grid& grid = anatomy.grid;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            if (!(anatomy.top[grid.index(i, j)] > anatomy.bottom[grid.index(i, j)]))
                continue;
            for (const auto& [di, dj] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)})
                if (fallsOff(anatomy, i, j, di, dj))
                    falls.push_back({{i + 0.5 * di, j + 0.5 * dj}, {di, dj}, {i, j}});
        }
    }
    return falls;
}

/// Returns the middle of an edge, moved onto a straight line if the wall is straight there. The line is fitted by total
/// least squares to the surrounding edges with the same direction or one at right angles.
glm::dvec2 VerticalWalls::straightened(const Fall& fall, const std::vector<Fall>& all,
                                       const std::vector<std::vector<std::size_t>>& byBlock, int blockSide)
{
    const int reach = static_cast<int>(std::ceil(kFitCells / kBlock));
    const int blockI = fall.high.x / kBlock;
    const int blockJ = fall.high.y / kBlock;
    std::vector<glm::dvec2> around;
    glm::dvec2 mean(0.0);
    for (int j = std::max(0, blockJ - reach); j <= std::min(blockSide - 1, blockJ + reach); ++j) {
        for (int i = std::max(0, blockI - reach); i <= std::min(blockSide - 1, blockI + reach); ++i) {
            for (const std::size_t k : byBlock[static_cast<std::size_t>(j * blockSide + i)]) {
                const glm::dvec2 apart = all[k].middle - fall.middle;
                if (glm::dot(apart, apart) > kFitCells * kFitCells || glm::dot(all[k].outwards, fall.outwards) < 0.0)
                    continue;
                around.push_back(apart);
                mean += apart;
            }
        }
    }
    mean /= static_cast<double>(around.size());
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (const glm::dvec2& place : around) {
        const glm::dvec2 off = place - mean;
        xx += off.x * off.x;
        xy += off.x * off.y;
        yy += off.y * off.y;
    }
    // Direction of the line: the eigenvector of the larger eigenvalue.
    const double half = 0.5 * (xx - yy);
    const double root = std::sqrt(half * half + xy * xy);
    glm::dvec2 along = half >= 0.0 ? glm::dvec2(half + root, xy) : glm::dvec2(xy, root - half);
    const double length = lengthOf(along);
    if (!(length > 0.0))
        return fall.middle;
    along /= length;
    const glm::dvec2 aside(-along.y, along.x);
    for (const glm::dvec2& place : around)
        if (std::abs(glm::dot(place - mean, aside)) > kFitsCells)
            return fall.middle;
    return fall.middle + aside * glm::dot(mean, aside);
}

VerticalWalls::VerticalWalls(const terrain::ToothAnatomy& anatomy)
    : m_side(anatomy.grid.side), m_blockSide((anatomy.grid.side + kBlock - 1) / kBlock)
{
    const terrain::Grid& grid = anatomy.grid;
    const std::vector<Fall> falls = fallsOf(anatomy);
    const auto blocks = static_cast<std::size_t>(m_blockSide) * static_cast<std::size_t>(m_blockSide);
    std::vector<std::vector<std::size_t>> byBlock(blocks);
    for (std::size_t k = 0; k < falls.size(); ++k)
        byBlock[static_cast<std::size_t>(falls[k].high.y / kBlock * m_blockSide + falls[k].high.x / kBlock)].push_back(
            k);
    for (const std::vector<std::size_t>& block : byBlock) {
        m_first.push_back(static_cast<std::uint32_t>(m_posts.size()));
        for (const std::size_t k : block) {
            const glm::dvec2 place = straightened(falls[k], falls, byBlock, m_blockSide);
            m_posts.push_back({glm::vec2(grid.originMm + grid.cellMm * place), falls[k].high});
        }
    }
    m_first.push_back(static_cast<std::uint32_t>(m_posts.size()));

    double widest = 0.0;
    for (const bur::Bur& bur : bur::burs())
        widest = std::max(widest, bur.headRadiusMm);
    const auto reach = static_cast<int>(std::ceil(kReachShare * widest / grid.cellMm / kBlock)) + 1;
    m_hasNear.assign(blocks, 0);
    for (int j = 0; j < m_blockSide; ++j)
        for (int i = 0; i < m_blockSide; ++i)
            if (!byBlock[static_cast<std::size_t>(j * m_blockSide + i)].empty())
                for (int nearJ = std::max(0, j - reach); nearJ <= std::min(m_blockSide - 1, j + reach); ++nearJ)
                    for (int nearI = std::max(0, i - reach); nearI <= std::min(m_blockSide - 1, i + reach); ++nearI)
                        m_hasNear[static_cast<std::size_t>(nearJ * m_blockSide + nearI)] = 1;
}

bool VerticalWalls::isFar(glm::dvec2 lattice) const noexcept
{
    // For a position outside the map, uses the block at its border.
    const int i = std::clamp(static_cast<int>(lattice.x), 0, m_side - 1) / kBlock;
    const int j = std::clamp(static_cast<int>(lattice.y), 0, m_side - 1) / kBlock;
    return m_hasNear[static_cast<std::size_t>(j * m_blockSide + i)] == 0;
}

/// Returns whether a node and its neighbours are uncut. Beside a cut only the columns count: otherwise the pocket that
/// a bur made would be narrower than the bur.
bool VerticalWalls::isUncut(glm::ivec2 node, const terrain::Tooth& tooth) noexcept
{
    const terrain::Grid& grid = tooth.grid();
    const int i = node.x;
    const int j = node.y;
    for (int atJ = std::max(0, j - 1); atJ <= std::min(grid.side - 1, j + 1); ++atJ) {
        for (int atI = std::max(0, i - 1); atI <= std::min(grid.side - 1, i + 1); ++atI) {
            const std::size_t k = grid.index(atI, atJ);
            if (tooth.top[k] < tooth.anatomy->top[k])
                return false;
        }
    }
    return true;
}

std::size_t VerticalWalls::nodesNear(glm::dvec2 pointMm, const terrain::Tooth& tooth, const Reach& reach,
                                     double aboveMm, Nodes& nodes) const noexcept
{
    const terrain::Grid& grid = tooth.grid();
    const glm::dvec2 lattice = grid.latticeOf(pointMm);
    std::size_t count = 0;
    if (isFar(lattice))
        return count;
    const double cells = reach.farthest / grid.cellMm + 1.0;  // a wall point may be in front of its node
    const int firstI = std::clamp(static_cast<int>(lattice.x - cells), 0, m_side - 1) / kBlock;
    const int lastI = std::clamp(static_cast<int>(lattice.x + cells), 0, m_side - 1) / kBlock;
    const int firstJ = std::clamp(static_cast<int>(lattice.y - cells), 0, m_side - 1) / kBlock;
    const int lastJ = std::clamp(static_cast<int>(lattice.y + cells), 0, m_side - 1) / kBlock;
    for (int j = firstJ; j <= lastJ; ++j) {
        const std::size_t first = m_first[static_cast<std::size_t>(j * m_blockSide + firstI)];
        const std::size_t end = m_first[static_cast<std::size_t>(j * m_blockSide + lastI) + 1];
        for (std::size_t n = first; n < end && count < nodes.size(); ++n) {
            const Post& post = m_posts[n];
            const std::size_t k = grid.index(post.high.x, post.high.y);
            const glm::dvec2 place(post.placeMm);
            const glm::dvec2 away = place - pointMm;
            const double apart2 = glm::dot(away, away);
            if (apart2 > reach.farthest * reach.farthest || static_cast<double>(tooth.top[k]) <= aboveMm ||
                !isUncut(post.high, tooth))
                continue;
            nodes[count++] = {place, static_cast<double>(tooth.top[k]), static_cast<double>(tooth.bottom[k]),
                              std::sqrt(apart2)};
        }
    }
    return count;
}

VerticalWalls::Reach::Reach(const terrain::Grid& grid, const bur::BurMask& mask)
    : radius(static_cast<double>(mask.radiusMm)), chord(std::min(kChordCells * grid.cellMm, kChordShare * radius))
{
    const double proud = chord * chord / (8.0 * radius);  // height of the middle of a chord over its ends
    farthest = std::sqrt((radius + proud) * (radius + proud) + chord * chord);
}

/// The point of a wall that is nearest to a bur: at a wall point, or on a chord between two of them.
struct VerticalWalls::Foot
{
    glm::dvec2 place;
    double top;
    double bottom;
    glm::dvec2 along;  ///< slope of the side's top, along the chord
};

/// Computes the nearest point on the chord between two wall points. Returns false if there is none.
bool VerticalWalls::footBetween(glm::dvec2 pointMm, const Node& one, const Node& other, double longest,
                                Foot& foot) noexcept
{
    const glm::dvec2 chord = other.place - one.place;
    const double length2 = glm::dot(chord, chord);
    if (!(length2 > kLengthRounding) || length2 > longest * longest)
        return false;
    const double share = glm::dot(chord, pointMm - one.place) / length2;
    const double rise = other.top - one.top;
    if (share <= 0.0 || share >= 1.0 || rise * rise > kTopSlope * kTopSlope * length2)
        return false;
    foot = {one.place + chord * share, one.top + rise * share, one.bottom + (other.bottom - one.bottom) * share,
            chord * (rise / length2)};
    return true;
}

Touch VerticalWalls::touchOf(glm::dvec2 pointMm, const bur::BurMask& mask, const Foot& foot) noexcept
{
    const glm::dvec2 out = pointMm - foot.place;
    const double apart = lengthOf(out);
    const glm::dvec2 outwards = out / apart;
    return {foot.top - mask.heightAt(apart),
            foot.along - outwards * mask.slopeAt(apart),
            {foot.place, foot.top},
            outwards,
            foot.bottom - mask.upperAt(apart)};
}

/// Calls `take` for every post and then, of the posts that `mayCount`, for the foot on every chord.
template <class Take, class MayCount>
void VerticalWalls::eachFoot(glm::dvec2 pointMm, const Reach& reach, std::span<const Node> nodes, Take&& take,
                             MayCount&& mayCount) noexcept
{
    for (const Node& node : nodes)
        take({node.place, node.top, node.bottom, {0.0, 0.0}});
    for (std::size_t a = 0; a < nodes.size(); ++a) {
        if (!mayCount(nodes[a]))
            continue;
        for (std::size_t b = 0; b < nodes.size(); ++b)
            if (Foot foot{}; b != a && footBetween(pointMm, nodes[a], nodes[b], reach.chord, foot))
                take(foot);
    }
}

Touch VerticalWalls::touchAt(glm::dvec2 pointMm, const terrain::Tooth& tooth, const bur::BurMask& mask,
                             const Touch& below) const noexcept
{
    const Reach reach(tooth.grid(), mask);
    Nodes nodes;
    const std::size_t count = nodesNear(pointMm, tooth, reach, below.heightMm, nodes);
    double highest = below.heightMm;
    Foot best{};
    const auto take = [&](const Foot& foot) {
        const double apart = lengthOf(pointMm - foot.place);
        if (!(apart > 0.0) || apart > reach.radius)
            return;
        const double height = foot.top - mask.heightAt(apart);
        if (height > highest) {
            highest = height;
            best = foot;
        }
    };
    // The nearest point on a chord is at most half a chord from its nearer end.
    const double half = 0.5 * reach.chord;
    eachFoot(pointMm, reach, std::span(nodes).first(count), take, [&](const Node& end) {
        const double nearest = std::sqrt(std::max(0.0, end.apart * end.apart - half * half));
        return nearest <= reach.radius && end.top + kTopSlope * half - mask.heightAt(nearest) > highest;
    });
    return highest > below.heightMm ? touchOf(pointMm, mask, best) : below;
}

Touch VerticalWalls::besideAt(glm::dvec2 pointMm, double tipMm, const terrain::Tooth& tooth,
                              const bur::BurMask& mask) const noexcept
{
    const Reach reach(tooth.grid(), mask);
    Nodes nodes;
    const std::size_t count = nodesNear(pointMm, tooth, reach, tipMm + mask.steepMm, nodes);
    double least = reach.radius;
    Foot best{};
    bool isThere = false;
    const auto take = [&](const Foot& foot) {
        const double apart = lengthOf(pointMm - foot.place);
        // A cone touches a higher wall sooner.
        const double beside =
            mask.steepMm < mask.sideMm ? apart + reach.radius - mask.reachAt(foot.top - tipMm) : apart;
        if (!(apart > 0.0) || beside > least || foot.bottom - mask.upperAt(apart) >= tipMm)
            return;
        least = beside;
        best = foot;
        isThere = true;
    };
    const double half = 0.5 * reach.chord;
    eachFoot(pointMm, reach, std::span(nodes).first(count), take,
             [&](const Node& end) { return end.apart * end.apart - half * half <= least * least; });
    constexpr auto kNothing = static_cast<double>(terrain::kEmptyTop);
    return isThere ? touchOf(pointMm, mask, best) : Touch{kNothing, {0.0, 0.0}, {pointMm, kNothing}};
}

}  // namespace core::contact
