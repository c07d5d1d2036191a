// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "core/contact/LiveTooth.h"
#include "core/settings/HardnessPreset.h"

namespace core::drilling {

/// Rectangle of columns, both ends inside; empty while i1 < i0.
struct CutRect
{
    int i0 = 0;
    int j0 = 0;
    int i1 = -1;
    int j1 = -1;
    [[nodiscard]] bool isEmpty() const { return i1 < i0; }
};

/// What one tick took away.
struct Cut
{
    glm::dvec3 tipMm{0.0};  ///< where the bur has got to
    terrain::PerMaterial removedMm3{};
    CutRect changed;  ///< columns that were lowered
};

/// Removes material under the bur, paced by volume (design section 3).
///
/// A tick grants dt seconds. Material m comes away at rate_m = S_m * max(0, F - F0_m) * direction mm3/s, so lowering
/// the columns under the bur by volumes V_m takes sum V_m / rate_m seconds; the bur advances from the anchor towards
/// the device just as far as the granted time reaches. Every column goes down by a real amount: no timer, no
/// all-or-nothing cell, and the pace depends neither on the grid nor on the tick rate. A touch that is short and light
/// is a brush and cuts nothing.
///
/// Servo thread: no allocation, no lock, cost bounded by the bur's footprint. Heights only ever go down.
class Drill
{
public:
    explicit Drill(const settings::HardnessPreset& preset) noexcept;

    /// Cuts for `seconds` with the bur's tip at `anchor`, drawn towards `device` with `forceN` newtons.
    Cut cut(contact::LiveTooth& tooth, const glm::dvec3& anchor, const glm::dvec3& device, double forceN,
            double seconds) noexcept;

    /// The bur has left the material: time left over is forgotten, and that it was more than a brush.
    void rest() noexcept
    {
        m_leftS = 0.0;
        m_lastAdvance = 0.0;
        m_pressedNS = 0.0;
    }

private:
    settings::HardnessPreset m_preset;
    double m_leftS = 0.0;  ///< time granted and not used, at most one tick's
    double m_lastAdvance = 0.0;
    double m_pressedNS = 0.0;  ///< impulse of this touch, as far as it counts
};

}  // namespace core::drilling
