// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <QSqlError>
#include <QString>

#include "core/base/Result.h"

namespace database::sql {

/// The differences between SQLite and PostgreSQL, in one place. All other SQL is the subset that both share.
namespace dialect {

/// "CUSP" as SQLite's application_id, which identifies our files. In PostgreSQL the table cusp_schema does.
inline constexpr int kApplicationId = 0x43555350;

[[nodiscard]] bool isPostgres(const QSqlDatabase& db);

/// Replaces the placeholders in a migration: {row_id}, {int64}, {blob}, {table_options}, and {append_only NAME}, which
/// makes the database refuse to change or delete rows of that table.
[[nodiscard]] QString expand(const QSqlDatabase& db, QString sql);

/// Returns the statement that begins a writing transaction. SQLite waits for other writers at its start, not at its
/// end.
[[nodiscard]] QString beginWrite(const QSqlDatabase& db);
/// Returns the statement that begins a reading transaction, which sees the state at its first SELECT and blocks nobody.
[[nodiscard]] QString beginRead(const QSqlDatabase& db);
/// Returns the suffix of a SELECT that locks its rows until the transaction ends.
[[nodiscard]] QString forUpdate(const QSqlDatabase& db);
/// Returns the statement that lets one migration run at a time, until the transaction ends; empty if beginWrite() does.
/// @param isThere  a schema of some version exists
[[nodiscard]] QString lockSchema(const QSqlDatabase& db, bool isThere);
/// Returns the statement that lets one transaction with audit rows run at a time. A connection that is then idle for
/// three seconds is closed.
[[nodiscard]] QString lockTurn(const QSqlDatabase& db);

/// For a server: makes this connection find the server's own functions before all others, and tables only in the schema
/// of the school, or in which it would be created, whatever the settings of role and database. Otherwise the owner of
/// those could replace the server's functions by others and pass the check.
[[nodiscard]] core::Status pinSearchPath(const QSqlDatabase& db);

/// Returns the number of the last migration applied; 0 for an empty database.
[[nodiscard]] core::Result<int> schemaVersion(const QSqlDatabase& db);
/// Sets that number. Call inside the transaction of the migration.
[[nodiscard]] core::Status setSchemaVersion(const QSqlDatabase& db, int version);
/// Returns the number of tables, of this program or another.
[[nodiscard]] core::Result<int> countTables(const QSqlDatabase& db);
/// Sets the next id of a table beyond those of inserted rows. On a server it needs no more permissions than inserting
/// rows.
[[nodiscard]] core::Status continueIds(const QSqlDatabase& db, const QString& table);

/// Returns the URI of an SQLite file, for QSQLITE_OPEN_URI. Immutable: the file does not change and SQLite creates no
/// file beside it; do not use it if part of the data is in a log.
[[nodiscard]] QString uriOf(const QString& file, bool isImmutable);
/// Returns the path of an open SQLite database.
[[nodiscard]] QString fileOf(const QSqlDatabase& db);

/// Returns the file, or the server's address, for display.
[[nodiscard]] std::string nameOf(const QSqlDatabase& db);

/// Returns the error for a failed statement: one sentence with `doing` ("add the attempt"), the database's name, the
/// cause and a remedy.
[[nodiscard]] core::Error error(const QSqlDatabase& db, const QSqlError& error, const std::string& doing);

}  // namespace dialect
}  // namespace database::sql
