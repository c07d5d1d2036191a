// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <QSqlError>
#include <QString>

#include "core/base/Result.h"

namespace database::sql {

/// The differences between SQLite and PostgreSQL, in one place. All other SQL is the subset that both share.
namespace dialect {

/// "CUSP" as SQLite's application_id, which identifies databases of this program. In PostgreSQL, the table cusp_schema
/// identifies them.
inline constexpr int kApplicationId = 0x43555350;

[[nodiscard]] bool isPostgres(const QSqlDatabase& db);

/// Replaces the placeholders in a migration: {row_id}, {int64}, {blob}, {table_options}, and {append_only NAME}, which
/// makes the database refuse to change or delete rows of that table. {let_change NAME: CONDITION} then lets rows change
/// for which a condition on old and new values is met.
[[nodiscard]] QString expand(const QSqlDatabase& db, QString sql);

/// Returns the statement that begins a writing transaction. In SQLite it waits for other writers at its begin, not at
/// its end.
[[nodiscard]] QString beginWrite(const QSqlDatabase& db);
/// Returns the statement that begins a reading transaction. It sees the state at its first SELECT and blocks no other.
[[nodiscard]] QString beginRead(const QSqlDatabase& db);
/// Returns the suffix of a SELECT that locks its rows until the transaction ends.
[[nodiscard]] QString forUpdate(const QSqlDatabase& db);
/// Returns the statement that lets only one migration run at a time, until the transaction ends. Empty if beginWrite()
/// does that already.
/// @param isThere  the database has a schema of some version
[[nodiscard]] QString lockSchema(const QSqlDatabase& db, bool isThere);
/// Returns the statement that lets only one transaction with audit rows run at a time. If the station is then idle for
/// three seconds, the server closes its connection.
[[nodiscard]] QString lockTurn(const QSqlDatabase& db);

/// For a server: makes this connection look up functions in the server's own schema first, and tables only in the
/// schema that contains the school or will contain it. Overrides the settings of role and database: their owner could
/// otherwise replace the server's functions and so pass the check.
[[nodiscard]] core::Status pinSearchPath(const QSqlDatabase& db);

/// For a server: determines whether this connection's account is that of a station (database/sql/Grants.h), which reads
/// and writes some data by functions of the server only. Call it after pinSearchPath().
[[nodiscard]] core::Status recognizeStation(const QSqlDatabase& db);
/// Returns whether the connection uses the account of a station, as recognizeStation() has determined. Always false for
/// a file.
[[nodiscard]] bool isStation(const QSqlDatabase& db);

/// Returns the number of the last migration applied; 0 for an empty database.
[[nodiscard]] core::Result<int> schemaVersion(const QSqlDatabase& db);
/// Sets that number. Call inside the transaction of the migration.
[[nodiscard]] core::Status setSchemaVersion(const QSqlDatabase& db, int version);
/// Returns the number of tables, of this program or another.
[[nodiscard]] core::Result<int> countTables(const QSqlDatabase& db);
/// Sets the next id of a table to more than the largest id of its rows. On a server this needs no more permissions than
/// inserting rows.
[[nodiscard]] core::Status continueIds(const QSqlDatabase& db, const QString& table);

/// Overwrites the former content of rows in unused parts of an SQLite file and in its write-ahead log. Call it outside
/// transactions. Busy: another program is using the file. Does nothing on a server, whose own VACUUM does the same.
[[nodiscard]] core::Status overwriteUnused(const QSqlDatabase& db);

/// Returns the URI of an SQLite file, for QSQLITE_OPEN_URI. Immutable: the file does not change, and SQLite creates no
/// files beside it. Do not use that if the database has a write-ahead log.
[[nodiscard]] QString uriOf(const QString& file, bool isImmutable);
/// Returns the path of an open SQLite database.
[[nodiscard]] QString fileOf(const QSqlDatabase& db);

/// Returns the file, or the server's address, for display.
[[nodiscard]] std::string nameOf(const QSqlDatabase& db);

/// Returns the error for a failed statement: one sentence with `doing` ("add the attempt"), the name of the database,
/// the cause and a remedy.
[[nodiscard]] core::Error error(const QSqlDatabase& db, const QSqlError& error, const std::string& doing);

}  // namespace dialect
}  // namespace database::sql
