// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/ForceLaw.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/contact/Lengths.h"

namespace core::contact {
namespace {

constexpr double kTouchMm = 1.0e-6;  ///< a penetration below a nanometre is rounding
/// Largest speed at which the held end of the spring moves by itself, and its increase per mm that the hand moves. The
/// nearest point of a convex hump moves at most 2.5 / 1.5 times as fast as a hand 1 mm inside it.
constexpr double kSlipMmPerS = 100.0;
constexpr double kSlideShare = 2.0;
constexpr double kGoneS = 0.006;  ///< time constant of the approach from far away: no hand is dragged through air
constexpr double kBrakeNSPerMm = 0.03;
constexpr double kPaceGrowth = 1.5;  ///< largest growth per tick; even an impact is visible in the second tick
/// Fastest change of the damper's force across the spring: a fifth of what a hand notices, per 1 ms. A swing of 0.15 mm
/// at 20 Hz needs 7 N/s. With 15 to 25 N/s, 508 to 510 of the lab's 516 trials pass, in no order. With 21 N/s, no limit
/// is missed.
constexpr double kAcrossNPerS = 21.0;

/// Up to this stiffness, the damper above and the dry friction of the device are sufficient. The energy that sampling
/// and delay add to a stiffer spring is proportional to its stiffness, and so is its damper. The limit is where the
/// damper would stop the Falcon's 0.25 kg faster than a force arrives, in 1.4 ms.
constexpr double kGentleNPerMm = 2.5;
constexpr double kMostPrompt = 6.0;

bool within(double value, double low, double high)
{
    return value >= low && value <= high;
}

}  // namespace

Status check(const ForceSettings& settings)
{
    if (!within(settings.stiffnessNPerMm, 0.01, 40.0))
        return unexpected(ErrorCode::OutOfRange, "The stiffness must lie between 0.01 and 40 N/mm.");
    if (!within(settings.dampingNSPerM, 0.0, 50.0))
        return unexpected(ErrorCode::OutOfRange, "The damping must lie between 0 and 50 N s/m.");
    if (!within(settings.fastDampingNSPerM, 0.0, 100.0))
        return unexpected(ErrorCode::OutOfRange, "The damping of fast motion must lie between 0 and 100 N s/m.");
    if (!within(settings.brakeN, 0.0, 8.0))
        return unexpected(ErrorCode::OutOfRange, "The brake of passivity control must lie between 0 and 8 N.");
    if (!within(settings.lateralGain, 0.1, 1.0) || !within(settings.verticalGain, 0.1, 1.0))
        return unexpected(ErrorCode::OutOfRange, "The force gains must lie between 0.1 and 1.");
    if (!within(settings.friction, 0.0, 1.0))
        return unexpected(ErrorCode::OutOfRange, "The friction coefficient must lie between 0 and 1.");
    if (!within(settings.clampN, 0.1, 20.0))
        return unexpected(ErrorCode::OutOfRange, "The force clamp must lie between 0.1 and 20 N.");
    if (settings.workAreaMm != 0.0 && !within(settings.workAreaMm, 15.0, 1000.0))
        return unexpected(ErrorCode::OutOfRange, "The work area must reach 15 to 1000 mm, or be 0: none.");
    if (!within(settings.vibrationN, 0.0, 0.2))
        return unexpected(ErrorCode::OutOfRange, "The vibration of the bur must lie between 0 and 0.2 N.");
    if (!within(settings.slewNPerS, 1000.0, 1.0e6))
        return unexpected(ErrorCode::OutOfRange, "The force slew limit must be at least 1000 N/s.");
    return {};
}

/// Moves the held end to the anchor. An undo, another bur or a column that breaks off can make the ground appear or
/// vanish in a tick. The anchor then moves faster than a sliding hand does, so its motion is spread over some
/// milliseconds.
void ForceLaw::follow(const glm::dvec3& anchor, double movedMm, double seconds) noexcept
{
    const glm::dvec3 way = anchor - m_held;
    const double length = lengthOf(way);
    const double most = std::max(kSlipMmPerS * seconds + kSlideShare * movedMm, length * seconds / kGoneS);
    m_held = m_begins || length <= most ? anchor : m_held + way * (most / length);
}

/// Returns the velocity, mm/s, at which the hand itself stretches the spring. The motion of an anchor that slips by
/// itself must not be damped.
glm::dvec3 ForceLaw::handsPace() const noexcept
{
    const glm::dvec3& stretching = m_stretching.mmPerS();
    const glm::dvec3& moving = m_moving.mmPerS();
    if (!(glm::dot(stretching, moving) < 0.0))
        return glm::dvec3(0.0);
    return shortened(stretching, lengthOf(moving));
}

/// Returns handsPace() with limited growth per tick. Otherwise an anchor that catches on an edge for one tick, while
/// the hand moves on, would be damped like a wall.
glm::dvec3 ForceLaw::lastingPace() noexcept
{
    const double most = kPaceGrowth * lengthOf(m_pace);
    m_pace = handsPace();
    return shortened(m_pace, most);
}

/// Returns the speed, mm/s, at which the hand lengthens the spring, under the conditions of handsPace() and
/// lastingPace(). It uses the length of the spring, not its vector: in a groove the spring turns, and a turn is no
/// impact.
/// @param normal  unit vector from the hand to the held end
double ForceLaw::lengthening(const glm::dvec3& normal) noexcept
{
    const double hand = -glm::dot(m_moving.mmPerS(), normal);
    const double length = m_length.mmPerS().x;
    const double most = kPaceGrowth * std::abs(m_lengthening);
    m_lengthening = length * hand > 0.0 ? std::copysign(std::min(std::abs(length), std::abs(hand)), hand) : 0.0;
    return std::clamp(m_lengthening, -most, most);
}

/// Returns the force of the damper, N. It damps the lengthening of the spring, because only that can be an impact.
/// Across the spring, the force changes gradually.
glm::dvec3 ForceLaw::damper(const glm::dvec3& pace, const glm::dvec3& normal, double seconds) noexcept
{
    const double along = lengthening(normal);
    const double fast = along * along / (along * along + kFastMmPerS * kFastMmPerS);
    // The stiffer the spring, the later this speed is known. The prompt damper replaces this one to that extent.
    const double share = 1.0 / timesStiff();
    const double nSPerMm = 0.001 * (m_settings.dampingNSPerM + m_settings.fastDampingNSPerM * share * fast);
    const glm::dvec3 across = pace - normal * glm::dot(pace, normal);
    m_acrossN += shortened(across * nSPerMm - m_acrossN, kAcrossNPerS * seconds);
    return normal * (nSPerMm * along) + m_acrossN;
}

/// Returns the additional damping force of a stiff spring, N. It uses the speed that the encoder counts prove. That
/// speed is known some milliseconds sooner than the stretching of the spring, even in the air before the contact. The
/// force acts only along the spring, so a hand that slides along the tooth does not feel it.
/// @param normal  unit vector from the hand to the held end
glm::dvec3 ForceLaw::promptDamper(const glm::dvec3& normal, double seconds) const noexcept
{
    const double nSPerM = m_settings.fastDampingNSPerM * std::min(kMostPrompt, timesStiff() - 1.0);
    if (!(nSPerM > 0.0))
        return glm::dvec3(0.0);
    return normal * (-0.001 * nSPerM * glm::dot(m_moving.provenMmPerS(seconds), normal));
}

/// Returns the share of a force that is applied to the hand, along x, y and z.
glm::dvec3 ForceLaw::gain() const noexcept
{
    return glm::dvec3(m_settings.lateralGain, m_settings.lateralGain, m_settings.verticalGain) * m_return;
}

double ForceLaw::springN(const glm::dvec3& stretchMm) const noexcept
{
    return std::min(lengthOf(stretchMm * gain()) * stiffnessNPerMm(), m_settings.clampN);
}

/// Returns the stiffness as a multiple of the stiffest gentle spring; at least 1.
double ForceLaw::timesStiff() const noexcept
{
    return std::max(1.0, stiffnessNPerMm() / kGentleNPerMm);
}

/// Limits the energy by passivity control (Hannaford & Ryu 2002) in its strict form: all energy in the spring must have
/// come from the hand. Other energy, from sampling or from a jump of the anchor, is removed from the motion by a brake.
/// Energy of the hand that is not in the spring was used up by cutting or friction, and does not count in its favour.
/// Slow motion is left to dry friction, because the brake would react to single encoder counts.
glm::dvec3 ForceLaw::brake(const glm::dvec3& pace, double springMj, double seconds) noexcept
{
    m_takenMj = std::min(m_takenMj, springMj);
    const double owed = springMj - m_takenMj;
    const double mmPerS = lengthOf(pace);
    if (!(owed > 0.0) || !(mmPerS > kFastMmPerS) || !(seconds > 0.0))
        return glm::dvec3(0.0);
    const double newtons =
        std::min({owed / (mmPerS * seconds), m_settings.brakeN, kBrakeNSPerMm * (mmPerS - kFastMmPerS)});
    return pace * (newtons / mmPerS);
}

glm::dvec3 ForceLaw::update(const glm::dvec3& device, const glm::dvec3& anchor, double seconds) noexcept
{
    if (m_begins)
        m_moving.restart(device);
    const glm::dvec3 moved = m_begins ? glm::dvec3(0.0) : device - m_device;
    m_device = device;
    m_moving.add(device, seconds);
    m_takenMj -= glm::dot(m_forceN, moved);
    m_return = std::min(1.0, m_return + seconds / kReturnS);
    follow(anchor, lengthOf(moved), seconds);

    const double stiffness = stiffnessNPerMm();
    glm::dvec3 stretch = m_held - device;
    const double depth = lengthOf(stretch);
    const bool touches = depth > kTouchMm;
    if (touches) {
        if (!m_touched)
            m_stuck = m_held;
        const glm::dvec3 normal = stretch / depth;
        glm::dvec3 drag = m_stuck - m_held;
        drag -= normal * glm::dot(drag, normal);
        drag = shortened(drag, m_settings.friction * depth);
        m_stuck = m_held + drag;
        stretch += drag;
    }
    if (m_begins)
        m_stretching.restart(stretch);
    m_stretching.add(stretch, seconds);
    const glm::dvec3 length(depth, 0.0, 0.0);
    if (m_begins)
        m_length.restart(length);
    m_length.add(length, seconds);

    glm::dvec3 wanted{0.0};
    if (touches) {
        const glm::dvec3 pace = lastingPace();
        const glm::dvec3 normal = (m_held - device) / depth;
        wanted = stretch * stiffness + damper(pace, normal, seconds) + promptDamper(normal, seconds);
        wanted += brake(pace, 0.5 * stiffness * glm::dot(stretch * gain(), stretch), seconds);
        const double pull = glm::dot(wanted, normal);
        if (pull < 0.0)
            wanted -= normal * pull;  // the force must not pull the hand into the tooth
        wanted *= gain();
    } else {
        m_takenMj = 0.0;
        m_pace = glm::dvec3(0.0);
        m_lengthening = 0.0;
        m_acrossN = glm::dvec3(0.0);
    }
    m_begins = false;
    m_touched = touches;
    m_clamped = lengthOf(wanted) > m_settings.clampN;
    wanted = shortened(wanted, m_settings.clampN);
    m_forceN += shortened(wanted - m_forceN, m_settings.slewNPerS * timesStiff() * seconds);
    return m_forceN;
}

void ForceLaw::drop() noexcept
{
    restart();
    m_return = 0.0;
}

void ForceLaw::restart() noexcept
{
    m_forceN = glm::dvec3(0.0);
    m_takenMj = 0.0;
    m_pace = glm::dvec3(0.0);
    m_lengthening = 0.0;
    m_acrossN = glm::dvec3(0.0);
    m_return = 1.0;
    m_begins = true;
    m_touched = false;
    m_clamped = false;
}

}  // namespace core::contact
