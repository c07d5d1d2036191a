// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/LiveTooth.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/bur/Reach.h"
#include "core/contact/BurHead.h"
#include "core/contact/Lengths.h"

namespace core::contact {
namespace {

constexpr double kRimRoundingMm = 1.0e-9;
constexpr double kFloatMm = 1.0e-6;  ///< heights are floats
/// In cells. If the ground is not steep, columns under a bur are at most this much lower than the ground between them.
constexpr float kSpikeShare = 0.35F;

/// A sharper bend of the ground is an edge.
constexpr double kSharpestPerMm = 2.0;
constexpr int kFootRounds = 12;
/// The second-order ground of a node extends a little into the cells of its neighbours. Otherwise a foot on the border
/// would belong to neither node.
constexpr double kOwnCells = 0.6;
/// Below this value, ground and bur have nearly the same curvature, and the point of contact is undetermined.
constexpr double kLeastDeterminant = 0.05;
constexpr double kFootMm = 3.0e-4;  ///< if a foot moves by less, it is found: the height there is a maximum

const Peak& highestOf(const Peaks& peaks)
{
    return *std::max_element(peaks.begin(), peaks.end(),
                             [](const Peak& a, const Peak& b) { return a.value < b.value; });
}

/// Returns where ground with `slope` supports a bur whose axis is at p.
glm::dvec2 footOn(const bur::BurMask& mask, glm::dvec2 p, glm::dvec2 slope)
{
    const double steep = std::sqrt(slope.x * slope.x + slope.y * slope.y);
    return steep > 0.0 ? p + slope * (mask.standsAt(steep) / steep) : p;
}

/// Returns the next estimate of the foot, from a position on ground with `slope` and `bend`. It is Newton's step
/// towards the ground that has the slope of the bur. If that step does not lead to a maximum, it is the position where
/// ground with this slope would support the bur.
glm::dvec2 stepToFoot(const bur::BurMask& mask, glm::dvec2 p, glm::dvec2 at, glm::dvec2 slope, glm::dvec2 bend,
                      double twist)
{
    const glm::dvec2 error = footOn(mask, p, slope) - at;
    const double steep2 = slope.x * slope.x + slope.y * slope.y;
    if (!(steep2 > 0.0))
        return error;
    // The foot is p + slope * share. The derivative of the foot by the slope is multiplied by that of the slope by
    // position.
    const double steep = std::sqrt(steep2);
    const double root = std::sqrt(1.0 + steep2);
    // The upper edge of a cone touches the ground like the rim of a disc.
    const bool onEdge = mask.standsOnEdge(steep);
    const double flat = onEdge ? static_cast<double>(mask.radiusMm) : mask.flatMm;
    const double corner = onEdge ? 0.0 : mask.cornerMm;
    const double share = flat / steep + corner / root;
    const double along = (corner / (root * root * root) - share) / steep2;
    const double xx = share + along * slope.x * slope.x;
    const double xy = along * slope.x * slope.y;
    const double yy = share + along * slope.y * slope.y;
    const double a = 1.0 - (xx * bend.x + xy * twist);
    const double b = -(xx * twist + xy * bend.y);
    const double c = -(xy * bend.x + yy * twist);
    const double d = 1.0 - (xy * twist + yy * bend.y);
    const double determinant = a * d - b * c;
    if (!(determinant > kLeastDeterminant) || !(a + d > 0.0))
        return error;
    return glm::dvec2(d * error.x - b * error.y, a * error.y - c * error.x) / determinant;
}

/// Returns the whole number nearest to a place on the lattice, or a negative one before its edge.
int nearestTo(double place)
{
    return static_cast<int>(place + 1.5) - 1;
}

}  // namespace

LiveTooth::LiveTooth(terrain::Tooth tooth)
    : m_tooth(std::move(tooth)), m_sides(*m_tooth.anatomy), m_floorMm(bur::lowestTipMm(*m_tooth.anatomy)),
      m_kernels(contact::kernels())
{
    assert(m_tooth.top.size() == grid().count() && m_tooth.bottom.size() == grid().count());
    assert(m_tooth.anatomy->layers.size() == grid().count());
    for (const bur::Bur& bur : bur::burs())
        m_masks.emplace_back(bur, grid().cellMm);
    std::size_t widest = 0;
    for (const bur::BurMask& mask : m_masks)
        widest = std::max(widest, 2 * static_cast<std::size_t>(mask.span) + 3);
    widest += 2;  // and the columns that motion within a cell adds
    m_columnsRoom.resize(widest * (widest / kBlock + 1));
    m_blocks.side = blocksFor(grid().side);
    const std::size_t blocks = static_cast<std::size_t>(m_blocks.side) * static_cast<std::size_t>(m_blocks.side);
    m_blocks.tops.assign(blocks + kBlock, terrain::kEmptyTop);
    m_blocks.bottoms.assign(blocks + kBlock, terrain::kEmptyBottom);
    refreshBlocks(0, 0, grid().side - 1, grid().side - 1);
    m_dej.reserve(grid().count());
    m_sound.reserve(grid().count());
    for (const terrain::ColumnLayers& column : m_tooth.anatomy->layers) {
        m_dej.push_back(column.dej);
        const float lesion = column.cariesRoof > column.cariesFloor ? column.cariesRoof : terrain::kEmptyTop;
        const float pulp = column.pulpRoof > column.pulpFloor ? column.pulpRoof : terrain::kEmptyTop;
        m_sound.push_back(std::max(lesion, pulp));
    }
    m_bends.assign(grid().count(), 0);
    for (int j = 1; j < grid().side - 1; ++j)
        for (int i = 1; i < grid().side - 1; ++i)
            m_bends[grid().index(i, j)] = bends(*m_tooth.anatomy, i, j) ? 1 : 0;
    for (int j = 0; j < grid().side; ++j)
        for (int i = 0; i < grid().side; ++i)
            if (!isWhole(grid().index(i, j)))
                noteCut(i, j);
}

bool LiveTooth::isWhole(std::size_t k) const noexcept
{
    return m_tooth.isSolid(k) && m_tooth.top[k] >= m_tooth.anatomy->top[k];
}

/// Returns whether the uncut ground around a node inside the map is curved without an edge.
bool LiveTooth::bends(const terrain::ToothAnatomy& anatomy, int i, int j) noexcept
{
    const terrain::Grid& grid = anatomy.grid;
    for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
            const std::size_t k = grid.index(i + di, j + dj);
            if (!(anatomy.top[k] > anatomy.bottom[k]))
                return false;
        }
    }
    const auto rise = [&](int di, int dj) {
        return std::abs(static_cast<double>(anatomy.top[grid.index(i + di, j + dj)]) -
                        static_cast<double>(anatomy.top[grid.index(i, j)])) /
               grid.cellMm;
    };
    // At an edge there are two slopes. The gentler one is the slope of the ground.
    const double steepX = std::min(rise(1, 0), rise(-1, 0));
    const double steepY = std::min(rise(0, 1), rise(0, -1));
    const double steep2 = 1.0 + steepX * steepX + steepY * steepY;
    const Bowl bowl = bowlAt(grid, anatomy.top, i, j);
    return std::max({std::abs(bowl.bend.x), std::abs(bowl.bend.y), std::abs(bowl.twist)}) < kSharpestPerMm * steep2;
}

