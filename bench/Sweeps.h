// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/Suites.h"

namespace bench {

/// Adds the sweeps of the suite "cutting": volume of swept cuts against closed form, by grid, with its chart.
/// @param steps  of the whole suite; the sweeps are the first kSweepSteps
void addSweeps(Figures& figures, const Context& context, int steps);

inline constexpr int kSweepSteps = 48;

}  // namespace bench
