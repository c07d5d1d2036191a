// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/grading/IdealCavity.h"
#include "core/terrain/Tooth.h"

namespace core::grading {

/// The columns of holes through the tooth (terrain::perforations) that nobody asked for, 1 each, [side * side]; may be
/// empty if there is none. A box opens to the proximal surface: columns that it cuts through, columns that it cuts less
/// than 0.5 mm from the outside of the tooth, and what hangs together with them along edges, are no perforation while a
/// shell stands around them.
/// @param ideal  what is to be cut, over the tooth's grid; null: every hole counts
[[nodiscard]] std::vector<std::uint8_t> perforationsBeside(const terrain::Tooth& tooth, const IdealTop& ideal);

}  // namespace core::grading
