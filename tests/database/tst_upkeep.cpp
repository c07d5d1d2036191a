// SPDX-License-Identifier: GPL-3.0-or-later
// Backups, copies between engines, class lists, and what a check finds.
#include <array>
#include <csignal>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QScopeGuard>
#include <QSqlError>
#include <QSqlQuery>
#include <QTest>
#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/Rng.h"
#include "database/Csv.h"
#include "database/sql/Backups.h"
#include "database/sql/Check.h"
#include "database/sql/Copy.h"
#include "database/sql/Dialect.h"
#include "database/sql/Export.h"
#include "database/sql/Migrations.h"
#include "database/sql/Overview.h"
#include "database/sql/Recordings.h"
#include "database/sql/Roster.h"
#include "database/sql/RowSum.h"
#include "database/sql/Statement.h"
#include "tests/database/Sample.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/FullDisk.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::addAttempt;
using support::makeSample;
using support::SchoolRig;

namespace {

std::vector<lessons::Lesson> madeLessons(const std::vector<std::string>& ids)
{
    std::vector<lessons::Lesson> made;
    for (const std::string& id : ids) {
        lessons::Lesson lesson;
        lesson.id = id;
        lesson.hash = std::string(64, '1');
        lesson.rubric.hash = std::string(64, '2');
        for (const auto& [criterion, weight] : {std::pair("outline", 400), std::pair("depth", 600)}) {
            lessons::CriterionRule rule;
            rule.id = criterion;
            rule.weightTenths = weight;
            lesson.rubric.criteria.push_back(rule);
        }
        made.push_back(lesson);
    }
    return made;
}

int attemptsIn(const QString& file)
{
    const auto database = Database::open(file);
    return database ? ask((*database)->handle(), "SELECT count(*) FROM attempts", "count")->toInt() : -1;
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// On a file as it is, without the program's own checks.
bool runOn(const QString& file, const char* sql)
{
    sqlite3* opened = nullptr;
    const int begun = sqlite3_open(file.toUtf8().constData(), &opened);
    const std::unique_ptr<sqlite3, int (*)(sqlite3*)> db(opened, sqlite3_close);
    return begun == SQLITE_OK && sqlite3_exec(db.get(), sql, nullptr, nullptr, nullptr) == SQLITE_OK;
}

/// A connection to a file as it is, while it lives.
class RawFile
{
public:
    explicit RawFile(const QString& file)
    {
        QSqlDatabase db = QSqlDatabase::addDatabase("QSQLITE", kName);
        db.setDatabaseName(file);
        db.open();
    }
    ~RawFile()
    {
        handle().close();
        QSqlDatabase::removeDatabase(kName);
    }
    RawFile(const RawFile&) = delete;
    RawFile& operator=(const RawFile&) = delete;
    [[nodiscard]] QSqlDatabase handle() const { return QSqlDatabase::database(kName, false); }
    [[nodiscard]] QVariant first(const QString& sql) const
    {
        QSqlQuery query(handle());
        return query.exec(sql) && query.next() ? query.value(0) : QVariant();
    }

private:
    static constexpr const char* kName = "raw";
};

/// All rows of all tables, but for what nobody compares with the audit: when somebody was entered, and was here last.
std::map<QString, RowSum> sumsOf(const QSqlDatabase& db)
{
    const QStringList moments{"created_utc", "last_login_utc"};
    std::map<QString, RowSum> sums;
    for (const QString& table : db.tables()) {
        QStringList columns = columnsOf(db, table);
        if (table == u"people")
            columns.removeIf([&moments](const QString& column) { return moments.contains(column); });
        RowSum& sum = sums[table];
        QSqlQuery rows(db);
        if (!rows.exec(QStringLiteral("SELECT %1 FROM %2").arg(columns.join(u','), table)))
            qWarning("%s: %s", qPrintable(table), qPrintable(rows.lastError().text()));
        while (rows.next())
            sum.add(rows, columns.size());
    }
    return sums;
}

/// Writes noise over the page that a table begins on.
bool spoil(const QString& file, const char* table)
{
    constexpr qint64 kPage = 4096;
    qint64 page = 0;
    {
        const RawFile raw(file);
        page =
            raw.first(QStringLiteral("SELECT rootpage FROM sqlite_master WHERE name = '%1'").arg(table)).toLongLong();
    }
    QFile bytes(file);
    return page > 1 && bytes.open(QIODevice::ReadWrite) && bytes.seek((page - 1) * kPage) &&
           bytes.write(QByteArray(kPage, 'Z')) == kPage;
}

}  // namespace

class TestUpkeep : public QObject
{
    Q_OBJECT

private slots:
    void aBackupIsRestoredWithoutTheOldLog();
    void aRestoreKilledAtAnyMomentLosesNothing();
    void twoRestoresAtOnceLeaveTheFileThere();
    void whatARestoreCannotReplaceIsNamed();
    void whatARestoreMovedAsideIsFound();
    void aBackupThatCannotBeUsedReplacesNothing();
    void aFullDiskIsLookedAtAndBackedUp();
    void whatCannotBeWrittenIsLookedAtAndBackedUp();
    void whatCouldNotBeWrittenOnceCanBeLater();
    void aLogIsNeverThrownAway();
    void backupsAndMigrationsAtOnceLeaveEachOtherAlone();
    void aCrashedFileIsKnownByItsLog();
    void onlyTheOwnerReadsWhatIsKept();
    void aBackupThatCannotBeWrittenIsRestored();
    void nothingIsRestoredUnderAnotherProgram();
    void longWorkIsStopped();
    void whatAKilledBackupLeavesGoesWithTheNext();
    void eachSchoolThinsItsOwnBackups();
    void aCopyIsASchoolOfItsOwn();
    void aDamagedSchoolIsReplacedByItsOwnBackupOnly();
    void whatALaterProgramWroteIsNotReplaced();
    void aClockThatWasWrongHidesNoBackup();
    void anEmptyDatabaseIsNoBackup();
    void aSchoolWithoutPeopleIsNotOffered();
    void whatAMigrationLeftAsItWasIsNotCopied();
    void aDamagedFileReplacesNoBackup();
    void aDamagedDatabaseIsNotBackedUp();
    void whatIsNotWholeIsNoBackup_data();
    void whatIsNotWholeIsNoBackup();
    void aBackupOfAChangedAuditPushesNoGoodOneOut();
    void withoutASoundCopyNothingIsMigrated();
    void backupsAreThinnedOut();
    void everyOlderSchemaIsBroughtToTheNewest_data() { support::addEngines(); }
    void everyOlderSchemaIsBroughtToTheNewest();
    void commentsFromBeforeTheyCouldBeTakenBackStand_data() { support::addEngines(); }
    void commentsFromBeforeTheyCouldBeTakenBackStand();
    void aSchoolMovesBetweenEnginesAndBack();
    void aCopyThatFailsTakesAwayWhatItBrought();
    void aCopyThatIsKilledIsNoSchool_data() { support::addEngines(); }
    void aCopyThatIsKilledIsNoSchool();
    void aCheckNamesTheAttemptThatWasChanged_data() { support::addEngines(); }
    void aCheckNamesTheAttemptThatWasChanged();
    void newRowsAreNumberedAgain_data() { support::addEngines(); }
    void itIsCheckedWhileOthersWrite_data() { support::addEngines(); }
    void itIsCheckedWhileOthersWrite();
    void newRowsAreNumberedAgain();
    void numbersThatCannotBeSeenAreToldOf();
    void whatASpreadsheetWouldRunIsQuoted();
    void lettersAreCountedAndNotTheirHalves();
    void nobodySetsForHimselfWhatTheSchoolSets_data() { support::addEngines(); }
    void nobodySetsForHimselfWhatTheSchoolSets();
    void aClockWithoutAYearIsSaidToBeWrong_data() { support::addEngines(); }
    void aClockWithoutAYearIsSaidToBeWrong();
    void ofTwoCopiesAtOnceOneArrives_data() { support::addEngines(); }
    void ofTwoCopiesAtOnceOneArrives();
    void classListsAreTakenWholeOrNotAtAll_data() { support::addEngines(); }
    void aClassListSaysWhatIsWrongWithItsFile_data() { support::addEngines(); }
    void aClassListSaysWhatIsWrongWithItsFile();
    void noClassIsCalledWithABar_data() { support::addEngines(); }
    void noClassIsCalledWithABar();
    void classListsAreTakenWholeOrNotAtAll();
    void aMadeUpSchoolIsSound_data() { support::addEngines(); }
    void aMadeUpSchoolIsSound();
    void flippedBytesAreReportedOrHarmless();
};

void TestUpkeep::aBackupIsRestoredWithoutTheOldLog()
{
    QTemporaryDir elsewhere;
    SchoolRig rig(false);
    rig.populate();
    VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500), {}));
    const auto backup = backUp(rig.school().db, elsewhere.path(), rig.nowUtc);
    VERIFY_DONE(backup);
    QCOMPARE(QFileInfo(*backup).fileName(), QString("backup-2026-11-20-10.15.00.sqlite"));
    VERIFY_DONE(restoreDrill(rig.school().db));
    // Work goes on, and stands in the log beside the file when the station is gone.
    VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 900), {}));
    const QString copy = elsewhere.filePath("school.sqlite");
    for (const char* end : {"", "-wal"})
        QVERIFY(QFile::copy(rig.address() + end, copy + end));
    QVERIFY(QFileInfo(copy + "-wal").size() > 0);
    const auto replaced = restoreBackup(*backup, copy, rig.nowUtc);
    VERIFY_DONE(replaced);
    QVERIFY(!QFile::exists(copy + "-wal"));
    // What was there is whole by itself.
    QVERIFY(!QFile::exists(*replaced + "-wal"));
    QCOMPARE(attemptsIn(*replaced), 2);
    const auto restored = Database::open(copy);
    VERIFY_DONE(restored);
    QSqlQuery count((*restored)->handle());
    QVERIFY(count.exec("SELECT count(*) FROM attempts") && count.next());
    QCOMPARE(count.value(0).toInt(), 1);
    QVERIFY(checkDatabase((*restored)->handle(), {})->findings.empty());
    VERIFY_REFUSED(restoreBackup(elsewhere.filePath("nothing.sqlite"), copy, rig.nowUtc), ErrorCode::FileMissing);
}

