// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/Weld.h"

#include <bit>
#include <cstddef>
#include <limits>

namespace core::mesh {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

std::uint64_t mixed(std::uint64_t hash)
{
    hash = (hash ^ (hash >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    hash = (hash ^ (hash >> 27U)) * 0x94D049BB133111EBULL;
    return hash ^ (hash >> 31U);
}

std::size_t hashOf(const glm::vec3& p)
{
    const auto word = [](float value) { return static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(value)); };
    return mixed(mixed(word(p.x) | word(p.y) << 32U) + word(p.z));
}

}  // namespace

void weldByPosition(TriangleMesh& mesh)
{
    std::vector<std::uint32_t> renamed(mesh.vertices.size(), kNone);
    std::vector<glm::vec3> distinct;
    distinct.reserve(std::min(mesh.vertices.size(), mesh.triangles.size()));
    // Open addressing, at most half full. The table stores every position once, as its index in `distinct`.
    std::vector<std::uint32_t> table(std::bit_ceil(2 * mesh.vertices.size() + 1), kNone);
    const std::size_t mask = table.size() - 1;
    for (auto& triangle : mesh.triangles)
        for (std::uint32_t& corner : triangle) {
            std::uint32_t& known = renamed[corner];
            if (known == kNone) {
                const glm::vec3 position = mesh.vertices[corner] + 0.0F;  // -0 becomes 0
                std::size_t slot = hashOf(position) & mask;
                while (table[slot] != kNone && distinct[table[slot]] != position)
                    slot = (slot + 1) & mask;
                if (table[slot] == kNone) {
                    table[slot] = static_cast<std::uint32_t>(distinct.size());
                    distinct.push_back(position);
                }
                known = table[slot];
            }
            corner = known;
        }
    mesh.vertices = std::move(distinct);
}

}  // namespace core::mesh
