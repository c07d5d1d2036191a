// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <QString>

#include "core/base/Result.h"

namespace database {

/// The Ed25519 key with which a station signs the head of the audit. It lies in a file that only its owner may read:
/// who can read it can sign, so on a computer that students share it protects against changes of the database alone,
/// not against somebody who takes over the account.
class StationKey
{
public:
    /// Reads the key, or makes one where there is no file. Refused: a file of another length, a link, what is no file.
    /// One that others may read is closed to them.
    [[nodiscard]] static core::Result<StationKey> readOrMake(const QString& file);
    /// One that is forgotten with the object; for tests.
    [[nodiscard]] static StationKey make();

    /// 64 hex digits.
    [[nodiscard]] const std::string& publicHex() const { return m_publicHex; }
    /// 128 hex digits.
    [[nodiscard]] std::string sign(std::string_view words) const;
    /// By any station's public key; false for what is no hex, too.
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
