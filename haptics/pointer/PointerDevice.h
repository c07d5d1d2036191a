// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"
#include "haptics/HapticDevice.h"

namespace haptics {

/// A mouse, pen or keyboard as a haptic device: a simulated hand that follows the pointer and, while the button is
/// held, presses on the tooth.
///
/// With a feed, the hand behaves like a supported finger. It has a level, which goes down at the feed, stops at the
/// depth stop, and waits while the bur cannot follow. The hand presses on the bur in proportion to the height of the
/// bur above the level, up to the requested force. So the bur cuts every tissue at the same speed, and keeps its depth
/// when it moves sideways.
///
/// Without a feed, the hand presses until the tooth resists with the requested force. It is an admittance: its speed is
/// proportional to the missing force, so the force builds up over about kPushLagS. While the bur sinks into a cut, the
/// hand estimates the speed of the bur and adds it.
///
/// Sideways, the hand follows the target through two first-order lags, so that the user does not feel the steps of a 60
/// Hz mouse. With a feed and without contact it follows without lag.
class PointerDevice final : public HapticDevice
{
public:
    /// @param input    written by the ui; values that are not finite are ignored
    /// @param stiffnessNPerMm  of the spring between hand and bur
    PointerDevice(core::rt::TripleBuffer<core::servo::PointerInput>& input, double stiffnessNPerMm,
                  double periodS) noexcept;

    void seeBur(const glm::dvec3& tipMm) noexcept override { m_burMm = tipMm; }
    DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override;
    /// Hovers over the target. A button that is held counts only after it has been released once.
    void takeOver() noexcept override { m_begins = true; }

private:
    void begin() noexcept;
    void moveAside(const glm::dvec3& forceOnHandN, double forceN) noexcept;
    void lean(double forceN) noexcept;
    void lower() noexcept;
    void lift() noexcept;

    core::rt::TripleBuffer<core::servo::PointerInput>& m_input;
    double m_stiffness;
    double m_period;
    core::servo::PointerInput m_want;  ///< the newest finite input
    glm::dvec3 m_burMm{0.0, 0.0, 4.0};
    double m_followMmPerS = 0.0;  ///< speed of the bur into the cut
    double m_levelMm = 4.0;       ///< level of a hand with a feed, tooth frame z
    bool m_isInAir = true;        ///< state of a hand with a feed in the last tick
    double m_idleS = 0.0;         ///< time without contact while the button is down
    double m_freeS = 1.0;         ///< time without contact
    glm::dvec3 m_tip{0.0, 0.0, 4.0};
    glm::dvec2 m_between{0.0, 0.0};  ///< target after the first lag
    bool m_begins = false;           ///< takeOver() was called since the last exchange()
    bool m_isHeldSince = false;      ///< the button was down at takeOver() and has not been released since
};

}  // namespace haptics
