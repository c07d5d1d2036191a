// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drilling/BurMask.h"

#include <algorithm>
#include <cmath>

namespace core::drilling {
namespace {

/// Cells: a head of a whole number of cells must not lose its rim to rounding.
constexpr double kRounding = 1.0e-3;

}  // namespace

BurMask::BurMask(const Bur& bur, double cellMm)
    : span(static_cast<int>(std::ceil(bur.headRadiusMm / cellMm + kRounding))),
      radiusMm(static_cast<float>(bur.headRadiusMm)),
      r2ToStep(static_cast<float>(kTableSteps / (bur.headRadiusMm * bur.headRadiusMm))), flatMm(bur.flatRadiusMm()),
      cornerMm(bur.cornerMm)
{
    for (int step = 0; step <= kTableSteps; ++step) {
        // The middle of the step: a lookup rounds down.
        const double r2 = (step + 0.5) / static_cast<double>(r2ToStep);
        const double r = std::min(std::sqrt(r2), bur.headRadiusMm);
        upperOfR2[static_cast<std::size_t>(step)] = static_cast<float>(bur.upperSideMm(r));
    }
    lowestUpperMm = *std::min_element(upperOfR2.begin(), upperOfR2.end());
}

double BurMask::standsAt(double slope) const noexcept
{
    return flatMm + cornerMm * (slope / std::sqrt(1.0 + slope * slope));
}

double BurMask::heightAt(double radius) const noexcept
{
    const double out = std::max(0.0, radius - flatMm);
    return cornerMm - std::sqrt(std::max(0.0, cornerMm * cornerMm - out * out));
}

double BurMask::slopeAt(double radius) const noexcept
{
    const double out = radius - flatMm;
    if (!(out > 0.0))
        return 0.0;
    const double down2 = cornerMm * cornerMm - out * out;
    return down2 > 0.0 ? std::min(kUpright, out / std::sqrt(down2)) : kUpright;
}

}  // namespace core::drilling
