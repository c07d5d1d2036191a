// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/contact/Touch.h"
#include "core/drilling/BurMask.h"
#include "core/terrain/Tooth.h"

namespace core::contact {

/// The upright sides of uncut ground: the outer rim of a tooth, a step, a wall.
///
/// Columns say of such a side only between which two of them it lies, and a side that runs across the lattice is a
/// stair: a bur that leans on it drops into every notch. So a node at the edge stands for its cell, half a cell beyond
/// itself, and neighbouring nodes are joined by the chords that a bur which touches both cannot get behind (the hull of
/// the nodes within kChordCells). Ground that has been cut is its columns and no more, and so are the sides beside it.
///
/// Built with the tooth; afterwards read on the servo thread, without allocation.
class UprightSides
{
public:
    explicit UprightSides(const terrain::ToothAnatomy& anatomy);

    /// What a bur let down over a point comes to stand on, if that is a side; else `below` again.
    /// @param below  what is known to carry the bur there
    [[nodiscard]] Touch touchAt(glm::dvec2 pointMm, const terrain::Tooth& tooth, const drilling::BurMask& mask,
                                const Touch& below) const noexcept;

private:
    static constexpr int kBlock = 8;
    static constexpr double kChordCells = 4.25;
    static constexpr double kCellShare = 0.5;

    [[nodiscard]] bool isUncut(int i, int j, const terrain::Tooth& tooth) const noexcept;

    /// Calls visit(i, j) for every edge node within `cells` of a place on the lattice.
    template <class Visit>
    void forEachNear(glm::dvec2 lattice, double cells, Visit&& visit) const noexcept;

    /// True if no side can be met over a place on the lattice.
    [[nodiscard]] bool isFar(glm::dvec2 lattice) const noexcept;

    int m_side = 0;
    int m_blockSide = 0;
    std::vector<std::uint8_t> m_hasNear;  ///< blocks within reach of whose nodes there are edge nodes, 1 each
    std::vector<std::uint64_t> m_edges;   ///< one bit a node, kBlock x kBlock of them a word, row by row
};

}  // namespace core::contact
