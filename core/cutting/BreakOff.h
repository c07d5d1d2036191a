// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cutting/Drill.h"

namespace core::cutting {

/// Removes what the columns that were just lowered have left too slender to stand: a column or a fin between a lowered
/// column and other ground, higher above both than `slenderness` times its width. It is lowered to the higher of the
/// two. Width is measured along the rows of the lattice and along its diagonals.
///
/// One pass: remains of a break wait for the next cut beside them. Servo thread; no allocation. Reads the columns of
/// `changed` and, from each, no farther than the possible width of a fin of the tooth's height.
/// @param changed  columns that a cut has lowered; extended by those that break
/// @return volume that broke off, mm3 of each material
terrain::PerMaterial breakOff(contact::LiveTooth& tooth, double slenderness, CutRect& changed) noexcept;

}  // namespace core::cutting
