// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/servo/ServoTick.h"
#include "haptics/simulated/SimulatedFalcon.h"
#include "lab/Contestant.h"

namespace lab {

/// What became of a loop of servo, device and hand in a scene; the worst that is true.
enum class Outcome {
    Holds,       ///< at rest, or following the hand, without a tremble that can be felt
    Buzzes,      ///< trembles by less than kSwingMm, with more than the scene's buzzN between 20 and 300 Hz
    LimitCycle,  ///< swings by more than that and less than kLostMm
    Diverges,    ///< swings by more; or it or its method gives more than kLeakUj in a loop, and what rubs hides it
    Crosses,     ///< went through what should have stopped it, pushed from inside, or is not a number
    Sticks       ///< stays behind the hand where nothing holds it
};
[[nodiscard]] std::string_view nameOf(Outcome outcome);

inline constexpr double kSwingMm = 0.15;
inline constexpr double kLostMm = 2.0;
inline constexpr double kLagMm = 0.1;
inline constexpr double kLeakUj = 1.0;
/// Of a bare spring by the trapezium rule, whose own error over the steps of a lattice is 0.7 uJ.
inline constexpr double kSpringLeakUj = 2.0;

/// Limits of a scene beyond holding (docs/facts/haptics.md, section 4); the figures of StabilityResult may be this
/// large.
struct StabilityBars
{
    double buzzN = 0.05;  ///< above it the outcome is Buzzes
    double swingMm = 1.0e9;
    double rippleN = 1.0e9;
    double jumpN = 1.0e9;
    double lagMm = 1.0e9;
    double errorMm = 1.0e9;
    double settleS = 1.0e9;
    double bounces = 1.0e9;
    double depthMm = 1.0e9;
    double mostN = 1.0e9;
    double mmPerS = 1.0e9;
};

/// One of the scenes of docs/facts/haptics.md, section 4, or a variant of it.
struct StabilitySceneName
{
    int number = 0;  ///< its row in the table there; 0: "slope", the case of section 3.3
    std::string_view name;
    StabilityBars bars;
};
[[nodiscard]] std::span<const StabilitySceneName> stabilityScenesAndBars();

/// The names alone: "push", "impact 50" and so on.
[[nodiscard]] std::span<const std::string_view> stabilityScenes();

struct StabilityTrial
{
    core::servo::ServoSettings settings;  ///< contact method by name: one of contestants()
    haptics::FalconFigures falcon;
    haptics::HandFigures hand = haptics::kHands[1];
    CedsFigures ceds;  ///< of method kCeds2011
};

/// Ripple and lag are taken only while exact geometry would ask the hand for a force that does not change faster than
/// it moves: at rest, and on even ways along what does not change along them. So whatever there is between 20 and 300
/// Hz is the loop's own, or the method's. (tst_stability checks it: with a device that reads exactly and answers at
/// once no scene shows half of what counts as a buzz.)
struct StabilityResult
{
    Outcome outcome = Outcome::Holds;
    std::string_view missed;  ///< first of the scene's bars that was missed: "jump"; empty if none was
    double swingMm = 0.0;     ///< largest peak to peak of the grip along an axis in the last 0.5 s, the hand being
                              ///< still; not along z while the drill is on
    double rippleN = 0.0;     ///< rms of the force between 20 and 300 Hz (Butterworth, 4th and 2nd order)
    double jumpN = 0.0;       ///< largest change of force in a tick, from when the scene counts; not in "impact"
    double lagMm = 0.0;       ///< most of the anchor behind the hand on ways where nothing holds it
    double errorMm = 0.0;     ///< rms of the anchor from where exact geometry has it: push, pit, groove, wall
    double settleS = 0.0;     ///< from the hand's last move, or the first touch of an impact, until the grip stays
                              ///< within 0.05 mm of where it ends; 0 while the drill is on
    int bounces = 0;          ///< times that the bur left the tooth
    /// "loops": energy that a round of the worst circle gave the hand beyond what it took, uJ; negative: it took
    /// (docs/facts/haptics.md, section 2.5). Of the loop as it is, force held from tick to tick;
    double leakUj = 0.0;
    double springLeakUj = 0.0;  ///< and of the method alone: bare spring, trapezium rule
    double depthMm = 0.0;       ///< deepest that was removed
    double mostN = 0.0;         ///< largest force
    double mmPerS = 0.0;        ///< largest speed of the grip, until it is grabbed
};

/// Puts the loop into a scene for some seconds and says what became of it. 1 kHz; seeded, the same every time; any
/// thread. As in the program, the servo loop softens the spring if the device measures more delay than it holds.
/// Errors: UnknownName, or as of makeContestant().
[[nodiscard]] core::Result<StabilityResult> tryStability(std::string_view scene, const StabilityTrial& trial);

}  // namespace lab
