// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/LatticeContact.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace core::contact {
namespace {

/// The bur collides where its underside is below the top and its upper side above the bottom.
bool isFree(LiveTooth& tooth, int i, int j, double z) noexcept
{
    if (!tooth.grid().contains(i, j))
        return z >= tooth.clearanceAt(tooth.grid().nodeMm(i, j));
    return z >= static_cast<double>(tooth.clearanceAtNode(i, j)) ||
           z <= static_cast<double>(tooth.undersideAtNode(i, j));
}

}  // namespace

void LatticeContact::moveTo(const glm::dvec3& anchor) noexcept
{
    m_anchor = anchor;
}

void LatticeContact::restart(const glm::dvec3& device) noexcept
{
    m_anchor = device;
}

glm::dvec3 LatticeContact::update(LiveTooth& tooth, const glm::dvec3& device) noexcept
{
    const terrain::Grid& grid = tooth.grid();
    const double h = grid.cellMm;
    const glm::dvec2 at = grid.latticeOf({m_anchor.x, m_anchor.y});
    // The anchor may have been put anywhere: snap to the lattice, upwards so that it stays free.
    const int i = static_cast<int>(std::lround(at.x));
    const int j = static_cast<int>(std::lround(at.y));
    int k = static_cast<int>(std::ceil(m_anchor.z / h - 1.0e-9));
    for (int climb = 0; climb < grid.side && !isFree(tooth, i, j, k * h); ++climb)
        ++k;

    glm::dvec3 best{};
    double bestDistance = 1.0e30;
    for (int dk = -1; dk <= 1; ++dk) {
        for (int dj = -1; dj <= 1; ++dj) {
            for (int di = -1; di <= 1; ++di) {
                const glm::dvec2 node = grid.nodeMm(i + di, j + dj);
                const glm::dvec3 candidate(node.x, node.y, (k + dk) * h);
                const glm::dvec3 apart = candidate - device;
                const double distance = glm::dot(apart, apart);
                if (distance < bestDistance && isFree(tooth, i + di, j + dj, candidate.z)) {
                    best = candidate;
                    bestDistance = distance;
                }
            }
        }
    }
    if (bestDistance < 1.0e30)
        m_anchor = best;
    return m_anchor;
}

}  // namespace core::contact
