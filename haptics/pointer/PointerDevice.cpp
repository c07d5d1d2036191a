// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/pointer/PointerDevice.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace haptics {
namespace {

constexpr double kGlideLagS = 0.012;             ///< each of the two lags sideways: half a mouse report together
constexpr double kPushLagS = 0.08;               ///< the force builds up over this time
constexpr double kFollowLagS = 2.0 * kPushLagS;  ///< and the pace of a cut is learnt over this: fast without swinging
constexpr double kLiftLagS = 0.03;               ///< and is gone over this
constexpr double kApproachMmPerS = 25.0;         ///< fastest descent of the leaning hand before it meets the tooth
constexpr double kGlideMmPerS = 400.0;           ///< fastest travel in the air
constexpr double kFeltN = 0.05;                  ///< less than this is no contact to a hand (haptics.md section 7)
constexpr double kDragMmPerS = 40.0;             ///< fastest travel while leaning

bool isFinite(const core::session::PointerInput& input)
{
    return std::isfinite(input.targetMm.x) && std::isfinite(input.targetMm.y) && std::isfinite(input.hoverMm) &&
           std::isfinite(input.pushForceN);
}

}  // namespace

PointerDevice::PointerDevice(core::rt::TripleBuffer<core::session::PointerInput>& input, double stiffnessNPerMm,
                             double periodS) noexcept
    : m_input(input), m_stiffness(stiffnessNPerMm), m_period(periodS)
{}

DeviceSample PointerDevice::exchange(const glm::dvec3& forceOnHandN) noexcept
{
    if (const core::session::PointerInput& asked = m_input.latest(); isFinite(asked))
        m_want = asked;
    const core::session::PointerInput& want = m_want;
    const double force = std::sqrt(glm::dot(forceOnHandN, forceOnHandN));

    // Sideways. A wall that pushes back as hard as the hand would lean holds it: it does not wind the spring up
    // further.
    const double glide = std::min(1.0, m_period / kGlideLagS);
    m_between += (want.targetMm - m_between) * glide;
    glm::dvec2 step = (m_between - glm::dvec2(m_tip.x, m_tip.y)) * glide;
    const double most = (want.pushing ? kDragMmPerS : kGlideMmPerS) * m_period;
    const double length = std::sqrt(glm::dot(step, step));
    if (length > most)
        step *= most / length;
    const double limit = want.pushForceN * 1.5;
    const glm::dvec2 side(forceOnHandN.x, forceOnHandN.y);
    const double against = -glm::dot(side, step);
    if (force > want.pushForceN && against > 0.0)
        step *= std::clamp((limit - force) / (limit - want.pushForceN), 0.0, 1.0);
    m_tip.x += step.x;
    m_tip.y += step.y;

    if (want.pushing) {
        const double missing = want.pushForceN - force;
        const double sink = missing / (m_stiffness * kPushLagS);
        // What the bur gives way to is no missing force. Learnt in contact only: the approach is no cut.
        if (force > kFeltN)
            m_followMmPerS += sink * m_period / kFollowLagS;
        m_followMmPerS = std::clamp(m_followMmPerS, 0.0, kDragMmPerS);
        m_tip.z -= std::min(sink + m_followMmPerS, kApproachMmPerS) * m_period;
    } else {
        m_followMmPerS = 0.0;
        m_tip.z += (want.hoverMm - m_tip.z) * std::min(1.0, m_period / kLiftLagS);
    }
    return {glm::vec3(m_tip), true};
}

}  // namespace haptics