/// Marks a node as cut: the ground around it is now given by its columns.
void LiveTooth::noteCut(int i, int j) noexcept
{
    for (int atJ = std::max(0, j - 1); atJ <= std::min(grid().side - 1, j + 1); ++atJ)
        for (int atI = std::max(0, i - 1); atI <= std::min(grid().side - 1, i + 1); ++atI)
            m_bends[grid().index(atI, atJ)] = 0;
}

LiveTooth::Bowl LiveTooth::bowlAt(const terrain::Grid& grid, const std::vector<float>& top, int i, int j) noexcept
{
    const auto row = [&](int dj) {
        const float* from = top.data() + grid.index(i - 1, j + dj);
        return std::array<double, 3>{static_cast<double>(from[0]), static_cast<double>(from[1]),
                                     static_cast<double>(from[2])};
    };
    const auto low = row(-1);
    const auto mid = row(0);
    const auto high = row(1);
    const double cell = grid.cellMm;
    return {{grid.nodeMm(i, j), mid[1]},
            {(mid[2] - mid[0]) / (2.0 * cell), (high[1] - low[1]) / (2.0 * cell)},
            {(mid[0] - 2.0 * mid[1] + mid[2]) / (cell * cell), (low[1] - 2.0 * mid[1] + high[1]) / (cell * cell)},
            (low[0] - low[2] - high[0] + high[2]) / (4.0 * cell * cell)};
}

