// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sound/SoundSettings.h"

/// Saves the settings of sound on this computer.
namespace app {

/// Returns the stored settings. A stored value out of range is replaced by the default value.
[[nodiscard]] ui::sound::SoundSettings storedSound();
void storeSound(const ui::sound::SoundSettings& settings);

}  // namespace app
