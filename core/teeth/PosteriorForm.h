// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/teeth/PosteriorCrown.h"

namespace core::teeth {

/// A generated premolar or molar as its maker knows it: where its cusps are and its grooves run, free of any grid.
/// Points are in the tooth frame, mm.
struct PosteriorForm
{
    PosteriorCrown crown;
    glm::dvec3 originMm{0.0};  ///< of the tooth frame in the design frame
    glm::dvec3 scale{1.0};     ///< tooth mm per design mm
    double ySign = 1.0;        ///< buccalSign()

    [[nodiscard]] glm::dvec2 toDesign(glm::dvec2 toothMm) const;
    [[nodiscard]] glm::dvec2 toTooth(glm::dvec2 designMm) const;
    /// Height of the occlusal surface were its fissures filled to the mouth: where a groove's depth is measured from.
    [[nodiscard]] double mouthMm(glm::dvec2 toothMm) const;
    /// Height of one lobe alone, by its place in crown.design().lobes: two lobes meet in a groove.
    [[nodiscard]] double lobeMm(std::size_t lobe, glm::dvec2 toothMm) const;
    /// The height of contour seen from above, as a closed line of so many points from distal.
    [[nodiscard]] std::vector<glm::dvec2> outline(int points) const;
};

}  // namespace core::teeth
