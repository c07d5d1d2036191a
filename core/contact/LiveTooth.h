// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/bur/BurMask.h"
#include "core/contact/BurHead.h"
#include "core/contact/Kernels.h"
#include "core/contact/Touch.h"
#include "core/contact/VerticalWalls.h"
#include "core/terrain/Tooth.h"

namespace core::contact {

/// The shape of the edges of uncut ground: that of the sampled columns, or that of the upright sides that the samples
/// represent.
enum class Edges { Columns, Sides };

/// The tooth that the servo works on: the height maps and contact with the current bur. The bur becomes a point and the
/// tooth its dilation,
///
///     C(p) = max over |q - p| <= R of (H(q) - b(|q - p|)),   the tip (p, z) is free above if z >= C(p)
///
/// and its mirror image from below, D(p) = min (bottom(q) - u(|q - p|)), free beneath if z <= D(p)
/// (inverse tool offset of CAM, tip dilation of Villarrubia 1997: docs/facts/haptics.md, section 3).
///
/// Built outside the servo thread (it allocates); afterwards used by the servo thread only, and no member below
/// allocates.
class LiveTooth
{
public:
    explicit LiveTooth(terrain::Tooth tooth);

    [[nodiscard]] const terrain::Tooth& tooth() const noexcept { return m_tooth; }
    [[nodiscard]] const terrain::Grid& grid() const noexcept { return m_tooth.anatomy->grid; }
    [[nodiscard]] const bur::BurMask& mask() const noexcept { return m_masks[m_bur]; }
    [[nodiscard]] std::size_t burIndex() const noexcept { return m_bur; }

    /// Returns the lowest height of the tip, mm: there the head of the handpiece touches the highest cusp of the uncut
    /// crown.
    [[nodiscard]] double floorMm() const noexcept { return m_floorMm; }

    /// Selects a bur by its index into bur::burs().
    void selectBur(std::size_t index) noexcept
    {
        m_bur = index;
        ++m_revision;
    }
    /// Returns a number that changes whenever a result of the functions below may change.
    [[nodiscard]] std::uint64_t revision() const noexcept { return m_revision; }

    /// Returns C at any point of the tooth frame, and the contact that determines it.
    ///
    /// Takes the maximum over the columns, and from the highest of them over the surface around it: uncut ground is a
    /// plane between any three of its nodes, and a ball that is lowered onto a plane touches it between the columns,
    /// which alone would be a bed of spikes (docs/facts/haptics.md, section 3.1). Cut ground consists of its columns
    /// only: a pocket must be as wide as the bur that made it.
    /// @param enough  any result above this may be returned for another one above it, so that the search stops early
    [[nodiscard]] Touch touchAt(glm::dvec2 pointMm, double enough = 1.0e9, Edges edges = Edges::Columns) noexcept;
    /// Returns the upright side beside a tip at `tipMm`, not below its rounded end, and nearest to its axis; not
    /// isSide() if there is none.
    [[nodiscard]] Touch sideAt(glm::dvec2 pointMm, double tipMm) const noexcept
    {
        return m_sides.besideAt(pointMm, tipMm, m_tooth, mask());
    }
    /// Returns whether touchAt() is higher than `z`.
    [[nodiscard]] bool isAbove(glm::dvec2 pointMm, double z, Edges edges) noexcept;
    /// Returns C only.
    [[nodiscard]] double clearanceAt(glm::dvec2 pointMm, double enough = 1.0e9) noexcept
    {
        return touchAt(pointMm, enough).heightMm;
    }
    /// Returns D: the greatest height at which the tip is free below all columns above it.
    /// @param enough  any result below this may be returned for another one below it
    [[nodiscard]] double undersideAt(glm::dvec2 pointMm, double enough = -1.0e9) noexcept;

    /// Returns the room around height `z` at a point, column by column: a column whose middle is below the bur is
    /// floor, any other roof. There is no room if the floor is above the roof. For a notch that a bur cuts from the
    /// side, which has both; clearanceAt() and undersideAt() are faster and find only one.
    /// @param enough  a room with a floor above this one's or a roof below it may be returned for another such one, and
    ///                one that is no room for any other
    [[nodiscard]] Room roomAt(glm::dvec2 pointMm, double z, const Room& enough = {1.0e9, -1.0e9}) const noexcept;

