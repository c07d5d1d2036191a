// SPDX-License-Identifier: GPL-3.0-or-later
// A backup in the place of a school, on file systems that can less, killed between any two steps, and beside files that
// only are called nearly so.
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <functional>
#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QScopeGuard>
#include <QTest>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "database/sql/Backups.h"
#include "database/sql/Statement.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/FullDisk.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::addAttempt;
using support::SchoolRig;

namespace {

/// What the file system of this process can do, and what it was asked.
struct Disk
{
    int renamesLeft = -1;  ///< then the program is killed; negative: it is not
    int unlinksLeft = -1;  ///< the same
    bool knowsExchange = true;
    bool knowsNoReplace = true;
    bool knowsLocks = true;
    mode_t widestOfCopies = 0;
    mode_t widestOfNew = 0;
    std::function<void()> beforeExchange;  ///< once
};
Disk disk;

void noteMode(const QByteArray& path, mode_t mode)
{
    if (path.contains(".restoring"))
        disk.widestOfCopies |= mode;
    if (path.endsWith("new.sqlite"))
        disk.widestOfNew |= mode;
}

}  // namespace

// In the place of the C library's, for Qt as well.
extern "C" {

int renameat2(int fromFolder, const char* from, int toFolder, const char* to, unsigned int flags) noexcept
{
    if (disk.renamesLeft >= 0 && disk.renamesLeft-- == 0)
        static_cast<void>(raise(SIGKILL));
    if (((flags & RENAME_EXCHANGE) != 0 && !disk.knowsExchange) ||
        ((flags & RENAME_NOREPLACE) != 0 && !disk.knowsNoReplace)) {
        errno = EINVAL;
        return -1;
    }
    if (const auto before = std::exchange(disk.beforeExchange, {}); (flags & RENAME_EXCHANGE) != 0 && before)
        before();
    else if (before)
        disk.beforeExchange = before;
    return static_cast<int>(syscall(SYS_renameat2, fromFolder, from, toFolder, to, flags));
}

int unlink(const char* path) noexcept
{
    if (disk.unlinksLeft >= 0 && disk.unlinksLeft-- == 0)
        static_cast<void>(raise(SIGKILL));
    return static_cast<int>(syscall(SYS_unlinkat, AT_FDCWD, path, 0));
}

int flock(int file, int operation) noexcept
{
    if (!disk.knowsLocks) {
        errno = ENOLCK;
        return -1;
    }
    return static_cast<int>(syscall(SYS_flock, file, operation));
}

// Qt makes its files by it.
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

class TestRestoring : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void aBackupThatIsCalledLikeACopyIsKept_data();
    void aBackupThatIsCalledLikeACopyIsKept();
    void whatAKilledRestoreHasLeftIsSweptAway();
    void atEveryMomentASchoolIsThere();
    void whereNamesAreNotExchangedTheSchoolIsFound();
    void whatWasMovedAsideLaterThanTheBackupIsOffered();
    void aDiskWithoutLocksIsRestoredTo();
    void theLockOfAnotherHoldsUpNobody();
    void theCopyIsNeverForOthers();
    void whoOpensItInTheLastMomentKeepsIt();
    void aNewSchoolIsNeverForOthers();
    void aFileOfTwoNamesIsRefused();
    void aNameThatAKilledRestoreHasLeftIsRemoved();
    void onlyARestoresOwnNamesAreRemoved_data();
    void onlyARestoresOwnNamesAreRemoved();
    void onlyWhatADrillOrABackupLeftIsSwept();
    void aFullDiskIsNotTheBackupsFault();

private:
    [[nodiscard]] QString file() const { return m_folder->filePath("school.sqlite"); }
    [[nodiscard]] QStringList there(const QString& names) const
    {
        return QDir(m_folder->path()).entryList({names}, QDir::Files | QDir::Hidden);
    }
    /// Restores in a process of its own. Whether it came to its end.
    [[nodiscard]] bool isRestored(int killedBeforeRename, int killedBeforeUnlink = -1) const;

    std::unique_ptr<QTemporaryDir> m_folder;
    QTemporaryDir m_backups;
    QString m_backup;  ///< without an attempt; in the school is one
    QString m_school;
    const QDateTime m_now = QDateTime(QDate(2026, 11, 21), QTime(12, 0), Qt::UTC);
};

