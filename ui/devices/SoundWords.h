// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/devices/DeviceWords.h"
#include "ui/sound/SoundSettings.h"

/// States of sound in the user's language.
namespace ui::devices {

[[nodiscard]] Sign signOf(const sound::SoundReport& report);
/// "Plays on the headphones."
[[nodiscard]] QString stateWords(const sound::SoundReport& report);
/// What to do about the state, one or two sentences.
[[nodiscard]] QString helpWords(const sound::SoundReport& report);

}  // namespace ui::devices
