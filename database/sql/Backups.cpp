// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Backups.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QSqlDriver>
#include <QTemporaryDir>
#include <fcntl.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/FileLock.h"
#include "core/base/WholeFile.h"
#include "database/Passwords.h"
#include "database/sql/Audit.h"
#include "database/sql/Database.h"
#include "database/sql/Dialect.h"
#include "database/sql/Migrations.h"
#include "database/sql/RowSum.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using core::ErrorCode;

constexpr int kPagesAtOnce = 2000;
constexpr int kBusyRestMs = 50;
constexpr int kMostBusyRests = 200;
constexpr std::size_t kWholeDays = 2;
constexpr std::size_t kDays = 12;
constexpr std::size_t kWeeks = 10;
constexpr std::size_t kMonths = 9;
const QString kStamp = QStringLiteral("yyyy-MM-dd-HH.mm.ss");
const QString kSuffix = QStringLiteral(".sqlite");
const QString kRestoring = QStringLiteral(".restoring");
const QString kReplaced = QStringLiteral("replaced-");
constexpr QFile::Permissions kOwners = QFile::ReadOwner | QFile::WriteOwner;

core::Error refused(const QString& file, const std::string& why)
{
    return {ErrorCode::FileUnwritable, "backup " + file.toStdString() + ": " + why};
}

/// What is the matter where a backup is to be put.
core::Error refusedThere(const QString& databaseFile, const std::string& why)
{
    return {ErrorCode::FileUnwritable, "database " + databaseFile.toStdString() + ": " + why};
}

core::Error stoppedThere(const QString& databaseFile)
{
    return refusedThere(databaseFile, "it was stopped, and nothing was replaced");
}

core::Error openElsewhere(const QString& databaseFile)
{
    return {ErrorCode::Busy,
            "database " + databaseFile.toStdString() + ": another program has it open; close every Cusp that uses it"};
}

bool sync(const QString& path)
{
    return core::bringToDisk(path.toStdU16String());
}

/// An empty one, of SQLite's making from then on. At no moment it is for more people than it is meant for: who has it
/// open reads on.
bool makeFile(const QString& path, QFile::Permissions mode)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly | QIODevice::NewOnly, kOwners) && file.setPermissions(mode | kOwners);
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

/// A connection of its own to a file that nobody changes: nothing is made beside it, so that it may lie on a medium
/// that cannot be written. Where a log lies beside it, as a program that was killed leaves it, that is read with it.
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
    // foreign_key_check answers with nothing if all is well.
    if (answer->isNull() || answer->toString() == u"ok")
        return {};
    return core::unexpected(ErrorCode::BadStructure, "database " + dialect::nameOf(db) + ": it is damaged (" +
                                                         answer->toString().simplified().toStdString() +
                                                         "); restore an older backup");
}

core::Status copyPages(const QSqlDatabase& db, const QString& file, const BackupProgress& progress)
{
    const QVariant handle = db.driver()->handle();
    if (!handle.isValid() || qstrcmp(handle.typeName(), "sqlite3*") != 0)
        return core::unexpected(ErrorCode::WrongKind, "database " + dialect::nameOf(db) +
                                                          ": only a file is backed up so; use \"cusp db copy\"");
    auto* const from = *static_cast<sqlite3* const*>(handle.data());
    // Whoever may not read the school may not read its copies.
    if (!makeFile(file, QFile::permissions(dialect::fileOf(db))))
        return tl::unexpected(refused(file, "it cannot be created; check the folder and the room on the disk"));
    sqlite3* opened = nullptr;
    const int begun = sqlite3_open(file.toUtf8().constData(), &opened);
    const std::unique_ptr<sqlite3, int (*)(sqlite3*)> to(opened, sqlite3_close);
    sqlite3_backup* const backup = begun == SQLITE_OK ? sqlite3_backup_init(to.get(), "main", from, "main") : nullptr;
    if (backup == nullptr)
        return tl::unexpected(refused(file, "it cannot be created; check the folder and the room on the disk"));
    int code = SQLITE_OK;
    for (int rests = 0; code == SQLITE_OK || code == SQLITE_BUSY || code == SQLITE_LOCKED;) {
        code = sqlite3_backup_step(backup, kPagesAtOnce);
        if (code == SQLITE_OK && progress &&
            !progress(sqlite3_backup_pagecount(backup) - sqlite3_backup_remaining(backup),
                      sqlite3_backup_pagecount(backup))) {
            sqlite3_backup_finish(backup);
            return tl::unexpected(refused(file, "it was stopped"));
        }
        if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
            if (++rests > kMostBusyRests)
                break;
            sqlite3_sleep(kBusyRestMs);
        }
    }
    const bool done = sqlite3_backup_finish(backup) == SQLITE_OK && code == SQLITE_DONE;
    return done ? core::Status()
                : core::Status(
                      tl::unexpected(refused(file, std::string("it could not be written (") + sqlite3_errstr(code) +
                                                       "); make room on the "
                                                       "disk and try again")));
}

QStringList tablesOf(const QSqlDatabase& db)
{
    QStringList tables;
    static_cast<void>(forEach(db,
                              "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%' "
                              "ORDER BY name",
                              "check it", {}, [&](const QSqlQuery& row) { tables += row.value(0).toString(); }));
    return tables;
}

