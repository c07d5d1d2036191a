// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace core::session {

/// Radius of the sphere around the middle of the work area that the grip of every supported device can reach, mm.
inline constexpr double kHandReachMm = 45.0;

/// Returns the nearest height of the hand from which the whole tooth can be reached, mm. 0 if restMm is not finite.
/// @param restMm  wanted height above the middle of the work area for the top of the tooth
/// @param scale   movement of the hand per movement of the bur
[[nodiscard]] double reachableRestMm(double restMm, double scale) noexcept;

}  // namespace core::session
