// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/simulated/IdealHand.h"
#include "haptics/simulated/Simulation.h"
#include "lessons/Assignment.h"

namespace app {

/// Returns a simulated hand that cuts the ideal of an assignment. If there is no ideal, the hand cuts about the
/// smallest cavity that removes the decay.
/// @param burIndex  index of the bur in core::bur::burs()
[[nodiscard]] haptics::IdealHand handFor(const lessons::Assignment& assignment, std::size_t burIndex);

/// Simulates an attempt at an assignment by such a hand with the first allowed bur. The same assignment gives the same
/// recording. Takes a second or two; any thread that may wait. Error: WrongKind for an exercise in which nothing is
/// cut.
/// @param simulatedFalcon  whether the hand uses a simulated Falcon instead of a pointer
[[nodiscard]] core::Result<haptics::SimulationOutcome> demonstrate(const lessons::Assignment& assignment,
                                                                   bool simulatedFalcon);

/// Simulates an attempt by a hand that cuts another surface than the ideal.
/// @param wanted  height of each column after the attempt, mm, [side * side]
[[nodiscard]] core::Result<haptics::SimulationOutcome> cutInstead(const lessons::Assignment& assignment,
                                                                  const std::vector<float>& wanted);

}  // namespace app
