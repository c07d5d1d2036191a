// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include <glm/vec3.hpp>

#include "core/contact/LiveTooth.h"
#include "core/settings/Handpiece.h"
#include "core/settings/HardnessPreset.h"

namespace core::cutting {

/// Ratio of tangential to normal force of a cutting bur: 0.24 to 1.77 N over 0.60 to 2.93 N in glass ceramic
/// (docs/facts/haptics.md, section 8.5).
inline constexpr double kCuttingFriction = 0.4;

/// Surface speed to which the rates of a preset refer, in rpm times mm of radius: a 330 in the turbine pressed with 1
/// N, 11.5 m/s. Rates are proportional to it (Preston's law).
inline constexpr double kReferenceRpmMm = 320'000.0 * (1.0 - kCuttingFriction * 0.4 / 1.1) * 0.4;

/// Rectangle of columns, bounds included; empty if i1 < i0.
struct CutRect
{
    int i0 = 0;
    int j0 = 0;
    int i1 = -1;
    int j1 = -1;
    [[nodiscard]] bool isEmpty() const { return i1 < i0; }
};

/// Returns the removal rate of a bur in a material, mm3/s (see Drill).
/// @param preset     only its full load is used
/// @param direction  factor for the direction of the push, 0 to 1
/// @param speedAt    returns the speed of the bur's surface under a load in N, relative to the reference
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

/// The removal of one tick.
struct Cut
{
    glm::dvec3 tipMm{0.0};  ///< position that the bur has reached
    terrain::PerMaterial removedMm3{};
    CutRect changed;  ///< columns that were lowered
};

/// Removes material under the bur at a rate given by volume (docs/facts/haptics.md, section 8.1).
///
/// A tick grants dt seconds. Material m is removed at rate_m = S_m * max(0, F - F0_m) * direction * speed mm3/s, where
/// speed is that of the bur's surface relative to the reference: the load F brakes it, until it stalls. A load beyond
/// the full load of the preset removes no more than that load. So lowering the columns under the bur by volumes V_m
/// takes sum V_m / rate_m seconds; the bur advances from the anchor towards the device as far as the granted time
/// allows. Every column is lowered by a real amount: there is no timer and no all-or-nothing cell, and the rate depends
/// neither on the grid nor on the tick rate. A short and light touch is a brush and cuts nothing.
///
/// Servo thread: no allocation, no lock, cost bounded by the bur's footprint. Heights only ever go down.
class Drill
{
public:
    Drill(const settings::HardnessPreset& preset, const settings::Handpiece& handpiece) noexcept;

    /// Changes the handpiece, except its name: no allocation.
    void setHandpiece(const settings::Handpiece& handpiece) noexcept
    {
        m_handpiece.freeRpm = handpiece.freeRpm;
        m_handpiece.stallTorqueNmm = handpiece.stallTorqueNmm;
        rest();
    }

    /// Changes the numbers of the hardness, except the name: no allocation.
    void setHardness(const settings::HardnessPreset& preset) noexcept { m_preset.takeFigures(preset); }

    /// Sets the share of its full speed, 0 to 1, at which the bur turns, as a pedal requests it.
    void setSpeedShare(double share) noexcept { m_speedShare = share; }

    /// Cuts for `seconds` with the bur's tip at `anchor`, pulled towards `device` with `forceN` newtons.
    Cut cut(contact::LiveTooth& tooth, const glm::dvec3& anchor, const glm::dvec3& device, double forceN,
            double seconds) noexcept;

    /// Returns the turns per minute of a bur of this radius pressed with `forceN`.
    [[nodiscard]] double rpmUnder(double forceN, double radiusMm) const noexcept
    {
        return m_speedShare * m_handpiece.rpmUnder(kCuttingFriction * forceN * radiusMm);
    }

    /// Must be called when the bur has left the material: clears the remaining time and the impulse of the touch.
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
    double m_leftS = 0.0;       ///< granted and unused time, at most one tick's
    double m_lastMmPerS = 0.0;  ///< rate of advance in the last tick
    double m_pressedNS = 0.0;   ///< impulse of this touch, up to the limit of a brush
};

}  // namespace core::cutting
