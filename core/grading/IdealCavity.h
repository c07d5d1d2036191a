// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/terrain/Tooth.h"

namespace core::grading {

/// The upper surface of a tooth as it ought to be when the work is done: heights over the anatomy's grid, mm,
/// [side * side], kEmptyTop where nothing is to be left. Shared and immutable.
using IdealTop = std::shared_ptr<const std::vector<float>>;

/// What the removal of decay asks for at the least: each column of the lesion down to the lesion's floor, everything
/// else as it was. What lies straight above decay goes with it, as a handpiece held upright cannot spare it. Null for a
/// tooth without a lesion.
[[nodiscard]] IdealTop idealCavity(const terrain::ToothAnatomy& anatomy);

}  // namespace core::grading
