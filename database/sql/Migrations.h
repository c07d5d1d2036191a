// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <QSqlDatabase>
#include <QString>

#include "core/base/Result.h"

namespace database::sql {

/// One step of the schema: statements that end with ";" at the end of a line, never edited once released.
struct Migration
{
    int number = 0;  ///< 1, 2, 3 ...
    QString sql;
};

/// The steps this program ships (resources of database/migrations), in order.
[[nodiscard]] core::Result<std::vector<Migration>> shippedMigrations();

/// Makes it where nothing is, inside a transaction of the caller's.
[[nodiscard]] core::Status applyAll(const QSqlDatabase& db, std::span<const Migration> steps);

/// Brings the database to the newest schema, one transaction per step: a step that breaks leaves the file as it was.
/// A file newer than us is refused, not guessed at. The caller has made a backup copy.
[[nodiscard]] core::Status migrate(const QSqlDatabase& db, std::span<const Migration> steps);

}  // namespace database::sql
