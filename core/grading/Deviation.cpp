// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grading/Deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/grading/AreaExcess.h"
#include "core/grading/Columns.h"
#include "core/grading/CutForm.h"
#include "core/grading/Outline.h"
#include "core/teeth/ToothBuilder.h"
#include "core/teeth/ToothTable.h"
#include "core/terrain/NodeRect.h"

namespace core::grading {
namespace {

using terrain::Grid;
using terrain::NodeRect;
using terrain::Tooth;
using terrain::ToothAnatomy;

constexpr double kPercentile = 0.95;

/// Heights at which columns ended before the cut, end now, and end in the ideal. top >= now, top >= ideal, and all are
/// at or above the under surface of the tooth.
struct Ends
{
    const ToothAnatomy& anatomy;
    std::vector<float> now;
    std::vector<float> ideal;

    Ends(const Tooth& tooth, const Preparation& preparation)
        : anatomy(*tooth.anatomy), now(anatomy.top), ideal(anatomy.top)
    {
        for (std::size_t k = 0; k < now.size(); ++k) {
            if (!wasSolid(anatomy, k))
                continue;
            now[k] = std::min(anatomy.top[k], endOf(tooth, k));
            ideal[k] = std::clamp((*preparation.top)[k], anatomy.bottom[k], anatomy.top[k]);
        }
    }
    [[nodiscard]] double top(std::size_t k) const { return static_cast<double>(anatomy.top[k]); }
    [[nodiscard]] double nowAt(std::size_t k) const { return static_cast<double>(now[k]); }
    [[nodiscard]] double idealAt(std::size_t k) const { return static_cast<double>(ideal[k]); }
    [[nodiscard]] double area(std::size_t k) const { return static_cast<double>(anatomy.areaMm2[k]); }
    [[nodiscard]] bool isTarget(std::size_t k) const { return ideal[k] < anatomy.top[k]; }
    /// Returns the removed length of a column between two heights.
    [[nodiscard]] double goneBetween(std::size_t k, double low, double high) const
    {
        return std::max(0.0, high - std::max(low, nowAt(k)));
    }
};

/// Returns whether column k has enamel on dentin.
bool hasJunction(const ToothAnatomy& anatomy, std::size_t k)
{
    return wasSolid(anatomy, k) && anatomy.layers[k].dej > anatomy.bottom[k] && anatomy.layers[k].dej < anatomy.top[k];
}

/// Returns the weighted percentile: the smallest value such that this share of the total weight has no greater value.
double percentile(std::vector<std::pair<double, double>>& valuesAndWeights, double share)
{
    std::sort(valuesAndWeights.begin(), valuesAndWeights.end());
    double all = 0.0;
    for (const auto& [value, weight] : valuesAndWeights)
        all += weight;
    double below = 0.0;
    for (const auto& [value, weight] : valuesAndWeights) {
        below += weight;
        if (below >= share * all)
            return value;
    }
    return valuesAndWeights.empty() ? 0.0 : valuesAndWeights.back().first;
}

/// Counts nodes of a kind in any rectangle in constant time, by sums over the rectangles that begin at the first node.
class Census
{
public:
    template <class Is>
    Census(const Grid& grid, const Is& is)
        : m_stride(static_cast<std::size_t>(grid.side) + 1), m_before(m_stride * m_stride, 0)
    {
        for (int j = 0; j < grid.side; ++j)
            for (int i = 0; i < grid.side; ++i)
                m_before[at(i + 1, j + 1)] = (is(grid.index(i, j)) ? 1 : 0) + m_before[at(i, j + 1)] +
                                             m_before[at(i + 1, j)] - m_before[at(i, j)];
    }
    /// Returns the count in a rectangle inside the grid.
    [[nodiscard]] int in(const NodeRect& rect) const
    {
        return m_before[at(rect.endI, rect.endJ)] - m_before[at(rect.beginI, rect.endJ)] -
               m_before[at(rect.endI, rect.beginJ)] + m_before[at(rect.beginI, rect.beginJ)];
    }

private:
    [[nodiscard]] std::size_t at(int i, int j) const
    {
        return static_cast<std::size_t>(j) * m_stride + static_cast<std::size_t>(i);
    }
    std::size_t m_stride;
    std::vector<int> m_before;
};

void measureVolumes(const Ends& ends, Deviation& result)
{
    double common = 0.0;
    double mostOver = 0.0;
    double mostUnder = 0.0;
    for (std::size_t k = 0; k < ends.now.size(); ++k) {
        if (!wasSolid(ends.anatomy, k))
            continue;
        const double area = ends.area(k);
        result.idealMm3 += (ends.top(k) - ends.idealAt(k)) * area;
        result.removedMm3 += (ends.top(k) - ends.nowAt(k)) * area;
        common += (ends.top(k) - std::max(ends.idealAt(k), ends.nowAt(k))) * area;
        const double over = ends.idealAt(k) - ends.nowAt(k);
        if (over > 0.0)
            (ends.isTarget(k) ? result.overcutBelowMm3 : result.overcutBesideMm3) += over * area;
        else
            result.undercutMm3 -= over * area;
        if (over > mostOver) {
            mostOver = over;
            result.overcutNode = k;
        }
        if (-over > mostUnder) {
            mostUnder = -over;
            result.undercutNode = k;
        }
    }
    if (result.idealMm3 + result.removedMm3 > 0.0) {
        result.dice = 2.0 * common / (result.idealMm3 + result.removedMm3);
        result.iou = common / (result.idealMm3 + result.removedMm3 - common);
    }
}

// ---------------------------------------------------------------------------------------------------------- floor

/// Returns the columns that represent a floor, in index order.
template <class IsFloor>
std::vector<std::size_t> floorOf(const Ends& ends, const IsFloor& isFloor)
{
    const Grid& grid = ends.anatomy.grid;
    const Census others(grid, [&](std::size_t k) { return !isFloor(k); });
    const int margin = static_cast<int>(std::ceil(kFloorMarginMm / grid.cellMm - 1.0e-6));
    std::vector<std::size_t> all;
    std::vector<std::size_t> inside;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            if (!isFloor(grid.index(i, j)))
                continue;
            all.push_back(grid.index(i, j));
            if (grid.contains(i - margin, j - margin) && grid.contains(i + margin, j + margin) &&
                others.in({i - margin, j - margin, i + margin + 1, j + margin + 1}) == 0)
                inside.push_back(grid.index(i, j));
        }
    }
    return inside.empty() ? all : inside;
}

