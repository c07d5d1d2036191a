// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/base/Result.h"
#include "core/contact/VelocityEstimator.h"

namespace core::contact {

/// Parameters that turn the distance between hand and anchor into a force.
struct ForceSettings
{
    /// Stiffness of the virtual coupling, the same for the whole tooth: hardness affects removal
    /// (docs/facts/haptics.md, section 3).
    double stiffnessNPerMm = 2.0;
    /// Damping of slow stretching of the spring, where the device's dry friction absorbs the energy that sampling and
    /// delay add, and where more damping would make every encoder count felt.
    double dampingNSPerM = 3.0;
    /// Additional damping when the length of the spring changes much faster than ForceLaw::kFastMmPerS, which dry
    /// friction does not absorb: small motions stop and large ones grow (docs/facts/haptics.md, section 2.1). For a
    /// spring stiffer than 3 N/mm it increases in proportion, with a velocity estimate of less delay.
    double fastDampingNSPerM = 30.0;
    double brakeN = 0.5;    ///< largest force of passivity control against fast motion; 0: none
    double friction = 0.1;  ///< Coulomb coefficient of the bur sliding on the tooth
    /// Factors of the force along x and y, and along z, for a device whose arms are weaker sideways. Equal factors act
    /// like a softer spring. Unequal ones tilt the force on a slope, so that it is no longer conservative: a circle
    /// into a 45 degree plane and out again, 0.3 mm wide, gives 0.07 mJ for a difference of one half. So both are 1 by
    /// default.
    double lateralGain = 1.0;
    double verticalGain = 1.0;
    double clampN = 8.0;  ///< largest force on the hand
    /// Radius of the sphere around the tooth's origin in which the device moves, mm; 0: unlimited, like a mouse
    /// (WorkArea).
    double workAreaMm = 0.0;
    double vibrationN = 0.0;  ///< rms vibration of a free-running bur (BurVibration); 0: none
    /// Fastest change of the force; below 1000 the filter itself destabilises (docs/facts/haptics.md, section 2.3). For
    /// a spring stiffer than 2.5 N/mm the limit rises in proportion, because it limits the speed of the hand.
    double slewNPerS = 2000.0;
    bool operator==(const ForceSettings&) const = default;
};

/// Checks the settings. OutOfRange names the first invalid one.
[[nodiscard]] Status check(const ForceSettings& settings);

/// Virtual coupling from the hand to the anchor (Colgate 1995; Adams & Hannaford 1999): spring and damper, friction,
/// passivity control, clamp, slew limit. Servo thread; no allocation.
class ForceLaw
{
public:
    explicit ForceLaw(const ForceSettings& settings) noexcept : m_settings(settings) {}

    /// Returns the force on the hand for this tick, N, tooth frame.
    glm::dvec3 update(const glm::dvec3& device, const glm::dvec3& anchor, double seconds) noexcept;

    /// Resets all state. No ramp is needed: the force is zero until contact.
    void restart() noexcept;
    /// Handles the loss of the device: zero force at once. When the device returns the force rises from zero over
    /// kReturnS, with or without contact.
    void drop() noexcept;

    /// Changes the settings. The resulting change of the force obeys the slew limit.
    void setSettings(const ForceSettings& settings) noexcept { m_settings = settings; }
    /// Sets the stiffness as a share of the settings, 0 to 1, for a loop that has become slower.
    void setShare(double share) noexcept { m_share = share; }
    /// Returns the force of the spring alone at this stretch, N: the load of a cutting bur. Rises after drop() like the
    /// force, so that a force that is not felt does not cut.
    [[nodiscard]] double springN(const glm::dvec3& stretchMm) const noexcept;

    /// Returns whether the last force was clamped.
    [[nodiscard]] bool clamped() const noexcept { return m_clamped; }
    [[nodiscard]] const ForceSettings& settings() const noexcept { return m_settings; }

    static constexpr double kReturnS = 0.2;
    static constexpr double kFastMmPerS = 30.0;

private:
    void follow(const glm::dvec3& anchor, double movedMm, double seconds) noexcept;
    [[nodiscard]] glm::dvec3 handsPace() const noexcept;
    [[nodiscard]] glm::dvec3 lastingPace() noexcept;
    [[nodiscard]] double lengthening(const glm::dvec3& normal) noexcept;
    [[nodiscard]] glm::dvec3 damper(const glm::dvec3& pace, const glm::dvec3& normal, double seconds) noexcept;
    [[nodiscard]] glm::dvec3 promptDamper(const glm::dvec3& normal, double seconds) const noexcept;
    /// Returns the current stiffness, N/mm.
    [[nodiscard]] double stiffnessNPerMm() const noexcept { return m_share * m_settings.stiffnessNPerMm; }
    [[nodiscard]] glm::dvec3 gain() const noexcept;
    [[nodiscard]] double timesStiff() const noexcept;
    [[nodiscard]] glm::dvec3 brake(const glm::dvec3& pace, double springMj, double seconds) noexcept;

    ForceSettings m_settings;
    glm::dvec3 m_forceN{0.0};
    /// The end of the spring: the anchor without its jumps.
    glm::dvec3 m_held{0.0};
    /// The place where the bur sticks to the surface: follows within the friction cone, so that friction adds neither
    /// delay nor velocity noise (Harwin & Melder 2002). The anchor itself is where the geometry puts it.
    glm::dvec3 m_stuck{0.0};
    glm::dvec3 m_device{0.0};
    VelocityEstimator m_stretching;
    VelocityEstimator m_moving;  ///< of the device
    VelocityEstimator m_length;  ///< of the spring from the hand to the held end, as x
    glm::dvec3 m_pace{0.0};      ///< handsPace() of the last tick
    double m_lengthening = 0.0;  ///< of the spring by the hand in the last tick, mm/s
    glm::dvec3 m_acrossN{0.0};   ///< damping force across the spring
    double m_takenMj = 0.0;      ///< energy that the hand has put into the spring and not got back
    double m_share = 1.0;
    double m_return = 1.0;  ///< 0 after drop(), rising to 1
    bool m_begins = true;   ///< there is no previous tick
    bool m_touched = false;
    bool m_clamped = false;
};

}  // namespace core::contact
