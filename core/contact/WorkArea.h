// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/contact/VelocityEstimator.h"

namespace core::contact {

/// The sphere around the tooth's origin in which a device can move: a soft wall at its border, so that the arms do not
/// hit their stops, and centring, which leads a hand that has left it to the start position over the tooth.
///
/// Centring moves an anchor to the start position, first up and then over the tooth, with a soft spring between hand
/// and anchor. It begins when the tool leaves the area or on request. It ends at the start position, when the hand
/// resists or pulls away for kPulledS, or when the device is lost. Then its force fades over kFadeS; after a loss the
/// wall returns over the same time. Servo thread; no allocation.
class WorkArea
{
public:
    /// @param radiusMm  0: the device is unlimited (a mouse), without wall and centring
    explicit WorkArea(double radiusMm) noexcept : m_radiusMm(radiusMm) {}

    /// Starts centring from the current position of the hand.
    void bringHome() noexcept { m_asked = m_radiusMm > 0.0; }
    /// Handles the loss of the device: no force, and centring ends.
    void drop() noexcept;

    /// Returns the force on the hand for this tick, N, tooth frame.
    glm::dvec3 update(const glm::dvec3& device, double seconds) noexcept;

    [[nodiscard]] bool isLeading() const noexcept { return m_leading; }

    static constexpr double kHomeMm = 10.0;      ///< height of the start position over the tooth's origin
    static constexpr double kWalkMmPerS = 60.0;  ///< of the anchor
    static constexpr double kLeadN = 1.0;        ///< largest force of the centring spring
    static constexpr double kPulledS = 0.15;
    static constexpr double kFadeS = 0.2;
    static constexpr double kWallNPerMm = 0.8;
    static constexpr double kWallMostN = 4.0;

private:
    void walk(const glm::dvec3& device, double seconds) noexcept;

    double m_radiusMm;
    VelocityEstimator m_pace;
    glm::dvec3 m_anchor{0.0};
    glm::dvec3 m_gaining{0.0};  ///< speed of the anchor relative to the hand, mm/s
    glm::dvec3 m_forceN{0.0};
    double m_heldBackS = 0.0;
    double m_strength = 0.0;  ///< of the centring spring: 1 while it leads, then falling to 0
    double m_return = 0.0;    ///< of the wall: 0 after drop(), rising to 1
    bool m_begins = true;
    bool m_wasInside = false;
    bool m_asked = false;
    bool m_leading = false;
};

}  // namespace core::contact