std::optional<DepthError> depthErrorOf(const Ends& ends, const std::vector<std::size_t>& floor)
{
    DepthError error;
    double area = 0.0;
    std::vector<std::pair<double, double>> sizes;
    std::vector<std::pair<double, double>> depths;
    std::vector<std::pair<double, double>> heights;
    sizes.reserve(floor.size());
    depths.reserve(floor.size());
    heights.reserve(floor.size());
    error.tooDeepMm.node = error.tooShallowMm.node = floor.empty() ? 0 : floor.front();
    for (const std::size_t k : floor) {
        const double here = ends.nowAt(k) - ends.idealAt(k);
        area += ends.area(k);
        error.meanMm += std::abs(here) * ends.area(k);
        error.signedMm += here * ends.area(k);
        sizes.emplace_back(std::abs(here), ends.area(k));
        depths.emplace_back(std::max(0.0, -here), ends.area(k));
        heights.emplace_back(std::max(0.0, here), ends.area(k));
        if (-here > error.tooDeepMm.value)
            error.tooDeepMm = {-here, k};
        if (here > error.tooShallowMm.value)
            error.tooShallowMm = {here, k};
    }
    if (!(area > 0.0))
        return {};
    error.meanMm /= area;
    error.signedMm /= area;
    error.p95Mm = percentile(sizes, kPercentile);
    error.deepP95Mm = percentile(depths, kPercentile);
    error.shallowP95Mm = percentile(heights, kPercentile);
    return error;
}

/// Returns the error in height of the gingival floor of a box.
std::optional<Placed> gingivalErrorOf(const Ends& ends, const std::vector<Part>& parts, const Preparation::Box& box)
{
    constexpr double kSameLevelMm = 0.01;
    constexpr double kDeepestMm = 4.0;  // depth into the tooth
    const glm::dvec2 across(-box.outwards.y, box.outwards.x);
    const auto isInBox = [&](std::size_t k) {
        const glm::dvec2 way = ends.anatomy.grid.nodeMm(k) - box.atMm;
        return std::abs(glm::dot(way, across)) <= 0.5 * box.widthMm && glm::dot(way, box.outwards) >= -kDeepestMm;
    };
    const std::vector<std::size_t> floor = floorOf(ends, [&](std::size_t k) {
        return parts[k] == Part::Floor && wasSolid(ends.anatomy, k) && isInBox(k) &&
               std::abs(ends.idealAt(k) - box.floorMm) <= kSameLevelMm;
    });
    if (floor.empty())
        return {};
    std::vector<std::pair<double, double>> sizes;
    Placed worst{0.0, floor.front()};
    for (const std::size_t k : floor) {
        const double size = std::abs(ends.nowAt(k) - ends.idealAt(k));
        sizes.emplace_back(size, ends.area(k));
        if (size > worst.value)
            worst = {size, k};
    }
    return Placed{percentile(sizes, kPercentile), worst.node};
}

