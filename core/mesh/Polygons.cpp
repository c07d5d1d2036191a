// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/Polygons.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace core::mesh {
namespace {

/// A larger fan would consist of needles, which are slow to rasterise. Such polygons are cut by ears instead.
constexpr std::size_t kMostFanCorners = 32;
/// Largest number of tests of a point against an ear for one file. A test takes a few nanoseconds.
constexpr double kMostTests = 1.0e9;

/// Returns twice the signed area: positive if a, b, c turn left. Differences of floats have little rounding error.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Triangulates polygons one by one, and reuses its memory.
class EarCutter
{
public:
    explicit EarCutter(TriangleMesh& mesh) : m_mesh(mesh) {}

    /// Sets the polygon and returns the cost of cutting it: 0 if it can be a fan. Empty if it cannot be cut because it
    /// has no area or winds around more than once.
    std::optional<double> take(const Polygon& polygon)
    {
        const auto* const triangle = m_mesh.triangles.data() + polygon.firstTriangle;
        m_index.assign({triangle[0][0], triangle[0][1]});
        for (std::size_t k = 0; k + 2 < polygon.corners; ++k)
            m_index.push_back(triangle[k][2]);
        if (!project())
            return std::nullopt;
        const std::size_t count = m_index.size();
        std::size_t blunt = 0;
        bool fan = true;
        for (std::size_t k = 0; k < count; ++k) {
            const glm::dvec2& next = m_flat[(k + 1) % count];
            blunt += turn(m_flat[(k + count - 1) % count], m_flat[k], next) <= 0.0 ? 1U : 0U;
            fan = fan && turn(m_flat[0], m_flat[k], next) >= 0.0;
        }
        if (blunt == 0 && !fan)
            return std::nullopt;
        if (blunt == 0 && count <= kMostFanCorners)
            return 0.0;
        return static_cast<double>(count) * (1.0 + static_cast<double>(blunt));
    }

    /// Writes the triangles of the polygon set last. Returns false and writes none if the polygon crosses itself.
    bool cut(const Polygon& polygon)
    {
        const auto count = static_cast<std::uint32_t>(m_index.size());
        m_before.resize(count);
        m_after.resize(count);
        m_isEar.assign(count, false);
        m_blunt.clear();
        for (std::uint32_t k = 0; k < count; ++k) {
            m_before[k] = (k + count - 1) % count;
            m_after[k] = (k + 1) % count;
            if (turnAt(k) <= 0.0)
                m_blunt.push_back(k);
        }
        for (std::uint32_t k = 0; k < count; ++k)
            m_isEar[k] = isEar(k);
        m_cut.clear();
        std::uint32_t at = 0;
        std::uint32_t sinceLast = 0;  // number of corners tested since the last ear
        for (std::uint32_t left = count; left > 3;) {
            // A spike or a corner on a straight line has no area. It is cut off only if no ear is left.
            const bool goes = m_isEar[at] || (sinceLast >= left && turnAt(at) == 0.0);
            if (!goes && ++sinceLast > 2 * left)
                return false;
            const std::uint32_t next = m_after[at];
            if (goes) {
                clip(at);
                --left;
                sinceLast = 0;
                at = m_after[next];  // not its neighbour: cutting every second corner avoids needles
            } else {
                at = next;
            }
        }
        if (turnAt(at) < 0.0)
            return false;
        m_cut.push_back({m_index[m_before[at]], m_index[at], m_index[m_after[at]]});
        std::copy(m_cut.begin(), m_cut.end(), m_mesh.triangles.begin() + polygon.firstTriangle);
        return true;
    }

private:
    /// Projects onto the plane of two axes in which the polygon is largest, counter-clockwise. Returns false if the
    /// polygon has no area.
    bool project()
    {
        const glm::dvec3 origin(m_mesh.vertices[m_index[0]]);
        glm::dvec3 normal(0.0);  // Newell's: twice the area vector
        glm::dvec3 last = glm::dvec3(m_mesh.vertices[m_index.back()]) - origin;
        for (const std::uint32_t index : m_index) {
            const glm::dvec3 p = glm::dvec3(m_mesh.vertices[index]) - origin;
            normal += glm::cross(last, p);
            last = p;
        }
        int axis = std::abs(normal.x) > std::abs(normal.y) ? 0 : 1;
        axis = std::abs(normal.z) >= std::abs(normal[axis]) ? 2 : axis;
        if (normal[axis] == 0.0)
            return false;
        const int u = (axis + (normal[axis] > 0.0 ? 1 : 2)) % 3;
        const int v = (axis + (normal[axis] > 0.0 ? 2 : 1)) % 3;
        m_flat.clear();
        for (const std::uint32_t index : m_index) {
            const glm::vec3& p = m_mesh.vertices[index];
            m_flat.emplace_back(p[u], p[v]);
        }
        return true;
    }

