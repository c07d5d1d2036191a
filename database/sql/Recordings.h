// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QByteArray>

#include "core/base/Result.h"
#include "database/sql/DatabaseContext.h"

/// The recordings of attempts, each named by the hash of its bytes and never changed. On a server they are in the table
/// "recordings". With a file they are in the folder "recordings/" beside it, so that a backup of the database does not
/// have to copy them.
namespace database::sql {

/// Stores a recording and returns its hash. The recording is on the disk when this returns. Equal recordings are stored
/// once. Call it inside the transaction of its attempt.
[[nodiscard]] core::Result<std::string> putRecording(const DatabaseContext& school, const QByteArray& bytes);

/// Returns a recording. FileMissing: it does not exist. BadStructure: its bytes were changed.
[[nodiscard]] core::Result<QByteArray> recordingOf(const QSqlDatabase& db, const std::string& hash);

/// Returns the hashes of all recordings that attempts refer to, without duplicates.
[[nodiscard]] core::Result<std::vector<std::string>> recordingsNamed(const QSqlDatabase& db);

}  // namespace database::sql