/// How many rows each table has: "people 7".
core::Result<QStringList> countsOf(const QSqlDatabase& db)
{
    QStringList counts;
    for (const QString& table : tablesOf(db)) {
        const auto rows = ask(db, QStringLiteral("SELECT count(*) FROM \"%1\"").arg(table), "count its rows");
        if (!rows)
            return tl::unexpected(rows.error());
        counts += table + ' ' + rows->toString();
    }
    return counts;
}

/// One moment of the school, whoever writes meanwhile: returns how many rows there were.
core::Result<QStringList> copyMoment(const QSqlDatabase& db, const QString& file, const BackupProgress& progress)
{
    // No transaction: there may be one around it.
    if (auto begun = execute(db, "SAVEPOINT moment", "read it"); !begun)
        return tl::unexpected(begun.error());
    const auto ended = qScopeGuard([&db] { static_cast<void>(execute(db, "RELEASE moment", "end reading it")); });
    auto counts = countsOf(db);
    if (!counts)
        return counts;
    if (auto made = copyPages(db, file, progress); !made)
        return tl::unexpected(made.error());
    return counts;
}

/// Whether a copy is whole and has as many rows as there were.
core::Status verifyCopy(const QString& file, const QStringList& counts)
{
    if (auto whole = verifyBackup(file); !whole)
        return whole;
    const Reader reader(file);
    const auto copied = countsOf(reader.handle());
    if (!copied)
        return tl::unexpected(copied.error());
    if (*copied != counts)
        return tl::unexpected(refused(file, "it has not as many rows as the school; make it again"));
    return {};
}

/// Of what lies in a folder and has exactly such a name: old enough that no program uses it any more. A link is none.
QStringList staleIn(const QString& folder, const QString& name, QDir::Filters kind)
{
    const QRegularExpression ours('^' + name + '$');
    const QDateTime yesterday = QDateTime::currentDateTimeUtc().addDays(-1);
    QStringList stale;
    for (const QFileInfo& one : QDir(folder).entryInfoList(kind | QDir::NoSymLinks | QDir::NoDotAndDotDot))
        if (one.lastModified() <= yesterday && ours.match(one.fileName()).hasMatch())
            stale += one.filePath();
    return stale;
}

/// As backUpAs() names what is not whole yet, and what lies beside that.
const QString kPartName = QStringLiteral(R"((?:backup|before-schema-\d+)-\d{4}-\d\d-\d\d-\d\d\.\d\d\.\d\d)"
                                         R"(\.sqlite\.part-[0-9a-f]{32})");
const QString kPartEnd = QStringLiteral("(?:-journal|-wal|-shm|-lock)?");
/// Of the file that is locked while one is made.
const QString kLock = QStringLiteral("-lock");
constexpr int kMostLockTries = 8;  ///< where files cannot be locked none is held, and nobody takes a part for left

/// What programs have left of backups when they were killed. Those that do not say who makes them are from older
/// programs, or lie where files cannot be locked: they go after a day.
void removeLeftParts(const QString& folder)
{
    for (const QString& part : staleIn(folder, kPartName + kPartEnd, QDir::Files))
        QFile::remove(part);
    const QRegularExpression ours('^' + kPartName + kLock + '$');
    const QDir there(folder);
    for (const QString& name : there.entryList(QDir::Files | QDir::NoSymLinks)) {
        if (!ours.match(name).hasMatch())
            continue;
        const QString file = there.filePath(name);
        if (const core::FileLock lock(file.toStdU16String()); lock.isHeld())
            removeWhole(file.chopped(kLock.size()));
    }
}

/// The drills' folders that were not removed because the program was killed, as far as nothing else lies in them.
void removeStaleDrills(const QString& folder)
{
    for (const QString& drill : staleIn(folder, QStringLiteral("cusp-drill-[0-9a-f]{32}-[A-Za-z]{6}"), QDir::Dirs)) {
        const QString name = QStringLiteral(R"((?:%1|backup-[-.\d]{19}\.sqlite|)"
                                            R"(restored\.sqlite(?:\.restoring[0-9a-f]{32})?(?:-journal|-wal|-shm)?))")
                                 .arg(kPartName + kPartEnd);
        for (const QString& file : staleIn(drill, name, QDir::Files))
            QFile::remove(file);
        QDir().rmdir(drill);
    }
}

enum class Named { Done, Taken, Refused };

/// Never over what is there: another program may have made its own in the same moment.
Named giveName(const QString& part, const QString& file)
{
    if (renameat2(AT_FDCWD, QFile::encodeName(part).constData(), AT_FDCWD, QFile::encodeName(file).constData(),
                  RENAME_NOREPLACE) == 0)
        return Named::Done;
    if (errno == EEXIST)
        return Named::Taken;
    // Not every file system can do that; Qt's way replaces nothing, either.
    if (QFile::rename(part, file))
        return Named::Done;
    return QFileInfo::exists(file) ? Named::Taken : Named::Refused;
}

