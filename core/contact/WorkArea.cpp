// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/WorkArea.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/contact/Lengths.h"

namespace core::contact {
namespace {

/// A soft spring: kLeadN over 5 mm. For a grip and a light hand, 0.3 kg, the damper between hand and anchor makes it
/// nearly critically damped.
constexpr double kSpringNPerMm = 0.2;
constexpr double kDamperNSPerMm = 0.012;
constexpr double kStrideS = 0.02;  ///< time constant of the damper's low-pass: neither a turn of the way nor a count is
                                   ///< felt
constexpr double kArrivedMm = 0.5;
/// Spring and damper together stay under 2 N (docs/facts/haptics.md, section 4, scene 13).
constexpr double kMostLeadN = 1.8;
/// A hand that follows needs little more than the friction of the device, 0.25 N. From this share of kLeadN on, the
/// hand counts as resisting.
constexpr double kHeldBackShare = 0.95;

constexpr double kSlewNPerS = 1000.0;  ///< fastest change of its force, so that a jump of the reading gives no blow

}  // namespace

void WorkArea::drop() noexcept
{
    m_begins = true;
    m_return = 0.0;
    m_wasInside = false;
    m_asked = false;
    m_leading = false;
    m_strength = 0.0;
    m_forceN = glm::dvec3(0.0);
}

/// Moves the anchor on its path home. Its distance ahead of the hand is limited by the largest force of the spring.
void WorkArea::walk(const glm::dvec3& device, double seconds) noexcept
{
    // The anchor moves up first, because the path is free above everything beside the bur.
    const glm::dvec3 home(0.0, 0.0, kHomeMm);
    const bool low = m_anchor.z < kHomeMm - kArrivedMm;
    const glm::dvec3 aim = low ? glm::dvec3(m_anchor.x, m_anchor.y, kHomeMm) : home;
    const glm::dvec3 way = aim - m_anchor;
    const double length = lengthOf(way);
    const double step = kWalkMmPerS * seconds;
    m_anchor = length > step ? m_anchor + way * (step / length) : aim;

    const glm::dvec3 lead = m_anchor - device;
    const double ahead = lengthOf(lead);
    const double most = kLeadN / kSpringNPerMm;
    if (ahead > most)
        m_anchor = device + lead * (most / ahead);
    m_heldBackS = ahead > kHeldBackShare * most ? m_heldBackS + seconds : 0.0;
    const bool arrived = lengthOf(home - m_anchor) < kArrivedMm && lengthOf(home - device) < kLeadN / kSpringNPerMm;
    if (arrived || m_heldBackS > kPulledS)
        m_leading = false;
}

glm::dvec3 WorkArea::update(const glm::dvec3& device, double seconds) noexcept
{
    if (!(m_radiusMm > 0.0))
        return glm::dvec3(0.0);
    if (m_begins)
        m_pace.restart(device);
    m_begins = false;
    m_pace.add(device, seconds);
    const double away = lengthOf(device);
    const bool left = m_wasInside && away > m_radiusMm;
    m_wasInside = away <= m_radiusMm;
    if ((left || m_asked) && !m_leading) {
        m_leading = true;
        m_strength = 0.0;
        m_heldBackS = 0.0;
        m_anchor = device;
        m_gaining = glm::dvec3(0.0);
    }
    m_asked = false;

    const double fade = seconds / kFadeS;
    m_return = std::min(1.0, m_return + fade);
    glm::dvec3 force(0.0);
    if (away > m_radiusMm)
        force -= device * (m_return * std::min(kWallMostN, kWallNPerMm * (away - m_radiusMm)) / away);
    const glm::dvec3 before = m_anchor;
    if (m_leading)
        walk(device, seconds);
    if (seconds > 0.0)
        m_gaining += ((m_anchor - before) / seconds - m_pace.mmPerS() - m_gaining) * std::min(1.0, seconds / kStrideS);
    m_strength = m_leading ? std::min(1.0, m_strength + fade) : std::max(0.0, m_strength - fade);
    if (m_strength > 0.0) {
        const glm::dvec3 pull = shortened((m_anchor - device) * kSpringNPerMm, kLeadN);
        force += shortened(pull + m_gaining * kDamperNSPerMm, kMostLeadN) * m_strength;
    }
    m_forceN += shortened(force - m_forceN, kSlewNPerS * seconds);
    return m_forceN;
}

}  // namespace core::contact
