// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/Pose.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace core::tracking {

double angleBetweenDeg(const glm::dmat3& a, const glm::dmat3& b)
{
    return glm::length(rotationVectorDeg(glm::transpose(a) * b));
}

glm::dvec3 rotationVectorDeg(const glm::dmat3& rotation)
{
    const glm::dquat turn = glm::normalize(glm::quat_cast(rotation));
    const glm::dvec3 axis(turn.x, turn.y, turn.z);
    const double sine = glm::length(axis);
    if (sine == 0.0)
        return glm::dvec3(0.0);
    // Of the two rotations, uses the shorter one.
    const double angle = 2.0 * std::atan2(sine, std::abs(turn.w));
    return axis * (std::copysign(glm::degrees(angle), turn.w) / sine);
}

}  // namespace core::tracking
