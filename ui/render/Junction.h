// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/terrain/Grid.h"

namespace ui::render {

/// Returns the heights of the enamel-dentin junction for drawing. In columns that are all enamel the junction may have
/// any height below them. There it is extended from the line where the enamel ends, so that the enamel begins there
/// with no thickness and grows evenly. That line is between the last column with dentin and the first without, which on
/// a steep neck are millimetres apart in height. No two columns give its height, but all columns near it together do.
/// Within a few nodes the junction follows the line, wherever between two columns it climbs the neck.
///
/// @param tops, bottoms  of the uncut tooth, mm, [side * side]; empty where top <= bottom
/// @param junction       its heights, at or below the bottom in columns that are all enamel
[[nodiscard]] std::vector<float> drawnJunction(const core::terrain::Grid& lattice, const std::vector<float>& tops,
                                               const std::vector<float>& bottoms, std::vector<float> junction);

}  // namespace ui::render
