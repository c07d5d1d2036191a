// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"
#include "haptics/pointer/PointerDevice.h"
#include "haptics/simulated/SimulatedFalcon.h"

namespace haptics {

/// A simulated Falcon in a simulated hand that does what is asked of a pointer device: to watch the simulator drill by
/// itself. The PointerDevice is the will, hand and Falcon carry it out, and the eye corrects what friction holds back.
class GuidedFalcon final : public HapticDevice
{
public:
    /// @param input, stiffnessNPerMm, periodS  as of PointerDevice
    GuidedFalcon(core::rt::TripleBuffer<core::servo::PointerInput>& input, double stiffnessNPerMm, double periodS);

    DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override;

private:
    double m_glance;  ///< share of an error seen that is made up for in a tick
    PointerDevice m_will;
    SimulatedFalcon m_falcon;
    glm::dvec3 m_readMm;
    glm::dvec3 m_correctionMm{0.0};
    glm::dvec3 m_feltN{0.0};
    double m_feeling;  ///< share of a new force that is felt after a tick
};

}  // namespace haptics
