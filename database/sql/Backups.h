// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QDateTime>
#include <QSqlDatabase>
#include <QString>
#include <QStringList>

#include "core/base/Result.h"
#include "database/sql/School.h"

/// Copies of an SQLite database, each checked before it counts. What a server keeps its administrator backs up;
/// `cusp db copy` brings it into a file.
namespace database::sql {

/// Pages done, and all; returns false to stop.
using BackupProgress = std::function<bool(int done, int all)>;

/// The folder "backups" beside the database's file.
[[nodiscard]] QString backupFolder(const QString& databaseFile);

/// Copies the database, as it is at one moment, into `folder` as "backup-2026-11-20-10.15.00.sqlite" by SQLite's online
/// API: others may write meanwhile, and whoever may read the database may read the copy. The database is checked first,
/// so that a damaged one never replaces a good copy, and the copy afterwards (see verifyBackup(), and whether it has as
/// many rows); only then it gets its name, on the disk. Returns its path.
[[nodiscard]] core::Result<QString> backUp(const QSqlDatabase& db, const QString& folder, const QDateTime& nowUtc,
                                           const BackupProgress& progress = {});

/// As backUp(), under the name "before-schema-3-...": kept until somebody deletes it. Returns its path.
[[nodiscard]] core::Result<QString> saveBeforeMigration(const QSqlDatabase& db, int version);

/// Whether a file is a whole database of this program: its pages and keys checked, its schema known.
[[nodiscard]] core::Status verifyBackup(const QString& file);

/// Whether nothing was changed in the audit of a backup, from its first row to its signed head: reads every row, some
/// seconds for a million. An error: it was stopped.
[[nodiscard]] core::Result<bool> holdsItsAudit(const QString& file, const BackupProgress& progress = {});
/// The same of one that was just put in its place, and brought to this program's schema.
[[nodiscard]] core::Result<bool> holdsItsAudit(const QSqlDatabase& db, const BackupProgress& progress = {});

/// The backups in a folder, newest first; of whichever school.
[[nodiscard]] QStringList backupsIn(const QString& folder);

/// What names a school: the hash of the row of its audit that says it was copied from another, the last of them, or of
/// the first row of all; the same in all its backups and in no other school. So what copySchool() has brought elsewhere
/// is a school of its own: what is tried out there does not come back as a backup. Empty: nobody has been entered yet.
[[nodiscard]] core::Result<std::string> schoolOf(const QSqlDatabase& db);
/// Of a file that nobody writes, with its log if a program that was killed has left one; empty also where it cannot be
/// read.
[[nodiscard]] std::string schoolOf(const QString& file);

/// Whether a backup was made before anybody was entered: to restore it is to have an empty school. False also where it
/// cannot be read, or is from before there were people.
[[nodiscard]] bool holdsNobody(const QString& file);

/// Of attempts and exams, by uid, those that a backup has; none where it cannot be read or an older program made it.
[[nodiscard]] QStringList heldBy(const QString& backup, const QStringList& uids);

/// Those of the backups in a folder that are of this school: several may back up into one.
[[nodiscard]] QStringList backupsOf(const QSqlDatabase& db, const QString& folder);

/// Of names as backUp() gives them, those to delete: kept are all of the last 2 days that have one, and the newest of
/// each of the last 12 days, 10 weeks and 9 months. Those from a clock that was wrong, and lie in the future, are left
/// alone.
[[nodiscard]] QStringList tooMany(const QStringList& files, const QDateTime& nowUtc);

/// Those of the school's backups to delete when one was made: tooMany(); but where its audit does not hold, none in
/// which it still does.
[[nodiscard]] QStringList toThin(const QStringList& files, const QDateTime& nowUtc, bool isAuditWhole);

/// The newest backup of a database's own folder that verifyBackup() finds whole and that somebody is in, one from the
/// future last, and none of another school, as far as mayReplace() can tell; empty: there is none, or the folder has
/// those of several schools and nothing says whose the file was.
[[nodiscard]] QString newestSound(const QString& databaseFile, const QDateTime& nowUtc);

/// The newest of those that restoreBackup() has moved aside, that verifyBackup() finds whole and that somebody is in,
/// one from the future last; empty: there is none.
[[nodiscard]] QString newestReplaced(const QString& databaseFile, const QDateTime& nowUtc);

/// Whether no file is there, or one that nothing or nobody is in: as after a restore that was stopped in the middle.
[[nodiscard]] bool liesEmpty(const QString& databaseFile);

/// What there is to go back to: newestSound(); where the school lies empty newestReplaced(), if that was moved aside
/// later than the backup was made. Empty: nothing.
[[nodiscard]] QString newestKept(const QString& databaseFile, const QDateTime& nowUtc);

/// Busy: another program has the database open. This one has closed it.
[[nodiscard]] core::Status expectClosed(const QString& databaseFile);

/// When a backup was made, or what a restore has replaced was moved aside: UTC, out of its name; invalid for other
/// files.
[[nodiscard]] QDateTime madeAt(const QString& backup);

/// Whether a file is called as backups, those from before a migration and what a restore has moved aside are: a copy of
/// a school, in which nobody looks for what comes in.
[[nodiscard]] bool isNamedAsCopy(const QString& file);

/// Whether a backup may take the place of what lies there. WrongKind: that is another school than the one of the
/// backup, and no copy of it, as a school is that has moved; where what lies there cannot be read the backups in its
/// folder say whose it was. NewerVersion: a later program wrote it. False: it may, but nothing says whose that was, or
/// the folder has backups of several schools, this one among them.
[[nodiscard]] core::Result<bool> mayReplace(const QString& backup, const QString& databaseFile);

/// Of some backups, newest first, the newest of each school. One that was copied from another counts as the same.
[[nodiscard]] QStringList newestOfEach(const QStringList& backups);
/// By what people know their school: how many are in it, who was entered first, some of the classes. Empty where that
/// cannot be read.
[[nodiscard]] QString whoIsIn(const QString& file);

/// Puts a backup in the place of the database, if it mayReplace() that. Busy: another program has that open (this one
/// has closed it), or is restoring there. Refused where no database may lie, and for the database itself. The backup is
/// checked, copied and brought to this program's schema first; what cannot be used replaces nothing. What lies there is
/// moved to "replaced-..." in the same step in which the backup takes its place; where the file system knows no such
/// step, before it, and back where that fails. What stands in its -wal is brought into it before; where it is damaged
/// that goes with it as it is, and first: whenever this is stopped, nothing is lost, and nothing of it is read into the
/// restored file. Who may read and write it stays as it was. Returns where the old file lies now, empty if there was
/// none.
/// @param progress  says nothing of how far it is; false stops it, as long as nothing was replaced
[[nodiscard]] core::Result<QString> restoreBackup(const QString& backup, const QString& databaseFile,
                                                  const QDateTime& nowUtc, const BackupProgress& progress = {});

/// Where the file system gives a new name before it removes the old one, a restore that was killed between the two has
/// left the database's file both. Removes the other one: a name of a restore's own, beside it, of the very same file.
/// Nothing while another program restores there, which may be about to remove this one, or where that cannot be known;
/// and none that a log lies beside, which goes with it.
void removeLeftNames(const QString& databaseFile);

/// Whether this person may put a backup in the place of the school. Admins. Of a file that is damaged or gone nobody
/// can be asked.
[[nodiscard]] core::Status mayRestore(const School& school, const Session& session);

/// Into the audit: that a person made it. Admins.
[[nodiscard]] core::Status noteBackup(const School& school, const Session& session, const QString& backup);

/// Into the audit of the restored database, whose end is older than before.
/// @param who  wanted it; where it knows nobody of that name yet, or nobody was asked, "system" is noted
[[nodiscard]] core::Status noteRestored(const School& school, const Session& who, const QString& backup);

/// Tries that a backup can be made of this database and brought back: into a folder of its own, which is removed. All
/// rows are compared with those of the database at that moment; returns how many there are.
[[nodiscard]] core::Result<qint64> restoreDrill(const QSqlDatabase& db, const BackupProgress& progress = {});

}  // namespace database::sql
