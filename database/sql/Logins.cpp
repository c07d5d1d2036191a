// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Logins.h"

#include <algorithm>
#include <optional>
#include <thread>

#include <QRegularExpression>

#include "database/Usernames.h"
#include "database/sql/Audit.h"
#include "database/sql/Grants.h"
#include "database/sql/People.h"
#include "database/sql/Settings.h"
#include "database/sql/Statement.h"
#include "database/sql/StationLogins.h"

namespace database::sql {
namespace {

using core::ErrorCode;

const std::string kLogIn = "log in";
const std::string kSetPassword = "set the password";
const QString kPasses = QStringLiteral("password.passes");
const QString kMemory = QStringLiteral("password.memory");
/// Setting with the hash of a random password, which no person has.
const QString kDecoy = QStringLiteral("password.decoy");
constexpr int kMostDoublings = 20;
constexpr std::size_t kStationDigits = 16;

/// The stored login data of a name.
struct Account
{
    std::optional<Person> person;
    std::string passwordHash;
    std::string codeHash;
    std::string codeUntilUtc;
    bool isByCode = false;  ///< the person gave the one-time code, not the password
};

core::Error wrongLogin()
{
    return {ErrorCode::WrongLogin, "name or password is wrong; try again, or ask an admin for a one-time code"};
}

qlonglong nowMs(const DatabaseContext& school)
{
    return school.nowUtc().toMSecsSinceEpoch();
}

qlonglong yesterdayMs(const DatabaseContext& school)
{
    return nowMs(school) - std::chrono::milliseconds(std::chrono::hours(24)).count();
}

core::Error tooSoon(std::chrono::milliseconds wait)
{
    const auto seconds = std::chrono::ceil<std::chrono::seconds>(wait).count();
    return {ErrorCode::TooSoon, "too many logins have failed; wait " + std::to_string(seconds) +
                                    (seconds == 1 ? " second" : " seconds") + " and try again"};
}

/// Returns the key of a row for a name, which exists while a login attempt is being compared.
QVariant tryOf(const std::string& hash)
{
    return text("try:" + hash);
}

/// Returns the key of the row with the failures of a name on this station. The row of the name itself has those on all
/// stations.
QVariant hereOf(const DatabaseContext& school, const std::string& hash)
{
    return text(hash + '@' + digestOf(school.key.publicHex()).substr(0, kStationDigits));
}

/// Returns the wait after a number of failures.
std::chrono::milliseconds waitAfter(int failures, int freeFailures, std::chrono::seconds longest)
{
    const int beyond = failures - freeFailures;
    if (beyond < 0)
        return std::chrono::milliseconds(0);
    return std::min<std::chrono::milliseconds>(longest, std::chrono::seconds(1LL << std::min(beyond, kMostDoublings)));
}

/// The state of the login attempts of a name.
struct Tries
{
    std::chrono::milliseconds wait{0};  ///< time until the next attempt is allowed
    bool isCompared = false;            ///< an attempt is being compared now, and may succeed
    bool isAhead = false;               ///< an attempt was counted by a clock that was ahead of this one
};

core::Result<Tries> triesOf(const DatabaseContext& school, const std::string& hash)
{
    // If a station stops during a comparison, the others do not wait for it any longer than this.
    constexpr std::chrono::milliseconds kLongestTry = std::chrono::seconds(5);
    Tries tries;
    const QVariant here = hereOf(school, hash);
    const auto read =
        forEach(school.db, "SELECT name_hash, failures, last_ms FROM failed_logins WHERE name_hash IN (?, ?, ?)",
                kLogIn, {text(hash), here, tryOf(hash)}, [&](const QSqlQuery& row) {
                    // If the clock was set back, a person must neither be locked out for long nor be admitted at once.
                    const qlonglong goneMs = nowMs(school) - row.value(2).toLongLong();
                    tries.isAhead = tries.isAhead || goneMs < 0;
                    const std::chrono::milliseconds gone(std::max(0LL, goneMs));
                    const std::string key = textOf(row, 0);
                    if (key != hash && key != here.toString().toStdString()) {
                        tries.isCompared = gone < kLongestTry;
                        return;
                    }
                    const auto whole =
                        key == hash ? waitAfter(row.value(1).toInt(), Logins::kFreeFailuresAnywhere,
                                                Logins::kLongestWaitAnywhere)
                                    : waitAfter(row.value(1).toInt(), Logins::kFreeFailures, Logins::kLongestWait);
                    tries.wait = std::max(tries.wait, whole - gone);
                });
    if (!read)
        return tl::unexpected(read.error());
    return tries;
}

/// Changes times in the future, from a clock that was ahead, to the present. Otherwise each check would restart the
/// wait until that time has passed.
core::Status bringBack(const DatabaseContext& school, const std::string& hash)
{
    const qlonglong now = nowMs(school);
    return execute(school.db, "UPDATE failed_logins SET last_ms = ? WHERE name_hash IN (?, ?, ?) AND last_ms > ?",
                   kLogIn, {now, text(hash), hereOf(school, hash), tryOf(hash), now});
}

/// Counts an attempt. Failures of the day before are forgotten: a few slips a week must not add up to a long wait.
core::Status countTry(const DatabaseContext& school, const QVariant& name)
{
    return execute(school.db,
                   "INSERT INTO failed_logins (name_hash, failures, last_ms) VALUES (?, 1, ?) ON CONFLICT (name_hash) "
                   "DO UPDATE SET failures = CASE WHEN failed_logins.last_ms < ? THEN 1 WHEN failed_logins.failures > "
                   "1000 THEN failed_logins.failures ELSE failed_logins.failures + 1 END, last_ms = excluded.last_ms",
                   kLogIn, {name, nowMs(school), yesterdayMs(school)});
}

/// Counts a login attempt as a failure before its comparison, so that many attempts at once allow no more guesses than
/// a sequence. Returns false if the name has to wait.
core::Result<bool> reserveTry(const DatabaseContext& school, const std::string& hash)
{
    return inTurn(school, kLogIn, [&]() -> core::Result<bool> {
        const auto tries = triesOf(school, hash);
        if (!tries)
            return tl::unexpected(tries.error());
        if (tries->wait.count() > 0)
            return false;
        // Removes old names, so that many guessed names do not fill the disk. A small table is left alone whatever the
        // clock says: filling it takes longer than any wait.
        if (auto forgotten = execute(
                school.db, "DELETE FROM failed_logins WHERE last_ms < ? AND (SELECT COUNT(*) FROM failed_logins) > ?",
                kLogIn, {yesterdayMs(school), Logins::kMostFailedNames});
            !forgotten)
            return tl::unexpected(forgotten.error());
        for (const QVariant& name : {QVariant(text(hash)), hereOf(school, hash), tryOf(hash)})
            if (auto counted = countTry(school, name); !counted)
                return tl::unexpected(counted.error());
        return true;
    });
}

/// Waits while other attempts for the same name are being compared. So parallel logins guess no faster than sequential
/// ones.
core::Status beginTry(const DatabaseContext& school, const std::string& hash)
{
    constexpr int kMostLooks = 100;
    constexpr std::chrono::milliseconds kBetween(50);
    for (int looks = 0; looks < kMostLooks; ++looks) {
        const auto tries = triesOf(school, hash);
        if (!tries)
            return tl::unexpected(tries.error());
        if (tries->isAhead)
            if (auto brought = bringBack(school, hash); !brought)
                return brought;
        if (tries->wait.count() > 0 && !tries->isCompared)
            return tl::unexpected(tooSoon(tries->wait));
        if (tries->wait.count() == 0) {
            const auto reserved = reserveTry(school, hash);
            if (!reserved)
                return tl::unexpected(reserved.error());
            if (*reserved)
                return {};
        }
        std::this_thread::sleep_for(kBetween);
    }
    return tl::unexpected(tooSoon(std::chrono::seconds(1)));
}

/// Uncounts an attempt in these rows.
core::Status uncount(const DatabaseContext& school, const QVariantList& rows)
{
    for (const QVariant& row : rows)
        for (const char* sql : {"DELETE FROM failed_logins WHERE name_hash = ? AND failures = 1",
                                "UPDATE failed_logins SET failures = failures - 1 WHERE name_hash = ?"})
            if (auto done = execute(school.db, QLatin1String(sql), kLogIn, {row}); !done)
                return done;
    return {};
}

/// Deletes the failures of a name here. Call it inside the transaction that follows a correct password or code. Those
/// on other stations stay: somebody may be guessing there.
core::Status forgive(const DatabaseContext& school, const std::string& hash)
{
    if (auto uncounted = uncount(school, {text(hash)}); !uncounted)
        return uncounted;
    return execute(school.db, "DELETE FROM failed_logins WHERE name_hash IN (?, ?)", kLogIn,
                   {hereOf(school, hash), tryOf(hash)});
}

core::Status endTry(const DatabaseContext& school, const std::string& hash)
{
    return execute(school.db, "DELETE FROM failed_logins WHERE name_hash = ?", kLogIn, {tryOf(hash)});
}

/// Ends a failed attempt, which reserveTry() has counted already.
core::Status noteFailure(const DatabaseContext& school, const std::string& hash)
{
    return inTurn(school, kLogIn, [&]() -> core::Status {
        if (auto ended = endTry(school, hash); !ended)
            return ended;
        return note(school, "", "login.failed", "name:" + nameInAudit(hash));
    });
}

/// Uncounts an attempt that could not be compared, because it is no failure.
core::Status takeBack(const DatabaseContext& school, const std::string& hash)
{
    return inTurn(school, kLogIn, [&]() -> core::Status {
        if (auto uncounted = uncount(school, {text(hash), hereOf(school, hash)}); !uncounted)
            return uncounted;
        return endTry(school, hash);
    });
}

core::Result<Account> accountOf(const DatabaseContext& school, const std::string& typed)
{
    Account account;
    const auto name = normalUsername(typed);
    if (!name)
        return account;
    const auto read = forEach(school.db,
                              "SELECT id, uid, username, given_name, family_name, role, disabled, password_hash, "
                              "reset_hash, reset_until_utc FROM people WHERE username = ?",
                              kLogIn, {text(*name)}, [&](const QSqlQuery& row) {
                                  Person person;
                                  person.id = {row.value(0).toLongLong()};
                                  person.uid = textOf(row, 1);
                                  person.username = textOf(row, 2);
                                  person.givenName = textOf(row, 3);
                                  person.familyName = textOf(row, 4);
                                  person.role = roleOf(textOf(row, 5)).value_or(Role::Student);
                                  person.disabled = row.value(6).toInt() != 0;
                                  account = {person, textOf(row, 7), textOf(row, 8), textOf(row, 9)};
                              });
    if (!read)
        return tl::unexpected(read.error());
    return account;
}

/// Returns whether a text is three groups of four letters or digits, separated by `by`, a regular expression. People
/// type a code with hyphens, with spaces or without either.
bool isCodeParted(const std::string& typed, const char* by)
{
    const QRegularExpression code(QStringLiteral("^([0-9A-Za-z]{4})%1([0-9A-Za-z]{4})%1([0-9A-Za-z]{4})$").arg(by));
    return code.match(QString::fromStdString(typed).trimmed()).hasMatch();
}

/// Returns whether a text looks like a code. New passwords that do are refused.
bool looksLikeCode(const std::string& typed)
{
    return isCodeParted(typed, "[-\u2010-\u2014 ]+");
}

std::string codeOf(const std::string& typed)
{
    constexpr qsizetype kGroup = 4;
    QString code = QString::fromStdString(typed).toUpper();
    code.removeIf([](QChar letter) { return !letter.isLetterOrNumber(); });
    for (qsizetype at = kGroup; at < code.size(); at += kGroup + 1)
        code.insert(at, u'-');
    return code.toStdString();
}

/// Returns the password hash to compare with if the name is unknown or has no password. It is the hash of another
/// person, and stays the same for a name until people are added or removed. So a login takes as long as for a known
/// name, even while some hashes still have the lower cost of an older computer.
core::Result<std::string> otherPassword(const DatabaseContext& school, const std::string& nameHash)
{
    constexpr const char* kHaving = "FROM people WHERE password_hash <> ''";
    constexpr int kHexDigits = 8;
    const auto decoy = ask(school.db, "SELECT value FROM settings WHERE owner = '' AND name = ?", kLogIn, {kDecoy});
    const auto count = ask(school.db, QStringLiteral("SELECT COUNT(*) %1").arg(kHaving), kLogIn);
    if (!decoy || !count)
        return tl::unexpected(decoy ? count.error() : decoy.error());
    if (count->toLongLong() == 0)
        return decoy->toString().toStdString();
    // The choice is unpredictable without the decoy, which is secret.
    const std::string draw = digestOf(decoy->toString().toStdString() + nameHash).substr(0, kHexDigits);
    const auto other =
        ask(school.db, QStringLiteral("SELECT password_hash %1 ORDER BY uid LIMIT 1 OFFSET ?").arg(kHaving), kLogIn,
            {QString::fromStdString(draw).toLongLong(nullptr, 16) % count->toLongLong()});
    if (!other)
        return tl::unexpected(other.error());
    return other->toString().toStdString();
}

enum class SecretKind { Password, Code, Either };

/// Lets the server compare a secret, as compare() does.
core::Result<std::optional<Account>> compareThere(const DatabaseContext& school, const std::string& username,
                                                  const std::string& secret, SecretKind kind)
{
    const QSqlDatabase db = school.db;
    const std::string name = normalUsername(username).value_or(username);
    const auto salt = station::saltOf(db, name);
    if (!salt)
        return tl::unexpected(salt.error());
    if (wantsRehash(salt->password, school.leastCost))
        return core::unexpected(ErrorCode::ServerRefuses,
                                "database " + dialect::nameOf(db) +
                                    ": the server asks for a proof from which the password is easily guessed; let its "
                                    "administrator look at it");
    if (kind != SecretKind::Code) {
        const auto hash = hashWithSalt(secret, salt->password);
        if (!hash)
            return tl::unexpected(hash.error());
        auto person = station::personBy(db, name, *hash);
        if (!person)
            return tl::unexpected(person.error());
        if (*person)
            return Account{std::move(*person), *hash, {}, {}};
    }
    if (kind == SecretKind::Password)
        return std::nullopt;
    Account account;
    account.codeHash = hashOfCode(salt->uid, codeOf(secret));
    const auto isRight = station::isCode(db, name, account.codeHash);
    if (!isRight)
        return tl::unexpected(isRight.error());
    account.isByCode = true;
    account.person.emplace();
    account.person->uid = salt->uid;
    account.person->username = name;
    return *isRight ? std::optional(std::move(account)) : std::nullopt;
}

/// Compares a secret with the account of a name. A password is compared exactly once, whether or not the account
/// exists, so that the time reveals nothing. Comparing a code is always fast.
/// @param hash  of the name
/// @return empty if the secret is wrong or the person is disabled
core::Result<std::optional<Account>> compare(const DatabaseContext& school, const std::string& username,
                                             const std::string& hash, const std::string& secret, SecretKind kind)
{
    if (dialect::isStation(school.db))
        return compareThere(school, username, secret, kind);
    auto account = accountOf(school, username);
    if (!account)
        return tl::unexpected(account.error());
    bool isRight = false;
    if (kind != SecretKind::Code) {
        const auto other = otherPassword(school, hash);
        if (!other)
            return tl::unexpected(other.error());
        const std::string& own = account->passwordHash;
        const auto same = fits(secret, own.empty() ? *other : own);
        if (!same)
            return tl::unexpected(same.error());
        isRight = *same && !own.empty();
    }
    if (!isRight && kind != SecretKind::Password) {
        const bool isOver = account->codeUntilUtc < school.now();
        isRight = !isOver && !account->codeHash.empty() &&
                  hashOfCode(account->person->uid, codeOf(secret)) == account->codeHash;
        account->isByCode = isRight;
    }
    if (!isRight || account->person->disabled)
        return std::nullopt;
    return std::optional(std::move(*account));
}

/// Returns the account if the secret is correct. The caller has to call forgive() in its next transaction.
core::Result<Account> tryAccount(const DatabaseContext& school, const std::string& username, const std::string& secret,
                                 SecretKind kind)
{
    const std::string hash = nameHash(username);
    if (auto begun = beginTry(school, hash); !begun)
        return tl::unexpected(begun.error());
    auto account = compare(school, username, hash, secret, kind);
    if (!account) {
        static_cast<void>(takeBack(school, hash));  // the error of the comparison is more important
        return tl::unexpected(account.error());
    }
    if (!*account) {
        if (auto noted = noteFailure(school, hash); !noted)
            return tl::unexpected(noted.error());
        return tl::unexpected(wrongLogin());
    }
    return std::move(**account);
}

/// Hashes a password. Takes a fraction of a second, so do not call it in a transaction that others wait for.
core::Result<std::string> hashFor(const DatabaseContext& school, const std::string& password)
{
    const auto cost = passwordCost(school);
    if (!cost)
        return tl::unexpected(cost.error());
    return hashPassword(password, *cost);
}

/// Fails if another station or an admin has changed the secret since it was compared.
core::Status expectStill(const DatabaseContext& school, const Person& person, const char* column,
                         const std::string& hash)
{
    const auto still =
        ask(school.db,
            QStringLiteral("SELECT %1 FROM people WHERE id = ? AND disabled = 0").arg(QLatin1String(column)) +
                dialect::forUpdate(school.db),
            kSetPassword, {number(person.id.value)});
    if (!still)
        return tl::unexpected(still.error());
    if (still->toString().toStdString() != hash)
        return tl::unexpected(wrongLogin());
    return {};
}

/// Replaces the password or the one-time code of an account, if it is still the one that was compared.
core::Status setPassword(const DatabaseContext& school, const Account& account, const std::string& hash)
{
    const Person& person = *account.person;
    if (dialect::isStation(school.db))
        return account.isByCode ? station::redeem(school.db, person.username, account.codeHash, hash)
                                : station::setPassword(school.db, person.username, account.passwordHash, hash);
    // If two stations redeem the code at once, only one succeeds.
    if (auto still = account.isByCode ? expectStill(school, person, "reset_hash", account.codeHash)
                                      : expectStill(school, person, "password_hash", account.passwordHash);
        !still)
        return still;
    return execute(school.db, "UPDATE people SET password_hash = ?, reset_hash = '', reset_until_utc = '' WHERE id = ?",
                   kSetPassword, {text(hash), number(person.id.value)});
}

/// Notes the time of a login.
/// @param dearer  a hash of the same password with a higher cost, which replaces the stored one unless an admin has
/// removed the password meanwhile; empty: none
/// @return the token, see Logins::tokenOf()
core::Result<std::string> enterAccount(const DatabaseContext& school, const Account& account, const std::string& dearer)
{
    const Person& person = *account.person;
    if (dialect::isStation(school.db)) {
        auto token = station::logIn(school.db, person.username, account.passwordHash, dearer);
        if (token && !dearer.empty())
            if (auto noted = noteLogin(school, person.uid, "password.rehash", person.uid, {dearer, "", ""}); !noted)
                return tl::unexpected(noted.error());
        return token;
    }
    const qlonglong id = person.id.value;
    if (!dearer.empty()) {
        const auto raised = ask(school.db,
                                "UPDATE people SET password_hash = ? WHERE id = ? AND password_hash = ? AND reset_hash "
                                "= '' AND reset_until_utc = '' RETURNING id",
                                kLogIn, {text(dearer), id, text(account.passwordHash)});
        if (!raised)
            return tl::unexpected(raised.error());
        if (!raised->isNull())
            if (auto noted = noteLogin(school, person.uid, "password.rehash", person.uid, {dearer, "", ""}); !noted)
                return tl::unexpected(noted.error());
    }
    return execute(school.db, "UPDATE people SET last_login_utc = ? WHERE id = ?", kLogIn, {text(school.now()), id})
        .map([] { return std::string(); });
}

/// Stores the cost of new password hashes, and a decoy hash of that cost.
core::Status keepCost(const DatabaseContext& school, const std::string& actor, const PasswordCost& cost,
                      const std::string& decoy)
{
    for (const auto& [name, value] : {std::pair(kPasses, std::to_string(cost.passes)),
                                      std::pair(kMemory, std::to_string(cost.memoryBytes)), std::pair(kDecoy, decoy)})
        if (auto kept = putSetting(school, actor, name.toStdString(), value); !kept)
            return kept;
    return {};
}

}  // namespace

core::Result<PasswordCost> passwordCost(const DatabaseContext& school)
{
    PasswordCost cost;
    for (const auto& [name, take] : {std::pair(
                                         kPasses, +[](PasswordCost&c, qulonglong value) { c.passes = value; }),
                                     std::pair(
                                         kMemory, +[](PasswordCost&c, qulonglong value) { c.memoryBytes = value; })}) {
        const auto kept = ask(school.db, "SELECT value FROM settings WHERE owner = '' AND name = ?",
                              "read what passwords cost", {name});
        if (!kept)
            return tl::unexpected(kept.error());
        if (const qulonglong value = kept->toString().toULongLong(); value > 0)
            take(cost, value);
    }
    // A person with write access to the database must not be able to make hashes cheap to guess, or logins endless.
    cost.passes = std::clamp(cost.passes, school.leastCost.passes, kMostPasses);
    cost.memoryBytes = std::clamp(cost.memoryBytes, school.leastCost.memoryBytes, kMostMemoryBytes);
    return cost;
}

core::Status raisePasswordCost(const DatabaseContext& school, const Login& session, const PasswordCost& cost)
{
    if (auto may = authorize(school, session, Operation::ChangeSettings); !may)
        return tl::unexpected(may.error());
    const auto present = passwordCost(school);
    if (!present)
        return tl::unexpected(present.error());
    if (cost.passes < 2 * present->passes || cost.memoryBytes < present->memoryBytes)
        return {};
    // Comparing with the decoy has to take as long as with a real hash.
    const auto decoy = hashPassword(newUid(), cost);
    if (!decoy)
        return tl::unexpected(decoy.error());
    return inTurn(school, "raise what passwords cost", [&] { return keepCost(school, session.uid(), cost, *decoy); });
}

core::Status Logins::checkNewPassword(const std::string& password, const std::string& username)
{
    if (auto fit = checkPassword(password, username); !fit)
        return fit;
    if (looksLikeCode(password))
        return core::unexpected(ErrorCode::OutOfRange, "the password looks like a one-time code; choose another one");
    return {};
}

core::Result<bool> Logins::isNew(const DatabaseContext& school)
{
    const auto somebody = ask(
        school.db, dialect::isStation(school.db) ? "SELECT 1 WHERE NOT cusp_is_new()" : "SELECT 1 FROM people LIMIT 1",
        "see who works here");
    if (!somebody)
        return tl::unexpected(somebody.error());
    return somebody->isNull();
}

core::Result<Login> Logins::createFirstAdmin(const DatabaseContext& school, const NewPerson& who,
                                             const std::string& password, const PasswordCost& cost)
{
    const std::string doing = "enter the first admin";
    if (auto owner = expectOwner(school.db, "cusp db init --admin " + who.username); !owner)
        return tl::unexpected(owner.error());
    if (auto fit = checkNewPassword(password, who.username); !fit)
        return tl::unexpected(fit.error());
    const auto hash = hashPassword(password, cost);
    const auto decoy = hashPassword(newUid(), cost);
    if (!hash || !decoy)
        return tl::unexpected(hash ? decoy.error() : hash.error());
    auto entered = inTurn(school, doing, [&]() -> core::Status {
        const auto fresh = isNew(school);
        if (!fresh)
            return tl::unexpected(fresh.error());
        if (!*fresh)
            return core::unexpected(ErrorCode::NotAllowed,
                                    "there are people here already; log in as an admin to enter more");
        NewPerson admin = who;
        admin.role = Role::Admin;
        // The person is created before keepCost(): the first row of the audit identifies the school.
        AuditBatch audit(school);
        if (auto person = enter(school, audit, "system", admin, {*hash, {}}); !person)
            return tl::unexpected(person.error());
        if (auto sealed = audit.seal(); !sealed)
            return sealed;
        return keepCost(school, "system", cost, *decoy);
    });
    if (!entered)
        return tl::unexpected(entered.error());
    return login(school, who.username, password);
}

core::Result<Login> Logins::login(const DatabaseContext& school, const std::string& username,
                                  const std::string& password)
{
    // A password may also be twelve letters without separators.
    const SecretKind kind = looksLikeCode(password)      ? SecretKind::Code
                            : isCodeParted(password, "") ? SecretKind::Either
                                                         : SecretKind::Password;
    auto account = tryAccount(school, username, password, kind);
    if (!account)
        return tl::unexpected(account.error());
    if (account->isByCode) {
        if (auto forgiven = inTurn(school, kLogIn, [&] { return forgive(school, nameHash(username)); }); !forgiven)
            return tl::unexpected(forgiven.error());
        return core::unexpected(ErrorCode::NewPassword, "the code is right; choose a password");
    }
    const Person& person = *account->person;
    const auto cost = passwordCost(school);
    if (!cost)
        return tl::unexpected(cost.error());
    std::string rehashed;
    if (wantsRehash(account->passwordHash, *cost))
        rehashed = hashPassword(password, *cost).value_or(std::string());
    const auto token = inTurn(school, kLogIn, [&]() -> core::Result<std::string> {
        auto entered = enterAccount(school, *account, rehashed);
        if (!entered)
            return entered;
        if (auto forgiven = forgive(school, nameHash(username)); !forgiven)
            return tl::unexpected(forgiven.error());
        if (auto noted = note(school, person.uid, "login", "person:" + person.uid); !noted)
            return tl::unexpected(noted.error());
        return entered;
    });
    if (!token)
        return tl::unexpected(token.error());
    Login session;
    session.m_person = person.id;
    session.m_uid = person.uid;
    session.m_username = person.username;
    session.m_fullName = person.fullName().empty() ? person.username : person.fullName();
    session.m_role = person.role;
    if (!token->empty())
        session.m_proof =
            std::make_shared<Login::Proof>(Login::Proof{*token, rehashed.empty() ? account->passwordHash : rehashed});
    return session;
}

core::Result<Login> Logins::redeem(const DatabaseContext& school, const std::string& username, const std::string& code,
                                   const std::string& newPassword)
{
    if (auto fit = checkNewPassword(newPassword, username); !fit)
        return tl::unexpected(fit.error());
    auto account = tryAccount(school, username, code, SecretKind::Code);
    if (!account)
        return tl::unexpected(account.error());
    const auto hash = hashFor(school, newPassword);
    if (!hash)
        return tl::unexpected(hash.error());
    auto set = inTurn(school, kSetPassword, [&]() -> core::Status {
        if (auto done = setPassword(school, *account, *hash); !done)
            return done;
        if (auto forgiven = forgive(school, nameHash(username)); !forgiven)
            return forgiven;
        if (auto noted =
                noteLogin(school, account->person->uid, "password.code", account->person->uid, {*hash, "", ""});
            !noted)
            return noted;
        return dialect::isStation(school.db) ? station::logOut(school.db) : core::Status();
    });
    if (!set)
        return tl::unexpected(set.error());
    return login(school, username, newPassword);
}

core::Status Logins::logout(const DatabaseContext& school, const Login& session)
{
    if (session.isGuest())
        return {};
    const std::string doing = "log out";
    const bool isStation = dialect::isStation(school.db);
    return inTurn(school, doing, [&]() -> core::Status {
        if (isStation) {
            // A login that the server has ended already cannot be noted.
            const auto isThere = station::resume(school.db, tokenOf(session));
            if (!isThere || !*isThere)
                return isThere ? station::logOut(school.db) : core::Status(tl::unexpected(isThere.error()));
        }
        if (auto noted = note(school, session.uid(), "logout", "person:" + session.uid()); !noted)
            return noted;
        return isStation ? station::logOut(school.db) : core::Status();
    });
}

core::Status Logins::changePassword(const DatabaseContext& school, const Login& session, const std::string& old,
                                    const std::string& newPassword)
{
    if (auto who = authorize(school, session, Operation::ChangeOwnPassword); !who)
        return tl::unexpected(who.error());
    if (auto fit = checkNewPassword(newPassword, session.username()); !fit)
        return fit;
    auto account = tryAccount(school, session.username(), old, SecretKind::Password);
    if (!account)
        return tl::unexpected(account.error());
    const auto hash = hashFor(school, newPassword);
    if (!hash)
        return tl::unexpected(hash.error());
    core::Status set = inTurn(school, kSetPassword, [&]() -> core::Status {
        if (auto done = setPassword(school, *account, *hash); !done)
            return done;
        if (auto forgiven = forgive(school, nameHash(session.username())); !forgiven)
            return forgiven;
        return noteLogin(school, session.uid(), "password.change", session.uid(), {*hash, "", ""});
    });
    if (set && session.m_proof)
        session.m_proof->passwordHash = *hash;
    return set;
}

std::string Logins::tokenOf(const Login& session)
{
    return session.m_proof ? session.m_proof->token : std::string();
}

core::Result<std::string> Logins::ownHash(const DatabaseContext& school, const Login& session)
{
    if (auto who = authorize(school, session, Operation::ChangeOwnPassword); !who)
        return tl::unexpected(who.error());
    if (session.m_proof)
        return session.m_proof->passwordHash;
    const auto hash = ask(school.db, QStringLiteral("SELECT password_hash FROM people WHERE id = ?"),
                          "read one's own account", {number(session.person().value)});
    if (!hash)
        return tl::unexpected(hash.error());
    return hash->toString().toStdString();
}

}  // namespace database::sql
