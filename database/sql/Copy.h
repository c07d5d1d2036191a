// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Table and rows of it so far; returns false to stop.
using CopyProgress = std::function<bool(const QString& table, std::int64_t rows)>;

struct CopyReport
{
    std::int64_t rows = 0;
    std::int64_t recordings = 0;
    std::int64_t recordingsMissing = 0;  ///< or damaged, already in what was copied
};

/// Brings everything of a school into an empty database of either engine, recordings included, in one transaction that
/// makes the schema, too, if there is none. Verifies it: the same rows in both, by a sum of their hashes, and each
/// recording read back. Recordings that were written beside a file stay there if it fails; the next copy uses them.
/// OutOfRange if the target holds a school already. Noted in the audit.
/// @param session  an admin's of `from`
[[nodiscard]] core::Result<CopyReport> copySchool(const DatabaseContext& from, const Login& session,
                                                  const DatabaseContext& to, const CopyProgress& progress = {});

}  // namespace database::sql
