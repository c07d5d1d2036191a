// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/terrain/Rim.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/terrain/Tooth.h"

namespace core::terrain {
namespace {

/// Calls visit(index) for each of the up to eight neighbours of a node.
template <class Visit>
void forEachNeighbour(const Grid& grid, int i, int j, Visit visit)
{
    for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di)
            if ((di != 0 || dj != 0) && grid.contains(i + di, j + dj))
                visit(grid.index(i + di, j + dj));
}

}  // namespace

std::size_t sewRim(const Grid& grid, std::span<const float> top, std::span<const float> bottom, const NodeRect& rect,
                   std::vector<float>& sewn)
{
    assert(top.size() == grid.count() && bottom.size() == grid.count());
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

void calmSteepNormals(const Grid& grid, std::span<const glm::vec3> normals, const NodeRect& rect,
                      std::span<glm::vec3> calm)
{
    assert(normals.size() == grid.count() && calm.size() == grid.count());
    constexpr float kBlendIn = 0.2F;  ///< of z, from where steep begins
    constexpr float kFade = 0.1F;     ///< of the weight with the square of the distance, in nodes
    std::array<float, 2 * kCalmReach * kCalmReach + 1> fades{};
    for (std::size_t far2 = 0; far2 < fades.size(); ++far2)
        fades[far2] = std::exp(-kFade * static_cast<float>(far2));
    for (int j = rect.beginJ; j < rect.endJ; ++j)
        for (int i = rect.beginI; i < rect.endI; ++i) {
            const glm::vec3 own = normals[grid.index(i, j)];
            glm::vec3& out = calm[grid.index(i, j)];
            out = own;
            if (own == glm::vec3(0.0F) || std::abs(own.z) >= kSteepNormalZ)
                continue;
            glm::vec3 sum{0.0F};
            for (int dj = -kCalmReach; dj <= kCalmReach; ++dj)
                for (int di = -kCalmReach; di <= kCalmReach; ++di) {
                    if (!grid.contains(i + di, j + dj))
                        continue;
                    const glm::vec3& near = normals[grid.index(i + di, j + dj)];
                    const float steep = std::max(0.0F, kSteepNormalZ - std::abs(near.z));
                    const float alike = std::max(0.0F, glm::dot(near, own));
                    sum += steep * alike * alike * fades[static_cast<std::size_t>(di * di + dj * dj)] * near;
                }
            if (glm::dot(sum, sum) < 1.0e-12F)
                continue;
            const float share = std::min(1.0F, (kSteepNormalZ - std::abs(own.z)) / kBlendIn);
            out = glm::normalize(glm::mix(own, glm::normalize(sum), share));
        }
}

}  // namespace core::terrain
