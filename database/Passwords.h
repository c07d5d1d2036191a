// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/Result.h"

/// Argon2id by libsodium. A hash takes a fraction of a second and tens of megabytes on purpose: keep it off the ui
/// thread. Any thread.
namespace database {

/// What a hash costs. The default is libsodium's INTERACTIVE, above OWASP's minimum of 19 MiB and 2 passes.
struct PasswordCost
{
    unsigned long long passes = 2;
    std::size_t memoryBytes = std::size_t{64} << 20U;
    bool operator==(const PasswordCost&) const = default;
};

/// No school asks for more, and no hash is worked out that does: who may write the database must not keep everybody at
/// the door.
inline constexpr unsigned long long kMostPasses = 16;
inline constexpr std::size_t kMostMemoryBytes = std::size_t{1} << 30U;

/// The dearest cost that this computer pays within `goalMs` of thread time: 64 MiB, and passes from 2 to 16.
[[nodiscard]] PasswordCost timedCost(double goalMs = 350.0);

inline constexpr int kShortestPassword = 8;
inline constexpr int kLongestPassword = 256;  ///< bytes of UTF-8: hashing a novel would keep the station busy

/// OutOfRange with a sentence: too short, too long, the user's own name with or without more, or what is tried first: a
/// common word with digits around it, keys in a row, three characters again and again.
[[nodiscard]] core::Status checkPassword(const std::string& password, const std::string& username);

/// "$argon2id$v=19$m=65536,t=2,p=1$salt$hash". FileTooLarge when there is no memory for it.
[[nodiscard]] core::Result<std::string> hashPassword(const std::string& password, const PasswordCost& cost);
/// FileTooLarge when there is no memory for it: then nobody knows whether it fits. None fits what isPasswordHash() is
/// not of.
[[nodiscard]] core::Result<bool> fits(const std::string& password, const std::string& hash);
/// Whether it is one that hashPassword() has made, or could have: no password fits another.
[[nodiscard]] bool isPasswordHash(const std::string& hash);
/// Made at a lower cost, in passes or memory, and at a higher one in neither.
[[nodiscard]] bool wantsRehash(const std::string& hash, const PasswordCost& cost);

/// Twelve letters and digits that are not mistaken for each other, in groups of four: "K7QM-2XHP-9RTB".
[[nodiscard]] std::string newCode();
/// What is kept of a person's code. A code is 59 bits of chance and lives for days, so that a quick hash is enough.
[[nodiscard]] std::string hashOfCode(const std::string& uid, const std::string& code);
inline constexpr std::size_t kUidLength = 32;
/// So many hex digits that nobody else has.
[[nodiscard]] std::string newUid();
/// Of what may be told twice, by what is its own: always the same.
[[nodiscard]] std::string uidOf(std::string_view identity);
/// BLAKE2b-256, 64 hex digits.
[[nodiscard]] std::string digestOf(std::string_view bytes);

}  // namespace database
