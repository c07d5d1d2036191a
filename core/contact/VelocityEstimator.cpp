// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/VelocityEstimator.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace core::contact {
namespace {

/// Size of a count of the Falcon: 0.048 mm sideways and 0.028 mm along its axis (docs/facts/haptics.md, section 5).
/// With a smaller value, a device at rest between two counts would seem to move at 30 mm/s.
constexpr double kCountMm = 0.05;
/// 1 / n: weight of the distance to the n-th last position, for a tick.
constexpr auto kShares = [] {
    std::array<double, 16> shares{};
    for (std::size_t n = 1; n < shares.size(); ++n)
        shares[n] = 1.0 / static_cast<double>(n);
    return shares;
}();
/// Largest change of the reading along an axis when one arm moves by one count, up to 20 mm from the middle.
constexpr double kArmCountMm = 0.045;
constexpr double kProvenS = 0.003;
constexpr double kCornerRadPerS = 2.0 * 3.14159265358979 * 240.0;

}  // namespace

void VelocityEstimator::restart(const glm::dvec3& placeMm) noexcept
{
    m_places.fill(placeMm);
    m_mmPerS = glm::dvec3(0.0);
}

glm::dvec3 VelocityEstimator::perTick() const noexcept
{
    const glm::dvec3& now = ago(0);
    static_assert(kShares.size() == kWindow);
    glm::dvec3 known = now - ago(1);
    // Bounds of the slope of a line through the newest position that is within a count of every position so far.
    glm::dvec3 least = known - kCountMm;
    glm::dvec3 most = known + kCountMm;
    for (std::size_t n = 2; n < kWindow; ++n) {
        const double share = kShares[n];
        const glm::dvec3 line = (now - ago(n)) * share;
        if (line.x < least.x || line.y < least.y || line.z < least.z || line.x > most.x || line.y > most.y ||
            line.z > most.z)
            return known;
        known = line;
        least = glm::max(least, line - kCountMm * share);
        most = glm::min(most, line + kCountMm * share);
    }
    return known;
}

void VelocityEstimator::add(const glm::dvec3& placeMm, double seconds) noexcept
{
    m_newest = (m_newest + 1) % kWindow;
    m_places[m_newest] = placeMm;
    if (!(seconds > 0.0))
        return;
    const double share = kCornerRadPerS * seconds / (1.0 + kCornerRadPerS * seconds);
    m_mmPerS += (perTick() / seconds - m_mmPerS) * share;
}

glm::dvec3 VelocityEstimator::provenMmPerS(double seconds) const noexcept
{
    glm::dvec3 proven(0.0);
    if (!(seconds > 0.0))
        return proven;
    const auto longest = static_cast<std::size_t>(std::clamp(kProvenS / seconds + 0.5, 1.0, kWindow - 1.0));
    for (std::size_t n = 1; n <= longest; ++n) {
        const glm::dvec3 way = ago(0) - ago(n);
        for (int axis = 0; axis < 3; ++axis) {
            // A long distance counts fully, and one within a count does not count (nonnegative garrote).
            const double length = std::abs(way[axis]);
            const double sure = length > kArmCountMm ? length - kArmCountMm * kArmCountMm / length : 0.0;
            const double mmPerS = sure / (static_cast<double>(n) * seconds);
            if (mmPerS > std::abs(proven[axis]))
                proven[axis] = std::copysign(mmPerS, way[axis]);
        }
    }
    return proven;
}

}  // namespace core::contact
