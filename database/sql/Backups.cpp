// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Backups.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <set>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QSqlDriver>
#include <fcntl.h>
#include <sqlite3.h>

#include "core/base/FileLock.h"
#include "core/base/WholeFile.h"
#include "database/Passwords.h"
#include "database/sql/Audit.h"
#include "database/sql/Database.h"
#include "database/sql/Migrations.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using core::ErrorCode;

constexpr int kStepsPerLook = 50'000;  ///< of SQLite's virtual machine: some milliseconds
constexpr std::size_t kWholeDays = 2;
constexpr std::size_t kDays = 12;
constexpr std::size_t kWeeks = 10;
constexpr std::size_t kMonths = 9;
const QString kStamp = QStringLiteral("yyyy-MM-dd-HH.mm.ss");
const QString kSuffix = QStringLiteral(".sqlite");
const QString kPart = QStringLiteral(".part-");
constexpr QFile::Permissions kOwners = QFile::ReadOwner | QFile::WriteOwner;

core::Error refused(const QString& file, const std::string& why, ErrorCode code = ErrorCode::FileUnwritable)
{
    return {code, "backup " + file.toStdString() + ": " + why};
}

/// Returns an error about the location where a backup is to be restored.
core::Error refusedThere(const QString& databaseFile, const std::string& why,
                         ErrorCode code = ErrorCode::FileUnwritable)
{
    return {code, "database " + databaseFile.toStdString() + ": " + why};
}

bool hasLog(const QString& databaseFile)
{
    return QFileInfo(databaseFile + QStringLiteral("-wal")).size() > 0;
}

void removeWhole(const QString& databaseFile)
{
    for (const QString& file : wholeOf(databaseFile))
        QFile::remove(file);
}

/// A connection for reading a file that no program changes. It creates no files beside it, so a read-only disk is
/// sufficient. It also reads the write-ahead log that a crashed program left.
class Reader
{
public:
    explicit Reader(const QString& file) : m_name(QStringLiteral("cusp-backup-%1").arg(quintptr(this)))
    {
        QSqlDatabase db = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_name);
        db.setDatabaseName(dialect::uriOf(file, !hasLog(file)));
        db.setConnectOptions(QStringLiteral("QSQLITE_OPEN_READONLY;QSQLITE_OPEN_URI"));
        db.open();
    }
    ~Reader()
    {
        handle().close();
        QSqlDatabase::removeDatabase(m_name);
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    [[nodiscard]] QSqlDatabase handle() const { return QSqlDatabase::database(m_name, false); }

private:
    QString m_name;
};

core::Status expectOk(const QSqlDatabase& db, const QString& pragma)
{
    const auto answer = ask(db, pragma, "check it");
    if (!answer)
        return tl::unexpected(answer.error());
    // foreign_key_check returns no rows if all keys are valid.
    if (answer->isNull() || answer->toString() == u"ok")
        return {};
    return core::unexpected(ErrorCode::BadStructure, "database " + dialect::nameOf(db) + ": it is damaged (" +
                                                         answer->toString().simplified().toStdString() +
                                                         "); restore an older backup");
}

/// Writes a consistent copy of the database into a new file.
/// @param mode  permissions of the new file, from its creation on
core::Status copyInto(const QSqlDatabase& db, const QString& file, QFile::Permissions mode,
                      const BackupProgress& progress)
{
    const QVariant handle = db.driver()->handle();
    if (!handle.isValid() || qstrcmp(handle.typeName(), "sqlite3*") != 0)
        return core::unexpected(ErrorCode::WrongKind, "database " + dialect::nameOf(db) +
                                                          ": only a file is backed up so; use \"cusp db copy\"");
    QFile made(file);
    if (!made.open(QIODevice::WriteOnly | QIODevice::NewOnly, kOwners) || !made.setPermissions(mode | kOwners))
        return tl::unexpected(refused(file, "it cannot be created; check the folder and the room on the disk"));
    made.close();
    struct Watch
    {
        const BackupProgress& progress;
        bool isStopped;
    } watch{progress, progress && !progress()};
    const auto look = [](void* data) {
        auto& seen = *static_cast<Watch*>(data);
        seen.isStopped = seen.isStopped || (seen.progress && !seen.progress());
        return seen.isStopped ? 1 : 0;
    };
    auto* const raw = *static_cast<sqlite3* const*>(handle.data());
    sqlite3_progress_handler(raw, kStepsPerLook, look, &watch);
    core::Status done =
        watch.isStopped ? core::Status() : execute(db, QStringLiteral("VACUUM INTO ?"), "back it up", {file});
    sqlite3_progress_handler(raw, 0, nullptr, nullptr);
    if (watch.isStopped)
        return tl::unexpected(refused(file, "it was stopped"));
    if (done || done.error().code == ErrorCode::BadStructure)  // of the database itself
        return done;
    return tl::unexpected(
        refused(file, "it could not be written; make room on the disk and try again (" + done.error().detail + ')'));
}

