// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace core::tracking {

/// Rotation and shift of the view by the head, relative to the view set with the mouse.
struct Lean
{
    double yawDeg = 0.0;    ///< the eye moves to the right
    double pitchDeg = 0.0;  ///< the eye moves up
    double farther = 1.0;   ///< factor of the distance
    /// Shift of the eye while the middle of the screen stays in place, because the screen is a window. Shares of the
    /// distance.
    double rightShare = 0.0;
    double upShare = 0.0;
    bool operator==(const Lean&) const = default;
};

}  // namespace core::tracking
