// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/StationLogins.h"

#include "database/sql/Statement.h"

namespace database::sql::station {
namespace {

const std::string kLogIn = "log in";
const std::string kSetPassword = "set the password";

core::Error changedSince()
{
    return {core::ErrorCode::WrongLogin, "the password or code has been changed meanwhile; try again"};
}

}  // namespace

core::Result<Salt> saltOf(const QSqlDatabase& db, const std::string& username)
{
    Salt salt;
    if (auto read = forEach(db, "SELECT uid, salt FROM cusp_salt(?)", kLogIn, {text(username)},
                            [&](const QSqlQuery& row) {
                                salt = {textOf(row, 0), textOf(row, 1)};
                            });
        !read)
        return tl::unexpected(read.error());
    return salt;
}

core::Result<std::optional<Person>> personBy(const QSqlDatabase& db, const std::string& username,
                                             const std::string& passwordHash)
{
    std::optional<Person> person;
    if (auto read = forEach(db, "SELECT id, uid, username, given_name, family_name, role FROM cusp_account(?, ?)",
                            kLogIn, {text(username), text(passwordHash)},
                            [&](const QSqlQuery& row) {
                                person.emplace();
                                person->id = {row.value(0).toLongLong()};
                                person->uid = textOf(row, 1);
                                person->username = textOf(row, 2);
                                person->givenName = textOf(row, 3);
                                person->familyName = textOf(row, 4);
                                person->role = roleOf(textOf(row, 5)).value_or(Role::Student);
                            });
        !read)
        return tl::unexpected(read.error());
    return person;
}

core::Result<bool> isCode(const QSqlDatabase& db, const std::string& username, const std::string& codeHash)
{
    return ask(db, "SELECT cusp_is_code(?, ?)", kLogIn, {text(username), text(codeHash)}).map([](const QVariant& is) {
        return is.toBool();
    });
}

core::Result<std::string> logIn(const QSqlDatabase& db, const std::string& username, const std::string& passwordHash,
                                const std::string& dearer)
{
    const auto token =
        ask(db, "SELECT cusp_login(?, ?, ?)", kLogIn, {text(username), text(passwordHash), text(dearer)});
    if (!token)
        return tl::unexpected(token.error());
    if (token->isNull())
        return tl::unexpected(changedSince());
    return token->toString().toStdString();
}

core::Status redeem(const QSqlDatabase& db, const std::string& username, const std::string& codeHash,
                    const std::string& newHash)
{
    const auto token =
        ask(db, "SELECT cusp_redeem(?, ?, ?)", kSetPassword, {text(username), text(codeHash), text(newHash)});
    if (!token)
        return tl::unexpected(token.error());
    return token->isNull() ? core::Status(tl::unexpected(changedSince())) : core::Status();
}

core::Status setPassword(const QSqlDatabase& db, const std::string& username, const std::string& passwordHash,
                         const std::string& newHash)
{
    const auto isSet =
        ask(db, "SELECT cusp_set_password(?, ?, ?)", kSetPassword, {text(username), text(passwordHash), text(newHash)});
    if (!isSet)
        return tl::unexpected(isSet.error());
    return isSet->toBool() ? core::Status() : core::Status(tl::unexpected(changedSince()));
}

core::Result<bool> resume(const QSqlDatabase& db, const std::string& token)
{
    return ask(db, "SELECT id FROM cusp_resume(?) WHERE disabled = 0", kLogIn, {text(token)})
        .map([](const QVariant& person) { return !person.isNull(); });
}

core::Status logOut(const QSqlDatabase& db)
{
    return execute(db, "SELECT cusp_logout()", "log out");
}

}  // namespace database::sql::station