/// Returns the deepest gouge in the floor. It also works for a floor that is too narrow for the height error, because a
/// wall beside the floor does not lower it.
Placed gougeOf(const Ends& ends, const std::vector<Part>& parts)
{
    AreaExcess gouge;
    for (std::size_t k = 0; k < parts.size(); ++k)
        if (parts[k] == Part::Floor && wasSolid(ends.anatomy, k))
            gouge.add(ends.idealAt(k) - ends.nowAt(k), ends.area(k), k);
    return gouge.over(kLocalMm2);
}

/// Returns the columns of each separate piece of the ideal's floor, in index order.
std::vector<std::vector<std::size_t>> piecesOf(const Ends& ends, const std::vector<Part>& parts)
{
    const Grid& grid = ends.anatomy.grid;
    std::vector<bool> isOpen(grid.count(), false);
    for (std::size_t k = 0; k < parts.size(); ++k)
        isOpen[k] = parts[k] == Part::Floor && wasSolid(ends.anatomy, k);
    std::vector<std::vector<std::size_t>> pieces;
    for (std::size_t start = 0; start < isOpen.size(); ++start) {
        if (!isOpen[start])
            continue;
        std::vector<std::size_t> piece{start};
        isOpen[start] = false;
        for (std::size_t next = 0; next < piece.size(); ++next) {
            const int i = static_cast<int>(piece[next] % static_cast<std::size_t>(grid.side));
            const int j = static_cast<int>(piece[next] / static_cast<std::size_t>(grid.side));
            for (int nj = j - 1; nj <= j + 1; ++nj)
                for (int ni = i - 1; ni <= i + 1; ++ni)
                    if (grid.contains(ni, nj) && isOpen[grid.index(ni, nj)]) {
                        isOpen[grid.index(ni, nj)] = false;
                        piece.push_back(grid.index(ni, nj));
                    }
        }
        std::sort(piece.begin(), piece.end());
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// @param speaks  for each column, whether it is far enough from a wall; if no column of the piece is, all are used
PieceError pieceErrorOf(const Ends& ends, const std::vector<std::size_t>& piece, const std::vector<bool>& speaks)
{
    const bool anySpeaks = std::any_of(piece.begin(), piece.end(), [&](std::size_t k) { return speaks[k]; });
    PieceError error;
    error.node = piece[piece.size() / 2];
    double area = 0.0;
    for (const std::size_t k : piece) {
        if (anySpeaks && !speaks[k])
            continue;
        area += ends.area(k);
        error.meanMm += (ends.nowAt(k) - ends.idealAt(k)) * ends.area(k);
        error.depthMm += (ends.top(k) - ends.idealAt(k)) * ends.area(k);
    }
    if (area > 0.0) {
        error.meanMm /= area;
        error.depthMm /= area;
    }
    return error;
}

std::optional<PieceError> worstPieceOf(const Ends& ends, const std::vector<Part>& parts,
                                       const std::vector<std::size_t>& floor)
{
    const std::vector<std::vector<std::size_t>> pieces = piecesOf(ends, parts);
    if (pieces.size() < 2)
        return {};
    std::vector<bool> speaks(parts.size(), false);
    for (const std::size_t k : floor)
        speaks[k] = true;
    std::optional<PieceError> worst;
    for (const std::vector<std::size_t>& piece : pieces)
        if (const PieceError error = pieceErrorOf(ends, piece, speaks);
            !worst || std::abs(error.meanMm) > std::abs(worst->meanMm))
            worst = error;
    return worst;
}

/// @param box  if there is a pulpal floor, the gingival floor is left out, because it ends in enamel towards the
///             outside
std::optional<double> intoDentinOf(const Ends& ends, const std::vector<std::size_t>& floor,
                                   const std::optional<Preparation::Box>& box)
{
    constexpr double kStepToBoxMm = 0.3;
    const auto isPulpal = [&](std::size_t k) { return !box || ends.idealAt(k) > box->floorMm + kStepToBoxMm; };
    const bool hasPulpal = std::any_of(floor.begin(), floor.end(), isPulpal);
    double depth = 0.0;
    double area = 0.0;
    for (const std::size_t k : floor) {
        if (!hasJunction(ends.anatomy, k) || (hasPulpal && !isPulpal(k)))
            continue;
        depth += (static_cast<double>(ends.anatomy.layers[k].dej) - ends.nowAt(k)) * ends.area(k);
        area += ends.area(k);
    }
    return area > 0.0 ? std::optional(depth / area) : std::nullopt;
}

/// A plane through the error in height of a floor.
struct ErrorPlane
{
    glm::dvec2 middleMm{0.0};
    double meanMm = 0.0;  ///< at the middle
    glm::dvec2 slope{0.0};

    [[nodiscard]] double at(glm::dvec2 placeMm) const { return meanMm + glm::dot(slope, placeMm - middleMm); }
};

double errorAt(const Ends& ends, std::size_t k)
{
    return ends.nowAt(k) - ends.idealAt(k);
}

/// Returns the weighted plane of best fit; empty if all columns are on one line.
std::optional<ErrorPlane> planeThrough(const Ends& ends, const std::vector<std::size_t>& columns,
                                       const std::vector<double>& weights)
{
    const Grid& grid = ends.anatomy.grid;
    ErrorPlane plane;
    double all = 0.0;
    for (std::size_t n = 0; n < columns.size(); ++n) {
        all += weights[n];
        plane.middleMm += grid.nodeMm(columns[n]) * weights[n];
        plane.meanMm += errorAt(ends, columns[n]) * weights[n];
    }
    if (!(all > 0.0))
        return {};
    plane.middleMm /= all;
    plane.meanMm /= all;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    glm::dvec2 moment(0.0);
    for (std::size_t n = 0; n < columns.size(); ++n) {
        const glm::dvec2 way = grid.nodeMm(columns[n]) - plane.middleMm;
        xx += way.x * way.x * weights[n];
        xy += way.x * way.y * weights[n];
        yy += way.y * way.y * weights[n];
        moment += way * ((errorAt(ends, columns[n]) - plane.meanMm) * weights[n]);
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1.0e-9 * (xx + yy) * (xx + yy)))
        return {};
    plane.slope = glm::dvec2(yy * moment.x - xy * moment.y, xx * moment.y - xy * moment.x) / determinant;
    return plane;
}

/// Returns the slope of most of a floor along x or y: the median over pairs of its columns kSlopeRunMm apart, so that a
/// gouge, a step or waves have no effect. Returns 0 if there are few such pairs, as across a narrow floor.
double slopeOfMost(const Ends& ends, const std::vector<std::size_t>& floor, glm::ivec2 along)
{
    const Grid& grid = ends.anatomy.grid;
    std::vector<bool> isFloor(grid.count(), false);
    for (const std::size_t k : floor)
        isFloor[k] = true;
    const int run = std::max(1, static_cast<int>(std::lround(kSlopeRunMm / grid.cellMm)));
    std::vector<double> slopes;
    for (const std::size_t k : floor) {
        const int i = static_cast<int>(k % static_cast<std::size_t>(grid.side)) + run * along.x;
        const int j = static_cast<int>(k / static_cast<std::size_t>(grid.side)) + run * along.y;
        if (grid.contains(i, j) && isFloor[grid.index(i, j)])
            slopes.push_back((errorAt(ends, grid.index(i, j)) - errorAt(ends, k)) / (run * grid.cellMm));
    }
    if (slopes.empty() || slopes.size() < floor.size() / 8)
        return 0.0;
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
    std::nth_element(slopes.begin(), middle, slopes.end());
    return *middle;
}

std::optional<FloorForm> floorFormOf(const Ends& ends, const std::vector<std::size_t>& floor,
                                     const std::optional<Preparation::Box>& box)
{
    const Grid& grid = ends.anatomy.grid;
    // An uncut place has no floor yet.
    std::vector<std::size_t> cut;
    std::vector<double> areas;
    double area = 0.0;
    for (const std::size_t k : floor)
        if (ends.top(k) - ends.nowAt(k) > kOutlineDepthMm) {
            cut.push_back(k);
            areas.push_back(ends.area(k));
            area += ends.area(k);
        }
    const auto plane = planeThrough(ends, cut, areas);
    if (!plane)
        return {};

    FloorForm form;
    const glm::dvec2 slope(slopeOfMost(ends, cut, {1, 0}), slopeOfMost(ends, cut, {0, 1}));
    form.slopeDeg = atanDeg(std::sqrt(glm::dot(slope, slope)));
    form.stepMm.node = cut.front();
    std::vector<double> rest(grid.count(), std::numeric_limits<double>::quiet_NaN());
    double sum2 = 0.0;
    for (const std::size_t k : cut) {
        rest[k] = errorAt(ends, k) - plane->at(grid.nodeMm(k));
        sum2 += rest[k] * rest[k] * ends.area(k);
    }
    form.flatnessMm = std::sqrt(sum2 / area);
    form.intoDentinMm = intoDentinOf(ends, cut, box);
    const int run = std::max(1, static_cast<int>(std::lround(kStepRunMm / grid.cellMm)));
    for (const std::size_t k : cut) {
        const int i = static_cast<int>(k % static_cast<std::size_t>(grid.side));
        const int j = static_cast<int>(k / static_cast<std::size_t>(grid.side));
        for (const auto& [ni, nj] : {std::pair(i + run, j), std::pair(i, j + run)}) {
            if (!grid.contains(ni, nj))
                continue;
            // NaN where there is no floor; the comparison below is then false.
            const double step = std::abs(rest[grid.index(ni, nj)] - rest[k]);
            if (step > form.stepMm.value)
                form.stepMm = {step, k};
        }
    }
    return form;
}

// -------------------------------------------------------------------------------------------------------- outline

Placed roughnessOf(const Outline& cut, const Outline& ideal)
{
    constexpr double kFarMm = 0.3;       // a wall farther away is misplaced, not rough
    constexpr double kSameFacing = 0.5;  // cosine: the opposite wall, and one behind a corner, do not count
    const std::span<const Outline::Segment> segments = cut.segments();
    std::vector<double> off;
    off.reserve(segments.size());
    for (const Outline::Segment& segment : segments) {
        const glm::dvec2 middle = segment.middleMm();
        const double apart = std::min(kFarMm, ideal.distanceMm(middle));
        off.push_back(ideal.insideMm(middle) > 0.0 ? -apart : apart);
    }
    Placed rough{0.0, segments.front().node};
    double squares = 0.0;
    double length = 0.0;
    double most = 0.0;
    for (std::size_t s = 0; s < segments.size(); ++s) {
        double sum = 0.0;
        double weight = 0.0;
        cut.forEachWithin(segments[s].middleMm(), 0.5 * kRoughStretchMm, [&](const Outline::Segment& near) {
            if (glm::dot(near.outwards, segments[s].outwards) < kSameFacing)
                return;
            sum += off[static_cast<std::size_t>(&near - segments.data())] * near.lengthMm();
            weight += near.lengthMm();
        });
        const double rest = weight > 0.0 ? off[s] - sum / weight : 0.0;
        squares += rest * rest * segments[s].lengthMm();
        length += segments[s].lengthMm();
        if (std::abs(rest) > most) {
            most = std::abs(rest);
            rough.node = segments[s].node;
        }
    }
    rough.value = length > 0.0 ? std::sqrt(squares / length) : 0.0;
    return rough;
}

std::optional<OutlineDeviation> outlineDeviationOf(const Outline& cut, const Outline& ideal)
{
    if (cut.segments().empty() || ideal.segments().empty())
        return {};
    OutlineDeviation result;
    result.overMm.node = result.underMm.node = cut.segments().front().node;
    double length = 0.0;
    std::vector<std::pair<double, double>> sizes;
    sizes.reserve(cut.segments().size() + ideal.segments().size());
    const auto compare = [&](const Outline& one, const Outline& other, bool isOverOutside) {
        for (const Outline::Segment& segment : one.segments()) {
            const glm::dvec2 middle = segment.middleMm();
            const double apart = other.distanceMm(middle);
            const bool isOutside = !(other.insideMm(middle) > 0.0);
            const bool isOver = isOutside == isOverOutside;
            const double weight = segment.lengthMm();
            length += weight;
            result.meanMm += apart * weight;
            result.signedMm += (isOver ? apart : -apart) * weight;
            sizes.emplace_back(apart, weight);
            Placed& most = isOver ? result.overMm : result.underMm;
            if (apart > most.value)
                most = {apart, segment.node};
        }
    };
    compare(cut, ideal, true);
    compare(ideal, cut, false);
    if (!(length > 0.0))
        return {};
    result.meanMm /= length;
    result.signedMm /= length;
    result.p95Mm = percentile(sizes, kPercentile);
    result.roughnessMm = roughnessOf(cut, ideal);
    return result;
}

Placed beyondOf(const Ends& ends, const Outline& ideal)
{
    const Grid& grid = ends.anatomy.grid;
    AreaExcess beyond;
    if (ideal.segments().empty())
        return {};
    for (std::size_t k = 0; k < grid.count(); ++k)
        if (wasSolid(ends.anatomy, k) && ends.top(k) - ends.nowAt(k) >= kStrayDepthMm &&
            !(ideal.insideMm(grid.nodeMm(k)) > 0.0))
            beyond.add(ideal.distanceMm(grid.nodeMm(k)), ends.area(k), k);
    return beyond.over(kStrayMm2);
}

// ------------------------------------------------------------------------------------------------ unsupported enamel

constexpr double kSliceMm = 0.05;
constexpr double kCoarseSliceMm = 0.25;
constexpr double kLeastStepMm = 0.02;  ///< along a rod, where that is more than a quarter of a cell

/// Follows enamel rods down to the enamel-dentin junction. The foot of the rod through a place is the nearest node of
/// the junction: the path from the foot to the place is at right angles to the junction. The search goes downhill from
/// the foot of the place below.
class Rods
{
public:
    explicit Rods(const Tooth& tooth)
        : m_tooth(tooth), m_anatomy(*tooth.anatomy), m_grid(m_anatomy.grid),
          m_harm(m_grid, [&](std::size_t k) { return isCut(tooth, k) || decayIn(tooth, k).any(); })
    {}

    /// Returns the height of the unsupported enamel in column (i, j).
    [[nodiscard]] double unsupportedMm(int i, int j) const
    {
        const std::size_t k = m_grid.index(i, j);
        if (!m_tooth.isSolid(k) || !hasJunction(m_anatomy, k))
            return 0.0;
        const double junction = junctionAt({i, j});
        const auto top = static_cast<double>(m_tooth.top[k]);
        if (const Decay decay = decayIn(m_tooth, k); decay.any())
            return std::max(0.0, top - std::max(junction, static_cast<double>(decay.roof)));
        if (!(top > junction) || !mayComeToHarm({i, j}, junction, top))
            return 0.0;
        const int slices = static_cast<int>((top - junction) / kSliceMm) + 1;
        const double sliceMm = (top - junction) / slices;
        glm::ivec2 foot(i, j);
        double height = 0.0;
        for (int slice = 0; slice < slices; ++slice) {
            const double z = junction + sliceMm * (slice + 0.5);
            foot = nearestFoot(foot, {i, j}, z);
            if (!stands({i, j}, z, foot))
                height += sliceMm;
        }
        return height;
    }

private:
    [[nodiscard]] double junctionAt(glm::ivec2 node) const
    {
        return static_cast<double>(m_anatomy.layers[m_grid.index(node.x, node.y)].dej);
    }

    /// Returns whether a cut or decay is between a column and the feet of its rods.
    [[nodiscard]] bool mayComeToHarm(glm::ivec2 column, double junction, double top) const
    {
        NodeRect feet{column.x, column.y, column.x + 1, column.y + 1};
        glm::ivec2 foot = column;
        for (double z = junction; z < top;) {
            z = std::min(top, z + kCoarseSliceMm);
            foot = nearestFoot(foot, column, z);
            feet = terrain::united(feet, {foot.x, foot.y, foot.x + 1, foot.y + 1});
        }
        return m_harm.in(terrain::grown(feet, 1, m_grid)) > 0;
    }

    [[nodiscard]] glm::ivec2 nearestFoot(glm::ivec2 from, glm::ivec2 column, double z) const
    {
        const auto apart2 = [&](glm::ivec2 foot) {
            const glm::dvec2 aside = glm::dvec2(foot - column) * m_grid.cellMm;
            const double below = z - junctionAt(foot);
            return glm::dot(aside, aside) + below * below;
        };
        double best = apart2(from);
        for (bool moved = true; moved;) {
            moved = false;
            for (const glm::ivec2 way : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
                const glm::ivec2 next = from + way;
                if (!m_grid.contains(next.x, next.y) || !hasJunction(m_anatomy, m_grid.index(next.x, next.y)))
                    continue;
                if (const double there = apart2(next); there < best) {
                    best = there;
                    from = next;
                    moved = true;
                }
            }
        }
        return from;
    }

    /// Returns whether the rod through a place is complete down to its foot and ends on dentin.
    [[nodiscard]] bool stands(glm::ivec2 column, double z, glm::ivec2 foot) const
    {
        const glm::dvec2 way(foot - column);
        const double stepCells = std::max(0.25, kLeastStepMm / m_grid.cellMm);
        const int steps = static_cast<int>(std::max(std::abs(way.x), std::abs(way.y)) / stepCells) + 1;
        for (int step = 1; step <= steps; ++step) {
            const double share = static_cast<double>(step) / steps;
            const glm::ivec2 node(glm::dvec2(column) + way * share + 0.5);
            const std::size_t k = m_grid.index(node.x, node.y);
            // Above the uncut surface, as in a fissure, there was no material to cut.
            const double height = z + (junctionAt(foot) - z) * share;
            if (wasSolid(m_anatomy, k) && static_cast<double>(endOf(m_tooth, k)) < height &&
                height <= static_cast<double>(m_anatomy.top[k]))
                return false;
        }
        return !isDecayUnder(m_grid.index(foot.x, foot.y));
    }

    /// Returns whether decay remains at the junction of a column.
    [[nodiscard]] bool isDecayUnder(std::size_t k) const
    {
        const Decay decay = decayIn(m_tooth, k);
        const float junction = m_anatomy.layers[k].dej;
        return decay.any() && decay.floor < junction && decay.roof >= junction;
    }

    const Tooth& m_tooth;
    const ToothAnatomy& m_anatomy;
    const Grid& m_grid;
    Census m_harm;
};

std::optional<Placed> unsupportedEnamelOf(const Tooth& tooth)
{
    const Grid& grid = tooth.grid();
    const Rods rods(tooth);
    Placed result;
    bool any = false;
    double most = 0.0;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            any = any || hasJunction(*tooth.anatomy, k);
            const double height = rods.unsupportedMm(i, j);
            result.value += height * static_cast<double>(tooth.anatomy->areaMm2[k]);
            if (height > most) {
                most = height;
                result.node = k;
            }
        }
    }
    return any ? std::optional(result) : std::nullopt;
}

