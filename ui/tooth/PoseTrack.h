// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/servo/ServoState.h"

namespace ui::tooth {

/// Returns the pose of the bur at a moment of the steady clock, interpolated between the two readings around it. Never
/// extrapolates: returns the oldest reading before the trail, and the newest after it. Without a trail returns the pose
/// of the state.
[[nodiscard]] core::servo::Pose poseAt(const core::servo::ServoState& state, std::int64_t momentNs);

/// Chooses the moment that each picture shows. Pictures are painted at slightly uneven times but shown at even ones:
/// movement drawn for the time of painting would tremble.
class FrameClock
{
public:
    /// Delay of a picture, so that there are readings on both sides even if the servo is late.
    static constexpr std::int64_t kBehindNs = 3'000'000;

    /// Returns the moment to draw, ns of the steady clock.
    /// @param paintedNs  steady clock, now
    [[nodiscard]] std::int64_t momentFor(std::int64_t paintedNs);

private:
    std::int64_t m_momentNs = 0;
    std::int64_t m_paintedNs = 0;
    std::int64_t m_periodNs = 16'666'667;
};

}  // namespace ui::tooth
