// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/contact/Head.h"

/// The innermost loops of contact: maxima and minima over a bur's footprint. One source, compiled for the plain
/// architecture and for AVX2; every element goes through the same IEEE operations in both, so they agree to the bit.
namespace core::contact {

/// Columns a side of the blocks that kernels work through.
inline constexpr int kBlock = 8;

/// So many rounded up to whole blocks.
[[nodiscard]] constexpr std::size_t wholeBlocks(std::size_t count)
{
    return (count + kBlock - 1) / kBlock * kBlock;
}

/// The heights a kernel reads: a square map, row by row, at least a block a side.
struct HeightView
{
    const float* heights = nullptr;
    int side = 0;
    const float* blocks = nullptr;  ///< no column of a block is higher, [blockSide * blockSide]; tops only
    int blockSide = 0;
};

/// What is known beforehand of a maximum, and what need not be found out. Neither changes an answer that matters.
struct Search
{
    float atLeast = -drilling::BurMask::kAbsent;  ///< some column under the head gives this much
    float spread = 0.0F;                          ///< columns this much below the largest, and lower, may be left out
    float enough = drilling::BurMask::kAbsent;    ///< any value above this may be given as any other above it
};

/// A maximum over columns, and one that gave it.
struct Peak
{
    float value = -drilling::BurMask::kAbsent;
    int i = -1;  ///< -1 if there was none
    int j = -1;
};

/// One for each quarter of the bur: a bur in a groove stands on two, one to either side.
using Peaks = std::array<Peak, 4>;

struct Kernels
{
    const char* name;  ///< "plain" or "avx2"
    /// The largest valueOver() in each quarter of the head, with its axis at (u, v) in lattice units: from the top map
    /// and from the bottom map.
    Peaks (*highestAtPoint)(const HeightView& top, const drilling::BurMask& mask, double cellMm, double u, double v,
                            const Search& wanted) noexcept;
    Peaks (*lowestAtPoint)(const HeightView& bottom, const drilling::BurMask& mask, double cellMm, double u, double v,
                           const Search& wanted) noexcept;
    /// underAt() over each of some columns (i, j), whole blocks of kBlock of them: [count].
    /// @param nearer  mm2, taken off every squared distance from the axis
    void (*undersides)(const float* i, const float* j, std::size_t count, const Head& head, float nearer,
                       float* under) noexcept;
};

extern const Kernels kPlainKernels;
/// The fastest this processor runs; the plain ones if CUSP_PLAIN_KERNELS is set in the environment (for tests).
[[nodiscard]] const Kernels& kernels();

}  // namespace core::contact
