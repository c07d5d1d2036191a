// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/teeth/PosteriorCrown.h"

namespace core::teeth {

/// The construction of a generated premolar or molar: the places of its cusps and grooves, independent of any grid.
/// Points are in the tooth frame, mm.
struct PosteriorForm
{
    PosteriorCrown crown;
    glm::dvec3 originMm{0.0};  ///< of the tooth frame in the design frame
    glm::dvec3 scale{1.0};     ///< tooth mm per design mm
    double ySign = 1.0;        ///< buccalSign()

    [[nodiscard]] glm::dvec2 toDesign(glm::dvec2 toothMm) const;
    [[nodiscard]] glm::dvec2 toTooth(glm::dvec2 designMm) const;
    /// Returns the height of the occlusal surface with its fissures filled: the reference for the depth of a groove.
    [[nodiscard]] double mouthMm(glm::dvec2 toothMm) const;
    /// Returns the height of one lobe alone, by its index in crown.design().lobes: two lobes meet in a groove.
    [[nodiscard]] double lobeMm(std::size_t lobe, glm::dvec2 toothMm) const;
    /// Returns the height of contour seen from above, as a closed line of `points` points from distal.
    [[nodiscard]] std::vector<glm::dvec2> outline(int points) const;
};

}  // namespace core::teeth
