// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"
#include "haptics/pointer/PointerDevice.h"
#include "haptics/simulated/SimulatedFalcon.h"

namespace haptics {

/// A simulated Falcon in a simulated hand that follows the input of a pointer device, for demonstrations. A
/// PointerDevice computes the intended movement, which hand and Falcon carry out. Simulated vision corrects the effect
/// of friction.
class GuidedFalcon final : public HapticDevice
{
public:
    /// @param input, stiffnessNPerMm, periodS  as for PointerDevice
    GuidedFalcon(core::rt::TripleBuffer<core::servo::PointerInput>& input, double stiffnessNPerMm, double periodS);

    DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override;

private:
    double m_glance;  ///< share of a visible error that is corrected per tick
    PointerDevice m_will;
    SimulatedFalcon m_falcon;
    glm::dvec3 m_readMm;
    glm::dvec3 m_correctionMm{0.0};
    glm::dvec3 m_feltN{0.0};
    double m_feeling;  ///< share of a new force that the hand feels after a tick
};

}  // namespace haptics
