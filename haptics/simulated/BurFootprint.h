// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/bur/Bur.h"
#include "core/terrain/Grid.h"

namespace haptics {

/// A column below a bur's head.
struct FootprintPart
{
    int i = 0;  ///< offset from the column below the tip
    int j = 0;
    float heightMm = 0.0F;  ///< of the head's underside above the tip
};

/// Returns all columns below a bur's head, including that below the tip.
[[nodiscard]] std::vector<FootprintPart> footprint(const core::bur::Bur& bur, const core::terrain::Grid& grid);

}  // namespace haptics
