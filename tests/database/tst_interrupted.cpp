// SPDX-License-Identifier: GPL-3.0-or-later
// Many rounds each: programs killed at random moments, several doing the same thing at once, servers that stop, and
// flipped bits.
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
#include "database/sql/Copy.h"
#include "database/sql/Dialect.h"
#include "database/sql/Migrations.h"
#include "database/sql/RowSum.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Tables.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::attemptsIn;
using support::SchoolRig;
using support::Station;

namespace {

constexpr int kDone = 0;
constexpr int kTooLate = 1;
constexpr int kOtherwise = 2;

/// Runs a function in a process of its own. Returns the id of the process.
pid_t begin(const std::function<int()>& work)
{
    const pid_t other = fork();
    if (other == 0)
        _exit(work());
    return other;
}

/// Waits for a process to end. Returns its exit code, or -1 if it was killed.
int exitOf(pid_t other)
{
    int status = 0;
    return waitpid(other, &status, 0) == other && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Runs several processes that do the same thing at once. Returns how many end with kDone; negative if one ends with
/// neither kDone nor kTooLate.
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

/// Returns a sum over all rows of each table. Leaves out the columns that the audit does not cover: when a user was
/// added and when they last logged in.
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
    /// After the kill, a second restore succeeds, and the replaced database is complete in one of the files.
    void aRestoreKilledAtAnyMomentLosesNothing()
    {
        QTemporaryDir elsewhere;
        QString backup;
        const QString crashed = elsewhere.filePath("crashed.sqlite");
        {
            SchoolRig rig(support::populatedSchool(false));
            backup = backUp(rig.school().db, elsewhere.path(), rig.nowUtc).value();
            VERIFY_DONE(rig.add(rig.student, "class1-36", 900));
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
            usleep(static_cast<useconds_t>(round) * 500);  // later in each round
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

    /// Two programs restore at once. At least one succeeds, and one that finds the file in use is refused.
    void twoRestoresAtOnceLeaveTheFileThere()
    {
        QTemporaryDir folder;
        SchoolRig rig(support::populatedSchool(false));
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
        // Each replaced file is still there, and no temporary file is left.
        QCOMPARE(QDir(folder.path()).entryList({"replaced-*"}, QDir::Files).size(), restored);
        QVERIFY(QDir(folder.path()).entryList({"school.sqlite.*"}, QDir::Files).isEmpty());
    }

    /// Backups and migrations of several programs do not wait for each other and do not remove each other's files.
    void backupsAndMigrationsAtOnceLeaveEachOtherAlone()
    {
        SchoolRig rig(support::populatedSchool(false));
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
                const support::RawFile raw(older);
                const QString mark = QStringLiteral("PRAGMA application_id = %1").arg(dialect::kApplicationId);
                VERIFY_DONE(execute(raw.handle(), mark, "mark"));
                VERIFY_DONE(execute(raw.handle(), "PRAGMA journal_mode = WAL", "keep a log"));
                VERIFY_DONE(migrate(raw.handle(), std::span(*steps).first(steps->size() - 1)));
            }
            QCOMPARE(together(3, [&] { return Database::open(older) ? kDone : kOtherwise; }), 3);
        }
    }

    /// A killed copy leaves no partial or empty database that could be taken for a complete one.
    void aCopyThatIsKilledIsNoSchool_data() { support::addEngines(); }
    void aCopyThatIsKilledIsNoSchool()
    {
        QFETCH(bool, onServer);
        if (onServer)
            NEEDS_SERVER();
        SchoolRig first(support::populatedSchool(false));
        VERIFY_DONE(first.add(first.student, SchoolRig::attempt("class1-36", 500), "a recording"));
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
        const auto killedAtTheRecordings = [&] {  // the recordings are copied last
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
        VERIFY_REFUSED(Database::open(where, asItIs), ErrorCode::BadStructure, "there is no school in it");
        QVERIFY(copy({}));
        VERIFY_DONE(Database::open(where, asItIs));
    }

    void flippedBytesAreReportedOrHarmless()
    {
        QTemporaryDir folder;
        QByteArray whole;
        std::map<QString, RowSum> sums;
        {
            SchoolRig rig(support::populatedSchool(false));
            for (int k = 0; k < 60; ++k)
                VERIFY_DONE(rig.add(rig.student, "class1-36", 500 + k));
            VERIFY_DONE(addPerson(rig.school(), rig.admin, {"s1003", "Cod", "Three", Role::Student}));
            sums = sumsOf(rig.school().db);
            QVERIFY(sums.size() >= 10 && sums["attempts"].rows() == 60 && sums["score_sheets"].rows() == 60);
            QFile file(backUp(rig.school().db, folder.path(), rig.nowUtc).value());
            QVERIFY(file.open(QIODevice::ReadOnly));
            whole = file.readAll();
        }
        constexpr int kRounds = 300;
        const QString path = folder.filePath("flipped.sqlite");
        core::Rng rng(20261123);
        int refused = 0;
        int found = 0;
        for (int round = 0; round < kRounds; ++round) {
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
            // The flip was harmless: no value has changed.
            std::map<QString, RowSum> now = sumsOf((*opened)->handle());
            for (const auto& [table, sum] : sums)
                // A higher next number does no harm, and the check would find one that is in use.
                QVERIFY2(table == u"sqlite_sequence" || now[table] == sum,
                         qPrintable(QStringLiteral("byte %1, a row of %2").arg(at).arg(table)));
        }
        qInfo("%d flips: %d refused at opening, %d found by the check, %d harmless", kRounds, refused, found,
              kRounds - refused - found);
        QVERIFY(refused > 0);
    }

    void aStationThatStopsInTheMiddleHoldsNobodyUpForLong()
    {
        NEEDS_SERVER();
        SchoolRig rig(support::populatedSchool(true));
        const DatabaseContext& stopped = rig.school();
        VERIFY_DONE(execute(stopped.db, dialect::beginWrite(stopped.db), "begin"));
        VERIFY_DONE(takeTurn(stopped));
        const Station other(rig.address());
        VERIFY_DONE(Logins::login(other.school(), "s1001", SchoolRig::kPassword));
        // When the suspended program continues, it gets the error that its connection is gone, and reconnects.
        VERIFY_REFUSED(execute(stopped.db, "COMMIT", "end it"), ErrorCode::ConnectionLost);
        VERIFY_DONE(rig.database().reconnect());
        VERIFY_DONE(Logins::logout(stopped, rig.student));
    }

    void howItEndedIsAskedForWhereNobodyAnswered_data()
    {
        support::columns<bool, bool>("isStopped", "comesBack");
        QTest::newRow("the connection is lost") << false << true;
        QTest::newRow("the server stops, and comes back") << true << true;
        QTest::newRow("the server stays away") << true << false;
    }

    /// The server stops between saving a new user and confirming it: it waits for a standby server that does not exist.
    /// After reconnecting, the program finds out by itself whether the user was saved.
    void howItEndedIsAskedForWhereNobodyAnswered()
    {
        QFETCH(bool, isStopped);
        QFETCH(bool, comesBack);
        NEEDS_SERVER();
        support::PostgresServer& server = support::sharedServer();
        SchoolRig rig(support::populatedSchool(true));
        rig.run({"ALTER SYSTEM SET synchronous_standby_names = 'nobody'", "SELECT pg_reload_conf()"});
        core::Result<Entered> entered = tl::unexpected(core::Error{});
        std::thread other([&] {
            const Station station(rig.address());
            entered = addPerson(station.school(), rig.admin, {"s3001", "Late", "Comer", Role::Student});
        });
        const QString waiting = "pg_stat_activity WHERE wait_event = 'SyncRep'";
        const bool waits = QTest::qWaitFor([&] { return rig.count(waiting) > 0; }, 30'000);
        if (!isStopped)
            rig.run({"SELECT pg_terminate_backend(pid) FROM " + waiting});
        else
            server.kill();
        if (isStopped && comesBack)
            QVERIFY(server.start());
        other.join();
        if (isStopped && !comesBack)
            QVERIFY(server.start());
        rig.reopen();
        rig.run({"ALTER SYSTEM RESET synchronous_standby_names", "SELECT pg_reload_conf()"});
        QVERIFY(waits);
        QCOMPARE(rig.count("people WHERE username = 's3001'"), 1);
        if (comesBack) {
            VERIFY_DONE(entered);
            VERIFY_DONE(Logins::redeem(rig.school(), "s3001", entered->code, SchoolRig::kPassword));
        } else {
            VERIFY_REFUSED(entered, ErrorCode::OutcomeUnknown);
        }
    }
};

QTEST_GUILESS_MAIN(TestInterrupted)
#include "tst_interrupted.moc"