/// Renames a file if the new name is free. Returns false if another file has that name.
bool giveName(const QString& file, const QString& name)
{
    if (renameat2(AT_FDCWD, QFile::encodeName(file).constData(), AT_FDCWD, QFile::encodeName(name).constData(),
                  RENAME_NOREPLACE) == 0)
        return true;
    return errno != EEXIST && QFile::rename(file, name);  // some file systems do not support this flag
}

/// Removes the files of interrupted backups that are older than a day.
void removeLeftParts(const QString& folder, const QString& kind)
{
    const QDateTime yesterday = QDateTime::currentDateTimeUtc().addDays(-1);
    for (const QFileInfo& one : QDir(folder).entryInfoList({kind + "-*" + kSuffix + kPart + '*'}, QDir::Files))
        if (one.lastModified() <= yesterday)
            QFile::remove(one.filePath());
}

core::Result<QString> backUpAs(const QSqlDatabase& db, const QString& folder, const QString& kind,
                               const QDateTime& nowUtc, const BackupProgress& progress)
{
    if (auto right = checkClock(nowUtc); !right)
        return tl::unexpected(right.error());
    if (!QDir().mkpath(folder))
        return tl::unexpected(refused(folder, "the folder cannot be created; check who may write there"));
    removeLeftParts(folder, kind);
    const auto nameAt = [&](const QDateTime& at) {
        return QDir(folder).filePath(kind + '-' + at.toString(kStamp) + kSuffix);
    };
    const QString part = nameAt(nowUtc) + kPart + QString::fromStdString(newUid());
    const auto removePart = qScopeGuard([&part] { removeWhole(part); });
    const std::string school = schoolOf(db).value_or(std::string());
    if (auto copied = copyInto(db, part, QFile::permissions(dialect::fileOf(db)), progress); !copied)
        return tl::unexpected(copied.error());
    if (auto whole = verifyBackup(part); !whole)
        return tl::unexpected(whole.error());
    if (!school.empty() && schoolOf(part) != school)
        return tl::unexpected(refused(part, "it does not hold the school; make it again"));
    if (!core::bringToDisk(part.toStdU16String()))
        return tl::unexpected(refused(part, "it could not be brought to the disk; make room there and try again"));
    for (QDateTime at = nowUtc;; at = at.addSecs(1)) {  // another program may have made a backup in the same second
        QString name = nameAt(at);
        if (giveName(part, name) && core::bringToDisk(folder.toStdU16String()))
            return name;
        if (!QFile::exists(name) || !QFile::exists(part))
            return tl::unexpected(refused(name, "it could not be given its name; check who may write there"));
    }
}

/// Renames a database and the files beside it. If that fails, it restores all names and returns false.
bool moveWhole(const QString& from, const QString& to)
{
    QStringList moved;
    for (const QString& file : wholeOf(from)) {
        const QString name = to + file.mid(from.size());
        if (QFile::exists(file) && !QFile::rename(file, name)) {
            for (const QString& back : std::as_const(moved))
                QFile::rename(to + back.mid(from.size()), back);
            return false;
        }
        moved += file;
    }
    return true;
}

