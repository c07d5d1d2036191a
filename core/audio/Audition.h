// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/audio/SoundState.h"

namespace core::audio {

/// Length of the sample that a user can play, s.
inline constexpr double kAuditionS = 5.0;

/// Returns the state of the sample: the turbine runs up, cuts enamel, then dentin, and runs down.
/// @param seconds  since the start of the sample
[[nodiscard]] SoundState auditionAt(double seconds) noexcept;

}  // namespace core::audio
