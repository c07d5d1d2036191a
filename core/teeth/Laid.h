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

/// Teeth that lie on a side (core::terrain::Lying): their names for a person, and where their tissues and decay are.
namespace core::teeth {

/// Returns how a tooth lies by the name of the side that is turned to the bur: "occlusal"; "mesial", "distal",
/// "buccal" and "lingual" of a tooth whose sides are known; "-x", "+x", "-y" and "+y" of a scan, in the frame it was
/// placed in. An error names what there is.
/// @param tiltDeg  5 to 90; ignored for "occlusal"
/// @param fdi  of a tooth that the program makes, 0 for a scan
[[nodiscard]] Result<terrain::Lying> findLying(std::string_view name, double tiltDeg, int fdi);

/// The name that findLying() takes.
[[nodiscard]] std::string_view nameOf(const terrain::Lying& lying, int fdi);

/// All names that findLying() takes, those of a scan last.
[[nodiscard]] const std::vector<std::string>& lyingNames();

/// A tooth before it was turned, and how it was turned. Its tissues belong to its own frame: enamel thins towards the
/// neck whichever side is up.
struct LaidTooth
{
    terrain::ToothAnatomy own;       ///< upright and whole, sound, on the default grid
    std::optional<ToothSizes> made;  ///< by which the program made it; none: a scan
    double crownHeightMm = 0.0;
    double tipMm = 0.0;  ///< own z of the highest point
    glm::dmat3 cutFromOwn{1.0};
    glm::dvec3 shiftMm{0.0};  ///< added after the turn

    /// Points from one frame into the other, mm.
    [[nodiscard]] glm::dvec3 cutMm(const glm::dvec3& ownMm) const { return cutFromOwn * ownMm + shiftMm; }
    [[nodiscard]] glm::dvec3 ownMm(const glm::dvec3& cutMm) const
    {
        return glm::transpose(cutFromOwn) * (cutMm - shiftMm);
    }
    /// Own z of the neck (enamel-cement junction) in the middle of the facial side.
    [[nodiscard]] double neckMm() const { return tipMm - crownHeightMm; }
};

}  // namespace core::teeth
