// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that are killed at any moment, several that do the same at once, servers that stop, and bytes that flip:
// many rounds of each.
#include <array>
#include <csignal>
#include <functional>
#include <map>
#include <thread>

#include <QDir>
#include <QFile>
#include <QTest>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/Rng.h"
#include "database/sql/Backups.h"
#include "database/sql/Check.h"
#include "database/sql/Copy.h"
#include "database/sql/Dialect.h"
#include "database/sql/Migrations.h"
#include "database/sql/RowSum.h"
#include "database/sql/Statement.h"
#include "tests/database/SchoolRig.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::addAttempt;
using support::SchoolRig;
using support::Station;

namespace {

constexpr int kDone = 0;
constexpr int kTooLate = 1;
constexpr int kOtherwise = 2;

int attemptsIn(const QString& file)
{
    const auto database = Database::open(file);
    return database ? ask((*database)->handle(), "SELECT count(*) FROM attempts", "count")->toInt() : -1;
}

/// Work in a process of its own.
pid_t begin(const std::function<int()>& work)
{
    const pid_t other = fork();
    if (other == 0)
        _exit(work());
    return other;
}

/// -1: it was killed.
int exitOf(pid_t other)
{
    int status = 0;
    return waitpid(other, &status, 0) == other && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// How many of some processes that do the same at once end with kDone. None ends otherwise than that, or too late.
int together(int count, const std::function<int()>& work)
{
    std::vector<pid_t> others;
    for (int k = 0; k < count; ++k)
        others.push_back(begin(work));
    int done = 0;
    for (const pid_t other : others) {
        const int code = exitOf(other);
        if (code != kDone && code != kTooLate)
            qWarning("one ended with %d", code);
        done += code == kDone ? 1 : code == kTooLate ? 0 : -1000;
    }
    return done;
}

/// All rows of all tables, but for what nobody compares with the audit: when somebody was entered, and was here last.
std::map<QString, RowSum> sumsOf(const QSqlDatabase& db)
{
    const QStringList moments{"created_utc", "last_login_utc"};
    std::map<QString, RowSum> sums;
    for (const QString& table : db.tables()) {
        QStringList columns = columnsOf(db, table);
        if (table == u"people")
            columns.removeIf([&moments](const QString& column) { return moments.contains(column); });
        static_cast<void>(forEach(db, QStringLiteral("SELECT %1 FROM %2").arg(columns.join(u','), table), "sum it", {},
                                  [&](const QSqlQuery& row) { sums[table].add(row, columns.size()); }));
    }
    return sums;
}

}  // namespace

class TestInterrupted : public QObject
{
    Q_OBJECT

private slots:
    void aRestoreKilledAtAnyMomentLosesNothing();
    void twoRestoresAtOnceLeaveTheFileThere();
    void backupsAndMigrationsAtOnceLeaveEachOtherAlone();
    void aCopyThatIsKilledIsNoSchool_data() { support::addEngines(); }
    void aCopyThatIsKilledIsNoSchool();
    void ofTwoCopiesAtOnceOneArrives_data() { support::addEngines(); }
    void ofTwoCopiesAtOnceOneArrives();
    void flippedBytesAreReportedOrHarmless();
    void aStationThatStopsInTheMiddleHoldsNobodyUpForLong();
    void howItEndedIsAskedForWhereNobodyAnswered_data();
    void howItEndedIsAskedForWhereNobodyAnswered();
    void whoMayOnlyReadHoldsNobodyUp();
};

/// And restored again: what was there lies whole in one of the files.
void TestInterrupted::aRestoreKilledAtAnyMomentLosesNothing()
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
    for (int round = 0; round < 60; ++round) {
        QTemporaryDir folder;
        const QString file = folder.filePath("school.sqlite");
        for (const char* end : {"", "-wal"})
            QVERIFY(QFile::copy(crashed + end, file + end));
        const pid_t other = begin([&] { return restoreBackup(backup, file, now) ? kDone : kOtherwise; });
        usleep(static_cast<useconds_t>(round) * 500);  // each time a later moment
        kill(other, SIGKILL);
        exitOf(other);
        VERIFY_DONE(restoreBackup(backup, file, now.addSecs(1)));
        QCOMPARE(attemptsIn(file), 0);
        int most = 0;
        for (const QFileInfo& one : QDir(folder.path()).entryInfoList({"replaced-*.sqlite"}))
            most = std::max(most, attemptsIn(one.filePath()));
        QCOMPARE(most, 1);
    }
}

