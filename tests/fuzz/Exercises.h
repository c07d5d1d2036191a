// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <string>
#include <string_view>

/// What a fuzz target does with its input, for the target and for the unit test that runs its corpus. Each reads the
/// bytes as they are, and again with what a fuzzer cannot guess put right: checksums, sizes, packing. It aborts where a
/// promise is broken.
namespace fuzz {

inline void promise(bool kept)
{
    if (!kept)
        std::abort();
}

/// A captured ideal; shows it and marks by it.
void exerciseIdeal(std::string_view bytes);
/// Its packed part unpacked, as a seed.
[[nodiscard]] std::string unpackedIdeal(std::string_view bytes);

/// The journal of an attempt. What comes out is saved, read and replayed as a recording, and its moments are found
/// again if it is short.
void exerciseJournal(std::string_view bytes);

/// A lesson that stands on its own.
void exerciseLesson(std::string_view bytes);
/// A pack of lessons, and what is in it as lessons.
void exercisePack(std::string_view bytes);

/// Each mesh format in turn. Takes what comes out through analysis, placement, patching and rasterising: no index is
/// out of range, every number is finite.
void exerciseMesh(std::string_view bytes);

/// A device path, which is walked: times rise, positions are finite and near, an error is a sentence.
void exercisePath(std::string_view bytes);

/// A recording, which is replayed if it is short: no force is above the clamp, no material grows, bytes read back.
void exerciseRecording(std::string_view bytes);
/// The bytes as they are alone.
void playRecording(std::string_view bytes);
/// Its sections unpacked, as a seed.
[[nodiscard]] std::string unpacked(std::string_view bytes);

}  // namespace fuzz
