// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/BurVibration.h"

#include <algorithm>

namespace core::contact {
namespace {

constexpr double kDrawS = 0.001;
constexpr int kDrawsPerAim = 80;  ///< number of draws after which the strength gets a new target
constexpr double kWeakest = 0.6;
constexpr double kStrongest = 1.4;
constexpr double kLevelS = 0.03;  ///< time constant of the strength
constexpr double kStopS = 0.01;   ///< the same when the bur stops
constexpr double kNothing = 0.01;
/// There are two axes, each of variance 2/3 and together of variance 1: n is this factor times uniform in [-1, 1).
constexpr double kScale = 0.8660254037844386;

}  // namespace

void BurVibration::stop() noexcept
{
    m_level = 0.0;
}

void BurVibration::draw() noexcept
{
    m_noise[2] = m_noise[1];
    m_noise[1] = m_noise[0];
    m_noise[0] = kScale * glm::dvec2(m_rng.uniform(-1.0, 1.0), m_rng.uniform(-1.0, 1.0));
    if (++m_drawn == kDrawsPerAim) {
        m_drawn = 0;
        m_aim = m_rng.uniform(kWeakest, kStrongest);
    }
}

glm::dvec3 BurVibration::update(bool running, double seconds) noexcept
{
    if (!(m_rmsN > 0.0))
        return glm::dvec3(0.0);
    const double aim = running ? m_aim : 0.0;
    m_level += (aim - m_level) * std::min(1.0, seconds / (running ? kLevelS : kStopS));
    if (!running && m_level < kNothing)
        m_level = 0.0;
    if (!(m_level > 0.0))
        return glm::dvec3(0.0);
    // Allows half a nanosecond, because a millisecond is not exact in binary. There is at most one draw per tick: with
    // several, the sum over 50 ms would no longer be that of four numbers.
    m_sinceDrawnS += seconds;
    if (m_sinceDrawnS >= kDrawS - 5.0e-10) {
        draw();
        m_sinceDrawnS = std::min(m_sinceDrawnS - kDrawS, kDrawS);
    }
    return {(m_noise[0] - m_noise[2]) * (m_level * m_rmsN), 0.0};
}

}  // namespace core::contact
