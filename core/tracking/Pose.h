// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace core::tracking {

/// Position and orientation of a tag in front of a camera. Camera frame: x right, y down, z forward. Tag frame: x
/// right, y down, z into the tag; a tag seen straight on has the identity as its rotation.
struct Pose
{
    glm::dvec3 positionMm{0.0};  ///< centre of the tag, camera frame
    glm::dmat3 rotation{1.0};    ///< camera from tag
};

/// Returns the angle between two orientations, degrees, 0 to 180.
[[nodiscard]] double angleBetweenDeg(const glm::dmat3& a, const glm::dmat3& b);

/// Returns the rotation vector of an orientation: its axis times its angle in degrees.
[[nodiscard]] glm::dvec3 rotationVectorDeg(const glm::dmat3& rotation);

}  // namespace core::tracking
