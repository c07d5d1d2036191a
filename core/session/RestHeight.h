// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace core::session {

/// Radius of the ball that the grip of every supported device is sure to reach, around the middle of its work area, mm.
inline constexpr double kHandReachMm = 45.0;

/// Returns the nearest height of the hand at which the whole tooth can still be reached. 0 if it is not finite.
/// @param restMm  above the middle of the work area, for the top of the tooth
/// @param scale   how far the hand moves for one millimetre of the bur
[[nodiscard]] double reachableRestMm(double restMm, double scale) noexcept;

}  // namespace core::session
