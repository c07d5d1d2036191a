// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/simulated/IdealHand.h"
#include "haptics/simulated/Simulation.h"
#include "lessons/Assignment.h"

namespace app {

/// A hand that cuts what an assignment asks for: its ideal, or about the smallest cavity that clears the decay.
/// @param burIndex  of core::bur::burs(), that it holds
[[nodiscard]] haptics::IdealHand handFor(const lessons::Assignment& assignment, std::size_t burIndex);

/// An attempt at an assignment by such a hand with the first bur that is allowed. The same assignment gives the same
/// recording. A second or two; any thread that may wait. WrongKind for an exercise, where nothing is to be cut.
/// @param simulatedFalcon  the hand holds a simulated Falcon, and no pointer
[[nodiscard]] core::Result<haptics::SimulationOutcome> demonstrate(const lessons::Assignment& assignment,
                                                                   bool simulatedFalcon);

/// An attempt by such a hand that cuts another surface than the one asked for.
/// @param wanted  top of each column afterwards, mm, [side * side]
[[nodiscard]] core::Result<haptics::SimulationOutcome> cutInstead(const lessons::Assignment& assignment,
                                                                  const std::vector<float>& wanted);

}  // namespace app
