// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/PaceMeter.h"

#include <glm/geometric.hpp>

namespace core::contact {
namespace {

/// A count of the Falcon: 0.048 mm sideways, 0.028 along its axis (haptics.md section 5).
constexpr double kCountMm = 0.05;
constexpr double kCornerRadPerS = 2.0 * 3.14159265358979 * 240.0;

}  // namespace

void PaceMeter::restart(const glm::dvec3& placeMm) noexcept
{
    m_places.fill(placeMm);
    m_mmPerS = glm::dvec3(0.0);
}

glm::dvec3 PaceMeter::perTick() const noexcept
{
    const glm::dvec3& now = ago(0);
    glm::dvec3 known = now - ago(1);
    for (std::size_t n = 2; n < kWindow; ++n) {
        const glm::dvec3 line = (now - ago(n)) / static_cast<double>(n);
        for (std::size_t k = 1; k < n; ++k) {
            const glm::dvec3 off = now - line * static_cast<double>(k) - ago(k);
            if (glm::dot(off, off) > kCountMm * kCountMm)
                return known;
        }
        known = line;
    }
    return known;
}

void PaceMeter::add(const glm::dvec3& placeMm, double seconds) noexcept
{
    m_newest = (m_newest + 1) % kWindow;
    m_places[m_newest] = placeMm;
    if (!(seconds > 0.0))
        return;
    const double share = kCornerRadPerS * seconds / (1.0 + kCornerRadPerS * seconds);
    m_mmPerS += (perTick() / seconds - m_mmPerS) * share;
}

}  // namespace core::contact
