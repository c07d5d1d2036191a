// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/audio/ServoSound.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

namespace core::audio {
namespace {

constexpr double kCutS = 0.006;             ///< time over which the removal rate is averaged
constexpr double kRoughS = 0.03;            ///< time over which the roughness of the force is averaged
constexpr double kSpeedS = 0.005;           ///< time over which the speed of the hand is averaged
constexpr double kBetweenContactsS = 0.02;  ///< a bur that skips over the ground for less time makes no new contact
constexpr double kQuietN = 0.02;            ///< roughness of the force in a steady cut
constexpr double kFullChatterN = 0.2;

/// Returns the weight of one step in a running mean over `timeS`.
double shareOfMean(double seconds, double timeS) noexcept
{
    return std::clamp(seconds / timeS, 0.0, 1.0);
}

}  // namespace

SoundState ServoSound::update(const servo::ServoState& state, const settings::Handpiece& handpiece,
                              double seconds) noexcept
{
    if (!(seconds > 0.0))
        return m_sound;
    m_sound.drive = driveOf(handpiece.freeRpm);
    m_sound.turns = state.drillOn && (state.health & servo::kDeviceLost) == 0;
    m_sound.freeRpm = static_cast<float>(handpiece.freeRpm);
    m_sound.burRpm = static_cast<float>(state.burRpm);
    m_sound.material = state.materialUnderBur;
    m_sound.suction = m_sound.turns;
    m_sound.spray = m_sound.turns && m_sound.drive != Drive::LowSpeed;

    // Tissue that breaks off makes no sound of grinding.
    const double removed = std::accumulate(state.removedMm3.begin(), state.removedMm3.end(), 0.0) -
                           std::accumulate(state.brokenMm3.begin(), state.brokenMm3.end(), 0.0);
    const double rate = std::max(0.0, removed - m_removedMm3) / seconds;
    m_removedMm3 = removed;
    m_cutMm3PerS += shareOfMean(seconds, kCutS) * (rate - m_cutMm3PerS);
    m_sound.cutMm3PerS = static_cast<float>(m_cutMm3PerS);

    const double speed = glm::length(state.deviceMm - m_deviceMm) / seconds;
    m_deviceMm = state.deviceMm;
    m_freeS = state.touching ? m_freeS : m_freeS + seconds;
    if (state.touching && m_freeS >= kBetweenContactsS) {
        ++m_sound.contacts;
        m_sound.contactMmPerS = static_cast<float>(m_speedMmPerS);
    }
    if (state.touching)
        m_freeS = 0.0;
    m_speedMmPerS += shareOfMean(seconds, kSpeedS) * (speed - m_speedMmPerS);
    m_sound.isTouching = state.touching;

    // The second difference of the force is zero while it is constant or grows steadily. It is large when an edge
    // catches and slips.
    const double newtons = glm::length(state.forceN);
    const double step = newtons - m_lastN;
    const double roughN = state.touching && m_sound.turns ? std::abs(step - m_lastStepN) : 0.0;
    m_lastN = newtons;
    m_lastStepN = step;
    m_roughN += shareOfMean(seconds, kRoughS) * (roughN - m_roughN);
    m_sound.chatter = static_cast<float>(std::clamp((m_roughN - kQuietN) / (kFullChatterN - kQuietN), 0.0, 1.0));
    return m_sound;
}

}  // namespace core::audio
