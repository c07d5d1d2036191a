// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/simulated/Simulation.h"
#include "lessons/Assignment.h"

namespace app {

/// An attempt at an assignment by a simulated hand: it cuts the ideal (haptics::IdealHand), or takes the decay out
/// (haptics::DemoHand), with the first bur that is allowed. The same assignment gives the same recording. A second or
/// two; any thread that may wait. WrongKind for an exercise, where nothing is to be cut.
/// @param simulatedFalcon  the hand holds a simulated Falcon, and no pointer
[[nodiscard]] core::Result<haptics::SimulationOutcome> demonstrate(const lessons::Assignment& assignment,
                                                                   bool simulatedFalcon);

}  // namespace app
