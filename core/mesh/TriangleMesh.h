// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace core::mesh {

/// An indexed triangle mesh, as returned by the readers and the generator and used by the rasteriser. Counter-clockwise
/// seen from outside. Its owner knows the unit and frame.
struct TriangleMesh
{
    std::vector<glm::vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace core::mesh
