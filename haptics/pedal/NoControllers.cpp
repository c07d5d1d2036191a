// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces SdlPort.cpp if SDL 2 is not installed.
#include "haptics/pedal/ControllerPort.h"

namespace haptics {

bool hasControllers() noexcept
{
    return false;
}

core::Result<std::unique_ptr<ControllerPort>> openControllerPort()
{
    return core::unexpected(
        core::ErrorCode::FileUnreadable,
        core::LocalizableText{"This program was built without SDL 2: pedals and gamepads are left out."});
}

}  // namespace haptics
