// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/simulated/BurFootprint.h"

#include <cmath>

namespace haptics {

std::vector<FootprintPart> footprint(const core::bur::Bur& bur, const core::terrain::Grid& grid)
{
    const int span = static_cast<int>(std::floor(bur.headRadiusMm / grid.cellMm));
    std::vector<FootprintPart> parts;
    for (int j = -span; j <= span; ++j)
        for (int i = -span; i <= span; ++i)
            if (const double radius = grid.cellMm * std::sqrt(i * i + j * j); radius <= bur.headRadiusMm)
                parts.push_back({i, j, static_cast<float>(bur.undersideMm(radius))});
    return parts;
}

}  // namespace haptics