Touch LiveTooth::touchAt(glm::dvec2 pointMm, double enough, Edges edges) noexcept
{
    const Touch touch = touchColumnsAt(pointMm, enough);
    if (edges == Edges::Columns || touch.heightMm > enough)
        return touch;
    return m_sides.touchAt(pointMm, m_tooth, mask(), touch);
}

bool LiveTooth::isAbove(glm::dvec2 pointMm, double z, Edges edges) noexcept
{
    // The column that was the highest a tick ago usually decides.
    if (const Peak last = lastPeakAt(grid().latticeOf(pointMm)); last.i >= 0 && static_cast<double>(last.value) > z)
        return true;
    return touchAt(pointMm, z, edges).heightMm > z;
}

Peak LiveTooth::lastPeakAt(glm::dvec2 lattice) const noexcept
{
    if (m_peak.i < 0)
        return {};
    const BurHead head = headAt(mask(), grid().cellMm, lattice.x, lattice.y);
    const float top = m_tooth.top[grid().index(m_peak.i, m_peak.j)];
    return {valueOver<Side::Above>(top, m_peak.i, dy2Of(m_peak.j, head), head), m_peak.i, m_peak.j};
}

Touch LiveTooth::touchColumnsAt(glm::dvec2 pointMm, double enough) noexcept
{
    const glm::dvec2 lattice = grid().latticeOf(pointMm);
    const float spread = kSpikeShare * static_cast<float>(grid().cellMm);
    Search wanted{-bur::BurMask::kAbsent, spread, static_cast<float>(enough)};
    if (const Peak last = lastPeakAt(lattice); last.i >= 0) {
        wanted.atLeast = last.value;
        if (last.value > wanted.enough)  // the bur has moved by a fraction of a cell: usually it is still the highest
            return {static_cast<double>(last.value), {0.0, 0.0}, {pointMm, static_cast<double>(last.value)}};
    }
    const Peaks peaks = m_kernels.highestAtPoint(tops(), mask(), grid().cellMm, lattice.x, lattice.y, wanted);
    if (const Peak& highest = highestOf(peaks); highest.i >= 0)
        m_peak = highest;
    Touch best{static_cast<double>(terrain::kEmptyTop), {0.0, 0.0}, {pointMm, static_cast<double>(terrain::kEmptyTop)}};
    // A slightly lower column may belong to higher ground.
    const float least = highestOf(peaks).value - spread;
    // Peaks on one smooth spot, one in each quarter, lead to the same foot.
    glm::ivec2 spot{};
    bool isSmooth = false;
    for (const Peak& peak : peaks) {
        if (peak.i < 0 || peak.value < least)
            continue;
        if (isSmooth && std::max(std::abs(peak.i - spot.x), std::abs(peak.j - spot.y)) <= 1)
            continue;
        Touch touch{};
        glm::ivec2 node{};
        if (touchOnBowl(peak, pointMm, touch, node)) {
            spot = node;
            isSmooth = true;
        } else {
            touch = touchOnFacets(peak, pointMm);
        }
        if (touch.heightMm > best.heightMm)
            best = touch;
    }
    return best;
}

double LiveTooth::riseBeyond(int i, int j, glm::dvec2 outwards) const noexcept
{
    const double longest = std::max(std::abs(outwards.x), std::abs(outwards.y));
    if (!(longest > 0.0))
        return 0.0;
    const int di = static_cast<int>(std::floor(outwards.x / longest + 0.5));
    const int dj = static_cast<int>(std::floor(outwards.y / longest + 0.5));
    if (!grid().contains(i + di, j + dj))
        return 0.0;
    const double up = static_cast<double>(m_tooth.top[grid().index(i + di, j + dj)]) -
                      static_cast<double>(m_tooth.top[grid().index(i, j)]);
    return up / (grid().cellMm * std::sqrt(static_cast<double>(di * di + dj * dj)));
}

