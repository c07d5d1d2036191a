// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/terrain/Grid.h"

namespace ui::render {

/// Returns the heights of the enamel-dentin junction for drawing. In columns that are all enamel the junction may be at
/// any height below them. There it is extended from the line where the enamel ends, so that the thickness of the enamel
/// grows evenly from 0. That line is between the last column with dentin and the first one without. On a steep neck the
/// heights of these two differ by millimetres, so the height of the line follows from all columns near it together.
/// Within a few nodes of the line the junction follows the line.
///
/// @param tops, bottoms  of the uncut tooth, mm, [side * side]; empty where top <= bottom
/// @param junction       its heights, at or below the bottom in columns that are all enamel
[[nodiscard]] std::vector<float> drawnJunction(const core::terrain::Grid& lattice, const std::vector<float>& tops,
                                               const std::vector<float>& bottoms, std::vector<float> junction);

}  // namespace ui::render
