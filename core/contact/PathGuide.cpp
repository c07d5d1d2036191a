// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/PathGuide.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/contact/Lengths.h"

namespace core::contact {
namespace {

/// With this stiffness and dry friction of 0.25 N, a hand that follows the lead stays within 0.6 mm.
constexpr double kGuideNPerMm = 0.4;
/// For a grip of 0.3 kg and a light hand, this is half of critical damping. The hand adds some damping of its own.
constexpr double kGuideNSPerMm = 0.012;
constexpr double kGuideArrivedMm = 2.0;  ///< the anchor has arrived when it is this near to the aim
constexpr double kGuideStrideS = 0.005;  ///< time constant of the damper's low-pass: no count is felt through it
/// A hand that approaches the anchor faster than this follows the lead.
constexpr double kGoesAlongMmPerS = 3.0;
constexpr double kGuideSlewNPerS = 150.0;  ///< fastest change of its force

}  // namespace

void PathGuide::drop() noexcept
{
    m_begins = true;
    m_asked = false;
    m_leading = false;
    m_strength = 0.0;
    m_forceN = glm::dvec3(0.0);
}

/// Moves the anchor with the aim if it has arrived there, otherwise towards the aim. Its distance ahead of the hand is
/// limited by the largest force of the spring.
void PathGuide::walk(const glm::dvec3& deviceMm, const glm::dvec3& aimMm, double seconds) noexcept
{
    const glm::dvec3 way = aimMm - m_anchor;
    const double with = lengthOf(way) < kGuideArrivedMm ? lengthOf(aimMm - m_aim) : 0.0;
    m_anchor += shortened(way, std::min(kWalkMmPerS * seconds + with, kFastestMmPerS * seconds));
    m_anchor = deviceMm + shortened(m_anchor - deviceMm, kMostN / kGuideNPerMm);
}

/// Releases a hand that resists the lead.
void PathGuide::watchPush(const glm::dvec3& lead, double seconds) noexcept
{
    const double ahead = lengthOf(lead);
    const bool isPulled = ahead * kGuideNPerMm >= kPushN;
    const bool goesAlong = isPulled && glm::dot(m_pace.mmPerS(), lead) / ahead > kGoesAlongMmPerS;
    m_pushedS = isPulled && !goesAlong ? m_pushedS + seconds : 0.0;
    if (m_pushedS > kPushedS) {
        m_leading = false;
        m_wasPushed = true;
    }
}

glm::dvec3 PathGuide::update(const glm::dvec3& deviceMm, const glm::dvec3& aimMm, double seconds) noexcept
{
    if (m_begins) {
        m_pace.restart(deviceMm);
        m_begins = false;
    }
    m_pace.add(deviceMm, seconds);
    if (m_asked && !m_leading) {
        m_leading = true;
        m_wasPushed = false;
        m_pushedS = 0.0;
        m_anchor = deviceMm;
        m_aim = aimMm;
        m_gaining = glm::dvec3(0.0);
    }
    m_asked = false;

    // A hand that moves ahead by itself must not be held back.
    if (m_leading && lengthOf(aimMm - deviceMm) < lengthOf(aimMm - m_anchor))
        m_anchor = deviceMm;
    const glm::dvec3 before = m_anchor;
    if (m_leading) {
        walk(deviceMm, aimMm, seconds);
        watchPush(m_anchor - deviceMm, seconds);
    }
    m_aim = aimMm;
    if (seconds > 0.0)
        m_gaining +=
            ((m_anchor - before) / seconds - m_pace.mmPerS() - m_gaining) * std::min(1.0, seconds / kGuideStrideS);
    m_strength =
        m_leading ? std::min(1.0, m_strength + seconds / kRiseS) : std::max(0.0, m_strength - seconds / kFadeS);
    glm::dvec3 force(0.0);
    if (m_strength > 0.0) {
        const glm::dvec3 pull = (m_anchor - deviceMm) * kGuideNPerMm + m_gaining * kGuideNSPerMm;
        force = shortened(pull, kMostN) * m_strength;
    }
    m_forceN += shortened(force - m_forceN, kGuideSlewNPerS * seconds);
    return m_forceN;
}

}  // namespace core::contact
