// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/tracking/HeadFilter.h"
#include "core/tracking/Lean.h"

namespace core::tracking {

/// How the view follows the head.
struct HeadViewSettings
{
    double gain = 2.0;         ///< degrees of the view for one of the head, 0.5 to 4
    double mostYawDeg = 75.0;  ///< farthest turn to a side
    double mostPitchDeg = 40.0;
    double depthPower = 0.7;  ///< of the distance: 0 keeps it, 1 follows the head in full
    bool isWindow = false;    ///< the screen is a window before the tooth, which does not turn; else the tooth turns
    bool operator==(const HeadViewSettings&) const = default;
};

/// Computes in each frame how the view turns, from the position of the head relative to that at recentre().
///
/// Without a tag, the view stays, and after a second glides back; with one it glides to the head. It never turns by
/// more than a degree a frame. Ui thread.
class HeadView
{
public:
    static constexpr double kMostDegPerFrame = 1.0;

    void setSettings(const HeadViewSettings& settings) { m_settings = settings; }
    /// Where the head is next seen becomes its middle position.
    void recentre() { m_hasNeutral = false; }
    /// @param nowS     steady clock; when the frame will be seen
    /// @param seconds  since the last frame
    /// @param holds    the bur touches the tooth: a tag that is lost moves nothing
    const Lean& update(const Head& head, double nowS, double seconds, bool holds);
    [[nodiscard]] const Lean& lean() const { return m_lean; }
    /// The view is where the mouse left it.
    [[nodiscard]] bool isAtRest() const { return m_lean == Lean{}; }

private:
    [[nodiscard]] Lean wanted(const glm::dvec3& positionMm) const;

    HeadViewSettings m_settings;
    bool m_hasNeutral = false;
    glm::dvec3 m_neutralMm{0.0};  ///< camera frame
    Lean m_lean;
    double m_follow = 0.0;  ///< 0: it glides from rest, 1: it is with the head
};

}  // namespace core::tracking
