// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sound/SoundSettings.h"

/// The settings of sound, as they are stored from run to run.
namespace app {

/// A stored value that is out of its range counts as the default.
[[nodiscard]] ui::sound::SoundSettings storedSound();
void storeSound(const ui::sound::SoundSettings& settings);

}  // namespace app
