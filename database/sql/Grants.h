// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <QString>

#include "core/base/Result.h"

/// Stations of a school on PostgreSQL can log in with an account that owns nothing there. What it may do is written in
/// grants.sql: by tables, columns and functions, and by the person who has logged in.
namespace database::sql {

/// Returns the SQL that gives an account the rights of a station, for psql. OutOfRange if an account cannot have that
/// name.
[[nodiscard]] core::Result<QString> grantsFor(const QString& station);

/// Gives an account, which exists, the rights of a station, and takes them from any other. WrongKind if the database is
/// a file; ServerRefuses if this connection's account does not own the tables.
[[nodiscard]] core::Status applyGrants(const QSqlDatabase& db, const QString& station);

/// Removes the policies of the grants, so that a migration can change the columns that they name. Inside a transaction.
/// Until renewGrants(), stations read and write nothing.
[[nodiscard]] core::Status suspendGrants(const QSqlDatabase& db);

/// Applies the grants of a database again if they were made for another schema. Does nothing if there are none.
[[nodiscard]] core::Status renewGrants(const QSqlDatabase& db);

/// Checks that this connection may read everything. ServerRefuses for the account of a station: the
/// window then sends the user to the administrator of the server.
/// @param command  one to run with the account that owns the tables, "cusp db check"
[[nodiscard]] core::Status expectOwner(const QSqlDatabase& db, const std::string& command);

}  // namespace database::sql
