// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/settings/FeelPreset.h"

namespace core::settings {

/// The other end of the spring: a device in a hand. A simulated Falcon in a light hand, which has the least damping and
/// is the hardest to keep stable (docs/facts/haptics.md, sections 5 and 6). Drilling only adds damping (section 8.2),
/// so contact without cutting is the worst case.
struct LoopFigures
{
    double massKg = 0.27;        ///< device and hand
    double viscousNSPerM = 1.3;  ///< device and hand
    double coulombN = 0.25;      ///< dry friction of the device
    double motorLagS = 0.001;
    double delayS = 0.002;     ///< beyond it the servo loop reduces the stiffness by itself
    double countMm = 0.048;    ///< step of the encoders at the centre
    double forceLimitN = 8.9;  ///< the largest force of the device
};

/// The largest stiffness that is stable, and its cause.
struct StabilityBound
{
    enum class Set {
        Damping,   ///< sampling and delay add more energy than friction and dampers remove: an impact is not absorbed
        Lateness,  ///< a damper with this delay cannot stabilise more, however strong
        Buzz       ///< dry friction no longer absorbs an encoder count
    };
    double stiffnessNPerMm = 0.0;
    Set set = Set::Damping;
};

/// Returns the largest stiffness at which a preset's dampers keep the bur stable on the tooth.
///
/// Damping: `K < 0.598 (b + B(v) + fc / v) / t`, `t = T/2 + delay + lag`, at v = 50 mm/s, with `B(v) = B + Bf v² / (v²
/// + v0²)` (Gil 2009, docs/facts/haptics.md, section 2.1; 0.598 is the factor of a unilateral wall). Lateness: `K <
/// 0.27 m / t²`. Buzz: `K < 2 fc / D` (Abbott & Okamura 2005). The factors are the smallest that lab::stiffnessLimit
/// measures for this force law over the whole range of both dampers (tests/lab/tst_stability_bound).
/// @param periodS  of the servo
[[nodiscard]] StabilityBound stabilityBound(const FeelPreset& preset, const LoopFigures& loop = {},
                                            double periodS = 0.001);

/// Checks whether the loop is stable with a preset, and the device can give its force limit; the error names value and
/// bound. Checks its numbers first (check()).
[[nodiscard]] Status checkStability(const FeelPreset& preset, const LoopFigures& loop = {}, double periodS = 0.001);

}  // namespace core::settings
