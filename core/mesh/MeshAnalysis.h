// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/TriangleMesh.h"

namespace core::mesh {

/// Largest number of shells for which nesting is determined: more are debris or a jaw.
inline constexpr std::size_t kMostNestedShells = 32;

/// One piece of surface, connected through shared edges.
struct Shell
{
    std::size_t triangles = 0;
    double volume = 0.0;                ///< signed, file units cubed; has little meaning if the shell is not closed
    bool closed = true;                 ///< no boundary and no non-manifold edge
    bool oriented = true;               ///< every edge is used once in each direction
    std::optional<std::size_t> inside;  ///< the closed shell that contains it
    glm::dvec3 low{};
    glm::dvec3 high{};
};

/// Properties of a welded mesh. Lengths in the mesh's own unit.
struct MeshFacts
{
    std::size_t triangles = 0;         ///< all, collapsed ones included
    std::size_t vertices = 0;          ///< distinct positions in use
    std::size_t collapsedFaces = 0;    ///< two corners the same: no part of the surface
    std::size_t zeroAreaFaces = 0;     ///< collapsed ones included
    std::size_t duplicateFaces = 0;    ///< the same three corners as an earlier one
    std::size_t boundaryEdges = 0;     ///< used once
    std::size_t nonManifoldEdges = 0;  ///< used three times or more
    std::size_t flippedEdges = 0;      ///< used twice in the same direction: the two faces disagree about the outside
    bool closed = false;               ///< no boundary and no non-manifold edge, and at least one face
    bool oriented = false;             ///< closed, and no flipped edge
    double area = 0.0;
    double volume = 0.0;  ///< signed, by the divergence theorem; valid if oriented
    /// Sum of the faces' area vectors: zero if closed, otherwise it points away from the opening.
    glm::dvec3 areaVector{};
    glm::dvec3 low{};
    glm::dvec3 high{};
    /// Boundary edges, ends in the direction of their face.
    std::vector<std::array<std::uint32_t, 2>> openEdges;
    std::vector<Shell> shells;           ///< in order of their first triangle
    std::vector<std::uint32_t> shellOf;  ///< [triangle]; kNoShell for collapsed faces
};

inline constexpr std::uint32_t kNoShell = 0xFFFFFFFFU;

/// Analyses a mesh. It must be welded (weldByPosition()) and have valid indices. Worst-case time n log n, about 10
/// bytes of scratch memory per corner.
[[nodiscard]] MeshFacts analyse(const TriangleMesh& mesh);

/// Reverses the shells that face inwards, with all shells inside them, so that they enclose a positive volume; updates
/// `facts`. Returns the number of shells that were inside out.
std::size_t turnOutwards(TriangleMesh& mesh, MeshFacts& facts);

}  // namespace core::mesh
