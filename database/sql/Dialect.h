// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <QSqlError>
#include <QString>

#include "core/base/Result.h"

namespace database::sql {

/// What SQLite and PostgreSQL disagree on, in one place. Every other line of SQL is the subset that they share.
namespace dialect {

/// "CUSP" as SQLite's application_id: tells our files from those of other programs. PostgreSQL's mark is the table
/// cusp_schema.
inline constexpr int kApplicationId = 0x43555350;

[[nodiscard]] bool isPostgres(const QSqlDatabase& db);

/// A migration's text with its braces filled in: {row_id}, {int64}, {blob}, {table_options}, and {append_only NAME},
/// which makes the database itself refuse to change or delete a row of that table.
[[nodiscard]] QString expand(const QSqlDatabase& db, QString sql);

/// Begins a transaction that writes. SQLite waits for other writers now, not at its end.
[[nodiscard]] QString beginWrite(const QSqlDatabase& db);
/// Begins a transaction that reads everything as it was at its first SELECT, and holds nobody up.
[[nodiscard]] QString beginRead(const QSqlDatabase& db);
/// Goes behind a SELECT whose rows nobody else may take until the transaction ends.
[[nodiscard]] QString forUpdate(const QSqlDatabase& db);
/// Lets one migration run at a time, until the transaction ends; empty where beginWrite() does.
/// @param isThere  a schema, of whichever version
[[nodiscard]] QString lockSchema(const QSqlDatabase& db, bool isThere);
/// The same for what is noted in the audit. Who then does nothing for three seconds loses his connection.
[[nodiscard]] QString lockTurn(const QSqlDatabase& db);

/// Of a server: this connection finds the server's own functions before all others, and tables in the schema only in
/// which the school is, or would be made, whatever its role and its database are set to. Who owns those could else put
/// functions of his own in the place of the server's, and be found sound by them.
[[nodiscard]] core::Status pinSearchPath(const QSqlDatabase& db);

/// Number of the last migration applied; 0 on an empty database.
[[nodiscard]] core::Result<int> schemaVersion(const QSqlDatabase& db);
/// To be called inside the transaction of the migration.
[[nodiscard]] core::Status setSchemaVersion(const QSqlDatabase& db, int version);
/// Tables there are, of this program or another.
[[nodiscard]] core::Result<int> countTables(const QSqlDatabase& db);
/// After rows came with ids of their own: the next id is beyond them. On a server it needs no more rights than rows do.
[[nodiscard]] core::Status continueIds(const QSqlDatabase& db, const QString& table);

/// Of an SQLite file, for QSQLITE_OPEN_URI. Immutable: nobody changes it, and nothing is made beside it; never where a
/// part of it lies in a log.
[[nodiscard]] QString uriOf(const QString& file, bool isImmutable);
/// Of SQLite: where it lies, however it was opened.
[[nodiscard]] QString fileOf(const QSqlDatabase& db);

/// For people: the file, or the server's address.
[[nodiscard]] std::string nameOf(const QSqlDatabase& db);

/// A failed statement as a sentence: `doing` ("add the attempt"), the database's name, the cause and a way out.
[[nodiscard]] core::Error error(const QSqlDatabase& db, const QSqlError& error, const std::string& doing);

}  // namespace dialect
}  // namespace database::sql
