// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/servo/ServoTick.h"
#include "haptics/falcon/FalconFeel.h"

namespace app {

/// Returns the settings of a servo for the hand that moves the bur.
/// @param hasForce  whether the hand feels a force
/// @param scale     distance in millimetres that the hand moves for one millimetre of the bur
[[nodiscard]] inline core::servo::ServoSettings settingsFor(bool hasForce, double scale = 1.0)
{
    core::servo::ServoSettings settings;
    if (hasForce)
        haptics::falcon::addFalconFeel(settings.force, scale);
    return settings;
}

}  // namespace app
