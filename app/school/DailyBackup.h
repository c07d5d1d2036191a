// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDateTime>
#include <QString>

#include "core/base/Result.h"
#include "database/Address.h"
#include "database/Login.h"
#include "database/Repositories.h"
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
/// The same in the name of an admin, noted in the audit.
[[nodiscard]] core::Result<QString> makeBackup(const database::Repositories& school, const database::Login& who,
                                               const database::Address& address, const QString& stationFolder,
                                               const QDateTime& nowUtc,
                                               const database::MaintenanceRepository::GoesOn& goesOn);

/// A backup in the folder of a database.
struct BackupFile
{
    QString path;
    QDateTime madeUtc;
    qint64 bytes = 0;
};
/// The backups of a database file that hold a school, newest first. Any thread.
[[nodiscard]] std::vector<BackupFile> backupsOf(const database::Address& address);

/// Whether a file is a whole backup of a school: takes long. Any thread.
[[nodiscard]] core::Status checkBackup(const QString& file);

}  // namespace app
