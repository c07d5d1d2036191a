// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Writes every attempt that the user may read as CSV (RFC 4180, UTF-8, numbers in the C locale), oldest first. Writes
/// one line at a time, so that memory does not grow with the number of attempts. Recorded in the audit. Returns the
/// number of attempts.
/// @param write  called with each line including its end; returns false to cancel, with error FileUnwritable
[[nodiscard]] core::Result<std::int64_t> exportAttempts(const DatabaseContext& school, const Login& session,
                                                        const std::function<bool(std::string_view line)>& write);

/// Records in the audit that a table or a report of a class is exported. Teachers of the class and admins.
[[nodiscard]] core::Status noteClassExport(const DatabaseContext& school, const Login& session, ClassId ofClass);

}  // namespace database::sql
