// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/TriangleMesh.h"

namespace core::teeth {

/// Collects vertices and strips of a closed surface, in the design frame. Rings run counter-clockwise seen from +z.
class MeshBuilder
{
public:
    using Index = std::uint32_t;
    using Ring = std::vector<Index>;

    Index add(const glm::dvec3& point);
    void triangle(Index a, Index b, Index c);

    /// Joins a ring to the one below it; the lower has as many vertices or half as many (vertex k under vertex 2k).
    void band(std::span<const Index> upper, std::span<const Index> lower);

    /// Closes a ring towards one point below it.
    void capBelow(std::span<const Index> ring, Index tip);

    [[nodiscard]] const glm::dvec3& point(Index index) const { return m_points[index]; }
    [[nodiscard]] std::vector<glm::dvec3>& points() { return m_points; }

    /// The mesh; y is multiplied by `ySign`, and with it the triangles are turned so that they keep facing outwards.
    [[nodiscard]] mesh::TriangleMesh finish(double ySign) const;

private:
    std::vector<glm::dvec3> m_points;
    std::vector<std::array<std::uint32_t, 3>> m_triangles;
};

}  // namespace core::teeth
