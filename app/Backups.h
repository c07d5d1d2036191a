// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>

#include "core/base/Result.h"
#include "database/Address.h"
#include "database/sql/Backups.h"

/// Backups beside the work of the window: on a connection of their own, on any thread, while others write.
namespace app {

/// Whether a file has no backup of today (UTC). A server never: its administrator makes them.
[[nodiscard]] bool isBackupDue(const database::Address& address, const QDateTime& nowUtc);

/// Makes a backup, thins the older ones, and throws away the attempts of this station that lay by until a backup had
/// them. Returns its path.
/// @param stationFolder  of this station's own files
[[nodiscard]] core::Result<QString> makeBackup(const database::Address& address, const QString& stationFolder,
                                               const QDateTime& nowUtc,
                                               const database::sql::BackupProgress& progress = {});

}  // namespace app
