// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/pointer/PointerDevice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace haptics {
namespace {

constexpr double kGlideLagS = 0.012;  ///< each of the two lags sideways; together half the interval of a mouse
constexpr double kPushLagS = 0.08;    ///< the force builds up over this time
constexpr double kFollowLagS = 2.0 * kPushLagS;  ///< the hand learns the speed of a cut over this time
constexpr double kLiftLagS = 0.03;               ///< the force ends over this time
constexpr double kApproachMmPerS = 25.0;         ///< fastest descent of the leaning hand before it meets the tooth
constexpr double kGlideMmPerS = 400.0;           ///< fastest travel in the air
constexpr double kFeltN = 0.05;                  ///< a smaller force is not felt as contact
constexpr double kDragMmPerS = 40.0;             ///< fastest travel while leaning or touching

// The hand with a feed.
constexpr double kFirmness = 10.0;         ///< ratio of the lean to the height of the bur above the level
constexpr double kTouchMm = 1.0e-3;        ///< a smaller distance between hand and bur is rounding
constexpr double kYieldsMm = 0.15;         ///< the level rises with a bur that is lifted farther above it
constexpr double kComesDownMmPerS = 10.0;  ///< speed of the approach
constexpr double kLeavesMmPerS = 20.0;     ///< speed of the lift as long as the bur touches
constexpr double kLeanS = 0.03;            ///< time from no lean to the wanted force
constexpr double kFreeS = 0.05;            ///< the bur counts as in the air after this time without contact
constexpr double kPedalLiftsAfterS = 0.3;  ///< a pressed bur stops turning after this time without contact

bool isFinite(const core::servo::PointerInput& input)
{
    return std::isfinite(input.targetMm.x) && std::isfinite(input.targetMm.y) && std::isfinite(input.hoverMm) &&
           std::isfinite(input.pushForceN) && std::isfinite(input.feedMmPerS) && !std::isnan(input.stopMm);
}

}  // namespace

PointerDevice::PointerDevice(core::rt::TripleBuffer<core::servo::PointerInput>& input, double stiffnessNPerMm,
                             double periodS) noexcept
    : m_input(input), m_stiffness(stiffnessNPerMm), m_period(periodS)
{}

DeviceSample PointerDevice::exchange(const glm::dvec3& forceOnHandN) noexcept
{
    if (const core::servo::PointerInput& asked = m_input.latest(); isFinite(asked))
        m_want = asked;
    if (std::exchange(m_begins, false))
        begin();
    m_isHeldSince = m_isHeldSince && m_want.pushing;
    if (m_isHeldSince)
        m_want.pushing = false;
    const double force = std::sqrt(glm::dot(forceOnHandN, forceOnHandN));
    const glm::dvec3 stretch = m_burMm - m_tip;
    m_freeS = glm::dot(stretch, stretch) > kTouchMm * kTouchMm ? 0.0 : m_freeS + m_period;
    moveAside(forceOnHandN, force);
    if (!m_want.pushing)
        lift();
    else if (m_want.feedMmPerS > 0.0)
        lower();
    else
        lean(force);
    m_idleS = m_want.pushing && m_freeS > 0.0 ? m_idleS + m_period : 0.0;
    DeviceSample sample{glm::vec3(m_tip), true};
    if (m_want.buttonIsPedal)
        sample.pedal = m_want.pushing && m_idleS < kPedalLiftsAfterS;
    return sample;
}

void PointerDevice::begin() noexcept
{
    m_isHeldSince = m_want.pushing;
    m_between = m_want.targetMm;
    m_tip = glm::dvec3(m_want.targetMm, m_want.hoverMm);
    m_levelMm = m_tip.z;
    m_isInAir = true;
    m_followMmPerS = 0.0;
    m_idleS = 0.0;
    m_freeS = 1.0;
}

/// Moves the hand sideways. It stops at a wall that pushes back with the wanted force, so that the spring is not
/// stretched further.
void PointerDevice::moveAside(const glm::dvec3& forceOnHandN, double forceN) noexcept
{
    const bool isFree = m_want.feedMmPerS > 0.0 && m_freeS > kFreeS;
    const double glide = isFree ? 1.0 : std::min(1.0, m_period / kGlideLagS);
    m_between += (m_want.targetMm - m_between) * glide;
    glm::dvec2 step = (m_between - glm::dvec2(m_tip.x, m_tip.y)) * glide;
    const bool isSlow = m_want.pushing || (m_want.feedMmPerS > 0.0 && !isFree);
    const double most = (isSlow ? kDragMmPerS : kGlideMmPerS) * m_period;
    const double length = std::sqrt(glm::dot(step, step));
    if (length > most)
        step *= most / length;
    const double limit = m_want.pushForceN * 1.5;
    const glm::dvec2 side(forceOnHandN.x, forceOnHandN.y);
    const double against = -glm::dot(side, step);
    if (forceN > m_want.pushForceN && against > 0.0)
        step *= std::clamp((limit - forceN) / (limit - m_want.pushForceN), 0.0, 1.0);
    m_tip.x += step.x;
    m_tip.y += step.y;
}

void PointerDevice::lean(double forceN) noexcept
{
    const double missing = m_want.pushForceN - forceN;
    const double sink = missing / (m_stiffness * kPushLagS);
    // While the bur sinks into a cut, its movement must not count as missing force. The speed is learnt only in
    // contact, because the approach is no cut.
    if (forceN > kFeltN)
        m_followMmPerS += sink * m_period / kFollowLagS;
    m_followMmPerS = std::clamp(m_followMmPerS, 0.0, kDragMmPerS);
    m_tip.z -= std::min(sink + m_followMmPerS, kApproachMmPerS) * m_period;
}

void PointerDevice::lower() noexcept
{
    const double mostLeanMm = m_want.pushForceN / m_stiffness;
    const double aboveMm = m_burMm.z - m_levelMm;
    const bool wasInAir = m_isInAir;
    m_isInAir = m_freeS > kFreeS;
    if (wasInAir && !m_isInAir)
        m_levelMm = m_burMm.z;  // the force starts at zero
    if (m_isInAir)
        m_levelMm -= kComesDownMmPerS * m_period;
    else if (aboveMm > kYieldsMm)
        m_levelMm = m_burMm.z - kYieldsMm;
    else if (aboveMm < mostLeanMm / kFirmness)
        m_levelMm -= m_want.feedMmPerS * m_period;
    m_levelMm = std::max(m_levelMm, m_want.stopMm);
    const double wanted = m_isInAir ? 0.0 : std::min(kFirmness * std::max(0.0, m_burMm.z - m_levelMm), mostLeanMm);
    // The force of a hand changes gradually, even if the bur slips off an edge.
    const double lean = std::max(0.0, m_burMm.z - m_tip.z);
    const double most = mostLeanMm * m_period / kLeanS;
    const double next = std::clamp(wanted, lean - most, lean + most);
    m_tip.z = next > 0.0 ? m_burMm.z - next : m_levelMm;
}

void PointerDevice::lift() noexcept
{
    m_followMmPerS = 0.0;
    // A faster hand would feel a pull by the damper of the force law.
    const double most = (m_freeS > kFreeS ? kGlideMmPerS : kLeavesMmPerS) * m_period;
    m_tip.z += m_want.feedMmPerS > 0.0 ? std::clamp(m_want.hoverMm - m_tip.z, -most, most)
                                       : (m_want.hoverMm - m_tip.z) * std::min(1.0, m_period / kLiftLagS);
    m_levelMm = m_tip.z;
    m_isInAir = true;
}

}  // namespace haptics