    /// Lowers one column to `heightMm`; a column lowered to its bottom or below becomes empty in both maps.
    void lower(int i, int j, float heightMm) noexcept;

    /// Lowers columns to the heights of a copy after removal.
    void take(const Columns& columns) noexcept;
    /// Must be called after cutting with the columns that were lowered, or searches become slow.
    void refreshBlocks(int firstI, int firstJ, int lastI, int lastJ) noexcept;

    /// Returns a buffer for copies of all columns below any bur. Not part of the tooth's state.
    [[nodiscard]] std::span<Columns> columnsRoom() noexcept { return m_columnsRoom; }
    [[nodiscard]] ToothView view() const noexcept
    {
        return {m_tooth.top.data(),
                m_tooth.bottom.data(),
                m_tooth.anatomy->areaMm2.data(),
                m_tooth.anatomy->layers.data(),
                m_dej.data(),
                m_sound.data(),
                grid().side};
    }
    [[nodiscard]] const Kernels& kernels() const noexcept { return m_kernels; }

private:
    /// Returns the last highest column for a bur at a place on the lattice; i < 0 if there is none.
    [[nodiscard]] Peak lastPeakAt(glm::dvec2 lattice) const noexcept;
    [[nodiscard]] Touch touchColumnsAt(glm::dvec2 pointMm, double enough) noexcept;
    /// Returns the contact of the bur at a point with the highest column of a quarter, and with the facets around it.
    [[nodiscard]] Touch touchOnFacets(const Peak& peak, glm::dvec2 pointMm) const noexcept;
    /// Computes the same on ground that is curved without an edge; returns false on other ground.
    /// @param node  the node nearest to the contact
    [[nodiscard]] bool touchOnBowl(const Peak& peak, glm::dvec2 pointMm, Touch& touch, glm::ivec2& node) const noexcept;
    /// Returns the slope from column (i, j) to its neighbour away from the bur's axis, mm per mm.
    [[nodiscard]] double riseBeyond(int i, int j, glm::dvec2 outwards) const noexcept;

    /// Ground around a node, to the second order.
    struct Bowl
    {
        glm::dvec3 nodeMm;
        glm::dvec2 slope;
        glm::dvec2 bend;  ///< of slope.x along x and of slope.y along y, 1 / mm
        double twist;     ///< of slope.x along y, 1 / mm
    };
    [[nodiscard]] HeightView tops() const noexcept { return {m_tooth.top.data(), grid().side, m_blocks.tops.data()}; }
    [[nodiscard]] HeightView bottoms() const noexcept
    {
        return {m_tooth.bottom.data(), grid().side, m_blocks.bottoms.data()};
    }
    [[nodiscard]] static bool bends(const terrain::ToothAnatomy& anatomy, int i, int j) noexcept;
    /// Returns the uncut ground around a node inside the map.
    [[nodiscard]] static Bowl bowlAt(const terrain::Grid& grid, const std::vector<float>& top, int i, int j) noexcept;
    [[nodiscard]] bool isWhole(std::size_t k) const noexcept;
    void noteCut(int i, int j) noexcept;
    /// Returns whether noteCut() has an effect on any of kBlock columns from (i, j) on.
    [[nodiscard]] bool bendsAround(int i, int j) const noexcept;

    terrain::Tooth m_tooth;
    VerticalWalls m_sides;
    std::vector<bur::BurMask> m_masks;
    double m_floorMm = 0.0;
    std::size_t m_bur = 0;
    std::uint64_t m_revision = 0;
    std::vector<Columns> m_columnsRoom;
    Blocks m_blocks;
    std::vector<float> m_dej;  ///< see ToothView
    std::vector<float> m_sound;
    std::vector<std::uint8_t> m_bends;  ///< 1 for nodes whose ground is uncut and curved without an edge
    /// The highest column of the last search, and the one that was lowest from below: they save time in the next and
    /// change no result.
    Peak m_peak;
    Peak m_lowest;
    const Kernels& m_kernels;
};

}  // namespace core::contact
