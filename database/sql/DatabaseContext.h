// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QDateTime>
#include <QSqlDatabase>

#include "core/base/Result.h"
#include "database/Login.h"
#include "database/Passwords.h"
#include "database/StationKey.h"

namespace database::sql {

/// The environment of every operation on a school's data. Belongs to the thread of its connection.
struct DatabaseContext
{
    QSqlDatabase db;  ///< of a Database, which must outlive this
    StationKey key;
    std::function<QDateTime()> nowUtc = [] { return QDateTime::currentDateTimeUtc(); };
    /// Lowest cost of password hashes, whatever the database says; lower in tests.
    PasswordCost leastCost = {};

    /// "2026-11-20T10:15:00Z"
    [[nodiscard]] std::string now() const;
};

/// Returns a clock that is set by the server's clock once: a wrong clock of a station must not block logins or extend
/// the validity of a code. For a file, or if the server returns no time, it is this computer's clock.
[[nodiscard]] std::function<QDateTime()> clockOf(const QSqlDatabase& db);

/// Checks a time. OutOfRange if it cannot be stored because the clock is thousands of years off.
[[nodiscard]] core::Status checkClock(const QDateTime& nowUtc);

/// A person's permission for an operation.
struct AuthorizedUser
{
    Role role = Role::Guest;
    Reach reach = Reach::Nothing;
};

/// Checks whether the user's current role permits an operation. NotAllowed if it does not, Disabled for a disabled
/// account. The caller must compare the owner of the data with the returned reach.
[[nodiscard]] core::Result<AuthorizedUser> authorize(const DatabaseContext& school, const Login& session,
                                                     Operation operation);

/// Like authorize(), for data of one person. Does not allow instructors to grade their own attempts.
[[nodiscard]] core::Result<AuthorizedUser> authorizeFor(const DatabaseContext& school, const Login& session,
                                                        Operation operation, PersonId owner);
/// Like authorize(), for data of one class.
[[nodiscard]] core::Result<AuthorizedUser> authorizeForClass(const DatabaseContext& school, const Login& session,
                                                             Operation operation, ClassId ofClass);

/// Returns the query for the id of the person with a uid (its one "?"): a station may deliver for everybody, but not
/// read everybody's row.
[[nodiscard]] QString personByUid(const QSqlDatabase& db);

/// Returns SQL, in parentheses, for the people of all classes of a person (bound to its one "?"), including that
/// person.
[[nodiscard]] QString classmates();

}  // namespace database::sql
