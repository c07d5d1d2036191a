// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/falcon/Arm.h"

#include <algorithm>

namespace support::falcon {
namespace {

using namespace std::chrono_literals;

constexpr auto kStep = 1ms;
constexpr auto kLongestCatchUp = 2s;
constexpr double kMmPerM = 1000.0;

/// Returns figures without delay and force limit, because the transport delays the force and the commands limit it.
haptics::FalconFigures figures()
{
    haptics::FalconFigures falcon;
    falcon.delayS = 0.0;
    falcon.delayJitterS = 0.0;
    falcon.forceLimitN = 1000.0;
    return falcon;
}

glm::dvec3 forceInTooth(const glm::dvec3& deviceN)
{
    return {deviceN.x, -deviceN.z, deviceN.y};
}

}  // namespace

Arm::Arm() : m_arms(*haptics::falcon::armsAt(haptics::falcon::kCentreMm)) {}

glm::dvec3 Arm::wantedMm(Time at) const
{
    if (at >= m_end)
        return m_toMm;
    const double share = std::chrono::duration<double>(at - m_begin) / std::chrono::duration<double>(m_end - m_begin);
    return m_fromMm + (m_toMm - m_fromMm) * std::clamp(share, 0.0, 1.0);
}

void Arm::moveTo(const glm::dvec3& deviceMm, Clock::duration duration, Time now)
{
    advance(now);
    m_fromMm = wantedMm(now);
    m_toMm = deviceMm;
    m_begin = now;
    m_end = now + duration;
    advance(now);
}

void Arm::setHand(const std::optional<haptics::HandFigures>& hand, Time now)
{
    advance(now);
    m_simulation.reset();
    if (hand)
        m_simulation.emplace(figures(), *hand, std::chrono::duration<double>(kStep).count(), 1,
                             haptics::falcon::toothFromDevice(m_gripMm));
    m_simulated = now;
}

void Arm::setMotors(const std::array<std::int16_t, 3>& commands, bool powered)
{
    for (std::size_t motor = 0; motor < 3; ++motor)
        m_torquesNm[static_cast<int>(motor)] = powered ? -commands[motor] / m_commandsPerNm : 0.0;
}

void Arm::advance(Time now)
{
    if (!m_simulation) {
        setGrip(wantedMm(now));
        return;
    }
    m_simulated = std::max(m_simulated, now - kLongestCatchUp);
    for (; m_simulated + kStep <= now; m_simulated += kStep) {
        m_simulation->follow(haptics::falcon::toothFromDevice(wantedMm(m_simulated + kStep)));
        m_simulation->exchange(forceInTooth(forceN()));
        setGrip(haptics::falcon::deviceFromTooth(m_simulation->tipMm()));
    }
}

void Arm::setGrip(const glm::dvec3& deviceMm)
{
    if (deviceMm == m_gripMm)
        return;
    if (const auto arms = haptics::falcon::armsAt(deviceMm)) {
        m_gripMm = deviceMm;
        m_arms = *arms;
    }
}

glm::dvec3 Arm::forceN() const
{
    glm::dvec3 force(0.0);
    for (std::size_t leg = 0; leg < 3; ++leg)
        force += m_arms.perMm[leg] * (kMmPerM * m_torquesNm[static_cast<int>(leg)]);
    return force;
}

}  // namespace support::falcon
