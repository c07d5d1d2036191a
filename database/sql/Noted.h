// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QSqlDatabase>

#include "core/base/Result.h"
#include "database/IntegrityIssue.h"

namespace database::sql {

/// Compares tables with the rows of the audit: overrides, comments, people and their login data, classes, enrolments,
/// assignments, presets, the school's settings, exams that were begun.
/// @param say  called for each row that differs
[[nodiscard]] core::Status compareWithAudit(const QSqlDatabase& db,
                                            const std::function<void(const IntegrityIssue&)>& say);

}  // namespace database::sql
