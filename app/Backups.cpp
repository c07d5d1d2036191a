// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Backups.h"

#include <QDir>
#include <QFile>

#include "database/Outbox.h"
#include "database/sql/Database.h"

namespace app {

bool isBackupDue(const database::Address& address, const QDateTime& nowUtc)
{
    if (address.isServer())
        return false;
    const QStringList there = database::sql::backupsIn(database::sql::backupFolder(address.file));
    return there.isEmpty() || database::sql::madeAt(there.front()).date() < nowUtc.date();
}

core::Result<QString> makeBackup(const database::Address& address, const QString& stationFolder,
                                 const QDateTime& nowUtc, const database::sql::BackupProgress& progress)
{
    const auto key = database::StationKey::readOrMake(QDir(stationFolder).filePath(QStringLiteral("station.key")));
    if (!key)
        return tl::unexpected(key.error());
    // What arrives from now on may be too late for this one.
    const QStringList arrived =
        database::Outbox(QDir(stationFolder).filePath(QStringLiteral("outbox")), *key).arrived();
    database::sql::Database::Options options;
    options.mayMigrate = false;
    const auto open = database::sql::Database::open(address, options);
    if (!open)
        return tl::unexpected(open.error());
    const QString folder = database::sql::backupFolder(address.file);
    auto made = database::sql::backUp((*open)->handle(), folder, nowUtc, progress);
    if (!made)
        return made;
    for (const QString& file : database::sql::tooMany(database::sql::backupsIn(folder)) + arrived)
        QFile::remove(file);
    return made;
}

}  // namespace app
