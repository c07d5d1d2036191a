// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drilling/BurMask.h"

/// The innermost loops of contact: maxima and minima over a bur's footprint. One source, compiled for the plain
/// architecture and for AVX2; every element goes through the same IEEE operations in both, so they agree to the bit.
namespace core::contact {

/// The heights a kernel reads: a square map, row by row.
struct HeightView
{
    const float* heights = nullptr;
    int side = 0;
};

/// A maximum over columns, and one that gave it.
struct Peak
{
    float value = 0.0F;
    int i = -1;  ///< -1 if there was none
    int j = -1;
};

struct Kernels
{
    const char* name;  ///< "plain" or "avx2"
    /// max over the mask of H(i + di, j + dj) - underside(di, dj); very low where the mask meets no node.
    float (*highestAtNode)(HeightView top, const drilling::BurMask& mask, int i, int j) noexcept;
    /// min over the mask of bottom(i + di, j + dj) - upperSide(di, dj); very high where the mask meets no node.
    float (*lowestAtNode)(HeightView bottom, const drilling::BurMask& mask, int i, int j) noexcept;
    /// The largest valueOver() of the nodes within the head, p = (u, v) in lattice units, at a point between nodes:
    /// from the top map and from the bottom map. May stop early and return any value above `enough`.
    Peak (*highestAtPoint)(HeightView top, const drilling::BurMask& mask, double cellMm, double u, double v,
                           float enough) noexcept;
    Peak (*lowestAtPoint)(HeightView bottom, const drilling::BurMask& mask, double cellMm, double u, double v,
                          float enough) noexcept;
};

extern const Kernels kPlainKernels;
/// The fastest this processor runs; the plain ones if CUSP_PLAIN_KERNELS is set in the environment (for tests).
[[nodiscard]] const Kernels& kernels();

}  // namespace core::contact
