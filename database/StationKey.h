// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <QString>

#include "core/base/Result.h"

namespace database {

/// The Ed25519 key with which a station signs the head of the audit. It is in a file that only its owner may read.
/// Everybody who can read it can sign: on a computer that students share it protects against changes of the database
/// alone, not against a person who uses the account.
class StationKey
{
public:
    /// Reads the key, or creates one if there is no file. Error: a file of another length, a link, or no regular file.
    /// If others may read the file, removes that permission.
    [[nodiscard]] static core::Result<StationKey> readOrMake(const QString& file);
    /// Returns a key that is not stored; for tests.
    [[nodiscard]] static StationKey make();

    /// Returns the public key, 64 hex digits.
    [[nodiscard]] const std::string& publicHex() const { return m_publicHex; }
    /// Returns a signature, 128 hex digits.
    [[nodiscard]] std::string sign(std::string_view words) const;
    /// Returns whether a signature is valid for a station's public key; false for text that is not hex.
    [[nodiscard]] static bool isSigned(std::string_view words, const std::string& signatureHex,
                                       const std::string& publicHex);

private:
    StationKey() = default;
    static constexpr std::size_t kSeedBytes = 32;
    [[nodiscard]] static StationKey fromSeed(const std::array<unsigned char, kSeedBytes>& seed);

    std::array<unsigned char, 64> m_secret{};
    std::string m_publicHex;
};

}  // namespace database
