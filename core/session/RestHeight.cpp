// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/RestHeight.h"

#include <algorithm>
#include <cmath>

namespace core::session {
namespace {

// Space that a hand needs around the middle of the top of a tooth: beside, above and below it, in mm of the bur.
constexpr double kBesideMm = 8.0;
constexpr double kAboveMm = 6.0;
constexpr double kBelowMm = 9.0;

}  // namespace

double reachableRestMm(double restMm, double scale) noexcept
{
    if (!std::isfinite(restMm) || !std::isfinite(scale))
        return 0.0;
    const double beside = scale * kBesideMm;
    const double half = std::sqrt(std::max(0.0, kHandReachMm * kHandReachMm - beside * beside));
    const double lowest = std::min(0.0, scale * kBelowMm - half);
    const double highest = std::max(0.0, half - scale * kAboveMm);
    return std::clamp(restMm, lowest, highest);
}

}  // namespace core::session
