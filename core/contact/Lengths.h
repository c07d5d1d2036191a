// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace core::contact {

[[nodiscard]] inline double lengthOf(const glm::dvec3& v) noexcept
{
    return std::sqrt(glm::dot(v, v));
}

[[nodiscard]] inline double lengthOf(glm::dvec2 v) noexcept
{
    return std::sqrt(v.x * v.x + v.y * v.y);
}

/// Returns the squared distance between two points.
[[nodiscard]] inline double distance2(const glm::dvec3& a, const glm::dvec3& b) noexcept
{
    const glm::dvec3 apart = a - b;
    return glm::dot(apart, apart);
}

/// Returns a vector in the same direction, no longer than `longest`.
[[nodiscard]] inline glm::dvec3 shortened(const glm::dvec3& v, double longest) noexcept
{
    const double length = lengthOf(v);
    return length > longest ? v * (longest / length) : v;
}

}  // namespace core::contact
