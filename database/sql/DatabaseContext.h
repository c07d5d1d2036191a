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

/// What every operation on a school's data works with. Belongs to the thread of its connection.
struct DatabaseContext
{
    QSqlDatabase db;  ///< of a Database, which outlives it
    StationKey key;
    std::function<QDateTime()> nowUtc = [] { return QDateTime::currentDateTimeUtc(); };
    /// What a password costs at least, whatever the database says; tests pay less.
    PasswordCost leastCost = {};

    /// "2026-11-20T10:15:00Z"
    [[nodiscard]] std::string now() const;
};

/// The clock of the server, asked once: a station whose clock is wrong shall neither lock a name out nor make a code
/// last. Of a file, and where the server does not say, this computer's.
[[nodiscard]] std::function<QDateTime()> clockOf(const QSqlDatabase& db);

/// OutOfRange for a time that cannot be noted, of a clock that is wrong by thousands of years.
[[nodiscard]] core::Status checkClock(const QDateTime& nowUtc);

/// A person, as the rules see him.
struct AuthorizedUser
{
    Role role = Role::Guest;
    Reach reach = Reach::Nothing;
};

/// Whether the session's person may do this at all, by the role he has now; NotAllowed if not, or if he was disabled.
/// Whose data it may be is for the operation to look at: the reach says how far.
[[nodiscard]] core::Result<AuthorizedUser> authorize(const DatabaseContext& school, const Login& session,
                                                     Operation operation);

/// As authorize(), for something that belongs to one person. To mark is not allowed on what is one's own.
[[nodiscard]] core::Result<AuthorizedUser> authorizeFor(const DatabaseContext& school, const Login& session,
                                                        Operation operation, PersonId owner);
/// As authorize(), for something that belongs to one class.
[[nodiscard]] core::Result<AuthorizedUser> authorizeForClass(const DatabaseContext& school, const Login& session,
                                                             Operation operation, ClassId ofClass);

/// The people of all classes that a person (bound to its one "?") belongs to, himself included: SQL, in brackets.
[[nodiscard]] QString classmates();

}  // namespace database::sql
