// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/ForceLaw.h"
#include "haptics/falcon/Kinematics.h"

namespace haptics::falcon {

/// Radius of the work area: soft walls begin 5 mm before the arms may reach their stops.
inline constexpr double kWorkAreaMm = kReachMm - 5.0;

/// Sets the properties that only a device in a hand has in a force law: the Falcon's work area, and the vibration of
/// the bur (0.03 to 0.08 N). A mouse has neither.
/// @param scale  movement of the hand per movement of the bur (DeviceSetup)
inline void addFalconFeel(core::contact::ForceSettings& force, double scale = 1.0)
{
    force.workAreaMm = kWorkAreaMm / scale;
    force.vibrationN = 0.05;
}

}  // namespace haptics::falcon
