// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/contact/LiveTooth.h"

namespace core::contact {

struct SearchLimits
{
    bool inNotch = false;   ///< the anchor has some columns beneath it and others above
    bool isStuck = false;   ///< it has found no way for some ticks: begins with wider steps, in all directions
    double steepest = 4.0;  ///< climb or sinking of one step, cells a cell (docs/facts/haptics.md, section 3.2)
};

/// Moves an anchor that has tooth above it nearer to the device: beneath an overhang along its underside, and in a
/// notch cut from the side, with floor beneath one part of the bur and overhang above another, column by column
/// (LiveTooth::roomAt). Also the last resort of an anchor above the tooth that is stuck.
///
/// Only (x, y) is searched, for over a point the best height is known. Eight directions, steps from about the device's
/// last move down to 1/32 cell; a step that would climb or sink more steeply than allowed is refused. Servo thread; no
/// allocation.
/// @param movedMm  how far the device moved in this tick
void searchAround(LiveTooth& tooth, const glm::dvec3& device, double movedMm, const SearchLimits& limits,
                  glm::dvec3& anchor) noexcept;

}  // namespace core::contact