// ---------------------------------------------------------------------------------------------------------- zones

/// The target column that is nearest to a column beside the target, and the distance between them.
struct Nearest
{
    int cells2 = std::numeric_limits<int>::max();
    std::size_t target = 0;
};

std::vector<Nearest> nearestTargets(const Ends& ends, double withinMm)
{
    const Grid& grid = ends.anatomy.grid;
    const auto isTarget = [&](int i, int j) { return grid.contains(i, j) && ends.isTarget(grid.index(i, j)); };
    std::vector<Nearest> nearest(grid.count());
    const int reach = static_cast<int>(std::min(withinMm / grid.cellMm, 1.0 * grid.side)) + 2;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const bool isEdge = !(isTarget(i - 1, j) && isTarget(i + 1, j) && isTarget(i, j - 1) && isTarget(i, j + 1));
            if (!isTarget(i, j) || !isEdge)
                continue;
            for (int nj = std::max(0, j - reach); nj <= std::min(grid.side - 1, j + reach); ++nj) {
                for (int ni = std::max(0, i - reach); ni <= std::min(grid.side - 1, i + reach); ++ni) {
                    const int cells2 = (ni - i) * (ni - i) + (nj - j) * (nj - j);
                    if (Nearest& known = nearest[grid.index(ni, nj)]; cells2 < known.cells2)
                        known = {cells2, grid.index(i, j)};
                }
            }
        }
    }
    return nearest;
}

