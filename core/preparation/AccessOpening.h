// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/grading/Preparation.h"
#include "core/preparation/ToothDesign.h"
#include "core/terrain/Tooth.h"

namespace core::preparation {

/// The opening of the pulp chamber of 36 or 21 as an endodontist leaves it: the roof gone wholly, the chamber empty,
/// its floor untouched, walls that lean out to the surface without a ledge; no deeper than a bur reaches
/// (drilling::lowestTipMm). See makePreparation(), which checks its inputs.
[[nodiscard]] Result<grading::Preparation> accessOpening(const ToothDesign& design,
                                                         const terrain::ToothAnatomy& anatomy);

}  // namespace core::preparation
