// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <string>
#include <string_view>

/// The functions that fuzz targets run on their input. Unit tests run them on the corpus. Each reads the bytes
/// unchanged, and again after correcting the parts that a fuzzer cannot guess: checksums, sizes, packing. It aborts if
/// a guarantee is broken.
namespace fuzz {

inline void promise(bool kept)
{
    if (!kept)
        std::abort();
}

/// Reads a captured ideal, shows it and grades with it.
void exerciseIdeal(std::string_view bytes);
/// Returns the bytes with the packed part unpacked, as a seed.
[[nodiscard]] std::string unpackedIdeal(std::string_view bytes);

/// Reads the journal of an attempt. The result is saved, read and replayed as a recording, and its moments are found
/// again if it is short.
void exerciseJournal(std::string_view bytes);

/// Reads a lesson that is based on no other file.
void exerciseLesson(std::string_view bytes);
/// Reads a pack of lessons, and its content as lessons.
void exercisePack(std::string_view bytes);

/// Reads the bytes as a file of the outbox, and as the content of one that the station has signed: an attempt that is
/// accepted has texts that every database stores as they are.
void exerciseLetter(std::string_view bytes);

/// Reads the bytes in each mesh format. The result goes through analysis, placement, patching and rasterising: no index
/// is out of range, and every number is finite.
void exerciseMesh(std::string_view bytes);

/// Reads and walks a device path: times rise, positions are finite and near, and an error is a sentence.
void exercisePath(std::string_view bytes);

/// Reads a recording, and replays it if it is short: no force is above the limit, no material grows, and the bytes read
/// back.
void exerciseRecording(std::string_view bytes);
/// Reads and replays a recording likewise, but only with the bytes unchanged.
void playRecording(std::string_view bytes);
/// Returns the bytes with the sections unpacked, as a seed.
[[nodiscard]] std::string unpacked(std::string_view bytes);

}  // namespace fuzz
