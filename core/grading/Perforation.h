// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/grading/IdealCavity.h"
#include "core/terrain/Tooth.h"

namespace core::grading {

/// Marks the columns of unwanted holes through the tooth (terrain::perforations) with 1, [side * side]; may be empty if
/// there is none. A box opens to the proximal surface: columns that it cuts through, columns that it cuts less than 0.5
/// mm from the outside of the tooth, and columns connected with them along edges, are no perforation while a shell is
/// left around them.
/// @param ideal  the surface to be cut, over the tooth's grid; null: every hole counts
[[nodiscard]] std::vector<std::uint8_t> perforationsBeside(const terrain::Tooth& tooth, const IdealTop& ideal);

}  // namespace core::grading
