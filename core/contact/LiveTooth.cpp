// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/LiveTooth.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/contact/Head.h"

namespace core::contact {
namespace {

constexpr double kRounding = 1.0e-9;
constexpr double kFloatMm = 1.0e-6;  ///< heights are floats
/// Of a cell, by which columns under a bur stand lower than the ground between them at most, where it is not steep.
constexpr float kSpikeShare = 0.35F;

/// Ground that bends more than this, along itself, is an edge.
constexpr double kSharpestPerMm = 2.0;
constexpr int kBowlRounds = 4;
constexpr int kFootRounds = 4;

const Peak& highestOf(const Peaks& peaks)
{
    return *std::max_element(peaks.begin(), peaks.end(),
                             [](const Peak& a, const Peak& b) { return a.value < b.value; });
}

/// Where ground with `slope` carries a bur whose axis is at p.
glm::dvec2 footOn(const drilling::BurMask& mask, glm::dvec2 p, glm::dvec2 slope)
{
    const double steep = std::sqrt(slope.x * slope.x + slope.y * slope.y);
    return steep > 0.0 ? p + slope * (mask.standsAt(steep) / steep) : p;
}

double lengthOf(glm::dvec2 v)
{
    return std::sqrt(v.x * v.x + v.y * v.y);
}

}  // namespace

LiveTooth::LiveTooth(terrain::Tooth tooth)
    : m_tooth(std::move(tooth)),
      m_floorMm(static_cast<double>(*std::max_element(m_tooth.anatomy->top.begin(), m_tooth.anatomy->top.end())) -
                drilling::kChuckMm),
      m_kernels(contact::kernels())
{
    for (const drilling::Bur& bur : drilling::burs())
        m_masks.emplace_back(bur, grid().cellMm);
    std::size_t widest = 0;
    for (const drilling::BurMask& mask : m_masks)
        widest = std::max(widest, 2 * static_cast<std::size_t>(mask.span) + 3);
    widest += 2;  // and those that a cell's advance adds
    m_columnsRoom.most = widest * widest;
    const std::size_t room = wholeBlocks(m_columnsRoom.most + static_cast<std::size_t>(grid().side) + kBlock);
    m_columnsRoom.i.resize(room);
    m_columnsRoom.j.resize(room);
    m_columnsRoom.index.resize(room);
    m_columnsRoom.under.resize(room);
    m_blockSide = (grid().side + kBlock - 1) / kBlock;
    m_blocks.assign(static_cast<std::size_t>(m_blockSide) * static_cast<std::size_t>(m_blockSide), terrain::kEmptyTop);
    for (int j = 0; j < grid().side; ++j) {
        for (int i = 0; i < grid().side; ++i) {
            float& highest = m_blocks[static_cast<std::size_t>(j / kBlock * m_blockSide + i / kBlock)];
            highest = std::max(highest, m_tooth.top[grid().index(i, j)]);
        }
    }
}

bool LiveTooth::isWhole(std::size_t k) const noexcept
{
    return m_tooth.isSolid(k) && m_tooth.top[k] >= m_tooth.anatomy->top[k];
}

bool LiveTooth::bowlAt(int i, int j, Bowl& bowl) const noexcept
{
    if (i < 1 || j < 1 || i > grid().side - 2 || j > grid().side - 2)
        return false;
    std::array<std::array<double, 3>, 3> height{};
    for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
            const std::size_t k = grid().index(i + di, j + dj);
            if (!isWhole(k))
                return false;
            height[static_cast<std::size_t>(dj + 1)][static_cast<std::size_t>(di + 1)] =
                static_cast<double>(m_tooth.top[k]);
        }
    }
    const auto& [low, mid, high] = height;
    const double cell = grid().cellMm;
    const double bendX = (mid[0] - 2.0 * mid[1] + mid[2]) / (cell * cell);
    const double bendY = (low[1] - 2.0 * mid[1] + high[1]) / (cell * cell);
    const double twist = (low[0] - low[2] - high[0] + high[2]) / (4.0 * cell * cell);
    bowl = {{grid().nodeMm(i, j), mid[1]},
            {(mid[2] - mid[0]) / (2.0 * cell), (high[1] - low[1]) / (2.0 * cell)},
            {bendX, bendY},
            twist};
    // An edge has two slopes: the gentler of them says how steep the ground is.
    const double steepX = std::min(std::abs(mid[2] - mid[1]), std::abs(mid[1] - mid[0])) / cell;
    const double steepY = std::min(std::abs(high[1] - mid[1]), std::abs(mid[1] - low[1])) / cell;
    const double steep2 = 1.0 + steepX * steepX + steepY * steepY;
    return std::max({std::abs(bendX), std::abs(bendY), std::abs(twist)}) < kSharpestPerMm * steep2;
}

