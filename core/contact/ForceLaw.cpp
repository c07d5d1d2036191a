// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/ForceLaw.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace core::contact {
namespace {

double lengthOf(const glm::dvec3& v)
{
    return std::sqrt(glm::dot(v, v));
}

glm::dvec3 shortened(const glm::dvec3& v, double longest)
{
    const double length = lengthOf(v);
    return length > longest ? v * (longest / length) : v;
}

bool within(double value, double low, double high)
{
    return value >= low && value <= high;
}

}  // namespace

Status check(const ForceSettings& settings)
{
    if (!within(settings.stiffnessNPerMm, 0.01, 20.0))
        return unexpected(ErrorCode::OutOfRange, "The stiffness must lie between 0.01 and 20 N/mm.");
    if (!within(settings.friction, 0.0, 1.0))
        return unexpected(ErrorCode::OutOfRange, "The friction coefficient must lie between 0 and 1.");
    if (!within(settings.clampN, 0.1, 20.0))
        return unexpected(ErrorCode::OutOfRange, "The force clamp must lie between 0.1 and 20 N.");
    if (!within(settings.slewNPerS, 1000.0, 1.0e6))
        return unexpected(ErrorCode::OutOfRange, "The force slew limit must be at least 1000 N/s.");
    return {};
}

glm::dvec3 ForceLaw::update(const glm::dvec3& device, const glm::dvec3& anchor, double seconds) noexcept
{
    const glm::dvec3 stretch = anchor - device;
    const double depth = lengthOf(stretch);
    glm::dvec3 wanted{0.0};
    if (depth > 0.0) {
        if (!m_touched)
            m_stuck = anchor;
        const glm::dvec3 normal = stretch / depth;
        glm::dvec3 drag = m_stuck - anchor;
        drag -= normal * glm::dot(drag, normal);
        drag = shortened(drag, m_settings.friction * depth);
        m_stuck = anchor + drag;
        wanted = (stretch + drag) * m_settings.stiffnessNPerMm;
    }
    m_touched = depth > 0.0;
    m_clamped = lengthOf(wanted) > m_settings.clampN;
    wanted = shortened(wanted, m_settings.clampN);
    m_forceN += shortened(wanted - m_forceN, m_settings.slewNPerS * seconds);
    return m_forceN;
}

void ForceLaw::drop() noexcept
{
    m_forceN = glm::dvec3(0.0);
    m_touched = false;
    m_clamped = false;
}

}  // namespace core::contact
