// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/PoseTrack.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <glm/common.hpp>

namespace ui::tooth {
namespace {

constexpr std::int64_t kLatestNs = 1'000'000;  ///< least time before painting; a later reading may not exist yet
constexpr std::int64_t kOldestNs = 6'000'000;  ///< most time before painting: a steadier beat is not worth more
constexpr std::int64_t kFollow = 8;            ///< pictures over which a deviation of the moment is corrected
constexpr std::int64_t kShortestNs = 4'000'000;
constexpr std::int64_t kLongestNs = 60'000'000;
constexpr std::int64_t kFollowPeriod = 32;  ///< pictures over which the period is corrected

}  // namespace

core::servo::Pose poseAt(const core::servo::ServoState& state, std::int64_t momentNs)
{
    const core::servo::Pose* before = nullptr;
    const core::servo::Pose* after = nullptr;
    for (const core::servo::Pose& pose : state.trail) {
        if (pose.takenNs == 0)
            continue;
        if (pose.takenNs <= momentNs && (before == nullptr || pose.takenNs > before->takenNs))
            before = &pose;
        if (pose.takenNs > momentNs && (after == nullptr || pose.takenNs < after->takenNs))
            after = &pose;
    }
    if (before == nullptr && after == nullptr)
        return {momentNs, state.deviceMm, state.anchorMm};
    if (before == nullptr || after == nullptr)
        return before != nullptr ? *before : *after;
    const double share =
        static_cast<double>(momentNs - before->takenNs) / static_cast<double>(after->takenNs - before->takenNs);
    return {momentNs, glm::mix(before->deviceMm, after->deviceMm, share),
            glm::mix(before->anchorMm, after->anchorMm, share)};
}

std::int64_t FrameClock::momentFor(std::int64_t paintedNs)
{
    const std::int64_t wanted = paintedNs - kBehindNs;
    const std::int64_t since = paintedNs - std::exchange(m_paintedNs, paintedNs);
    const std::int64_t error = wanted - (m_momentNs + m_periodNs);
    if (std::abs(error) > m_periodNs / 2) {
        // Begins anew at the first picture, or when the interval between pictures has changed.
        m_momentNs = wanted;
        if (since >= kShortestNs && since <= kLongestNs)
            m_periodNs = since;
        return m_momentNs;
    }
    m_periodNs += error / kFollowPeriod;
    m_momentNs = std::clamp(m_momentNs + m_periodNs + error / kFollow, paintedNs - kOldestNs, paintedNs - kLatestNs);
    return m_momentNs;
}

}  // namespace ui::tooth
