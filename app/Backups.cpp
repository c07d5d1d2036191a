// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Backups.h"

#include <QDir>
#include <QFile>

#include "database/Outbox.h"

namespace app {

bool isBackupDue(const database::Address& address, const QDateTime& nowUtc)
{
    if (address.isServer())
        return false;
    const QStringList there = database::sql::backupsIn(database::sql::backupFolder(address.file));
    return there.isEmpty() || database::sql::madeAt(there.front()).date() < nowUtc.date();
}

core::Result<QString> makeBackup(const database::sql::School& school, const database::Address& address,
                                 const QString& stationFolder, const QDateTime& nowUtc,
                                 const database::sql::BackupProgress& progress)
{
    // What arrives from now on may be too late for this one.
    const QStringList arrived =
        database::Outbox(QDir(stationFolder).filePath(QStringLiteral("outbox")), school.key).arrived();
    const QString folder = database::sql::backupFolder(address.file);
    auto made = database::sql::backUp(school.db, folder, nowUtc, progress);
    if (!made)
        return made;
    for (const QString& file : database::sql::tooMany(database::sql::backupsIn(folder)) + arrived)
        if (file != *made)
            QFile::remove(file);
    return made;
}

}  // namespace app