/// Copies a backup and migrates the copy to this program's schema.
core::Status makeReady(const QString& backup, const QString& copy, const QString& databaseFile,
                       const BackupProgress& progress)
{
    removeWhole(copy);  // of an interrupted restore
    const QFile::Permissions mode = QFileInfo::exists(databaseFile) ? QFile::permissions(databaseFile) : kOwners;
    if (auto copied = copyInto(Reader(backup).handle(), copy, mode, progress); !copied)
        return copied;
    Database::Options options;
    options.mayCreate = false;
    options.savesFirst = false;  // the backup itself can be restored again
    Address address;
    address.file = copy;
    if (auto opened = Database::open(address, options); !opened) {
        const QString said = QString::fromStdString(opened.error().detail).replace(copy, backup);
        return core::unexpected(opened.error().code, said.toStdString() + "; nothing was replaced");
    }
    if (hasLog(copy) || !core::bringToDisk(copy.toStdU16String()))
        return tl::unexpected(
            refusedThere(databaseFile, "the backup could not be copied there; make room on the disk"));
    return {};
}

/// Renames the database and moves the copy to its path.
core::Result<QString> replace(const QString& copy, const QString& databaseFile, const QDateTime& nowUtc)
{
    const bool wasThere = QFileInfo::exists(databaseFile);
    const QFileInfo target(databaseFile);
    const auto asideAt = [&target](const QDateTime& at) {
        return target.absoluteDir().filePath("replaced-" + at.toString(kStamp) + '-' + target.fileName());
    };
    QDateTime at = nowUtc;
    while (QFile::exists(asideAt(at)))  // an earlier restore in the same second
        at = at.addSecs(1);
    const QString replaced = asideAt(at);
    if (!moveWhole(databaseFile, replaced))
        return tl::unexpected(refusedThere(databaseFile, "the file could not be moved aside; check who may write "
                                                         "there"));
    if (!giveName(copy, databaseFile)) {
        const bool isBack = !QFile::exists(databaseFile) && moveWhole(replaced, databaseFile);
        return tl::unexpected(
            refusedThere(databaseFile, "the backup could not be put there; what was there is " +
                                           (isBack ? std::string("there again") : "in " + replaced.toStdString())));
    }
    core::bringToDisk(target.absolutePath().toStdU16String());
    return wasThere ? replaced : QString();
}

core::Status expectSameSchool(const QString& backup, const QString& databaseFile)
{
    const std::string there = schoolOf(databaseFile);
    const std::string brought = schoolOf(backup);
    if (there.empty() || there == brought)
        return {};
    return tl::unexpected(
        refused(backup,
                (brought.empty() ? "nobody is in it, and a school is in " : "it is of another school than ") +
                    databaseFile.toStdString() + "; choose another backup, or move that file away first",
                ErrorCode::WrongKind));
}

}  // namespace

core::Result<std::string> schoolOf(const QSqlDatabase& db)
{
    return ask(db,
               "SELECT hash FROM audit WHERE seq = 1 OR (object = 'school' AND action = 'school.copied') ORDER BY seq "
               "DESC LIMIT 1",
               "see which school it is")
        .map([](const QVariant& hash) { return hash.toString().toStdString(); });
}

std::string schoolOf(const QString& file)
{
    return QFileInfo(file).isFile() ? schoolOf(Reader(file).handle()).value_or(std::string()) : std::string();
}

QString backupFolder(const QString& databaseFile)
{
    const QFileInfo file(databaseFile);
    return file.absoluteDir().filePath(file.fileName() == u"cusp.sqlite" ? QStringLiteral("backups")
                                                                         : file.fileName() + "-backups");
}

core::Result<QString> backUp(const QSqlDatabase& db, const QString& folder, const QDateTime& nowUtc,
                             const BackupProgress& progress)
{
    return backUpAs(db, folder, QStringLiteral("backup"), nowUtc, progress);
}

core::Result<QString> saveBeforeMigration(const QSqlDatabase& db, int version)
{
    return backUpAs(db, backupFolder(dialect::fileOf(db)), QStringLiteral("before-schema-%1").arg(version + 1),
                    QDateTime::currentDateTimeUtc(), {});
}

