// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/simulated/SimulatedFalcon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "haptics/falcon/Kinematics.h"

namespace haptics {
namespace {

constexpr double kLongestStepS = 20.0e-6;
constexpr int kLeastSteps = 10;
constexpr double kReachM = falcon::kReachMm * 0.001;

/// Number of sines whose sum is the unrest of a band along an axis, one in each equal part of the band. The rms of such
/// a sum is exact.
constexpr int kWaves = 5;
constexpr std::array kTremorHz{7.5, 10.5};
constexpr std::array kDriftHz{0.1, 2.0};

glm::dvec3 shortened(const glm::dvec3& v, double longest)
{
    const double length = glm::length(v);
    return length > longest ? v * (longest / length) : v;
}

}  // namespace

SimulatedFalcon::SimulatedFalcon(const FalconFigures& falcon, const HandFigures& hand, double periodS,
                                 std::uint64_t seed, const glm::dvec3& tipMm)
    : m_falcon(falcon), m_hand(hand),
      m_steps(std::max(kLeastSteps, static_cast<int>(std::ceil(periodS / kLongestStepS)))), m_stepS(periodS / m_steps),
      m_motorShare(1.0 - std::exp(-m_stepS / falcon.motorLagS)), m_rng(seed),
      m_line(static_cast<std::size_t>((falcon.delayS + falcon.delayJitterS) / periodS) + 2), m_at(tipMm * kMPerMm),
      m_wanted(m_at), m_readMm(falcon::deviceFromTooth(tipMm))
{
    const auto add = [&](int axis, double rmsMm, const std::array<double, 2>& bandHz) {
        for (int n = 0; n < kWaves; ++n) {
            const double hz = bandHz[0] + (bandHz[1] - bandHz[0]) * (n + m_rng.uniform()) / kWaves;
            m_waves.push_back({axis, rmsMm * kMPerMm * std::sqrt(2.0 / kWaves), 2.0 * std::numbers::pi * hz,
                               m_rng.uniform(0.0, 2.0 * std::numbers::pi)});
        }
    };
    for (const int axis : {0, 1})
        add(axis, hand.tremorMm, kTremorHz);
    for (const int axis : {0, 1, 2})
        add(axis, hand.driftMm, kDriftHz);
    follow(tipMm);
}

void SimulatedFalcon::follow(const glm::dvec3& wantedMm) noexcept
{
    m_wanted = wantedMm * kMPerMm;
    if (m_now == 0)
        m_reference = m_wanted + unrest(0);
}

/// Returns the displacement of the hand by tremor and drift.
glm::dvec3 SimulatedFalcon::unrest(std::int64_t step) const noexcept
{
    const double t = static_cast<double>(step) * m_stepS;
    glm::dvec3 sum(0.0);
    for (const Wave& wave : m_waves)
        sum[wave.axis] += wave.amplitude * std::sin(wave.radPerS * t + wave.phaseRad);
    return sum;
}

void SimulatedFalcon::send(const glm::dvec3& forceN) noexcept
{
    const double delayS = m_falcon.delayS + m_falcon.delayJitterS * m_rng.uniform();
    m_lastDue = std::max(m_lastDue, m_now + static_cast<std::int64_t>(std::lround(delayS / m_stepS)));
    m_line[(m_first + m_underWay++) % m_line.size()] = {m_lastDue, shortened(forceN, m_falcon.forceLimitN)};
}

void SimulatedFalcon::step(const glm::dvec3& reference, const glm::dvec3& referenceSpeed) noexcept
{
    for (; m_underWay > 0 && m_line[m_first].due <= m_now; --m_underWay) {
        m_commandedN = m_line[m_first].forceN;
        m_first = (m_first + 1) % m_line.size();
    }
    m_motorN += (m_commandedN - m_motorN) * m_motorShare;
    const glm::dvec3 force = m_motorN + m_hand.stiffnessNPerM * (reference - m_at) +
                             m_hand.dampingNSPerM * (referenceSpeed - m_speed) - m_falcon.viscousNSPerM * m_speed;
    const double perMass = m_stepS / (m_falcon.massKg + m_hand.massKg);
    m_speed += force * perMass;
    m_speed -= shortened(m_speed, m_falcon.coulombN * perMass);
    m_at += m_speed * m_stepS;
    if (const double away = glm::length(m_at); away > kReachM) {
        m_at *= kReachM / away;
        m_speed -= m_at * (std::max(0.0, glm::dot(m_at, m_speed)) / (kReachM * kReachM));
    }
    ++m_now;
}

DeviceSample SimulatedFalcon::read() noexcept
{
    const glm::dvec3 at = falcon::deviceFromTooth(tipMm());
    if (!(m_falcon.countShare > 0.0))
        m_readMm = at;
    else if (const auto arms = falcon::armsAt(at))
        if (const auto grip = falcon::gripAt(falcon::roundedToCounts(arms->angleRad, m_falcon.countShare), m_readMm))
            m_readMm = *grip;
    return {glm::vec3(falcon::toothFromDevice(m_readMm)), true};
}

DeviceSample SimulatedFalcon::exchange(const glm::dvec3& forceOnHandN) noexcept
{
    send(forceOnHandN);
    const double delayS = static_cast<double>(m_lastDue - m_now) * m_stepS;  // of the force used now
    const glm::dvec3 before = m_reference;
    m_reference = m_wanted + unrest(m_now + m_steps);
    const glm::dvec3 stride = (m_reference - before) / static_cast<double>(m_steps);
    for (int n = 1; n <= m_steps; ++n)
        step(before + stride * static_cast<double>(n), stride / m_stepS);
    DeviceSample sample = read();
    sample.delayS = static_cast<float>(delayS);
    return sample;
}

}  // namespace haptics
