// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace core::contact {

[[nodiscard]] inline double lengthOf(const glm::dvec3& v) noexcept
{
    return std::sqrt(glm::dot(v, v));
}

/// The same direction, no longer than `longest`.
[[nodiscard]] inline glm::dvec3 shortened(const glm::dvec3& v, double longest) noexcept
{
    const double length = lengthOf(v);
    return length > longest ? v * (longest / length) : v;
}

}  // namespace core::contact
