// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/MeshAnalysis.h"
#include "core/mesh/TriangleMesh.h"

namespace core::mesh {

/// An opening of the surface: connected boundary edges.
struct Hole
{
    std::vector<std::array<std::uint32_t, 2>> edges;  ///< in the direction of their faces
    glm::dvec3 centre{};                              ///< mean of its edges' middles
    glm::dvec3 areaVector{};  ///< of the patch that would close it: points out of the mesh, its length is the area
    glm::dvec3 low{};
    glm::dvec3 high{};
};

/// Returns the holes of a mesh, in the current unit and frame of its vertices.
[[nodiscard]] std::vector<Hole> findHoles(const TriangleMesh& mesh, const MeshFacts& facts);

/// Closes a hole with a fan of triangles around its centre.
void patch(TriangleMesh& mesh, const Hole& hole);

}  // namespace core::mesh
