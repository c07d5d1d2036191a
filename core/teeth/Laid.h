// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "core/base/Result.h"
#include "core/teeth/ToothTable.h"
#include "core/terrain/Lying.h"
#include "core/terrain/Tooth.h"

/// Teeth placed on a side (core::terrain::Lying): the names of their orientation, and the places of their tissues and
/// decay.
namespace core::teeth {

/// Returns the orientation of a tooth by the name of the side that is turned to the bur: "occlusal"; "mesial",
/// "distal", "buccal" and "lingual" of a tooth whose sides are known; "-x", "+x", "-y" and "+y" of a scan, in the frame
/// it was placed in. The error lists the valid names.
/// @param tiltDeg  5 to 90; ignored for "occlusal"
/// @param fdi  of a generated tooth, 0 for a scan
[[nodiscard]] Result<terrain::Lying> findLying(std::string_view name, double tiltDeg, int fdi);

/// Returns the name of an orientation, as for findLying().
[[nodiscard]] std::string_view nameOf(const terrain::Lying& lying, int fdi);

/// An upright tooth and the rotation that was applied to it. Its tissues are defined in its own frame: enamel becomes
/// thinner towards the neck whichever side is up.
struct LaidTooth
{
    terrain::ToothAnatomy own;       ///< upright and whole, sound, on the default grid
    std::optional<ToothSizes> made;  ///< sizes of a generated tooth; empty: a scan
    double crownHeightMm = 0.0;
    double tipMm = 0.0;  ///< own z of the highest point
    glm::dmat3 cutFromOwn{1.0};
    glm::dvec3 shiftMm{0.0};  ///< added after the rotation

    /// Convert points between the frames, mm.
    [[nodiscard]] glm::dvec3 cutMm(const glm::dvec3& ownMm) const { return cutFromOwn * ownMm + shiftMm; }
    [[nodiscard]] glm::dvec3 ownMm(const glm::dvec3& cutMm) const
    {
        return glm::transpose(cutFromOwn) * (cutMm - shiftMm);
    }
    /// Returns the own z of the neck (cemento-enamel junction) in the middle of the facial side.
    [[nodiscard]] double neckMm() const { return tipMm - crownHeightMm; }
};

}  // namespace core::teeth
