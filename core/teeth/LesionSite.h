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

/// Where on a tooth decay begins.
enum class LesionSite : std::uint8_t {
    Fissure,   ///< in a fissure of the occlusal surface, or in the lowest place of a crown without one
    Cervical,  ///< above the neck, on the buccal or lingual side (Class V)
    Pit,       ///< in the deepest pit or groove of the buccal or lingual side: cingulum pit, buccal pit
    Contact    ///< below the contact point, on the mesial or distal side (Class III on front teeth)
};

/// Names in files, in the order of LesionSite.
inline constexpr const char* kLesionSites[] = {"fissure", "cervical", "pit", "contact"};

/// A tooth that leans further than this shows the bur a side; up to it, the occlusal surface.
inline constexpr double kSideTiltDeg = 60.0;

/// The site that the side towards the bur usually has: a fissure up to a tilt of 60 degrees, cervical on the buccal and
/// lingual side, contact on the mesial and distal side.
[[nodiscard]] LesionSite usualSite(const terrain::Lying& lying);

/// Whether a bur reaches the site of a tooth that lies like this; if not, a sentence that says how it would.
[[nodiscard]] Status checkSite(LesionSite site, const terrain::Lying& lying);

/// Puts decay into the layers of a laid tooth, made by buildLaidLayers for these maps. Fissure decay is that of the
/// upright tooth, met along the bur. Cervical decay has its middle 1.2 mm above the neck and that of a contact 0.75 mm
/// below the point that stands out furthest; a seed other than 0 moves them by up to 0.4 mm. They are at most 3.2 mm
/// long and 1.8 mm high (Sturdevant's Art and Science of Operative Dentistry, Classes III and V).
/// @param extent  0 none .. 1 deepest; a larger extent contains every smaller one
/// @return a sentence if the side that is turned to the bur has no such place
[[nodiscard]] Status addLesion(LesionSite site, double extent, const LaidTooth& laid, const terrain::Grid& grid,
                               std::span<const float> top, std::span<const float> bottom,
                               std::vector<terrain::ColumnLayers>& layers);

}  // namespace core::teeth
