// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/audio/SoundState.h"

namespace core::audio {

/// Length in seconds of the sample that a user can play.
inline constexpr double kAuditionS = 5.0;

/// The sample: the turbine runs up, cuts enamel, then dentin, and runs down.
/// @param seconds  since the sample began
[[nodiscard]] SoundState auditionAt(double seconds) noexcept;

}  // namespace core::audio
