// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/MeshBuilder.h"

#include <cassert>
#include <utility>

namespace core::teeth {

MeshBuilder::Index MeshBuilder::add(const glm::dvec3& point)
{
    m_points.push_back(point);
    return static_cast<Index>(m_points.size() - 1);
}

void MeshBuilder::triangle(Index a, Index b, Index c)
{
    m_triangles.push_back({a, b, c});
}

void MeshBuilder::band(std::span<const Index> upper, std::span<const Index> lower)
{
    const std::size_t n = lower.size();
    const std::size_t step = upper.size() / n;
    assert(upper.size() == n * step && (step == 1 || step == 2));
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t next = (k + 1) % n;
        const Index a = upper[k * step];
        const Index b = upper[next * step];
        const Index c = lower[k];
        const Index d = lower[next];
        if (step == 2) {
            const Index middle = upper[k * 2 + 1];
            triangle(a, c, middle);
            triangle(middle, c, d);
            triangle(middle, d, b);
        } else {
            triangle(a, c, d);
            triangle(a, d, b);
        }
    }
}

void MeshBuilder::capBelow(std::span<const Index> ring, Index tip)
{
    for (std::size_t k = 0; k < ring.size(); ++k)
        triangle(ring[k], tip, ring[(k + 1) % ring.size()]);
}

mesh::TriangleMesh MeshBuilder::finish(double ySign) const
{
    mesh::TriangleMesh mesh;
    mesh.vertices.reserve(m_points.size());
    for (const glm::dvec3& p : m_points)
        mesh.vertices.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y * ySign), static_cast<float>(p.z));
    mesh.triangles = m_triangles;
    if (ySign < 0.0)
        for (auto& t : mesh.triangles)
            std::swap(t[1], t[2]);
    return mesh;
}

}  // namespace core::teeth
