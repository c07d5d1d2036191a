// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/terrain/Tooth.h"

namespace core::contact {

/// What a bur let down over a point comes to stand on.
struct Touch
{
    double heightMm;   ///< of the tip: the clearance C; kEmptyTop or less if there is nothing
    glm::dvec2 slope;  ///< dC/dx and dC/dy, mm a mm; kUpright and more at an upright side
    glm::dvec3 onMm;   ///< the point of the tooth that carries the bur
    /// On an upright side of uncut ground: the way it looks, a unit vector, and its height over onMm down to roofMm, up
    /// to which the tip is free beneath it. Zero on everything else.
    glm::dvec2 outwards{0.0, 0.0};
    double roofMm = static_cast<double>(terrain::kEmptyTop);

    [[nodiscard]] bool isSide() const { return outwards.x != 0.0 || outwards.y != 0.0; }
};

}  // namespace core::contact
