// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Backups.h"

#include <algorithm>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "database/Outbox.h"

namespace app {
namespace {

/// Of letters that have arrived, those that a backup has; another school's may lie in the same folder.
QStringList heldBy(const QString& backup, const QStringList& letters)
{
    QStringList uids;
    for (const QString& letter : letters)
        uids += QFileInfo(letter).completeBaseName();
    const QStringList held = database::sql::heldBy(backup, uids);
    QStringList there = letters;
    there.removeIf([&held](const QString& letter) { return !held.contains(QFileInfo(letter).completeBaseName()); });
    return there;
}

/// The newest whole one beside the one that has just been made; empty: there is none.
QString soundBeside(const QString& made, const QStringList& backups)
{
    const auto sound = std::find_if(backups.begin(), backups.end(), [&made](const QString& file) {
        return file != made && database::sql::verifyBackup(file).has_value();
    });
    return sound != backups.end() ? *sound : QString();
}

}  // namespace

bool isBackupDue(const database::Address& address, const QDateTime& nowUtc)
{
    if (address.isServer())
        return false;
    using database::sql::schoolOf;
    QStringList today = database::sql::backupsIn(database::sql::backupFolder(address.file));
    today.removeIf([&nowUtc](const QString& backup) { return database::sql::madeAt(backup).date() != nowUtc.date(); });
    if (today.isEmpty())
        return true;
    // Another school may back up into the same folder.
    const std::string school = schoolOf(address.file);
    return !school.empty() && std::none_of(today.begin(), today.end(),
                                           [&school](const QString& backup) { return schoolOf(backup) == school; });
}

core::Result<MadeBackup> makeBackup(const database::sql::School& school, const database::Address& address,
                                    const QString& stationFolder, const QDateTime& nowUtc,
                                    const database::sql::BackupProgress& progress)
{
    // What arrives from now on may be too late for this one.
    const QStringList arrived =
        database::Outbox(QDir(stationFolder).filePath(QStringLiteral("outbox")), school.key).arrived();
    const QString folder = database::sql::backupFolder(address.file);
    const auto made = database::sql::backUp(school.db, folder, nowUtc, progress);
    if (!made)
        return tl::unexpected(made.error());
    // Who stops this has a backup, and nothing is thrown away.
    const auto isAuditWhole = database::sql::holdsItsAudit(*made, progress);
    if (!isAuditWhole)
        return MadeBackup{*made};
    const QStringList there = database::sql::backupsOf(school.db, folder);
    // A disk may spoil the one that has just been made: two have it before its letter goes.
    QStringList gone = heldBy(*made, arrived);
    if (!gone.isEmpty())
        gone = heldBy(soundBeside(*made, there), gone);
    for (const QString& file : database::sql::toThin(there, nowUtc, *isAuditWhole) + gone)
        if (file != *made)
            QFile::remove(file);
    return MadeBackup{*made, *isAuditWhole};
}

}  // namespace app
