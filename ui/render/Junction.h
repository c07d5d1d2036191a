// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/terrain/Grid.h"

namespace ui::render {

/// The enamel-dentin junction as it is drawn. In columns of enamel alone it may lie anywhere below, and there it is
/// carried on from the line where enamel ends: so enamel begins there with no thickness and grows from it evenly. That
/// line runs between the last column with dentin and the first without, which on a steep neck are millimetres apart;
/// how high it is no two of them tell, but all near it do. Within a few nodes of it the junction keeps to the line,
/// wherever between two columns it has climbed the neck.
///
/// @param tops, bottoms  of the uncut tooth, mm, [side * side]; empty where top <= bottom
/// @param junction       heights of it, at or below the bottom in enamel alone
[[nodiscard]] std::vector<float> drawnJunction(const core::terrain::Grid& lattice, const std::vector<float>& tops,
                                               const std::vector<float>& bottoms, std::vector<float> junction);

}  // namespace ui::render
