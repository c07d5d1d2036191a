// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/settings/FeelPreset.h"

namespace core::settings {

/// What stands at the other end of the spring: a device in a hand. A simulated Falcon in a light hand, which
/// damps least and is the hardest to keep still (docs/facts/haptics.md, sections 5 and 6). Drilling only damps (section
/// 8.2), so the wall without a cut is the worst case.
struct LoopFigures
{
    double massKg = 0.27;        ///< device and hand
    double viscousNSPerM = 1.3;  ///< device and hand
    double coulombN = 0.25;      ///< dry friction of the device
    double motorLagS = 0.001;
    double delayS = 0.002;     ///< beyond it the servo loop softens the spring by itself
    double countMm = 0.048;    ///< step of the encoders at the centre
    double forceLimitN = 8.9;  ///< the most that the device can give
};

/// The most that a loop holds, and what sets the limit.
struct StabilityBound
{
    enum class Set {
        Damping,   ///< what is fed by sampling and delay outruns friction and dampers: an impact is not held
        Lateness,  ///< a damper that comes so late holds no more, however strong
        Buzz       ///< dry friction does not hold a count of the encoders any longer
    };
    double stiffnessNPerMm = 0.0;
    Set set = Set::Damping;
};

/// Up to which stiffness a preset's dampers hold the bur on the tooth.
///
/// Damping: `K < 0.598 (b + B(v) + fc / v) / t`, `t = T/2 + delay + lag`, at v = 50 mm/s, with `B(v) = B + Bf v² / (v²
/// + v0²)` (Gil 2009, docs/facts/haptics.md, section 2.1; 0.598 is what a unilateral wall is short of it by). Lateness:
/// `K < 0.27 m / t²`. Buzz: `K < 2 fc / D` (Abbott & Okamura 2005). The factors are the least of what
/// lab::stiffnessLimit measures of this force law over the whole range of both dampers (tests/lab/tst_stability_bound).
/// @param periodS  of the servo
[[nodiscard]] StabilityBound stabilityBound(const FeelPreset& preset, const LoopFigures& loop = {},
                                            double periodS = 0.001);

/// Whether the loop holds a preset, and the device can give its force limit; the sentence names value and bound. Its
/// numbers are checked first (check()).
[[nodiscard]] Status checkStability(const FeelPreset& preset, const LoopFigures& loop = {}, double periodS = 0.001);

}  // namespace core::settings
