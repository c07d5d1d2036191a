// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Logins.h"

#include <algorithm>
#include <optional>

#include <QRegularExpression>

#include "database/Usernames.h"
#include "database/sql/Audit.h"
#include "database/sql/People.h"
#include "database/sql/Settings.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using core::ErrorCode;

const std::string kLogIn = "log in";
const QString kPasses = QStringLiteral("password.passes");
const QString kMemory = QStringLiteral("password.memory");
/// The hash of a password that nobody knows.
const QString kDecoy = QStringLiteral("password.decoy");
constexpr int kMostDoublings = 20;

/// What is known of a name when somebody tries it.
struct Account
{
    std::optional<Person> person;
    std::string passwordHash;
    std::string codeHash;
    std::string codeUntilUtc;
    bool isByCode = false;  ///< he has shown his one-time code, not his password
};

core::Error wrongLogin()
{
    return {ErrorCode::WrongLogin, "name or password is wrong; try again, or ask an admin for a one-time code"};
}

/// Under this the failures of a name are kept, whatever was typed.
std::string nameHash(const std::string& typed)
{
    const auto name = normalUsername(typed);
    return digestOf(name ? *name : typed);
}

constexpr std::size_t kNameInAudit = 16;  ///< digits of that hash

qlonglong nowMs(const School& school)
{
    return school.nowUtc().toMSecsSinceEpoch();
}

/// How long this name still has to wait.
core::Result<std::chrono::milliseconds> waitFor(const School& school, const std::string& hash)
{
    std::chrono::milliseconds wait{0};
    const auto read =
        forEach(school.db, "SELECT failures, last_ms FROM failed_logins WHERE name_hash = ?", kLogIn, {text(hash)},
                [&](const QSqlQuery& row) {
                    const int beyond = row.value(0).toInt() - Logins::kFreeFailures;
                    if (beyond < 0)
                        return;
                    const std::chrono::milliseconds whole = std::min<std::chrono::milliseconds>(
                        Logins::kLongestWait, std::chrono::seconds(1LL << std::min(beyond, kMostDoublings)));
                    // A clock that was put back must neither lock anybody out for long nor let him in at once.
                    const std::chrono::milliseconds gone(std::max(0LL, nowMs(school) - row.value(1).toLongLong()));
                    wait = std::max(std::chrono::milliseconds(0), whole - gone);
                });
    if (!read)
        return tl::unexpected(read.error());
    return wait;
}

core::Status noteFailure(const School& school, const std::string& hash)
{
    return inTurn(school, kLogIn, [&]() -> core::Status {
        if (auto counted = execute(school.db,
                                   "INSERT INTO failed_logins (name_hash, failures, last_ms) VALUES (?, 1, ?) "
                                   "ON CONFLICT (name_hash) DO UPDATE SET failures = failed_logins.failures + 1, "
                                   "last_ms = excluded.last_ms",
                                   kLogIn, {text(hash), nowMs(school)});
            !counted)
            return counted;
        // Names that nobody has tried for a day are forgotten: a list of guesses does not fill the disk.
        const qlonglong yesterday = nowMs(school) - std::chrono::milliseconds(std::chrono::hours(24)).count();
        if (auto forgotten = execute(school.db, "DELETE FROM failed_logins WHERE last_ms < ?", kLogIn, {yesterday});
            !forgotten)
            return forgotten;
        return note(school, "", "login.failed", "name:" + hash.substr(0, kNameInAudit));
    });
}

core::Result<Account> accountOf(const School& school, const std::string& typed)
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

/// Four letters or digits, three times. Whoever reads a code off a slip parts them by hyphens, by spaces, or not at
/// all.
bool isCodeParted(const std::string& typed, const char* by)
{
    const QRegularExpression code(QStringLiteral("^([0-9A-Za-z]{4})%1([0-9A-Za-z]{4})%1([0-9A-Za-z]{4})$").arg(by));
    return code.match(QString::fromStdString(typed).trimmed()).hasMatch();
}

/// No password looks like that.
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

