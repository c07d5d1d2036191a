// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/servo/ServoTick.h"
#include "haptics/simulated/SimulatedFalcon.h"
#include "lab/Contestant.h"

namespace lab {

/// A servo, a device and a hand in a closed loop.
struct ClosedLoop
{
    core::servo::ServoSettings settings;  ///< contact method by name: one of contestants()
    haptics::FalconFigures falcon;
    haptics::HandFigures hand = haptics::kHands[1];
    double rateHz = 1000.0;
    CedsFigures ceds;  ///< for method kCeds2011
};

inline constexpr double kSoftestNPerMm = 0.1;
inline constexpr double kStiffestNPerMm = 40.0;

/// Returns K_max: the largest stiffness of the force law, N/mm, whatever that of the settings, at which the loop comes
/// to rest on a flat tooth; to 2 %, by steps of a fifth and then by bisection. kStiffestNPerMm if even that is stable,
/// 0 if kSoftestNPerMm is not.
///
/// As in docs/facts/haptics.md, section 2.2: the hand throws the bur at the tooth with 50 mm/s from 2 mm above and
/// presses on it with 2 N; at rest means that the grip moves less than 0.15 mm from peak to peak along every axis in
/// the last 0.5 s of 2 s. The drill is off, and the hand neither trembles nor drifts. The device does not report its
/// delay, so that the loop does not soften its spring.
[[nodiscard]] core::Result<double> stiffnessLimit(const ClosedLoop& loop);

}  // namespace lab
