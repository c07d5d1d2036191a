// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/devices/DeviceWords.h"
#include "ui/sound/SoundSettings.h"

/// Texts about sound in the user's language.
namespace ui::devices {

[[nodiscard]] Sign signOf(const sound::SoundReport& report);
/// Returns a sentence on the state, such as "Plays on the headphones."
[[nodiscard]] QString stateWords(const sound::SoundReport& report);
/// Returns one or two sentences on what to do in this state.
[[nodiscard]] QString helpWords(const sound::SoundReport& report);

}  // namespace ui::devices