core::Status verifyBackup(const QString& file)
{
    if (!QFileInfo::exists(file))
        return tl::unexpected(refused(file, "there is no such file; choose another one", ErrorCode::FileMissing));
    if (!QFileInfo(file).isFile())
        return tl::unexpected(refused(file, "this is no file; choose a file", ErrorCode::WrongKind));
    const Reader reader(file);
    const QSqlDatabase db = reader.handle();
    if (!db.isOpen())
        return tl::unexpected(dialect::error(db, db.lastError(), "open it"));
    const auto application = ask(db, "PRAGMA application_id", "check it");
    if (!application)
        return tl::unexpected(application.error());
    if (application->toInt() != dialect::kApplicationId)
        return tl::unexpected(
            refused(file, "this database belongs to another program; choose another file", ErrorCode::WrongKind));
    const auto version = dialect::schemaVersion(db);
    const auto steps = shippedMigrations();
    if (!version || !steps)
        return tl::unexpected(version ? steps.error() : version.error());
    if (*version < 1)
        return tl::unexpected(refused(file, "there is no school in it; choose another one", ErrorCode::WrongKind));
    if (*version > static_cast<int>(steps->size()))
        return tl::unexpected(refused(file, "a later program made it; use that program", ErrorCode::NewerVersion));
    for (const char* pragma : {"PRAGMA integrity_check(1)", "PRAGMA foreign_key_check"})
        if (auto sound = expectOk(db, QLatin1String(pragma)); !sound)
            return sound;
    return {};
}

QStringList backupsIn(const QString& folder)
{
    QStringList files;
    const QDir there(folder);
    for (const QString& name : there.entryList({"backup-*.sqlite"}, QDir::Files, QDir::Name | QDir::Reversed))
        if (madeAt(name).isValid())
            files += there.filePath(name);
    return files;
}

QDateTime madeAt(const QString& backup)
{
    static const QRegularExpression kName(QStringLiteral(R"(^backup-(.{19})\.sqlite$)"));
    QDateTime made = QDateTime::fromString(kName.match(QFileInfo(backup).fileName()).captured(1), kStamp);
    made.setTimeSpec(Qt::UTC);
    return made;
}

QStringList tooMany(const QStringList& files)
{
    QStringList sorted = files;
    std::sort(sorted.begin(), sorted.end(), [](const QString& a, const QString& b) { return madeAt(a) > madeAt(b); });
    QStringList gone;
    std::set<QString> days;
    std::set<QString> weeks;
    std::set<QString> months;
    for (const QString& file : std::as_const(sorted)) {
        const QDateTime made = madeAt(file);
        if (!made.isValid())
            continue;
        int year = 0;
        const int week = made.date().weekNumber(&year);
        // The list is sorted: the first backup of a day, week or month is its newest.
        const auto isFirst = [](std::set<QString>& seen, std::size_t most, const QString& when) {
            return seen.size() < most && seen.insert(when).second;
        };
        const QString day = made.date().toString(Qt::ISODate);
        const bool forDay = isFirst(days, kDays, day);
        const bool forWeek = isFirst(weeks, kWeeks, QStringLiteral("%1-%2").arg(year).arg(week));
        const bool forMonth = isFirst(months, kMonths, made.date().toString(QStringLiteral("yyyy-MM")));
        // A user who makes a backup after an accident must not lose the backup from before it.
        const bool isYoung = days.contains(day) && days.size() <= kWholeDays;
        if (!isYoung && !forDay && !forWeek && !forMonth)
            gone += file;
    }
    return gone;
}

QStringList removeOldBackups(const QSqlDatabase& db, const QString& folder)
{
    const std::string school = schoolOf(db).value_or(std::string());
    QStringList own = backupsIn(folder);
    own.removeIf([&school](const QString& file) { return schoolOf(file) != school; });
    QStringList gone = tooMany(own);
    gone.removeIf([](const QString& file) { return !QFile::remove(file); });
    return gone;
}

