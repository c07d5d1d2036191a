// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/session/ServoTick.h"
#include "haptics/simulated/SimulatedFalcon.h"

namespace lab {

/// What became of a loop of servo, device and hand in a scene.
enum class Outcome {
    Holds,       ///< at rest, or following the hand, without a tremble that can be felt
    Buzzes,      ///< trembles by less than kSwingMm, with more than kBuzzN between 20 and 300 Hz
    LimitCycle,  ///< swings by more than that and less than kLostMm
    Diverges,    ///< swings by more
    Crosses,     ///< went through what it should have been stopped by
    Sticks       ///< stays behind the hand where nothing holds it
};
[[nodiscard]] std::string_view nameOf(Outcome outcome);

inline constexpr double kBuzzN = 0.05;
inline constexpr double kSwingMm = 0.15;
inline constexpr double kLostMm = 2.0;

/// The scenes of haptics.md section 4 that a bur on a tooth can be put into, by name: "push", "impact", "pit",
/// "groove", "wall", "ridge", "step", "brush", "drill", "dropout", "inside".
[[nodiscard]] std::span<const std::string_view> stabilityScenes();

struct StabilityTrial
{
    core::session::ServoSettings settings;  ///< contact method by name
    haptics::FalconFigures falcon;
    haptics::HandFigures hand = haptics::kHands[1];
};

struct StabilityResult
{
    Outcome outcome = Outcome::Holds;
    double swingMm = 0.0;  ///< largest peak to peak of the grip along an axis, beyond what the hand wanted, at the end
    double rippleN = 0.0;  ///< rms of the force between 20 and 300 Hz, at the end
    double jumpN = 0.0;    ///< largest change of force in a tick
    double lagMm = 0.0;    ///< of the anchor behind the grip, along the hand's way, at the end
};

/// Puts the loop into a scene for some seconds and says what became of it. 1 kHz; seeded, the same every time. As in
/// the program, the servo loop softens the spring if the device measures more delay than it holds.
[[nodiscard]] core::Result<StabilityResult> tryStability(std::string_view scene, const StabilityTrial& trial);

}  // namespace lab
