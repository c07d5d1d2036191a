// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bur/BurMask.h"

#include <algorithm>
#include <cmath>

namespace core::bur {
namespace {

/// In cells. Without it, rounding could remove the rim of a head that is a whole number of cells wide.
constexpr double kRounding = 1.0e-3;

}  // namespace

BurMask::BurMask(const Bur& bur, double cellMm)
    : span(static_cast<int>(std::ceil(bur.headRadiusMm / cellMm + kRounding))),
      radiusMm(static_cast<float>(bur.headRadiusMm)),
      r2ToStep(static_cast<float>(kTableSteps / (bur.headRadiusMm * bur.headRadiusMm))), flatMm(bur.flatRadiusMm()),
      cornerMm(bur.cornerMm), bendMm(bur.bendMm()), coneSlope(bur.coneSlope),
      sideMm(bur.hasCone() ? heightAt(bur.headRadiusMm) : bur.cornerMm),
      steepMm(bur.coneSlope >= kNearlyUpright ? heightAt(flatMm + bendMm) : sideMm)
{
    for (int step = 0; step <= kTableSteps; ++step) {
        // Uses the middle of the step, because a lookup rounds down.
        const double r2 = (step + 0.5) / static_cast<double>(r2ToStep);
        const double r = std::min(std::sqrt(r2), bur.headRadiusMm);
        upperOfR2[static_cast<std::size_t>(step)] = static_cast<float>(bur.upperSideMm(r));
    }
    lowestUpperMm = *std::min_element(upperOfR2.begin(), upperOfR2.end());
}

double BurMask::reachAt(double height) const noexcept
{
    if (height >= sideMm)
        return static_cast<double>(radiusMm);
    const double bend = heightAt(flatMm + bendMm);
    if (coneSlope > 0.0 && height > bend)
        return std::min(static_cast<double>(radiusMm), flatMm + bendMm + (height - bend) / coneSlope);
    const double down = cornerMm - height;
    return flatMm + std::sqrt(std::max(0.0, cornerMm * cornerMm - down * down));
}

double BurMask::upperAt(double radius) const noexcept
{
    const double step = radius * radius * static_cast<double>(r2ToStep);
    return static_cast<double>(upperOfR2[static_cast<std::size_t>(std::min(step, static_cast<double>(kTableSteps)))]);
}

}  // namespace core::bur