Touch LiveTooth::touchAt(glm::dvec2 pointMm, double enough) noexcept
{
    const glm::dvec2 lattice = grid().latticeOf(pointMm);
    const float spread = kSpikeShare * static_cast<float>(grid().cellMm);
    Search wanted{-drilling::BurMask::kAbsent, spread, static_cast<float>(enough)};
    if (m_peak.i >= 0) {  // the bur has moved by a fraction of a cell: mostly it is still near the highest
        const Head head = headAt(mask(), grid().cellMm, lattice.x, lattice.y);
        m_peak.value = valueOver<Side::Above>(m_tooth.top[grid().index(m_peak.i, m_peak.j)], m_peak.i,
                                              dy2Of(m_peak.j, head), head);
        wanted.atLeast = m_peak.value;
        if (m_peak.value > wanted.enough)
            return touchOn(m_peak, pointMm);
    }
    const Peaks peaks = m_kernels.highestAtPoint({m_tooth.top.data(), grid().side, m_blocks.data(), m_blockSide},
                                                 mask(), grid().cellMm, lattice.x, lattice.y, wanted);
    if (const Peak& highest = highestOf(peaks); highest.i >= 0)
        m_peak = highest;
    Touch best{static_cast<double>(terrain::kEmptyTop), {0.0, 0.0}, {pointMm, static_cast<double>(terrain::kEmptyTop)}};
    // A column that stands a little lower than another may lie on ground that is higher.
    const float least = highestOf(peaks).value - spread;
    for (const Peak& peak : peaks) {
        if (peak.i < 0 || peak.value < least)
            continue;
        const Touch touch = touchOn(peak, pointMm);
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

Touch LiveTooth::touchOn(const Peak& peak, glm::dvec2 pointMm) const noexcept
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
    if (Touch smooth{}; touchOnBowl(peak, pointMm, smooth))
        return smooth;
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
            if (r > static_cast<double>(mask().radiusMm) + kRounding)
                continue;
            const double height = ground - mask().heightAt(r);
            if (height > best.heightMm)
                best = {height, foot == wanted ? slope : slopeTowards(foot), {foot, ground}};
        }
    }
    return best;
}

