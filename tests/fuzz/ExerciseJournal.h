// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace fuzz {

/// Reads the bytes as the journal of an attempt; what comes out is saved, read and replayed as a recording
/// (exerciseRecording), and its moments are found again if it is short. Aborts when a promise is broken.
void exerciseJournal(std::string_view bytes);

/// Mends the checksums of a journal whose frames a fuzzer has changed.
[[nodiscard]] std::string journalWithChecksums(std::string_view bytes);

}  // namespace fuzz
