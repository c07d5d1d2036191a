// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ui/sound/AudioPort.h"

namespace ui::sound {

/// Returns the audio outputs that Qt Multimedia finds. Samples are read in the thread that calls this function, which
/// needs an event loop.
[[nodiscard]] std::unique_ptr<AudioPort> qtAudioPort();

}  // namespace ui::sound
