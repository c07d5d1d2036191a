// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/bur/Bur.h"

namespace core::bur {

/// A bur made ready for one lattice.
///
/// Its underside is a flat disc with a rounded rim, from which a cone may go on, computed; its upper side, which is
/// seldom met, a table over the squared radius. Contact and cutting must agree on both to the bit, or the bur would
/// rest on a column that it does not cut: both take them from core/contact/BurHead.h.
struct BurMask
{
    static constexpr int kTableSteps = 4096;
    /// Stands for "the bur is not there": H - this is lower than any height, empty ones included.
    static constexpr float kAbsent = 4.0e6F;
    /// Stands for the slope of an upright side.
    static constexpr double kUpright = 1.0e9;
    /// Slope of a side that holds as an upright one does: 6 degrees off it.
    static constexpr double kNearlyUpright = 10.0;

    int span = 0;  ///< columns that the head reaches to either side of the lattice cell its axis is in

    float radiusMm = 0.0F;
    float lowestUpperMm = 0.0F;  ///< of upperOfR2
    float r2ToStep = 0.0F;       ///< table steps per mm2
    std::array<float, kTableSteps + 1> upperOfR2{};

    double flatMm = 0.0;     ///< radius of the flat end
    double cornerMm = 0.0;   ///< radius of its rounded rim
    double bendMm = 0.0;     ///< how far beyond the flat end the rim goes: cornerMm where no cone goes on from it
    double coneSlope = 0.0;  ///< of the cone that goes on from there; 0: there is none
    double sideMm = 0.0;     ///< height above the tip from which on the side is upright
    double steepMm = 0.0;    ///< the same where a cone as steep as kNearlyUpright counts as upright

    BurMask(const Bur& bur, double cellMm);

    /// Radius at which the bur stands on a plane that rises by `slope` (>= 0), mm a mm.
    [[nodiscard]] double standsAt(double slope) const noexcept
    {
        return standsOnEdge(slope) ? static_cast<double>(radiusMm)
                                   : flatMm + cornerMm * (slope / std::sqrt(1.0 + slope * slope));
    }
    /// True if the bur stands on such a plane with the upper edge of its cone.
    [[nodiscard]] bool standsOnEdge(double slope) const noexcept { return coneSlope > 0.0 && slope >= coneSlope; }
    /// Height of the underside above the tip at a radius up to radiusMm.
    [[nodiscard]] double heightAt(double radius) const noexcept
    {
        const double out = std::max(0.0, radius - flatMm);
        const double round = std::min(out, bendMm);
        return cornerMm - std::sqrt(cornerMm * cornerMm - round * round) + coneSlope * (out - round);
    }
    /// Slope of the underside there; kUpright at an upright side.
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
    /// Radius up to which the underside is no higher above the tip than `height` (>= 0): radiusMm from sideMm up.
    [[nodiscard]] double reachAt(double height) const noexcept;
    /// Height of the upper side above the tip at a radius up to radiusMm.
    [[nodiscard]] double upperAt(double radius) const noexcept;
};

}  // namespace core::bur
