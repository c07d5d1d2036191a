// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/grading/Preparation.h"
#include "core/preparation/ToothDesign.h"
#include "core/terrain/Tooth.h"

namespace core::preparation {

/// The occlusal reduction of a generated premolar or molar for a crown (docs/teeth.md): its surface with the fissures
/// closed, lowered along z by functionalMm over the functional cusps (buccal of a lower tooth, lingual of an upper one)
/// and by reductionMm elsewhere, with a smooth change between the middle of the tooth and the tips. No part of the cut
/// is steeper than 45 degrees: where the sides of the crown are, the planes go straight on and run out, which makes the
/// bevel of the functional cusps. All cut columns are Floor.
///
/// Some tens of milliseconds; any thread that may wait. An error where the tooth has no occlusal surface of ours.
[[nodiscard]] Result<grading::Preparation> occlusalReduction(const ToothDesign& design,
                                                             const terrain::ToothAnatomy& anatomy);

}  // namespace core::preparation
