// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ui/sound/AudioPort.h"

namespace ui::sound {

/// The audio outputs that Qt Multimedia finds. The samples are read in the thread that calls this, which needs an event
/// loop.
[[nodiscard]] std::unique_ptr<AudioPort> qtAudioPort();

}  // namespace ui::sound
