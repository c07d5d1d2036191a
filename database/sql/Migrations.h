// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <QSqlDatabase>
#include <QString>

#include "core/base/Result.h"

namespace database::sql {

/// One step of the schema: statements that end with ";" at the end of a line. Never edited after its release.
struct Migration
{
    int number = 0;  ///< 1, 2, 3 ...
    QString sql;
};

/// Returns the migrations of this program (resources of database/migrations), in order.
[[nodiscard]] core::Result<std::vector<Migration>> shippedMigrations();

/// Returns the statements of a text, without its lines of comment. A statement ends with ";" at the end of a line that
/// is not between two "$$".
[[nodiscard]] QStringList statementsOf(const QString& sql);

/// Creates the schema in an empty database, inside a transaction of the caller.
[[nodiscard]] core::Status applyAll(const QSqlDatabase& db, std::span<const Migration> steps);

/// Migrates the database to the newest schema, one transaction per step: a step that fails changes nothing. A database
/// with a newer schema than the program's is an error. The caller must have made a backup.
[[nodiscard]] core::Status migrate(const QSqlDatabase& db, std::span<const Migration> steps);

}  // namespace database::sql
