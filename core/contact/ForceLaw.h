// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/base/Result.h"

namespace core::contact {

/// What turns the distance between hand and anchor into a force.
struct ForceSettings
{
    double stiffnessNPerMm =
        2.0;                    ///< one for the whole tooth: hardness acts on removal (haptics.md 3, virtual coupling)
    double friction = 0.1;      ///< Coulomb coefficient of the bur sliding on the tooth
    double clampN = 8.0;        ///< largest force ever given to the hand
    double slewNPerS = 2000.0;  ///< fastest change of force; below 1000 the filter itself destabilises (haptics.md 2.3)
    bool operator==(const ForceSettings&) const = default;
};

/// OutOfRange naming the first setting outside its limits.
[[nodiscard]] Status check(const ForceSettings& settings);

/// Spring from the hand to the anchor, friction, clamp, slew limit. Servo thread; no allocation.
class ForceLaw
{
public:
    explicit ForceLaw(const ForceSettings& settings) noexcept : m_settings(settings) {}

    /// Force on the hand for this tick, newtons, tooth frame.
    glm::dvec3 update(const glm::dvec3& device, const glm::dvec3& anchor, double seconds) noexcept;

    /// The device is lost: zero at once, and the next force starts from zero.
    void drop() noexcept;

    /// True if the last force was cut down to the clamp.
    [[nodiscard]] bool clamped() const noexcept { return m_clamped; }
    [[nodiscard]] const ForceSettings& settings() const noexcept { return m_settings; }

private:
    ForceSettings m_settings;
    glm::dvec3 m_forceN{0.0};
    /// Where the bur sticks to the surface: trails the anchor inside the friction cone, so that friction costs neither
    /// delay nor velocity noise (Harwin & Melder 2002). The anchor itself stays where the geometry puts it.
    glm::dvec3 m_stuck{0.0};
    bool m_touched = false;
    bool m_clamped = false;
};

}  // namespace core::contact
