// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/Beside.h"

#include <limits>
#include <map>
#include <mutex>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include "core/teeth/Arch.h"

namespace core::teeth {
namespace {

constexpr int kGridSide = 300;  ///< about a tenth of a millimetre a cell

std::shared_ptr<const terrain::HeightMaps> made(int fdi)
{
    mesh::TriangleMesh both;
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (const ArchPiece& piece : Arch().neighbours(fdi)) {
        if (!piece.tooth)
            continue;
        const auto first = static_cast<std::uint32_t>(both.vertices.size());
        for (const LookVertex& vertex : piece.mesh->vertices) {
            const glm::dvec3 at(piece.place * glm::dvec4(glm::dvec3(vertex.positionMm), 1.0));
            both.vertices.emplace_back(at);
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
        const std::vector<std::uint32_t>& indices = piece.mesh->indices;
        for (std::size_t k = 0; k + 2 < indices.size(); k += 3)
            both.triangles.push_back({first + indices[k], first + indices[k + 1], first + indices[k + 2]});
    }
    if (both.triangles.empty())
        return nullptr;
    const terrain::Grid grid = terrain::fitGrid({low.x, low.y}, {high.x, high.y}, kGridSide);
    return std::make_shared<const terrain::HeightMaps>(terrain::rasterise(both, grid, low.z));
}

}  // namespace

std::shared_ptr<const terrain::HeightMaps> teethBeside(int fdi)
{
    static std::mutex guard;
    static std::map<int, std::shared_ptr<const terrain::HeightMaps>> known;
    const std::lock_guard lock(guard);
    const auto found = known.find(fdi);
    return found != known.end() ? found->second : known.emplace(fdi, made(fdi)).first->second;
}

}  // namespace core::teeth