Touch LiveTooth::touchOnFacets(const Peak& peak, glm::dvec2 pointMm) const noexcept
{
    const std::size_t at = grid().index(peak.i, peak.j);
    const glm::dvec2 node = grid().nodeMm(peak.i, peak.j);
    const auto top = static_cast<double>(m_tooth.top[at]);
    const auto slopeTowards = [&](glm::dvec2 foot) {
        const glm::dvec2 out = foot - pointMm;
        const double r = lengthOf(out);
        return r > 0.0 ? out * (mask().slopeAt(r) / r) : glm::dvec2(0.0);
    };
    Touch best{static_cast<double>(peak.value), slopeTowards(node), {node, top}};
    if (!isWhole(at)) {
        best.rise = riseBeyond(peak.i, peak.j, node - pointMm);
        if (best.rise > lengthOf(best.slope))
            best.slope = (node - pointMm) * (best.rise / lengthOf(node - pointMm));
        return best;
    }
    const double cell = grid().cellMm;
    for (const int dj : {-1, 1}) {
        for (const int di : {-1, 1}) {
            if (!grid().contains(peak.i + di, peak.j + dj))
                continue;
            const std::size_t besideX = grid().index(peak.i + di, peak.j);
            const std::size_t besideY = grid().index(peak.i, peak.j + dj);
            if (!isWhole(besideX) || !isWhole(besideY))
                continue;
            const glm::dvec2 slope((static_cast<double>(m_tooth.top[besideX]) - top) / (di * cell),
                                   (static_cast<double>(m_tooth.top[besideY]) - top) / (dj * cell));
            const glm::dvec2 wanted = footOn(mask(), pointMm, slope);
            const glm::dvec2 next = node + glm::dvec2(di, dj) * cell;
            const glm::dvec2 foot = glm::clamp(wanted, glm::min(node, next), glm::max(node, next));
            const double ground = top + slope.x * (foot.x - node.x) + slope.y * (foot.y - node.y);
            const double r = lengthOf(foot - pointMm);
            if (r > static_cast<double>(mask().radiusMm) + kRimRoundingMm)
                continue;
            const double height = ground - mask().heightAt(r);
            if (height > best.heightMm)
                best = {height, foot == wanted ? slope : slopeTowards(foot), {foot, ground}};
        }
    }
    return best;
}

/// Finds the foot, where bur and ground have the same slope. Starts from the highest column, then again from the node
/// nearest to the result, because on steep ground the highest column may be some cells away.
bool LiveTooth::touchOnBowl(const Peak& peak, glm::dvec2 pointMm, Touch& touch, glm::ivec2& node) const noexcept
{
    int i = peak.i;
    int j = peak.j;
    if (m_bends[grid().index(i, j)] == 0)
        return false;
    Bowl bowl = bowlAt(grid(), m_tooth.top, i, j);
    glm::dvec2 slope = bowl.slope;
    glm::dvec2 foot(bowl.nodeMm);
    for (int round = 0; round < kFootRounds; ++round) {
        const glm::dvec2 moved = stepToFoot(mask(), pointMm, foot, slope, bowl.bend, bowl.twist);
        foot += moved;
        const glm::dvec2 lattice = grid().latticeOf(foot);
        const bool isElsewhere = std::abs(lattice.x - i) > kOwnCells || std::abs(lattice.y - j) > kOwnCells;
        if (isElsewhere) {
            const int nearI = nearestTo(lattice.x);
            const int nearJ = nearestTo(lattice.y);
            if (!grid().contains(nearI, nearJ) || m_bends[grid().index(nearI, nearJ)] == 0)
                return false;
            i = nearI;
            j = nearJ;
            bowl = bowlAt(grid(), m_tooth.top, i, j);
        }
        const glm::dvec2 out = foot - glm::dvec2(bowl.nodeMm);
        slope = bowl.slope + bowl.bend * out + glm::dvec2(out.y, out.x) * bowl.twist;
        const bool isPlane = bowl.twist == 0.0 && bowl.bend.x == 0.0 && bowl.bend.y == 0.0;
        if (isElsewhere || (!isPlane && glm::dot(moved, moved) > kFootMm * kFootMm))
            continue;
        const double ground = bowl.nodeMm.z + glm::dot(bowl.slope, out) + 0.5 * glm::dot(bowl.bend, out * out) +
                              bowl.twist * out.x * out.y;
        const double r = std::min(lengthOf(foot - pointMm), static_cast<double>(mask().radiusMm));
        touch = {ground - mask().heightAt(r), slope, {foot, ground}};
        node = {i, j};
        return touch.heightMm >= static_cast<double>(peak.value) - kFloatMm;
    }
    return false;
}

