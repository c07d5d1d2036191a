// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/contact/LiveTooth.h"

namespace core::contact {

/// Moves an anchor that has tooth above it nearer to the device: beneath an overhang along its underside, and in a
/// notch cut from the side, with floor beneath one part of the bur and overhang above another, column by column
/// (LiveTooth::roomAt).
///
/// Only (x, y) is searched, for over a point the best height is known. Eight directions, steps from about the device's
/// last move down to 1/32 cell; a step that would climb or sink more than four cells a cell is refused (haptics.md
/// 3.2). Servo thread; no allocation.
/// @param movedMm  how far the device moved in this tick
/// @param isStuck  it has found no way for some ticks: begins with wider steps, in all directions
void searchUnderRoof(LiveTooth& tooth, const glm::dvec3& device, double movedMm, bool inNotch, bool isStuck,
                     glm::dvec3& anchor) noexcept;

}  // namespace core::contact
