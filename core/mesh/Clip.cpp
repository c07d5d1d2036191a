// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/Clip.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace core::mesh {
namespace {

class Clipper
{
public:
    Clipper(const TriangleMesh& mesh, double height)
        : m_mesh(mesh), m_height(height), m_kept(mesh.vertices.size(), kNone)
    {}

    TriangleMesh clip()
    {
        for (const auto& triangle : m_mesh.triangles)
            add(triangle);
        return std::move(m_result);
    }

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    [[nodiscard]] double heightOf(std::uint32_t vertex) const { return static_cast<double>(m_mesh.vertices[vertex].z); }
    [[nodiscard]] bool isAbove(std::uint32_t vertex) const { return heightOf(vertex) >= m_height; }

    std::uint32_t put(const glm::vec3& vertex)
    {
        m_result.vertices.push_back(vertex);
        return static_cast<std::uint32_t>(m_result.vertices.size() - 1);
    }

    std::uint32_t kept(std::uint32_t vertex)
    {
        if (m_kept[vertex] == kNone)
            m_kept[vertex] = put(m_mesh.vertices[vertex]);
        return m_kept[vertex];
    }

    /// Returns the vertex where an edge crosses the plane. Both triangles of the edge share this vertex.
    std::uint32_t crossing(std::uint32_t a, std::uint32_t b)
    {
        const auto [low, high] = std::minmax(a, b);
        const auto [found, isNew] = m_crossings.try_emplace({low, high}, kNone);
        if (isNew) {
            const double share = (m_height - heightOf(low)) / (heightOf(high) - heightOf(low));
            glm::dvec3 at = glm::mix(glm::dvec3(m_mesh.vertices[low]), glm::dvec3(m_mesh.vertices[high]), share);
            at.z = m_height;
            found->second = put(glm::vec3(at));
        }
        return found->second;
    }

    /// Adds the part of a triangle above the plane, which has three or four corners.
    void add(const std::array<std::uint32_t, 3>& triangle)
    {
        std::array<std::uint32_t, 4> corners{};
        std::size_t count = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t here = triangle[k];
            const std::uint32_t next = triangle[(k + 1) % 3];
            if (isAbove(here))
                corners.at(count++) = kept(here);
            if (isAbove(here) != isAbove(next))
                corners.at(count++) = crossing(here, next);
        }
        for (std::size_t k = 2; k < count; ++k)
            m_result.triangles.push_back({corners[0], corners.at(k - 1), corners.at(k)});
    }

    const TriangleMesh& m_mesh;
    double m_height;
    std::vector<std::uint32_t> m_kept;  ///< [vertex of the mesh] its index in the result
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> m_crossings;
    TriangleMesh m_result;
};

}  // namespace

TriangleMesh clippedBelow(const TriangleMesh& mesh, double height)
{
    return Clipper(mesh, height).clip();
}

}  // namespace core::mesh
