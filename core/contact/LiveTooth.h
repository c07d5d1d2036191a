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

/// How the edges of uncut ground are felt: as the columns they are sampled by, or as the upright sides that the samples
/// stand for.
enum class Edges { Columns, Sides };

/// The tooth the servo works on: the height maps, felt by the bur in hand. The bur becomes a point and the tooth its
/// dilation,
///
///     C(p) = max over |q - p| <= R of (H(q) - b(|q - p|)),   the tip (p, z) is free above if z >= C(p)
///
/// and its mirror image from below, D(p) = min (bottom(q) - u(|q - p|)), free beneath if z <= D(p)
/// (inverse tool offset of CAM, tip dilation of Villarrubia 1997: docs/facts/haptics.md, section 3).
///
/// Built outside the servo thread (it allocates); afterwards owned by the servo thread alone, and no member below
/// allocates.
class LiveTooth
{
public:
    explicit LiveTooth(terrain::Tooth tooth);

    [[nodiscard]] const terrain::Tooth& tooth() const noexcept { return m_tooth; }
    [[nodiscard]] const terrain::Grid& grid() const noexcept { return m_tooth.anatomy->grid; }
    [[nodiscard]] const bur::BurMask& mask() const noexcept { return m_masks[m_bur]; }
    [[nodiscard]] std::size_t burIndex() const noexcept { return m_bur; }

    /// Deepest the tip gets anywhere, mm: there the head of the handpiece lies on the highest cusp of the uncut crown.
    [[nodiscard]] double floorMm() const noexcept { return m_floorMm; }

    /// Takes another bur in hand: index into bur::burs().
    void selectBur(std::size_t index) noexcept
    {
        m_bur = index;
        ++m_revision;
    }
    /// Another one whenever an answer below may be another.
    [[nodiscard]] std::uint64_t revision() const noexcept { return m_revision; }

    /// C at any point of the tooth frame, and what gives it.
    ///
    /// The maximum over the columns, and from the highest of them over the surface around it: whole ground is a plane
    /// between any three of its nodes, and a ball let down on a plane finds its own place between the columns, which
    /// alone are a bed of spikes (docs/facts/haptics.md, section 3.1). Cut ground is its columns and no more: a pocket
    /// must be as wide as the bur that made it.
    /// @param enough  any answer above this may be given as any other above it (lets the search stop early)
    [[nodiscard]] Touch touchAt(glm::dvec2 pointMm, double enough = 1.0e9, Edges edges = Edges::Columns) noexcept;
    /// The upright side that stands beside a tip at `tipMm`, not beneath its rounded end, and nearest to its axis;
    /// none if it is no isSide().
    [[nodiscard]] Touch sideAt(glm::dvec2 pointMm, double tipMm) const noexcept
    {
        return m_sides.besideAt(pointMm, tipMm, m_tooth, mask());
    }
    /// Whether touchAt() is higher than `z`.
    [[nodiscard]] bool isAbove(glm::dvec2 pointMm, double z, Edges edges) noexcept;
    /// C alone.
    [[nodiscard]] double clearanceAt(glm::dvec2 pointMm, double enough = 1.0e9) noexcept
    {
        return touchAt(pointMm, enough).heightMm;
    }
    /// D: greatest height at which the tip is free beneath everything, over the columns.
    /// @param enough  any answer below this may be given as any other below it
    [[nodiscard]] double undersideAt(glm::dvec2 pointMm, double enough = -1.0e9) noexcept;

    /// The room around height `z` at a point, column by column: a column whose middle the bur is above is floor, any
    /// other roof. There is none if the floor is above the roof. For the notch that a bur makes in from the side, where
    /// it has both; clearanceAt() and undersideAt() are quicker and know only one.
    /// @param enough  a room with a floor above this one's or a roof below may be given as any other such, and one that
    ///                is none as any other
    [[nodiscard]] Room roomAt(glm::dvec2 pointMm, double z, const Room& enough = {1.0e9, -1.0e9}) const noexcept;

    /// Lowers one column to `heightMm`; a column lowered to its bottom or below becomes empty in both maps.
    void lower(int i, int j, float heightMm) noexcept;

    /// Lowers columns to what removal has left of a copy of them.
    void take(const Columns& columns) noexcept;
    /// To be told, after cutting, of the columns that were lowered, or looks take longer than they need to.
    void refreshBlocks(int firstI, int firstJ, int lastI, int lastJ) noexcept;

    /// Room for every column that any bur covers, for whoever cuts to make a copy in. Not part of the tooth's state.
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
    /// The last highest column as it stands under a bur at a place on the lattice; i < 0 if there is none.
    [[nodiscard]] Peak lastPeakAt(glm::dvec2 lattice) const noexcept;
    [[nodiscard]] Touch touchColumnsAt(glm::dvec2 pointMm, double enough) noexcept;
    /// The bur over p carried by the highest of a quarter, and by the facets around it.
    [[nodiscard]] Touch touchOnFacets(const Peak& peak, glm::dvec2 pointMm) const noexcept;
    /// The same on ground that bends without an edge; false if it does not.
    /// @param node  the node that is nearest to where the bur stands
    [[nodiscard]] bool touchOnBowl(const Peak& peak, glm::dvec2 pointMm, Touch& touch, glm::ivec2& node) const noexcept;
    /// Slope from column (i, j) to its neighbour that lies outwards of the bur's axis, mm a mm.
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
    /// Of the uncut ground around a node inside the map.
    [[nodiscard]] static Bowl bowlAt(const terrain::Grid& grid, const std::vector<float>& top, int i, int j) noexcept;
    [[nodiscard]] bool isWhole(std::size_t k) const noexcept;
    void noteCut(int i, int j) noexcept;
    /// Whether noteCut() of kBlock columns from (i, j) on would have anything to note.
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
    std::vector<std::uint8_t> m_bends;  ///< nodes whose ground is uncut and bends without an edge, 1 each
    /// Highest column of the last look, and the one that hung lowest: they save time in the next and change no answer.
    Peak m_peak;
    Peak m_lowest;
    const Kernels& m_kernels;
};

}  // namespace core::contact
