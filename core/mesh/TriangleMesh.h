// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace core::mesh {

/// An indexed triangle mesh: what the readers give, the generator makes and the rasteriser takes.
/// Counter-clockwise seen from outside. The unit and frame are said by whoever holds it.
struct TriangleMesh
{
    std::vector<glm::vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace core::mesh
