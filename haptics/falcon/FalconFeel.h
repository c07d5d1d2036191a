// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/ForceLaw.h"
#include "haptics/falcon/Kinematics.h"

namespace haptics::falcon {

/// Soft walls begin 5 mm before the arms may come to their stops.
inline constexpr double kWorkAreaMm = kReachMm - 5.0;

/// Gives a force law what only a device in a hand has: the Falcon's work area, and a bur that is felt running
/// (0.03 to 0.08 N). A mouse has neither.
/// @param scale  how far the hand moves for one millimetre of the bur (DeviceSetup)
inline void addFalconFeel(core::contact::ForceSettings& force, double scale = 1.0)
{
    force.workAreaMm = kWorkAreaMm / scale;
    force.vibrationN = 0.05;
}

}  // namespace haptics::falcon
