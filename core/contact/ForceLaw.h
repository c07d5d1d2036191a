// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/base/Result.h"

namespace core::contact {

/// What turns the distance between hand and anchor into a force.
struct ForceSettings
{
    /// Spring of the virtual coupling, one for the whole tooth: hardness acts on removal (haptics.md 3).
    double stiffnessNPerMm = 2.0;
    /// Its damper, on the speed at which it is stretched. Every millisecond of delay halves what it may be at most;
    /// 5 N s/m is the middle of what haptics.md 2.2 found to help.
    double dampingNSPerM = 5.0;
    double brakeN = 1.0;        ///< most that passivity control takes out of the hand's motion; 0 is none
    double friction = 0.1;      ///< Coulomb coefficient of the bur sliding on the tooth
    double lateralGain = 1.0;   ///< of the force along x and y: arms are weaker sideways
    double verticalGain = 1.0;  ///< of the force along z
    double clampN = 8.0;        ///< largest force ever given to the hand
    double slewNPerS = 2000.0;  ///< fastest change of force; below 1000 the filter itself destabilises (haptics.md 2.3)
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

    /// The device is lost: zero at once. If it comes back in contact, the force rises from zero over kReturnS.
    void drop() noexcept;

    /// The spring from now on as this share of the settings, 0 to 1: the loop has become slower.
    void setShare(double share) noexcept { m_share = share; }
    /// Of the spring as it is now, N/mm.
    [[nodiscard]] double stiffnessNPerMm() const noexcept { return m_share * m_settings.stiffnessNPerMm; }

    /// True if the last force was cut down to the clamp.
    [[nodiscard]] bool clamped() const noexcept { return m_clamped; }
    [[nodiscard]] const ForceSettings& settings() const noexcept { return m_settings; }

    static constexpr double kReturnS = 0.2;

private:
    [[nodiscard]] glm::dvec3 damped(const glm::dvec3& stretch, double seconds) noexcept;
    [[nodiscard]] glm::dvec3 braked(const glm::dvec3& wanted, const glm::dvec3& moved, double springMj,
                                    double seconds) noexcept;

    ForceSettings m_settings;
    glm::dvec3 m_forceN{0.0};
    /// Where the bur sticks to the surface: trails the anchor inside the friction cone, so that friction costs neither
    /// delay nor velocity noise (Harwin & Melder 2002). The anchor itself stays where the geometry puts it.
    glm::dvec3 m_stuck{0.0};
    glm::dvec3 m_device{0.0};
    glm::dvec3 m_stretch{0.0};   ///< of the spring, mm
    glm::dvec3 m_pace{0.0};      ///< at which it is stretched, mm/s, through one pole
    glm::dvec3 m_calmPace{0.0};  ///< through both
    double m_takenMj = 0.0;      ///< what the hand has put into the spring and not yet got back
    double m_share = 1.0;
    double m_return = 0.0;  ///< 0 after drop(), rising to 1
    bool m_touched = false;
    bool m_clamped = false;
};

}  // namespace core::contact