/// Two programs: one of them restores, and whoever comes too early is told so.
void TestInterrupted::twoRestoresAtOnceLeaveTheFileThere()
{
    QTemporaryDir folder;
    SchoolRig rig(false);
    rig.populate();
    const QString backup = backUp(rig.school().db, folder.filePath("backups"), rig.nowUtc).value();
    const QString file = folder.filePath("school.sqlite");
    QVERIFY(QFile::copy(backup, file));
    int restored = 0;
    for (int round = 0; round < 25; ++round) {
        const int done = together(2, [&] {
            const auto put = restoreBackup(backup, file, rig.nowUtc);
            return put ? kDone : put.error().code == ErrorCode::Busy ? kTooLate : kOtherwise;
        });
        QVERIFY(done > 0);
        restored += done;
        QVERIFY(QFile::exists(file));
    }
    QCOMPARE(attemptsIn(file), 0);
    // What was there each time lies there whole, and nothing else is left.
    QCOMPARE(QDir(folder.path()).entryList({"replaced-*"}, QDir::Files).size(), restored);
    QVERIFY(QDir(folder.path()).entryList({"school.sqlite.*"}, QDir::Files).isEmpty());
}

/// Each waits for nobody, and takes nothing from another.
void TestInterrupted::backupsAndMigrationsAtOnceLeaveEachOtherAlone()
{
    SchoolRig rig(false);
    rig.populate();
    rig.close();
    QTemporaryDir folder;
    for (int round = 1; round <= 5; ++round) {
        const auto makeOne = [&] {
            const auto database = Database::open(rig.address());
            return database && backUp((*database)->handle(), folder.path(), rig.nowUtc) ? kDone : kOtherwise;
        };
        QCOMPARE(together(4, makeOne), 4);
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
        QCOMPARE(together(3, [&] { return Database::open(older) ? kDone : kOtherwise; }), 3);
    }
}

/// Nor is there half of one, or an empty one, that somebody might take for it.
void TestInterrupted::aCopyThatIsKilledIsNoSchool()
{
    QFETCH(bool, onServer);
    if (onServer && !support::sharedServer().fault().isEmpty())
        QSKIP(qPrintable(support::sharedServer().fault()));
    SchoolRig first(false);
    first.populate();
    VERIFY_DONE(addAttempt(first.school(), first.student, SchoolRig::attempt("class1-36", 500), "a recording"));
    first.close();
    QTemporaryDir folder;
    const Address where =
        Address::parse(onServer ? support::sharedServer().newDatabase() : folder.filePath("copy.sqlite")).value();
    Database::Options options;
    options.isToBeFilled = true;
    const auto copy = [&](const CopyProgress& progress) {
        const StationKey key = StationKey::make();
        const auto source = Database::open(first.address());
        const auto there = Database::open(where, options);
        return source && there &&
               copySchool({(*source)->handle(), key}, first.admin, {(*there)->handle(), key}, progress);
    };
    const auto killedAtTheRecordings = [&] {  // they come last
        static_cast<void>(copy([](const QString& what, std::int64_t) {
            if (what == u"recordings")
                _exit(kDone);
            return true;
        }));
        return kOtherwise;
    };
    QCOMPARE(exitOf(begin(killedAtTheRecordings)), kDone);
    Database::Options asItIs;
    asItIs.mayCreate = false;
    const auto empty = Database::open(where, asItIs);
    VERIFY_REFUSED(empty, ErrorCode::BadStructure);
    QVERIFY2(empty.error().detail.find("there is no school in it") != std::string::npos, empty.error().detail.c_str());
    QVERIFY(copy({}));
    VERIFY_DONE(Database::open(where, asItIs));
}

