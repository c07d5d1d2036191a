// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

namespace core::contact {

/// How fast a point moves that is known only to a count of an encoder, once a tick.
///
/// The pace is that of the longest straight line back in time which all places since lie within a count of: long at
/// rest, where a count more or less says nothing, and a tick or two where the point is fast (first-order adaptive
/// windowing, Janabi-Sharifi, Hayward, Chen 2000); then one pole, against the jumps from one window to another. A
/// backward difference instead has a step of 30 to 50 mm/s (docs/facts/haptics.md, section 2.6). Servo thread; no
/// allocation.
class VelocityEstimator
{
public:
    /// Forgets what was: the point rests at `placeMm`.
    void restart(const glm::dvec3& placeMm) noexcept;
    void add(const glm::dvec3& placeMm, double seconds) noexcept;

    [[nodiscard]] const glm::dvec3& mmPerS() const noexcept { return m_mmPerS; }

    /// What of the pace the places of the last 3 ms prove, whatever the counts hide: along each axis 0 until the point
    /// has moved farther than a count, then soon all of it. A point that rests or creeps shows none; but in a swing of
    /// 0.15 mm with 20 Hz this is late by 1 to 2 ms where mmPerS() is by 5.
    /// @param seconds  of a tick
    [[nodiscard]] glm::dvec3 provenMmPerS(double seconds) const noexcept;

private:
    static constexpr std::size_t kWindow = 16;
    [[nodiscard]] glm::dvec3 perTick() const noexcept;
    [[nodiscard]] const glm::dvec3& ago(std::size_t ticks) const noexcept
    {
        return m_places[(m_newest + kWindow - ticks) % kWindow];
    }

    std::array<glm::dvec3, kWindow> m_places{};  ///< ring
    std::size_t m_newest = 0;
    glm::dvec3 m_mmPerS{0.0};
};

}  // namespace core::contact
