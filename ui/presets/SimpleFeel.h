// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/settings/FeelPreset.h"

namespace ui::presets {

/// What of a preset can be turned without knowing numbers, each from -1 to 1 and 0 as the preset is: harder materials,
/// a touch that must be heavier before it cuts, a stiffer wall.
enum class Dial { Enamel, Dentin, Caries, Plastic, Touch, Wall };
inline constexpr std::size_t kDials = 6;
using Dials = std::array<double, kDials>;

/// A preset with its dials turned: rates and thresholds to a quarter and four times what they were, the stiffness to
/// half and twice, but no farther than the loop holds. What the dials leave alone stays to the bit;
/// what they change has no hash.
[[nodiscard]] core::settings::FeelPreset turned(const core::settings::FeelPreset& base, const Dials& dials);

/// A slider stops at so many places to either side of 0.
inline constexpr int kDialSteps = 20;

/// The dials, at their stops, that turn `base` into a preset of these numbers; nothing where none do.
[[nodiscard]] std::optional<Dials> dialsFor(const core::settings::FeelPreset& base,
                                            const core::settings::FeelPreset& preset);

}  // namespace ui::presets
