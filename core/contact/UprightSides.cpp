// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/UprightSides.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace core::contact {
namespace {

/// A rise of this many cells from one node to the next is an edge, if the ground to either side of it goes on this much
/// more gently.
constexpr double kLeastRise = 0.75;
constexpr double kGentler = 3.0;

/// Tops of one side differ from node to node by no more than this many cells a cell.
constexpr double kTopSlope = 2.0;

/// Longest chord: of a bur's radius. Farther apart are the two sides of a corner that it is in.
constexpr double kChordShare = 0.75;

/// Farther from the axis, in radii, is no node that counts: a radius, half a cell and a chord.
constexpr double kReachShare = 2.0;

constexpr double kRounding = 1.0e-9;

struct Node
{
    glm::dvec2 place;
    double top;
    double bottom;
    double apart;  ///< from the bur's axis, mm
};
constexpr std::size_t kMostNodes = 64;

double lengthOf(glm::dvec2 v)
{
    return std::sqrt(v.x * v.x + v.y * v.y);
}

/// True if the ground falls off upright from node (i, j) towards (i + di, j + dj).
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

UprightSides::UprightSides(const terrain::ToothAnatomy& anatomy)
    : m_side(anatomy.grid.side), m_blockSide((anatomy.grid.side + kBlock - 1) / kBlock),
      m_edges(static_cast<std::size_t>(m_blockSide) * static_cast<std::size_t>(m_blockSide), 0)
{
    const terrain::Grid& grid = anatomy.grid;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            if (!(anatomy.top[grid.index(i, j)] > anatomy.bottom[grid.index(i, j)]))
                continue;
            if (fallsOff(anatomy, i, j, 1, 0) || fallsOff(anatomy, i, j, -1, 0) || fallsOff(anatomy, i, j, 0, 1) ||
                fallsOff(anatomy, i, j, 0, -1))
                m_edges[static_cast<std::size_t>(j / kBlock * m_blockSide + i / kBlock)] |=
                    std::uint64_t{1} << static_cast<unsigned>(j % kBlock * kBlock + i % kBlock);
        }
    }
    double widest = 0.0;
    for (const drilling::Bur& bur : drilling::burs())
        widest = std::max(widest, bur.headRadiusMm);
    const auto reach = static_cast<int>(std::ceil(kReachShare * widest / grid.cellMm / kBlock)) + 1;
    m_hasNear.assign(m_edges.size(), 0);
    for (int j = 0; j < m_blockSide; ++j)
        for (int i = 0; i < m_blockSide; ++i)
            if (m_edges[static_cast<std::size_t>(j * m_blockSide + i)] != 0)
                for (int nearJ = std::max(0, j - reach); nearJ <= std::min(m_blockSide - 1, j + reach); ++nearJ)
                    for (int nearI = std::max(0, i - reach); nearI <= std::min(m_blockSide - 1, i + reach); ++nearI)
                        m_hasNear[static_cast<std::size_t>(nearJ * m_blockSide + nearI)] = 1;
}

bool UprightSides::isFar(glm::dvec2 lattice) const noexcept
{
    // A place outside the map is as near as the block at its edge.
    const int i = std::clamp(static_cast<int>(lattice.x), 0, m_side - 1) / kBlock;
    const int j = std::clamp(static_cast<int>(lattice.y), 0, m_side - 1) / kBlock;
    return m_hasNear[static_cast<std::size_t>(j * m_blockSide + i)] == 0;
}

/// A node and its neighbours are as they began: beside a cut the columns alone count, or the pocket that a bur made
/// would be narrower than the bur.
bool UprightSides::isUncut(int i, int j, const terrain::Tooth& tooth) const noexcept
{
    const terrain::Grid& grid = tooth.grid();
    for (int atJ = std::max(0, j - 1); atJ <= std::min(grid.side - 1, j + 1); ++atJ) {
        for (int atI = std::max(0, i - 1); atI <= std::min(grid.side - 1, i + 1); ++atI) {
            const std::size_t k = grid.index(atI, atJ);
            if (tooth.top[k] < tooth.anatomy->top[k])
                return false;
        }
    }
    return true;
}

