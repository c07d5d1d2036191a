// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QDateTime>
#include <QSqlDatabase>
#include <QString>
#include <QStringList>

#include "core/base/Result.h"
#include "database/sql/DatabaseContext.h"

/// Backups of an SQLite file. A server is backed up by its administrator.
namespace database::sql {

/// Called repeatedly during long operations; returns false to cancel.
using BackupProgress = std::function<bool()>;

/// Returns the folder "backups" beside the database's file; beside a file with another name than "cusp.sqlite",
/// "NAME-backups".
[[nodiscard]] QString backupFolder(const QString& databaseFile);

/// Writes a consistent copy of the database into `folder` as "backup-2026-11-20-10.15.00.sqlite". Other programs may
/// write to the database meanwhile. The copy gets this name only when it is on the disk and verified: by
/// verifyBackup(), and to contain the same school. It has the permissions of the database. Returns its path.
[[nodiscard]] core::Result<QString> backUp(const QSqlDatabase& db, const QString& folder, const QDateTime& nowUtc,
                                           const BackupProgress& progress = {});

/// Like backUp(), with the name "before-schema-3-...", which no rotation removes.
[[nodiscard]] core::Result<QString> saveBeforeMigration(const QSqlDatabase& db, int version);

/// Checks a backup: it is a database of this program with a known schema, and its pages and foreign keys are sound.
[[nodiscard]] core::Status verifyBackup(const QString& file);

/// Returns the backups in a folder, newest first.
[[nodiscard]] QStringList backupsIn(const QString& folder);

/// Returns the time of a backup (UTC) from its name; invalid for other files.
[[nodiscard]] QDateTime madeAt(const QString& backup);

/// Returns the identity of a school: the hash of the first row of its audit, or of the last row that records a copy
/// from another database. It is the same in all backups of a school. Empty if no person has been entered.
[[nodiscard]] core::Result<std::string> schoolOf(const QSqlDatabase& db);
/// Returns the identity of the school in a file; empty also if the file cannot be read.
[[nodiscard]] std::string schoolOf(const QString& file);

/// Returns the backups that the rotation removes. It retains all backups of the last 2 days that have any, and the
/// newest of each of the last 12 days, 10 weeks and 9 months.
[[nodiscard]] QStringList tooMany(const QStringList& files);

/// Removes the backups of this school that tooMany() returns from a folder, and returns them.
QStringList removeOldBackups(const QSqlDatabase& db, const QString& folder);

/// Returns the newest verified backup in the folder of this database; empty if there is none. Ignores backups of
/// another school than the one in the file, and of a school without people.
[[nodiscard]] QString newestSound(const QString& databaseFile);

/// Checks that the database is closed, and merges the write-ahead log of a crashed program into the file. Busy: another
/// program, or another connection of this one, has the database open.
[[nodiscard]] core::Status expectClosed(const QString& databaseFile);

/// Replaces the database by a backup and migrates it to this program's schema. The old file is moved to "replaced-...",
/// with its write-ahead log. Errors, without any change: Busy if another program has the database open or restores it,
/// WrongKind if the backup is of another school than the file. The backup is verified, copied and migrated before the
/// old file is moved.
/// @param progress  false cancels as long as the file was not replaced
/// @return new path of the old file; empty if there was none
[[nodiscard]] core::Result<QString> restoreBackup(const QString& backup, const QString& databaseFile,
                                                  const QDateTime& nowUtc, const BackupProgress& progress = {});

/// Checks whether a person may restore a backup over an open database: only admins. A damaged or missing database is
/// not protected by this check.
[[nodiscard]] core::Status mayRestore(const DatabaseContext& school, const Login& session);

/// Records in the audit that a person made a backup. Admins.
[[nodiscard]] core::Status noteBackup(const DatabaseContext& school, const Login& session, const QString& backup);

/// Records in the audit of the restored database that it was restored.
/// @param who  the user; recorded as "system" if the restored database does not contain them
[[nodiscard]] core::Status noteRestored(const DatabaseContext& school, const Login& who, const QString& backup);

}  // namespace database::sql