QString newestSound(const QString& databaseFile)
{
    const QStringList files = backupsIn(backupFolder(databaseFile));
    const std::string there = schoolOf(databaseFile);
    const auto sound = std::find_if(files.begin(), files.end(), [&there](const QString& file) {
        const std::string school = schoolOf(file);
        return !school.empty() && (there.empty() || school == there) && verifyBackup(file).has_value();
    });
    return sound != files.end() ? *sound : QString();
}

core::Status expectClosed(const QString& databaseFile)
{
    sqlite3* db = nullptr;
    int code = sqlite3_open_v2(databaseFile.toUtf8().constData(), &db, SQLITE_OPEN_READWRITE, nullptr);
    // Every other connection has a lock: all the time with a write-ahead log, otherwise while it reads or writes.
    if (code == SQLITE_OK)
        code = sqlite3_exec(db, "PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE; COMMIT", nullptr, nullptr, nullptr);
    sqlite3_close(db);  // this merges the log of a crashed program into the file
    if (code != SQLITE_BUSY)
        return {};
    return tl::unexpected(
        refusedThere(databaseFile, "another program has it open; close every Cusp that uses it", ErrorCode::Busy));
}

core::Result<QString> restoreBackup(const QString& backup, const QString& databaseFile, const QDateTime& nowUtc,
                                    const BackupProgress& progress)
{
    const QString copy = databaseFile + QStringLiteral(".restoring");
    for (const QString& own : {databaseFile, copy})
        if (core::isSameFile(backup.toStdU16String(), own.toStdU16String()))
            return tl::unexpected(
                refused(backup, "this is the database itself; choose a backup of it", ErrorCode::WrongKind));
    if (auto fit = checkPlace(databaseFile); !fit)
        return tl::unexpected(fit.error());
    if (hasLog(backup))
        return tl::unexpected(refused(backup,
                                      "this is a database in use, not a backup; make a backup of it with \"cusp db "
                                      "backup\"",
                                      ErrorCode::WrongKind));
    if (auto sound = verifyBackup(backup); !sound)
        return tl::unexpected(sound.error());
    const core::FileLock lock((copy + "-lock").toStdU16String());
    if (!lock.isHeld())
        return tl::unexpected(refusedThere(databaseFile,
                                           "another program is restoring a backup there, or nothing can be written "
                                           "there; wait until it has ended, or check who may write there",
                                           ErrorCode::Busy));
    if (auto closed = expectClosed(databaseFile); !closed)
        return tl::unexpected(closed.error());
    if (auto same = expectSameSchool(backup, databaseFile); !same)
        return tl::unexpected(same.error());
    const auto removeCopy = qScopeGuard([&copy] { removeWhole(copy); });
    if (auto ready = makeReady(backup, copy, databaseFile, progress); !ready)
        return tl::unexpected(ready.error());
    // Checks again, because makeReady() takes a while.
    if (auto closed = expectClosed(databaseFile); !closed)
        return tl::unexpected(closed.error());
    if (progress && !progress())
        return tl::unexpected(refusedThere(databaseFile, "it was stopped, and nothing was replaced"));
    return replace(copy, databaseFile, nowUtc);
}

core::Status mayRestore(const DatabaseContext& school, const Login& session)
{
    return authorize(school, session, Operation::KeepBackups).map([](const auto&) {});
}

core::Status noteBackup(const DatabaseContext& school, const Login& session, const QString& backup)
{
    if (auto may = authorize(school, session, Operation::KeepBackups); !may)
        return tl::unexpected(may.error());
    return inTurn(school, "note the backup", [&] {
        return note(school, session.uid(), "backup.made",
                    "backup:" + QFileInfo(backup).completeBaseName().toStdString());
    });
}

core::Status noteRestored(const DatabaseContext& school, const Login& who, const QString& backup)
{
    const std::string doing = "note the restoring";
    return inTurn(school, doing, [&]() -> core::Status {
        const auto known =
            ask(school.db, QStringLiteral("SELECT uid FROM people WHERE uid = ?"), doing, {text(who.uid())});
        if (!known)
            return tl::unexpected(known.error());
        return note(school, known->isNull() ? "system" : who.uid(), "backup.restored",
                    "backup:" + QFileInfo(backup).completeBaseName().toStdString());
    });
}

}  // namespace database::sql
