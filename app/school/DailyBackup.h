// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>

#include "core/base/Result.h"
#include "database/Address.h"
#include "database/sql/Backups.h"
#include "database/sql/DatabaseContext.h"

/// Backups of a school that is in use: while others write, on the thread of the connection.
namespace app {

/// Whether a school's file has no backup of today (UTC) in its own folder. A server never: its administrator makes
/// them.
[[nodiscard]] bool isBackupDue(const database::Address& address, const QDateTime& nowUtc);

/// Makes a backup, removes the older ones that the rotation does not keep, and removes the sent attempts of this
/// station from its outbox that the backup holds. Returns the backup's file.
/// @param stationFolder  of this station's own files
[[nodiscard]] core::Result<QString> makeBackup(const database::sql::DatabaseContext& school,
                                               const database::Address& address, const QString& stationFolder,
                                               const QDateTime& nowUtc,
                                               const database::sql::BackupProgress& progress = {});

}  // namespace app
