// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Solids.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <glm/vec2.hpp>

namespace support {

using core::mesh::TriangleMesh;

namespace {

std::uint32_t number(std::size_t index)
{
    return static_cast<std::uint32_t>(index);
}

/// Returns a surface of revolution about z: rings of points from the outermost to a tip, closed below by a flat bottom.
TriangleMesh dome(const std::vector<glm::dvec2>& rings, double tip, int segments)
{
    TriangleMesh mesh;
    const auto n = static_cast<std::size_t>(segments);
    for (const glm::dvec2& ring : rings)
        for (std::size_t k = 0; k < n; ++k) {
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
            mesh.vertices.emplace_back(ring.x * std::cos(angle), ring.x * std::sin(angle), ring.y);
        }
    const std::uint32_t top = number(mesh.vertices.size());
    mesh.vertices.emplace_back(0.0F, 0.0F, static_cast<float>(tip));
    const std::uint32_t middle = number(mesh.vertices.size());
    mesh.vertices.emplace_back(0.0F, 0.0F, static_cast<float>(rings.front().y));
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t next = (k + 1) % n;
        mesh.triangles.push_back({middle, number(next), number(k)});
        for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
            const std::uint32_t a = number(r * n + k);
            const std::uint32_t b = number(r * n + next);
            const std::uint32_t c = number((r + 1) * n + next);
            const std::uint32_t d = number((r + 1) * n + k);
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
        mesh.triangles.push_back({number((rings.size() - 1) * n + k), number((rings.size() - 1) * n + next), top});
    }
    return mesh;
}

void append(std::string& bytes, std::uint64_t word, std::size_t size, bool bigEndian = false)
{
    for (std::size_t k = 0; k < size; ++k)
        bytes.push_back(static_cast<char>(word >> (8 * (bigEndian ? size - 1 - k : k))));
}

void append(std::string& bytes, float value, bool bigEndian = false)
{
    append(bytes, std::bit_cast<std::uint32_t>(value), 4, bigEndian);
}

std::string inWords(const glm::vec3& p)
{
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%.9g %.9g %.9g", static_cast<double>(p.x), static_cast<double>(p.y),
                  static_cast<double>(p.z));
    return text.data();
}

std::string plyHeader(const TriangleMesh& mesh, const char* format)
{
    return std::string("ply\nformat ") + format + " 1.0\ncomment made by a test\nelement vertex " +
           std::to_string(mesh.vertices.size()) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

}  // namespace

TriangleMesh box(float x, float y, float z)
{
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k)
        mesh.vertices.emplace_back((k & 1) != 0 ? x : 0.0F, (k & 2) != 0 ? y : 0.0F, (k & 4) != 0 ? z : 0.0F);
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

TriangleMesh cone(float radius, float height, int segments)
{
    return dome({{radius, 0.0}}, height, segments);
}

TriangleMesh sphereCap(float sphereRadius, float height, int segments, int rings)
{
    const double centre = static_cast<double>(height) - static_cast<double>(sphereRadius);
    const double lowest = std::asin(std::clamp(-centre / static_cast<double>(sphereRadius), -1.0, 1.0));
    std::vector<glm::dvec2> circles;
    for (int r = 0; r < rings; ++r) {
        const double angle = lowest + (std::numbers::pi / 2.0 - lowest) * r / rings;
        circles.emplace_back(static_cast<double>(sphereRadius) * std::cos(angle),
                             centre + static_cast<double>(sphereRadius) * std::sin(angle));
    }
    return dome(circles, height, segments);
}

TriangleMesh wedge(float x, float y, float z)
{
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {x, 0, 0}, {0, y, 0}, {x, y, 0}, {0, 0, z}, {0, y, z}};
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {2, 5, 3}, {0, 4, 2}, {2, 4, 5}, {1, 3, 4}, {3, 5, 4}};
    return mesh;
}

TriangleMesh turned(TriangleMesh mesh, double radiansAboutZ)
{
    const double c = std::cos(radiansAboutZ);
    const double s = std::sin(radiansAboutZ);
    for (glm::vec3& v : mesh.vertices)
        v = {static_cast<float>(c * static_cast<double>(v.x) - s * static_cast<double>(v.y)),
             static_cast<float>(s * static_cast<double>(v.x) + c * static_cast<double>(v.y)), v.z};
    return mesh;
}

TriangleMesh moved(TriangleMesh mesh, glm::vec3 by)
{
    for (glm::vec3& v : mesh.vertices)
        v += by;
    return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, float by)
{
    for (glm::vec3& v : mesh.vertices)
        v *= by;
    return mesh;
}

TriangleMesh insideOut(TriangleMesh mesh)
{
    for (auto& t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
}

TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& other)
{
    const std::uint32_t first = number(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& t : other.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return mesh;
}

TriangleMesh withoutBase(TriangleMesh mesh)
{
    const auto below = [](const glm::vec3& a, const glm::vec3& b) { return a.z < b.z; };
    const float lowest = std::min_element(mesh.vertices.begin(), mesh.vertices.end(), below)->z;
    std::erase_if(mesh.triangles, [&](const auto& t) {
        return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.vertices[v].z <= lowest; });
    });
    return mesh;
}

TriangleMesh clampedAt(TriangleMesh mesh, float lowestZ)
{
    for (glm::vec3& vertex : mesh.vertices)
        vertex.z = std::max(vertex.z, lowestZ);
    return mesh;
}

std::string asObj(const TriangleMesh& mesh)
{
    std::string text = "# made by a test\n";
    for (const glm::vec3& v : mesh.vertices)
        text += "v " + inWords(v) + "\n";
    for (const auto& t : mesh.triangles)
        text +=
            "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) + "\n";
    return text;
}

std::string asAsciiStl(const TriangleMesh& mesh)
{
    std::string text = "solid made by a test\n";
    for (const auto& t : mesh.triangles) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (const std::uint32_t corner : t)
            text += "  vertex " + inWords(mesh.vertices[corner]) + "\n";
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid made by a test\n";
}

std::string asBinaryStl(const TriangleMesh& mesh)
{
    std::string bytes(80, ' ');
    append(bytes, mesh.triangles.size(), 4);
    for (const auto& t : mesh.triangles) {
        bytes.append(12, '\0');
        for (const std::uint32_t corner : t)
            for (int k = 0; k < 3; ++k)
                append(bytes, mesh.vertices[corner][k]);
        bytes.append(2, '\0');
    }
    return bytes;
}

std::string asAsciiPly(const TriangleMesh& mesh)
{
    std::string text = plyHeader(mesh, "ascii");
    for (const glm::vec3& v : mesh.vertices)
        text += inWords(v) + "\n";
    for (const auto& t : mesh.triangles)
        text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
    return text;
}

std::string asBinaryPly(const TriangleMesh& mesh, bool bigEndian)
{
    std::string bytes = plyHeader(mesh, bigEndian ? "binary_big_endian" : "binary_little_endian");
    for (const glm::vec3& v : mesh.vertices)
        for (int k = 0; k < 3; ++k)
            append(bytes, v[k], bigEndian);
    for (const auto& t : mesh.triangles) {
        bytes.push_back(3);
        for (const std::uint32_t corner : t)
            append(bytes, corner, 4, bigEndian);
    }
    return bytes;
}

}  // namespace support
