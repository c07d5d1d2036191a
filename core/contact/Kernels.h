// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/contact/BurHead.h"
#include "core/terrain/Tooth.h"

/// The innermost loops of contact and cutting: maxima, minima and sums over a bur's footprint. One source, compiled for
/// the plain architecture and for AVX2; every element passes the same IEEE operations in both, so the results are
/// bit-identical.
namespace core::contact {

/// Side of the blocks that kernels process, columns.
inline constexpr int kBlock = 8;

/// The heights that a kernel reads: a square map, row by row, at least one block per side.
struct HeightView
{
    const float* heights = nullptr;
    int side = 0;
    const float* blocks = nullptr;  ///< see Blocks
};

/// Bounds of blocks of kBlock x kBlock columns: no top is higher than `tops`, no bottom lower than `bottoms`, [side *
/// side] with padding for reads behind the end.
struct Blocks
{
    int side = 0;
    std::vector<float> tops;
    std::vector<float> bottoms;
};

/// Returns the number of blocks per side of a map.
[[nodiscard]] constexpr int blocksFor(int side)
{
    return (side + kBlock - 1) / kBlock;
}

/// The heights of the tip between which a bur is free, mm: above the columns below it, below those above it.
struct Room
{
    double floorMm;
    double roofMm;
};

/// Hints for the search of a maximum. None changes a result that matters.
struct Search
{
    float atLeast = -bur::BurMask::kAbsent;  ///< some column under the head has this value
    float spread = 0.0F;                     ///< columns lower than the largest by this much or more may be left out
    float enough = bur::BurMask::kAbsent;    ///< any value above this may be returned for another one above it
};

/// A maximum over columns, and a column with that value.
struct Peak
{
    float value = -bur::BurMask::kAbsent;
    int i = -1;  ///< -1 if there was none
    int j = -1;
};

/// One for each quarter of the bur: a bur in a groove rests on two, one on either side.
using Peaks = std::array<Peak, 4>;

/// A tooth for the kernels: maps of side * side.
struct ToothView
{
    const float* top;
    const float* bottom;
    const float* areaMm2;
    const terrain::ColumnLayers* layers;
    const float* dej;    ///< of layers
    const float* sound;  ///< there is neither caries nor pulp above this height
    int side;
};

/// Neighbouring columns of a row, copied from the tooth: cutting reads the same ones repeatedly.
struct alignas(32) Columns
{
    using PerColumn = std::array<float, kBlock>;
    PerColumn top;
    PerColumn bottom;
    PerColumn areaMm2;  ///< 0 for one that is also in another group
    PerColumn dej;
    int i;  ///< the first
    int j;
    float highestBottom;   ///< of the columns that may be cut
    bool isSound;          ///< there is neither caries nor pulp down to where they may be cut
    std::uint8_t lowered;  ///< since they were copied: one bit each, the first in the lowest
    std::uint8_t emptied;  ///< those of them that are removed completely
    // The following members are not set if isSound.
    PerColumn cariesRoof;
    PerColumn cariesFloor;
    PerColumn pulpRoof;
    PerColumn pulpFloor;
};

/// The columns that a bur meets on its way down.
struct Reach
{
    double cells;    ///< to either side of its axis
    float nearer;    ///< mm2, subtracted from every squared distance from the axis
    float lowestMm;  ///< of its tip
};

/// The height of the tip of a cutting bur, mm, and the highest on its way there.
struct Descent
{
    float tipMm;
    float highestMm;
};

/// Time to remove a mm3 of each material, s.
struct RemovalTimes
{
    terrain::PerMaterial ofMaterial{};
    bool hasDecayZones = false;  ///< if set, ofMaterial has the soft zone of decay
    double leatheryDecay = 0.0;
    double firmDecay = 0.0;
};

struct Kernels
{
    const char* name;  ///< "plain" or "avx2"
    /// Return the largest valueOver() in each quarter of the head, with its axis at (u, v) in lattice units: from the
    /// top map and from the bottom map.
    Peaks (*highestAtPoint)(const HeightView& top, const bur::BurMask& mask, double cellMm, double u, double v,
                            const Search& wanted) noexcept;
    Peaks (*lowestAtPoint)(const HeightView& bottom, const bur::BurMask& mask, double cellMm, double u, double v,
                           const Search& wanted) noexcept;
    /// Returns the room around the height `tipMm`: LiveTooth::roomAt().
    Room (*roomAt)(const HeightView& top, const HeightView& bottom, const BurHead& head, float tipMm,
                   const Room& enough) noexcept;
    /// Copies the columns that reach into a head, row by row; some more may be copied.
    /// @return number of groups of columns; room.size() + 1 if there is not enough room
    std::size_t (*columnsUnder)(const ToothView& tooth, const BurHead& head, const Reach& reach,
                                std::span<Columns> room) noexcept;
    /// Returns the time to remove the tissue in a head's way, s.
    double (*secondsToRemove)(std::span<const Columns> columns, const BurHead& head, const Descent& descent,
                              const RemovalTimes& secondsPerMm3) noexcept;
    /// Lowers the copies of the columns in a head's way by a share of it, empties those lowered to their bottom, and
    /// adds the removed volumes, mm3.
    void (*remove)(std::span<Columns> columns, const BurHead& head, const Descent& descent, float share,
                   terrain::PerMaterial& removedMm3) noexcept;
};

extern const Kernels kPlainKernels;
/// Returns the fastest kernels for this processor; the plain ones if CUSP_PLAIN_KERNELS is set in the environment (for
/// tests).
[[nodiscard]] const Kernels& kernels();

}  // namespace core::contact
