// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <QSqlDatabase>

#include "core/base/Result.h"
#include "database/IntegrityIssue.h"

namespace database::sql {

inline constexpr std::size_t kMostFindings = 100;

/// The result of a check of a database.
struct CheckReport
{
    std::vector<IntegrityIssue> findings;  ///< empty: the database is sound
    std::vector<IntegrityIssue> notes;     ///< explanations of the findings
    std::int64_t attempts = 0;
    std::int64_t auditRows = 0;
    std::string auditCode;                     ///< of the newest row, as on reports
    std::string signedBy;                      ///< public key of the station that wrote that row, 64 hex digits
    bool isStopped = false;                    ///< cancelled before the end
    bool isWhole = true;                       ///< false: parts could not be checked, as the last finding says
    std::size_t mostFindings = kMostFindings;  ///< limit; further findings are dropped
};

/// Checks the whole database: tables and triggers, pages and keys (SQLite), the audit's chain and signed head up to the
/// first invalid row, each attempt against its audit row, other tables against the audit (see compareWithAudit()),
/// score sheets and standings, recordings. Does not write.
/// @param witnesses  audit codes of printed reports
/// @param stationKey  public key of the only computer that may have written it, 64 hex digits; empty: there are several
/// @param progress  called with the part being checked and its rows so far; false cancels
[[nodiscard]] core::Result<CheckReport>
checkDatabase(const QSqlDatabase& db, const std::vector<std::string>& witnesses,
              const std::function<bool(const char* what, std::int64_t rows)>& progress = {},
              const std::string& stationKey = {});

}  // namespace database::sql
