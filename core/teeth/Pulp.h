// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/teeth/TissueFigures.h"
#include "core/terrain/Grid.h"
#include "core/terrain/Tooth.h"

namespace core::teeth {

/// Adds the pulp to layers that already have their enamel-dentin junction: a chamber as wide as the cervix minus its
/// dentin wall, a horn under each cusp, and canals as far as vertical columns can follow them. At least 1 mm of dentin
/// stays on every side; a tooth without room for that has no pulp. If the model is cut off flat (a scan of a crown),
/// the pulp continues to the cut; if that is above the chamber's roof, there is none.
///
/// @param cervixMm  height of the cemento-enamel junction over each node, [side * side]
void hollowPulp(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
                std::span<const float> cervixMm, const TissueFigures& figures, std::uint64_t seed,
                std::vector<terrain::ColumnLayers>& layers);

}  // namespace core::teeth