/// The others are told why, whichever moment they come in.
void TestInterrupted::ofTwoCopiesAtOnceOneArrives()
{
    SCHOOL_RIG(target);
    SchoolRig from(false);
    from.populate();
    for (int k = 0; k < 30; ++k)
        VERIFY_DONE(addAttempt(from.school(), from.student, SchoolRig::attempt("class1-36", k), {}));
    from.close();
    const QString where = target.address();
    target.close();
    const auto copy = [&] {
        const StationKey key = StationKey::make();
        const auto source = Database::open(from.address());
        const auto there = Database::open(where, std::chrono::seconds(20));
        if (!source || !there)
            return kOtherwise;
        const auto copied = copySchool({(*source)->handle(), key}, from.admin, {(*there)->handle(), key});
        return copied ? kDone : copied.error().code == ErrorCode::OutOfRange ? kTooLate : kOtherwise;
    };
    QCOMPARE(together(3, copy), 1);
    QCOMPARE(attemptsIn(where), 30);
}

void TestInterrupted::flippedBytesAreReportedOrHarmless()
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
        QVERIFY(sums.size() >= 10 && sums["attempts"].rows() == 60 && sums["score_sheets"].rows() == 60);
        QFile file(backUp(rig.school().db, folder.path(), rig.nowUtc).value());
        QVERIFY(file.open(QIODevice::ReadOnly));
        whole = file.readAll();
    }
    const int rounds =
        qEnvironmentVariableIntValue("CUSP_FLIPS") > 0 ? qEnvironmentVariableIntValue("CUSP_FLIPS") : 300;
    const QString path = folder.filePath("flipped.sqlite");
    core::Rng rng(20261123);
    int refused = 0;
    int found = 0;
    for (int round = 0; round < rounds; ++round) {
        QByteArray damaged = whole;
        const int at = rng.below(static_cast<int>(damaged.size()));
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << rng.below(8)));
        for (const QString& one : wholeOf(path))
            QFile::remove(one);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(damaged) == damaged.size());
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
        std::map<QString, RowSum> now = sumsOf((*opened)->handle());
        for (const auto& [table, sum] : sums)
            // A next number that is higher is as good, and one that is taken is found.
            QVERIFY2(table == u"sqlite_sequence" || now[table] == sum,
                     qPrintable(QStringLiteral("byte %1, a row of %2").arg(at).arg(table)));
    }
    qInfo("%d flips: %d refused at opening, %d found by the check, %d harmless", rounds, refused, found,
          rounds - refused - found);
    QVERIFY(refused > 0);
}

void TestInterrupted::aStationThatStopsInTheMiddleHoldsNobodyUpForLong()
{
    if (!support::sharedServer().fault().isEmpty())
        QSKIP(qPrintable(support::sharedServer().fault()));
    SchoolRig rig(true);
    QVERIFY(rig.isOpen());
    rig.populate();
    const School& stopped = rig.school();
    VERIFY_DONE(execute(stopped.db, dialect::beginWrite(stopped.db), "begin"));
    VERIFY_DONE(takeTurn(stopped));
    const Station other(rig.address());
    VERIFY_DONE(Logins::login(other.school(), "s1001", SchoolRig::kPassword));
    // When it goes on it is told that its connection is gone, and connects again.
    VERIFY_REFUSED(execute(stopped.db, "COMMIT", "end it"), core::ErrorCode::ConnectionLost);
    VERIFY_DONE(rig.database().reconnect());
    VERIFY_DONE(Logins::logout(stopped, rig.student));
}

void TestInterrupted::howItEndedIsAskedForWhereNobodyAnswered_data()
{
    QTest::addColumn<bool>("isStopped");
    QTest::addColumn<bool>("comesBack");
    QTest::newRow("the connection is lost") << false << true;
    QTest::newRow("the server stops, and comes back") << true << true;
    QTest::newRow("the server stays away") << true << false;
}

