// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/servo/ServoTick.h"
#include "core/terrain/Tooth.h"

namespace lab {

/// How much the force of a spring of 1 N/mm changes in one tick, N.
struct ForceChange
{
    double xMm = 0.0;      ///< of the hand
    double feltN = 0.0;    ///< of the force that the device gets
    double springN = 0.0;  ///< of the spring alone
};

/// Where the lines of forceChanges() lie on a molar, y in mm: the middle one runs along its fossa, the others up and
/// down its cusps.
inline constexpr std::array kSmoothnessLinesMm{-1.0, -0.5, 0.0, 0.5, 1.0};
inline constexpr double kSmoothnessReachMm = 3.0;
inline constexpr double kSmoothnessDepthMm = 0.3;
inline constexpr double kSmoothnessMmPerS = 50.0;
inline constexpr std::size_t kSmoothnessBur = 1;  ///< the pear No. 330

/// Leads a hand along a line of the crown, from x = -kSmoothnessReachMm to +kSmoothnessReachMm with kSmoothnessMmPerS,
/// and says how the force changes from tick to tick. The hand stays kSmoothnessDepthMm below the height at which the
/// bur would slide over the tooth; nothing stops it. The drill is off, the device reads exactly. 1 kHz; any thread.
/// Errors: as of makeServoTick().
[[nodiscard]] core::Result<std::vector<ForceChange>>
forceChanges(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, double yMm,
             const core::servo::ServoSettings& settings);

/// The value that 99 of 100 stay under; 0 of none.
[[nodiscard]] double percentile99(std::vector<double> values);

}  // namespace lab
