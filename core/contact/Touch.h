// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/terrain/Tooth.h"

namespace core::contact {

/// First contact of a bur lowered vertically at a point.
struct Touch
{
    double heightMm;   ///< of the tip: the clearance C; kEmptyTop or less if there is no contact
    glm::dvec2 slope;  ///< dC/dx and dC/dy, mm per mm; kUpright or more at an upright side
    glm::dvec3 onMm;   ///< the point of the tooth that the bur touches
    /// On an upright side of uncut ground: its outward direction, a unit vector; the side is between roofMm and onMm in
    /// height, and the tip is free below roofMm. Zero elsewhere.
    glm::dvec2 outwards{0.0, 0.0};
    double roofMm = static_cast<double>(terrain::kEmptyTop);
    /// On cut ground, the slope from that column to the next one outwards, mm per mm: a bur beside a wall must not
    /// climb the columns at its foot on the way to the first column of the wall, which may be most of a cell beyond its
    /// rim.
    double rise = 0.0;

    [[nodiscard]] bool isSide() const { return outwards.x != 0.0 || outwards.y != 0.0; }
};

}  // namespace core::contact
