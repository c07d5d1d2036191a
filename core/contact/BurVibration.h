// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/Rng.h"

namespace core::contact {

/// Computes the vibration that the hand feels while the bur turns freely: noise perpendicular to the axis of the bur,
/// mostly between 150 and 350 Hz, with a slowly changing amplitude (docs/facts/haptics.md, section 7). A real bur
/// vibrates at 5 kHz, which a loop of 1 kHz cannot produce.
///
/// The noise is n(k) - n(k-2) of uniform random numbers n, one per millisecond, or one per tick if ticks are longer. At
/// 1 kHz its spectrum is zero at 0 and 500 Hz and largest at 250 Hz. A sum over any 50 ms has only four numbers left,
/// so the mean is zero. The seed is fixed: each run gives the same noise. Servo thread; no allocation.
class BurVibration
{
public:
    /// @param rmsN  over time, both axes together; 0: no vibration
    explicit BurVibration(double rmsN) noexcept : m_rmsN(rmsN) {}

    /// Returns the force on the hand for this tick, N, tooth frame. Ends within 50 ms when `running` is false.
    glm::dvec3 update(bool running, double seconds) noexcept;
    /// Stops the vibration at once.
    void stop() noexcept;

private:
    void draw() noexcept;

    static constexpr std::uint64_t kSeed = 5000;
    double m_rmsN;
    Rng m_rng{kSeed};
    std::array<glm::dvec2, 3> m_noise{};  ///< newest first
    double m_sinceDrawnS = 0.0;
    int m_drawn = 0;
    double m_aim = 1.0;    ///< target of the strength
    double m_level = 0.0;  ///< current strength, about 1 while the bur runs
};

}  // namespace core::contact
