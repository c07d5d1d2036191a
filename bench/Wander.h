// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "core/servo/ServoState.h"

namespace bench {

/// Returns strokes that cover the whole crown: a slow figure of eight in a slowly turning direction, with 1 N.
[[nodiscard]] inline core::servo::PointerInput wander(double seconds, double radiusMm)
{
    core::servo::PointerInput want;
    const double stroke = radiusMm * std::sin(2.0 * std::numbers::pi * 0.8 * seconds);
    const double drift = 0.5 * radiusMm * std::sin(2.0 * std::numbers::pi * 0.031 * seconds);
    const double turn = 2.0 * std::numbers::pi * 0.013 * seconds;
    want.targetMm = {stroke * std::cos(turn) - drift * std::sin(turn),
                     stroke * std::sin(turn) + drift * std::cos(turn)};
    want.pushing = true;
    want.pushForceN = 1.0;
    return want;
}

}  // namespace bench
