// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QByteArray>

#include "core/base/Result.h"
#include "database/sql/DatabaseContext.h"

/// The recordings of attempts, each under the hash of its bytes, never changed. On a server they are in the table
/// "recordings"; beside a file they are files in "recordings/", so that a backup of the database need not copy them
/// again and again.
namespace database::sql {

/// Keeps a recording, on the disk when this returns, and returns its hash; the same again costs nothing. To be called
/// inside the transaction of its attempt.
[[nodiscard]] core::Result<std::string> putRecording(const DatabaseContext& school, const QByteArray& bytes);

/// FileMissing: it is not there. BadStructure: it is not what was put there.
[[nodiscard]] core::Result<QByteArray> recordingOf(const QSqlDatabase& db, const std::string& hash);

/// The hashes of all that attempts tell of, each once.
[[nodiscard]] core::Result<std::vector<std::string>> recordingsNamed(const QSqlDatabase& db);

}  // namespace database::sql
