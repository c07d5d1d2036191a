// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/grading/IdealCavity.h"

namespace core::guidance {

/// Places on the occlusal surface that a step of a lesson can name.
enum class Landmark : std::uint8_t {
    CentralPit,
    MesialPit,
    DistalPit,
    MesialRidge,
    DistalRidge,
    RidgesToKeep,  ///< the marginal ridges that the ideal keeps
    RidgesToCut    ///< the marginal ridges that the ideal cuts through
};

struct PlacedLandmark
{
    Landmark landmark = Landmark::CentralPit;  ///< a pit or a single ridge
    glm::dvec2 placeMm{0.0};                   ///< tooth frame, seen from above
    bool operator==(const PlacedLandmark&) const = default;
};

/// Finds a landmark on the uncut surface of a posterior tooth. A pit is the lowest point within the outline of the
/// ideal: in the middle of the tooth, or in its mesial or distal part. A ridge is the highest point on the line along
/// which the outline runs to the mesial or distal edge. Returns an empty list if the tooth has no such place or lies on
/// a side.
/// @param ideal  of this anatomy; not null
[[nodiscard]] std::vector<PlacedLandmark> findLandmark(Landmark landmark, const terrain::ToothAnatomy& anatomy,
                                                       const std::vector<float>& ideal);

}  // namespace core::guidance
