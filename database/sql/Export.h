// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Writes every attempt within the session's reach as CSV (RFC 4180, UTF-8, numbers as in C), oldest first, one line at
/// a time: memory does not grow with the number of attempts. Noted in the audit. Returns how many there were.
/// @param write  takes a line with its end; returns false to stop, which is FileUnwritable
[[nodiscard]] core::Result<std::int64_t> exportAttempts(const DatabaseContext& school, const Login& session,
                                                        const std::function<bool(std::string_view line)>& write);

/// Into the audit: that a table or a report of a class is taken out of the school. Its teachers, and admins.
[[nodiscard]] core::Status noteClassExport(const DatabaseContext& school, const Login& session, ClassId ofClass);

}  // namespace database::sql