/// Somebody is entered, and the server goes after it has kept that and before it has said so: it waits for a second
/// server, which there is not.
void TestInterrupted::howItEndedIsAskedForWhereNobodyAnswered()
{
    QFETCH(bool, isStopped);
    QFETCH(bool, comesBack);
    support::PostgresServer& server = support::sharedServer();
    if (!server.fault().isEmpty())
        QSKIP(qPrintable(server.fault()));
    SchoolRig rig(true);
    rig.populate();
    const auto twoServers = [](const QSqlDatabase& db, const char* change) {
        VERIFY_DONE(
            execute(db, QStringLiteral("ALTER SYSTEM %1").arg(QLatin1String(change)), "change how it confirms"));
        VERIFY_DONE(ask(db, "SELECT pg_reload_conf()", "change how it confirms"));
    };
    twoServers(rig.school().db, "SET synchronous_standby_names = 'nobody'");
    core::Result<Entered> entered = tl::unexpected(core::Error{});
    std::thread other([&] {
        const Station station(rig.address());
        entered = addPerson(station.school(), rig.admin, {"s3001", "Late", "Comer", Role::Student});
    });
    const auto waiting = [&] {
        return ask(rig.school().db, "SELECT pid FROM pg_stat_activity WHERE wait_event = 'SyncRep'", "look").value();
    };
    const bool waits = QTest::qWaitFor([&] { return !waiting().isNull(); }, 30'000);
    if (!isStopped)
        static_cast<void>(ask(rig.school().db, "SELECT pg_terminate_backend(?)", "end it", {waiting()}));
    else
        server.kill();
    if (isStopped && comesBack)
        QVERIFY(server.start());
    other.join();
    if (isStopped && !comesBack)
        QVERIFY(server.start());
    rig.reopen();
    twoServers(rig.school().db, "RESET synchronous_standby_names");
    QVERIFY(waits);
    QCOMPARE(ask(rig.school().db, "SELECT count(*) FROM people WHERE username = 's3001'", "count").value().toInt(), 1);
    if (comesBack) {
        VERIFY_DONE(entered);
        VERIFY_DONE(Logins::redeem(rig.school(), "s3001", entered->code, SchoolRig::kPassword));
    } else {
        VERIFY_REFUSED(entered, ErrorCode::OutcomeUnknown);
    }
}

/// They can lock any number there is: what a station waits for is none.
void TestInterrupted::whoMayOnlyReadHoldsNobodyUp()
{
    if (!support::sharedServer().fault().isEmpty())
        QSKIP(qPrintable(support::sharedServer().fault()));
    SchoolRig rig(true);
    rig.populate();
    const auto reader = Database::open(rig.address());
    VERIFY_DONE(reader);
    const QSqlDatabase db = (*reader)->handle();
    const QString role = "reads_" + QString::fromStdString(newUid());
    for (const char* sql : {"CREATE ROLE %1", "GRANT SELECT ON ALL TABLES IN SCHEMA public TO %1", "SET ROLE %1"})
        VERIFY_DONE(execute(db, QString::fromLatin1(sql).arg(role), "be another"));
    for (int more = 0; more < 3; ++more)
        VERIFY_DONE(
            execute(db, QStringLiteral("SELECT pg_advisory_lock(%1)").arg(dialect::kApplicationId + more), "lock"));
    VERIFY_DONE(execute(db, "BEGIN", "read"));
    VERIFY_DONE(execute(db, "SELECT count(*) FROM audit_seal", "read"));
    VERIFY_REFUSED(execute(db, "LOCK TABLE audit_seal IN SHARE UPDATE EXCLUSIVE MODE", "lock"),
                   ErrorCode::ServerRefuses);
    VERIFY_DONE(execute(db, "ROLLBACK", "end reading"));
    VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500), {}));
    // Of two that write one waits, and is told by whom it may be held up.
    VERIFY_DONE(execute(db, "RESET ROLE", "be oneself"));
    VERIFY_DONE(execute(db, "BEGIN", "write"));
    VERIFY_DONE(execute(db, dialect::lockTurn(db), "write"));
    const auto late = addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500), {});
    VERIFY_REFUSED(late, ErrorCode::Busy);
    QVERIFY2(late.error().detail.find("pg_locks") != std::string::npos, late.error().detail.c_str());
    VERIFY_DONE(execute(db, "ROLLBACK", "end writing"));
    VERIFY_DONE(execute(db, "DROP OWNED BY " + role + "; DROP ROLE " + role, "tidy up"));
}

QTEST_GUILESS_MAIN(TestInterrupted)
#include "tst_interrupted.moc"
