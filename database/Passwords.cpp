// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Passwords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include <QString>
#include <sodium.h>

#include "database/Sodium.h"

namespace database {
namespace {

constexpr unsigned long long kMostPasses = 16;
constexpr std::size_t kDigestBytes = 32;
constexpr std::size_t kUidBytes = 16;
constexpr std::string_view kCodeLetters = "23456789ABCDEFGHJKMNPQRSTUVWXYZ";
constexpr int kCodeLength = 12;
constexpr int kCodeGroup = 4;

double threadMs()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// The same letters typed on another keyboard are the same password.
QByteArray normal(const std::string& password)
{
    return QString::fromStdString(password).normalized(QString::NormalizationForm_KC).toUtf8();
}

}  // namespace

PasswordCost timedCost(double goalMs)
{
    PasswordCost cost;
    const double before = threadMs();
    static_cast<void>(hashPassword("how long does this take", cost));
    const double onePassMs = std::max(1.0, (threadMs() - before) / static_cast<double>(cost.passes));
    cost.passes = std::clamp(static_cast<unsigned long long>(std::floor(goalMs / onePassMs)), cost.passes, kMostPasses);
    return cost;
}

core::Status checkPassword(const std::string& password, const std::string& username)
{
    const QString given = QString::fromUtf8(normal(password));
    if (given.size() < kShortestPassword)
        return core::unexpected(core::ErrorCode::OutOfRange, "the password is too short; give it " +
                                                                 std::to_string(kShortestPassword) +
                                                                 " characters or more");
    if (given.toUtf8().size() > kLongestPassword)
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "the password is too long; " + std::to_string(kLongestPassword) + " bytes are enough");
    if (given.compare(QString::fromStdString(username), Qt::CaseInsensitive) == 0)
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "the password is the user's name, which everybody tries first; choose another one");
    return {};
}

core::Result<std::string> hashPassword(const std::string& password, const PasswordCost& cost)
{
    const QByteArray given = normal(password);
    std::array<char, crypto_pwhash_STRBYTES> hash{};
    if (!beginSodium() ||
        crypto_pwhash_str_alg(hash.data(), given.constData(), static_cast<unsigned long long>(given.size()),
                              cost.passes, cost.memoryBytes, crypto_pwhash_ALG_ARGON2ID13) != 0)
        return core::unexpected(core::ErrorCode::FileTooLarge,
                                "there is not enough memory to work with passwords; close other programs");
    return std::string(hash.data());
}

bool fits(const std::string& password, const std::string& hash)
{
    const QByteArray given = normal(password);
    return beginSodium() && hash.size() < crypto_pwhash_STRBYTES && given.size() <= 4 * kLongestPassword &&
           crypto_pwhash_str_verify(hash.c_str(), given.constData(), static_cast<unsigned long long>(given.size())) ==
               0;
}

bool wantsRehash(const std::string& hash, const PasswordCost& cost)
{
    return beginSodium() && crypto_pwhash_str_needs_rehash(hash.c_str(), cost.passes, cost.memoryBytes) != 0;
}

std::string newCode()
{
    beginSodium();
    std::string code;
    for (int k = 0; k < kCodeLength; ++k) {
        if (k > 0 && k % kCodeGroup == 0)
            code += '-';
        code += kCodeLetters[randombytes_uniform(static_cast<std::uint32_t>(kCodeLetters.size()))];
    }
    return code;
}

std::string hashOfCode(const std::string& uid, const std::string& code)
{
    return digestOf("one-time code " + uid + ' ' + code);
}

std::string newUid()
{
    beginSodium();
    std::array<unsigned char, kUidBytes> bytes{};
    randombytes_buf(bytes.data(), bytes.size());
    return hexOf(bytes.data(), bytes.size());
}

std::string digestOf(std::string_view bytes)
{
    beginSodium();
    std::array<unsigned char, kDigestBytes> digest{};
    crypto_generichash(digest.data(), digest.size(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                       nullptr, 0);
    return hexOf(digest.data(), digest.size());
}

}  // namespace database
