// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/TriangleMesh.h"

namespace core::teeth {

/// The resolution of a tooth's mesh. The default is for rasterising and drilling; the others are for viewing.
struct MeshDetail
{
    int topCells = 160;      ///< along the side of the square over the occlusal table: under 0.09 mm each on a molar
    int sideRings = 30;      ///< from the height of contour to the CEJ
    int edgeSections = 150;  ///< of an incisor or canine, from the edge to the CEJ
    int edgeAround = 256;    ///< vertices of each of them; a multiple of four
    int trunkRings = 9;      ///< from the CEJ to the furcation
    int branchRings = 26;    ///< of each root
    int spokePoints = 14;    ///< across the furcation

    /// For a distant view.
    [[nodiscard]] static MeshDetail coarse() { return {32, 6, 22, 56, 3, 6, 3}; }
    /// For a view beside the tooth that is drilled.
    [[nodiscard]] static MeshDetail medium() { return {80, 8, 44, 112, 3, 6, 3}; }
};

/// Collects vertices and strips of a closed surface, in the design frame. Rings run counter-clockwise seen from +z.
class MeshBuilder
{
public:
    using Index = std::uint32_t;
    using Ring = std::vector<Index>;

    Index add(const glm::dvec3& point);
    void triangle(Index a, Index b, Index c);

    /// Joins a ring to the one below it, which has as many vertices or half as many (vertex k under vertex 2k).
    void band(std::span<const Index> upper, std::span<const Index> lower);

    /// Closes a ring with a point below it.
    void capBelow(std::span<const Index> ring, Index tip);

    [[nodiscard]] const glm::dvec3& point(Index index) const { return m_points[index]; }
    [[nodiscard]] std::vector<glm::dvec3>& points() { return m_points; }

    /// Returns the mesh with y multiplied by `ySign`; keeps the triangles facing outwards.
    [[nodiscard]] mesh::TriangleMesh finish(double ySign) const;

private:
    std::vector<glm::dvec3> m_points;
    std::vector<std::array<std::uint32_t, 3>> m_triangles;
};

}  // namespace core::teeth
