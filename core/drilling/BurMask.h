// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/drilling/Bur.h"

namespace core::drilling {

/// A bur sampled for one lattice, in the two forms that contact and cutting need.
///
/// `underside` holds the bur centred on a node, row by row, for clearances at nodes. Rim cells, through which the edge
/// of the head runs, are supersampled: the covered part goes on to the cell's centre as a ramp, so that a flat end does
/// not enter the lattice a whole cell at a time.
/// `underOfR2` and `upperOfR2` hold the same profiles over the squared radius, for a bur between nodes: one table
/// lookup a column, no square root. 4096 steps leave 0.1 um at the tip of a ball of 0.5 mm. Steps up to kTableSteps are
/// under the head, kOutside stands for all beyond: contact and cutting must agree on that to the bit, or the bur would
/// rest on a column that it does not cut.
struct BurMask
{
    static constexpr int kTableSteps = 4096;
    static constexpr int kOutside = kTableSteps + 1;
    /// Stands for "the bur is not there" in `underside`: H - this is lower than any height, empty ones included.
    static constexpr float kAbsent = 4.0e6F;

    int reach = 0;                 ///< cells from the centre to the last column
    int width = 0;                 ///< 2 * reach + 1
    std::vector<float> underside;  ///< [width * width], mm above the tip, kAbsent outside the head
    std::vector<float> upperSide;  ///< [width * width], mm above the tip, -kAbsent outside the head
    std::vector<int> halfWidth;    ///< [width], cells the head reaches to either side in a row

    /// Columns that the head reaches to either side, in a row so many rows from the lattice cell its axis is in.
    std::vector<int> spanOfRow;

    float radiusMm = 0.0F;
    float r2ToStep = 0.0F;  ///< table steps per mm2
    std::array<float, kOutside + 1> underOfR2{};
    std::array<float, kOutside + 1> upperOfR2{};

    BurMask(const Bur& bur, double cellMm);
};

}  // namespace core::drilling
