// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <glm/vec3.hpp>

#include "core/tracking/OneEuro.h"
#include "core/tracking/Tag.h"

namespace core::tracking {

/// Filtered position and orientation of the head.
struct Head
{
    bool isSeen = false;  ///< in the last picture
    double seenS = 0.0;   ///< time of the last accepted picture; 0: never
    Pose pose;            ///< of the tag, camera frame, filtered
    Pose raw;             ///< the same as measured
    glm::dvec3 mmPerS{0.0};

    /// Returns the position at a later time, by its speed; at most 30 ms ahead.
    [[nodiscard]] glm::dvec3 positionAtMm(double timeS) const;
};

/// Selects the measured poses that belong to the head, chooses between the two poses of each, and filters them.
///
/// A tag that comes into view counts from its second picture on. A jump is accepted when it is confirmed twice.
class HeadFilter
{
public:
    struct Settings
    {
        OneEuro::Settings position{0.4, 0.07, 1.0};  ///< mm
        OneEuro::Settings angle{0.4, 0.03, 1.0};     ///< degrees
    };

    HeadFilter();
    explicit HeadFilter(const Settings& settings);

    /// @param tag    the tag in a picture; empty: none
    /// @param timeS  of the picture, later than that of the last one
    const Head& take(const std::optional<PosedTag>& tag, double timeS);
    [[nodiscard]] const Head& head() const { return m_head; }

private:
    [[nodiscard]] Pose choose(const PosedTag& tag);
    [[nodiscard]] bool isJump(const Pose& pose, double seconds) const;
    void restart(const Pose& pose, double timeS);
    void follow(const Pose& pose, double timeS);

    Settings m_settings;
    std::array<OneEuro, 3> m_position;
    double m_turnDegPerS = 0.0;
    Head m_head;
    bool m_isFollowing = false;       ///< the filter contains a recent pose
    std::optional<Pose> m_candidate;  ///< pose of a tag that is not accepted yet
    double m_candidateS = 0.0;
    int m_confirmed = 0;
    int m_otherIsBetter = 0;  ///< pictures in a row in which the pose that was not chosen has half the error
};

}  // namespace core::tracking
