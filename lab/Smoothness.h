// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/servo/ServoTick.h"
#include "core/terrain/Tooth.h"

namespace lab {

/// The change of the force of a spring of 1 N/mm in one tick, N.
struct ForceChange
{
    double xMm = 0.0;      ///< position of the hand
    double feltN = 0.0;    ///< change of the force that the device gets
    double springN = 0.0;  ///< change of the spring force alone
};

/// Positions of the lines of forceChanges() on a molar, y in mm: the middle one runs along its fossa, the others over
/// its cusps.
inline constexpr std::array kSmoothnessLinesMm{-1.0, -0.5, 0.0, 0.5, 1.0};
inline constexpr double kSmoothnessReachMm = 3.0;
inline constexpr double kSmoothnessDepthMm = 0.3;
inline constexpr double kSmoothnessMmPerS = 50.0;
inline constexpr std::size_t kSmoothnessBur = 1;  ///< the pear No. 330

/// Leads a hand along a line of the crown, from x = -kSmoothnessReachMm to +kSmoothnessReachMm with kSmoothnessMmPerS,
/// and returns the change of the force from tick to tick. The hand is kSmoothnessDepthMm below the height at which the
/// bur would slide over the tooth; nothing stops it. The drill is off, the device has no quantisation. 1 kHz; any
/// thread. Errors: those of makeServoTick().
[[nodiscard]] core::Result<std::vector<ForceChange>>
forceChanges(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, double yMm,
             const core::servo::ServoSettings& settings);

/// Returns the 99th percentile; 0 without values.
[[nodiscard]] double percentile99(std::vector<double> values);

}  // namespace lab
