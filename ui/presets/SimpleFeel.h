// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/settings/FeelPreset.h"

namespace ui::presets {

/// The dials of a preset, for users without knowledge of its numbers. Each has a range of -1 to 1, with 0 as the preset
/// is: harder materials, a higher threshold before the bur cuts, a stiffer wall.
enum class Dial { Enamel, Dentin, Caries, Plastic, Touch, Wall };
inline constexpr std::size_t kDials = 6;
using Dials = std::array<double, kDials>;

/// Returns a preset with its dials turned: rates and thresholds from a quarter to four times, the stiffness from half
/// to twice, limited to what the servo loop keeps stable. Numbers of unturned dials stay bit-identical. A changed
/// preset has no hash.
[[nodiscard]] core::settings::FeelPreset turned(const core::settings::FeelPreset& base, const Dials& dials);

/// Number of slider steps on either side of 0.
inline constexpr int kDialSteps = 20;

/// Returns the dials, in slider steps, that turn `base` into a preset with these numbers; empty if there are none.
[[nodiscard]] std::optional<Dials> dialsFor(const core::settings::FeelPreset& base,
                                            const core::settings::FeelPreset& preset);

}  // namespace ui::presets
