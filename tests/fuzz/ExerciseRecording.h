// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace fuzz {

/// Reads the bytes as a recording; replays what comes out if it is short. Aborts when a promise of the reader or of the
/// replay is broken: a force that is not finite or above the clamp, material that grows, bytes that do not read back.
void exerciseRecording(std::string_view bytes);

/// Mends the checksums of a recording whose sections a fuzzer has changed, so that it gets past them to the readers
/// behind. The rest stays as it is.
[[nodiscard]] std::string withChecksums(std::string_view bytes);

/// A recording with its sections unpacked, so that a fuzzer can change what is in them; and back.
[[nodiscard]] std::string unpacked(std::string_view bytes);
[[nodiscard]] std::string packed(std::string_view bytes);

}  // namespace fuzz
