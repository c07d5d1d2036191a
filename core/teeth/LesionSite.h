// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/Result.h"
#include "core/teeth/Laid.h"
#include "core/terrain/Grid.h"
#include "core/terrain/Lying.h"
#include "core/terrain/Tooth.h"

namespace core::teeth {

/// The place on a tooth where decay begins.
enum class LesionSite : std::uint8_t {
    Fissure,   ///< in a fissure of the occlusal surface, or in the lowest place of a crown without one
    Cervical,  ///< above the neck, on the buccal or lingual side (Class V)
    Pit,       ///< in the deepest pit or groove of the buccal or lingual side: cingulum pit, buccal pit
    Contact    ///< below the contact point, on the mesial or distal side (Class III on front teeth)
};

/// Names in files, in the order of LesionSite.
inline constexpr const char* kLesionSites[] = {"fissure", "cervical", "pit", "contact"};

/// Tilt beyond which a tooth turns a side to the bur; up to it, the occlusal surface.
inline constexpr double kSideTiltDeg = 60.0;

/// Returns the usual site on the side towards the bur: a fissure up to a tilt of 60 degrees, cervical on the buccal and
/// lingual side, contact on the mesial and distal side.
[[nodiscard]] LesionSite usualSite(const terrain::Lying& lying);

/// Checks whether a bur can reach the site of a tooth with this orientation; the error says which one is needed.
[[nodiscard]] Status checkSite(LesionSite site, const terrain::Lying& lying);

/// Adds decay to the layers of a tooth on its side, from buildLaidLayers() for these maps. Fissure decay is that of the
/// upright tooth, along the direction of the bur. The middle of cervical decay is 1.2 mm above the neck and that of a
/// contact 0.75 mm below the most protruding point; a seed other than 0 moves them by up to 0.4 mm. They are at most
/// 3.2 mm long and 1.8 mm high (Sturdevant's Art and Science of Operative Dentistry, Classes III and V).
/// @param extent  0 none to 1 deepest; a larger extent contains every smaller one
/// @return an error if the side that is turned to the bur has no such place
[[nodiscard]] Status addLesion(LesionSite site, double extent, const LaidTooth& laid, const terrain::Grid& grid,
                               std::span<const float> top, std::span<const float> bottom,
                               std::vector<terrain::ColumnLayers>& layers);

}  // namespace core::teeth
