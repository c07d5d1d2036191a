// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/contact/VelocityEstimator.h"

namespace core::contact {

/// The ball about the tooth's origin in which a device can move: a soft wall at its end, so that nobody runs into the
/// arms' stops, and centring, which leads a hand that has left it home over the tooth.
///
/// Centring walks an anchor home, up first and then over the tooth, with a soft spring between hand and anchor. It
/// begins when the tool leaves the area or on request. It ends at home, or when the hand holds back or pulls away for
/// kPulledS, or when the device is lost. Whatever ends it, its force fades over kFadeS; after a loss the wall comes
/// back over as long. Servo thread; no allocation.
class WorkArea
{
public:
    /// @param radiusMm  0: the device has no end (a mouse), and there is neither wall nor centring
    explicit WorkArea(double radiusMm) noexcept : m_radiusMm(radiusMm) {}

    /// Leads the hand home from where it is now.
    void bringHome() noexcept { m_asked = m_radiusMm > 0.0; }
    /// The device is lost: no force, and the hand is on its own again.
    void drop() noexcept;

    /// Force on the hand for this tick, newtons, tooth frame.
    glm::dvec3 update(const glm::dvec3& device, double seconds) noexcept;

    [[nodiscard]] bool isLeading() const noexcept { return m_leading; }

    static constexpr double kHomeMm = 10.0;      ///< height of home over the tooth's origin
    static constexpr double kWalkMmPerS = 60.0;  ///< of the anchor
    static constexpr double kLeadN = 1.0;        ///< most that the spring pulls the hand with
    static constexpr double kPulledS = 0.15;
    static constexpr double kFadeS = 0.2;
    static constexpr double kWallNPerMm = 0.8;
    static constexpr double kWallMostN = 4.0;

private:
    void walk(const glm::dvec3& device, double seconds) noexcept;

    double m_radiusMm;
    VelocityEstimator m_pace;
    glm::dvec3 m_anchor{0.0};
    glm::dvec3 m_gaining{0.0};  ///< its pace against the hand's, mm/s
    glm::dvec3 m_forceN{0.0};
    double m_heldBackS = 0.0;
    double m_strength = 0.0;  ///< of the centring spring, 1 while it leads, then falling to 0
    double m_return = 0.0;    ///< of the wall, 0 after drop(), rising to 1
    bool m_begins = true;
    bool m_wasInside = false;
    bool m_asked = false;
    bool m_leading = false;
};

}  // namespace core::contact
