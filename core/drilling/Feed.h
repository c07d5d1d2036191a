// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drilling/Bur.h"
#include "core/settings/Handpiece.h"
#include "core/settings/HardnessPreset.h"

namespace core::drilling {

/// How fast a bur sinks straight down into a material that it is pressed into with `forceN`, once its whole
/// cross-section cuts, mm/s: Drill's law for a bur whose end is flat, solved for the advance.
[[nodiscard]] double feedMmPerS(const settings::MaterialHardness& hardness, double axialShare,
                                const settings::Handpiece& handpiece, const Bur& bur, double forceN) noexcept;

}  // namespace core::drilling
