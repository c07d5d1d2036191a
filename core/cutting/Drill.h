// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include <glm/vec3.hpp>

#include "core/contact/LiveTooth.h"
#include "core/settings/Handpiece.h"
#include "core/settings/HardnessPreset.h"

namespace core::cutting {

/// Tangential over normal force of a bur that cuts: 0.24 to 1.77 N over 0.60 to 2.93 N in glass ceramic
/// (docs/facts/haptics.md, section 8.5).
inline constexpr double kCuttingFriction = 0.4;

/// Speed of the surface for which the rates of a preset hold, in rpm mm of radius: a 330 in the turbine that is pressed
/// with 1 N, 11.5 m/s. Rates are proportional to it (Preston's law).
inline constexpr double kReferenceRpmMm = 320'000.0 * (1.0 - kCuttingFriction * 0.4 / 1.1) * 0.4;

/// Rectangle of columns, both ends inside; empty while i1 < i0.
struct CutRect
{
    int i0 = 0;
    int j0 = 0;
    int i1 = -1;
    int j1 = -1;
    [[nodiscard]] bool isEmpty() const { return i1 < i0; }
};

/// Returns the pace at which a bur takes away a material, mm3/s (see Drill).
/// @param preset     only its full load counts here
/// @param direction  share of the rate that is left for the direction of the push, 0 to 1
/// @param speedAt    speed of the bur's surface under a load of so many newtons, over the reference
template <class Speed>
[[nodiscard]] double paceMm3PerS(const settings::HardnessPreset& preset, const settings::MaterialHardness& hardness,
                                 double forceN, double direction, const Speed& speedAt) noexcept
{
    const auto under = [&](double newtons) {
        return hardness.rateMm3PerNs * std::max(0.0, newtons - hardness.thresholdN) * direction * speedAt(newtons);
    };
    const bool isBeyond = forceN > preset.fullLoadN && preset.fullLoadN < settings::kNoFullLoadN;
    return isBeyond ? std::min(under(preset.fullLoadN), under(forceN)) : under(forceN);
}

/// What one tick took away.
struct Cut
{
    glm::dvec3 tipMm{0.0};  ///< where the bur has got to
    terrain::PerMaterial removedMm3{};
    CutRect changed;  ///< columns that were lowered
};

/// Removes material under the bur, paced by volume (docs/facts/haptics.md, section 8.1).
///
/// A tick grants dt seconds. Material m comes away at rate_m = S_m * max(0, F - F0_m) * direction * speed mm3/s, with
/// the speed of the bur's surface over the reference: the load F brakes it, until it stalls. A load beyond the full
/// load of the preset removes no more than that load does. So lowering the columns under the bur by volumes V_m takes
/// sum V_m / rate_m seconds; the bur advances from the anchor towards the device just as far as the granted time
/// reaches. Every column goes down by a real amount: no timer, no all-or-nothing cell, and the pace depends neither on
/// the grid nor on the tick rate. A touch that is short and light is a brush and cuts nothing.
///
/// Servo thread: no allocation, no lock, cost bounded by the bur's footprint. Heights only ever go down.
class Drill
{
public:
    Drill(const settings::HardnessPreset& preset, const settings::Handpiece& handpiece) noexcept;

    /// Another one from now on. Its name stays behind: nothing is allocated.
    void setHandpiece(const settings::Handpiece& handpiece) noexcept
    {
        m_handpiece.freeRpm = handpiece.freeRpm;
        m_handpiece.stallTorqueNmm = handpiece.stallTorqueNmm;
        rest();
    }

    /// Other figures of hardness from now on. The name stays behind: nothing is allocated.
    void setHardness(const settings::HardnessPreset& preset) noexcept { m_preset.takeFigures(preset); }

    /// Sets the share of its full speed, 0 to 1, at which the bur turns from now on: what a pedal asks for.
    void setSpeedShare(double share) noexcept { m_speedShare = share; }

    /// Cuts for `seconds` with the bur's tip at `anchor`, drawn towards `device` with `forceN` newtons.
    Cut cut(contact::LiveTooth& tooth, const glm::dvec3& anchor, const glm::dvec3& device, double forceN,
            double seconds) noexcept;

    /// Turns a minute of a bur of this radius that is pressed with `forceN`.
    [[nodiscard]] double rpmUnder(double forceN, double radiusMm) const noexcept
    {
        return m_speedShare * m_handpiece.rpmUnder(kCuttingFriction * forceN * radiusMm);
    }

    /// The bur has left the material: time left over is forgotten, and that it was more than a brush.
    void rest() noexcept
    {
        m_leftS = 0.0;
        m_lastMmPerS = 0.0;
        m_pressedNS = 0.0;
    }

private:
    [[nodiscard]] contact::RemovalTimes removalTimes(const contact::LiveTooth& tooth, const glm::dvec3& towards,
                                                     double forceN) const noexcept;

    settings::HardnessPreset m_preset;
    settings::Handpiece m_handpiece;
    double m_speedShare = 1.0;
    double m_leftS = 0.0;       ///< time granted and not used, at most one tick's
    double m_lastMmPerS = 0.0;  ///< advance that the last tick's time was spent on
    double m_pressedNS = 0.0;   ///< impulse of this touch, as far as it counts
};

}  // namespace core::cutting