/// And restored again: what was there lies whole in one of the files.
void TestUpkeep::aRestoreKilledAtAnyMomentLosesNothing()
{
    QTemporaryDir elsewhere;
    QString backup;
    const QString crashed = elsewhere.filePath("crashed.sqlite");
    {
        SchoolRig rig(false);
        rig.populate();
        backup = backUp(rig.school().db, elsewhere.path(), rig.nowUtc).value();
        VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 900), {}));
        for (const char* end : {"", "-wal"})
            QVERIFY(QFile::copy(rig.address() + end, crashed + end));
    }
    const QDateTime now(QDate(2026, 11, 20), QTime(12, 0), Qt::UTC);
    for (int round = 0; round < 40; ++round) {
        QTemporaryDir folder;
        const QString file = folder.filePath("school.sqlite");
        for (const char* end : {"", "-wal"})
            QVERIFY(QFile::copy(crashed + end, file + end));
        // First, what stops it between the file and its log.
        QFile inTheWay(folder.filePath("replaced-2026-11-20-12.00.00-school.sqlite-wal"));
        QVERIFY(round > 0 || inTheWay.open(QIODevice::WriteOnly));
        const pid_t other = fork();
        if (other == 0) {
            const bool isDone = restoreBackup(backup, file, now).has_value();
            _exit(isDone ? 0 : 1);
        }
        usleep(static_cast<useconds_t>(round) * 500);
        if (round > 0)
            kill(other, SIGKILL);
        QCOMPARE(waitpid(other, nullptr, 0), other);
        VERIFY_DONE(restoreBackup(backup, file, now.addSecs(1)));
        QCOMPARE(attemptsIn(file), 0);
        int most = 0;
        for (const QFileInfo& one : QDir(folder.path()).entryInfoList({"replaced-*.sqlite"}))
            most = std::max(most, attemptsIn(one.filePath()));
        QCOMPARE(most, 1);
    }
}

/// Two programs: one of them restores, and whoever comes too early is told so.
void TestUpkeep::twoRestoresAtOnceLeaveTheFileThere()
{
    QTemporaryDir folder;
    SchoolRig rig(false);
    rig.populate();
    const QString backup = backUp(rig.school().db, folder.filePath("backups"), rig.nowUtc).value();
    const QString file = folder.filePath("school.sqlite");
    QVERIFY(QFile::copy(backup, file));
    constexpr int kDone = 0;
    constexpr int kBusy = 1;
    constexpr int kOtherwise = 2;
    int restored = 0;
    for (int round = 0; round < 25; ++round) {
        std::array<pid_t, 2> others{};
        for (pid_t& other : others) {
            other = fork();
            if (other == 0) {
                const auto done = restoreBackup(backup, file, rig.nowUtc);
                if (!done && done.error().code != ErrorCode::Busy)
                    qWarning("%s", done.error().detail.c_str());
                _exit(done ? kDone : done.error().code == ErrorCode::Busy ? kBusy : kOtherwise);
            }
        }
        int done = 0;
        for (const pid_t other : others) {
            int status = 0;
            QCOMPARE(waitpid(other, &status, 0), other);
            QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) != kOtherwise);
            done += WEXITSTATUS(status) == kDone ? 1 : 0;
        }
        QVERIFY(done > 0);
        restored += done;
        QVERIFY(QFile::exists(file));
    }
    QCOMPARE(attemptsIn(file), 0);
    // What was there each time lies there whole, and nothing else is left.
    QCOMPARE(QDir(folder.path()).entryList({"replaced-*"}, QDir::Files).size(), restored);
    QVERIFY(QDir(folder.path()).entryList({"school.sqlite.*"}, QDir::Files).isEmpty());
}

/// Another program makes a file in the very moment in which none is there: what lies beside the file has to be moved,
/// too, here a log that was ended.
void TestUpkeep::whatARestoreCannotReplaceIsNamed()
{
    SchoolRig rig(false);
    rig.populate();
    VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500), {}));
    QTemporaryDir backups;
    const QString backup = backUp(rig.school().db, backups.path(), rig.nowUtc).value();
    for (int round = 0; round < 10; ++round) {
        QTemporaryDir folder;
        const QString file = folder.filePath("school.sqlite");
        QVERIFY(QFile::copy(backup, file));
        QFile log(file + "-journal");
        QVERIFY(log.open(QIODevice::WriteOnly) && log.putChar('\0'));
        log.close();
        const pid_t other = fork();
        if (other == 0)
            while (true)
                if (open(qPrintable(file), O_CREAT | O_EXCL | O_WRONLY, 0600) >= 0)
                    _exit(0);
        const auto done = restoreBackup(backup, file, rig.nowUtc);
        kill(other, SIGKILL);
        QCOMPARE(waitpid(other, nullptr, 0), other);
        const QStringList aside = QDir(folder.path()).entryList({"replaced-*.sqlite"}, QDir::Files);
        if (!done && !aside.isEmpty())
            QVERIFY2(done.error().detail.find(aside.front().toStdString()) != std::string::npos,
                     done.error().detail.c_str());
        QCOMPARE(attemptsIn(aside.isEmpty() ? file : folder.filePath(aside.front())), 1);
    }
}

void TestUpkeep::whatARestoreMovedAsideIsFound()
{
    QTemporaryDir folder;
    SchoolRig rig(false);
    rig.populate();
    const QString backup = backUp(rig.school().db, folder.filePath("backups"), rig.nowUtc).value();
    const QString file = folder.filePath("school.sqlite");
    QCOMPARE(newestReplaced(file, rig.nowUtc), QString());
    for (const char* name : {"replaced-2026-11-20-10.15.00-school.sqlite", "replaced-2026-11-20-10.15.01-school.sqlite",
                             "replaced-2026-11-20-10.15.03-other-school.sqlite"})
        QVERIFY(QFile::copy(backup, folder.filePath(name)));
    QFile noise(folder.filePath("replaced-2026-11-20-10.15.02-school.sqlite"));
    QVERIFY(noise.open(QIODevice::WriteOnly));
    QCOMPARE(newestReplaced(file, rig.nowUtc), folder.filePath("replaced-2026-11-20-10.15.01-school.sqlite"));
}

/// One that is whole, but cannot be brought to this program's schema.
void TestUpkeep::aBackupThatCannotBeUsedReplacesNothing()
{
    QTemporaryDir folder;
    SchoolRig rig(false);
    rig.populate();
    const QString backup = backUp(rig.school().db, folder.filePath("backups"), rig.nowUtc).value();
    const QString file = folder.filePath("school.sqlite");
    QVERIFY(QFile::copy(backup, file));
    QVERIFY(runOn(backup, "PRAGMA user_version = 1"));
    VERIFY_DONE(verifyBackup(backup));
    const QByteArray before = contentOf(file);
    const auto refused = restoreBackup(backup, file, rig.nowUtc);
    QVERIFY(!refused.has_value());
    const QString said = QString::fromStdString(refused.error().detail);
    QVERIFY2(said.contains(backup) && said.contains("nothing was replaced"), qPrintable(said));
    QCOMPARE(contentOf(file), before);
    const QStringList there = QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    QCOMPARE(there, QStringList({"backups", "school.sqlite"}));
}

/// Not even what SQLite shares beside the file finds room there.
void TestUpkeep::aFullDiskIsLookedAtAndBackedUp()
{
    QTemporaryDir elsewhere;
    SchoolRig rig(false);
    rig.populate();
    VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500), {}));
    rig.close();
    const Address address = Address::parse(rig.address()).value();
    Database::Options options;
    options.mayCreate = false;
    options.onlyLooks = true;
    core::Result<std::unique_ptr<Database>> looked = core::unexpected(ErrorCode::FileEmpty, "not tried");
    {
        const support::FullDisk full(10);
        VERIFY_REFUSED(Database::open(rig.address()), ErrorCode::FileUnwritable);
        looked = Database::open(address, options);
        VERIFY_DONE(looked);
        QVERIFY(!(*looked)->allowsOthers());
        const auto report = checkDatabase((*looked)->handle(), {});
        VERIFY_DONE(report);
        QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
        QCOMPARE(report->attempts, 1);
    }
    const auto backup = backUp((*looked)->handle(), elsewhere.path(), rig.nowUtc);
    VERIFY_DONE(backup);
    looked->reset();
    QCOMPARE(attemptsIn(*backup), 1);
    rig.reopen();
    QVERIFY(rig.isOpen());
}

void TestUpkeep::whatCannotBeWrittenIsLookedAtAndBackedUp()
{
    QTemporaryDir elsewhere;
    QTemporaryDir folder;
    SchoolRig rig(false);
    rig.populate();
    const QString file = folder.filePath("school.sqlite");
    QVERIFY(QFile::copy(backUp(rig.school().db, elsewhere.path(), rig.nowUtc).value(), file));
    QCOMPARE(chmod(qPrintable(file), 0444), 0);
    QCOMPARE(chmod(qPrintable(folder.path()), 0555), 0);
    QCOMPARE(chmod(qPrintable(elsewhere.path()), 0777), 0);
    Address address;
    address.file = file;
    Database::Options options;
    options.mayCreate = false;
    options.onlyLooks = true;
    core::Result<std::unique_ptr<Database>> looked = core::unexpected(ErrorCode::FileEmpty, "not tried");
    {
        // To root no folder is closed.
        constexpr uid_t kNobody = 65534;
        const uid_t me = geteuid();
        QCOMPARE(me == 0 ? seteuid(kNobody) : 0, 0);
        const auto back = qScopeGuard([me] { QCOMPARE(seteuid(me), 0); });
        const auto refused = Database::open(file);
        VERIFY_REFUSED(refused, ErrorCode::FileUnwritable);
        QVERIFY2(refused.error().detail.find("read-only") != std::string::npos, refused.error().detail.c_str());
        looked = Database::open(address, options);
        VERIFY_DONE(looked);
        QVERIFY(checkDatabase((*looked)->handle(), {})->findings.empty());
        VERIFY_DONE(backUp((*looked)->handle(), elsewhere.path(), rig.nowUtc.addDays(1)));
        const auto drill = restoreDrill((*looked)->handle());
        VERIFY_REFUSED(drill, ErrorCode::FileUnwritable);
        QVERIFY2(drill.error().detail.find(folder.path().toStdString() + ": no folder") != std::string::npos,
                 drill.error().detail.c_str());
        VERIFY_DONE((*looked)->stayedAsItWas());
    }
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"school.sqlite"});
    QCOMPARE(chmod(qPrintable(folder.path()), 0755), 0);
    QCOMPARE(chmod(qPrintable(file), 0644), 0);
    VERIFY_DONE((*looked)->stayedAsItWas());
    // What was read while its owner wrote is told of nobody.
    QVERIFY(runOn(file, "UPDATE people SET given_name = 'Eve'"));
    VERIFY_REFUSED((*looked)->stayedAsItWas(), ErrorCode::Busy);
}

/// What SQLite puts beside a file that may not be written may not be written either, and stays there.
void TestUpkeep::whatCouldNotBeWrittenOnceCanBeLater()
{
    QTemporaryDir folder;
    SchoolRig rig(false);
    rig.populate();
    const QString file = folder.filePath("school.sqlite");
    {
        QTemporaryDir elsewhere;
        QVERIFY(QFile::copy(backUp(rig.school().db, elsewhere.path(), rig.nowUtc).value(), file));
        QVERIFY(runOn(file, "PRAGMA journal_mode = WAL"));
    }
    // To root no file is closed.
    constexpr uid_t kNobody = 65534;
    const uid_t me = geteuid();
    QCOMPARE(chmod(qPrintable(folder.path()), 0777), 0);
    QCOMPARE(chmod(qPrintable(file), 0444), 0);
    QCOMPARE(me == 0 ? chown(qPrintable(file), kNobody, kNobody) : 0, 0);
    QCOMPARE(me == 0 ? seteuid(kNobody) : 0, 0);
    const auto back = qScopeGuard([me] { QCOMPARE(seteuid(me), 0); });
    QVERIFY(isReadOnly(file));
    const QString change = "UPDATE people SET given_name = 'Eve'";
    const auto closed = Database::open(file);
    QVERIFY(!closed || !execute((*closed)->handle(), change, "write"));
    QVERIFY(isReadOnly(file + "-shm"));

    QCOMPARE(chmod(qPrintable(file), 0644), 0);
    QVERIFY(!isReadOnly(file));
    const auto open = Database::open(file);
    VERIFY_DONE(open);
    VERIFY_DONE(execute((*open)->handle(), change, "write"));
}

