// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bur/Bur.h"
#include "core/settings/Handpiece.h"
#include "core/settings/HardnessPreset.h"

namespace core::cutting {

/// Returns the speed at which a bur sinks straight down into a material under `forceN`, once its whole cross-section
/// cuts, mm/s: Drill's law, solved for the advance.
/// @param hardness  of the material; the preset gives the shares for the bur's end and the full load
[[nodiscard]] double feedMmPerS(const settings::HardnessPreset& preset, const settings::MaterialHardness& hardness,
                                const settings::Handpiece& handpiece, const bur::Bur& bur, double forceN) noexcept;

}  // namespace core::cutting
