// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/grading/Preparation.h"
#include "core/preparation/ToothDesign.h"
#include "core/terrain/Tooth.h"

namespace core::preparation {

/// Returns the occlusal reduction of a generated premolar or molar for a crown (docs/teeth.md): its surface with the
/// fissures closed, lowered along z by functionalMm over the functional cusps (buccal of a lower tooth, lingual of an
/// upper one) and by reductionMm elsewhere, with a smooth change between the middle of the tooth and the tips. No part
/// of the cut is steeper than 45 degrees: at the sides of the crown the planes continue straight and run out, which
/// makes the bevel of the functional cusps. All cut columns are Floor.
///
/// Some tens of milliseconds; any thread but the ui thread. Error if the tooth has no generated occlusal surface.
[[nodiscard]] Result<grading::Preparation> occlusalReduction(const ToothDesign& design,
                                                             const terrain::ToothAnatomy& anatomy);

}  // namespace core::preparation
