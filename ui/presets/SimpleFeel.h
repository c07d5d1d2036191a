// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/settings/FeelPreset.h"

namespace ui::presets {

/// The dials of a preset, for users who do not know its numbers: harder materials, a higher threshold before the bur
/// cuts, a stiffer wall. Each has a range of -1 to 1, where 0 leaves the preset unchanged.
enum class Dial { Enamel, Dentin, Caries, Plastic, Touch, Wall };
inline constexpr std::size_t kDials = 6;
using Dials = std::array<double, kDials>;

/// Returns a preset with its dials turned. Rates and thresholds range from a quarter to four times, the stiffness from
/// half to twice, limited to what the servo loop keeps stable. Numbers of dials at 0 stay bit-identical. A changed
/// preset has no hash.
[[nodiscard]] core::settings::FeelPreset turned(const core::settings::FeelPreset& base, const Dials& dials);

/// Number of slider steps on either side of 0.
inline constexpr int kDialSteps = 20;

/// Returns the dials, in slider steps, that turn `base` into a preset with these numbers. Empty if no dials do.
[[nodiscard]] std::optional<Dials> dialsFor(const core::settings::FeelPreset& base,
                                            const core::settings::FeelPreset& preset);

}  // namespace ui::presets
