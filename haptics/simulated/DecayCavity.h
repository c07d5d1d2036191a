// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/bur/Bur.h"
#include "core/terrain/Tooth.h"

namespace haptics {

/// Returns approximately the smallest cavity that a bur can cut to remove the decay down to
/// core::grading::decayGoesDownTo(). Decay stays where the bur would come near the pulp, perforate the tooth or not
/// fit. Takes some ten milliseconds at 150 x 150. Any thread.
/// @return the top of each column afterwards, mm, [side * side], as core::grading::IdealTop
[[nodiscard]] std::vector<float> decayCavity(const core::terrain::ToothAnatomy& anatomy, const core::bur::Bur& bur);

}  // namespace haptics