/// The bur stands where bur and ground have the same slope. From the highest column go there, and from the node that is
/// nearest to it again: on steep ground the highest column may be some cells to the side.
bool LiveTooth::touchOnBowl(const Peak& peak, glm::dvec2 pointMm, Touch& touch) const noexcept
{
    int i = peak.i;
    int j = peak.j;
    for (int round = 0; round < kBowlRounds; ++round) {
        Bowl bowl{};
        if (!bowlAt(i, j, bowl))
            return false;
        glm::dvec2 out(0.0);
        glm::dvec2 slope = bowl.slope;
        const bool bends = bowl.twist != 0.0 || bowl.bend.x != 0.0 || bowl.bend.y != 0.0;
        for (int k = 0; k < (bends ? kFootRounds : 1); ++k) {
            out = footOn(mask(), pointMm, slope) - glm::dvec2(bowl.nodeMm);
            slope = bowl.slope + bowl.bend * out + glm::dvec2(out.y, out.x) * bowl.twist;
        }
        const glm::dvec2 foot = glm::dvec2(bowl.nodeMm) + out;
        const glm::dvec2 nearest = glm::round(grid().latticeOf(foot));
        if (static_cast<int>(nearest.x) == i && static_cast<int>(nearest.y) == j) {
            const double ground = bowl.nodeMm.z + glm::dot(bowl.slope, out) + 0.5 * glm::dot(bowl.bend, out * out) +
                                  bowl.twist * out.x * out.y;
            const double r = std::min(lengthOf(foot - pointMm), static_cast<double>(mask().radiusMm));
            touch = {ground - mask().heightAt(r), slope, {foot, ground}};
            return touch.heightMm >= static_cast<double>(peak.value) - kFloatMm;
        }
        i = static_cast<int>(nearest.x);
        j = static_cast<int>(nearest.y);
    }
    return false;
}

double LiveTooth::undersideAt(glm::dvec2 pointMm, double enough) const noexcept
{
    const glm::dvec2 lattice = grid().latticeOf(pointMm);
    const Search wanted{-drilling::BurMask::kAbsent, 0.0F, static_cast<float>(-enough)};
    if (m_peak.i >= 0) {  // what stops the bur from above mostly reaches down beside it
        const Head head = headAt(mask(), grid().cellMm, lattice.x, lattice.y);
        const float value = valueOver<Side::Beneath>(m_tooth.bottom[grid().index(m_peak.i, m_peak.j)], m_peak.i,
                                                     dy2Of(m_peak.j, head), head);
        if (value > wanted.enough)
            return -static_cast<double>(value);
    }
    const Peaks peaks = m_kernels.lowestAtPoint({m_tooth.bottom.data(), grid().side, nullptr, 0}, mask(), grid().cellMm,
                                                lattice.x, lattice.y, wanted);
    return -static_cast<double>(highestOf(peaks).value);
}

Room LiveTooth::roomAt(glm::dvec2 pointMm, double z) const noexcept
{
    const glm::dvec2 lattice = grid().latticeOf(pointMm);
    const Head head = headAt(mask(), grid().cellMm, lattice.x, lattice.y);
    const int span = mask().span;
    const int midI = static_cast<int>(std::floor(lattice.x));
    const int midJ = static_cast<int>(std::floor(lattice.y));
    const auto tip = static_cast<float>(z);
    float floor = terrain::kEmptyTop;
    float roof = terrain::kEmptyBottom;
    for (int j = std::max(0, midJ - span); j <= std::min(grid().side - 1, midJ + 1 + span); ++j) {
        const float dy2 = dy2Of(j, head);
        for (int i = std::max(0, midI - span); i <= std::min(grid().side - 1, midI + 1 + span); ++i) {
            const std::size_t k = grid().index(i, j);
            if (!m_tooth.isSolid(k))
                continue;
            const float above = valueOver<Side::Above>(m_tooth.top[k], i, dy2, head);
            const float beneath = -valueOver<Side::Beneath>(m_tooth.bottom[k], i, dy2, head);
            if (above <= beneath)  // not under the head
                continue;
            if (2.0F * tip >= above + beneath)
                floor = std::max(floor, above);
            else
                roof = std::min(roof, beneath);
        }
    }
    return {static_cast<double>(floor), static_cast<double>(roof)};
}

void LiveTooth::lower(int i, int j, float heightMm) noexcept
{
    const std::size_t index = grid().index(i, j);
    if (heightMm > m_tooth.bottom[index]) {
        m_tooth.top[index] = heightMm;
        return;
    }
    m_tooth.top[index] = terrain::kEmptyTop;
    m_tooth.bottom[index] = terrain::kEmptyBottom;
}

}  // namespace core::contact
