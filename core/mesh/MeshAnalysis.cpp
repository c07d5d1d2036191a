// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/MeshAnalysis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

namespace core::mesh {
namespace {

using Corners = std::array<std::uint32_t, 3>;

bool isCollapsed(const Corners& t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Groups connected triangles (union-find with path halving).
class Groups
{
public:
    explicit Groups(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), 0U); }
    std::uint32_t find(std::uint32_t a)
    {
        while (m_parent[a] != a)
            a = m_parent[a] = m_parent[m_parent[a]];
        return a;
    }
    void merge(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        m_parent[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> m_parent;
};

/// One use of an edge by a face, stored under the edge's lower vertex.
struct EdgeUse
{
    std::uint32_t highVertex;
    std::uint32_t faceAndDirection;  ///< face * 2, plus 1 where the face runs from the higher to the lower vertex
};

struct EdgeUses
{
    std::vector<std::uint32_t> begin;  ///< [vertex + 1]
    std::vector<EdgeUse> uses;         ///< by lower vertex, then by higher vertex, then by face
};

/// Sorts by lower vertex (counting sort), then sorts the few edges of each vertex.
EdgeUses collectEdges(const TriangleMesh& mesh)
{
    EdgeUses edges;
    edges.begin.assign(mesh.vertices.size() + 1, 0);
    const auto forEachEdge = [&](auto&& visit) {
        for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
            const Corners& t = mesh.triangles[face];
            if (isCollapsed(t))
                continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t from = t[k];
                const std::uint32_t to = t[(k + 1) % 3];
                visit(std::min(from, to), std::max(from, to), face * 2 + (from > to ? 1U : 0U));
            }
        }
    };
    forEachEdge([&](std::uint32_t low, std::uint32_t, std::uint32_t) { ++edges.begin[low + 1]; });
    std::partial_sum(edges.begin.begin(), edges.begin.end(), edges.begin.begin());
    edges.uses.resize(edges.begin.back());
    std::vector<std::uint32_t> next(edges.begin.begin(), edges.begin.end() - 1);
    forEachEdge([&](std::uint32_t low, std::uint32_t high, std::uint32_t use) {
        edges.uses[next[low]++] = {high, use};
    });
    for (std::size_t v = 0; v + 1 < edges.begin.size(); ++v)
        std::sort(edges.uses.begin() + edges.begin[v], edges.uses.begin() + edges.begin[v + 1],
                  [](const EdgeUse& a, const EdgeUse& b) {
                      return std::pair(a.highVertex, a.faceAndDirection) < std::pair(b.highVertex, b.faceAndDirection);
                  });
    return edges;
}

std::size_t countDuplicates(const TriangleMesh& mesh)
{
    // Stored by lowest vertex. A vertex has few faces, so the lists are short.
    std::vector<std::uint32_t> begin(mesh.vertices.size() + 1, 0);
    for (const Corners& t : mesh.triangles)
        if (!isCollapsed(t))
            ++begin[std::min({t[0], t[1], t[2]}) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> others(begin.back());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (Corners t : mesh.triangles) {
        if (isCollapsed(t))
            continue;
        std::sort(t.begin(), t.end());
        others[next[t[0]]++] = {t[1], t[2]};
    }
    std::size_t duplicates = 0;
    for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
        const auto first = others.begin() + begin[v];
        const auto last = others.begin() + begin[v + 1];
        std::sort(first, last);
        for (auto it = first; it != last; ++it)
            duplicates += it != first && *it == *(it - 1) ? 1U : 0U;
    }
    return duplicates;
}

/// Returns whether a ray from the point along +z crosses the shell an odd number of times.
bool encloses(const TriangleMesh& mesh, const MeshFacts& facts, std::uint32_t shell, const glm::dvec3& p)
{
    bool odd = false;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        if (facts.shellOf[k] != shell)
            continue;
        const Corners& t = mesh.triangles[k];
        const std::array<glm::dvec3, 3> c{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
        // The interval is half-open in y, so that a ray through a shared edge or corner counts once.
        bool insideOutline = false;
        for (std::size_t a = 0, b = 2; a < 3; b = a++)
            if ((c[a].y > p.y) != (c[b].y > p.y) &&
                p.x < (c[b].x - c[a].x) * (p.y - c[a].y) / (c[b].y - c[a].y) + c[a].x)
                insideOutline = !insideOutline;
        if (!insideOutline)
            continue;
        const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
        if (normal.z != 0.0 && c[0].z - (normal.x * (p.x - c[0].x) + normal.y * (p.y - c[0].y)) / normal.z > p.z)
            odd = !odd;
    }
    return odd;
}

void findNested(const TriangleMesh& mesh, MeshFacts& facts)
{
    // Every test visits the whole mesh, so the number of shells is limited.
    if (facts.shells.size() < 2 || facts.shells.size() > kMostNestedShells)
        return;
    std::vector<glm::dvec3> probe(facts.shells.size());
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
        if (facts.shellOf[k] != kNoShell)
            probe[facts.shellOf[k]] = mesh.vertices[mesh.triangles[k][0]];
    for (std::uint32_t inner = 0; inner < facts.shells.size(); ++inner)
        for (std::uint32_t outer = 0; outer < facts.shells.size(); ++outer) {
            const Shell& in = facts.shells[inner];
            const Shell& out = facts.shells[outer];
            const bool boxInBox = in.low.x > out.low.x && in.low.y > out.low.y && in.low.z > out.low.z &&
                                  in.high.x < out.high.x && in.high.y < out.high.y && in.high.z < out.high.z;
            // The largest shell that encloses this one is the outermost.
            const bool outermost = !in.inside || std::abs(out.volume) > std::abs(facts.shells[*in.inside].volume);
            if (inner != outer && out.closed && boxInBox && outermost && encloses(mesh, facts, outer, probe[inner]))
                facts.shells[inner].inside = outer;
        }
}

void measure(const TriangleMesh& mesh, MeshFacts& facts)
{
    facts.low = glm::dvec3(std::numeric_limits<double>::max());
    facts.high = -facts.low;
    for (const Corners& t : mesh.triangles)
        for (const std::uint32_t v : t) {
            facts.low = glm::min(facts.low, glm::dvec3(mesh.vertices[v]));
            facts.high = glm::max(facts.high, glm::dvec3(mesh.vertices[v]));
        }
    for (Shell& shell : facts.shells) {
        shell.low = facts.high;
        shell.high = facts.low;
    }
    // Computed relative to the middle of the box, so that no digits are lost far from the origin.
    const glm::dvec3 middle = (facts.low + facts.high) * 0.5;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const Corners& t = mesh.triangles[k];
        const std::array<glm::dvec3, 3> c{glm::dvec3(mesh.vertices[t[0]]) - middle,
                                          glm::dvec3(mesh.vertices[t[1]]) - middle,
                                          glm::dvec3(mesh.vertices[t[2]]) - middle};
        const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
        const double area = 0.5 * glm::length(normal);
        const double volume = glm::dot(c[0], glm::cross(c[1], c[2])) / 6.0;
        facts.zeroAreaFaces += area == 0.0 ? 1U : 0U;
        facts.area += area;
        facts.areaVector += 0.5 * normal;
        facts.volume += volume;
        if (facts.shellOf[k] == kNoShell)
            continue;
        Shell& shell = facts.shells[facts.shellOf[k]];
        ++shell.triangles;
        shell.volume += volume;
        for (const glm::dvec3& corner : c) {
            shell.low = glm::min(shell.low, corner + middle);
            shell.high = glm::max(shell.high, corner + middle);
        }
    }
}

}  // namespace