namespace {

int attemptsIn(const QString& file)
{
    const auto database =
        QFile::exists(file)
            ? Database::open(file)
            : core::Result<std::unique_ptr<Database>>(core::unexpected(ErrorCode::FileMissing, "it is not there"));
    return database ? ask((*database)->handle(), "SELECT count(*) FROM attempts", "count")->toInt() : -1;
}

int namesOf(const QString& file)
{
    struct stat found
    {};
    return stat(QFile::encodeName(file).constData(), &found) == 0 ? static_cast<int>(found.st_nlink) : 0;
}

}  // namespace

void TestRestoring::init()
{
    disk = {};
    m_folder = std::make_unique<QTemporaryDir>();
    if (m_backup.isEmpty()) {
        SchoolRig rig(false);
        rig.populate();
        m_backup = backUp(rig.school().db, m_backups.path(), rig.nowUtc).value();
        VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 900), {}));
        m_school = backUp(rig.school().db, m_backups.path(), rig.nowUtc.addSecs(1)).value();
    }
    QVERIFY(QFile::copy(m_school, file()));
}

bool TestRestoring::isRestored(int killedBeforeRename, int killedBeforeUnlink) const
{
    const pid_t other = fork();
    if (other == 0) {
        disk.renamesLeft = killedBeforeRename;
        disk.unlinksLeft = killedBeforeUnlink;
        _exit(restoreBackup(m_backup, file(), m_now).has_value() ? 0 : 1);
    }
    int status = 0;
    return waitpid(other, &status, 0) == other && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void TestRestoring::aBackupThatIsCalledLikeACopyIsKept_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("as older programs left it") << "school.sqlite.restoring";
    QTest::newRow("a user's") << "school.sqlite.restoring-mine";
    QTest::newRow("a copy itself") << "school.sqlite.restoring" + QString(32, 'a');
}

void TestRestoring::aBackupThatIsCalledLikeACopyIsKept()
{
    QFETCH(QString, name);
    const QString backup = m_folder->filePath(name);
    const QStringList others{"school.sqlite.restoring-notes.txt", "school.sqlite.restoring.sqlite",
                             "school.sqlite.restoring" + QString(32, 'b') + ".txt"};
    QVERIFY(QFile::copy(m_backup, backup));
    for (const QString& other : others)
        QVERIFY(QFile::copy(m_backup, m_folder->filePath(other)));
    VERIFY_DONE(restoreBackup(backup, file(), m_now));
    QCOMPARE(attemptsIn(file()), 0);
    QVERIFY(QFile::exists(backup));
    for (const QString& other : others)
        QVERIFY2(QFile::exists(m_folder->filePath(other)), qPrintable(other));
}

void TestRestoring::whatAKilledRestoreHasLeftIsSweptAway()
{
    for (const char* end : {"", "-wal", "-shm", "-journal"})
        QVERIFY(QFile::copy(m_backup, file() + ".restoring" + QString(32, 'a') + end));
    VERIFY_DONE(restoreBackup(m_backup, file(), m_now));
    QCOMPARE(there("*.restor*"), QStringList());
}

/// Whoever opens it then would begin a new one.
void TestRestoring::atEveryMomentASchoolIsThere()
{
    bool isDone = false;
    for (int renames = 0; !isDone; ++renames) {
        init();
        isDone = isRestored(renames);
        const int kept = attemptsIn(file());
        QVERIFY(kept == 1 || (kept == 0 && attemptsIn(m_folder->filePath(there("replaced-*").value(0))) == 1));
        QVERIFY(renames > 0 || !isDone);
    }
    QCOMPARE(attemptsIn(file()), 0);
    QCOMPARE(there("*.restor*"), QStringList());
    QCOMPARE(there("replaced-*"), QStringList{"replaced-2026-11-21-12.00.00-school.sqlite"});
}

/// Also after somebody has begun a new school in its place.
void TestRestoring::whereNamesAreNotExchangedTheSchoolIsFound()
{
    disk.knowsExchange = false;
    bool wasGone = false;
    bool isDone = false;
    for (int renames = 0; !isDone; ++renames) {
        init();
        disk.knowsExchange = false;
        isDone = isRestored(renames);
        if (QFile::exists(file()))
            continue;
        wasGone = true;
        QCOMPARE(attemptsIn(newestKept(file(), m_now)), 1);
        QVERIFY(Database::open(file()).has_value());
        QVERIFY(liesEmpty(file()));
        QCOMPARE(attemptsIn(newestKept(file(), m_now)), 1);
    }
    QVERIFY(wasGone);
    QCOMPARE(attemptsIn(file()), 0);
    QCOMPARE(attemptsIn(m_folder->filePath(there("replaced-*").value(0))), 1);
    QCOMPARE(there("*.restor*"), QStringList());
}

