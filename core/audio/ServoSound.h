// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/audio/SoundState.h"
#include "core/servo/ServoState.h"
#include "core/settings/Handpiece.h"

namespace core::audio {

/// Computes the input of the synthesiser from successive states of the servo: removal rate, contacts and chatter.
///
/// The spray and the suction are on while the handpiece is; a low-speed handpiece works dry.
/// Servo thread, or the one thread of a replay. No allocation, no lock, no exception.
class ServoSound
{
public:
    /// @param seconds  since the state before
    [[nodiscard]] SoundState update(const servo::ServoState& state, const settings::Handpiece& handpiece,
                                    double seconds) noexcept;

private:
    SoundState m_sound;
    double m_removedMm3 = 0.0;
    double m_cutMm3PerS = 0.0;
    glm::dvec3 m_deviceMm{0.0};
    double m_speedMmPerS = 0.0;  ///< speed of the hand
    double m_freeS = 0.0;        ///< time since the last contact
    double m_lastN = 0.0;        ///< magnitude of the force
    double m_lastStepN = 0.0;    ///< its change in the last tick
    double m_roughN = 0.0;       ///< smoothed difference between the last two changes of the force
};

}  // namespace core::audio