/// A damaged file keeps its log beside it; one without its file is kept, too. Nothing of it, nor of what was shared
/// about it, is read into the restored one.
void TestUpkeep::aLogIsNeverThrownAway()
{
    QTemporaryDir folder;
    SchoolRig rig(false);
    rig.populate();
    const QString backup = backUp(rig.school().db, folder.path(), rig.nowUtc).value();
    const QString file = folder.filePath("school.sqlite");
    QVERIFY(QFile::copy(rig.address() + "-wal", file + "-wal"));
    const qint64 size = QFileInfo(file + "-wal").size();
    QVERIFY(size > 0);
    const auto putMemory = [&file] {
        QFile memory(file + "-shm");
        return memory.open(QIODevice::WriteOnly) && memory.write(QByteArray(32'768, 'm')) == 32'768;
    };
    QVERIFY(putMemory());
    QCOMPARE(restoreBackup(backup, file, rig.nowUtc).value(), QString());
    const QString lone = folder.filePath("replaced-2026-11-20-10.15.00-school.sqlite");
    QCOMPARE(QFileInfo(lone + "-wal").size(), size);
    QCOMPARE(QFileInfo(lone + "-shm").size(), qint64{32'768});
    QVERIFY(!QFile::exists(file + "-wal") && !QFile::exists(file + "-shm"));
    QFile noise(file);
    QVERIFY(noise.open(QIODevice::ReadWrite) && noise.seek(4096));
    noise.write(QByteArray(50'000, 'n'));
    noise.close();
    QFile log(file + "-wal");
    QVERIFY(log.open(QIODevice::WriteOnly));
    log.write("a log");
    log.close();
    QVERIFY(putMemory());
    const auto replaced = restoreBackup(backup, file, rig.nowUtc.addSecs(1));
    VERIFY_DONE(replaced);
    QVERIFY(!QFile::exists(file + "-wal") && !QFile::exists(file + "-shm"));
    QVERIFY(QFile::exists(*replaced) && QFileInfo(*replaced + "-wal").size() == 5);
    QVERIFY(Database::open(file).has_value());
}

/// Each waits for nobody, and takes nothing from another.
void TestUpkeep::backupsAndMigrationsAtOnceLeaveEachOtherAlone()
{
    const auto together = [](int count, const std::function<bool()>& work) {
        std::vector<pid_t> others;
        for (int k = 0; k < count; ++k) {
            const pid_t other = fork();
            if (other == 0)
                _exit(work() ? 0 : 1);
            others.push_back(other);
        }
        int done = 0;
        for (const pid_t other : others) {
            int status = -1;
            waitpid(other, &status, 0);
            done += status == 0 ? 1 : 0;
        }
        return done;
    };
    SchoolRig rig(false);
    rig.populate();
    const QDateTime now = rig.nowUtc;
    const QString file = rig.address();
    rig.close();
    QTemporaryDir folder;
    for (int round = 1; round <= 5; ++round) {
        QCOMPARE(together(4,
                          [&] {
                              const auto database = Database::open(file);
                              return database && backUp((*database)->handle(), folder.path(), now).has_value();
                          }),
                 4);
        QCOMPARE(backupsIn(folder.path()).size(), 4 * round);
    }
    QCOMPARE(QDir(folder.path()).entryList({"*.part*"}).size(), 0);
    const auto steps = shippedMigrations();
    VERIFY_DONE(steps);
    for (int round = 0; round < 5; ++round) {
        QTemporaryDir place;
        const QString older = place.filePath("school.sqlite");
        {
            QSqlDatabase db = QSqlDatabase::addDatabase("QSQLITE", "older");
            db.setDatabaseName(older);
            QVERIFY(db.open());
            VERIFY_DONE(execute(db, QStringLiteral("PRAGMA application_id = %1").arg(dialect::kApplicationId), "mark"));
            VERIFY_DONE(execute(db, "PRAGMA journal_mode = WAL", "keep a log"));
            VERIFY_DONE(migrate(db, std::span(*steps).first(steps->size() - 1)));
        }
        QSqlDatabase::removeDatabase("older");
        QCOMPARE(together(3, [&] { return Database::open(older).has_value(); }), 3);
    }
}

/// One that a program left when it was killed: all that tells whose it is stands in its log.
void TestUpkeep::aCrashedFileIsKnownByItsLog()
{
    QTemporaryDir folder;
    SchoolRig rig(false);
    VERIFY_DONE(execute(rig.school().db, "PRAGMA wal_autocheckpoint = 0", "keep the log"));
    rig.populate();
    const QString copy = folder.filePath("school.sqlite");
    for (const char* end : {"", "-wal"})
        QVERIFY(QFile::copy(rig.address() + end, copy + end));
    QCOMPARE(schoolOf(copy), *schoolOf(rig.school().db));
    QVERIFY(!schoolOf(copy).empty());
}

/// Names, marks and hashes of passwords.
void TestUpkeep::onlyTheOwnerReadsWhatIsKept()
{
    QTemporaryDir elsewhere;
    SchoolRig rig(false);
    rig.populate();
    const auto others = QFile::ReadGroup | QFile::ReadOther | QFile::WriteGroup | QFile::WriteOther;
    for (const char* end : {"", "-wal", "-shm"})
        QVERIFY2(!(QFile::permissions(rig.address() + end) & others), end);
    const auto backup = backUp(rig.school().db, elsewhere.path(), rig.nowUtc);
    VERIFY_DONE(backup);
    QVERIFY(!(QFile::permissions(*backup) & others));
    const QString restored = elsewhere.filePath("restored.sqlite");
    VERIFY_DONE(restoreBackup(*backup, restored, rig.nowUtc));
    QVERIFY(!(QFile::permissions(restored) & others));
    // Who wants that others of his group read it says so, and it stays so.
    QVERIFY(QFile::setPermissions(restored, QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup));
    VERIFY_DONE(restoreBackup(*backup, restored, rig.nowUtc));
    QVERIFY(QFile::permissions(restored) & QFile::ReadGroup);
    // Nobody has said so of noise.
    QFile noise(restored);
    QVERIFY(noise.open(QIODevice::WriteOnly | QIODevice::Truncate) && noise.write(QByteArray(5000, 'n')) == 5000);
    noise.close();
    QVERIFY(noise.setPermissions(QFile::permissions(restored) | others));
    VERIFY_DONE(restoreBackup(*backup, restored, rig.nowUtc));
    QVERIFY(!(QFile::permissions(restored) & others));
    // For root every folder can be written: that nothing is made beside it is seen all the same.
    QCOMPARE(QDir(elsewhere.path()).entryList({"backup-*"}, QDir::Files).size(), 1);
}

/// On a medium that cannot be written, or marked so.
void TestUpkeep::aBackupThatCannotBeWrittenIsRestored()
{
    QTemporaryDir medium;
    QTemporaryDir elsewhere;
    SchoolRig rig(false);
    rig.populate();
    const auto backup = backUp(rig.school().db, medium.path(), rig.nowUtc);
    VERIFY_DONE(backup);
    QVERIFY(QFile::setPermissions(*backup, QFile::ReadOwner));
    QVERIFY(QFile::setPermissions(medium.path(), QFile::ReadOwner | QFile::ExeOwner));
    const QString restored = elsewhere.filePath("restored.sqlite");
    const auto done = restoreBackup(*backup, restored, rig.nowUtc);
    QVERIFY(QFile::setPermissions(medium.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    VERIFY_DONE(done);
    const auto opened = Database::open(restored);
    VERIFY_DONE(opened);
    QSqlQuery write((*opened)->handle());
    QVERIFY(write.exec("UPDATE settings SET value = value"));
    // A database in use is no backup: what stands in its log would be lost.
    VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 900), {}));
    VERIFY_REFUSED(restoreBackup(rig.address(), elsewhere.filePath("other.sqlite"), rig.nowUtc), ErrorCode::WrongKind);
    VERIFY_REFUSED(restoreBackup(*backup, elsewhere.filePath("nowhere/x.sqlite"), rig.nowUtc), ErrorCode::FileMissing);
}

void TestUpkeep::longWorkIsStopped()
{
    SchoolRig rig(false);
    const auto admin =
        Logins::createFirstAdmin(rig.school(), {"admin", "", "", Role::Admin}, SchoolRig::kPassword, SchoolRig::kCheap);
    VERIFY_DONE(admin);
    VERIFY_DONE(makeSample(rig.school(), *admin, {40, 1200, 20, 7}, madeLessons({"class1-36"})));
    int told = 0;
    const auto report = checkDatabase(rig.school().db, {}, [&](const char*, std::int64_t) { return ++told > 1; });
    VERIFY_DONE(report);
    QVERIFY(report->isStopped);
    QCOMPARE(told, 1);
    QVERIFY(!restoreDrill(rig.school().db, [](int, int) { return false; }).has_value());
    QVERIFY(!checkDatabase(rig.school().db, {}, [](const char*, std::int64_t) { return true; })->isStopped);
}

/// Two schools that back up onto one drive, in the same second.
void TestUpkeep::eachSchoolThinsItsOwnBackups()
{
    SchoolRig first(false);
    SchoolRig second(false);
    first.populate();
    second.populate();
    QTemporaryDir drive;
    const auto one = backUp(first.school().db, drive.path(), first.nowUtc);
    const auto other = backUp(second.school().db, drive.path(), first.nowUtc);
    VERIFY_DONE(one);
    VERIFY_DONE(other);
    QVERIFY(*one != *other);
    QCOMPARE(backupsIn(drive.path()).size(), 2);
    QCOMPARE(backupsOf(first.school().db, drive.path()), QStringList{*one});
    QCOMPARE(backupsOf(second.school().db, drive.path()), QStringList{*other});
    QCOMPARE(schoolOf(*one), *schoolOf(first.school().db));
    QVERIFY(!schoolOf(*one).empty() && schoolOf(*one) != schoolOf(*other));
    // Nobody has been entered yet: it is not known whose it is, and nothing is anybody's to delete.
    SchoolRig empty(false);
    QVERIFY(backupsOf(empty.school().db, drive.path()).isEmpty());
}

/// Somebody tries something out in it, and has it backed up where the school's own backups lie.
void TestUpkeep::aCopyIsASchoolOfItsOwn()
{
    SchoolRig first(false);
    SchoolRig trial(false);
    SchoolRig again(false);
    first.populate();
    VERIFY_DONE(copySchool(first.school(), first.admin, trial.school()));
    const auto admin = [](const SchoolRig& rig) {
        return Logins::login(rig.school(), "admin", SchoolRig::kPassword).value();
    };
    VERIFY_DONE(copySchool(trial.school(), admin(trial), again.school()));
    QTemporaryDir drive;
    QStringList backups;
    for (const SchoolRig* rig : {&first, &trial, &again}) {
        backups += backUp(rig->school().db, drive.path(), first.nowUtc).value();
        QCOMPARE(backupsOf(rig->school().db, drive.path()), QStringList{backups.last()});
        QCOMPARE(schoolOf(backups.last()), *schoolOf(rig->school().db));
    }
    // Back to what it was before it moved, and never to what came of its copy.
    QCOMPARE(mayReplace(backups[0], again.address()).value(), true);
    QCOMPARE(mayReplace(backups[1], again.address()).value(), true);
    VERIFY_REFUSED(mayReplace(backups[2], trial.address()), ErrorCode::WrongKind);
    first.close();
    const QByteArray before = contentOf(first.address());
    for (const QString& other : {backups[1], backups[2]})
        VERIFY_REFUSED(restoreBackup(other, first.address(), first.nowUtc), ErrorCode::WrongKind);
    QCOMPARE(contentOf(first.address()), before);
    VERIFY_DONE(restoreBackup(backups[0], first.address(), first.nowUtc));
}

/// The backups beside it say what it was.
/// Also in the same minute; but not what another program is still making.
void TestUpkeep::whatAKilledBackupLeavesGoesWithTheNext()
{
    SchoolRig rig(false);
    rig.populate();
    const QString file = rig.address();
    rig.close();
    // So that it is copied in several steps.
    QVERIFY(runOn(file, "CREATE TABLE ballast (x); INSERT INTO ballast VALUES (zeroblob(20000000))"));
    QTemporaryDir folder;
    const auto parts = [&folder] { return QDir(folder.path()).entryList({"*.part-*"}, QDir::Files); };
    const auto backUpAnd = [&](const std::function<void()>& meanwhile) {
        const auto opened = Database::open(file);
        const auto made = backUp((*opened)->handle(), folder.path(), rig.nowUtc, [&meanwhile](int, int) {
            meanwhile();
            return true;
        });
        return made.has_value();
    };
    const auto inOther = [&](int signal) {
        const pid_t other = fork();
        if (other == 0) {
            bool isFirst = true;
            _exit(backUpAnd([&isFirst, signal] {
                if (std::exchange(isFirst, false))
                    raise(signal);
            })
                      ? 0
                      : 1);
        }
        return other;
    };
    int status = 0;
    const pid_t killed = inOther(SIGKILL);
    QCOMPARE(waitpid(killed, &status, 0), killed);
    QVERIFY(WIFSIGNALED(status) && !parts().isEmpty());
    QVERIFY(backupsIn(folder.path()).isEmpty());
    const pid_t slow = inOther(SIGSTOP);
    QCOMPARE(waitpid(slow, &status, WUNTRACED), slow);
    QVERIFY(WIFSTOPPED(status));
    const auto ended = qScopeGuard([slow] { kill(slow, SIGKILL); });
    // This one's goes, that one's stays.
    QVERIFY(backUpAnd([] {}));
    QCOMPARE(parts().filter(QRegularExpression("part-[0-9a-f]{32}$")).size(), 1);
    kill(slow, SIGCONT);
    QCOMPARE(waitpid(slow, &status, 0), slow);
    QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    QVERIFY2(parts().isEmpty(), qPrintable(parts().join(u' ')));
    QCOMPARE(backupsIn(folder.path()).size(), 2);
}

void TestUpkeep::aDamagedSchoolIsReplacedByItsOwnBackupOnly()
{
    SchoolRig first(false);
    SchoolRig second(false);
    first.populate();
    second.populate();
    QTemporaryDir drive;
    const QString own = backUp(first.school().db, drive.path(), first.nowUtc).value();
    const QString others = backUp(second.school().db, drive.path(), first.nowUtc).value();
    const QString beside = backUp(first.school().db, backupFolder(first.address()), first.nowUtc).value();
    first.close();
    const auto spoil = [&first] {
        QFile file(first.address());
        return file.open(QIODevice::WriteOnly) && file.write(QByteArray(50'000, 'n')) == 50'000;
    };
    QVERIFY(spoil());
    VERIFY_REFUSED(restoreBackup(others, first.address(), first.nowUtc), ErrorCode::WrongKind);
    QCOMPARE(mayReplace(own, first.address()).value(), true);
    VERIFY_DONE(restoreBackup(own, first.address(), first.nowUtc));
    // Two schools in the folder: either may be the one that the file was, and who looks by hand is told which.
    const QString stranger = backUp(second.school().db, backupFolder(first.address()), first.nowUtc.addDays(1)).value();
    QCOMPARE(mayReplace(beside, first.address()).value(), true);
    VERIFY_REFUSED(mayReplace(stranger, first.address()), ErrorCode::WrongKind);
    QCOMPARE(newestSound(first.address(), first.nowUtc.addDays(1)), beside);
    QVERIFY(spoil());
    QCOMPARE(newestSound(first.address(), first.nowUtc.addDays(1)), QString());
    for (const QString& either : {beside, stranger})
        QCOMPARE(mayReplace(either, first.address()).value(), false);
    QCOMPARE(newestOfEach(backupsIn(backupFolder(first.address()))), (QStringList{stranger, beside}));
    QVERIFY2(whoIsIn(stranger).contains("people: 6") && whoIsIn(stranger).contains("DEN101-A"),
             qPrintable(whoIsIn(stranger)));
    QVERIFY(QFile::remove(stranger) && QFile::remove(beside));
    QCOMPARE(mayReplace(others, first.address()).value(), false);
    // Where nothing lies there is nothing to compare with.
    QCOMPARE(mayReplace(others, drive.filePath("new.sqlite")).value(), true);
}

void TestUpkeep::whatALaterProgramWroteIsNotReplaced()
{
    QTemporaryDir folder;
    SchoolRig rig(false);
    rig.populate();
    const QString backup = backUp(rig.school().db, folder.filePath("backups"), rig.nowUtc).value();
    const QString file = folder.filePath("school.sqlite");
    QVERIFY(QFile::copy(backup, file) && runOn(file, "PRAGMA user_version = 99"));
    const QByteArray before = contentOf(file);
    const auto refused = restoreBackup(backup, file, rig.nowUtc);
    VERIFY_REFUSED(refused, ErrorCode::NewerVersion);
    QVERIFY2(refused.error().detail.find("later program (schema 99") != std::string::npos,
             refused.error().detail.c_str());
    QCOMPARE(contentOf(file), before);
}

void TestUpkeep::aClockThatWasWrongHidesNoBackup()
{
    SchoolRig rig(false);
    rig.populate();
    const QString folder = backupFolder(rig.address());
    const auto made = backUp(rig.school().db, folder, rig.nowUtc);
    VERIFY_DONE(made);
    const QString later = QDir(folder).filePath("backup-2046-01-01-00.00.00.sqlite");
    QVERIFY(QFile::copy(*made, later));
    QCOMPARE(newestSound(rig.address(), rig.nowUtc), *made);
    // It is there for who has nothing else.
    QVERIFY(QFile::remove(*made));
    QCOMPARE(newestSound(rig.address(), rig.nowUtc), later);
}

void TestUpkeep::anEmptyDatabaseIsNoBackup()
{
    QTemporaryDir folder;
    const QString file = folder.filePath("empty.sqlite");
    sqlite3* made = nullptr;
    QCOMPARE(sqlite3_open(file.toUtf8().constData(), &made), SQLITE_OK);
    const QByteArray mark = QStringLiteral("PRAGMA application_id = %1").arg(dialect::kApplicationId).toUtf8();
    QCOMPARE(sqlite3_exec(made, mark.constData(), nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(made);
    VERIFY_REFUSED(verifyBackup(file), ErrorCode::WrongKind);
}

void TestUpkeep::aSchoolWithoutPeopleIsNotOffered()
{
    SchoolRig rig(false);
    const QString folder = backupFolder(rig.address());
    const auto empty = backUp(rig.school().db, folder, rig.nowUtc);
    VERIFY_DONE(empty);
    QVERIFY(holdsNobody(*empty));
    QCOMPARE(newestSound(rig.address(), rig.nowUtc), QString());
    rig.populate();
    const auto full = backUp(rig.school().db, folder, rig.nowUtc.addSecs(-60));
    VERIFY_DONE(full);
    QVERIFY(!holdsNobody(*full));
    QCOMPARE(newestSound(rig.address(), rig.nowUtc), *full);
}

void TestUpkeep::whatAMigrationLeftAsItWasIsNotCopied()
{
    SchoolRig rig(false);
    rig.populate();
    // Says that it is older than it is: the tables of the next step are there already.
    VERIFY_DONE(execute(rig.school().db, "PRAGMA user_version = 2", "age it"));
    rig.close();
    for (int again = 0; again < 3; ++again)
        QVERIFY(!Database::open(rig.address()).has_value());
    QVERIFY(QDir(backupFolder(rig.address())).entryList({"before-schema-*"}).isEmpty());
}

/// Who has it open would go on writing into the file that was moved away.
void TestUpkeep::nothingIsRestoredUnderAnotherProgram()
{
    SchoolRig rig(false);
    rig.populate();
    const auto backup = backUp(rig.school().db, backupFolder(rig.address()), rig.nowUtc);
    QVERIFY(backup);
    QCOMPARE(newestSound(rig.address(), QDateTime::currentDateTimeUtc()), *backup);
    rig.close();
    int ready[2];
    int done[2];
    QVERIFY(pipe(ready) == 0 && pipe(done) == 0);
    const pid_t other = fork();
    if (other == 0) {
        char byte = 'x';
        sqlite3* db = nullptr;
        if (sqlite3_open(rig.address().toUtf8().constData(), &db) == SQLITE_OK &&
            sqlite3_exec(db, "SELECT count(*) FROM people", nullptr, nullptr, nullptr) == SQLITE_OK &&
            write(ready[1], &byte, 1) == 1 && read(done[0], &byte, 1) == 1)
            sqlite3_close(db);
        _exit(0);
    }
    char byte = 'x';
    QCOMPARE(read(ready[0], &byte, 1), 1);
    VERIFY_REFUSED(restoreBackup(*backup, rig.address(), rig.nowUtc), ErrorCode::Busy);
    QCOMPARE(write(done[1], &byte, 1), 1);
    QCOMPARE(waitpid(other, nullptr, 0), other);
    QVERIFY(restoreBackup(*backup, rig.address(), rig.nowUtc).has_value());
    rig.reopen();
    QVERIFY(rig.isOpen());
}

void TestUpkeep::aDamagedFileReplacesNoBackup()
{
    QTemporaryDir folder;
    const QString file = folder.filePath("noise.sqlite");
    QFile noise(file);
    QVERIFY(noise.open(QIODevice::WriteOnly));
    noise.write(QByteArray(8192, 'n'));
    noise.close();
    QVERIFY(!verifyBackup(file).has_value());
    const QString target = folder.filePath("school.sqlite");
    {
        SchoolRig rig(false);
        rig.populate();
        QVERIFY(QFile::copy(rig.address(), target));
    }
    QVERIFY(!restoreBackup(file, target, QDateTime::currentDateTimeUtc()).has_value());
    QVERIFY(QFile::exists(target));
    QVERIFY(!Database::open(file).has_value());
}

void TestUpkeep::aDamagedDatabaseIsNotBackedUp()
{
    SchoolRig rig(false);
    rig.populate();
    const QString folder = backupFolder(rig.address());
    const auto good = backUp(rig.school().db, folder, rig.nowUtc);
    VERIFY_DONE(good);
    const QByteArray before = contentOf(*good);
    rig.close();
    QVERIFY(spoil(rig.address(), "people"));
    {
        const RawFile damaged(rig.address());
        const auto refused = backUp(damaged.handle(), folder, rig.nowUtc.addDays(1));
        VERIFY_REFUSED(refused, ErrorCode::BadStructure);
        QVERIFY2(refused.error().detail.find("damaged") != std::string::npos, refused.error().detail.c_str());
    }
    // Not even a part of a copy is there, and the older one is as it was.
    QCOMPARE(QDir(folder).entryList(QDir::Files), QStringList{QFileInfo(*good).fileName()});
    QCOMPARE(contentOf(*good), before);
    VERIFY_DONE(verifyBackup(*good));
}

void TestUpkeep::whatIsNotWholeIsNoBackup_data()
{
    using Harm = std::function<bool(const QString&)>;
    QTest::addColumn<Harm>("harm");
    QTest::addColumn<ErrorCode>("code");
    const auto row = [](const char* name, ErrorCode code, const Harm& harm) { QTest::newRow(name) << harm << code; };
    const auto sql = [](const char* words) { return [words](const QString& file) { return runOn(file, words); }; };
    row("a key that leads nowhere", ErrorCode::BadStructure,
        sql("PRAGMA foreign_keys = OFF; INSERT INTO enrolments VALUES (99, 99)"));
    row("cut off", ErrorCode::BadStructure,
        [](const QString& file) { return QFile::resize(file, QFileInfo(file).size() / 2); });
    row("noise in a table", ErrorCode::BadStructure, [](const QString& file) { return spoil(file, "audit"); });
    row("of another program", ErrorCode::WrongKind, sql("PRAGMA application_id = 7"));
    row("of no program", ErrorCode::WrongKind, sql("PRAGMA application_id = 0"));
    row("of a later program", ErrorCode::NewerVersion, sql("PRAGMA user_version = 99"));
}

/// Nor is it restored.
void TestUpkeep::whatIsNotWholeIsNoBackup()
{
    QFETCH(std::function<bool(const QString&)>, harm);
    QFETCH(ErrorCode, code);
    QTemporaryDir folder;
    SchoolRig rig(false);
    rig.populate();
    const auto backup = backUp(rig.school().db, folder.path(), rig.nowUtc);
    VERIFY_DONE(backup);
    VERIFY_DONE(verifyBackup(*backup));
    QVERIFY(harm(*backup));
    VERIFY_REFUSED(verifyBackup(*backup), code);
    rig.close();
    const QByteArray before = contentOf(rig.address());
    QVERIFY(!restoreBackup(*backup, rig.address(), rig.nowUtc).has_value());
    QCOMPARE(contentOf(rig.address()), before);
}

/// It is made all the same: it is all there is of the days since.
void TestUpkeep::aBackupOfAChangedAuditPushesNoGoodOneOut()
{
    QTemporaryDir folder;
    SchoolRig rig(false);
    rig.populate();
    const QSqlDatabase db = rig.school().db;
    const auto backUpAt = [&](int day, int hour) {
        return backUp(db, folder.path(), QDateTime(rig.nowUtc.date().addDays(day), QTime(hour, 0), Qt::UTC)).value();
    };
    const QString good = backUpAt(-5, 9);
    backUpAt(-5, 18);
    QVERIFY(holdsItsAudit(good).value());
    QVERIFY(!holdsItsAudit(good, [](int, int) { return false; }).has_value());
    for (const char* deed : {"DROP TRIGGER audit_no_update", "UPDATE audit SET detail = 'x' WHERE seq = 5"})
        VERIFY_DONE(execute(db, deed, "change it"));
    const QString changed = backUpAt(-4, 9);
    QVERIFY(!holdsItsAudit(changed).value());
    for (const int day : {-4, -3, -2})
        backUpAt(day, 18);
    const QStringList files = backupsIn(folder.path());
    QCOMPARE(files.size(), 6);
    QCOMPARE(toThin(files, rig.nowUtc, true), (QStringList{changed, good}));
    QCOMPARE(toThin(files, rig.nowUtc, false), QStringList{changed});
}

/// What the copy before it is found to be when it is checked holds a migration up, too.
void TestUpkeep::withoutASoundCopyNothingIsMigrated()
{
    const auto steps = shippedMigrations();
    VERIFY_DONE(steps);
    QTemporaryDir folder;
    const QString file = folder.filePath("school.sqlite");
    const int version = static_cast<int>(steps->size()) - 1;
    {
        const RawFile old(file);
        VERIFY_DONE(
            execute(old.handle(), QStringLiteral("PRAGMA application_id = %1").arg(dialect::kApplicationId), "mark"));
        VERIFY_DONE(migrate(old.handle(), std::span(*steps).first(steps->size() - 1)));
        VERIFY_DONE(execute(old.handle(), "INSERT INTO enrolments VALUES (99, 99)", "break a key"));
    }
    VERIFY_REFUSED(Database::open(file), ErrorCode::BadStructure);
    QCOMPARE(RawFile(file).first("PRAGMA user_version").toInt(), version);
    QVERIFY(QDir(backupFolder(file)).entryList(QDir::Files).isEmpty());
    QVERIFY(runOn(file, "DELETE FROM enrolments"));
    VERIFY_DONE(Database::open(file));
    QCOMPARE(QDir(backupFolder(file)).entryList({"before-schema-*"}, QDir::Files).size(), 1);
}

void TestUpkeep::backupsAreThinnedOut()
{
    QStringList files{"somebody-elses.sqlite", "before-schema-3-2026-01-01-00.00.00.sqlite"};
    QDateTime when(QDate(2026, 11, 20), QTime(18, 0), Qt::UTC);
    for (int day = 0; day < 400; ++day)
        for (const int hour : {9, 18})
            files += "backup-" +
                     QDateTime(when.date().addDays(-day), QTime(hour, 0), Qt::UTC).toString("yyyy-MM-dd-HH.mm.ss") +
                     ".sqlite";
    // A clock that was wrong for a day.
    files += "backup-2036-01-01-10.00.00.sqlite";
    const QStringList gone = tooMany(files, when);
    QStringList kept;
    for (const QString& file : std::as_const(files))
        if (!gone.contains(file))
            kept += file;
    QVERIFY(kept.contains("somebody-elses.sqlite"));
    QVERIFY(kept.contains("before-schema-3-2026-01-01-00.00.00.sqlite"));
    QVERIFY(kept.removeOne("backup-2036-01-01-10.00.00.sqlite"));
    // The last of each of twelve days.
    for (int day = 0; day < 12; ++day)
        QVERIFY(kept.contains("backup-" + when.addDays(-day).toString("yyyy-MM-dd-HH.mm.ss") + ".sqlite"));
    // A copy from before an accident outlives those that are made after it.
    QVERIFY(kept.contains("backup-2026-11-20-09.00.00.sqlite"));
    QVERIFY(kept.contains("backup-2026-11-19-09.00.00.sqlite"));
    QVERIFY(!kept.contains("backup-2026-11-18-09.00.00.sqlite"));
    // Twelve days lie in two or three of ten weeks, and those in three or four of nine months.
    QVERIFY2(kept.size() - 4 >= 12 + 7 + 5 && kept.size() - 4 <= 12 + 9 + 8, qPrintable(kept.join('\n')));
    QVERIFY(kept.contains("backup-2026-03-31-18.00.00.sqlite"));
    QVERIFY(!kept.contains("backup-2026-02-28-18.00.00.sqlite"));
    QVERIFY(tooMany(kept, when).isEmpty());
}

/// With what was in it.
void TestUpkeep::everyOlderSchemaIsBroughtToTheNewest()
{
    QFETCH(bool, onServer);
    if (onServer && !support::sharedServer().fault().isEmpty())
        QSKIP(qPrintable(support::sharedServer().fault()));
    const auto steps = shippedMigrations();
    VERIFY_DONE(steps);
    for (std::size_t version = 1; version < steps->size(); ++version) {
        QTemporaryDir folder;
        const QString where = onServer ? support::sharedServer().newDatabase() : folder.filePath("old.sqlite");
        const Address address = Address::parse(where).value();
        const QString name = QStringLiteral("old-%1").arg(version);
        {
            QSqlDatabase db = QSqlDatabase::addDatabase(onServer ? "QPSQL" : "QSQLITE", name);
            db.setDatabaseName(onServer ? address.name : address.file);
            db.setHostName(address.host);
            db.setUserName(address.user);
            if (address.port > 0)
                db.setPort(address.port);
            QVERIFY2(db.open(), qPrintable(db.lastError().text()));
            QSqlQuery query(db);
            if (!onServer)
                QVERIFY(query.exec(QStringLiteral("PRAGMA application_id = %1").arg(dialect::kApplicationId)));
            VERIFY_DONE(migrate(db, std::span(*steps).first(version)));
            const QString columns = version == 1  ? QStringLiteral("score_points, score_sheet_json, recording_file")
                                    : version < 4 ? QStringLiteral("score_tenths, score_sheet_json, recording_file")
                                                  : QStringLiteral("score_tenths, uid");
            const QString values = version == 1  ? QStringLiteral("82, '{\"old\":1}', 'x.cusprec'")
                                   : version < 4 ? QStringLiteral("820, '{\"old\":1}', 'x.cusprec'")
                                                 : QStringLiteral("820, 'legacy-1'");
            QVERIFY2(
                query.exec(QStringLiteral("INSERT INTO attempts (finished_utc, tooth, duration_ms, state_hash, %1) "
                                          "VALUES ('2026-03-01T10:00:00Z', '36', 1000, '0123456789abcdef', %2)")
                               .arg(columns, values)),
                qPrintable(query.lastError().text()));
            if (version >= 4)
                QVERIFY(query.exec("INSERT INTO score_sheets SELECT id, '{\"old\":1}' FROM attempts"));
        }
        QSqlDatabase::removeDatabase(name);
        Database::Options careful;
        careful.mayMigrate = false;
        VERIFY_REFUSED(Database::open(address, careful), ErrorCode::OlderVersion);
        const auto database = Database::open(address);
        VERIFY_DONE(database);
        const QSqlDatabase db = (*database)->handle();
        QCOMPARE(dialect::schemaVersion(db).value(), static_cast<int>(steps->size()));
        QCOMPARE(ask(db, "SELECT score_tenths FROM attempts", "read")->toInt(), 820);
        QCOMPARE(ask(db, "SELECT json FROM score_sheets", "read")->toString(), QString("{\"old\":1}"));
        QVERIFY(!ask(db, "SELECT uid FROM attempts", "read")->toString().isEmpty());
        const auto report = checkDatabase(db, {});
        VERIFY_DONE(report);
        QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
        if (onServer)
            continue;
        // The copy from before is whole, and holds what was there as it was.
        const QDir backups(backupFolder(where));
        const QStringList copies = backups.entryList({QStringLiteral("before-schema-%1-*").arg(version + 1)});
        QCOMPARE(copies.size(), 1);
        const QString copy = backups.filePath(copies.first());
        VERIFY_DONE(verifyBackup(copy));
        const RawFile before(copy);
        QCOMPARE(before.first("PRAGMA user_version").toInt(), static_cast<int>(version));
        QCOMPARE(before.first("SELECT count(*) FROM attempts").toInt(), 1);
        QCOMPARE(
            before.first(version == 1 ? "SELECT score_points * 10 FROM attempts" : "SELECT score_tenths FROM attempts")
                .toInt(),
            820);
        QCOMPARE(before.first(version < 4 ? "SELECT score_sheet_json FROM attempts" : "SELECT json FROM score_sheets")
                     .toString(),
                 QString("{\"old\":1}"));
    }
}

void TestUpkeep::whatASpreadsheetWouldRunIsQuoted()
{
    for (const char* sign : {"=", "+", "-", "@", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"})
        QCOMPARE(csvField(std::string(sign) + "1+1"), "'" + std::string(sign) + "1+1");
    for (const char* harmless : {"", "Ada", "1-1", "\uFF21da"})
        QCOMPARE(csvField(harmless), std::string(harmless));
}

/// Beyond the first plane of Unicode a letter takes two of QString's places.
void TestUpkeep::lettersAreCountedAndNotTheirHalves()
{
    SchoolRig rig(false);
    rig.populate();
    const auto of = [](int count) { return QString::fromUtf8("𠮷").repeated(count).toStdString(); };
    VERIFY_DONE(addClass(rig.school(), rig.admin, of(100)));
    VERIFY_REFUSED(addClass(rig.school(), rig.admin, of(101)), ErrorCode::OutOfRange);
    VERIFY_DONE(checkPersonName(of(200)));
    VERIFY_REFUSED(checkPersonName(of(201)), ErrorCode::OutOfRange);
}

/// Whatever he keeps for himself.
void TestUpkeep::nobodySetsForHimselfWhatTheSchoolSets()
{
    SCHOOL_RIG(rig);
    rig.populate();
    VERIFY_DONE(changeSetting(rig.school(), rig.admin, "idle.minutes", "12"));
    VERIFY_DONE(changeOwnSetting(rig.school(), rig.student, "idle.minutes", "600"));
    VERIFY_DONE(changeOwnSetting(rig.school(), rig.student, "language", "de"));
    const auto settings = readSettings(rig.school(), rig.student);
    VERIFY_DONE(settings);
    QCOMPARE(settings->at("idle.minutes"), std::string("12"));
    QCOMPARE(settings->at("language"), std::string("de"));
    const std::string most(16'000, 'x');
    VERIFY_DONE(changeOwnSetting(rig.school(), rig.student, "language", most));
    VERIFY_REFUSED(changeOwnSetting(rig.school(), rig.student, "language", most + 'x'), ErrorCode::OutOfRange);
    VERIFY_REFUSED(changeSetting(rig.school(), rig.admin, "idle.minutes", most + 'x'), ErrorCode::OutOfRange);
}

/// Or with one of five digits, which nothing is noted and no backup is named by.
void TestUpkeep::aClockWithoutAYearIsSaidToBeWrong()
{
    SCHOOL_RIG(rig);
    rig.populate();
    QTemporaryDir folder;
    const QDateTime right = rig.nowUtc;
    for (const int year : {-75, 10'002}) {
        rig.nowUtc.setDate(QDate(year, 1, 1));
        const auto refused = addClass(rig.school(), rig.admin, "new");
        VERIFY_REFUSED(refused, ErrorCode::OutOfRange);
        QVERIFY2(refused.error().detail.find("clock is wrong") != std::string::npos, refused.error().detail.c_str());
        if (!onServer)
            VERIFY_REFUSED(backUp(rig.school().db, folder.path(), rig.nowUtc), ErrorCode::OutOfRange);
    }
    QVERIFY(QDir(folder.path()).isEmpty());
    rig.nowUtc = right;
    VERIFY_DONE(addClass(rig.school(), rig.admin, "new"));
}

/// The other is told why, whichever moment it comes in.
void TestUpkeep::ofTwoCopiesAtOnceOneArrives()
{
    SCHOOL_RIG(target);
    SchoolRig from(false);
    from.populate();
    for (int k = 0; k < 30; ++k)
        VERIFY_DONE(addAttempt(from.school(), from.student, SchoolRig::attempt("class1-36", k), {}));
    from.close();
    const QString where = target.address();
    target.close();
    constexpr int kTooLate = 1;
    std::array<pid_t, 3> others{};
    for (pid_t& other : others) {
        other = fork();
        if (other != 0)
            continue;
        const StationKey key = StationKey::make();
        const auto source = Database::open(from.address());
        const auto there = Database::open(where, std::chrono::seconds(20));
        if (!source || !there)
            _exit(2);
        const School to{(*there)->handle(), key, [] { return QDateTime::currentDateTimeUtc(); }};
        const School school{(*source)->handle(), key, [] { return QDateTime::currentDateTimeUtc(); }};
        const auto copied = copySchool(school, from.admin, to);
        if (!copied && copied.error().detail.find("a school already") == std::string::npos)
            qWarning("%s", copied.error().detail.c_str());
        _exit(copied ? 0
              : copied.error().code == ErrorCode::OutOfRange &&
                      copied.error().detail.find("a school already") != std::string::npos
                  ? kTooLate
                  : 2);
    }
    int arrived = 0;
    for (const pid_t other : others) {
        int status = 0;
        QCOMPARE(waitpid(other, &status, 0), other);
        QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) <= kTooLate);
        arrived += WEXITSTATUS(status) == 0 ? 1 : 0;
    }
    QCOMPARE(arrived, 1);
    QCOMPARE(attemptsIn(where), 30);
}

void TestUpkeep::commentsFromBeforeTheyCouldBeTakenBackStand()
{
    SCHOOL_RIG(rig);
    rig.populate();
    const School& school = rig.school();
    const AttemptId id = addAttempt(school, rig.student, SchoolRig::attempt("class1-36", 700), {}).value();
    const std::int64_t comment = addComment(school, rig.instructor, id, {"too deep", {{1.0, 2.0, -0.5}}, 4200}).value();
    const auto talk = readTalk(school, rig.instructor, id);
    constexpr std::size_t kStep = 7;
    for (const char* aged : {"ALTER TABLE comments DROP COLUMN withdrawn_utc",
                             onServer ? "DELETE FROM cusp_schema WHERE version > 6" : "PRAGMA user_version = 6"})
        VERIFY_DONE(execute(school.db, aged, "age it"));
    VERIFY_REFUSED(readTalk(school, rig.instructor, id), onServer ? ErrorCode::ServerRefuses : ErrorCode::BadStructure);
    const auto steps = shippedMigrations();
    VERIFY_DONE(steps);
    VERIFY_DONE(migrate(school.db, std::span(*steps).first(kStep)));
    QVERIFY(*readTalk(school, rig.instructor, id) == *talk);
    VERIFY_DONE(withdrawComment(school, rig.instructor, comment));
    const auto report = checkDatabase(school.db, {});
    VERIFY_DONE(report);
    QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
}

void TestUpkeep::aSchoolMovesBetweenEnginesAndBack()
{
    if (!support::sharedServer().fault().isEmpty())
        QSKIP(qPrintable(support::sharedServer().fault()));
    SchoolRig first(false);
    first.populate();
    AttemptRecord attempt = SchoolRig::attempt("class1-36", 823);
    attempt.device = "Gerät 歯 \\ ' \"";
    const QByteArray recording("recording\0with a zero", 21);
    const AttemptId id = addAttempt(first.school(), first.student, attempt, recording).value();
    VERIFY_DONE(addComment(first.school(), first.instructor, id, {"Well done.", {{1.0, 2.0, -0.5}}, 90'000}));
    const auto wrong = addComment(first.school(), first.instructor, id, {"Of another.", {}, {}});
    VERIFY_DONE(wrong);
    VERIFY_DONE(withdrawComment(first.school(), first.instructor, *wrong));
    VERIFY_DONE(overrideScore(first.school(), first.instructor, id, 900, "It is better than that."));
    SchoolRig server(true);
    QVERIFY(server.isOpen());
    const auto there = copySchool(first.school(), first.admin, server.school());
    VERIFY_DONE(there);
    QCOMPARE(there->recordings, 1);
    VERIFY_REFUSED(copySchool(first.school(), first.admin, server.school()), ErrorCode::OutOfRange);
    SchoolRig back(false);
    VERIFY_DONE(copySchool(server.school(), Logins::login(server.school(), "admin", SchoolRig::kPassword).value(),
                           back.school()));
    for (SchoolRig* rig : {&server, &back}) {
        const auto report = checkDatabase(rig->school().db, {auditHead(first.school())->code()});
        VERIFY_DONE(report);
        QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
        const auto session = Logins::login(rig->school(), "s1001", SchoolRig::kPassword);
        VERIFY_DONE(session);
        QVERIFY(*openAttempt(rig->school(), *session, id) == *openAttempt(first.school(), first.student, id));
        QCOMPARE(openRecording(rig->school(), *session, id).value(), recording);
        QVERIFY(*readTalk(rig->school(), *session, id) == *readTalk(first.school(), first.student, id));
        // Numbers go on behind those that came along.
        const auto next = addAttempt(rig->school(), *session, SchoolRig::attempt("class1-36", 1), {});
        VERIFY_DONE(next);
        QVERIFY(next->value > id.value);
    }
}

/// And nothing that was there before.
void TestUpkeep::aCopyThatFailsTakesAwayWhatItBrought()
{
    SchoolRig first(false);
    first.populate();
    const QByteArray recordings[]{QByteArray(5000, 'r'), QByteArray(5000, 's')};
    for (const QByteArray& recording : recordings)
        VERIFY_DONE(addAttempt(first.school(), first.student, SchoolRig::attempt("class1-36", 500), recording));
    for (const bool hasOne : {false, true}) {
        SchoolRig target(false);
        QVERIFY(target.isOpen());
        if (hasOne)
            VERIFY_DONE(putRecording(target.school(), recordings[0]));
        const auto names = [folder = QFileInfo(target.address()).absolutePath() + "/recordings"] {
            QStringList found;
            QDirIterator all(folder, QDir::AllEntries | QDir::NoDotAndDotDot, QDirIterator::Subdirectories);
            while (all.hasNext())
                found += all.next();
            return QFileInfo::exists(folder) ? found : QStringList{"no folder"};
        };
        const QStringList before = names();
        // It comes last.
        VERIFY_DONE(execute(target.school().db,
                            "CREATE TRIGGER stop BEFORE UPDATE ON audit_seal BEGIN SELECT RAISE(ABORT, 'stop'); END",
                            "stop it"));
        QVERIFY(!copySchool(first.school(), first.admin, target.school()).has_value());
        QCOMPARE(names(), before);
        VERIFY_DONE(execute(target.school().db, "DROP TRIGGER stop", "let it go on"));
        const auto copied = copySchool(first.school(), first.admin, target.school());
        VERIFY_DONE(copied);
        QCOMPARE(copied->recordings, 2);
    }
}

/// Nor is there half of one, or an empty one, that somebody might take for it.
void TestUpkeep::aCopyThatIsKilledIsNoSchool()
{
    QFETCH(bool, onServer);
    if (onServer && !support::sharedServer().fault().isEmpty())
        QSKIP(qPrintable(support::sharedServer().fault()));
    SchoolRig first(false);
    first.populate();
    VERIFY_DONE(addAttempt(first.school(), first.student, SchoolRig::attempt("class1-36", 500), "a recording"));
    const QString from = first.address();
    first.close();
    QTemporaryDir folder;
    const Address where =
        Address::parse(onServer ? support::sharedServer().newDatabase() : folder.filePath("copy.sqlite")).value();
    Database::Options options;
    options.isToBeFilled = true;
    const auto copy = [&](const CopyProgress& progress) {
        const StationKey key = StationKey::make();
        const auto source = Database::open(from);
        const auto there = Database::open(where, options);
        return source && there &&
               copySchool({(*source)->handle(), key}, first.admin, {(*there)->handle(), key}, progress);
    };
    const pid_t other = fork();
    if (other == 0) {
        static_cast<void>(copy([](const QString& what, std::int64_t) {
            if (what == u"recordings")  // they come last
                _exit(0);
            return true;
        }));
        _exit(1);
    }
    int status = 0;
    QCOMPARE(waitpid(other, &status, 0), other);
    QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    Database::Options asItIs;
    asItIs.mayCreate = false;
    const auto empty = Database::open(where, asItIs);
    VERIFY_REFUSED(empty, ErrorCode::BadStructure);
    QVERIFY2(empty.error().detail.find("there is no school in it") != std::string::npos, empty.error().detail.c_str());
    QVERIFY(onServer || liesEmpty(where.file));
    QVERIFY(copy({}));
    VERIFY_DONE(Database::open(where, asItIs));
}

void TestUpkeep::aCheckNamesTheAttemptThatWasChanged()
{
    SCHOOL_RIG(rig);
    rig.populate();
    std::vector<AttemptRecord> attempts;
    for (int k = 0; k < 5; ++k) {
        attempts.push_back(SchoolRig::attempt("class1-36", 500 + k));
        VERIFY_DONE(addAttempt(rig.school(), rig.student, attempts.back(), {}));
    }
    QVERIFY(checkDatabase(rig.school().db, {})->findings.empty());
    QSqlQuery query(rig.school().db);
    const auto sql = [&](const char* words, const AttemptRecord& attempt) {
        return query.exec(QString::fromLatin1(words).arg(QString::fromStdString(attempt.uid)));
    };
    QVERIFY(sql("UPDATE attempts SET score_tenths = 999 WHERE uid = '%1'", attempts[1]));
    QVERIFY(sql("DELETE FROM score_sheets WHERE attempt_id = (SELECT id FROM attempts WHERE uid = '%1')", attempts[2]));
    QVERIFY(sql("DELETE FROM attempts WHERE uid = '%1'", attempts[2]));
    const auto report = checkDatabase(rig.school().db, {});
    VERIFY_DONE(report);
    const QString all = support::wordsOf(report->findings);
    QVERIFY2(all.contains(QString::fromStdString(attempts[1].uid) + " (2026-11-20T10:15:00Z, class1-36) was changed"),
             qPrintable(all));
    QVERIFY2(all.contains(QString::fromStdString(attempts[2].uid) + " was removed"), qPrintable(all));
    QVERIFY2(all.contains("do not add up"), qPrintable(all));
    QCOMPARE(report->findings.size(), std::size_t{3});
}

/// What they write between two looks is none of the check's.
void TestUpkeep::itIsCheckedWhileOthersWrite()
{
    SCHOOL_RIG(rig);
    const auto admin =
        Logins::createFirstAdmin(rig.school(), {"admin", "", "", Role::Admin}, SchoolRig::kPassword, SchoolRig::kCheap);
    VERIFY_DONE(admin);
    VERIFY_DONE(makeSample(rig.school(), *admin, {40, 1200, 20, 7}, madeLessons({"class1-36"})));
    const auto elsewhere = Database::open(rig.address());
    VERIFY_DONE(elsewhere);
    School other = rig.school();
    other.db = (*elsewhere)->handle();
    int written = 0;
    const auto report = checkDatabase(rig.school().db, {}, [&](const char*, std::int64_t) {
        const std::string name = "late" + std::to_string(++written);
        return addPerson(other, *admin, {name, "", "", Role::Student}).has_value();
    });
    VERIFY_DONE(report);
    QVERIFY(written > 1 && !report->isStopped);
    QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
}

/// As after a dump that was put back without its sequences; or somebody has set them to their end.
void TestUpkeep::newRowsAreNumberedAgain()
{
    SCHOOL_RIG(rig);
    rig.populate();
    const QSqlDatabase db = rig.school().db;
    const QStringList deeds =
        onServer ? QStringList{"SELECT setval(pg_get_serial_sequence('people', 'id'), 1)",
                               "SELECT setval(pg_get_serial_sequence('people', 'id'), 9223372036854775807)",
                               "ALTER TABLE people ALTER COLUMN id SET INCREMENT BY -1",
                               "ALTER TABLE people ALTER COLUMN id SET MAXVALUE 63 RESTART WITH 63; SELECT nextval("
                               "pg_get_serial_sequence('people', 'id'))"}
                 : QStringList{"UPDATE sqlite_sequence SET seq = 9223372036854775807 WHERE name = 'people'"};
    for (const QString& deed : deeds) {
        QSqlQuery query(db);
        QVERIFY2(query.exec(deed), qPrintable(query.lastError().text()));
        query.finish();
        QVERIFY(!addPerson(rig.school(), rig.admin, {"new", "", "", Role::Student}).has_value());
        const auto report = checkDatabase(db, {});
        VERIFY_DONE(report);
        QCOMPARE(report->findings.size(), std::size_t{1});
        const QString said = support::wordsOf(report->findings);
        QVERIFY2(said.startsWith("new rows of the table people are not numbered"), qPrintable(said));
        VERIFY_DONE(dialect::repairIds(db));
        QVERIFY(checkDatabase(db, {})->findings.empty());
    }
    if (onServer) {
        // One is left, and then none.
        VERIFY_DONE(execute(db, "ALTER TABLE people ALTER COLUMN id SET INCREMENT BY 5000000000000000000", "spoil it"));
        QCOMPARE(checkDatabase(db, {})->findings.size(), std::size_t{1});
        VERIFY_DONE(dialect::repairIds(db));
        QVERIFY(checkDatabase(db, {})->findings.empty());
    }
    VERIFY_DONE(addPerson(rig.school(), rig.admin, {"new", "", "", Role::Student}));
    // Behind the last number there is comes none.
    VERIFY_DONE(execute(db, "UPDATE people SET id = 9223372036854775807 WHERE username = 'new'", "spoil it"));
    if (onServer)
        VERIFY_DONE(execute(db, "SELECT setval(pg_get_serial_sequence('people', 'id'), 1)", "spoil it"));
    const auto repaired = dialect::repairIds(db);
    VERIFY_REFUSED(repaired, ErrorCode::OutOfRange);
    QVERIFY2(repaired.error().detail.find("table people") != std::string::npos, repaired.error().detail.c_str());
}

/// Whose numbers cannot be seen can be used up, for all that is known.
void TestUpkeep::numbersThatCannotBeSeenAreToldOf()
{
    if (!support::sharedServer().fault().isEmpty())
        QSKIP(qPrintable(support::sharedServer().fault()));
    SchoolRig rig(true);
    rig.populate();
    const QSqlDatabase db = rig.school().db;
    QVERIFY(dialect::repairIds(db).value());
    const QString role = "looks_" + QString::fromStdString(newUid());
    for (const char* sql : {"CREATE ROLE %1", "GRANT SELECT, INSERT, UPDATE ON ALL TABLES IN SCHEMA public TO %1",
                            "GRANT USAGE ON ALL SEQUENCES IN SCHEMA public TO %1", "SET ROLE %1"})
        VERIFY_DONE(execute(db, QString::fromLatin1(sql).arg(role), "be another"));
    const auto repaired = dialect::repairIds(db);
    VERIFY_DONE(execute(db, "RESET ROLE", "be oneself"));
    VERIFY_DONE(execute(db, "DROP OWNED BY " + role + "; DROP ROLE " + role, "tidy up"));
    VERIFY_DONE(repaired);
    QVERIFY(!*repaired);
}

void TestUpkeep::aClassListSaysWhatIsWrongWithItsFile()
{
    using Kind = RosterFault::Kind;
    SCHOOL_RIG(rig);
    rig.populate();
    const auto faults = [&](std::string_view file) {
        const auto outcome = importRoster(rig.school(), rig.admin, file, true);
        return outcome ? outcome->faults : std::vector<RosterFault>();
    };
    // In Latin-1: "ü" after "Jü" in UTF-8 is the first byte that is none.
    const auto latin = faults("username,given_name\nok,Zo\xC3\xAB\nbad,J\xC3\xBCr\xFC\n");
    QCOMPARE(latin.size(), std::size_t{1});
    QVERIFY(latin[0].kind == Kind::NoUtf8);
    QCOMPARE(latin[0].line, 3);
    QCOMPARE(latin[0].value, std::string("8"));
    const auto wide = faults(std::string_view("\xFF\xFEu\0s\0", 6));
    QVERIFY(wide.size() == 1 && wide[0].kind == Kind::NoUtf8 && wide[0].line == 1 && wide[0].value == "1");
    // Both what is missing and what is there instead, with the column that was meant.
    const auto head = faults("user_name,family_name,family_name\nx,y,z\n");
    QCOMPARE(head.size(), std::size_t{3});
    QVERIFY(head[0].kind == Kind::NoSuchColumn && head[0].column == "user_name" && head[0].value == "username");
    QVERIFY(head[1].kind == Kind::ColumnTwice && head[1].column == "family_name");
    QVERIFY(head[2].kind == Kind::ColumnMissing && head[2].column == "username");
    // What is no slip of one of them means none; and words may be parted by a line.
    const auto guessed = faults("name,first_name,username\nx,y,z\n");
    QCOMPARE(guessed.size(), std::size_t{2});
    QVERIFY2(guessed[0].value.empty() && guessed[0].what.find("perhaps") == std::string::npos, guessed[0].what.c_str());
    QCOMPARE(guessed[1].value, std::string("given_name"));
    // A head in one of the window's languages names the column that it means.
    const auto meant = [&](std::string_view file) {
        QStringList columns;
        for (const RosterFault& fault : faults(file))
            if (fault.kind == Kind::NoSuchColumn)
                columns << QString::fromStdString(fault.value);
        return columns.join(u' ');
    };
    const QString all = "username given_name family_name role class";
    QCOMPARE(meant("Benutzername;Vorname;Nachname;Rolle;Klasse\n"), all);
    QCOMPARE(meant("Usuario;Nombre;Apellidos;Rol;Grupo\n"), all);
    QCOMPARE(meant("ユーザー名,名,姓,役割,クラス\n"), all);
    const auto quote = faults("username,given_name\nok,\"Ada\n");
    QVERIFY(quote.size() == 1 && quote[0].kind == Kind::OpenQuote && quote[0].line == 2 && quote[0].value == "4");
}

void TestUpkeep::noClassIsCalledWithABar()
{
    SCHOOL_RIG(rig);
    rig.populate();
    const auto added = addClass(rig.school(), rig.admin, "DEN|101");
    QVERIFY(!added && added.error().detail.find('|') != std::string::npos);
    QVERIFY(!renameClass(rig.school(), rig.admin, rig.second, "DEN|101"));
    QCOMPARE(listClasses(rig.school(), rig.admin)->size(), std::size_t{2});
}

void TestUpkeep::classListsAreTakenWholeOrNotAtAll()
{
    SCHOOL_RIG(rig);
    rig.populate();
    const auto people = [&] { return listPeople(rig.school(), rig.admin)->size(); };
    const std::size_t before = people();
    const std::string before1001 = findPerson(rig.school(), rig.admin, "s1001")->fullName();
    const char* good = "\xEF\xBB\xBFusername;given_name;family_name;role;class\r\n"
                       "new1;Åsa;\"Berg; af\";student;DEN101-A|Evening\r\n\r\n"
                       "s1001;Sam;Renamed;;Evening\r\n";
    const auto dry = importRoster(rig.school(), rig.admin, good, true);
    VERIFY_DONE(dry);
    QVERIFY(dry->faults.empty());
    QCOMPARE(dry->people.size(), std::size_t{2});
    QVERIFY(dry->people[0].isNew && dry->people[0].code.empty() && !dry->people[1].isNew);
    // Another name may be a slip of the line.
    QVERIFY(dry->people[0].nameBefore.empty());
    QVERIFY(!dry->people[0].isShort && !dry->people[1].isShort);
    const auto shorter =
        importRoster(rig.school(), rig.admin, "username,given_name,family_name\nnew8,Eve,\nnew9,Eve\n", true);
    VERIFY_DONE(shorter);
    QVERIFY(!shorter->people[0].isShort && shorter->people[1].isShort);
    QCOMPARE(dry->people[1].nameBefore, before1001);
    QCOMPARE(people(), before);
    const auto done = importRoster(rig.school(), rig.admin, good, false);
    VERIFY_DONE(done);
    QCOMPARE(people(), before + 1);
    VERIFY_DONE(Logins::redeem(rig.school(), "new1", done->people[0].code, "another horse"));
    QCOMPARE(findPerson(rig.school(), rig.admin, "new1")->familyName, std::string("Berg; af"));
    QCOMPARE(findPerson(rig.school(), rig.admin, "s1001")->familyName, std::string("Renamed"));
    QCOMPARE(listClasses(rig.school(), rig.admin)->size(), std::size_t{3});

    const auto bad = importRoster(rig.school(), rig.admin,
                                  "username,role,class\nok1,student,A\nt w o,student,A\nok1,student,A\nok2,boss,A\n"
                                  "teach,student,A\nok3,student,A,more\n",
                                  false);
    VERIFY_DONE(bad);
    QStringList lines;
    for (const RosterFault& fault : bad->faults)
        lines += QStringLiteral("%1 %2").arg(fault.line).arg(QString::fromStdString(fault.column));
    QCOMPARE(lines, (QStringList{"3 username", "4 username", "5 role", "6 role", "7 "}));
    QCOMPARE(people(), before + 1);
    // A rare kanji beyond the first plane of Unicode; a role that the list leaves open stays what it is.
    const auto rare =
        importRoster(rig.school(), rig.admin, "username,given_name,family_name,role\nteach,,,\nrare1,太,𠮷田,\n", true);
    VERIFY_DONE(rare);
    QVERIFY2(rare->faults.empty(), rare->faults.empty() ? "" : rare->faults.front().what.c_str());
    QCOMPARE(rare->people[0].role, Role::Instructor);
    // The head's faults are told by its own line.
    const auto late = importRoster(rig.school(), rig.admin, "sep=;\n\nusername;nickname\nx;y\n", true);
    VERIFY_DONE(late);
    QCOMPARE(late->faults.front().line, 3);
    // As spreadsheets of three kinds write it: rows of separators, a line that names them, the ends of old lines.
    for (const char* odd :
         {"username,class\ns1001,\n,,\n , \n", "sep=;\nusername;class\ns1001;\n", "username,class\rs1001,\r,\r"}) {
        const auto same = importRoster(rig.school(), rig.admin, odd, false);
        QVERIFY2(same.has_value() && same->faults.empty() && same->people.size() == 1,
                 same ? odd : same.error().detail.c_str());
    }
    // What a name may be is told by line and column, on either engine.
    const auto names = importRoster(
        rig.school(), rig.admin,
        "username,given_name,family_name\nlong1," + std::string(201, 'x') + ",\nok9,,\nhid,,a\u200bb\n", false);
    VERIFY_DONE(names);
    QCOMPARE(names->faults.size(), std::size_t{2});
    QVERIFY(names->faults[0].line == 2 && names->faults[0].column == "given_name");
    QVERIFY(names->faults[1].line == 4 && names->faults[1].column == "family_name");
    QCOMPARE(people(), before + 1);
    for (const char* broken : {"", "name\nx\n", "username,username\nx,y\n", "username\n\"x\n", "username\n\"x\"y\n",
                               "username\n\xFF\xFE\n"}) {
        const auto whole = importRoster(rig.school(), rig.admin, broken, false);
        QVERIFY2(!whole || !whole->faults.empty(), broken);
    }
    QCOMPARE(people(), before + 1);
    // In a spreadsheet no name is a formula.
    AttemptRecord formula = SchoolRig::attempt("=cmd|'/c calc'!A0", 1);
    VERIFY_DONE(addAttempt(rig.school(), rig.student, formula, {}));
    std::string csv;
    VERIFY_DONE(exportAttempts(rig.school(), rig.admin, [&](std::string_view line) {
        csv += line;
        return true;
    }));
    QVERIFY2(csv.find(",'=cmd|'/c calc'!A0,") != std::string::npos, csv.c_str());
    QVERIFY2(csv.find(",0.1,no,,80.0,345.678,0.850,2.400,") != std::string::npos, csv.c_str());
}

void TestUpkeep::aMadeUpSchoolIsSound()
{
    SCHOOL_RIG(rig);
    const auto admin =
        Logins::createFirstAdmin(rig.school(), {"admin", "", "", Role::Admin}, SchoolRig::kPassword, SchoolRig::kCheap);
    VERIFY_DONE(admin);
    VERIFY_DONE(makeSample(rig.school(), *admin, {40, 600, 20, 7}, madeLessons({"class1-36", "decay-21"})));
    const auto report = checkDatabase(rig.school().db, {});
    VERIFY_DONE(report);
    QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
    QCOMPARE(report->attempts, 600);
    const auto classes = listClasses(rig.school(), *admin);
    QCOMPARE(classes->size(), std::size_t{2});
    const auto overview = classOverview(rig.school(), *admin, classes->front().id);
    VERIFY_DONE(overview);
    QCOMPARE(overview->students.size(), std::size_t{20});
    QCOMPARE(overview->lessons, (std::vector<std::string>{"class1-36", "decay-21"}));
    // What is summed up is what there is.
    int attempts = 0;
    for (const auto& row : overview->cells)
        for (const MatrixCell& cell : row)
            attempts += cell.attempts;
    int listed = 0;
    for (const MatrixStudent& student : overview->students)
        listed += static_cast<int>(history(rig.school(), *admin, student.id, {})->size());
    QCOMPARE(attempts, listed);
    const auto results = lessonResults(rig.school(), *admin, classes->front().id, "class1-36");
    VERIFY_DONE(results);
    QVERIFY(!results->curve.empty() && results->curve.front().people >= 5);
    QVERIFY(results->curve.front().lowerQuartileTenths <= results->curve.front().medianTenths);
}

void TestUpkeep::flippedBytesAreReportedOrHarmless()
{
    QTemporaryDir folder;
    QByteArray whole;
    std::map<QString, RowSum> sums;
    {
        SchoolRig rig(false);
        rig.populate();
        for (int k = 0; k < 60; ++k)
            VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500 + k), {}));
        VERIFY_DONE(addPerson(rig.school(), rig.admin, {"s1003", "Cod", "Three", Role::Student}));
        sums = sumsOf(rig.school().db);
        QVERIFY(sums.size() >= 16 && sums["attempts"].rows() == 60 && sums["score_sheets"].rows() == 60);
        QSqlQuery query(rig.school().db);
        QVERIFY(query.exec("PRAGMA wal_checkpoint(TRUNCATE)"));
        query.clear();
        QFile file(rig.address());
        QVERIFY(file.open(QIODevice::ReadOnly));
        whole = file.readAll();
    }
    QVERIFY(whole.size() > 100'000);
    const int rounds =
        qEnvironmentVariableIntValue("CUSP_FLIPS") > 0 ? qEnvironmentVariableIntValue("CUSP_FLIPS") : 150;
    const QString path = folder.filePath("flipped.sqlite");
    core::Rng rng(20261123);
    int refused = 0;
    int found = 0;
    for (int round = 0; round < rounds; ++round) {
        QByteArray damaged = whole;
        const int at = rng.below(static_cast<int>(damaged.size()));
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << rng.below(8)));
        for (const char* end : {"-wal", "-shm"})
            QFile::remove(path + end);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(damaged);
        file.close();
        const auto opened = Database::open(path, std::chrono::milliseconds(10));
        if (!opened) {
            QVERIFY(!opened.error().detail.empty());
            ++refused;
            continue;
        }
        const auto report = checkDatabase((*opened)->handle(), {});
        if (!report || !report->findings.empty()) {
            ++found;
            continue;
        }
        // Harmless: not a value is another one.
        const std::map<QString, RowSum> now = sumsOf((*opened)->handle());
        for (const auto& [table, sum] : sums)
            // A next number that is higher is as good, and one that is taken is found.
            QVERIFY2(table == u"sqlite_sequence" || (now.count(table) == 1 && now.at(table) == sum),
                     qPrintable(QStringLiteral("byte %1, a row of %2").arg(at).arg(table)));
    }
    qInfo("%d flips: %d refused at opening, %d found by the check, %d harmless", rounds, refused, found,
          rounds - refused - found);
    QVERIFY(refused > 0);
}

QTEST_GUILESS_MAIN(TestUpkeep)
#include "tst_upkeep.moc"
