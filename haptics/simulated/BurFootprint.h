// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/bur/Bur.h"
#include "core/terrain/Grid.h"

namespace haptics {

/// A column that a bur's head stands over.
struct FootprintPart
{
    int i = 0;  ///< columns from the one that the tip is over
    int j = 0;
    float heightMm = 0.0F;  ///< of the head's underside there, above the tip
};

/// All that a bur's head stands over, seen from above; the part below the tip is one of them.
[[nodiscard]] std::vector<FootprintPart> footprint(const core::bur::Bur& bur, const core::terrain::Grid& grid);

}  // namespace haptics
