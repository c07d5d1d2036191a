// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/terrain/Tooth.h"

namespace core::terrain {

/// Thickness of the two lower zones of decay in dentin, mm. Below the infected dentin 0.5 to 1.5 mm are demineralised
/// but not infected (docs/teeth.md).
inline constexpr float kFirmDecayMm = 0.5F;
inline constexpr float kLeatheryDecayMm = 0.5F;

/// Upper ends of the zones of decay in one column, mm: firm from cariesFloor to firmRoof, leathery up to leatheryRoof,
/// soft up to cariesRoof.
struct DecayZones
{
    float firmRoof = 0.0F;
    float leatheryRoof = 0.0F;
};

/// Returns the zones of a column. Decay in enamel is soft. Without decay both heights are cariesFloor. Any thread.
[[nodiscard]] inline DecayZones decayZonesOf(const ColumnLayers& column) noexcept
{
    const float inDentin = std::max(column.cariesFloor, std::min(column.cariesRoof, column.dej));
    return {std::min(column.cariesFloor + kFirmDecayMm, inDentin),
            std::min(column.cariesFloor + kFirmDecayMm + kLeatheryDecayMm, inDentin)};
}

/// Returns the zones of column k of a tooth. Both heights are cariesFloor also if its decay has no zones.
[[nodiscard]] inline DecayZones decayZonesOf(const ToothAnatomy& anatomy, std::size_t k) noexcept
{
    const ColumnLayers& column = anatomy.layers[k];
    return anatomy.hasDecayZones ? decayZonesOf(column) : DecayZones{column.cariesFloor, column.cariesFloor};
}

}  // namespace core::terrain
