// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "core/mesh/TriangleMesh.h"

namespace core::mesh {

/// The axes along which a surface is longest, shortest and between, at right angles to each other.
struct PrincipalAxes
{
    std::array<glm::dvec3, 3> axes{};  ///< of length 1, the longest first
    glm::dvec3 spread{0.0};            ///< standard deviation of the surface along each, in units of the mesh
};

/// Returns the principal axes of the surface of a mesh: the eigenvectors of the covariance of its points.
[[nodiscard]] PrincipalAxes principalAxes(const TriangleMesh& mesh);

}  // namespace core::mesh
