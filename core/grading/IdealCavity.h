// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/terrain/Tooth.h"

namespace core::grading {

/// The upper surface of a tooth after the ideal work: heights over the anatomy's grid, mm, [side * side], kEmptyTop
/// where no material is to be left. Shared and immutable.
using IdealTop = std::shared_ptr<const std::vector<float>>;

/// Largest thickness of dentin straight below decay, above the pulp, at which the decay counts as over the pulp, mm. In
/// decay with zones, leathery decay stays there: without it, less than the ideal 2.0 mm would be left (docs/teeth.md).
inline constexpr float kOverPulpMm = 1.5F;

/// Returns whether the decay of a column is over the pulp.
[[nodiscard]] bool isOverPulp(const terrain::ToothAnatomy& anatomy, std::size_t k);

/// Returns the height down to which the decay of a column has to be removed, mm: the floor of the lesion. Where decay
/// has zones, firm decay stays, and leathery decay over the pulp as well; but within kAtJunctionMm of the enamel-dentin
/// junction all decay goes. Any value for a column without decay.
[[nodiscard]] float decayGoesDownTo(const terrain::ToothAnatomy& anatomy, std::size_t k);

/// Returns the smallest cavity that removes the decay: each column of the lesion down to decayGoesDownTo(), all else
/// uncut. Tissue straight above decay is removed with it, because an upright handpiece cannot avoid it. Null for a
/// tooth without a lesion.
[[nodiscard]] IdealTop idealCavity(const terrain::ToothAnatomy& anatomy);

}  // namespace core::grading
