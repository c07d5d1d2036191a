// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>

#include "core/base/Result.h"
#include "database/Address.h"
#include "database/sql/Backups.h"
#include "database/sql/School.h"

/// Backups of a school that is in use: while others write, on the thread of the connection.
namespace app {

/// Whether a school's file has no backup of today (UTC) in its own folder. A server never: its administrator makes
/// them.
[[nodiscard]] bool isBackupDue(const database::Address& address, const QDateTime& nowUtc);

struct MadeBackup
{
    QString file;
    bool isAuditWhole = true;  ///< false: somebody has changed it; older backups in which it is whole were kept
};
/// Makes a backup, thins the older ones, and throws away the attempts of this station that lay by until two
/// whole backups had them.
/// @param stationFolder  of this station's own files
[[nodiscard]] core::Result<MadeBackup> makeBackup(const database::sql::School& school, const database::Address& address,
                                                  const QString& stationFolder, const QDateTime& nowUtc,
                                                  const database::sql::BackupProgress& progress = {});

}  // namespace app