/// Named by the moment, or the first one behind it that is not taken: by another school, or another program.
core::Result<QString> backUpAs(const QSqlDatabase& db, const QString& folder, const QString& kind,
                               const QDateTime& nowUtc, const BackupProgress& progress)
{
    // By its name it is offered and thinned out.
    if (auto right = checkClock(nowUtc); !right)
        return tl::unexpected(right.error());
    if (auto sound = expectOk(db, "PRAGMA quick_check(1)"); !sound)
        return tl::unexpected(sound.error());
    if (!QDir().mkpath(folder))
        return tl::unexpected(refused(folder, "the folder cannot be created; check who may write there"));
    const auto nameOf = [&](const QDateTime& at) {
        return QDir(folder).filePath(kind + '-' + at.toString(kStamp) + kSuffix);
    };
    removeLeftParts(folder);
    // Another program may be making one in the same second; and one that looks for what is left may have come between
    // the name of a lock and its being held: it would take the part for left.
    QString part;
    std::optional<core::FileLock> isBeingMade;
    for (int tries = 0; tries < kMostLockTries && !(isBeingMade && isBeingMade->isHeld()); ++tries) {
        part = nameOf(nowUtc) + ".part-" + QString::fromStdString(newUid());
        isBeingMade.emplace((part + kLock).toStdU16String());
    }
    const auto removePart = qScopeGuard([&part] {
        removeWhole(part);
        QFile::remove(part + kLock);  // which stays where files cannot be locked
    });
    const auto counts = copyMoment(db, part, progress);
    if (!counts)
        return tl::unexpected(counts.error());
    if (auto whole = verifyCopy(part, *counts); !whole)
        return tl::unexpected(whole.error());
    if (!sync(part))
        return tl::unexpected(
            refused(nameOf(nowUtc), "it could not be brought to the disk; make room there and try again"));
    QDateTime at = nowUtc;
    Named named = giveName(part, nameOf(at));
    while (named == Named::Taken) {
        at = at.addSecs(1);
        named = giveName(part, nameOf(at));
    }
    if (named == Named::Refused || !sync(folder))
        return tl::unexpected(refused(nameOf(at), "it could not be given its name; check who may write there"));
    return nameOf(at);
}

