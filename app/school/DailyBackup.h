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

/// Makes backups of a database while other programs write to it. Call the functions on the thread of the connection,
/// unless their comment says otherwise.
namespace app {

/// Returns whether a database file has no backup of today (UTC) in its backup folder. Returns false for a server: its
/// administrator makes the backups.
[[nodiscard]] bool isBackupDue(const database::Address& address, const QDateTime& nowUtc);

/// Makes a backup, removes older backups according to the rotation, and removes the attempts that the backup contains
/// from the outbox of this computer. Returns the path of the backup.
/// @param stationFolder  folder with this computer's own files
[[nodiscard]] core::Result<QString> makeBackup(const database::sql::DatabaseContext& school,
                                               const database::Address& address, const QString& stationFolder,
                                               const QDateTime& nowUtc,
                                               const database::sql::BackupProgress& progress = {});
/// Does the same in the name of an admin and records it in the audit.
[[nodiscard]] core::Result<QString> makeBackup(const database::Repositories& school, const database::Login& who,
                                               const database::Address& address, const QString& stationFolder,
                                               const QDateTime& nowUtc,
                                               const database::MaintenanceRepository::GoesOn& goesOn);

/// A backup in the backup folder of a database.
struct BackupFile
{
    QString path;
    QDateTime madeUtc;
    qint64 bytes = 0;
};
/// Returns the backups of a database file that contain a school, newest first. Any thread.
[[nodiscard]] std::vector<BackupFile> backupsOf(const database::Address& address);

/// Checks whether a file is a complete backup of a school, which takes long. Any thread.
[[nodiscard]] core::Status checkBackup(const QString& file);

}  // namespace app
