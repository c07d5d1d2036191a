// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QSqlDatabase>

#include "core/base/Result.h"
#include "database/IntegrityIssue.h"

namespace database::sql {

using database::CheckReport;
using database::kMostFindings;

/// Checks the whole database and does not write: tables and triggers; pages and keys (SQLite); the audit's chain up to
/// its signed head or the first invalid row; each attempt against its audit row; other tables against the audit (see
/// compareWithAudit()); score sheets, standings and recordings.
/// @param witnesses  audit codes of printed reports
/// @param stationKey  public key of the only computer that may have written the database, 64 hex digits; empty: several
///                    may
/// @param progress  called with the part being checked and its rows so far; false cancels
[[nodiscard]] core::Result<CheckReport>
checkDatabase(const QSqlDatabase& db, const std::vector<std::string>& witnesses,
              const std::function<bool(const char* what, std::int64_t rows)>& progress = {},
              const std::string& stationKey = {});

}  // namespace database::sql
