// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/contact/VelocityEstimator.h"

namespace core::contact {

/// Leads a hand along a path that somebody else has gone: a soft spring and a damper from the hand to an anchor, which
/// walks to the place of the moment and then keeps to it.
///
/// Its force is never more than kMostN, comes up over kRiseS, and fades over kFadeS when it ends. It ends when the hand
/// is let go, or when the hand itself wants to be: when it pushes against the lead with kPushN or more for kPushedS,
/// and does not go along meanwhile; a hand that is only slow is pulled on. Servo thread; no allocation.
class PathGuide
{
public:
    /// Leads from now on; the anchor begins where the hand is.
    void takeUp() noexcept { m_asked = true; }
    /// The force fades.
    void letGo() noexcept { m_leading = false; }
    /// The device is lost: no force at once, and the hand is on its own.
    void drop() noexcept;

    /// Force on the hand for this tick, newtons, tooth frame.
    /// @param aimMm  the place of the moment
    glm::dvec3 update(const glm::dvec3& deviceMm, const glm::dvec3& aimMm, double seconds) noexcept;

    [[nodiscard]] bool isLeading() const noexcept { return m_leading; }
    /// It was the hand that ended the last lead.
    [[nodiscard]] bool wasPushed() const noexcept { return m_wasPushed; }

    static constexpr double kMostN = 1.5;
    static constexpr double kRiseS = 0.3;
    static constexpr double kFadeS = 0.2;
    static constexpr double kPushN = 1.2;
    static constexpr double kPushedS = 0.1;
    static constexpr double kWalkMmPerS = 40.0;      ///< of the anchor to a place that is far
    static constexpr double kFastestMmPerS = 150.0;  ///< of the anchor with the path

private:
    void walk(const glm::dvec3& deviceMm, const glm::dvec3& aimMm, double seconds) noexcept;
    void watchPush(const glm::dvec3& lead, double seconds) noexcept;

    VelocityEstimator m_pace;
    glm::dvec3 m_anchor{0.0};
    glm::dvec3 m_aim{0.0};      ///< of the tick before
    glm::dvec3 m_gaining{0.0};  ///< the anchor's pace against the hand's, mm/s
    glm::dvec3 m_forceN{0.0};
    double m_pushedS = 0.0;
    double m_strength = 0.0;
    bool m_begins = true;
    bool m_asked = false;
    bool m_leading = false;
    bool m_wasPushed = false;
};

}  // namespace core::contact
