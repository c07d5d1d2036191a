// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

namespace core::audio {

/// Returns the bytes of a WAV file with one channel of 16 bits (RIFF, PCM: Microsoft and IBM, Multimedia Programming
/// Interface and Data Specifications 1.0, 1991).
/// @param samples  from -1 to 1; at most 2^30 of them
[[nodiscard]] std::string waveFile(std::span<const float> samples, int rateHz);

}  // namespace core::audio
