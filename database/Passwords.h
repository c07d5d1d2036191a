// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/Result.h"

/// Password hashes by libsodium's Argon2id. A hash deliberately takes a fraction of a second and tens of megabytes.
/// Call these functions in any thread except the ui thread.
namespace database {

/// The cost of a hash. The default is libsodium's INTERACTIVE, above OWASP's minimum of 19 MiB and 2 passes.
struct PasswordCost
{
    unsigned long long passes = 2;
    std::size_t memoryBytes = std::size_t{64} << 20U;
    bool operator==(const PasswordCost&) const = default;
};

/// Limits of the cost. Hashes with a higher cost are not computed: otherwise a person with write access to the database
/// could block all logins.
inline constexpr unsigned long long kMostPasses = 16;
inline constexpr std::size_t kMostMemoryBytes = std::size_t{1} << 30U;

/// Returns the highest cost that this computer can compute within `goalMs` of thread time: 64 MiB, and 2 to 16 passes.
[[nodiscard]] PasswordCost timedCost(double goalMs = 350.0);

inline constexpr int kShortestPassword = 8;
inline constexpr int kLongestPassword = 256;  ///< bytes of UTF-8: hashing a longer password would take too long

/// Checks a new password. OutOfRange with one sentence: too short, too long, contains the username, or is easily
/// guessed (zxcvbn): a common word or password, dates, adjacent keys, repetitions, or some of them together.
[[nodiscard]] core::Status checkPassword(const std::string& password, const std::string& username);

/// Returns "$argon2id$v=19$m=65536,t=2,p=1$salt$hash". FileTooLarge if there is not enough memory.
[[nodiscard]] core::Result<std::string> hashPassword(const std::string& password, const PasswordCost& cost);
/// Returns the hash of a password with the cost and the salt of another hash.
/// @param salt  a hash up to and with its last "$"; OutOfRange if it is none
[[nodiscard]] core::Result<std::string> hashWithSalt(const std::string& password, const std::string& salt);
/// Returns whether a password matches a hash. Returns false if isPasswordHash() does. FileTooLarge if there is not
/// enough memory to compute the hash.
[[nodiscard]] core::Result<bool> fits(const std::string& password, const std::string& hash);
/// Returns whether a text has the form of a hash of hashPassword(). No password matches any other text.
[[nodiscard]] bool isPasswordHash(const std::string& hash);
/// Returns whether a hash has fewer passes or less memory than `cost`, and not more of either. True if it is no hash.
[[nodiscard]] bool wantsRehash(const std::string& hash, const PasswordCost& cost);

/// Returns twelve unambiguous letters and digits in groups of four: "K7QM-2XHP-9RTB".
[[nodiscard]] std::string newCode();
/// Returns the hash of a person's code for storage. A code is 59 random bits and valid for days, so that a fast hash is
/// enough.
[[nodiscard]] std::string hashOfCode(const std::string& uid, const std::string& code);
inline constexpr std::size_t kUidLength = 32;
/// Returns a random uid of kUidLength hex digits.
[[nodiscard]] std::string newUid();
/// Returns a uid derived from an identity. The same identity always gives the same uid.
[[nodiscard]] std::string uidOf(std::string_view identity);
/// Returns the BLAKE2b-256 of bytes, 64 hex digits.
[[nodiscard]] std::string digestOf(std::string_view bytes);

}  // namespace database
