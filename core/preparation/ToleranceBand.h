// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/grading/Preparation.h"
#include "core/terrain/Tooth.h"

namespace core::preparation {

/// The range of a tolerance on a tooth: the two surfaces between which a cut is within it.
struct ToleranceBand
{
    std::vector<float> shallowestMm;  ///< [side * side]; a higher surface is cut too little
    std::vector<float> deepestMm;     ///< [side * side]; a lower surface is cut too much
};

/// Returns the range of the ideal with its outline moved in and out by `outlineMm` and its surface moved up and down by
/// `depthMm`: for each column the highest and the lowest result, never above the uncut tooth nor below its under
/// surface. An edge of the ideal is midway between two columns.
///
/// About 2 ms for a Class I at 150 x 150 and 0.3 mm, in proportion to the fourth power of the grid's side. Any thread.
/// @param outlineMm, depthMm  0 or more
[[nodiscard]] ToleranceBand toleranceBand(const terrain::ToothAnatomy& anatomy, const grading::Preparation& ideal,
                                          double outlineMm, double depthMm);

}  // namespace core::preparation
