// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "core/session/DeviceReport.h"
#include "haptics/falcon/Kinematics.h"

namespace haptics::falcon {

/// Converts between the device frame of a Falcon and the tooth frame, for a Falcon that stands or lies in front of the
/// user or beside them. The origin of the tooth is DeviceSetup::restMm above the middle of the work area.
class Placement
{
public:
    explicit Placement(const core::session::DeviceSetup& setup = {}) noexcept;

    [[nodiscard]] glm::dvec3 toothFromGripMm(const glm::dvec3& gripMm) const noexcept
    {
        return (m_toothFromDevice * (gripMm - kCentreMm) - m_restMm) / m_scale;
    }
    [[nodiscard]] glm::dvec3 gripFromToothMm(const glm::dvec3& toothMm) const noexcept
    {
        return kCentreMm + (toothMm * m_scale + m_restMm) * m_toothFromDevice;  // the transpose turns back
    }
    /// Converts a force on the hand. The scale has no effect on forces.
    [[nodiscard]] glm::dvec3 deviceFromToothN(const glm::dvec3& forceN) const noexcept
    {
        return forceN * m_toothFromDevice;
    }

private:
    glm::dmat3 m_toothFromDevice;
    double m_scale;
    glm::dvec3 m_restMm;  ///< of the hand, along the axes of the tooth
};

}  // namespace haptics::falcon
