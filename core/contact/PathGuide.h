// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/contact/VelocityEstimator.h"

namespace core::contact {

/// Guides a hand along a recorded path: a soft spring and a damper from the hand to an anchor, which moves to the
/// current place of the path and then follows it.
///
/// Its force is never more than kMostN, rises over kRiseS, and fades over kFadeS at the end. The guidance ends on
/// request, or when the hand resists: when it pushes against the force with kPushN or more for kPushedS and does not
/// follow meanwhile. A hand that is only slow is pulled on. Servo thread; no allocation.
class PathGuide
{
public:
    /// Starts the guidance; the anchor begins at the hand.
    void takeUp() noexcept { m_asked = true; }
    /// Ends the guidance; the force fades.
    void letGo() noexcept { m_leading = false; }
    /// Handles the loss of the device: no force at once, and the guidance ends.
    void drop() noexcept;

    /// Returns the force on the hand for this tick, N, tooth frame.
    /// @param aimMm  the current place of the path
    glm::dvec3 update(const glm::dvec3& deviceMm, const glm::dvec3& aimMm, double seconds) noexcept;

    [[nodiscard]] bool isLeading() const noexcept { return m_leading; }
    /// Returns whether the hand ended the last guidance.
    [[nodiscard]] bool wasPushed() const noexcept { return m_wasPushed; }

    static constexpr double kMostN = 1.5;
    static constexpr double kRiseS = 0.3;
    static constexpr double kFadeS = 0.2;
    static constexpr double kPushN = 1.2;
    static constexpr double kPushedS = 0.1;
    static constexpr double kWalkMmPerS = 40.0;      ///< speed of the anchor towards a distant place
    static constexpr double kFastestMmPerS = 150.0;  ///< largest speed of the anchor along the path

private:
    void walk(const glm::dvec3& deviceMm, const glm::dvec3& aimMm, double seconds) noexcept;
    void watchPush(const glm::dvec3& lead, double seconds) noexcept;

    VelocityEstimator m_pace;
    glm::dvec3 m_anchor{0.0};
    glm::dvec3 m_aim{0.0};      ///< in the last tick
    glm::dvec3 m_gaining{0.0};  ///< speed of the anchor relative to the hand, mm/s
    glm::dvec3 m_forceN{0.0};
    double m_pushedS = 0.0;
    double m_strength = 0.0;
    bool m_begins = true;
    bool m_asked = false;
    bool m_leading = false;
    bool m_wasPushed = false;
};

}  // namespace core::contact
