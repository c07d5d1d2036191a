// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Called with the table and its rows so far; returns false to cancel.
using CopyProgress = std::function<bool(const QString& table, std::int64_t rows)>;

struct CopyReport
{
    std::int64_t rows = 0;
    std::int64_t recordings = 0;
    std::int64_t recordingsMissing = 0;  ///< missing or damaged in the source
};

/// Copies a school with its recordings into an empty database of either engine, in one transaction. Creates the schema
/// if there is none. Verifies that the copy has the same rows, by a sum of their hashes, and reads each recording back.
/// Recorded in the audit. If it fails, recordings written beside a file stay, and the next copy uses them. OutOfRange
/// if the target contains a school.
/// @param session  of an admin of `from`
[[nodiscard]] core::Result<CopyReport> copySchool(const DatabaseContext& from, const Login& session,
                                                  const DatabaseContext& to, const CopyProgress& progress = {});

}  // namespace database::sql