double LiveTooth::undersideAt(glm::dvec2 pointMm, double enough) noexcept
{
    const glm::dvec2 lattice = grid().latticeOf(pointMm);
    Search wanted{-bur::BurMask::kAbsent, 0.0F, static_cast<float>(-enough)};
    const BurHead head = headAt(mask(), grid().cellMm, lattice.x, lattice.y);
    // The lowest column of the last tick usually still is the lowest. A column that stops the bur from above usually
    // also extends down beside it.
    for (const Peak& last : {m_lowest, m_peak}) {
        if (last.i < 0)
            continue;
        const float bottom = m_tooth.bottom[grid().index(last.i, last.j)];
        const float value = valueOver<Side::Beneath>(bottom, last.i, dy2Of(last.j, head), head);
        if (value > wanted.enough)
            return -static_cast<double>(value);
        wanted.atLeast = std::max(wanted.atLeast, value);
    }
    const Peaks peaks = m_kernels.lowestAtPoint(bottoms(), mask(), grid().cellMm, lattice.x, lattice.y, wanted);
    const Peak& lowest = highestOf(peaks);
    if (lowest.i >= 0)
        m_lowest = lowest;
    return -static_cast<double>(lowest.value);
}

Room LiveTooth::roomAt(glm::dvec2 pointMm, double z, const Room& enough) const noexcept
{
    const glm::dvec2 lattice = grid().latticeOf(pointMm);
    return m_kernels.roomAt(tops(), bottoms(), headAt(mask(), grid().cellMm, lattice.x, lattice.y),
                            static_cast<float>(z), enough);
}

void LiveTooth::lower(int i, int j, float heightMm) noexcept
{
    const std::size_t index = grid().index(i, j);
    ++m_revision;
    if (isWhole(index))
        noteCut(i, j);
    if (heightMm > m_tooth.bottom[index]) {
        m_tooth.top[index] = heightMm;
        return;
    }
    m_tooth.top[index] = terrain::kEmptyTop;
    m_tooth.bottom[index] = terrain::kEmptyBottom;
}

bool LiveTooth::bendsAround(int i, int j) const noexcept
{
    const int left = std::max(i - 1, 0);
    const int right = std::min(i + 1, grid().side - kBlock);
    std::uint64_t any = 0;
    for (int atJ = std::max(0, j - 1); atJ <= std::min(grid().side - 1, j + 1); ++atJ) {
        for (const int atI : {left, right}) {
            std::uint64_t eight = 0;
            static_assert(sizeof eight == kBlock);
            std::memcpy(&eight, m_bends.data() + grid().index(atI, atJ), sizeof eight);
            any |= eight;
        }
    }
    return any != 0;
}

void LiveTooth::take(const Columns& columns) noexcept
{
    if (columns.lowered == 0)
        return;
    ++m_revision;
    if (columns.emptied != 0 || bendsAround(columns.i, columns.j)) {
        for (int n = 0; n < kBlock; ++n)
            if ((columns.lowered >> n & 1) != 0)
                lower(columns.i + n, columns.j, columns.top[static_cast<std::size_t>(n)]);
        return;
    }
    std::copy(columns.top.begin(), columns.top.end(), m_tooth.top.data() + grid().index(columns.i, columns.j));
}

void LiveTooth::refreshBlocks(int firstI, int firstJ, int lastI, int lastJ) noexcept
{
    for (int blockJ = firstJ / kBlock; blockJ <= lastJ / kBlock; ++blockJ) {
        const int rowEnd = std::min(grid().side, (blockJ + 1) * kBlock);
        for (int blockI = firstI / kBlock; blockI <= lastI / kBlock; ++blockI) {
            // The last block of a row overlaps the block before it, so its value is only a bound.
            const int from = std::min(blockI * kBlock, grid().side - kBlock);
            std::array<float, kBlock> highest;
            std::array<float, kBlock> lowest;
            highest.fill(terrain::kEmptyTop);
            lowest.fill(terrain::kEmptyBottom);
            for (int j = blockJ * kBlock; j < rowEnd; ++j) {
                const float* top = m_tooth.top.data() + grid().index(from, j);
                const float* bottom = m_tooth.bottom.data() + grid().index(from, j);
                for (std::size_t n = 0; n < highest.size(); ++n) {
                    highest[n] = std::max(highest[n], top[n]);
                    lowest[n] = std::min(lowest[n], bottom[n]);
                }
            }
            const auto block = static_cast<std::size_t>(blockJ * m_blocks.side + blockI);
            m_blocks.tops[block] = *std::max_element(highest.begin(), highest.end());
            m_blocks.bottoms[block] = *std::min_element(lowest.begin(), lowest.end());
        }
    }
}

}  // namespace core::contact
