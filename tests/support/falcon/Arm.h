// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "haptics/falcon/Kinematics.h"
#include "haptics/simulated/SimulatedFalcon.h"
#include "tests/support/falcon/FtdiChip.h"

namespace support::falcon {

/// The Falcon's mechanism, its motors and the hand at its grip.
///
/// Without a hand the grip is where it was set. With a hand the grip is a mass between the hand and the motors
/// (haptics::SimulatedFalcon), and the set position is the one that the hand aims at.
class Arm
{
public:
    static constexpr double kDefaultCommandsPerNm = 10000.0;

    Arm();

    /// Moves the grip, or the hand, evenly to a place. If the legs do not reach a place, they stay.
    void moveTo(const glm::dvec3& deviceMm, Clock::duration duration, Time now);
    void setHand(const std::optional<haptics::HandFigures>& hand, Time now);
    void setCommandsPerNm(double commands) { m_commandsPerNm = commands; }
    /// @param powered  without power the motors give no force
    void setMotors(const std::array<std::int16_t, 3>& commands, bool powered);
    void advance(Time now);

    [[nodiscard]] const glm::dvec3& gripMm() const { return m_gripMm; }
    /// Encoder counts from the index marks, unrounded.
    [[nodiscard]] glm::dvec3 counts() const { return haptics::falcon::countsAt(m_arms.angleRad); }
    /// Returns the force of the motors on the hand at the grip, device frame.
    [[nodiscard]] glm::dvec3 forceN() const;

private:
    [[nodiscard]] glm::dvec3 wantedMm(Time at) const;
    void setGrip(const glm::dvec3& deviceMm);

    glm::dvec3 m_fromMm{haptics::falcon::kCentreMm};
    glm::dvec3 m_toMm{haptics::falcon::kCentreMm};
    Time m_begin{};
    Time m_end{};
    glm::dvec3 m_gripMm{haptics::falcon::kCentreMm};
    haptics::falcon::Arms m_arms{};
    glm::dvec3 m_torquesNm{0.0};
    double m_commandsPerNm = kDefaultCommandsPerNm;
    std::optional<haptics::SimulatedFalcon> m_simulation;
    Time m_simulated{};  ///< time up to which the simulation has run
};

}  // namespace support::falcon
