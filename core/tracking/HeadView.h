// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/tracking/HeadFilter.h"
#include "core/tracking/Lean.h"

namespace core::tracking {

/// Settings for the view that follows the head.
struct HeadViewSettings
{
    double gain = 2.0;         ///< rotation of the view per rotation of the head, 0.5 to 4
    double mostYawDeg = 75.0;  ///< largest rotation to a side
    double mostPitchDeg = 40.0;
    double depthPower = 0.7;  ///< exponent of the distance: 0 ignores it, 1 follows the head fully
    bool isWindow = false;    ///< the screen is a window in front of the tooth, which does not turn; otherwise the
                              ///< tooth turns
    bool operator==(const HeadViewSettings&) const = default;
};

/// Computes in each frame the rotation of the view from the position of the head relative to that at recentre().
///
/// Without a tag the view stays, and after a second returns smoothly; with one it approaches the head smoothly. It
/// never turns by more than a degree per frame. Ui thread.
class HeadView
{
public:
    static constexpr double kMostDegPerFrame = 1.0;

    void setSettings(const HeadViewSettings& settings) { m_settings = settings; }
    /// Makes the next position of the head its middle position.
    void recentre() { m_hasNeutral = false; }
    /// @param nowS     steady clock; the time at which the frame will be seen
    /// @param seconds  since the last frame
    /// @param holds    the bur touches the tooth: then losing the tag moves nothing
    const Lean& update(const Head& head, double nowS, double seconds, bool holds);
    [[nodiscard]] const Lean& lean() const { return m_lean; }
    /// Returns whether the view is as the mouse left it.
    [[nodiscard]] bool isAtRest() const { return m_lean == Lean{}; }

private:
    [[nodiscard]] Lean wanted(const glm::dvec3& positionMm) const;

    HeadViewSettings m_settings;
    bool m_hasNeutral = false;
    glm::dvec3 m_neutralMm{0.0};  ///< camera frame
    Lean m_lean;
    double m_follow = 0.0;  ///< 0: at rest, 1: with the head
};

}  // namespace core::tracking