void TestRestoring::whatWasMovedAsideLaterThanTheBackupIsOffered()
{
    QVERIFY(QDir().mkpath(backupFolder(file())));
    const QString backup = backupFolder(file()) + "/backup-2026-11-20-10.15.00.sqlite";
    const QString older = m_folder->filePath("replaced-2026-11-19-10.15.00-school.sqlite");
    const QString later = m_folder->filePath("replaced-2026-11-20-10.15.01-school.sqlite");
    QVERIFY(QFile::copy(m_backup, backup) && QFile::rename(file(), older));
    QCOMPARE(newestKept(file(), m_now), backup);
    QVERIFY(QFile::copy(older, later));
    QCOMPARE(newestKept(file(), m_now), later);
    QCOMPARE(madeAt(later), QDateTime(QDate(2026, 11, 20), QTime(10, 15, 1), Qt::UTC));
    // Under a clock that was wrong: it is no longer newer than all that will ever be.
    const QString odd = m_folder->filePath("replaced-2031-01-01-00.00.00-school.sqlite");
    QVERIFY(QFile::copy(m_backup, odd));
    QCOMPARE(newestKept(file(), m_now), later);
    QVERIFY(QFile::remove(later) && QFile::remove(older));
    QCOMPARE(newestReplaced(file(), m_now), odd);
    QCOMPARE(newestKept(file(), m_now), backup);
    QVERIFY(QFile::remove(odd) && QFile::copy(m_school, later));
    // Of a new school that a backup has replaced nobody wants anything back.
    QVERIFY(Database::open(file()).has_value());
    const QString empty = m_folder->filePath("replaced-2026-11-20-10.15.02-school.sqlite");
    QVERIFY(QFile::rename(file(), empty));
    QCOMPARE(newestKept(file(), m_now), later);
    // Where a school is, it was moved aside because somebody wanted so.
    QVERIFY(QFile::copy(m_backup, file()));
    QCOMPARE(newestKept(file(), m_now), backup);
}

void TestRestoring::aDiskWithoutLocksIsRestoredTo()
{
    disk.knowsLocks = false;
    const QString others = file() + ".restoring" + QString(32, 'a');  // perhaps still being made
    QVERIFY(QFile::copy(m_backup, others));
    VERIFY_DONE(restoreBackup(m_backup, file(), m_now));
    QCOMPARE(attemptsIn(file()), 0);
    QVERIFY(QFile::exists(others));
}

/// As an older program left it that was killed.
void TestRestoring::theLockOfAnotherHoldsUpNobody()
{
    QFile lock(file() + ".restore-lock");
    QVERIFY(lock.open(QIODevice::WriteOnly));
    QCOMPARE(chmod(qPrintable(lock.fileName()), 0), 0);
    for (const QString& folder : {m_folder->path(), m_backups.path()})
        QCOMPARE(chmod(qPrintable(folder), 0777), 0);
    QCOMPARE(chmod(qPrintable(m_backup), 0644), 0);
    const QString own = m_folder->filePath("own.sqlite");
    QVERIFY(QFile::rename(file() + ".restore-lock", own + ".restore-lock"));
    // To root no file is closed.
    constexpr uid_t kNobody = 65534;
    const uid_t me = geteuid();
    QCOMPARE(me == 0 ? seteuid(kNobody) : 0, 0);
    const auto back = qScopeGuard([me] { QCOMPARE(seteuid(me), 0); });
    VERIFY_DONE(restoreBackup(m_backup, own, m_now));
}

void TestRestoring::theCopyIsNeverForOthers()
{
    QVERIFY(QFile::setPermissions(m_backup, QFile::ReadOwner | QFile::ReadGroup | QFile::ReadOther));
    QVERIFY(QFile::setPermissions(file(), QFile::ReadOwner | QFile::WriteOwner));
    VERIFY_DONE(restoreBackup(m_backup, file(), m_now));
    QCOMPARE(disk.widestOfCopies, mode_t{0600});
    QCOMPARE(QFile::permissions(file()) & (QFile::ReadGroup | QFile::ReadOther), QFile::Permissions());
}

