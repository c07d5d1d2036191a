// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/grading/Preparation.h"
#include "core/preparation/ToothDesign.h"
#include "core/terrain/Lying.h"
#include "core/terrain/Tooth.h"

namespace core::preparation {

/// Returns whether a tooth is placed like an incisor or canine whose chamber is opened from its lingual side: that side
/// up, tilted by more than 60 degrees.
[[nodiscard]] bool opensFromLingual(const terrain::Lying& lying, int fdi);

/// Returns the opening of the pulp chamber of 36 or 21 as an endodontist leaves it: the roof removed, the chamber
/// empty, its floor untouched, walls that lean out to the surface without a ledge; no deeper than a bur reaches
/// (bur::lowestTipMm). For an incisor that opensFromLingual(), the chamber ends at the neck, and its floor is its
/// labial wall. Called by makePreparation(), which checks the inputs.
[[nodiscard]] Result<grading::Preparation> accessOpening(const ToothDesign& design,
                                                         const terrain::ToothAnatomy& anatomy);

}  // namespace core::preparation
