// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/servo/ServoState.h"

namespace ui::tooth {

/// Where the bur was at a moment of the steady clock, between the two readings around it. Never where it has not been:
/// before the trail its oldest pose, after it the newest. Without a trail what the state holds, as taken at that
/// moment.
[[nodiscard]] core::servo::Pose poseAt(const core::servo::ServoState& state, std::int64_t momentNs);

/// Chooses the moments for which pictures are drawn. They are painted now a little early, now a little late, and shown
/// at a steady beat: drawn for when they are painted, what moves evenly would tremble.
class FrameClock
{
public:
    /// How far behind a picture is drawn, so that there are readings on both sides even of a servo that comes late.
    static constexpr std::int64_t kBehindNs = 3'000'000;

    /// @param paintedNs  steady clock, now
    [[nodiscard]] std::int64_t momentFor(std::int64_t paintedNs);

private:
    std::int64_t m_momentNs = 0;
    std::int64_t m_paintedNs = 0;
    std::int64_t m_periodNs = 16'666'667;
};

}  // namespace ui::tooth