/// What is compared with where nobody is called so, or he has no password: that of somebody else, the same for a name
/// until people come or go. So it takes as long as it takes with those who are here, also while some passwords are
/// still kept at the cost of an older computer.
core::Result<std::string> otherPassword(const School& school, const std::string& nameHash)
{
    constexpr const char* kHaving = "FROM people WHERE password_hash <> ''";
    constexpr int kHexDigits = 8;
    const auto decoy = ask(school.db, "SELECT value FROM settings WHERE owner = '' AND name = ?", kLogIn, {kDecoy});
    const auto count = ask(school.db, QStringLiteral("SELECT COUNT(*) %1").arg(kHaving), kLogIn);
    if (!decoy || !count)
        return tl::unexpected(decoy ? count.error() : decoy.error());
    if (count->toLongLong() == 0)
        return decoy->toString().toStdString();
    // Whose it is can be told by nobody who does not know the decoy.
    const std::string draw = digestOf(decoy->toString().toStdString() + nameHash).substr(0, kHexDigits);
    const auto other =
        ask(school.db, QStringLiteral("SELECT password_hash %1 ORDER BY uid LIMIT 1 OFFSET ?").arg(kHaving), kLogIn,
            {QString::fromStdString(draw).toLongLong(nullptr, 16) % count->toLongLong()});
    if (!other)
        return tl::unexpected(other.error());
    return other->toString().toStdString();
}

enum class Secret { Password, Code, Either };

/// A password is compared once, whoever it is: with his, or with another's. A code is compared quickly, whoever it is.
core::Result<Account> tryAccount(const School& school, const std::string& username, const std::string& secret,
                                 Secret kind)
{
    const std::string hash = nameHash(username);
    const auto wait = waitFor(school, hash);
    if (!wait)
        return tl::unexpected(wait.error());
    if (wait->count() > 0) {
        const auto seconds = std::chrono::ceil<std::chrono::seconds>(*wait).count();
        return core::unexpected(ErrorCode::TooSoon, "too many logins have failed; wait " + std::to_string(seconds) +
                                                        (seconds == 1 ? " second" : " seconds") + " and try again");
    }
    auto account = accountOf(school, username);
    if (!account)
        return account;
    bool isRight = false;
    if (kind != Secret::Code) {
        const auto other = otherPassword(school, hash);
        if (!other)
            return tl::unexpected(other.error());
        const std::string& own = account->passwordHash;
        const auto same = fits(secret, own.empty() ? *other : own);
        if (!same)
            return tl::unexpected(same.error());
        isRight = *same && !own.empty();
    }
    if (!isRight && kind != Secret::Password) {
        const bool isOver = account->codeUntilUtc < school.now();
        isRight = !isOver && !account->codeHash.empty() &&
                  hashOfCode(account->person->uid, codeOf(secret)) == account->codeHash;
        account->isByCode = isRight;
    }
    if (!isRight || account->person->disabled) {
        if (auto noted = noteFailure(school, hash); !noted)
            return tl::unexpected(noted.error());
        return tl::unexpected(wrongLogin());
    }
    return account;
}

core::Status setPassword(const School& school, const Person& person, const std::string& password)
{
    const auto cost = passwordCost(school);
    if (!cost)
        return tl::unexpected(cost.error());
    const auto hash = hashPassword(password, *cost);
    if (!hash)
        return tl::unexpected(hash.error());
    return execute(school.db, "UPDATE people SET password_hash = ?, reset_hash = '', reset_until_utc = '' WHERE id = ?",
                   "set the password", {text(*hash), static_cast<qlonglong>(person.id.value)});
}

/// What passwords cost from now on, and what nobody's is compared with: it takes as long.
core::Status keepCost(const School& school, const std::string& actor, const PasswordCost& cost,
                      const std::string& decoy)
{
    for (const auto& [name, value] : {std::pair(kPasses, std::to_string(cost.passes)),
                                      std::pair(kMemory, std::to_string(cost.memoryBytes)), std::pair(kDecoy, decoy)})
        if (auto kept = putSetting(school, actor, name.toStdString(), value); !kept)
            return kept;
    return {};
}

}  // namespace

core::Result<PasswordCost> passwordCost(const School& school)
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
    return cost;
}

core::Status raisePasswordCost(const School& school, const Session& session, const PasswordCost& cost)
{
    if (auto may = admit(school, session, Operation::ChangeSettings); !may)
        return tl::unexpected(may.error());
    const auto present = passwordCost(school);
    if (!present)
        return tl::unexpected(present.error());
    if (cost.passes < 2 * present->passes || cost.memoryBytes < present->memoryBytes)
        return {};
    // Who is compared with nobody's password shall wait as long.
    const auto decoy = hashPassword(newUid(), cost);
    if (!decoy)
        return tl::unexpected(decoy.error());
    return inTurn(school, "raise what passwords cost", [&] { return keepCost(school, session.uid(), cost, *decoy); });
}

std::string Logins::nameInAudit(const std::string& username)
{
    return nameHash(username).substr(0, kNameInAudit);
}

core::Status Logins::checkNewPassword(const std::string& password, const std::string& username)
{
    if (auto fit = checkPassword(password, username); !fit)
        return fit;
    if (looksLikeCode(password))
        return core::unexpected(ErrorCode::OutOfRange, "the password looks like a one-time code; choose another one");
    return {};
}