Zones zonesOf(const Ends& ends, const Outline& ideal, const Leeway& leeway)
{
    const Grid& grid = ends.anatomy.grid;
    const std::vector<Nearest> nearest = nearestTargets(ends, leeway.sidesMm);
    Zones zones;
    double mostLeft = 0.0;
    double deepestBottom = 0.0;
    double deepestSide = 0.0;
    const auto touched = [](Placed& container, double& deepest, std::size_t k, double lengthMm, double areaMm2) {
        container.value += lengthMm * areaMm2;
        if (lengthMm * areaMm2 > 0.0 && lengthMm > deepest) {
            deepest = lengthMm;
            container.node = k;
        }
    };
    for (std::size_t k = 0; k < ends.now.size(); ++k) {
        if (!wasSolid(ends.anatomy, k))
            continue;
        const double area = ends.area(k);
        const auto under = static_cast<double>(ends.anatomy.bottom[k]);
        if (ends.isTarget(k)) {
            const double floor = std::max(under, ends.idealAt(k) - leeway.bottomMm);
            const double gone = ends.goneBetween(k, ends.idealAt(k), ends.top(k));
            const double left = ends.top(k) - ends.idealAt(k) - gone;
            zones.targetMm3 += (ends.top(k) - ends.idealAt(k)) * area;
            zones.targetRemovedMm3 += gone * area;
            zones.leewayBottomMm3 += (ends.idealAt(k) - floor) * area;
            zones.leewayBottomRemovedMm3 += ends.goneBetween(k, floor, ends.idealAt(k)) * area;
            touched(zones.containerBottomMm3, deepestBottom, k, ends.goneBetween(k, under, floor), area);
            if (left > mostLeft) {
                mostLeft = left;
                zones.targetLeftNode = k;
            }
            continue;
        }
        double share = 0.0;  // share of the column's cell that is leeway
        double floor = under;
        if (nearest[k].cells2 < std::numeric_limits<int>::max()) {
            // A target that is too shallow for an outline is known only to half a cell.
            const double apartMm = ideal.segments().empty()
                                       ? grid.cellMm * (std::sqrt(static_cast<double>(nearest[k].cells2)) - 0.5)
                                       : ideal.distanceMm(grid.nodeMm(k));
            share = std::clamp((leeway.sidesMm - apartMm) / grid.cellMm + 0.5, 0.0, 1.0);
            floor = std::clamp(ends.idealAt(nearest[k].target) - leeway.bottomMm, under, ends.top(k));
        }
        zones.leewaySidesMm3 += share * (ends.top(k) - floor) * area;
        zones.leewaySidesRemovedMm3 += share * ends.goneBetween(k, floor, ends.top(k)) * area;
        touched(zones.containerBottomMm3, deepestBottom, k, ends.goneBetween(k, under, floor), share * area);
        touched(zones.containerSidesMm3, deepestSide, k, ends.goneBetween(k, under, ends.top(k)), (1.0 - share) * area);
    }
    return zones;
}

