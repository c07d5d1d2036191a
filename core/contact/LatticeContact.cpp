// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/LatticeContact.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace core::contact {
namespace {

constexpr double kRounding = 1.0e-5;  ///< mm: heights are floats

/// The bur collides where its underside is below the top and its upper side above the bottom.
bool isFree(LiveTooth& tooth, int i, int j, double z) noexcept
{
    const glm::dvec2 place = tooth.grid().nodeMm(i, j);
    if (!tooth.grid().contains(i, j))
        return z >= tooth.clearanceAt(place);
    if (z >= static_cast<double>(tooth.clearanceAtNode(i, j)) - kRounding ||
        z <= static_cast<double>(tooth.undersideAtNode(i, j)) + kRounding)
        return true;
    if (!tooth.isFeltByColumns(place))
        return false;
    const Room room = tooth.roomAt(place, z);  // a notch: some columns beneath the bur, others above
    return z >= room.floorMm - kRounding && z <= room.roofMm + kRounding;
}

/// The nearest to `device` of the neighbours that `isAllowed(di, dj, place)`; the anchor itself if there is none.
template <class IsAllowed>
glm::dvec3 nearestNeighbour(const glm::dvec3& anchor, double cell, const glm::dvec3& device,
                            IsAllowed&& isAllowed) noexcept
{
    glm::dvec3 best = anchor;
    double bestDistance = 1.0e30;
    for (int dk = -1; dk <= 1; ++dk) {
        for (int dj = -1; dj <= 1; ++dj) {
            for (int di = -1; di <= 1; ++di) {
                const glm::dvec3 place = anchor + cell * glm::dvec3(di, dj, dk);
                const glm::dvec3 apart = place - device;
                const double distance = glm::dot(apart, apart);
                if (distance < bestDistance && isAllowed(di, dj, place)) {
                    best = place;
                    bestDistance = distance;
                }
            }
        }
    }
    return best;
}

}  // namespace

void LatticeContact::restart(const glm::dvec3& device) noexcept
{
    m_anchor = device;
    m_mayBeInside = true;
}

glm::dvec3 LatticeContact::update(LiveTooth& tooth, const glm::dvec3& device) noexcept
{
    const terrain::Grid& grid = tooth.grid();
    m_cellMm = grid.cellMm;
    const glm::dvec2 at = grid.latticeOf({m_anchor.x, m_anchor.y});
    const int i = static_cast<int>(std::lround(at.x));
    const int j = static_cast<int>(std::lround(at.y));
    if (m_mayBeInside) {
        // Snap to the lattice, then out by the way that is always open.
        int k = static_cast<int>(std::ceil(m_anchor.z / m_cellMm - 1.0e-9));
        for (int climb = 0; climb < grid.side && !isFree(tooth, i, j, k * m_cellMm); ++climb)
            ++k;
        m_anchor = {grid.nodeMm(i, j), k * m_cellMm};
        m_mayBeInside = false;
    }
    m_anchor = nearestNeighbour(m_anchor, m_cellMm, device, [&](int di, int dj, const glm::dvec3& place) {
        return isFree(tooth, i + di, j + dj, place.z);
    });
    return m_anchor;
}

glm::dvec3 LatticeContact::cutTowards(const glm::dvec3& device) const noexcept
{
    return nearestNeighbour(m_anchor, m_cellMm, device, [](int, int, const glm::dvec3&) { return true; });
}

}  // namespace core::contact