    [[nodiscard]] double turnAt(std::uint32_t k) const
    {
        return turn(m_flat[m_before[k]], m_flat[k], m_flat[m_after[k]]);
    }

    /// Returns whether a corner is sharp and its triangle contains no other corner. Only blunt corners need the test
    /// (Meisters 1975).
    [[nodiscard]] bool isEar(std::uint32_t k) const
    {
        const glm::dvec2& a = m_flat[m_before[k]];
        const glm::dvec2& b = m_flat[k];
        const glm::dvec2& c = m_flat[m_after[k]];
        if (!(turn(a, b, c) > 0.0))
            return false;
        for (const std::uint32_t other : m_blunt) {
            const glm::dvec2& p = m_flat[other];
            // Where a bridge leads to a hole, two corners have the same position.
            if (p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0)
                return false;
        }
        return true;
    }

    void clip(std::uint32_t ear)
    {
        const std::uint32_t before = m_before[ear];
        const std::uint32_t after = m_after[ear];
        m_cut.push_back({m_index[before], m_index[ear], m_index[after]});
        m_after[before] = after;
        m_before[after] = before;
        std::erase_if(m_blunt,
                      [&](std::uint32_t k) { return k == ear || ((k == before || k == after) && turnAt(k) > 0.0); });
        m_isEar[before] = isEar(before);
        m_isEar[after] = isEar(after);
    }

    TriangleMesh& m_mesh;
    std::vector<std::uint32_t> m_index;  ///< vertex of each corner
    std::vector<glm::dvec2> m_flat;      ///< projected position of each corner
    std::vector<std::uint32_t> m_before;
    std::vector<std::uint32_t> m_after;
    std::vector<std::uint32_t> m_blunt;  ///< remaining corners that do not turn left
    std::vector<bool> m_isEar;
    std::vector<std::array<std::uint32_t, 3>> m_cut;
};

}  // namespace

Status cutPolygons(MeshFile& file, const std::vector<Polygon>& polygons, std::string_view name)
{
    EarCutter cutter(file.mesh);
    double tests = 0.0;
    std::size_t crossed = 0;
    for (const Polygon& polygon : polygons) {
        const std::optional<double> cost = cutter.take(polygon);
        if (cost && *cost == 0.0)
            continue;
        tests += cost.value_or(0.0);
        if (tests > kMostTests)
            return unexpected(ErrorCode::BadStructure,
                              std::string(name) +
                                  " has faces with too many corners and notches to cut them into "
                                  "triangles, one of them with " +
                                  std::to_string(polygon.corners) + " corners; export it with triangles only");
        crossed += cost && cutter.cut(polygon) ? 0U : 1U;
    }
    if (crossed > 0)
        file.warnings.push_back(
            std::to_string(crossed) +
            (crossed == 1 ? " face crosses itself or is a mere line" : " faces cross themselves or are mere lines") +
            ", so the surface may be wrong there");
    return {};
}

}  // namespace core::mesh
