// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/DailyBackup.h"

#include <algorithm>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "database/Outbox.h"

namespace app {
namespace {

/// Makes a backup, and then removes the attempts that the backup contains from the outbox.
/// @param backUp  takes a folder, makes a backup in it and returns the path of the backup
template <class BackUp>
core::Result<QString> withOutbox(const database::StationKey& key, const database::Address& address,
                                 const QString& stationFolder, BackUp backUp)
{
    const database::Outbox outbox(QDir(stationFolder).filePath(QStringLiteral("outbox")), key,
                                  database::Outbox::schoolAt(address, stationFolder));
    const QStringList sent = outbox.arrived();  // first: the backup may lack attempts that arrive while it is made
    auto made = backUp(database::sql::backupFolder(address.file));
    if (made)
        for (const QString& attempt : sent)
            QFile::remove(attempt);
    return made;
}

}  // namespace

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
    return withOutbox(school.key, address, stationFolder, [&](const QString& folder) {
        auto made = database::sql::backUp(school.db, folder, nowUtc, progress);
        if (made)
            database::sql::removeOldBackups(school.db, folder);
        return made;
    });
}

core::Result<QString> makeBackup(const database::Repositories& school, const database::Login& who,
                                 const database::Address& address, const QString& stationFolder,
                                 const QDateTime& nowUtc, const database::MaintenanceRepository::GoesOn& goesOn)
{
    return withOutbox(school.stationKey, address, stationFolder,
                      [&](const QString& folder) { return school.maintenance.backUp(who, folder, nowUtc, goesOn); });
}

std::vector<BackupFile> backupsOf(const database::Address& address)
{
    std::vector<BackupFile> backups;
    for (const QString& file : database::sql::backupsIn(database::sql::backupFolder(address.file)))
        if (!database::sql::schoolOf(file).empty())
            backups.push_back({file, database::sql::madeAt(file), QFileInfo(file).size()});
    return backups;
}

core::Status checkBackup(const QString& file)
{
    return database::sql::verifyBackup(file);
}

}  // namespace app
