// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/terrain/Rim.h"

#include <cstdlib>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "core/terrain/Tooth.h"

namespace core::terrain {
namespace {

/// Calls visit(index) for each of the up to eight neighbours.
template <class Visit>
void forEachNeighbour(const Grid& grid, int i, int j, Visit visit)
{
    for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di)
            if ((di != 0 || dj != 0) && grid.contains(i + di, j + dj))
                visit(grid.index(i + di, j + dj));
}

/// The normal of the nearest node that is not steep, ring by ring.
std::optional<glm::vec3> nearestGentle(const Grid& grid, std::span<const glm::vec3> normals, int i, int j, int reach)
{
    for (int ring = 1; ring <= reach; ++ring) {
        std::optional<glm::vec3> best;
        int bestDistance = 0;
        for (int dj = -ring; dj <= ring; ++dj)
            for (int di = -ring; di <= ring; ++di) {
                const bool onRing = std::max(std::abs(di), std::abs(dj)) == ring;
                if (!onRing || !grid.contains(i + di, j + dj))
                    continue;
                const glm::vec3& normal = normals[grid.index(i + di, j + dj)];
                const int distance = di * di + dj * dj;
                if (normal.z >= kSteepNormalZ && (!best || distance < bestDistance)) {
                    best = normal;
                    bestDistance = distance;
                }
            }
        if (best)
            return best;
    }
    return std::nullopt;
}

}  // namespace

std::size_t sewRim(const Grid& grid, std::span<const float> top, std::span<const float> bottom, const NodeRect& rect,
                   std::vector<float>& sewn)
{
    sewn.resize(grid.count(), kEmptyTop);
    const NodeRect area = grown(rect, 1, grid);
    std::size_t count = 0;
    for (int j = area.beginJ; j < area.endJ; ++j)
        for (int i = area.beginI; i < area.endI; ++i) {
            const std::size_t here = grid.index(i, j);
            sewn[here] = kEmptyTop;
            if (top[here] > bottom[here])
                continue;
            float sum = 0.0F;
            int solid = 0;
            forEachNeighbour(grid, i, j, [&](std::size_t k) {
                if (top[k] > bottom[k]) {
                    sum += 0.5F * (top[k] + bottom[k]);
                    ++solid;
                }
            });
            if (solid == 0)
                continue;
            sewn[here] = sum / static_cast<float>(solid);
            ++count;
        }
    return count;
}

std::size_t repairRimNormals(const Grid& grid, std::span<const float> sewn, const NodeRect& rect,
                             std::span<glm::vec3> normals, int reach)
{
    std::vector<std::pair<std::size_t, glm::vec3>> repaired;  // put in place at the end: no repair lends to another
    for (int j = rect.beginJ; j < rect.endJ; ++j)
        for (int i = rect.beginI; i < rect.endI; ++i) {
            const std::size_t here = grid.index(i, j);
            const glm::vec3 own = normals[here];
            if (own == glm::vec3(0.0F) || own.z >= kSteepNormalZ)
                continue;
            bool atSeam = sewn[here] != kEmptyTop;
            forEachNeighbour(grid, i, j, [&](std::size_t k) { atSeam = atSeam || sewn[k] != kEmptyTop; });
            if (!atSeam)
                continue;
            if (const auto lent = nearestGentle(grid, normals, i, j, reach))
                if (const glm::vec3 mixed(lent->x, lent->y, own.z); glm::dot(mixed, mixed) > 1.0e-8F)
                    repaired.emplace_back(here, glm::normalize(mixed));
        }
    for (const auto& [index, normal] : repaired)
        normals[index] = normal;
    return repaired.size();
}

}  // namespace core::terrain
