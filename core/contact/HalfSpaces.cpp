// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/HalfSpaces.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/contact/Lengths.h"

namespace core::contact {
namespace {

constexpr double kRoundingMm = 1.0e-9;
constexpr double kParallel = 1.0e-10;  ///< squared sine below which two planes count as one direction

}  // namespace

void HalfSpaces::add(const HalfSpace& space) noexcept
{
    if (m_count == kMost) {
        std::copy(m_planes.begin() + 1, m_planes.end(), m_planes.begin());
        --m_count;
    }
    m_planes[m_count++] = space;
}

bool HalfSpaces::holds(const glm::dvec3& point) const noexcept
{
    for (std::size_t k = 0; k < m_count; ++k)
        if (glm::dot(m_planes[k].normal, point) < m_planes[k].offset - kRoundingMm)
            return false;
    return true;
}

/// Computes the nearest point in all half-spaces. It is on none, one, two or three of the planes, so it is the nearest
/// of the perpendicular foot points on such sets that are in all half-spaces.
bool HalfSpaces::nearest(const glm::dvec3& to, glm::dvec3& point) const noexcept
{
    if (holds(to)) {
        point = to;
        return true;
    }
    const auto lack = [&](std::size_t k) { return m_planes[k].offset - glm::dot(m_planes[k].normal, to); };
    for (std::size_t a = 0; a < m_count; ++a) {
        const glm::dvec3 foot = to + m_planes[a].normal * lack(a);
        if (lack(a) > 0.0 && holds(foot)) {
            point = foot;
            return true;
        }
    }
    double best = 1.0e30;
    const auto take = [&](const glm::dvec3& foot) {
        if (holds(foot) && distance2(foot, to) < best) {
            best = distance2(foot, to);
            point = foot;
        }
    };
    for (std::size_t a = 0; a < m_count; ++a) {
        for (std::size_t b = a + 1; b < m_count; ++b) {
            const glm::dvec3& na = m_planes[a].normal;
            const glm::dvec3& nb = m_planes[b].normal;
            const double cosine = glm::dot(na, nb);
            const double sine2 = 1.0 - cosine * cosine;
            if (sine2 < kParallel)
                continue;
            const double shareA = (lack(a) - cosine * lack(b)) / sine2;
            const double shareB = (lack(b) - cosine * lack(a)) / sine2;
            take(to + na * shareA + nb * shareB);
            const glm::dvec3 edge = glm::cross(na, nb);
            for (std::size_t c = b + 1; c < m_count; ++c) {
                const glm::dvec3& nc = m_planes[c].normal;
                const double volume = glm::dot(edge, nc);
                if (volume * volume < kParallel)
                    continue;
                take(to + (glm::cross(nb, nc) * lack(a) + glm::cross(nc, na) * lack(b) + edge * lack(c)) / volume);
            }
        }
    }
    return best < 1.0e30;
}

}  // namespace core::contact
