// SPDX-License-Identifier: GPL-3.0-or-later
// Backups: making, verifying, thinning out and restoring them.
#include <array>
#include <cstdarg>
#include <functional>
#include <memory>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTest>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "database/sql/Backups.h"
#include "database/sql/Copy.h"
#include "database/sql/Migrations.h"
#include "database/sql/Statement.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/FullDisk.h"
#include "tests/support/Suite.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::asNobody;
using support::attemptsIn;
using support::RawFile;
using support::SchoolRig;

namespace {

/// The widest permissions of any file created while a school, a backup or a restored copy was made.
mode_t widest = 0;

void noteMode(const QByteArray& path, mode_t mode)
{
    if (path.contains(".restoring") || path.contains(".part-") || path.endsWith("new.sqlite"))
        widest |= mode;
}

}  // namespace

// Replaces the function of the C library. Qt creates its files with open64().
extern "C" {

int open64(const char* path, int flags, ...)
{
    va_list rest;
    va_start(rest, flags);
    const auto mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : mode_t{0};
    va_end(rest);
    if ((flags & O_CREAT) != 0 && access(path, F_OK) != 0)
        noteMode(path, mode);
    return static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags | O_LARGEFILE, mode));
}

int chmod(const char* path, mode_t mode) noexcept
{
    noteMode(path, mode);
    return static_cast<int>(syscall(SYS_fchmodat, AT_FDCWD, path, mode));
}

int fchmod(int file, mode_t mode) noexcept
{
    noteMode(QFile::symLinkTarget(QStringLiteral("/proc/self/fd/%1").arg(file)).toLocal8Bit(), mode);
    return static_cast<int>(syscall(SYS_fchmod, file, mode));
}
}

