// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drilling/BurMask.h"

#include <algorithm>
#include <cmath>

namespace core::drilling {
namespace {

/// Samples a side of a rim cell.
constexpr int kRimSamples = 8;

/// Slope at which the head goes on from the part of a rim cell that it covers to the cell's centre, mm a mm: the climb
/// that the anchor search still accepts (haptics.md 3.2).
constexpr double kRimSlope = 4.0;

/// Cells: a head of a whole number of cells must not lose its rim to rounding.
constexpr double kRounding = 1.0e-3;

struct Sample
{
    double underside = BurMask::kAbsent;
    double upperSide = -BurMask::kAbsent;
};

/// The bur over one cell: its centre value inside the head. At the rim, where profiles are steep or end, the lowest
/// reading of any covered point, each raised by kRimSlope on its way to the centre: a wall enters the lattice as a
/// ramp, not a whole cell at a time, and a cell whose centre the head covers never counts less than that centre.
Sample sampleCell(const Bur& bur, double x, double y, double cell)
{
    const double centre = std::sqrt(x * x + y * y);
    Sample sample;
    if (centre <= bur.headRadiusMm)
        sample = {bur.undersideMm(centre), bur.upperSideMm(centre)};
    const double diagonal = 0.7071067811865476 * cell;
    if (centre + diagonal <= bur.headRadiusMm)
        return sample;
    for (int a = 0; a < kRimSamples; ++a) {
        for (int b = 0; b < kRimSamples; ++b) {
            const double du = cell * ((a + 0.5) / kRimSamples - 0.5);
            const double dv = cell * ((b + 0.5) / kRimSamples - 0.5);
            const double r = std::sqrt((x + du) * (x + du) + (y + dv) * (y + dv));
            if (r > bur.headRadiusMm)
                continue;
            const double ramp = kRimSlope * std::sqrt(du * du + dv * dv);
            sample.underside = std::min(sample.underside, bur.undersideMm(r) + ramp);
            sample.upperSide = std::max(sample.upperSide, bur.upperSideMm(r) - ramp);
        }
    }
    return sample;
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
            if (sample.underside >= kAbsent)
                continue;
            const auto row = static_cast<std::size_t>(dj + reach);
            const std::size_t k = row * static_cast<std::size_t>(width) + static_cast<std::size_t>(di + reach);
            underside[k] = static_cast<float>(sample.underside);
            upperSide[k] = static_cast<float>(sample.upperSide);
            halfWidth[row] = std::max(halfWidth[row], std::abs(di));
        }
    }
    const double radius = bur.headRadiusMm / cellMm + kRounding;
    for (int row = 0; row <= radius; ++row)
        spanOfRow.push_back(static_cast<int>(std::ceil(std::sqrt(radius * radius - row * row))));
    while (static_cast<int>(spanOfRow.size()) <= spanOfRow.front())
        spanOfRow.push_back(0);
    underOfR2[kOutside] = kAbsent;
    upperOfR2[kOutside] = -kAbsent;
    for (int step = 0; step <= kTableSteps; ++step) {
        // The middle of the step: a lookup rounds down.
        const double r2 = (step + 0.5) / static_cast<double>(r2ToStep);
        const double r = std::min(std::sqrt(r2), bur.headRadiusMm);
        underOfR2[static_cast<std::size_t>(step)] = static_cast<float>(bur.undersideMm(r));
        upperOfR2[static_cast<std::size_t>(step)] = static_cast<float>(bur.upperSideMm(r));
    }
}

}  // namespace core::drilling