MeshFacts analyse(const TriangleMesh& mesh)
{
    MeshFacts facts;
    facts.triangles = mesh.triangles.size();
    facts.vertices = mesh.vertices.size();
    if (mesh.triangles.empty())
        return facts;

    const EdgeUses edges = collectEdges(mesh);
    Groups pieces(mesh.triangles.size());
    std::vector<std::uint32_t> openFaces;     // a face at each boundary or non-manifold edge
    std::vector<std::uint32_t> flippedFaces;  // a face at each flipped edge
    for (std::uint32_t low = 0; low < mesh.vertices.size(); ++low) {
        for (std::size_t begin = edges.begin[low], end = begin; begin < edges.begin[low + 1]; begin = end) {
            const std::uint32_t high = edges.uses[begin].highVertex;
            std::size_t backwards = 0;
            const std::uint32_t face = edges.uses[begin].faceAndDirection / 2;
            for (; end < edges.begin[low + 1] && edges.uses[end].highVertex == high; ++end) {
                backwards += edges.uses[end].faceAndDirection % 2;
                pieces.merge(face, edges.uses[end].faceAndDirection / 2);
            }
            if (end - begin == 1) {
                ++facts.boundaryEdges;
                facts.openEdges.push_back(backwards == 0 ? std::array{low, high} : std::array{high, low});
            } else if (end - begin > 2) {
                ++facts.nonManifoldEdges;
            } else if (backwards != 1) {
                ++facts.flippedEdges;
                flippedFaces.push_back(face);
            }
            if (end - begin != 2)
                openFaces.push_back(face);
        }
    }

    // A mesh may have millions of small pieces, so memory is reserved once.
    std::size_t pieceCount = 0;
    for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k)
        pieceCount += pieces.find(k) == k && !isCollapsed(mesh.triangles[k]) ? 1U : 0U;
    facts.shells.reserve(pieceCount);
    facts.shellOf.assign(mesh.triangles.size(), kNoShell);
    std::vector<std::uint32_t> shellOfRoot(mesh.triangles.size(), kNoShell);
    for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k) {
        if (isCollapsed(mesh.triangles[k])) {
            ++facts.collapsedFaces;
            continue;
        }
        std::uint32_t& shell = shellOfRoot[pieces.find(k)];
        if (shell == kNoShell) {
            shell = static_cast<std::uint32_t>(facts.shells.size());
            facts.shells.emplace_back();
        }
        facts.shellOf[k] = shell;
    }
    for (const std::uint32_t face : openFaces)
        facts.shells[facts.shellOf[face]].closed = facts.shells[facts.shellOf[face]].oriented = false;
    for (const std::uint32_t face : flippedFaces)
        facts.shells[facts.shellOf[face]].oriented = false;
    facts.closed = !facts.shells.empty() && facts.boundaryEdges == 0 && facts.nonManifoldEdges == 0;
    facts.oriented = facts.closed && facts.flippedEdges == 0;
    facts.duplicateFaces = countDuplicates(mesh);
    measure(mesh, facts);
    findNested(mesh, facts);
    return facts;
}

std::size_t turnOutwards(TriangleMesh& mesh, MeshFacts& facts)
{
    std::vector<bool> turn(facts.shells.size(), false);
    std::size_t insideOut = 0;
    for (std::size_t k = 0; k < facts.shells.size(); ++k) {
        turn[k] = !facts.shells[k].inside && facts.shells[k].oriented && facts.shells[k].volume < 0.0;
        insideOut += turn[k] ? 1U : 0U;
    }
    if (insideOut == 0)
        return 0;
    for (std::size_t k = 0; k < facts.shells.size(); ++k)
        if (const auto& outer = facts.shells[k].inside)
            turn[k] = turn[*outer];
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
        if (facts.shellOf[k] != kNoShell && turn[facts.shellOf[k]])
            std::swap(mesh.triangles[k][1], mesh.triangles[k][2]);
    facts.volume = 0.0;
    for (std::size_t k = 0; k < facts.shells.size(); ++k) {
        if (turn[k])
            facts.shells[k].volume = -facts.shells[k].volume;
        facts.volume += facts.shells[k].volume;
    }
    return insideOut;
}

}  // namespace core::mesh
