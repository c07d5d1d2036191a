// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstdint>
#include <string_view>

namespace core::recording {

inline constexpr std::uint64_t kExamNote = 0x4558ULL << 48U;
inline constexpr std::size_t kExamNoteDigits = 12;

/// Returns the note (session::AddNote) that the start of an exam was reported: "EX" and the first 48 bits of the uid of
/// the start.
/// @param startUid  hex digits
[[nodiscard]] inline std::uint64_t examNote(std::string_view startUid) noexcept
{
    std::uint64_t bits = 0;
    const std::string_view digits = startUid.substr(0, kExamNoteDigits);
    std::from_chars(digits.data(), digits.data() + digits.size(), bits, 16);
    return kExamNote | bits;
}

[[nodiscard]] constexpr bool isExamNote(std::uint64_t note) noexcept
{
    return (note >> 48U) == (kExamNote >> 48U);
}

}  // namespace core::recording
