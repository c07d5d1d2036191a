// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cutting/Drill.h"

namespace core::cutting {

/// Takes off what the columns that were just lowered have left standing and no tooth could keep: a column or a fin
/// between a lowered column and other ground, higher above both than `slenderness` times its width. It goes down to the
/// higher of the two. Width is measured along the rows of the lattice and along its diagonals.
///
/// One pass: what a break leaves standing waits for the next cut beside it. Servo thread; no allocation. Looks at the
/// columns of `changed` and, from each, no farther than a fin of the tooth's height may be wide.
/// @param changed  columns that a cut has lowered; grows by those that break
/// @return what broke, mm3 of each material
terrain::PerMaterial breakOff(contact::LiveTooth& tooth, double slenderness, CutRect& changed) noexcept;

}  // namespace core::cutting
