// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/base/Result.h"
#include "core/contact/VelocityEstimator.h"

namespace core::contact {

/// What turns the distance between hand and anchor into a force.
struct ForceSettings
{
    /// Spring of the virtual coupling, one for the whole tooth: hardness acts on removal
    /// (docs/facts/haptics.md, section 3).
    double stiffnessNPerMm = 2.0;
    /// Its damper, on the speed at which it is stretched: for slow motion, where the device's dry friction holds what
    /// sampling and delay feed, and where every count of the encoders would be felt through more.
    double dampingNSPerM = 3.0;
    /// What the damper has more where the length of the spring changes much faster than ForceLaw::kFastMmPerS, which
    /// dry friction does not hold: small motions come to rest and large ones grow (docs/facts/haptics.md, section 2.1).
    /// For a spring stiffer than 3 N/mm so much more, as often as it is stiffer, on a pace that is known sooner.
    double fastDampingNSPerM = 30.0;
    double brakeN = 0.5;    ///< most that passivity control takes out of fast motion; 0 is none
    double friction = 0.1;  ///< Coulomb coefficient of the bur sliding on the tooth
    /// Of the force along x and y, for a device whose arms are weaker sideways, and of that along z. Equal gains are a
    /// softer spring. Unequal ones tilt the force on a slope, so that it is no longer that of any spring: a circle into
    /// a 45 degree plane and out again, 0.3 mm wide, gives 0.07 mJ for a difference of one half. So both are shipped
    /// at 1.
    double lateralGain = 1.0;
    double verticalGain = 1.0;
    double clampN = 8.0;  ///< largest force ever given to the hand
    /// Radius of the ball about the tooth's origin that the device moves in, mm; 0: it has no end, as a mouse has none
    /// (WorkArea).
    double workAreaMm = 0.0;
    double vibrationN = 0.0;  ///< rms of what a bur that runs free is felt by (BurVibration); 0: nothing
    /// Fastest change of force; below 1000 the filter itself destabilises (docs/facts/haptics.md, section 2.3). A
    /// spring stiffer than 2.5 N/mm may change its force faster in proportion: it is the pace of the hand that is
    /// limited.
    double slewNPerS = 2000.0;
    bool operator==(const ForceSettings&) const = default;
};

/// OutOfRange naming the first setting outside its limits.
[[nodiscard]] Status check(const ForceSettings& settings);

/// Virtual coupling from the hand to the anchor (Colgate 1995; Adams & Hannaford 1999): spring and damper, friction,
/// passivity control, clamp, slew limit. Servo thread; no allocation.
class ForceLaw
{
public:
    explicit ForceLaw(const ForceSettings& settings) noexcept : m_settings(settings) {}

    /// Force on the hand for this tick, newtons, tooth frame.
    glm::dvec3 update(const glm::dvec3& device, const glm::dvec3& anchor, double seconds) noexcept;

    /// Forgets everything and begins at zero: what begins in the air begins softly by itself.
    void restart() noexcept;
    /// The device is lost: zero at once. When it comes back the force rises from zero over kReturnS, whether it is in
    /// contact by then or not.
    void drop() noexcept;

    /// Other settings from now on. What that changes of the force comes no faster than the slew limit lets it.
    void setSettings(const ForceSettings& settings) noexcept { m_settings = settings; }
    /// The spring from now on as this share of the settings, 0 to 1: the loop has become slower.
    void setShare(double share) noexcept { m_share = share; }
    /// What the spring alone gives to the hand when it is stretched so far, N: what a bur presses with that cuts. As
    /// the force rises after drop(), so does this: nothing is cut by a force that is not felt.
    [[nodiscard]] double springN(const glm::dvec3& stretchMm) const noexcept;

    /// True if the last force was cut down to the clamp.
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
    /// Of the spring as it is now, N/mm.
    [[nodiscard]] double stiffnessNPerMm() const noexcept { return m_share * m_settings.stiffnessNPerMm; }
    [[nodiscard]] glm::dvec3 gain() const noexcept;
    [[nodiscard]] double timesStiff() const noexcept;
    [[nodiscard]] glm::dvec3 brake(const glm::dvec3& pace, double springMj, double seconds) noexcept;

    ForceSettings m_settings;
    glm::dvec3 m_forceN{0.0};
    /// Where the spring ends: the anchor, but for its jumps.
    glm::dvec3 m_held{0.0};
    /// Where the bur sticks to the surface: trails it inside the friction cone, so that friction costs neither delay
    /// nor velocity noise (Harwin & Melder 2002). The anchor itself stays where the geometry puts it.
    glm::dvec3 m_stuck{0.0};
    glm::dvec3 m_device{0.0};
    VelocityEstimator m_stretching;
    VelocityEstimator m_moving;  ///< of the device
    VelocityEstimator m_length;  ///< of the spring from the hand to the held end, as x
    glm::dvec3 m_pace{0.0};      ///< handsPace() of the last tick
    double m_lengthening = 0.0;  ///< of the spring by the hand in the last tick, mm/s
    glm::dvec3 m_acrossN{0.0};   ///< what the damper gives across the spring
    double m_takenMj = 0.0;      ///< what the hand has put into the spring and not yet got back
    double m_share = 1.0;
    double m_return = 1.0;  ///< 0 after drop(), rising to 1
    bool m_begins = true;   ///< nothing is known of the tick before
    bool m_touched = false;
    bool m_clamped = false;
};

}  // namespace core::contact
