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

/// What a thorough look at a database finds.
struct CheckReport
{
    std::vector<IntegrityIssue> findings;  ///< empty: it is sound
    std::vector<IntegrityIssue> notes;     ///< how to read them
    std::int64_t attempts = 0;
    std::int64_t auditRows = 0;
    std::string auditCode;                     ///< of the newest row, as reports show it
    std::string signedBy;                      ///< key of the station that wrote that row, 64 hex digits
    bool isStopped = false;                    ///< not all was looked at
    bool isWhole = true;                       ///< false: not all could be looked at, as the last finding says
    std::size_t mostFindings = kMostFindings;  ///< further ones are not told
};

/// Looks at everything: tables and triggers, pages and keys (SQLite), the audit's chain and signed head up to the first
/// row that does not hold, whether each attempt is as the audit says it was when it was kept, what else the audit notes
/// (see compareWithAudit()), score sheets and standings, recordings. Does not write.
/// @param witnesses  audit codes of printed reports
/// @param stationKey  of the only computer that may have written it, 64 hex digits; empty: there are several
/// @param progress  what is looked at, and how many rows of it so far; false stops it
[[nodiscard]] core::Result<CheckReport>
checkDatabase(const QSqlDatabase& db, const std::vector<std::string>& witnesses,
              const std::function<bool(const char* what, std::int64_t rows)>& progress = {},
              const std::string& stationKey = {});

}  // namespace database::sql
