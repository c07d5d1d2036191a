// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/simulated/GuidedFalcon.h"
#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"

#include <algorithm>

#include <glm/common.hpp>

namespace haptics {
namespace {

/// A firm hand. The wall of a narrow fissure would push a softer one aside, and the bur would slip to another place.
constexpr HandFigures kHand = kHands[2];
constexpr double kHandNPerMm = 0.001 * kHand.stiffnessNPerM;
constexpr glm::dvec3 kStartMm{0.0, 0.0, 4.0};  ///< start of a PointerDevice
constexpr double kEyeLagS = 0.3;               ///< from eye to hand [A]
constexpr double kFeelLagS = 0.01;             ///< time to distinguish a push from a tremble [A]
constexpr double kMostCorrectionMm = 0.5;      ///< the device's dry friction holds this hand back by a little less

}  // namespace

GuidedFalcon::GuidedFalcon(core::rt::TripleBuffer<core::servo::PointerInput>& input, double stiffnessNPerMm,
                           double periodS)
    : m_glance(periodS / kEyeLagS),
      // The springs of hand and tooth are in series when the hand leans on a tooth through an arm.
      m_will(input, stiffnessNPerMm * kHandNPerMm / (stiffnessNPerMm + kHandNPerMm), periodS),
      m_falcon({}, kHand, periodS, 1, kStartMm), m_readMm(kStartMm), m_feeling(std::min(1.0, periodS / kFeelLagS))
{}

DeviceSample GuidedFalcon::exchange(const glm::dvec3& forceOnHandN) noexcept
{
    m_feltN += (forceOnHandN - m_feltN) * m_feeling;
    const glm::dvec3 wanted(m_will.exchange(m_feltN).tipInToothMm);
    // Along the axis of the bur, the hand controls the force and not the position.
    const glm::dvec3 aside = (wanted - m_readMm) * glm::dvec3(1.0, 1.0, 0.0);
    m_correctionMm =
        glm::clamp(m_correctionMm + aside * m_glance, -glm::dvec3(kMostCorrectionMm), glm::dvec3(kMostCorrectionMm));
    m_falcon.follow(wanted + m_correctionMm);
    const DeviceSample sample = m_falcon.exchange(forceOnHandN);
    m_readMm = glm::dvec3(sample.tipInToothMm);
    return sample;
}

}  // namespace haptics
