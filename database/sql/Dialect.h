// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <QSqlError>
#include <QString>

#include "core/base/Result.h"

namespace database::sql {

/// What the databases disagree on, in one place. Every other line of SQL is the subset that SQLite and PostgreSQL
/// share; only SQLite is served so far.
namespace dialect {

/// "CUSP" as SQLite's application_id: tells our files from those of other programs.
inline constexpr int kApplicationId = 0x43555350;

/// A migration's text with its braces filled in: {row_id}, {int64}, {table_options}.
[[nodiscard]] QString expand(QString sql);

/// Begins a transaction that writes: waits for other writers now, not at its end.
[[nodiscard]] QString beginWrite();

/// Number of the last migration applied; 0 on an empty database.
[[nodiscard]] core::Result<int> schemaVersion(QSqlDatabase& db);
/// To be called inside the transaction of the migration.
[[nodiscard]] core::Status setSchemaVersion(QSqlDatabase& db, int version);

/// A failed statement as a sentence: `doing` ("add the attempt"), the database's file, the cause and a way out.
[[nodiscard]] core::Error error(const QSqlDatabase& db, const QSqlError& error, const std::string& doing);

}  // namespace dialect
}  // namespace database::sql
