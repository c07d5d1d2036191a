// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drilling/BurMask.h"

#include <algorithm>
#include <cmath>

namespace core::drilling {
namespace {

/// Samples a side of a rim cell.
constexpr int kRimSamples = 8;

/// Slope given to the part of a rim cell that the head does not cover, cells per cell: the climb that the anchor search
/// still accepts (haptics.md 3.2).
constexpr double kRimSlope = 4.0;

struct Sample
{
    double underside = 0.0;
    double upperSide = 0.0;
    double share = 0.0;
};

/// The bur over one cell: its centre value inside the head, an average over the covered part at the rim.
Sample sampleCell(const Bur& bur, double x, double y, double cell)
{
    const double centre = std::sqrt(x * x + y * y);
    const double diagonal = 0.7071067811865476 * cell;
    if (centre + diagonal <= bur.headRadiusMm)
        return {bur.undersideMm(centre), bur.upperSideMm(centre), 1.0};
    Sample sum;
    int covered = 0;
    for (int a = 0; a < kRimSamples; ++a) {
        for (int b = 0; b < kRimSamples; ++b) {
            const double u = x + cell * ((a + 0.5) / kRimSamples - 0.5);
            const double v = y + cell * ((b + 0.5) / kRimSamples - 0.5);
            const double r = std::sqrt(u * u + v * v);
            if (r > bur.headRadiusMm)
                continue;
            ++covered;
            sum.underside += bur.undersideMm(r);
            sum.upperSide += bur.upperSideMm(r);
        }
    }
    if (covered == 0)
        return sum;
    sum.share = static_cast<double>(covered) / (kRimSamples * kRimSamples);
    sum.underside = sum.underside / covered + (1.0 - sum.share) * kRimSlope * cell;
    sum.upperSide = sum.upperSide / covered;
    return sum;
}

}  // namespace

BurMask::BurMask(const Bur& bur, double cellMm)
    : reach(static_cast<int>(std::ceil(bur.headRadiusMm / cellMm + 0.5))), width(2 * reach + 1),
      underside(static_cast<std::size_t>(width) * static_cast<std::size_t>(width), kAbsent),
      upperSide(underside.size(), -kAbsent), halfWidth(static_cast<std::size_t>(width), -1),
      radiusMm(static_cast<float>(bur.headRadiusMm)),
      r2ToStep(static_cast<float>(kTableSteps / (bur.headRadiusMm * bur.headRadiusMm)))
{
    for (int dj = -reach; dj <= reach; ++dj) {
        for (int di = -reach; di <= reach; ++di) {
            const Sample sample = sampleCell(bur, di * cellMm, dj * cellMm, cellMm);
            // A sliver of a cell is left to its neighbour: half of it is the rule that keeps the mean radius.
            if (sample.share < 0.5)
                continue;
            const auto row = static_cast<std::size_t>(dj + reach);
            const std::size_t k = row * static_cast<std::size_t>(width) + static_cast<std::size_t>(di + reach);
            underside[k] = static_cast<float>(sample.underside);
            upperSide[k] = static_cast<float>(sample.upperSide);
            halfWidth[row] = std::max(halfWidth[row], std::abs(di));
        }
    }
    for (int step = 0; step <= kTableSteps; ++step) {
        // The middle of the step: a lookup rounds down.
        const double r2 = (step + 0.5) / static_cast<double>(r2ToStep);
        const double r = std::min(std::sqrt(r2), bur.headRadiusMm);
        underOfR2[static_cast<std::size_t>(step)] = static_cast<float>(bur.undersideMm(r));
        upperOfR2[static_cast<std::size_t>(step)] = static_cast<float>(bur.upperSideMm(r));
    }
}

}  // namespace core::drilling
