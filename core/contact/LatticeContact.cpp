// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/LatticeContact.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace core::contact {
namespace {

constexpr double kHeightRoundingMm = 1.0e-5;  ///< mm: heights are floats

/// Returns whether the bur is free. It collides where its underside is below the top and its upper side is above the
/// bottom.
/// @param fromAbove  the anchor is above everything, so none of its neighbours is in a notch
bool isFree(LiveTooth& tooth, const glm::dvec3& place, bool fromAbove) noexcept
{
    const glm::dvec2 at(place);
    if (place.z >= tooth.clearanceAt(at, place.z + kHeightRoundingMm) - kHeightRoundingMm)
        return true;
    if (place.z <= tooth.undersideAt(at, place.z - kHeightRoundingMm) + kHeightRoundingMm)
        return true;
    if (fromAbove)
        return false;
    const Room room = tooth.roomAt(at, place.z);  // in a notch, some columns are below the bur and others above
    return place.z >= room.floorMm - kHeightRoundingMm && place.z <= room.roofMm + kHeightRoundingMm;
}

/// Returns the nearest neighbour to `device` for which isAllowed(place) is true, or the anchor itself if there is none.
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
                if (distance < bestDistance && isAllowed(place)) {
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
    if (m_mayBeInside) {
        // Snaps to the lattice, then moves out upwards, which is always free.
        const glm::dvec2 at = glm::round(grid.latticeOf({m_anchor.x, m_anchor.y}));
        const double level = std::ceil(m_anchor.z / m_cellMm - 1.0e-9);
        m_anchor = {grid.nodeMm(static_cast<int>(at.x), static_cast<int>(at.y)), level * m_cellMm};
        for (int climb = 0; climb < grid.side && !isFree(tooth, m_anchor, true); ++climb)
            m_anchor.z += m_cellMm;
        m_mayBeInside = false;
    }
    for (int step = 0; step < m_steps; ++step) {
        const bool fromAbove =
            m_anchor.z >= tooth.clearanceAt(glm::dvec2(m_anchor), m_anchor.z + kHeightRoundingMm) - kHeightRoundingMm;
        const glm::dvec3 next = nearestNeighbour(
            m_anchor, m_cellMm, device, [&](const glm::dvec3& place) { return isFree(tooth, place, fromAbove); });
        if (next == m_anchor)
            break;
        m_anchor = next;
    }
    const glm::dvec3 apart = glm::abs(device - m_anchor);
    if (std::max({apart.x, apart.y, apart.z}) <= 0.5 * m_cellMm + kHeightRoundingMm && isFree(tooth, device, false))
        return device;
    return m_anchor;
}

glm::dvec3 LatticeContact::cutTowards(const glm::dvec3& device) const noexcept
{
    return nearestNeighbour(m_anchor, m_cellMm, device, [](const glm::dvec3&) { return true; });
}

}  // namespace core::contact
