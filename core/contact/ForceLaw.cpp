// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/ForceLaw.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace core::contact {
namespace {

/// Corner of the damper's low-pass, two poles: a count of the Falcon in a millisecond is 30 to 50 mm/s, which a damper
/// must not pass on (haptics.md 2.6).
constexpr double kPaceCornerRadPerS = 2.0 * 3.14159265358979 * 150.0;
constexpr double kLeastMoveMm = 1.0e-4;
constexpr double kBrakeNSPerMm = 0.05;

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
    if (!within(settings.dampingNSPerM, 0.0, 50.0))
        return unexpected(ErrorCode::OutOfRange, "The damping must lie between 0 and 50 N s/m.");
    if (!within(settings.brakeN, 0.0, 8.0))
        return unexpected(ErrorCode::OutOfRange, "The brake of passivity control must lie between 0 and 8 N.");
    if (!within(settings.lateralGain, 0.1, 1.0) || !within(settings.verticalGain, 0.1, 1.0))
        return unexpected(ErrorCode::OutOfRange, "The force gains must lie between 0.1 and 1.");
    if (!within(settings.friction, 0.0, 1.0))
        return unexpected(ErrorCode::OutOfRange, "The friction coefficient must lie between 0 and 1.");
    if (!within(settings.clampN, 0.1, 20.0))
        return unexpected(ErrorCode::OutOfRange, "The force clamp must lie between 0.1 and 20 N.");
    if (!within(settings.slewNPerS, 1000.0, 1.0e6))
        return unexpected(ErrorCode::OutOfRange, "The force slew limit must be at least 1000 N/s.");
    return {};
}

/// The damper's force, N. A damper that would pull the hand into the tooth lets go.
glm::dvec3 ForceLaw::damped(const glm::dvec3& stretch, double seconds) noexcept
{
    const glm::dvec3 pace = seconds > 0.0 ? (stretch - m_stretch) / seconds : glm::dvec3(0.0);
    const double share = kPaceCornerRadPerS * seconds / (1.0 + kPaceCornerRadPerS * seconds);
    m_pace += (pace - m_pace) * share;
    m_calmPace += (m_pace - m_calmPace) * share;
    return m_calmPace * (m_settings.dampingNSPerM * 0.001);
}

/// Passivity control (Hannaford & Ryu 2002) in its strict form: what the spring holds must have come from the hand.
/// What it holds beyond that, by sampling or by a jump of the anchor, is taken out of the hand's motion; what the hand
/// gave beyond that has been cut or rubbed away and is no credit.
glm::dvec3 ForceLaw::braked(const glm::dvec3& wanted, const glm::dvec3& moved, double springMj, double seconds) noexcept
{
    m_takenMj = std::min(m_takenMj, springMj);
    const double owed = springMj - m_takenMj;
    const double way = lengthOf(moved);
    if (!(owed > 0.0) || way < kLeastMoveMm || !(seconds > 0.0))
        return wanted;
    // A slow hand would feel a few microjoules as a click.
    const double mostN = std::min(m_settings.brakeN, kBrakeNSPerMm * way / seconds);
    return wanted - moved * (std::min(owed / way, mostN) / way);
}

glm::dvec3 ForceLaw::update(const glm::dvec3& device, const glm::dvec3& anchor, double seconds) noexcept
{
    const glm::dvec3 moved = m_return > 0.0 ? device - m_device : glm::dvec3(0.0);
    m_device = device;
    m_takenMj -= glm::dot(m_forceN, moved);
    m_return = std::min(1.0, m_return + seconds / kReturnS);

    const double stiffness = stiffnessNPerMm();
    glm::dvec3 stretch = anchor - device;
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
        stretch += drag;
        wanted = stretch * stiffness + damped(stretch, seconds);
        const double pull = glm::dot(wanted, normal);
        if (pull < 0.0)
            wanted -= normal * pull;
        wanted = braked(wanted, moved, 0.5 * stiffness * glm::dot(stretch, stretch), seconds);
        wanted *= glm::dvec3(m_settings.lateralGain, m_settings.lateralGain, m_settings.verticalGain) * m_return;
    } else {
        m_pace = glm::dvec3(0.0);
        m_calmPace = glm::dvec3(0.0);
        m_takenMj = 0.0;
        m_return = 1.0;  // what begins in the air begins softly by itself
    }
    m_stretch = stretch;
    m_touched = depth > 0.0;
    m_clamped = lengthOf(wanted) > m_settings.clampN;
    wanted = shortened(wanted, m_settings.clampN);
    m_forceN += shortened(wanted - m_forceN, m_settings.slewNPerS * seconds);
    return m_forceN;
}

void ForceLaw::drop() noexcept
{
    m_forceN = glm::dvec3(0.0);
    m_pace = glm::dvec3(0.0);
    m_calmPace = glm::dvec3(0.0);
    m_stretch = glm::dvec3(0.0);
    m_takenMj = 0.0;
    m_return = 0.0;
    m_touched = false;
    m_clamped = false;
}

}  // namespace core::contact
