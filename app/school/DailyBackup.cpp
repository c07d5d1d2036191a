// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/DailyBackup.h"

#include <algorithm>

#include <QDir>
#include <QFile>

#include "database/Outbox.h"

namespace app {

bool isBackupDue(const database::Address& address, const QDateTime& nowUtc)
{
    if (address.isServer())
        return false;
    const QStringList backups = database::sql::backupsIn(database::sql::backupFolder(address.file));
    return std::none_of(backups.begin(), backups.end(), [&nowUtc](const QString& backup) {
        return database::sql::madeAt(backup).date() == nowUtc.date();
    });
}

core::Result<QString> makeBackup(const database::sql::DatabaseContext& school, const database::Address& address,
                                 const QString& stationFolder, const QDateTime& nowUtc,
                                 const database::sql::BackupProgress& progress)
{
    const database::Outbox outbox(QDir(stationFolder).filePath(QStringLiteral("outbox")), school.key,
                                  database::Outbox::schoolAt(address, stationFolder));
    const QStringList sent = outbox.arrived();  // what is sent from now on may be too late for the backup
    const QString folder = database::sql::backupFolder(address.file);
    auto made = database::sql::backUp(school.db, folder, nowUtc, progress);
    if (!made)
        return made;
    database::sql::removeOldBackups(school.db, folder);
    for (const QString& attempt : sent)
        QFile::remove(attempt);
    return made;
}

}  // namespace app
