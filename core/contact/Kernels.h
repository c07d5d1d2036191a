// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/contact/BurHead.h"
#include "core/terrain/Tooth.h"

/// The innermost loops of contact and cutting: maxima, minima and sums over a bur's footprint. One source, compiled for
/// the plain architecture and for AVX2; every element goes through the same IEEE operations in both, so they agree to
/// the bit.
namespace core::contact {

/// Columns a side of the blocks that kernels work through.
inline constexpr int kBlock = 8;

/// The heights a kernel reads: a square map, row by row, at least a block a side.
struct HeightView
{
    const float* heights = nullptr;
    int side = 0;
    const float* blocks = nullptr;  ///< see Blocks
};

/// What is known of kBlock x kBlock columns at a time: no top is higher than `tops`, no bottom lower than `bottoms`,
/// [side * side] and room for a kernel to read on behind.
struct Blocks
{
    int side = 0;
    std::vector<float> tops;
    std::vector<float> bottoms;
};

/// Blocks a side of a map.
[[nodiscard]] constexpr int blocksFor(int side)
{
    return (side + kBlock - 1) / kBlock;
}

/// Heights of the tip between which a bur is free, mm: above the columns beneath it, beneath those above it.
struct Room
{
    double floorMm;
    double roofMm;
};

/// What is known beforehand of a maximum, and what need not be found out. Neither changes an answer that matters.
struct Search
{
    float atLeast = -bur::BurMask::kAbsent;  ///< some column under the head gives this much
    float spread = 0.0F;                     ///< columns this much below the largest, and lower, may be left out
    float enough = bur::BurMask::kAbsent;    ///< any value above this may be given as any other above it
};

/// A maximum over columns, and one that gave it.
struct Peak
{
    float value = -bur::BurMask::kAbsent;
    int i = -1;  ///< -1 if there was none
    int j = -1;
};

/// One for each quarter of the bur: a bur in a groove stands on two, one to either side.
using Peaks = std::array<Peak, 4>;

/// A tooth as the kernels read it: maps of side * side.
struct ToothView
{
    const float* top;
    const float* bottom;
    const float* areaMm2;
    const terrain::ColumnLayers* layers;
    const float* dej;    ///< of layers
    const float* sound;  ///< there is neither caries nor pulp above that height
    int side;
};

/// Neighbours in a row of the lattice, copied out of the tooth: cutting looks at the same ones again and again.
struct alignas(32) Columns
{
    using PerColumn = std::array<float, kBlock>;
    PerColumn top;
    PerColumn bottom;
    PerColumn areaMm2;  ///< 0 for one that another group holds as well
    PerColumn dej;
    int i;  ///< the first
    int j;
    float highestBottom;   ///< of those that may be cut
    bool isSound;          ///< there is neither caries nor pulp as far down as they may be cut
    std::uint8_t lowered;  ///< since they were copied: a bit each, the first in the lowest
    std::uint8_t emptied;  ///< those of them of which nothing is left
    // Not copied of what is sound.
    PerColumn cariesRoof;
    PerColumn cariesFloor;
    PerColumn pulpRoof;
    PerColumn pulpFloor;
};

/// Which columns a bur on its way down meets.
struct Reach
{
    double cells;    ///< to either side of its axis
    float nearer;    ///< mm2, taken off every squared distance from the axis
    float lowestMm;  ///< of its tip
};

/// Where the tip of a cutting bur is, mm, and the highest it was on its way there.
struct Descent
{
    float tipMm;
    float highestMm;
};

/// Time that it takes to remove a mm3, s.
struct RemovalTimes
{
    terrain::PerMaterial ofMaterial{};
    bool hasDecayZones = false;  ///< then ofMaterial has the soft zone of decay
    double leatheryDecay = 0.0;
    double firmDecay = 0.0;
};

struct Kernels
{
    const char* name;  ///< "plain" or "avx2"
    /// The largest valueOver() in each quarter of the head, with its axis at (u, v) in lattice units: from the top map
    /// and from the bottom map.
    Peaks (*highestAtPoint)(const HeightView& top, const bur::BurMask& mask, double cellMm, double u, double v,
                            const Search& wanted) noexcept;
    Peaks (*lowestAtPoint)(const HeightView& bottom, const bur::BurMask& mask, double cellMm, double u, double v,
                           const Search& wanted) noexcept;
    /// The room around the height `tipMm`: LiveTooth::roomAt().
    Room (*roomAt)(const HeightView& top, const HeightView& bottom, const BurHead& head, float tipMm,
                   const Room& enough) noexcept;
    /// Copies out the columns that stand up into a head, row by row; some are copied in vain.
    /// @return how many groups of columns; room.size() + 1 if there is not enough room
    std::size_t (*columnsUnder)(const ToothView& tooth, const BurHead& head, const Reach& reach,
                                std::span<Columns> room) noexcept;
    /// Time that it takes to remove what is in a head's way.
    double (*secondsToRemove)(std::span<const Columns> columns, const BurHead& head, const Descent& descent,
                              const RemovalTimes& secondsPerMm3) noexcept;
    /// Lowers the copies of the columns in a head's way by a share of it, empties those that are lowered to their
    /// bottom, and adds what that takes away, mm3.
    void (*remove)(std::span<Columns> columns, const BurHead& head, const Descent& descent, float share,
                   terrain::PerMaterial& removedMm3) noexcept;
};

extern const Kernels kPlainKernels;
/// The fastest this processor runs; the plain ones if CUSP_PLAIN_KERNELS is set in the environment (for tests).
[[nodiscard]] const Kernels& kernels();

}  // namespace core::contact
