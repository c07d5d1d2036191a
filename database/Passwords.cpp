// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Passwords.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <ctime>
#include <optional>
#include <utility>
#include <vector>

#include <QRegularExpression>
#include <QString>
#include <sodium.h>
#include <zxcvbn.h>

#include "database/Secret.h"
#include "database/Sodium.h"

namespace database {
namespace {

constexpr std::size_t kKiB = 1024;
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

/// Returns the normal form of a password, so that it matches when it is typed on another keyboard.
Secret normal(const std::string& password)
{
    QString typed = QString::fromStdString(password);
    QString given = typed.normalized(QString::NormalizationForm_KC);
    Secret normal(given);
    wipe(given);
    given.clear();  // it may have shared the text with `typed`
    wipe(typed);
    return normal;
}

/// Returns the cost of a hash; empty if it is no hash.
std::optional<PasswordCost> costOf(const std::string& hash)
{
    static const QRegularExpression kCost(QStringLiteral(R"(^\$argon2id\$v=19\$m=(\d{1,9}),t=(\d{1,9}),)"));
    const auto found = kCost.match(QString::fromStdString(hash));
    if (!found.hasMatch())
        return std::nullopt;
    return PasswordCost{found.captured(2).toULongLong(), found.captured(1).toULongLong() * kKiB};
}

core::Error noMemory()
{
    return {core::ErrorCode::FileTooLarge, "there is not enough memory to work with passwords; close other programs"};
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

namespace {

constexpr qsizetype kNameLetters = 4;  ///< a shorter username is part of too many words
/// Entropy below which a password is refused: an attacker finds it among the first million guesses. zxcvbn gives such
/// passwords less than two of four points.
constexpr double kFewestBits = 20.0;
/// What people at a dental school try first, in the languages of Cusp, besides the 30,000 English words and passwords
/// that zxcvbn knows.
constexpr std::array kTriedFirst{
    "cusp",       "dental",  "dentist",    "tooth",    "student",  "teacher",  "guest",      "demo",       "school",
    "schule",     "geheim",  "hallo",      "kennwort", "passwort", "zahnarzt", "willkommen", "contrasena", "hola",
    "bienvenido", "escuela", "estudiante", "dentista", "diente",   "qwertz",   "yxcvbnm",    "asdfghjkl"};

/// Returns whether a password is one of the first guesses of an attacker (NIST SP 800-63B, 5.1.1.2: common words,
/// repetitions, sequences, the username).
/// @param given, username  in lower case
bool isTriedFirst(const QString& given, const QString& username)
{
    if (username.size() >= kNameLetters && given.contains(username))
        return true;
    const QByteArray name = username.toUtf8();
    std::vector<const char*> words(kTriedFirst.begin(), kTriedFirst.end());
    words.push_back(name.constData());
    words.push_back(nullptr);
    return ZxcvbnMatch(given.toUtf8().constData(), words.data(), nullptr) < kFewestBits;
}

}  // namespace

core::Status checkPassword(const std::string& password, const std::string& username)
{
    const QString given = QString::fromStdString(normal(password).text());
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
    if (isTriedFirst(given.toLower(), QString::fromStdString(username).toLower()))
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "the password is one of those that everybody tries first; choose another one, such as "
                                "three words that do not belong together");
    return {};
}

core::Result<std::string> hashPassword(const std::string& password, const PasswordCost& cost)
{
    const Secret given = normal(password);
    std::array<char, crypto_pwhash_STRBYTES> hash{};
    if (!beginSodium() || crypto_pwhash_str_alg(hash.data(), given.text().data(), given.text().size(), cost.passes,
                                                cost.memoryBytes, crypto_pwhash_ALG_ARGON2ID13) != 0)
        return tl::unexpected(noMemory());
    return std::string(hash.data());
}

core::Result<std::string> hashWithSalt(const std::string& password, const std::string& salt)
{
    constexpr std::size_t kHashBytes = 32;
    constexpr int kBase64 = sodium_base64_VARIANT_ORIGINAL_NO_PADDING;
    const Secret given = normal(password);
    const auto cost = costOf(salt);
    std::array<unsigned char, crypto_pwhash_SALTBYTES> bytes{};
    std::size_t size = 0;
    const QString text = QString::fromStdString(salt).section(u'$', -2, -2);
    if (!beginSodium() || !cost || !salt.ends_with('$') || cost->passes > kMostPasses ||
        cost->memoryBytes > kMostMemoryBytes ||
        sodium_base642bin(bytes.data(), bytes.size(), text.toLatin1().constData(),
                          static_cast<std::size_t>(text.size()), nullptr, &size, nullptr, kBase64) != 0 ||
        size != bytes.size())
        return core::unexpected(core::ErrorCode::OutOfRange, "the server answered with something that is no salt");
    std::array<unsigned char, kHashBytes> hash{};
    // No password is as long as this part of a longer text.
    const std::size_t length = std::min<std::size_t>(given.text().size(), 4 * kLongestPassword + 1);
    if (crypto_pwhash(hash.data(), hash.size(), given.text().data(), length, bytes.data(), cost->passes,
                      cost->memoryBytes, crypto_pwhash_ALG_ARGON2ID13) != 0)
        return tl::unexpected(noMemory());
    std::array<char, sodium_base64_ENCODED_LEN(kHashBytes, kBase64)> encoded{};
    sodium_bin2base64(encoded.data(), encoded.size(), hash.data(), hash.size(), kBase64);
    return salt + encoded.data();
}

core::Result<bool> fits(const std::string& password, const std::string& hash)
{
    const Secret given = normal(password);
    if (!isPasswordHash(hash) || hash.size() >= crypto_pwhash_STRBYTES || given.text().size() > 4 * kLongestPassword)
        return false;
    errno = 0;
    const bool isRight = crypto_pwhash_str_verify(hash.c_str(), given.text().data(), given.text().size()) == 0;
    if (!isRight && errno == ENOMEM)
        return tl::unexpected(noMemory());
    return isRight;
}

bool isPasswordHash(const std::string& hash)
{
    const PasswordCost cost;
    const auto paid = costOf(hash);
    return beginSodium() && paid && paid->passes <= kMostPasses && paid->memoryBytes <= kMostMemoryBytes &&
           crypto_pwhash_str_needs_rehash(hash.c_str(), cost.passes, cost.memoryBytes) != -1;
}

bool wantsRehash(const std::string& hash, const PasswordCost& cost)
{
    const auto paid = costOf(hash);
    if (!paid)
        return true;
    return paid->passes <= cost.passes && paid->memoryBytes <= cost.memoryBytes &&
           (paid->passes < cost.passes || paid->memoryBytes < cost.memoryBytes);
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

std::string uidOf(std::string_view identity)
{
    return digestOf(identity).substr(0, kUidLength);
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
