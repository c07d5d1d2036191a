// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>

/// Notes (session::AddNote) that tell where a recording comes from. The school compares them with the attempt.
namespace core::recording {

inline constexpr std::uint64_t kExamNote = 0x4558ULL << 48U;
inline constexpr std::uint64_t kPersonNote = 0x5045ULL << 48U;
inline constexpr std::size_t kOriginDigits = 12;

/// Returns the first 48 bits of a uid, hex digits.
[[nodiscard]] inline std::uint64_t originBits(std::string_view uid) noexcept
{
    std::uint64_t bits = 0;
    const std::string_view digits = uid.substr(0, kOriginDigits);
    std::from_chars(digits.data(), digits.data() + digits.size(), bits, 16);
    return bits;
}

/// Returns the note that the start of an exam was reported: "EX" and the first 48 bits of the uid of the start.
[[nodiscard]] inline std::uint64_t examNote(std::string_view startUid) noexcept
{
    return kExamNote | originBits(startUid);
}

/// Returns the note that says whose attempt it is: "PE" and the first 48 bits of the person's uid. An attempt of a
/// guest or of the simulated hand has no such note.
[[nodiscard]] inline std::uint64_t personNote(std::string_view personUid) noexcept
{
    return kPersonNote | originBits(personUid);
}

[[nodiscard]] constexpr bool isExamNote(std::uint64_t note) noexcept
{
    return (note >> 48U) == (kExamNote >> 48U);
}

[[nodiscard]] constexpr bool isPersonNote(std::uint64_t note) noexcept
{
    return (note >> 48U) == (kPersonNote >> 48U);
}

}  // namespace core::recording
