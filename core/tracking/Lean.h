// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace core::tracking {

/// Turn and shift of the view by the head, relative to the view that the mouse chose.
struct Lean
{
    double yawDeg = 0.0;    ///< the eye goes to the right
    double pitchDeg = 0.0;  ///< the eye goes up
    double farther = 1.0;   ///< factor of the distance
    /// Move the eye beside the middle of the screen, which stays in its place: the screen is a window. Shares of the
    /// distance.
    double rightShare = 0.0;
    double upShare = 0.0;
    bool operator==(const Lean&) const = default;
};

}  // namespace core::tracking
