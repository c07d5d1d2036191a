// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/Rng.h"

namespace core::contact {

/// What a bur that runs free is felt by: noise across its axis, most of it at 150 to 350 Hz (the 5 kHz of a real one
/// cannot be shown at 1 kHz), of slowly changing strength (docs/facts/haptics.md, section 7).
///
/// n(k) - n(k-2) of uniform random numbers, one a millisecond, or one a tick where ticks are longer: at 1 kHz nothing
/// at 0 and at 500 Hz, most at 250 Hz; and a sum
/// over any 50 ms is that of four numbers, so the mean is nought. Seeded: the same every time. Servo thread; no
/// allocation.
class BurVibration
{
public:
    /// @param rmsN  over time, both axes together; 0: none
    explicit BurVibration(double rmsN) noexcept : m_rmsN(rmsN) {}

    /// Force on the hand for this tick, newtons, tooth frame. Without `running` it is gone within 50 ms.
    glm::dvec3 update(bool running, double seconds) noexcept;
    /// None from now on.
    void stop() noexcept;

private:
    void draw() noexcept;

    static constexpr std::uint64_t kSeed = 5000;
    double m_rmsN;
    Rng m_rng{kSeed};
    std::array<glm::dvec2, 3> m_noise{};  ///< newest first
    double m_sinceDrawnS = 0.0;
    int m_drawn = 0;
    double m_aim = 1.0;    ///< where the strength goes
    double m_level = 0.0;  ///< strength now, about 1 while the bur runs
};

}  // namespace core::contact
