// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/contact/LiveTooth.h"

namespace core::contact {

struct SearchLimits
{
    bool inNotch = false;   ///< the anchor is above some columns and below others
    bool isStuck = false;   ///< the slide has been blocked for some ticks: begins with wider steps, in all directions
    double steepest = 4.0;  ///< largest climb or descent of one step, cells per cell (docs/facts/haptics.md, section
                            ///< 3.2)
};

/// Moves an anchor below overhanging tooth nearer to the device: along the underside of an overhang, and in a notch cut
/// from the side, with floor below one part of the bur and overhang above another, column by column
/// (LiveTooth::roomAt). Also the last resort for a blocked anchor above the tooth.
///
/// Searches in (x, y) only, because the best height at a point is known. Eight directions, steps from about the
/// device's last move down to 1/32 cell; a step that climbs or descends too steeply is refused. Servo thread; no
/// allocation.
/// @param movedMm  movement of the device in this tick
void searchAround(LiveTooth& tooth, const glm::dvec3& device, double movedMm, const SearchLimits& limits,
                  glm::dvec3& anchor) noexcept;

}  // namespace core::contact
