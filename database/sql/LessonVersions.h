// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include <QByteArray>

#include "database/IntegrityIssue.h"
#include "database/sql/DatabaseContext.h"

/// The versions of lessons that were assigned (lessons/LessonVersion.h). A version is stored once and never changed.
namespace database::sql {

/// Stores the version that an assignment names. Call it inside the transaction of the assignment. OutOfRange: the
/// version is not stored yet and `pack` is empty, or the pack is of another lesson.
/// @param hash  of the lesson
/// @param pack  empty if the version is stored already
[[nodiscard]] core::Status putVersion(const DatabaseContext& school, const std::string& lessonId,
                                      const std::string& hash, const QByteArray& pack);

/// Returns the pack of a version that was assigned to a class of the user. UnknownName: it was not.
[[nodiscard]] core::Result<QByteArray> versionPack(const DatabaseContext& school, const Login& session,
                                                   const std::string& hash);

/// Calls `say` for each stored version whose content does not have its hash.
[[nodiscard]] core::Status checkVersions(const QSqlDatabase& db, const std::function<void(const IntegrityIssue&)>& say);

}  // namespace database::sql
