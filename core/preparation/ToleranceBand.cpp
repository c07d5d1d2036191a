// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/preparation/ToleranceBand.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core::preparation {
namespace {

using grading::Part;

/// Returns the columns whose far edge is within the reach of the outline: nearer than the tolerance plus half a cell.
std::vector<std::pair<int, int>> discOf(double radiusMm, double cellMm)
{
    const double reach = radiusMm / cellMm + 0.5;
    const int side = static_cast<int>(std::floor(reach));
    std::vector<std::pair<int, int>> disc;
    for (int dj = -side; dj <= side; ++dj)
        for (int di = -side; di <= side; ++di)
            if ((di != 0 || dj != 0) && di * di + dj * dj <= reach * reach)
                disc.emplace_back(di, dj);
    return disc;
}

}  // namespace

ToleranceBand toleranceBand(const terrain::ToothAnatomy& anatomy, const grading::Preparation& ideal, double outlineMm,
                            double depthMm)
{
    const terrain::Grid& grid = anatomy.grid;
    const std::vector<float>& top = *ideal.top;
    const auto depth = static_cast<float>(depthMm);
    const auto disc = discOf(outlineMm, grid.cellMm);
    ToleranceBand band{anatomy.top, anatomy.top};
    const auto isCut = [&](std::size_t k) { return ideal.parts[k] != Part::Keep; };
    // The floor of a hole is the under surface.
    const auto floorOf = [&](std::size_t k) { return std::max(top[k], anatomy.bottom[k]); };
    std::vector<float> highest(grid.count(), terrain::kEmptyTop);
    std::vector<std::uint8_t> besideKept(grid.count(), 0);
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            if (!isCut(k))
                continue;
            highest[k] = std::max(highest[k], floorOf(k));
            band.deepestMm[k] = std::min(band.deepestMm[k], floorOf(k) - depth);
            for (const auto& [di, dj] : disc) {
                if (!grid.contains(i + di, j + dj))
                    continue;
                const std::size_t n = grid.index(i + di, j + dj);
                band.deepestMm[n] = std::min(band.deepestMm[n], floorOf(k) - depth);
                if (isCut(n))
                    highest[n] = std::max(highest[n], floorOf(k));
                else
                    besideKept[k] = 1;
            }
        }
    for (std::size_t k = 0; k < top.size(); ++k) {
        const float uncut = anatomy.top[k];
        if (!(uncut > anatomy.bottom[k])) {
            band.deepestMm[k] = uncut;
            continue;
        }
        band.deepestMm[k] = std::clamp(band.deepestMm[k], anatomy.bottom[k], uncut);
        if (isCut(k) && besideKept[k] == 0)
            band.shallowestMm[k] = std::clamp(highest[k] + depth, anatomy.bottom[k], uncut);
    }
    return band;
}

}  // namespace core::preparation