// ---------------------------------------------------------------------------------------------------------- input

Status check(const Tooth& tooth, const Preparation& ideal, const std::optional<Leeway>& leeway)
{
    const std::size_t count = tooth.grid().count();
    if (!ideal.top || ideal.top->size() != count || ideal.parts.size() != count)
        return unexpected(ErrorCode::BadStructure, "The ideal preparation is not for this tooth's grid of " +
                                                       std::to_string(tooth.grid().side) + " x " +
                                                       std::to_string(tooth.grid().side) + " columns.");
    for (std::size_t k = 0; k < count; ++k) {
        if (std::isnan((*ideal.top)[k]))
            return unexpected(ErrorCode::BadNumber,
                              "The ideal preparation's height of column " + std::to_string(k) + " is not a number.");
        if (std::isnan(tooth.top[k]) || std::isnan(tooth.bottom[k]))
            return unexpected(ErrorCode::BadNumber,
                              "The tooth's height of column " + std::to_string(k) + " is not a number.");
    }
    if (ideal.isthmus) {
        const Preparation::Isthmus& isthmus = *ideal.isthmus;
        const double across2 = glm::dot(isthmus.across, isthmus.across);
        // The conditions are not written with < and >, so that they also refuse NaN.
        const bool isSound = std::isfinite(isthmus.atMm.x) && std::isfinite(isthmus.atMm.y) &&
                             std::abs(across2 - 1.0) <= 1.0e-6 && isthmus.lengthMm >= 0.0 && isthmus.lengthMm <= 100.0;
        if (!isSound)
            return unexpected(ErrorCode::OutOfRange,
                              "The ideal preparation's isthmus needs a place, a unit vector across it and a length "
                              "from 0 to 100 mm.");
    }
    if (leeway &&
        !(leeway->sidesMm >= 0.0 && leeway->bottomMm >= 0.0 && leeway->sidesMm <= 100.0 && leeway->bottomMm <= 100.0))
        return unexpected(ErrorCode::OutOfRange, "A leeway lies between 0 and 100 mm.");
    return {};
}

}  // namespace

