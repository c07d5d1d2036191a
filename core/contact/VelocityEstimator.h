// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

namespace core::contact {

/// Estimates the velocity of a point from positions that are quantised to encoder counts, once per tick.
///
/// The estimate is that of the longest straight line back in time that all positions since then match within a count: a
/// long window at rest, where a single count has no meaning, and a tick or two for a fast point (first-order adaptive
/// windowing, Janabi-Sharifi, Hayward, Chen 2000); then one pole, against the jumps between windows. A backward
/// difference would have steps of 30 to 50 mm/s (docs/facts/haptics.md, section 2.6). Servo thread; no allocation.
class VelocityEstimator
{
public:
    /// Resets the estimator: the point is at rest at `placeMm`.
    void restart(const glm::dvec3& placeMm) noexcept;
    void add(const glm::dvec3& placeMm, double seconds) noexcept;

    [[nodiscard]] const glm::dvec3& mmPerS() const noexcept { return m_mmPerS; }

    /// Returns the part of the velocity that the positions of the last 3 ms prove despite quantisation: along each axis
    /// 0 until the point has moved farther than a count, then soon all of it. A point that rests or creeps has none; in
    /// a swing of 0.15 mm with 20 Hz the delay is 1 to 2 ms, while that of mmPerS() is 5.
    /// @param seconds  duration of a tick
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