/// After the last look, and before the names are exchanged.
void TestRestoring::whoOpensItInTheLastMomentKeepsIt()
{
    std::array<int, 2> toTest{};
    std::array<int, 2> toOther{};
    QCOMPARE(pipe(toTest.data()) + pipe(toOther.data()), 0);
    pid_t other = 0;
    char byte = 0;
    disk.beforeExchange = [&] {
        other = fork();
        if (other == 0) {
            close(toOther[1]);
            const auto database = Database::open(file());
            const bool written = database && execute((*database)->handle(), "CREATE TABLE late (id INTEGER)", "write");
            static_cast<void>(write(toTest[1], written ? "y" : "n", 1));
            static_cast<void>(read(toOther[0], &byte, 1));  // until the test closes its end
            _exit(0);                                       // as one that is killed: its log stays
        }
        static_cast<void>(read(toTest[0], &byte, 1));
    };
    const auto restored = restoreBackup(m_backup, file(), m_now);
    close(toOther[1]);
    int status = 0;
    QCOMPARE(waitpid(other, &status, 0), other);
    for (const int end : {toTest[0], toTest[1], toOther[0]})
        close(end);
    QCOMPARE(byte, 'y');
    VERIFY_REFUSED(restored, ErrorCode::Busy);
    QCOMPARE(there("replaced-*") + there("*.restor*"), QStringList());
    QCOMPARE(attemptsIn(file()), 1);
    const auto database = Database::open(file());
    VERIFY_DONE(database);
    QCOMPARE(ask((*database)->handle(), "SELECT count(*) FROM late", "count")->toInt(), 0);
}

void TestRestoring::aNewSchoolIsNeverForOthers()
{
    QVERIFY(Database::open(m_folder->filePath("new.sqlite")).has_value());
    QCOMPARE(disk.widestOfNew, mode_t{0600});
}

/// Each program would have its own log beside the name by which it was opened.
void TestRestoring::aFileOfTwoNamesIsRefused()
{
    const QString other = m_folder->filePath("other.sqlite");
    QCOMPARE(link(qPrintable(file()), qPrintable(other)), 0);
    for (const QString& name : {file(), other}) {
        VERIFY_REFUSED(Database::open(name), ErrorCode::FileUnreadable);
        const auto restored = restoreBackup(m_backup, name, m_now);
        VERIFY_REFUSED(restored, ErrorCode::FileUnreadable);
        QVERIFY2(restored.error().detail.find("hard links") != std::string::npos, restored.error().detail.c_str());
    }
    QCOMPARE(there("*"), (QStringList{"other.sqlite", "school.sqlite"}));
    QVERIFY(QFile::remove(other));
    QCOMPARE(attemptsIn(file()), 1);
    // Of a backup nobody writes the names: programs that save disk space give it several.
    const QString backup = m_folder->filePath("backup.sqlite");
    QVERIFY(QFile::copy(m_backup, backup));
    QCOMPARE(link(qPrintable(backup), qPrintable(other)), 0);
    VERIFY_DONE(restoreBackup(backup, file(), m_now));
    QCOMPARE(attemptsIn(file()), 0);
}

/// Where a file system knows no name change that replaces nothing, the new name is given before the old one is removed.
void TestRestoring::aNameThatAKilledRestoreHasLeftIsRemoved()
{
    int withTwoNames = 0;
    bool isDone = false;
    for (int unlinks = 0; !isDone; ++unlinks) {
        init();
        disk.knowsExchange = false;
        disk.knowsNoReplace = false;
        isDone = isRestored(-1, unlinks);
        if (!QFile::exists(file()))
            continue;
        withTwoNames += static_cast<int>(namesOf(file()) > 1);
        const int kept = attemptsIn(file());
        QVERIFY(kept == 1 || (kept == 0 && attemptsIn(m_folder->filePath(there("replaced-*").value(0))) == 1));
        QCOMPARE(namesOf(file()), 1);
    }
    // The old file's, and the new one's.
    QCOMPARE(withTwoNames, 2);
    QCOMPARE(attemptsIn(file()), 0);
}

void TestRestoring::onlyARestoresOwnNamesAreRemoved_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("isOwn");
    const QString uid(32, 'a');
    QTest::newRow("moved aside") << "replaced-2026-11-21-12.00.00-school.sqlite" << true;
    QTest::newRow("a copy") << "school.sqlite.restoring" + uid << true;
    QTest::newRow("another school's") << "replaced-2026-11-21-12.00.00-other.sqlite" << false;
    QTest::newRow("without a moment") << "replaced-school.sqlite" << false;
    QTest::newRow("a user's") << "school.sqlite.restoring-mine" << false;
    QTest::newRow("more than a copy") << "school.sqlite.restoring" + uid + ".txt" << false;
    QTest::newRow("elsewhere") << "elsewhere/replaced-2026-11-21-12.00.00-school.sqlite" << false;
}

