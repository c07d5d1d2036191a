// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Backups.h"

#include <algorithm>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "database/Outbox.h"
#include "database/sql/Statement.h"

namespace app {
namespace {

/// Whether a school has what a letter brought; it may be another's, whose file lies in the same folder.
bool isIn(const database::sql::School& school, const QString& letter)
{
    const auto row = database::sql::ask(school.db,
                                        database::Outbox::isExam(letter) ? "SELECT 1 FROM exam_starts WHERE uid = ?"
                                                                         : "SELECT 1 FROM attempts WHERE uid = ?",
                                        "look for it", {QFileInfo(letter).completeBaseName()});
    return row && !row->isNull();
}

}  // namespace

bool isBackupDue(const database::Address& address, const QDateTime& nowUtc)
{
    if (address.isServer())
        return false;
    const QStringList there = database::sql::backupsIn(database::sql::backupFolder(address.file));
    return std::none_of(there.begin(), there.end(), [&nowUtc](const QString& backup) {
        return database::sql::madeAt(backup).date() == nowUtc.date();
    });
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
    QStringList inIt;
    for (const QString& file : arrived)
        if (isIn(school, file))
            inIt += file;
    for (const QString& file : database::sql::tooMany(database::sql::backupsOf(school.db, folder), nowUtc) + inIt)
        if (file != *made)
            QFile::remove(file);
    return made;
}

}  // namespace app
