// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/drilling/Bur.h"
#include "core/terrain/Tooth.h"

namespace haptics {

/// About the smallest cavity that a bur can cut to clear the decay (core::grading::decayGoesDownTo()): each column of
/// it from as near above as neither comes near the pulp nor goes through the tooth. Decay that cannot be reached so is
/// left, and what no bur reaches. Any thread; some ten milliseconds at 150 x 150.
/// @return the top of each column afterwards, mm, [side * side], as core::grading::IdealTop
[[nodiscard]] std::vector<float> decayCavity(const core::terrain::ToothAnatomy& anatomy,
                                             const core::drilling::Bur& bur);

}  // namespace haptics