core::Result<bool> Logins::isNew(const School& school)
{
    const auto somebody = ask(school.db, "SELECT 1 FROM people LIMIT 1", "see who works here");
    if (!somebody)
        return tl::unexpected(somebody.error());
    return somebody->isNull();
}

core::Result<Session> Logins::createFirstAdmin(const School& school, const NewPerson& who, const std::string& password,
                                               const PasswordCost& cost)
{
    const std::string doing = "enter the first admin";
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
        // First: the first row of the audit tells schools apart.
        if (auto done = enter(school, "system", admin, *hash); !done)
            return tl::unexpected(done.error());
        return keepCost(school, "system", cost, *decoy);
    });
    if (!entered)
        return tl::unexpected(entered.error());
    return login(school, who.username, password);
}

core::Result<Session> Logins::login(const School& school, const std::string& username, const std::string& password)
{
    // A password may be twelve letters, too.
    const Secret kind = looksLikeCode(password)      ? Secret::Code
                        : isCodeParted(password, "") ? Secret::Either
                                                     : Secret::Password;
    auto account = tryAccount(school, username, password, kind);
    if (!account)
        return tl::unexpected(account.error());
    if (account->isByCode)
        return core::unexpected(ErrorCode::NewPassword, "the code is right; choose a password");
    const Person& person = *account->person;
    const auto cost = passwordCost(school);
    if (!cost)
        return tl::unexpected(cost.error());
    std::string rehashed;
    if (wantsRehash(account->passwordHash, *cost))
        rehashed = hashPassword(password, *cost).value_or(std::string());
    const auto doing = kLogIn;
    auto entered = inTurn(school, doing, [&]() -> core::Status {
        const qlonglong id = person.id.value;
        if (!rehashed.empty())
            if (auto raised =
                    execute(school.db, "UPDATE people SET password_hash = ? WHERE id = ?", doing, {text(rehashed), id});
                !raised)
                return raised;
        if (auto seen = execute(school.db, "UPDATE people SET last_login_utc = ? WHERE id = ?", doing,
                                {text(school.now()), id});
            !seen)
            return seen;
        if (auto forgiven =
                execute(school.db, "DELETE FROM failed_logins WHERE name_hash = ?", doing, {text(nameHash(username))});
            !forgiven)
            return forgiven;
        return note(school, person.uid, "login", "person:" + person.uid);
    });
    if (!entered)
        return tl::unexpected(entered.error());
    Session session;
    session.m_person = person.id;
    session.m_uid = person.uid;
    session.m_username = person.username;
    session.m_fullName = person.fullName().empty() ? person.username : person.fullName();
    session.m_role = person.role;
    return session;
}

core::Result<Session> Logins::redeem(const School& school, const std::string& username, const std::string& code,
                                     const std::string& newPassword)
{
    if (auto fit = checkNewPassword(newPassword, username); !fit)
        return tl::unexpected(fit.error());
    auto account = tryAccount(school, username, code, Secret::Code);
    if (!account)
        return tl::unexpected(account.error());
    auto set = inTurn(school, "set the password", [&]() -> core::Status {
        // Two stations at once: the code is good for one of them.
        const auto still = ask(school.db, "SELECT reset_hash FROM people WHERE id = ?" + dialect::forUpdate(school.db),
                               "set the password", {static_cast<qlonglong>(account->person->id.value)});
        if (!still)
            return tl::unexpected(still.error());
        if (still->toString().toStdString() != account->codeHash)
            return tl::unexpected(wrongLogin());
        if (auto done = setPassword(school, *account->person, newPassword); !done)
            return done;
        return note(school, account->person->uid, "password.code", "person:" + account->person->uid);
    });
    if (!set)
        return tl::unexpected(set.error());
    return login(school, username, newPassword);
}

core::Status Logins::logout(const School& school, const Session& session)
{
    if (session.isGuest())
        return {};
    return inTurn(school, "log out", [&] { return note(school, session.uid(), "logout", "person:" + session.uid()); });
}

core::Status Logins::changePassword(const School& school, const Session& session, const std::string& old,
                                    const std::string& newPassword)
{
    if (auto who = admit(school, session, Operation::ChangeOwnPassword); !who)
        return tl::unexpected(who.error());
    if (auto fit = checkNewPassword(newPassword, session.username()); !fit)
        return fit;
    auto account = tryAccount(school, session.username(), old, Secret::Password);
    if (!account)
        return tl::unexpected(account.error());
    return inTurn(school, "set the password", [&]() -> core::Status {
        if (auto done = setPassword(school, *account->person, newPassword); !done)
            return done;
        return note(school, session.uid(), "password.change", "person:" + session.uid());
    });
}

}  // namespace database::sql
