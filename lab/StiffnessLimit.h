// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/servo/ServoTick.h"
#include "haptics/simulated/SimulatedFalcon.h"
#include "lab/Contestant.h"

namespace lab {

/// A servo, a device and a hand that act on each other.
struct ClosedLoop
{
    core::servo::ServoSettings settings;  ///< contact method by name: one of contestants()
    haptics::FalconFigures falcon;
    haptics::HandFigures hand = haptics::kHands[1];
    double rateHz = 1000.0;
    CedsFigures ceds;  ///< of method kCeds2011
};

inline constexpr double kSoftestNPerMm = 0.1;
inline constexpr double kStiffestNPerMm = 40.0;

/// K_max: up to which stiffness of the force law, N/mm, whatever the settings say, the loop comes to rest on a flat
/// tooth; to 2 %, by steps of a fifth and then by bisection. kStiffestNPerMm if even that holds, 0 if kSoftestNPerMm
/// does not.
///
/// As docs/facts/haptics.md, section 2.2: the hand throws the bur at the tooth with 50 mm/s from 2 mm above and leans
/// on it with 2 N; at rest is a grip that moves less than 0.15 mm from peak to peak along every axis in the last 0.5 s
/// of 2 s. The drill is off, and the hand neither trembles nor drifts. The device does not tell its delay: no loop
/// softens its spring.
[[nodiscard]] core::Result<double> stiffnessLimit(const ClosedLoop& loop);

}  // namespace lab
