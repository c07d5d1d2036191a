// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/StationKey.h"

#include <algorithm>
#include <vector>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <sodium.h>

#include "database/Sodium.h"

namespace database {
namespace {

const unsigned char* bytesOf(std::string_view words)
{
    return reinterpret_cast<const unsigned char*>(words.data());
}

/// Reads bytes from lower-case hex digits, the form that this program writes. Returns false for any other text.
template <std::size_t N>
bool takeHex(const std::string& hex, std::array<unsigned char, N>& bytes)
{
    std::size_t taken = 0;
    return hex.size() == 2 * N && std::none_of(hex.begin(), hex.end(), [](char c) { return c >= 'A' && c <= 'F'; }) &&
           sodium_hex2bin(bytes.data(), N, hex.data(), hex.size(), nullptr, &taken, nullptr) == 0 && taken == N;
}

core::Error refused(core::ErrorCode code, const QString& file, const char* why)
{
    return {code, "station key " + file.toStdString() + ": " + why};
}

}  // namespace

core::Result<StationKey> StationKey::readOrMake(const QString& path)
{
    using core::ErrorCode;
    if (!beginSodium())
        return tl::unexpected(refused(ErrorCode::FileUnreadable, path, "this computer has no source of chance"));
    // Changing permissions would affect the target of a link, and reading a pipe could block forever.
    const QFileInfo info(path);
    if (info.isSymLink() || (info.exists() && !info.isFile()))
        return tl::unexpected(refused(ErrorCode::FileUnreadable, path,
                                      "it is no file but a link, a folder, a pipe or a device; put the file there"));
    std::array<unsigned char, kSeedBytes> seed{};
    QFile file(path);
    if (!file.exists()) {
        randombytes_buf(seed.data(), seed.size());
        QDir().mkpath(QFileInfo(path).absolutePath());
        QSaveFile made(path);
        // QSaveFile creates the file for its owner only, so nobody else can read it at any time.
        if (!made.open(QIODevice::WriteOnly) || !made.setPermissions(QFile::ReadOwner | QFile::WriteOwner) ||
            made.write(reinterpret_cast<const char*>(seed.data()), kSeedBytes) != kSeedBytes || !made.flush() ||
            !made.commit())
            return tl::unexpected(
                refused(ErrorCode::FileUnwritable, path, "it cannot be written; make its folder writable"));
        return fromSeed(seed);
    }
    if (!file.open(QIODevice::ReadOnly))
        return tl::unexpected(refused(ErrorCode::FileUnreadable, path, "it cannot be read; check who may read it"));
    // A copy of the file, or a user, may have given others access.
    constexpr QFile::Permissions kOthers =
        QFile::ReadGroup | QFile::WriteGroup | QFile::ExeGroup | QFile::ReadOther | QFile::WriteOther | QFile::ExeOther;
    if ((file.permissions() & kOthers) && !file.setPermissions(QFile::ReadOwner | QFile::WriteOwner))
        return tl::unexpected(refused(ErrorCode::FileUnreadable, path,
                                      "others may read it, and that cannot be changed; let only its owner read it"));
    const QByteArray bytes = file.read(kSeedBytes + 1);
    if (bytes.size() != kSeedBytes)
        return tl::unexpected(refused(ErrorCode::FileUnreadable, path,
                                      "it has not the length of a key; put the right file back. Without it, moved "
                                      "away, a new key is made, and attempts that still wait here are not sent"));
    std::copy(bytes.begin(), bytes.end(), seed.begin());
    return fromSeed(seed);
}

StationKey StationKey::make()
{
    std::array<unsigned char, kSeedBytes> seed{};
    beginSodium();
    randombytes_buf(seed.data(), seed.size());
    return fromSeed(seed);
}

StationKey StationKey::fromSeed(const std::array<unsigned char, kSeedBytes>& seed)
{
    StationKey key;
    std::array<unsigned char, crypto_sign_PUBLICKEYBYTES> open{};
    static_assert(kSeedBytes == crypto_sign_SEEDBYTES && sizeof key.m_secret == crypto_sign_SECRETKEYBYTES);
    crypto_sign_seed_keypair(open.data(), key.m_secret.data(), seed.data());
    key.m_publicHex = hexOf(open.data(), open.size());
    return key;
}

std::string StationKey::sign(std::string_view words) const
{
    std::array<unsigned char, crypto_sign_BYTES> signature{};
    crypto_sign_detached(signature.data(), nullptr, bytesOf(words), words.size(), m_secret.data());
    return hexOf(signature.data(), signature.size());
}

bool StationKey::isSigned(std::string_view words, const std::string& signatureHex, const std::string& publicHex)
{
    std::array<unsigned char, crypto_sign_BYTES> signature{};
    std::array<unsigned char, crypto_sign_PUBLICKEYBYTES> open{};
    return beginSodium() && takeHex(signatureHex, signature) && takeHex(publicHex, open) &&
           crypto_sign_verify_detached(signature.data(), bytesOf(words), words.size(), open.data()) == 0;
}

}  // namespace database
