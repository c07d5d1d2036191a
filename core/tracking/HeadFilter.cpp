// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/HeadFilter.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace core::tracking {
namespace {

constexpr double kMostAheadS = 0.03;
constexpr double kForgottenS = 0.5;    ///< after this time without a tag, it must be found anew
constexpr double kSamePlaceMm = 60.0;  ///< largest distance between pictures of a tag that appears
constexpr int kFoundAfter = 2;         ///< number of pictures in a row with the tag
constexpr double kFastestMmPerS = 1500.0;
constexpr double kFastestDegPerS = 200.0;
constexpr double kRestMm = 5.0;  ///< measuring error that does not count as a jump
constexpr double kRestDeg = 8.0;
constexpr int kJumpAfter = 3;
constexpr double kClearlyBetter = 2.0;
constexpr int kOtherAfter = 3;
constexpr double kLeastS = 1e-4;

}  // namespace

glm::dvec3 Head::positionAtMm(double timeS) const
{
    return pose.positionMm + mmPerS * std::clamp(timeS - seenS, 0.0, kMostAheadS);
}

HeadFilter::HeadFilter() : HeadFilter(Settings{}) {}

HeadFilter::HeadFilter(const Settings& settings)
    : m_settings(settings), m_position{OneEuro(settings.position), OneEuro(settings.position),
                                       OneEuro(settings.position)}
{}

const Head& HeadFilter::take(const std::optional<PosedTag>& tag, double timeS)
{
    m_head.isSeen = false;
    if (m_isFollowing && timeS - m_head.seenS > kForgottenS)
        m_isFollowing = false;
    if (!tag) {
        m_candidate.reset();
        return m_head;
    }
    const Pose pose = choose(*tag);
    if (m_isFollowing && !isJump(pose, std::max(kLeastS, timeS - m_head.seenS))) {
        m_candidate.reset();
        follow(pose, timeS);
        return m_head;
    }
    const bool isSamePlace = m_candidate && glm::distance(m_candidate->positionMm, pose.positionMm) < kSamePlaceMm;
    m_confirmed = isSamePlace ? m_confirmed + 1 : 1;
    m_candidate = pose;
    m_candidateS = timeS;
    if (m_confirmed >= (m_isFollowing ? kJumpAfter : kFoundAfter)) {
        restart(pose, timeS);
        m_candidate.reset();
    }
    return m_head;
}

/// Returns the pose nearer to the last one, unless the other pose has matched the picture clearly better for some time.
Pose HeadFilter::choose(const PosedTag& tag)
{
    if (!m_isFollowing)
        return tag.pose;
    const bool isFirst = angleBetweenDeg(m_head.raw.rotation, tag.pose.rotation) <=
                         angleBetweenDeg(m_head.raw.rotation, tag.other.rotation);
    if (isFirst || tag.otherPx < kClearlyBetter * tag.reprojectionPx) {
        m_otherIsBetter = 0;
        return isFirst ? tag.pose : tag.other;
    }
    if (++m_otherIsBetter < kOtherAfter)
        return tag.other;
    // The head has not turned: the filter had chosen the wrong one of the two poses.
    m_otherIsBetter = 0;
    m_head.raw.rotation = tag.pose.rotation;
    m_head.pose.rotation = tag.pose.rotation;
    return tag.pose;
}

bool HeadFilter::isJump(const Pose& pose, double seconds) const
{
    return glm::distance(m_head.raw.positionMm, pose.positionMm) > kRestMm + kFastestMmPerS * seconds ||
           angleBetweenDeg(m_head.raw.rotation, pose.rotation) > kRestDeg + kFastestDegPerS * seconds;
}

void HeadFilter::restart(const Pose& pose, double timeS)
{
    for (int axis = 0; axis < 3; ++axis)
        m_position.at(static_cast<std::size_t>(axis)).restart(pose.positionMm[axis]);
    m_turnDegPerS = 0.0;
    m_otherIsBetter = 0;
    m_isFollowing = true;
    m_head = {true, timeS, pose, pose, glm::dvec3(0.0)};
}

void HeadFilter::follow(const Pose& pose, double timeS)
{
    const double seconds = std::max(kLeastS, timeS - m_head.seenS);
    for (int axis = 0; axis < 3; ++axis) {
        OneEuro& filter = m_position.at(static_cast<std::size_t>(axis));
        m_head.pose.positionMm[axis] = filter.take(pose.positionMm[axis], seconds);
        m_head.mmPerS[axis] = filter.speed();
    }
    // The same filter for an orientation. Its speed is the angular speed.
    const OneEuro::Settings& angle = m_settings.angle;
    const double turned = angleBetweenDeg(m_head.raw.rotation, pose.rotation) / seconds;
    m_turnDegPerS += OneEuro::share(angle.speedHz, seconds) * (turned - m_turnDegPerS);
    const double share = OneEuro::share(angle.leastHz + angle.perSpeed * m_turnDegPerS, seconds);
    m_head.pose.rotation =
        glm::mat3_cast(glm::slerp(glm::quat_cast(m_head.pose.rotation), glm::quat_cast(pose.rotation), share));
    m_head.raw = pose;
    m_head.seenS = timeS;
    m_head.isSeen = true;
}

}  // namespace core::tracking
