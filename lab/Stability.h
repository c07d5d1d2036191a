// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/servo/ServoTick.h"
#include "haptics/simulated/SimulatedFalcon.h"
#include "lab/Contestant.h"

namespace lab {

/// The outcome of servo, device and hand in a scene; the worst that applies.
enum class Outcome {
    Holds,       ///< at rest, or following the hand, without a noticeable tremble
    Buzzes,      ///< trembles by less than kSwingMm, with more than the scene's buzzN between 20 and 300 Hz
    LimitCycle,  ///< swings by more than that and less than kLostMm
    Diverges,    ///< swings by more; or the loop or its method adds more than kLeakUj per round, which friction hides
    Crosses,     ///< crossed an obstacle, pushed from inside, or has values that are not numbers
    Sticks       ///< stays behind the hand where it is free
};
[[nodiscard]] std::string_view nameOf(Outcome outcome);

inline constexpr double kSwingMm = 0.15;
inline constexpr double kLostMm = 2.0;
inline constexpr double kLagMm = 0.1;
inline constexpr double kLeakUj = 1.0;
/// Limit for a bare spring by the trapezium rule, whose own error over the steps of a lattice is 0.7 uJ.
inline constexpr double kSpringLeakUj = 2.0;

/// Limits of a scene besides stability (docs/facts/haptics.md, section 4): the largest allowed values of
/// StabilityResult.
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
    int number = 0;  ///< row in the table there; 0: "slope", the case of section 3.3
    std::string_view name;
    StabilityBars bars;
};
[[nodiscard]] std::span<const StabilitySceneName> stabilityScenesAndBars();

/// Returns the names alone: "push", "impact 50" and so on.
[[nodiscard]] std::span<const std::string_view> stabilityScenes();

struct StabilityTrial
{
    core::servo::ServoSettings settings;  ///< contact method by name: one of contestants()
    haptics::FalconFigures falcon;
    haptics::HandFigures hand = haptics::kHands[1];
    CedsFigures ceds;  ///< for method kCeds2011
};

/// The results of a trial. Ripple and lag are measured only while the exact force would not change faster than the hand
/// moves: at rest, and on even paths along ground that does not change. So any power between 20 and 300 Hz is that of
/// the loop or the method. (tst_stability checks it: with a device without quantisation and delay no scene has half of
/// what counts as a buzz.)
struct StabilityResult
{
    Outcome outcome = Outcome::Holds;
    std::string_view missed;  ///< first of the scene's limits that was exceeded: "jump"; empty if none was
    double swingMm = 0.0;     ///< largest peak to peak of the grip along an axis in the last 0.5 s, with the hand
                              ///< still; not along z while the drill is on
    double rippleN = 0.0;     ///< rms of the force between 20 and 300 Hz (Butterworth, 4th and 2nd order)
    double jumpN = 0.0;       ///< largest change of force in a tick, from the time at which the scene counts; not in
                              ///< "impact"
    double lagMm = 0.0;       ///< largest distance of the anchor behind the hand on free paths
    double errorMm = 0.0;     ///< rms of the anchor from its exact position: push, pit, groove, wall
    double settleS = 0.0;     ///< from the hand's last move, or the first touch of an impact, until the grip stays
                              ///< within 0.05 mm of its end; 0 while the drill is on
    int bounces = 0;          ///< number of times that the bur left the tooth
    /// "loops": energy that a round of the worst circle gave the hand beyond what it took, uJ; negative: it took energy
    /// (docs/facts/haptics.md, section 2.5). For the real loop, with the force held between ticks.
    double leakUj = 0.0;
    double springLeakUj = 0.0;  ///< likewise for the method alone: bare spring, trapezium rule
    double depthMm = 0.0;       ///< largest depth that was removed
    double mostN = 0.0;         ///< largest force
    double mmPerS = 0.0;        ///< largest speed of the grip, until the hand holds it
};

/// Runs the loop in a scene for some seconds and returns the outcome. 1 kHz; seeded, the same every time; any thread.
/// As in the program, the servo loop softens the spring if the device measures too much delay. Errors: UnknownName, or
/// those of makeContestant().
[[nodiscard]] core::Result<StabilityResult> tryStability(std::string_view scene, const StabilityTrial& trial);

}  // namespace lab
