// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/HeadView.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

namespace core::tracking {
namespace {

constexpr double kHoldS = 1.0;    ///< after this time without a tag, the view glides back
constexpr double kSeenS = 0.25;   ///< largest age of a tag that is still followed
constexpr double kGlideS = 0.15;  ///< time constant of gliding
constexpr double kDeadDeg = 0.3;  ///< range around the middle in which the view hardly moves
constexpr double kMostFarther = 1.6;
constexpr double kMostWindowDeg = 40.0;
constexpr double kMostStep = 0.0175;  ///< largest step per frame, as a share of the distance: a degree
constexpr double kLeastMm = 1.0;

/// Returns the value after a soft dead zone: small values change little, and large ones fully.
double calmed(double deg)
{
    return deg - kDeadDeg * std::tanh(deg / kDeadDeg);
}

double towards(double from, double to, double share, double most)
{
    return from + std::clamp((to - from) * share, -most, most);
}

}  // namespace

const Lean& HeadView::update(const Head& head, double nowS, double seconds, bool holds)
{
    const bool wasSeen = head.seenS > 0.0;
    const double ageS = wasSeen ? nowS - head.seenS : 2.0 * kHoldS;
    Lean target;
    if (wasSeen && ageS < kSeenS) {
        const glm::dvec3 position = head.positionAtMm(nowS);
        if (!m_hasNeutral) {
            m_neutralMm = position;
            m_hasNeutral = true;
        }
        target = wanted(position);
        m_follow = std::min(1.0, m_follow + seconds / (2.0 * kGlideS));
    } else {
        m_follow = 0.0;
        if (holds || ageS < kHoldS)
            return m_lean;
    }
    const double glide = 1.0 - std::exp(-seconds / kGlideS);
    const double share = glm::mix(glide, 1.0, m_follow * m_follow);
    m_lean.yawDeg = towards(m_lean.yawDeg, target.yawDeg, share, kMostDegPerFrame);
    m_lean.pitchDeg = towards(m_lean.pitchDeg, target.pitchDeg, share, kMostDegPerFrame);
    m_lean.farther = towards(m_lean.farther, target.farther, share, kMostStep);
    m_lean.rightShare = towards(m_lean.rightShare, target.rightShare, share, kMostStep);
    m_lean.upShare = towards(m_lean.upShare, target.upShare, share, kMostStep);
    constexpr double kNothing = 1e-3;
    const double left = std::abs(m_lean.yawDeg) + std::abs(m_lean.pitchDeg) + std::abs(m_lean.farther - 1.0) +
                        std::abs(m_lean.rightShare) + std::abs(m_lean.upShare);
    if (target == Lean{} && left < kNothing)
        m_lean = {};
    return m_lean;
}

/// Returns the wanted lean. The camera faces the user: its right is the user's left, and its y axis points down.
Lean HeadView::wanted(const glm::dvec3& positionMm) const
{
    const double depth = std::max(kLeastMm, positionMm.z);
    const auto angle = [&](double moved) { return glm::degrees(std::atan2(moved, depth)); };
    const double yaw = m_settings.gain * calmed(angle(m_neutralMm.x - positionMm.x));
    const double pitch = m_settings.gain * calmed(angle(m_neutralMm.y - positionMm.y));
    Lean lean;
    if (m_settings.isWindow) {
        lean.rightShare = std::tan(glm::radians(std::clamp(yaw, -kMostWindowDeg, kMostWindowDeg)));
        lean.upShare = std::tan(glm::radians(std::clamp(pitch, -kMostWindowDeg, kMostWindowDeg)));
    } else {
        lean.yawDeg = std::clamp(yaw, -m_settings.mostYawDeg, m_settings.mostYawDeg);
        lean.pitchDeg = std::clamp(pitch, -m_settings.mostPitchDeg, m_settings.mostPitchDeg);
    }
    lean.farther = std::clamp(std::pow(depth / std::max(kLeastMm, m_neutralMm.z), m_settings.depthPower),
                              1.0 / kMostFarther, kMostFarther);
    return lean;
}

}  // namespace core::tracking