/// Whether another program has a database open. While one does, it holds a lock on a byte of the -shm file (the "dead
/// man's switch" of SQLite's os_unix.c); without a write-ahead log only while it reads or writes.
bool isOpenElsewhere(const QString& databaseFile)
{
    struct Place
    {
        const char* ending;
        off_t start;
        off_t length;
    };
    constexpr std::array kPlaces{Place{"-shm", 128, 1}, Place{"", 0x40000000, 512}};
    return std::any_of(kPlaces.begin(), kPlaces.end(), [&databaseFile](const Place& place) {
        const int file =
            open(QFile::encodeName(databaseFile + QLatin1String(place.ending)).constData(), O_RDWR | O_CLOEXEC);
        if (file < 0)
            return false;
        struct flock lock
        {};
        lock.l_type = F_WRLCK;
        lock.l_whence = SEEK_SET;
        lock.l_start = place.start;
        lock.l_len = place.length;
        const bool held = fcntl(file, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
        close(file);
        return held;
    });
}

bool hasBeside(const QString& databaseFile)
{
    return std::any_of(kBeside.begin(), kBeside.end(), [&databaseFile](const char* end) {
        return QFileInfo::exists(databaseFile + QLatin1String(end));
    });
}

/// Of a database as a program that was killed leaves it: brings what stands in its log into the file, so that one file
/// is all there is to move. A damaged one stays as it is.
void settle(const QString& databaseFile)
{
    if (!QFileInfo::exists(databaseFile) || !hasBeside(databaseFile))
        return;
    sqlite3* opened = nullptr;
    const int begun = sqlite3_open_v2(databaseFile.toUtf8().constData(), &opened, SQLITE_OPEN_READWRITE, nullptr);
    const std::unique_ptr<sqlite3, int (*)(sqlite3*)> db(opened, sqlite3_close);
    sqlite3_db_config(db.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    bool isSound = false;
    const auto take = [](void* sound, int, char** values, char**) {
        *static_cast<bool*>(sound) = qstrcmp(values[0], "ok") == 0;
        return 0;
    };
    // To read it undoes what a -journal says; to close it brings the log into it.
    if (begun == SQLITE_OK)
        sqlite3_exec(db.get(), "PRAGMA quick_check(1)", take, &isSound, nullptr);
    if (isSound)
        sqlite3_db_config(db.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 0, nullptr);
}

/// That one restores at a time in one folder. No file is made for it, which another user could not open and who is
/// killed would leave there. Where the file system knows no such locks, or the folder cannot be read, one goes on
/// without, and sweeps nothing: it may be another's copy that grows there.
class RestoreLock
{
public:
    explicit RestoreLock(const QString& databaseFile)
        : m_folder(::open(QFile::encodeName(QFileInfo(databaseFile).absolutePath()).constData(),
                          O_RDONLY | O_DIRECTORY | O_CLOEXEC)),
          m_isHeld(m_folder >= 0 && flock(m_folder, LOCK_EX | LOCK_NB) == 0),
          m_isTaken(!m_isHeld && m_folder >= 0 && errno == EWOULDBLOCK)
    {}
    ~RestoreLock()
    {
        if (m_folder >= 0)
            close(m_folder);
    }
    RestoreLock(const RestoreLock&) = delete;
    RestoreLock& operator=(const RestoreLock&) = delete;
    [[nodiscard]] bool isHeld() const { return m_isHeld; }
    /// By another program.
    [[nodiscard]] bool isTaken() const { return m_isTaken; }

private:
    int m_folder;
    bool m_isHeld;
    bool m_isTaken;
};

/// Whoever may not read the school may not read the copy, not even while it grows.
bool copyBytes(const QString& backup, const QString& copy, QFile::Permissions mode, const std::function<bool()>& goesOn)
{
    constexpr qint64 kAtOnce = qint64{1} << 20;
    QFile from(backup);
    QFile to(copy);
    if (!from.open(QIODevice::ReadOnly) || !makeFile(copy, mode) || !to.open(QIODevice::WriteOnly))
        return false;
    QByteArray bytes;
    do {
        bytes = from.read(kAtOnce);
        if (to.write(bytes) != bytes.size() || !goesOn())
            return false;
    } while (!bytes.isEmpty());
    return from.error() == QFile::NoError && to.flush();
}

/// Whether the file is, or was before it was damaged, a school's: its head says so.
bool isSchools(const QString& file)
{
    if (!QFileInfo(file).isFile())
        return false;
    const Reader reader(file);
    const auto application = ask(reader.handle(), "PRAGMA application_id", "see whose it is");
    return application && application->toInt() == dialect::kApplicationId;
}

/// Copies a backup and brings the copy to this program's schema: what cannot be used replaces nothing.
core::Status makeReady(const QString& backup, const QString& copy, const QString& databaseFile,
                       const std::function<bool()>& goesOn)
{
    // As the school was whose place it takes: a backup may be read-only, and nobody has chosen the mode of noise.
    const QFile::Permissions mode = isSchools(databaseFile) ? QFile::permissions(databaseFile) | kOwners : kOwners;
    const core::Error noRoom = refusedThere(
        databaseFile, "it could not be copied there; make room on the disk, and check who may write there");
    if (!copyBytes(backup, copy, mode, goesOn))
        return tl::unexpected(goesOn() ? noRoom : stoppedThere(databaseFile));
    Database::Options options;
    options.mayCreate = false;
    options.savesFirst = false;  // the backup itself is what there is to go back to
    Address address;
    address.file = copy;
    if (auto opened = Database::open(address, options); !opened) {
        const QString said = QString::fromStdString(opened.error().detail).replace(copy, backup);
        return core::unexpected(opened.error().code, said.toStdString() + "; nothing was replaced");
    }
    return hasLog(copy) || !sync(copy) ? core::Status(tl::unexpected(noRoom)) : core::Status();
}

/// Of a database, and what lies beside it; none that is not there. The file itself goes last: what lies beside it is
/// never alone there, where SQLite would delete it. False: all lies where it was.
bool moveAway(const QString& databaseFile, const QString& aside)
{
    QStringList moved;
    const auto move = [&](const char* end) {
        const QString from = databaseFile + QLatin1String(end);
        if (QFile::exists(from) && !QFile::rename(from, aside + QLatin1String(end)))
            return false;
        moved += QLatin1String(end);
        return true;
    };
    if (std::all_of(kBeside.begin(), kBeside.end(), move) && move(""))
        return true;
    for (const QString& one : std::as_const(moved))
        QFile::rename(aside + one, databaseFile + one);
    return false;
}

/// What moveAway() has moved. False: another file has taken the place meanwhile.
bool moveBack(const QString& databaseFile, const QString& aside)
{
    if (QFile::exists(aside) && giveName(aside, databaseFile) != Named::Done)
        return false;
    for (const char* end : kBeside)
        if (QFile::exists(aside + QLatin1String(end)))
            QFile::rename(aside + QLatin1String(end), databaseFile + QLatin1String(end));
    return true;
}

/// The first name from this moment on that is free.
QString freeAside(const QString& databaseFile, const QDateTime& nowUtc)
{
    const QFileInfo target(databaseFile);
    const auto named = [&target](const QDateTime& at) {
        return target.absoluteDir().filePath(kReplaced + at.toString(kStamp) + '-' + target.fileName());
    };
    QDateTime at = nowUtc;
    while (QFile::exists(named(at)))  // of a restore in the same second
        at = at.addSecs(1);
    return named(at);
}

/// In one step, so that a whole school lies there at every moment: one that is killed leaves the old or the new. Not
/// where something lies beside it, which no name change takes along. False: all lies where it was; another program has
/// opened it just now, or the file system may know no such step.
bool swap(const QString& copy, const QString& databaseFile, const QString& replaced)
{
    // Under its last name from the beginning: what has been moved away is never called like what may be swept away.
    if (hasBeside(databaseFile) || giveName(copy, replaced) != Named::Done)
        return false;
    if (renameat2(AT_FDCWD, QFile::encodeName(replaced).constData(), AT_FDCWD,
                  QFile::encodeName(databaseFile).constData(), RENAME_EXCHANGE) == 0) {
        // Whoever opened the old one in the last moment has its log beside the new one, which would be read with it.
        if (!isOpenElsewhere(replaced))
            return true;
        if (renameat2(AT_FDCWD, QFile::encodeName(replaced).constData(), AT_FDCWD,
                      QFile::encodeName(databaseFile).constData(), RENAME_EXCHANGE) != 0)
            return true;
    }
    giveName(replaced, copy);
    return false;
}

/// In two steps: what lies there is moved away first.
core::Status replace(const QString& copy, const QString& databaseFile, const QString& replaced)
{
    if (!moveAway(databaseFile, replaced))
        return tl::unexpected(
            refusedThere(databaseFile, "what lies there could not be moved away; close every Cusp that uses it"));
    // As in swap().
    if (isOpenElsewhere(replaced) && moveBack(databaseFile, replaced))
        return tl::unexpected(openElsewhere(databaseFile));
    if (giveName(copy, databaseFile) == Named::Done)
        return {};
    if (moveBack(databaseFile, replaced))
        return tl::unexpected(refusedThere(databaseFile, "it could not be put in its place, and what was there is "
                                                         "there again; check who may write there"));
    return tl::unexpected(refusedThere(databaseFile, "it could not be put in its place, where another program has made "
                                                     "a file meanwhile; what was there lies in " +
                                                         replaced.toStdString()));
}

/// Gives a copy that is ready the place of the database. Returns where that lies now, empty if there was none.
core::Result<QString> exchange(const QString& copy, const QString& databaseFile, const QDateTime& nowUtc)
{
    settle(databaseFile);
    const bool wasThere = QFileInfo::exists(databaseFile);
    const QString replaced = freeAside(databaseFile, nowUtc);
    if (!wasThere || !swap(copy, databaseFile, replaced)) {
        if (auto closed = expectClosed(databaseFile); !closed)
            return tl::unexpected(closed.error());
        if (auto done = replace(copy, databaseFile, replaced); !done)
            return tl::unexpected(done.error());
    }
    if (!sync(QFileInfo(databaseFile).absolutePath()))
        return tl::unexpected(refusedThere(databaseFile, "it could not be brought to the disk; check the disk; what "
                                                         "was there lies in " +
                                                             replaced.toStdString()));
    return wasThere ? replaced : QString();
}

/// How a restore's copy for this database is called, as an expression.
QString copyOf(const QFileInfo& target)
{
    return QRegularExpression::escape(target.fileName() + kRestoring) + QStringLiteral("[0-9a-f]{%1}").arg(kUidLength);
}

/// Whether freeAside() gives this database such a name.
bool isAside(const QString& name, const QFileInfo& target)
{
    return madeAt(name).isValid() && name.startsWith(kReplaced) &&
           name.mid(kReplaced.size() + kStamp.size()) == '-' + target.fileName();
}

/// The copies that restores have left which were killed: nobody uses them any more. Nothing else that is called nearly
/// so, and not the backup itself: older programs left the user one of such a name.
void sweep(const QString& databaseFile, const QString& backup)
{
    const QFileInfo target(databaseFile);
    QStringList ends{QString()};
    for (const char* end : kBeside)
        ends += QLatin1String(end);
    const QRegularExpression ours(QStringLiteral("^%1(%2)$").arg(copyOf(target), ends.join(u'|')));
    const QDir there = target.absoluteDir();
    for (const QString& name : there.entryList(QDir::Files | QDir::Hidden))
        if (const QString file = there.filePath(name);
            ours.match(name).hasMatch() && !core::isSameFile(backup.toStdU16String(), file.toStdU16String()))
            QFile::remove(file);
}

/// A day is the clock's to be wrong by.
bool isOfTheFuture(const QString& backup, const QDateTime& nowUtc)
{
    return madeAt(backup) > nowUtc.addDays(1);
}

/// Else in the order in which they are.
void putFutureLast(QStringList& files, const QDateTime& nowUtc)
{
    std::stable_partition(files.begin(), files.end(),
                          [&nowUtc](const QString& file) { return !isOfTheFuture(file, nowUtc); });
}

/// The schools that it was, one copied from the other, and is: see schoolOf().
core::Result<std::vector<std::string>> lineOf(const QSqlDatabase& db)
{
    std::vector<std::string> line;
    if (auto read = forEach(db,
                            "SELECT hash, seq FROM audit WHERE seq = 1 UNION SELECT hash, seq FROM audit WHERE object "
                            "= 'school' AND action = 'school.copied' ORDER BY seq",
                            "see whose it is", {}, [&line](const QSqlQuery& row) { line.push_back(textOf(row, 0)); });
        !read)
        return tl::unexpected(read.error());
    return line;
}

std::vector<std::string> lineOf(const QString& file)
{
    if (!QFileInfo(file).isFile())
        return {};
    const Reader reader(file);
    return lineOf(reader.handle()).value_or(std::vector<std::string>());
}

/// As a school's file is before there is a school in it.
bool holdsNothing(const QString& file)
{
    if (!QFileInfo(file).isFile())
        return false;
    const Reader reader(file);
    return dialect::countTables(reader.handle()).value_or(1) == 0;
}

/// What lies there was written by a program that knows more than this one.
core::Status expectKnown(const QString& databaseFile)
{
    if (!QFileInfo(databaseFile).isFile())
        return {};
    const Reader reader(databaseFile);
    const auto steps = shippedMigrations();
    const auto application = ask(reader.handle(), "PRAGMA application_id", "look into it");
    const auto version = dialect::schemaVersion(reader.handle());
    if (!steps || !application || !version || application->toInt() != dialect::kApplicationId ||
        *version <= static_cast<int>(steps->size()))
        return {};
    return core::unexpected(ErrorCode::NewerVersion,
                            "database " + databaseFile.toStdString() + ": it was written by a later program (schema " +
                                std::to_string(*version) + ", this program knows " + std::to_string(steps->size()) +
                                "), and a backup would take its place; use that program, or move the file away first");
}

}  // namespace

core::Result<bool> mayReplace(const QString& backup, const QString& databaseFile)
{
    if (auto known = expectKnown(databaseFile); !known)
        return tl::unexpected(known.error());
    if (liesEmpty(databaseFile))
        return true;
    const std::string school = schoolOf(backup);
    if (school.empty())
        return false;
    auto line = lineOf(databaseFile);
    const QStringList beside = line.empty() ? backupsIn(backupFolder(databaseFile)) : QStringList();
    for (const QString& file : beside)
        for (const std::string& other : lineOf(file))
            line.push_back(other);
    if (line.empty())
        return false;
    // Several schools may back up into one folder: then it says whose the file may have been, and not whose it was.
    if (std::find(line.begin(), line.end(), school) != line.end())
        return beside.isEmpty() || newestOfEach(beside).size() == 1;
    return core::unexpected(ErrorCode::WrongKind, "backup " + backup.toStdString() + ": it is of another school than " +
                                                      databaseFile.toStdString() +
                                                      "; name another place, or move that file away first");
}

QStringList newestOfEach(const QStringList& backups)
{
    QStringList newest;
    std::set<std::string> schools;
    for (const QString& file : backups)
        if (const auto line = lineOf(file); !line.empty() && schools.insert(line.front()).second)
            newest += file;
    return newest;
}

QString whoIsIn(const QString& file)
{
    if (!QFileInfo(file).isFile())
        return {};
    const Reader reader(file);
    const auto people = ask(reader.handle(), "SELECT COUNT(*) FROM people", "see whose it is");
    const auto first = ask(reader.handle(), "SELECT username FROM people ORDER BY id LIMIT 1", "see whose it is");
    if (!people || !first)
        return {};
    QStringList classes;
    static_cast<void>(forEach(reader.handle(), "SELECT name FROM classes ORDER BY id LIMIT 3", "see whose it is", {},
                              [&classes](const QSqlQuery& row) { classes += row.value(0).toString(); }));
    return QStringLiteral("people: %1, the first of them %2%3")
        .arg(people->toString(), first->toString(),
             classes.isEmpty() ? QString() : QStringLiteral("; classes: ") + classes.join(QStringLiteral(", ")));
}

core::Status expectClosed(const QString& databaseFile)
{
    if (!isOpenElsewhere(databaseFile))
        return {};
    return tl::unexpected(openElsewhere(databaseFile));
}

QDateTime madeAt(const QString& backup)
{
    static const QRegularExpression kName(
        QStringLiteral(R"(^(?:backup-(?=.{19}\.sqlite$)|replaced-(?=.{19}-))(\d{4}-\d\d-\d\d-\d\d\.\d\d\.\d\d))"));
    const auto found = kName.match(QFileInfo(backup).fileName());
    QDateTime made = found.hasMatch() ? QDateTime::fromString(found.captured(1), kStamp) : QDateTime();
    made.setTimeSpec(Qt::UTC);
    return made;
}

bool isNamedAsCopy(const QString& file)
{
    static const QRegularExpression kBefore(
        QStringLiteral(R"(^before-schema-\d+-\d{4}-\d\d-\d\d-\d\d\.\d\d\.\d\d\.sqlite$)"));
    return madeAt(file).isValid() || kBefore.match(QFileInfo(file).fileName()).hasMatch();
}

QString newestSound(const QString& databaseFile, const QDateTime& nowUtc)
{
    QStringList files = backupsIn(backupFolder(databaseFile));
    putFutureLast(files, nowUtc);
    // Another school's, which backs up into the same folder, would take its place.
    const auto isOfIt = [&](const QString& file) {
        const auto may = mayReplace(file, databaseFile);
        return may && (*may || newestOfEach(files).size() < 2);
    };
    const auto sound = std::find_if(files.begin(), files.end(), [&isOfIt](const QString& file) {
        return !holdsNobody(file) && verifyBackup(file).has_value() && isOfIt(file);
    });
    return sound != files.end() ? *sound : QString();
}

QString newestReplaced(const QString& databaseFile, const QDateTime& nowUtc)
{
    const QFileInfo target(databaseFile);
    const QDir there = target.absoluteDir();
    QStringList names = there.entryList({kReplaced + '*'}, QDir::Files, QDir::Name | QDir::Reversed);
    putFutureLast(names, nowUtc);
    for (const QString& name : std::as_const(names))
        if (QString file = there.filePath(name);
            isAside(name, target) && !holdsNobody(file) && verifyBackup(file).has_value())
            return file;
    return {};
}

bool liesEmpty(const QString& databaseFile)
{
    return !QFileInfo::exists(databaseFile) || holdsNobody(databaseFile) || holdsNothing(databaseFile);
}

QString newestKept(const QString& databaseFile, const QDateTime& nowUtc)
{
    const QString backup = newestSound(databaseFile, nowUtc);
    const QString replaced = liesEmpty(databaseFile) ? newestReplaced(databaseFile, nowUtc) : QString();
    if (replaced.isEmpty() || backup.isEmpty())
        return replaced + backup;
    const bool isOdd = isOfTheFuture(backup, nowUtc);
    if (isOdd != isOfTheFuture(replaced, nowUtc))
        return isOdd ? replaced : backup;
    return madeAt(replaced) >= madeAt(backup) ? replaced : backup;
}

core::Result<std::string> schoolOf(const QSqlDatabase& db)
{
    return lineOf(db).map([](const auto& line) { return line.empty() ? std::string() : line.back(); });
}

std::string schoolOf(const QString& file)
{
    const auto line = lineOf(file);
    return line.empty() ? std::string() : line.back();
}

bool holdsNobody(const QString& file)
{
    if (!QFileInfo(file).isFile())
        return false;
    const Reader reader(file);
    const auto somebody = ask(reader.handle(), "SELECT EXISTS (SELECT 1 FROM people)", "see whether it is empty");
    return somebody && somebody->toInt() == 0;
}

QStringList heldBy(const QString& backup, const QStringList& uids)
{
    const Reader reader(backup);
    QStringList held;
    for (const QString& uid : uids)
        if (const auto row =
                ask(reader.handle(),
                    "SELECT 1 FROM attempts WHERE uid = ? UNION ALL SELECT 1 FROM exam_starts WHERE uid = ?",
                    "look for it", {uid, uid});
            row && !row->isNull())
            held += uid;
    return held;
}

QStringList backupsOf(const QSqlDatabase& db, const QString& folder)
{
    const std::string school = schoolOf(db).value_or(std::string());
    QStringList files = backupsIn(folder);
    files.removeIf([&school](const QString& file) { return school.empty() || schoolOf(file) != school; });
    return files;
}

QString backupFolder(const QString& databaseFile)
{
    // Two schools in one folder keep theirs apart.
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
    const QFileInfo there(file);
    if (there.isDir())
        return core::unexpected(ErrorCode::FileUnreadable,
                                "backup " + file.toStdString() + ": this is a folder; choose a file in it");
    if (there.exists() && !there.isFile())
        return core::unexpected(ErrorCode::WrongKind, "backup " + file.toStdString() +
                                                          ": this is no file but a device or a pipe; choose a file");
    if (!there.exists())
        return core::unexpected(ErrorCode::FileMissing,
                                "backup " + file.toStdString() + ": there is no such file; choose another one");
    const Reader reader(file);
    const QSqlDatabase db = reader.handle();
    if (!db.isOpen())
        return tl::unexpected(dialect::error(db, db.lastError(), "open it"));
    const auto application = ask(db, "PRAGMA application_id", "check it");
    if (!application)
        return tl::unexpected(application.error());
    if (application->toInt() != dialect::kApplicationId)
        return core::unexpected(ErrorCode::WrongKind, "backup " + file.toStdString() +
                                                          ": this database belongs to another program; choose another "
                                                          "file");
    const auto version = dialect::schemaVersion(db);
    const auto steps = shippedMigrations();
    if (!version || !steps)
        return tl::unexpected(version ? steps.error() : version.error());
    if (*version < 1)
        return core::unexpected(ErrorCode::WrongKind,
                                "backup " + file.toStdString() + ": there is no school in it; choose another one");
    if (*version > static_cast<int>(steps->size()))
        return core::unexpected(ErrorCode::NewerVersion,
                                "backup " + file.toStdString() + ": a later program made it; use that program");
    for (const char* pragma : {"PRAGMA integrity_check(1)", "PRAGMA foreign_key_check"})
        if (auto sound = expectOk(db, QLatin1String(pragma)); !sound)
            return sound;
    return {};
}

core::Result<bool> holdsItsAudit(const QString& file, const BackupProgress& progress)
{
    const Reader reader(file);
    return holdsItsAudit(reader.handle(), progress);
}

core::Result<bool> holdsItsAudit(const QSqlDatabase& db, const BackupProgress& progress)
{
    constexpr std::int64_t kTold = 1000;
    bool goesOn = true;
    const auto findings = checkAudit(db, {}, [&](std::int64_t row) {
        goesOn = !progress || row % kTold != 1 || progress(0, 0);
        return goesOn;
    });
    if (!goesOn)
        return tl::unexpected(refused(dialect::fileOf(db), "it was stopped"));
    return findings && findings->empty();
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

QStringList tooMany(const QStringList& files, const QDateTime& nowUtc)
{
    QStringList sorted = files;
    sorted.removeIf([&nowUtc](const QString& file) { return isOfTheFuture(file, nowUtc); });
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
        // The newest of its day, week or month comes first.
        const auto isFirst = [](std::set<QString>& seen, std::size_t most, const QString& when) {
            return seen.size() < most && seen.insert(when).second;
        };
        const bool isOfOneDay = days.contains(made.date().toString(Qt::ISODate));
        const bool forDay = isFirst(days, kDays, made.date().toString(Qt::ISODate));
        const bool forWeek = isFirst(weeks, kWeeks, QStringLiteral("%1-%2").arg(year).arg(week));
        const bool forMonth = isFirst(months, kMonths, made.date().toString(QStringLiteral("yyyy-MM")));
        // Whoever backs up after an accident must not lose the copy from before it.
        const bool isYoung = isOfOneDay && days.size() <= kWholeDays;
        if (!isYoung && !forDay && !forWeek && !forMonth)
            gone += file;
    }
    return gone;
}

QStringList toThin(const QStringList& files, const QDateTime& nowUtc, bool isAuditWhole)
{
    QStringList gone = tooMany(files, nowUtc);
    if (!isAuditWhole)
        gone.removeIf([](const QString& file) { return holdsItsAudit(file).value_or(true); });
    return gone;
}

core::Result<QString> restoreBackup(const QString& backup, const QString& databaseFile, const QDateTime& nowUtc,
                                    const BackupProgress& progress)
{
    if (core::isSameFile(backup.toStdU16String(), databaseFile.toStdU16String()))
        return core::unexpected(ErrorCode::WrongKind, "backup " + backup.toStdString() +
                                                          ": this is the database itself; choose a backup of it");
    // Whatever is no database would be moved away, with all that lies in it.
    if (auto fit = checkPlace(databaseFile); !fit)
        return tl::unexpected(fit.error());
    if (hasLog(backup))
        return core::unexpected(ErrorCode::WrongKind,
                                "backup " + backup.toStdString() +
                                    ": this is a database in use, not a backup, and a part of it lies in the file -wal "
                                    "beside it; open it with Cusp, or make a backup of it with \"cusp db backup\"");
    if (auto sound = verifyBackup(backup); !sound)
        return tl::unexpected(sound.error());
    const RestoreLock lock(databaseFile);
    if (lock.isTaken())
        return core::unexpected(ErrorCode::Busy, "database " + databaseFile.toStdString() +
                                                     ": another program is restoring a backup there, or has locked "
                                                     "the folder; wait until it has ended");
    if (auto closed = expectClosed(databaseFile); !closed)
        return tl::unexpected(closed.error());
    if (auto may = mayReplace(backup, databaseFile); !may)
        return tl::unexpected(may.error());
    // It gives back the room that the copy needs.
    if (lock.isHeld())
        sweep(databaseFile, backup);
    const QString copy = databaseFile + kRestoring + QString::fromStdString(newUid());
    const auto removeCopy = qScopeGuard([&copy] { removeWhole(copy); });
    const auto goesOn = [&progress] { return !progress || progress(0, 0); };
    if (auto ready = makeReady(backup, copy, databaseFile, goesOn); !ready)
        return tl::unexpected(ready.error());
    // That took its time.
    if (auto closed = expectClosed(databaseFile); !closed)
        return tl::unexpected(closed.error());
    if (!goesOn())
        return tl::unexpected(stoppedThere(databaseFile));
    return exchange(copy, databaseFile, nowUtc);
}

void removeLeftNames(const QString& databaseFile)
{
    const auto found = [](const QString& file) {
        struct stat there
        {};
        return lstat(QFile::encodeName(file).constData(), &there) == 0 ? std::optional(there) : std::nullopt;
    };
    const RestoreLock lock(databaseFile);
    const auto own = found(databaseFile);
    if (!lock.isHeld() || !own || !S_ISREG(own->st_mode))
        return;
    const QFileInfo target(databaseFile);
    const QRegularExpression copy('^' + copyOf(target) + '$');
    const QDir there = target.absoluteDir();
    for (const QString& name : there.entryList(QDir::Files | QDir::Hidden)) {
        const QString file = there.filePath(name);
        const auto other = found(file);
        if (other && other->st_dev == own->st_dev && other->st_ino == own->st_ino && !hasBeside(file) &&
            (isAside(name, target) || copy.match(name).hasMatch()))
            QFile::remove(file);
    }
}

core::Status mayRestore(const School& school, const Session& session)
{
    return admit(school, session, Operation::KeepBackups).map([](const auto&) {});
}

core::Status noteBackup(const School& school, const Session& session, const QString& backup)
{
    if (auto may = admit(school, session, Operation::KeepBackups); !may)
        return tl::unexpected(may.error());
    return inTurn(school, "note the backup", [&] {
        return note(school, session.uid(), "backup.made",
                    "backup:" + QFileInfo(backup).completeBaseName().toStdString());
    });
}

core::Status noteRestored(const School& school, const Session& who, const QString& backup)
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

core::Result<qint64> restoreDrill(const QSqlDatabase& db, const BackupProgress& progress)
{
    const QString beside = QFileInfo(dialect::fileOf(db)).absolutePath();
    removeStaleDrills(beside);
    QTemporaryDir folder(
        QDir(beside).filePath(QStringLiteral("cusp-drill-%1-XXXXXX").arg(QString::fromStdString(newUid()))));
    if (!folder.isValid())
        return tl::unexpected(refused(beside, "no folder can be made there to restore it into; check who may write "
                                              "there, and the room on the disk"));
    // One moment of the school, whoever writes meanwhile: the copy is made of it, and compared with it.
    if (auto begun = execute(db, "BEGIN", "read it"); !begun)
        return tl::unexpected(begun.error());
    const auto ended = qScopeGuard([&db] { static_cast<void>(execute(db, "ROLLBACK", "end reading it")); });
    if (const auto rows = ask(db, "SELECT count(*) FROM sqlite_master", "read it"); !rows)
        return tl::unexpected(rows.error());
    const auto backup = backUp(db, folder.path(), QDateTime::currentDateTimeUtc(), progress);
    if (!backup)
        return tl::unexpected(backup.error());
    const QString restored = folder.filePath(QStringLiteral("restored.sqlite"));
    if (const auto put = restoreBackup(*backup, restored, QDateTime::currentDateTimeUtc()); !put)
        return tl::unexpected(put.error());
    const Reader reader(restored);
    qint64 rows = 0;
    bool goesOn = true;
    const auto tell = [&](std::int64_t) {
        goesOn = !progress || progress(0, 0);
        return goesOn;
    };
    for (const QString& table : tablesOf(db)) {
        if (!tell(0))
            break;
        const auto here = sumOf(db, table, tell);
        const auto there = goesOn ? sumOf(reader.handle(), table, tell) : here;
        if (!here || !there)
            return tl::unexpected(here ? there.error() : here.error());
        if (!goesOn)
            break;
        if (*here != *there)
            return core::unexpected(ErrorCode::BadStructure, "the restored copy of the table " + table.toStdString() +
                                                                 " is not as it is in the database");
        rows += there->rows();
    }
    if (!goesOn)
        return tl::unexpected(refused(*backup, "it was stopped"));
    return rows;
}

}  // namespace database::sql