Result<Deviation> measureDeviation(const Tooth& tooth, const Preparation& ideal, const std::optional<Leeway>& leeway)
{
    if (const Status sound = check(tooth, ideal, leeway); !sound)
        return tl::unexpected(sound.error());
    const ToothAnatomy& anatomy = *tooth.anatomy;
    const Ends ends(tooth, ideal);
    Deviation result;
    measureVolumes(ends, result);

    const std::vector<std::size_t> floor =
        floorOf(ends, [&](std::size_t k) { return ideal.parts[k] == Part::Floor && wasSolid(anatomy, k); });
    result.depth = depthErrorOf(ends, floor);
    if (result.depth) {
        result.depth->gougeMm = gougeOf(ends, ideal.parts);
        result.depth->worstPiece = worstPieceOf(ends, ideal.parts, floor);
    }
    result.floor = floorFormOf(ends, floor, ideal.box);
    if (ideal.box)
        result.gingivalFloorErrorMm = gingivalErrorOf(ends, ideal.parts, *ideal.box);

    const Outline cutOutline(anatomy, ends.now);
    const Outline idealOutline(anatomy, ends.ideal);
    result.outline = outlineDeviationOf(cutOutline, idealOutline);
    result.beyondMm = beyondOf(ends, idealOutline);

    const bool knowsSides = teeth::standsInTheArch(anatomy) && teeth::findToothSizes(anatomy.fdi).has_value();
    if (knowsSides)
        result.buccalSign = teeth::buccalSign(anatomy.fdi) > 0.0 ? 1 : -1;
    const auto measureForm = [&](const std::vector<float>& end, const Outline& outline, Form& form) {
        const CutSurface surface{anatomy, end, outline};
        if (ideal.isthmus)
            form.isthmusMm = isthmusOf(surface, *ideal.isthmus, idealOutline);
        if (ideal.box)
            form.axialDepthMm = axialDepthOf(surface, *ideal.box);
        form.obliqueRidgeMm = obliqueRidgeOf(surface, ideal.obliqueCrest);
        if (knowsSides) {
            form.ridgeMesialMm = ridgeOf(surface, -1);
            form.ridgeDistalMm = ridgeOf(surface, 1);
        }
        measureWalls(surface, form);
    };
    measureForm(ends.now, cutOutline, result.form);
    measureForm(ends.ideal, idealOutline, result.idealForm);

    result.unsupportedEnamelMm3 = unsupportedEnamelOf(tooth);
    if (leeway)
        result.zones = zonesOf(ends, idealOutline, *leeway);
    return result;
}

}  // namespace core::grading
