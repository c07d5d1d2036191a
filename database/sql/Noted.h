// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QSqlDatabase>

#include "core/base/Result.h"
#include "database/Finding.h"

namespace database::sql {

/// Compares with the audit what it notes of other tables: whose attempts are, overrides, comments and which were taken
/// back and when, what people are and are called, their passwords and one-time codes, who is in which class, what
/// classes were given and by whom, presets and who made them, the school's settings.
/// @param lacksNotes  the audit has lost rows: what it says nothing of may be sound
/// @param say  is told each thing that is not as it was noted
[[nodiscard]] core::Status compareWithAudit(const QSqlDatabase& db, bool lacksNotes,
                                            const std::function<void(const Finding&)>& say);

/// What is found of a thing, "%1", that the audit says nothing of.
[[nodiscard]] const char* wordsOfUnnoted(bool lacksNotes);

}  // namespace database::sql
