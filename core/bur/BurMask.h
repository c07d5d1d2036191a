// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/bur/Bur.h"

namespace core::bur {

/// A bur prepared for one lattice.
///
/// The underside is a flat disc with a rounded rim and perhaps a cone, and is computed; the upper side, which is rarely
/// needed, is a table over the squared radius. Contact and cutting must agree on both bit for bit, or the bur would
/// rest on a column that it does not cut: both use core/contact/BurHead.h.
struct BurMask
{
    static constexpr int kTableSteps = 4096;
    /// Value for "no bur here": H minus this is lower than any height, including empty ones.
    static constexpr float kAbsent = 4.0e6F;
    /// Value for the slope of an upright side.
    static constexpr double kUpright = 1.0e9;
    /// Slope from which on a side acts like an upright one: 6 degrees off it.
    static constexpr double kNearlyUpright = 10.0;

    int span = 0;  ///< columns that the head covers on either side of the lattice cell of its axis

    float radiusMm = 0.0F;
    float lowestUpperMm = 0.0F;  ///< minimum of upperOfR2
    float r2ToStep = 0.0F;       ///< table steps per mm2
    std::array<float, kTableSteps + 1> upperOfR2{};

    double flatMm = 0.0;     ///< radius of the flat end
    double cornerMm = 0.0;   ///< radius of its rounded rim
    double bendMm = 0.0;     ///< width of the rim beyond the flat end: cornerMm if there is no cone
    double coneSlope = 0.0;  ///< slope of the cone that adjoins the rim; 0: none
    double sideMm = 0.0;     ///< height above the tip from which on the side is upright
    double steepMm = 0.0;    ///< the same if a cone as steep as kNearlyUpright counts as upright

    BurMask(const Bur& bur, double cellMm);

    /// Returns the radius at which the bur touches a plane with slope `slope` (>= 0), mm per mm.
    [[nodiscard]] double standsAt(double slope) const noexcept
    {
        return standsOnEdge(slope) ? static_cast<double>(radiusMm)
                                   : flatMm + cornerMm * (slope / std::sqrt(1.0 + slope * slope));
    }
    /// Returns whether the bur touches such a plane with the upper edge of its cone.
    [[nodiscard]] bool standsOnEdge(double slope) const noexcept { return coneSlope > 0.0 && slope >= coneSlope; }
    /// Returns the height of the underside above the tip at a radius up to radiusMm.
    [[nodiscard]] double heightAt(double radius) const noexcept
    {
        const double out = std::max(0.0, radius - flatMm);
        const double round = std::min(out, bendMm);
        return cornerMm - std::sqrt(cornerMm * cornerMm - round * round) + coneSlope * (out - round);
    }
    /// Returns the slope of the underside at a radius; kUpright at an upright side.
    [[nodiscard]] double slopeAt(double radius) const noexcept
    {
        const double out = radius - flatMm;
        if (!(out > 0.0))
            return 0.0;
        if (coneSlope > 0.0 && out >= bendMm)
            return coneSlope;
        const double down2 = cornerMm * cornerMm - out * out;
        return down2 > 0.0 ? std::min(kUpright, out / std::sqrt(down2)) : kUpright;
    }
    /// Returns the radius up to which the underside is no higher above the tip than `height` (>= 0); radiusMm from
    /// sideMm on.
    [[nodiscard]] double reachAt(double height) const noexcept;
    /// Returns the height of the upper side above the tip at a radius up to radiusMm.
    [[nodiscard]] double upperAt(double radius) const noexcept;
};

}  // namespace core::bur
