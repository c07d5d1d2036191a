// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rt/TripleBuffer.h"
#include "core/session/Links.h"
#include "haptics/HapticDevice.h"

namespace haptics {

/// A mouse, pen or keyboard as a haptic device: a simulated hand that goes where the pointer points and, while the
/// button is held, leans on the tooth until the tooth pushes back with the wanted force.
///
/// Sideways the hand glides to the target through two first-order lags, so that the steps of a 60 Hz mouse are not
/// felt. Downwards it is an admittance: its speed is proportional to the force still missing, so the force builds up
/// over about kPushLagS and the hand follows the bur into the cut, over cusps and along walls alike. To the pace at
/// which the bur sinks into a cut it adds up by and by, so that while drilling, too, the force is the wanted one.
class PointerDevice final : public HapticDevice
{
public:
    /// @param input    written by the ui; a wish that is not finite is passed over
    /// @param stiffnessNPerMm  of the spring that answers the hand: the unit of its leaning
    PointerDevice(core::rt::TripleBuffer<core::session::PointerInput>& input, double stiffnessNPerMm,
                  double periodS) noexcept;

    DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override;

private:
    core::rt::TripleBuffer<core::session::PointerInput>& m_input;
    double m_stiffness;
    double m_period;
    core::session::PointerInput m_want;  ///< the newest that was finite
    double m_followMmPerS = 0.0;         ///< pace of the bur into the cut
    glm::dvec3 m_tip{0.0, 0.0, 4.0};
    glm::dvec2 m_between{0.0, 0.0};  ///< target after the first lag
};

}  // namespace haptics
