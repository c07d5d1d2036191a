// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/ext/vector_int2.hpp>
#include <glm/vec2.hpp>

#include "core/bur/BurMask.h"
#include "core/contact/Touch.h"
#include "core/terrain/Tooth.h"

namespace core::contact {

/// The upright sides of uncut ground: the outer rim of a tooth, a step, a wall.
///
/// Columns give the place of such a side only to within a cell, and a side at an angle to the lattice is a stair: a bur
/// that presses against it would drop into every notch. So a side is a chain of points half-way between a high node and
/// a low one, each moved onto the straight line that fits its neighbours if there is one. The points are joined by
/// chords, and a bur that touches both ends of a chord cannot get behind it. Cut ground consists of its columns only,
/// and so do the sides beside it.
///
/// Built with the tooth; afterwards read on the servo thread, without allocation.
class VerticalWalls
{
public:
    explicit VerticalWalls(const terrain::ToothAnatomy& anatomy);

    /// Returns the contact of a bur lowered at a point if that is with a side; otherwise `below`.
    /// @param below  the contact with the ground
    [[nodiscard]] Touch touchAt(glm::dvec2 pointMm, const terrain::Tooth& tooth, const bur::BurMask& mask,
                                const Touch& below) const noexcept;

    /// Returns, of the sides beside a bur whose tip is at `tipMm` over a point, and not wholly above it, the one
    /// nearest to its axis; not isSide() if there is none.
    [[nodiscard]] Touch besideAt(glm::dvec2 pointMm, double tipMm, const terrain::Tooth& tooth,
                                 const bur::BurMask& mask) const noexcept;

private:
    static constexpr int kBlock = 8;

    /// A wall point that a bur may touch.
    struct Node
    {
        glm::dvec2 place;
        double top;
        double bottom;
        double apart;  ///< from the bur's axis, mm
    };
    /// Enough for both sides of a slot under the widest bur at 1024 nodes a side.
    using Nodes = std::array<Node, 1280>;

    /// The distances around its axis within which a bur needs wall points, mm.
    struct Reach
    {
        Reach(const terrain::Grid& grid, const bur::BurMask& mask);
        double radius;
        double chord;     ///< longest
        double farthest;  ///< end of a chord that the bur may touch
    };
    struct Foot;

    [[nodiscard]] std::size_t nodesNear(glm::dvec2 pointMm, const terrain::Tooth& tooth, const Reach& reach,
                                        double aboveMm, Nodes& nodes) const noexcept;
    [[nodiscard]] static bool footBetween(glm::dvec2 pointMm, const Node& one, const Node& other, double longest,
                                          Foot& foot) noexcept;
    template <class Take, class MayCount>
    static void eachFoot(glm::dvec2 pointMm, const Reach& reach, std::span<const Node> nodes, Take&& take,
                         MayCount&& mayCount) noexcept;
    [[nodiscard]] static Touch touchOf(glm::dvec2 pointMm, const bur::BurMask& mask, const Foot& foot) noexcept;

    /// A point of a wall.
    struct Post
    {
        glm::vec2 placeMm;
        glm::ivec2 high;  ///< the high node behind it
    };

    /// The edge between a high and a low node, before it is straightened.
    struct Fall
    {
        glm::dvec2 middle;  ///< lattice
        glm::dvec2 outwards;
        glm::ivec2 high;
    };
    [[nodiscard]] static std::vector<Fall> fallsOf(const terrain::ToothAnatomy& anatomy);
    [[nodiscard]] static glm::dvec2 straightened(const Fall& fall, const std::vector<Fall>& all,
                                                 const std::vector<std::vector<std::size_t>>& byBlock, int blockSide);

    [[nodiscard]] static bool isUncut(glm::ivec2 node, const terrain::Tooth& tooth) noexcept;
    /// Returns whether no side can be touched at a place on the lattice.
    [[nodiscard]] bool isFar(glm::dvec2 lattice) const noexcept;

    int m_side = 0;
    int m_blockSide = 0;
    std::vector<std::uint8_t> m_hasNear;  ///< 1 for blocks within reach of whose nodes there are wall points
    std::vector<std::uint32_t> m_first;   ///< index of a block's first wall point, and one more at the end
    std::vector<Post> m_posts;            ///< block by block
};

}  // namespace core::contact
