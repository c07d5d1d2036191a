// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/recording/Recording.h"
#include "core/servo/ServoState.h"
#include "core/servo/ServoTick.h"
#include "haptics/HapticDevice.h"
#include "haptics/simulated/TickTimes.h"

namespace haptics {

/// Returns the processor time of the calling thread, microseconds: the cost of a tick regardless of other load.
[[nodiscard]] double threadCpuUs();

struct SimulationOptions
{
    core::servo::ServoSettings settings;
    std::size_t burIndex = 1;  ///< 330
    double rateHz = 1000.0;
    std::string lesson;   ///< the lesson of the attempt, for the recording; may be empty
    bool record = false;  ///< stores a recording, which grows with every tick
    std::function<void(const core::servo::TilePatch&)> onPatch;  ///< called with each cut tile; may be empty
};

struct SimulationOutcome
{
    core::terrain::Tooth tooth;
    core::servo::ServoState last;
    std::optional<core::recording::Recording> recording;  ///< if one was requested
    std::unique_ptr<TickTimes> tickTimes;                 ///< thread CPU time of each tick
};

/// Runs the servo and session loops with a device in this thread, as fast as possible. Without a recording its memory
/// does not grow with the number of ticks.
/// @param ticks   largest number of ticks
/// @param before  called before each tick with its number; may steer the device; returns whether the drill is on, or
///                empty to stop
/// @param after   called after each tick with its number and the servo's state; may be empty
[[nodiscard]] core::Result<SimulationOutcome>
simulate(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, HapticDevice& device, std::uint64_t ticks,
         const SimulationOptions& options,
         const std::function<std::optional<bool>(std::uint64_t tick, const core::servo::ServoState& state,
                                                 const core::terrain::Tooth& tooth)>& before,
         const std::function<void(std::uint64_t tick, const core::servo::ServoState& state)>& after);

}  // namespace haptics
