// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/Holes.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace core::mesh {
namespace {

/// Groups the vertices of each hole (union-find over the few vertices on a boundary).
class BoundaryGroups
{
public:
    std::uint32_t find(std::uint32_t vertex)
    {
        std::uint32_t root = vertex;
        for (auto it = m_parent.find(root); it != m_parent.end() && it->second != root; it = m_parent.find(root))
            root = it->second;
        while (vertex != root) {
            std::uint32_t& parent = m_parent[vertex];
            vertex = parent;
            parent = root;
        }
        return root;
    }
    void merge(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        m_parent[std::max(a, b)] = std::min(a, b);
        m_parent[std::min(a, b)] = std::min(a, b);
    }

private:
    std::unordered_map<std::uint32_t, std::uint32_t> m_parent;
};

}  // namespace

std::vector<Hole> findHoles(const TriangleMesh& mesh, const MeshFacts& facts)
{
    BoundaryGroups groups;
    for (const auto& [from, to] : facts.openEdges)
        groups.merge(from, to);
    std::vector<Hole> holes;
    std::unordered_map<std::uint32_t, std::size_t> holeOf;
    for (const auto& edge : facts.openEdges) {
        const auto [it, isNew] = holeOf.try_emplace(groups.find(edge[0]), holes.size());
        if (isNew)
            holes.emplace_back();
        holes[it->second].edges.push_back(edge);
    }
    for (Hole& hole : holes) {
        hole.low = glm::dvec3(std::numeric_limits<double>::max());
        hole.high = -hole.low;
        for (const auto& [from, to] : hole.edges) {
            const glm::dvec3 a(mesh.vertices[from]);
            const glm::dvec3 b(mesh.vertices[to]);
            hole.centre += 0.5 * (a + b) / static_cast<double>(hole.edges.size());
            hole.low = glm::min(hole.low, glm::min(a, b));
            hole.high = glm::max(hole.high, glm::max(a, b));
        }
        for (const auto& [from, to] : hole.edges)
            hole.areaVector += 0.5 * glm::cross(glm::dvec3(mesh.vertices[to]) - hole.centre,
                                                glm::dvec3(mesh.vertices[from]) - hole.centre);
    }
    return holes;
}

void patch(TriangleMesh& mesh, const Hole& hole)
{
    const auto centre = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(hole.centre);
    for (const auto& [from, to] : hole.edges)
        mesh.triangles.push_back({to, from, centre});
}

}  // namespace core::mesh
