// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "core/contact/Head.h"
#include "core/contact/Kernels.h"
#include "core/drilling/BurMask.h"
#include "core/terrain/Tooth.h"

namespace core::contact {

/// Heights of the tip between which a bur is free, mm: above the columns beneath it, beneath those above it.
struct Room
{
    double floorMm;
    double roofMm;
};

/// The tooth the servo works on: the height maps with, for the bur in hand, the clearance field
///
///     C(p) = max over |q - p| <= R of (H(q) - b(|q - p|)),   the tip (p, z) is free above if z >= C(p)
///
/// and its mirror image from below, D(p) = min (bottom(q) - u(|q - p|)), free beneath if z <= D(p)
/// (design section 2; inverse tool offset of CAM, tip dilation of Villarrubia 1997).
///
/// Values at nodes are computed when first asked for and kept until a cut dirties them. Built outside the servo thread
/// (it allocates); afterwards owned by the servo thread alone, and no member below allocates.
class LiveTooth
{
public:
    explicit LiveTooth(terrain::Tooth tooth);

    [[nodiscard]] const terrain::Tooth& tooth() const noexcept { return m_tooth; }
    [[nodiscard]] const terrain::Grid& grid() const noexcept { return m_tooth.anatomy->grid; }
    [[nodiscard]] const drilling::BurMask& mask() const noexcept { return m_masks[m_bur]; }
    [[nodiscard]] std::size_t burIndex() const noexcept { return m_bur; }

    /// Deepest the tip gets anywhere, mm: there the head of the handpiece lies on the highest cusp of the uncut crown.
    [[nodiscard]] double floorMm() const noexcept { return m_floorMm; }

    /// Takes another bur in hand: index into drilling::burs(). Constant time, all clearances become stale.
    void selectBur(std::size_t index) noexcept;

    /// C at a node; kEmptyTop or less where the bur meets no material. Node must be on the grid.
    [[nodiscard]] float clearanceAtNode(int i, int j) noexcept;
    /// D at a node; kEmptyBottom or more where the bur meets no material.
    [[nodiscard]] float undersideAtNode(int i, int j) noexcept;

    /// Least height at which the tip is free above everything, at any point of the tooth frame, mm.
    ///
    /// Over uncut surface bilinear between nodes, which is exact on planes and does not cog (haptics.md 3.1). Where the
    /// bur covers columns that have been cut, the maximum over the columns themselves: a pocket as wide as the bur that
    /// made it lies between the nodes, none of them sees it, and the bur could rest on ground it can never cut.
    /// @param enough  any answer above this may be given as any other above it (lets the search stop early)
    [[nodiscard]] double clearanceAt(glm::dvec2 pointMm, double enough = 1.0e9) noexcept;
    /// Whether clearanceAt() takes the columns themselves here.
    [[nodiscard]] bool isFeltByColumns(glm::dvec2 pointMm) const noexcept;
    /// Greatest height at which the tip is free beneath everything, at any point, mm. By nodes or columns, as above.
    /// @param enough  any answer below this may be given as any other below it
    [[nodiscard]] double undersideAt(glm::dvec2 pointMm, double enough = -1.0e9) noexcept;

    /// The room around height `z` at a point, column by column: a column whose middle the bur is above is floor, any
    /// other roof. There is none if the floor is above the roof. For the notch that a bur makes in from the side, where
    /// it has both; clearanceAt() and undersideAt() are quicker and know only one.
    [[nodiscard]] Room roomAt(glm::dvec2 pointMm, double z) const noexcept;

    /// Lowers one column to `heightMm`; a column lowered to its bottom or below becomes empty in both maps.
    /// Clearances go stale only with markCut().
    void lower(int i, int j, float heightMm) noexcept;
    /// Says that columns i0..i1 x j0..j1 (on the grid) were lowered: dirties the clearances within the bur's reach.
    void markCut(int i0, int j0, int i1, int j1) noexcept;

    /// Room for every column that any bur covers, for whoever cuts to make a list in. Not part of the tooth's state.
    [[nodiscard]] std::span<terrain::ColumnAt> columnsRoom() noexcept { return m_columnsRoom; }

private:
    struct Field
    {
        std::vector<float> value;
        std::vector<std::uint32_t> stamp;  ///< value is fresh if this equals m_epoch
    };

    [[nodiscard]] std::size_t blockOf(int i, int j) const noexcept
    {
        return static_cast<std::size_t>(j / kBlock) * static_cast<std::size_t>(m_blocks) +
               static_cast<std::size_t>(i / kBlock);
    }
    [[nodiscard]] bool isCutNear(glm::dvec2 lattice) const noexcept;
    /// Largest valueOver() at a point in lattice units, from the columns themselves: C, or -D. Any answer above
    /// `enough` may be any other above it.
    template <Side side>
    [[nodiscard]] float mostInTheWay(glm::dvec2 lattice, float enough) noexcept;
    [[nodiscard]] bool corners(glm::dvec2 lattice, int& i, int& j, double& fx, double& fy) const noexcept;

    terrain::Tooth m_tooth;
    std::vector<drilling::BurMask> m_masks;
    double m_floorMm = 0.0;
    std::size_t m_bur = 0;
    Field m_above;
    Field m_below;
    std::uint32_t m_epoch = 1;
    std::vector<terrain::ColumnAt> m_columnsRoom;
    static constexpr int kBlock = 8;
    int m_blocks = 0;                      ///< a side
    std::vector<std::uint8_t> m_cutBlock;  ///< 1 if a column of that block of kBlock x kBlock has been cut
    /// Columns that the bur met in the last looks, newest first. The next look, a fraction of a cell away, mostly meets
    /// one of them again, which settles it. They save time and change no answer.
    std::array<Peak, 4> m_peaksAbove;
    std::array<Peak, 4> m_peaksBeneath;
    const Kernels& m_kernels;
};

}  // namespace core::contact
