// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/grading/Preparation.h"
#include "core/preparation/ToothDesign.h"
#include "core/terrain/Tooth.h"

namespace core::preparation {

/// Returns usualDesign(), changed as far as a small tooth needs it for any outline: first with upright end walls, then
/// with half of the ridge across, and last with less marginal ridge, in tenths of a millimetre and not under 0.8 (under
/// 1.0 to 1.2 a ridge fails, docs/teeth.md). The same on every grid.
[[nodiscard]] Result<ToothDesign> fittedDesign(Kind kind, const terrain::ToothAnatomy& anatomy);

/// Returns the ideal preparation of a generated tooth by rule. Its outline follows the tooth's own grooves and is the
/// same in millimetres on every grid.
///
/// Some tens of milliseconds; any thread but the ui thread. Errors, one sentence each: a scan, whose fissures are
/// unknown; a tooth that the kind is not available for; a number out of range, or one that leaves no room or would open
/// the pulp.
[[nodiscard]] Result<grading::Preparation> makePreparation(Kind kind, const ToothDesign& design,
                                                           const terrain::ToothAnatomy& anatomy);

}  // namespace core::preparation
