// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/drilling/Bur.h"

namespace core::drilling {

/// A bur made ready for one lattice.
///
/// Its underside is a flat disc with a rounded rim, computed; its upper side, which is seldom met, a table over the
/// squared radius. Contact and cutting must agree on both to the bit, or the bur would rest on a column that it does
/// not cut: both take them from core/contact/Head.h.
struct BurMask
{
    static constexpr int kTableSteps = 4096;
    /// Stands for "the bur is not there": H - this is lower than any height, empty ones included.
    static constexpr float kAbsent = 4.0e6F;
    /// Stands for the slope of an upright side.
    static constexpr double kUpright = 1.0e9;

    int span = 0;  ///< columns that the head reaches to either side of the lattice cell its axis is in

    float radiusMm = 0.0F;
    float lowestUpperMm = 0.0F;  ///< of upperOfR2
    float r2ToStep = 0.0F;       ///< table steps per mm2
    std::array<float, kTableSteps + 1> upperOfR2{};

    double flatMm = 0.0;    ///< radius of the flat end
    double cornerMm = 0.0;  ///< radius of its rounded rim

    BurMask(const Bur& bur, double cellMm);

    /// Radius at which the bur stands on a plane that rises by `slope` (>= 0), mm a mm.
    [[nodiscard]] double standsAt(double slope) const noexcept
    {
        return flatMm + cornerMm * (slope / std::sqrt(1.0 + slope * slope));
    }
    /// Height of the underside above the tip at a radius up to radiusMm.
    [[nodiscard]] double heightAt(double radius) const noexcept
    {
        const double out = std::max(0.0, radius - flatMm);
        return cornerMm - std::sqrt(std::max(0.0, cornerMm * cornerMm - out * out));
    }
    /// Slope of the underside there; kUpright at the side.
    [[nodiscard]] double slopeAt(double radius) const noexcept
    {
        const double out = radius - flatMm;
        if (!(out > 0.0))
            return 0.0;
        const double down2 = cornerMm * cornerMm - out * out;
        return down2 > 0.0 ? std::min(kUpright, out / std::sqrt(down2)) : kUpright;
    }
    /// Radius up to which the underside is no higher above the tip than `height` (>= 0): radiusMm from the corner up.
    [[nodiscard]] double reachAt(double height) const noexcept;
    /// Height of the upper side above the tip at a radius up to radiusMm.
    [[nodiscard]] double upperAt(double radius) const noexcept;
};

}  // namespace core::drilling
