// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <QString>

#include "core/base/Result.h"

namespace database {

/// The Ed25519 key with which a station signs the head of the audit. It is stored in a file that only its owner may
/// read. Any person who can read the file can sign. So, on a computer that students share, the key detects changes made
/// in the database alone, but not those of a person who uses the same account.
class StationKey
{
public:
    /// Reads the key, or creates one if the file does not exist. Error if the file has another length, is a link or is
    /// no regular file. Removes the permissions of others if they may access the file.
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