namespace {

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool putNoise(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(QByteArray(50'000, 'n')) == 50'000;
}

bool runOn(const QString& file, const QStringList& statements)
{
    const RawFile raw(file);
    return std::all_of(statements.begin(), statements.end(),
                       [&raw](const QString& sql) { return execute(raw.handle(), sql, "prepare it").has_value(); });
}

/// Overwrites the first page of a table with noise.
bool spoil(const QString& file, const char* table)
{
    constexpr qint64 kPage = 4096;
    const qint64 page = ask(RawFile(file).handle(), "SELECT rootpage FROM sqlite_master WHERE name = ?", "find it",
                            {QLatin1String(table)})
                            ->toLongLong();
    QFile bytes(file);
    return page > 1 && bytes.open(QIODevice::ReadWrite) && bytes.seek((page - 1) * kPage) &&
           bytes.write(QByteArray(kPage, 'Z')) == kPage;
}

}  // namespace

class TestRestoring : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_empty = backUp(m_rig.school().db, m_backups.path(), m_rig.nowUtc.addDays(-1)).value();
        m_rig.populate();
        m_backup = backUp(m_rig.school().db, m_backups.path(), m_rig.nowUtc).value();
        QCOMPARE(QFileInfo(m_backup).fileName(), QString("backup-2026-11-20-10.15.00.sqlite"));
        QCOMPARE(madeAt(m_backup), m_rig.nowUtc);
        VERIFY_DONE(m_rig.add(m_rig.student, SchoolRig::attempt("class1-36", 900), {}));
        m_crashed = m_backups.filePath("crashed.sqlite");
        for (const char* end : {"", "-wal"})
            QVERIFY(QFile::copy(m_rig.address() + end, m_crashed + end));
        // A second backup in the same second.
        m_school = backUp(m_rig.school().db, m_backups.path(), m_rig.nowUtc).value();
        QVERIFY(m_school != m_backup);
        SchoolRig other(false);
        other.populate();
        m_other = backUp(other.school().db, m_backups.path(), m_rig.nowUtc.addDays(1)).value();
        const QString id = QString::fromStdString(*schoolOf(m_rig.school().db));
        QVERIFY(!id.isEmpty());
        for (const QString& own : {m_backup, m_school, m_crashed})
            QCOMPARE(QString::fromStdString(schoolOf(own)), id);
        QVERIFY(schoolOf(m_empty).empty() && schoolOf(m_other) != id.toStdString());
    }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QFile::copy(m_school, file()));
    }

    void whatACrashedProgramLeftIsMovedAsideWhole()
    {
        QVERIFY(QFile::remove(file()));
        for (const char* end : {"", "-wal"})
            QVERIFY(QFile::copy(m_crashed + end, file() + end));
        QVERIFY(QFileInfo(file() + "-wal").size() > 0);
        const auto replaced = restoreBackup(m_backup, file(), m_now);
        VERIFY_DONE(replaced);
        QCOMPARE(there(), (QStringList{"replaced-2026-11-21-12.00.00-school.sqlite", "school.sqlite"}));
        QCOMPARE(attemptsIn(*replaced), 1);
        QCOMPARE(attemptsIn(file()), 0);
        QVERIFY(checkDatabase(Database::open(file()).value()->handle(), {})->findings.empty());
        // A second restore in the same second.
        VERIFY_DONE(restoreBackup(m_school, file(), m_now));
        QCOMPARE(there("replaced-*").size(), 2);
        // A database that is in use cannot serve as a backup.
        QVERIFY(QFile::copy(m_crashed, at("used.sqlite")) && QFile::copy(m_crashed + "-wal", at("used.sqlite-wal")));
        VERIFY_REFUSED(restoreBackup(at("used.sqlite"), file(), m_now), ErrorCode::WrongKind);
        VERIFY_REFUSED(restoreBackup(file(), file(), m_now), ErrorCode::WrongKind);
    }

    void theLogOfADamagedFileIsNotReadIntoTheRestoredOne()
    {
        for (const bool isThere : {true, false}) {
            QVERIFY(isThere ? putNoise(file()) : QFile::remove(file()));
            QVERIFY(QFile::copy(m_crashed + "-wal", file() + "-wal"));
            QVERIFY(putNoise(file() + "-shm"));
            VERIFY_DONE(restoreBackup(m_backup, file(), m_now));
            QVERIFY(!QFile::exists(file() + "-wal") && !QFile::exists(file() + "-shm"));
            QCOMPARE(attemptsIn(file()), 0);
        }
    }

    void whatIsNotWholeIsNoBackup_data()
    {
        using Harm = std::function<bool(const QString&)>;
        QTest::addColumn<Harm>("harm");
        QTest::addColumn<ErrorCode>("code");
        const auto row = [](const char* name, ErrorCode code, const Harm& harm) {
            QTest::newRow(name) << harm << code;
        };
        const auto sql = [](const QStringList& deeds) {
            return [deeds](const QString& path) { return runOn(path, deeds); };
        };
        row("a key that leads nowhere", ErrorCode::BadStructure,
            sql({"PRAGMA foreign_keys = OFF", "INSERT INTO enrolments VALUES (99, 99)"}));
        row("cut off", ErrorCode::BadStructure,
            [](const QString& path) { return QFile::resize(path, QFileInfo(path).size() / 2); });
        row("noise in a table", ErrorCode::BadStructure, [](const QString& path) { return spoil(path, "audit"); });
        row("nothing but noise", ErrorCode::WrongKind, putNoise);
        row("of another program", ErrorCode::WrongKind, sql({"PRAGMA application_id = 7"}));
        row("of no program", ErrorCode::WrongKind, sql({"PRAGMA application_id = 0"}));
        row("of a later program", ErrorCode::NewerVersion, sql({"PRAGMA user_version = 99"}));
        row("without a schema", ErrorCode::WrongKind, sql({"PRAGMA user_version = 0"}));
        row("gone", ErrorCode::FileMissing, [](const QString& path) { return QFile::remove(path); });
        row("a folder", ErrorCode::WrongKind,
            [](const QString& path) { return QFile::remove(path) && QDir().mkdir(path); });
    }

    /// A damaged file is neither accepted as a backup nor restored.
    void whatIsNotWholeIsNoBackup()
    {
        QFETCH(std::function<bool(const QString&)>, harm);
        QFETCH(ErrorCode, code);
        const QString backup = at("backup.sqlite");
        QVERIFY(QFile::copy(m_backup, backup));
        VERIFY_DONE(verifyBackup(backup));
        QVERIFY(harm(backup));
        VERIFY_REFUSED(verifyBackup(backup), code);
        const QByteArray before = contentOf(file());
        VERIFY_REFUSED(restoreBackup(backup, file(), m_now), code);
        QCOMPARE(contentOf(file()), before);
    }

    /// The backup claims an older schema than it has, so its migration fails.
    void aBackupThatCannotBeMigratedReplacesNothing()
    {
        const QString backup = at("backup.sqlite");
        QVERIFY(QFile::copy(m_backup, backup) && runOn(backup, {"PRAGMA user_version = 1"}));
        VERIFY_DONE(verifyBackup(backup));
        const QByteArray before = contentOf(file());
        const auto refused = restoreBackup(backup, file(), m_now);
        QVERIFY(!refused.has_value());
        const QString said = QString::fromStdString(refused.error().detail);
        QVERIFY2(said.contains(backup) && said.contains("nothing was replaced"), qPrintable(said));
        QCOMPARE(contentOf(file()), before);
        QCOMPARE(there(), (QStringList{"backup.sqlite", "school.sqlite"}));
    }

    void aDamagedDatabaseIsNotBackedUp()
    {
        QVERIFY(spoil(file(), "people"));
        {
            const RawFile damaged(file());
            VERIFY_REFUSED(backUp(damaged.handle(), m_folder->path(), m_now), ErrorCode::BadStructure);
        }
        QCOMPARE(there(), QStringList{"school.sqlite"});
    }

    /// An unfinished part younger than a day may belong to a backup that another program is making.
    void whatAKilledBackupLeavesGoesWithTheNext()
    {
        const auto leave = [this](const QString& name, int hoursAgo) {
            QFile part(at(name));
            QVERIFY(part.open(QIODevice::WriteOnly));
            QVERIFY(part.setFileTime(QDateTime::currentDateTimeUtc().addSecs(-3600 * hoursAgo),
                                     QFileDevice::FileModificationTime));
        };
        leave("backup-2026-11-01-10.00.00.sqlite.part-old", 25);
        leave("backup-2026-11-01-10.00.00.sqlite.part-old-journal", 25);
        leave("backup-2026-11-01-10.00.00.sqlite.part-young", 23);
        VERIFY_DONE(backUp(m_rig.school().db, m_folder->path(), m_now));
        QCOMPARE(there("*.part-*"), QStringList{"backup-2026-11-01-10.00.00.sqlite.part-young"});
        QCOMPARE(backupsIn(m_folder->path()).size(), 1);
    }

    void aBackupOfAnotherSchoolIsNotRestored()
    {
        const QByteArray before = contentOf(file());
        for (const QString& backup : {m_other, m_empty}) {
            VERIFY_REFUSED(restoreBackup(backup, file(), m_now), ErrorCode::WrongKind, "move that file away first");
            QCOMPARE(contentOf(file()), before);
        }
        // To restore the backup of another school, the user must move the present file away.
        QVERIFY(QFile::rename(file(), at("away.sqlite")));
        QCOMPARE(restoreBackup(m_other, file(), m_now).value(), QString());
        // A damaged file no longer shows which school it belongs to, so it can be replaced.
        QVERIFY(putNoise(file()));
        VERIFY_DONE(restoreBackup(m_backup, file(), m_now));
        // A copy into another database is a school of its own.
        SchoolRig copy(false);
        VERIFY_DONE(copySchool(m_rig.school(), m_rig.admin, copy.school()));
        VERIFY_REFUSED(restoreBackup(backUp(copy.school().db, m_folder->path(), m_now).value(), file(), m_now),
                       ErrorCode::WrongKind);
    }

    void theNewestSoundBackupIsOffered()
    {
        const QString folder = backupFolder(file());
        QCOMPARE(folder, at("school.sqlite-backups"));
        QCOMPARE(backupFolder(at("cusp.sqlite")), at("backups"));
        QCOMPARE(newestSound(file()), QString());
        QVERIFY(QDir().mkpath(folder));
        const auto put = [&folder](const QString& backup, int day) {
            const QString name = QStringLiteral("%1/backup-2026-11-0%2-10.00.00.sqlite").arg(folder).arg(day);
            return QFile::copy(backup, name) ? name : QString();
        };
        const QString own = put(m_backup, 1);
        const QString others = put(m_other, 2);
        put(m_empty, 3);
        QVERIFY(putNoise(put(m_backup, 4)));
        QCOMPARE(newestSound(file()), own);
        QVERIFY(QFile::remove(file()));
        QCOMPARE(newestSound(file()), others);
    }

    /// The other program would continue to write into the file that was moved away.
    void nothingIsRestoredUnderAnotherProgram()
    {
        std::array<int, 2> ready{};
        std::array<int, 2> done{};
        QCOMPARE(pipe(ready.data()) + pipe(done.data()), 0);
        const pid_t other = fork();
        if (other == 0) {
            close(done[1]);
            char byte = 'x';
            const auto database = Database::open(file());
            static_cast<void>(write(ready[1], &byte, database ? 1 : 0));
            static_cast<void>(read(done[0], &byte, 1));
            _exit(0);
        }
        char byte = 'x';
        QCOMPARE(read(ready[0], &byte, 1), 1);
        VERIFY_REFUSED(expectClosed(file()), ErrorCode::Busy);
        VERIFY_REFUSED(restoreBackup(m_backup, file(), m_now), ErrorCode::Busy);
        QCOMPARE(there("*.restor*") + there("replaced-*"), QStringList());
        for (const int end : {done[0], done[1], ready[0], ready[1]})
            close(end);
        QCOMPARE(waitpid(other, nullptr, 0), other);
        VERIFY_DONE(expectClosed(file()));
        VERIFY_DONE(restoreBackup(m_backup, file(), m_now));
        QCOMPARE(attemptsIn(file()), 0);
    }

    /// The restore is stopped at each step in turn, with leftovers of a killed restore in the folder.
    void aStoppedRestoreReplacesNothing()
    {
        const QByteArray before = contentOf(file());
        for (int most = 0;; ++most) {
            QVERIFY(putNoise(file() + ".restoring") && putNoise(file() + ".restoring-journal"));
            int looks = 0;
            const auto done = restoreBackup(m_backup, file(), m_now, [&looks, most] { return looks++ < most; });
            if (done)
                break;
            VERIFY_REFUSED(done, ErrorCode::FileUnwritable);
            QCOMPARE(contentOf(file()), before);
            QCOMPARE(there(), QStringList{"school.sqlite"});
            QVERIFY(most < 100);
        }
        QCOMPARE(attemptsIn(file()), 0);
        QCOMPARE(there("*.restor*"), QStringList());
        const auto stopped = backUp(m_rig.school().db, m_folder->path(), m_now, [] { return false; });
        VERIFY_REFUSED(stopped, ErrorCode::FileUnwritable);
        QVERIFY(there("backup*").isEmpty());
    }

    /// The file has two names. Each program would write a log next to the name that it opened.
    void aFileOfTwoNamesIsRefused()
    {
        const QString other = at("other.sqlite");
        QCOMPARE(link(qPrintable(file()), qPrintable(other)), 0);
        for (const QString& name : {file(), other}) {
            VERIFY_REFUSED(Database::open(name), ErrorCode::FileUnreadable);
            VERIFY_REFUSED(restoreBackup(m_backup, name, m_now), ErrorCode::FileUnreadable);
        }
        QCOMPARE(there(), (QStringList{"other.sqlite", "school.sqlite"}));
        QVERIFY(QFile::remove(other));
        QCOMPARE(attemptsIn(file()), 1);
        // A backup is not written to, so several names are harmless. Programs that save disk space create them.
        QVERIFY(QFile::copy(m_backup, at("backup.sqlite")));
        QCOMPARE(link(qPrintable(at("backup.sqlite")), qPrintable(other)), 0);
        VERIFY_DONE(restoreBackup(at("backup.sqlite"), file(), m_now));
    }

    /// Files with names, marks and password hashes are readable for their owner only, also while they grow.
    void onlyTheOwnerReadsWhatIsKept()
    {
        const auto others = QFile::ReadGroup | QFile::ReadOther | QFile::WriteGroup | QFile::WriteOther;
        for (const char* end : {"", "-wal", "-shm"})
            QVERIFY2(!(QFile::permissions(m_rig.address() + end) & others), end);
        widest = 0;
        VERIFY_DONE(Database::open(at("new.sqlite")));
        QCOMPARE(widest, mode_t{0600});
        const QString backup = backUp(m_rig.school().db, m_folder->path(), m_now).value();
        QVERIFY(!(QFile::permissions(backup) & others));
        QVERIFY(QFile::setPermissions(backup, QFile::ReadOwner | others));
        QVERIFY(QFile::setPermissions(file(), QFile::ReadOwner | QFile::WriteOwner));
        VERIFY_DONE(restoreBackup(backup, file(), m_now));
        QVERIFY(!(QFile::permissions(file()) & others));
        QCOMPARE(widest, mode_t{0600});
        VERIFY_DONE(restoreBackup(backup, at("nothing.sqlite"), m_now));
        QVERIFY(!(QFile::permissions(at("nothing.sqlite")) & others));
        // Permissions that the owner has given to the group are preserved.
        QVERIFY(QFile::setPermissions(file(), QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup));
        VERIFY_DONE(restoreBackup(backup, file(), m_now));
        QVERIFY(QFile::permissions(file()) & QFile::ReadGroup);
    }

    void aFullDiskIsToldAndChangesNothing()
    {
        VERIFY_DONE(Database::open(file()));  // creates the write-ahead log
        {
            const support::FullDisk full(10);
            VERIFY_REFUSED(Database::open(file()), ErrorCode::FileUnwritable);
        }
        auto open = Database::open(file());
        VERIFY_DONE(open);
        {
            const support::FullDisk full(10);
            VERIFY_REFUSED(backUp((*open)->handle(), at("b"), m_now), ErrorCode::FileUnwritable);
        }
        const auto backup = backUp((*open)->handle(), at("b"), m_now);
        VERIFY_DONE(backup);
        open->reset();
        QCOMPARE(attemptsIn(*backup), 1);
        {
            const support::FullDisk full(100'000);
            VERIFY_REFUSED(restoreBackup(m_backup, file(), m_now), ErrorCode::FileUnwritable);
        }
        QCOMPARE(attemptsIn(file()), 1);
    }

    void whatCannotBeWrittenIsRefused()
    {
        VERIFY_DONE(Database::open(file()));  // creates the write-ahead log
        QCOMPARE(chmod(qPrintable(file()), 0444) + chmod(qPrintable(m_folder->path()), 0555), 0);
        {
            const auto back = asNobody();
            VERIFY_REFUSED(Database::open(file()), ErrorCode::FileUnwritable, "read-only");
        }
        QCOMPARE(there(), QStringList{"school.sqlite"});
        QCOMPARE(chmod(qPrintable(m_folder->path()), 0755), 0);
    }

    /// SQLite gives the -shm file of a read-only database read-only permissions too, and the file stays. The database
    /// must be writable again later all the same.
    void whatCouldNotBeWrittenOnceCanBeLater()
    {
        QVERIFY(runOn(file(), {"PRAGMA journal_mode = WAL"}));
        QCOMPARE(chmod(qPrintable(m_folder->path()), 0777) + chmod(qPrintable(file()), 0444), 0);
        QCOMPARE(geteuid() == 0 ? chown(qPrintable(file()), 65534, 65534) : 0, 0);
        const auto back = asNobody();
        QVERIFY(isReadOnly(file()));
        const QString change = "UPDATE people SET given_name = 'Eve'";
        const auto closed = Database::open(file());
        QVERIFY(!closed || !execute((*closed)->handle(), change, "write"));
        QVERIFY(isReadOnly(file() + "-shm"));
        QCOMPARE(chmod(qPrintable(file()), 0644), 0);
        QVERIFY(!isReadOnly(file()));
        const auto open = Database::open(file());
        VERIFY_DONE(open);
        VERIFY_DONE(execute((*open)->handle(), change, "write"));
    }

    /// The backup is in a read-only folder and is read-only itself.
    void aReadOnlyBackupIsRestored()
    {
        QVERIFY(QDir().mkdir(at("medium")));
        const QString backup = at("medium/backup.sqlite");
        QVERIFY(QFile::copy(m_backup, backup));
        QCOMPARE(chmod(qPrintable(backup), 0444) + chmod(qPrintable(at("medium")), 0555), 0);
        QCOMPARE(chmod(qPrintable(m_folder->path()), 0777) + chmod(qPrintable(file()), 0666), 0);
        {
            const auto back = asNobody();
            VERIFY_DONE(restoreBackup(backup, at("mine.sqlite"), m_now));
            VERIFY_DONE(execute(Database::open(at("mine.sqlite")).value()->handle(),
                                "UPDATE settings SET value = value", "write"));
        }
        QCOMPARE(QDir(at("medium")).entryList(QDir::Files), QStringList{"backup.sqlite"});
        QCOMPARE(chmod(qPrintable(at("medium")), 0755), 0);
        VERIFY_REFUSED(restoreBackup(m_backup, at("nowhere/x.sqlite"), m_now), ErrorCode::FileMissing);
    }

    void backupsAreThinnedOut()
    {
        QStringList files{"somebody-elses.sqlite", "before-schema-3-2026-01-01-00.00.00.sqlite"};
        const QDateTime when(QDate(2026, 11, 20), QTime(18, 0), Qt::UTC);
        for (int day = 0; day < 400; ++day)
            for (const int hour : {9, 18})
                files += "backup-" +
                         QDateTime(when.date().addDays(-day), QTime(hour, 0), Qt::UTC).toString("yyyy-MM-dd-HH.mm.ss") +
                         ".sqlite";
        const QStringList gone = tooMany(files);
        QStringList kept;
        for (const QString& file : std::as_const(files))
            if (!gone.contains(file))
                kept += file;
        QVERIFY(kept.contains("somebody-elses.sqlite"));
        QVERIFY(kept.contains("before-schema-3-2026-01-01-00.00.00.sqlite"));
        // The last backup of each of twelve days is kept.
        for (int day = 0; day < 12; ++day)
            QVERIFY(kept.contains("backup-" + when.addDays(-day).toString("yyyy-MM-dd-HH.mm.ss") + ".sqlite"));
        // The copy from before the migration is kept longer than those that were made after it.
        QVERIFY(kept.contains("backup-2026-11-20-09.00.00.sqlite"));
        QVERIFY(kept.contains("backup-2026-11-19-09.00.00.sqlite"));
        QVERIFY(!kept.contains("backup-2026-11-18-09.00.00.sqlite"));
        // Twelve days belong to two or three of ten weeks, and those weeks to three or four of nine months.
        QVERIFY2(kept.size() - 4 >= 12 + 7 + 5 && kept.size() - 4 <= 12 + 9 + 8, qPrintable(kept.join('\n')));
        QVERIFY(kept.contains("backup-2026-03-31-18.00.00.sqlite"));
        QVERIFY(!kept.contains("backup-2026-02-28-18.00.00.sqlite"));
        QVERIFY(tooMany(kept).isEmpty());
    }

    void eachSchoolThinsItsOwnBackups()
    {
        for (const char* hour : {"09", "18"})
            for (int day = 1; day <= 5; ++day)
                for (const QString& backup : {m_backup, m_other})
                    QVERIFY(QFile::copy(backup, at(QStringLiteral("backup-2026-11-1%1-%2.00.0%3.sqlite")
                                                       .arg(day)
                                                       .arg(QLatin1String(hour))
                                                       .arg(backup == m_other ? 1 : 0))));
        const QStringList gone = removeOldBackups(m_rig.school().db, m_folder->path());
        QCOMPARE(gone, (QStringList{at("backup-2026-11-13-09.00.00.sqlite"), at("backup-2026-11-12-09.00.00.sqlite"),
                                    at("backup-2026-11-11-09.00.00.sqlite")}));
        QCOMPARE(backupsIn(m_folder->path()).size(), 17);
    }

    void aMigrationKeepsACopyIfItChangesSomething()
    {
        const auto steps = shippedMigrations();
        VERIFY_DONE(steps);
        const QString old = at("old.sqlite");
        const auto saved = [&old] { return QDir(backupFolder(old)).entryList({"before-schema-*"}, QDir::Files); };
        const int version = static_cast<int>(steps->size()) - 1;
        {
            const RawFile raw(old);
            VERIFY_DONE(execute(raw.handle(), QStringLiteral("PRAGMA application_id = %1").arg(dialect::kApplicationId),
                                "mark"));
            VERIFY_DONE(migrate(raw.handle(), std::span(*steps).first(steps->size() - 1)));
            VERIFY_DONE(execute(raw.handle(), "INSERT INTO enrolments VALUES (99, 99)", "break a key"));
        }
        // The migrated copy does not pass the check, so the file stays as it is.
        VERIFY_REFUSED(Database::open(old), ErrorCode::BadStructure);
        QCOMPARE(ask(RawFile(old).handle(), "PRAGMA user_version", "look")->toInt(), version);
        QVERIFY(saved().isEmpty());
        // No copy is kept of a file that could not be migrated.
        QVERIFY(runOn(old, {"DELETE FROM enrolments", "PRAGMA user_version = 2"}));
        QVERIFY(!Database::open(old).has_value());
        QVERIFY(saved().isEmpty());
        QVERIFY(runOn(old, {QStringLiteral("PRAGMA user_version = %1").arg(version)}));
        VERIFY_DONE(Database::open(old));
        QCOMPARE(saved().size(), 1);
        VERIFY_DONE(verifyBackup(QDir(backupFolder(old)).filePath(saved().first())));
    }

private:
    [[nodiscard]] QString at(const QString& name) const { return m_folder->filePath(name); }
    [[nodiscard]] QString file() const { return at("school.sqlite"); }
    [[nodiscard]] QStringList there(const QString& names = "*") const
    {
        return QDir(m_folder->path()).entryList({names}, QDir::Files | QDir::Hidden);
    }

    SchoolRig m_rig{false};
    std::unique_ptr<QTemporaryDir> m_folder;
    QTemporaryDir m_backups;
    QString m_backup;   ///< a backup without an attempt
    QString m_school;   ///< a backup with an attempt
    QString m_crashed;  ///< a database with an attempt that is only in the log next to it
    QString m_empty;    ///< a database without users
    QString m_other;    ///< a backup of another school
    const QDateTime m_now = QDateTime(QDate(2026, 11, 21), QTime(12, 0), Qt::UTC);
};

CUSP_TEST(TestRestoring)
#include "tst_restoring.moc"