template <class Visit>
void UprightSides::forEachNear(glm::dvec2 lattice, double cells, Visit&& visit) const noexcept
{
    const int last = m_side - 1;
    const int firstI = std::max(0, static_cast<int>(std::ceil(lattice.x - cells)));
    const int lastI = std::min(last, static_cast<int>(std::floor(lattice.x + cells)));
    const int firstJ = std::max(0, static_cast<int>(std::ceil(lattice.y - cells)));
    const int lastJ = std::min(last, static_cast<int>(std::floor(lattice.y + cells)));
    for (int blockJ = firstJ / kBlock; blockJ <= lastJ / kBlock && firstJ <= lastJ; ++blockJ) {
        for (int blockI = firstI / kBlock; blockI <= lastI / kBlock && firstI <= lastI; ++blockI) {
            std::uint64_t edges = m_edges[static_cast<std::size_t>(blockJ * m_blockSide + blockI)];
            for (; edges != 0; edges &= edges - 1) {
                const int bit = std::countr_zero(edges);
                const int i = blockI * kBlock + bit % kBlock;
                const int j = blockJ * kBlock + bit / kBlock;
                if (i < firstI || i > lastI || j < firstJ || j > lastJ)
                    continue;
                const glm::dvec2 apart = glm::dvec2(i, j) - lattice;
                if (glm::dot(apart, apart) <= cells * cells)
                    visit(i, j);
            }
        }
    }
}

Touch UprightSides::touchAt(glm::dvec2 pointMm, const terrain::Tooth& tooth, const drilling::BurMask& mask,
                            const Touch& below) const noexcept
{
    const terrain::Grid& grid = tooth.grid();
    const double cell = grid.cellMm;
    const auto radius = static_cast<double>(mask.radiusMm);
    const double ahead = kCellShare * cell;  // of the nodes, the side
    const double longest = std::min(kChordCells * cell, kChordShare * radius);
    const double proud = longest * longest / (8.0 * radius);  // of its ends, the middle of a chord
    const glm::dvec2 lattice = grid.latticeOf(pointMm);
    if (isFar(lattice))
        return below;

    std::array<Node, kMostNodes> nodes;
    std::size_t count = 0;
    double nearest = radius + ahead + proud;
    forEachNear(lattice, std::sqrt(nearest * nearest + longest * longest) / cell, [&](int i, int j) {
        const std::size_t k = grid.index(i, j);
        if (count == nodes.size() || static_cast<double>(tooth.top[k]) <= below.heightMm || !isUncut(i, j, tooth))
            return;
        const glm::dvec2 place = grid.nodeMm(i, j);
        const double apart = lengthOf(place - pointMm);
        nodes[count++] = {place, static_cast<double>(tooth.top[k]), static_cast<double>(tooth.bottom[k]), apart};
        nearest = std::min(nearest, apart);
    });

    Touch best = below;
    const auto take = [&](glm::dvec2 foot, double top, double bottom) {
        const glm::dvec2 out = pointMm - foot;
        const double apart = lengthOf(out);
        const double r = std::max(0.0, apart - ahead);
        if (!(apart > 0.0) || r > radius)
            return;
        const double height = top - mask.heightAt(r);
        if (!(height > best.heightMm))
            return;
        const glm::dvec2 outwards = out / apart;
        best = {
            height, -outwards * mask.slopeAt(r), {foot + outwards * ahead, top}, outwards, bottom - mask.upperAt(r)};
    };
    for (std::size_t a = 0; a < count; ++a) {
        const Node& one = nodes[a];
        if (one.apart >
            nearest + longest * longest /
                          (8.0 * std::max(nearest, cell)))  // no chord of which this is the nearer end is the nearest
            continue;
        take(one.place, one.top, one.bottom);
        const glm::dvec2 towards = pointMm - one.place;
        for (std::size_t b = 0; b < count; ++b) {
            const Node& other = nodes[b];
            const glm::dvec2 chord = other.place - one.place;
            const double length2 = glm::dot(chord, chord);
            const double share = glm::dot(chord, towards) / std::max(length2, kRounding);
            if (b == a || length2 > longest * longest || share <= 0.0 || share >= 1.0)
                continue;
            if (std::abs(other.top - one.top) > kTopSlope * std::sqrt(length2))
                continue;
            take(one.place + chord * share, one.top + (other.top - one.top) * share,
                 one.bottom + (other.bottom - one.bottom) * share);
        }
    }
    return best;
}

}  // namespace core::contact