void TestRestoring::onlyARestoresOwnNamesAreRemoved()
{
    QFETCH(QString, name);
    QFETCH(bool, isOwn);
    const QString other = m_folder->filePath(name);
    QVERIFY(QDir().mkpath(QFileInfo(other).path()));
    QCOMPARE(link(qPrintable(file()), qPrintable(other)), 0);
    // Who restores there may be between the two steps.
    disk.knowsLocks = false;
    VERIFY_REFUSED(Database::open(file()), ErrorCode::FileUnreadable);
    disk.knowsLocks = true;
    QVERIFY(QFile::copy(m_backup, other + "-wal"));
    VERIFY_REFUSED(Database::open(file()), ErrorCode::FileUnreadable);
    QVERIFY(QFile::remove(other + "-wal"));
    QVERIFY(QFile::exists(other));
    QCOMPARE(Database::open(file()).has_value(), isOwn);
    QCOMPARE(QFile::exists(other), !isOwn);
    // What is called so and is a file of its own.
    QVERIFY(QFile::exists(other) ? QFile::remove(other) : true);
    QVERIFY(QFile::copy(m_backup, other));
    QVERIFY(QDir().mkpath(m_folder->filePath("more")));
    QCOMPARE(link(qPrintable(file()), qPrintable(m_folder->filePath("more/school.sqlite"))), 0);
    VERIFY_REFUSED(Database::open(file()), ErrorCode::FileUnreadable);
    QVERIFY(QFile::exists(other));
}

void TestRestoring::onlyWhatADrillOrABackupLeftIsSwept()
{
    const QString uid(32, 'a');
    const QStringList others{"drill-photos/a.jpg",
                             "drill-2025au/a.jpg",
                             "cusp-drill-" + uid + "-abcdef/thesis",
                             "drill-report",
                             "old.sqlite.parts/a.jpg",
                             "archive.sqlite.part1.rar",
                             "old.sqlite.partial-notes.txt",
                             "backup-2026-11-20-10.15.00.sqlite.part-" + uid + ".txt"};
    const QStringList ours{"cusp-drill-" + uid + "-ghijkl/restored.sqlite",
                           "cusp-drill-" + uid + "-ghijkl/backup-2026-11-20-10.15.00.sqlite",
                           "backup-2026-11-20-10.15.00.sqlite.part-" + uid,
                           "backup-2026-11-20-10.15.00.sqlite.part-" + uid + "-journal"};
    const auto age = [](const QString& path) {
        const std::array<timespec, 2> longAgo{};
        return utimensat(AT_FDCWD, QFile::encodeName(path).constData(), longAgo.data(), 0) == 0;
    };
    for (const QString& name : others + ours) {
        const QFileInfo info(m_folder->filePath(name));
        QVERIFY(QDir().mkpath(info.path()));
        QVERIFY(QFile::copy(m_backup, info.filePath()) && age(info.filePath()));
    }
    for (const QString& name : others + ours)
        if (name.contains('/'))
            QVERIFY(age(QFileInfo(m_folder->filePath(name)).path()));
    const auto database = Database::open(file());
    VERIFY_DONE(database);
    VERIFY_DONE(restoreDrill((*database)->handle()));
    VERIFY_DONE(backUp((*database)->handle(), m_folder->path(), m_now));
    for (const QString& other : others)
        QVERIFY2(QFile::exists(m_folder->filePath(other)), qPrintable(other));
    for (const QString& one : ours)
        QVERIFY2(!QFile::exists(m_folder->filePath(one)), qPrintable(one));
    QCOMPARE(QDir(m_folder->path()).entryList({"cusp-drill-*"}, QDir::Dirs).size(), 1);
}

void TestRestoring::aFullDiskIsNotTheBackupsFault()
{
    core::Result<QString> done = QString();
    {
        const support::FullDisk full(100'000);
        done = restoreBackup(m_backup, file(), m_now);
    }
    VERIFY_REFUSED(done, ErrorCode::FileUnwritable);
    QVERIFY2(done.error().detail.rfind("database " + file().toStdString(), 0) == 0, done.error().detail.c_str());
    QCOMPARE(attemptsIn(file()), 1);
}

QTEST_GUILESS_MAIN(TestRestoring)
#include "tst_restoring.moc"
