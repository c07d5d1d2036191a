// SPDX-License-Identifier: GPL-3.0-or-later
// Two stations do at the same moment what must not be done twice, or what each decides by what the other changes.
#include <atomic>
#include <thread>
#include <vector>

#include <QTest>

#include "database/sql/Check.h"
#include "database/sql/Dialect.h"
#include "database/sql/Roster.h"
#include "database/sql/Statement.h"
#include "tests/database/SchoolRig.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::addAttempt;
using support::SchoolRig;

namespace {

/// Another station at the rig's database. Made and used in one thread.
class Station
{
public:
    explicit Station(const QString& address, std::chrono::milliseconds patience = std::chrono::seconds(5))
        : m_database(Database::open(address, patience).value())
    {}
    [[nodiscard]] School school() const
    {
        School school{m_database->handle(), m_key};
        school.leastCost = SchoolRig::kCheap;
        return school;
    }

private:
    std::unique_ptr<Database> m_database;
    StationKey m_key = StationKey::make();
};

/// Runs two things at once, each at a station of its own.
template <class First, class Second>
void atOnce(const QString& address, First first, Second second)
{
    std::atomic<int> ready = 0;
    const auto run = [&](auto work) {
        const Station station(address);
        const School school = station.school();
        ++ready;
        while (ready < 2)
            std::this_thread::yield();
        work(school);
    };
    std::thread other([&] { run(second); });
    run(first);
    other.join();
}

/// The same thing at many stations at once, each begun when all are there.
template <class Work>
void atMany(const QString& address, int count, Work work)
{
    std::atomic<int> ready = 0;
    std::vector<std::thread> threads;
    for (int k = 0; k < count; ++k)
        threads.emplace_back([&] {
            const Station station(address);
            const School school = station.school();
            ++ready;
            while (ready < count)
                std::this_thread::yield();
            work(school);
        });
    for (std::thread& thread : threads)
        thread.join();
}

/// As in a school: comparing takes a while.
void makePasswordDear(const School& school, const char* username)
{
    QSqlQuery set(school.db);
    set.prepare("UPDATE people SET password_hash = ? WHERE username = ?");
    set.addBindValue(QString::fromStdString(hashPassword(SchoolRig::kPassword, PasswordCost{}).value()));
    set.addBindValue(QLatin1String(username));
    QVERIFY(set.exec());
}

constexpr int kRounds = 15;
constexpr int kStations = 8;

}  // namespace

class TestAtOnce : public QObject
{
    Q_OBJECT

private slots:
    void whatAnotherHasGivenIsNotOverwritten_data() { support::addEngines(); }
    void whatAnotherHasGivenIsNotOverwritten();
    void oneAdminAtLeastStays_data() { support::addEngines(); }
    void oneAdminAtLeastStays();
    void standingsKnowBothScores_data() { support::addEngines(); }
    void standingsKnowBothScores();
    void whatWasGivenLastCounts_data() { support::addEngines(); }
    void whatWasGivenLastCounts();
    void guessesAtOnceAreNoMoreThanOneAfterTheOther_data() { support::addEngines(); }
    void guessesAtOnceAreNoMoreThanOneAfterTheOther();
    void whoKnowsHisPasswordIsLetInAtManyPlaces_data() { support::addEngines(); }
    void whoKnowsHisPasswordIsLetInAtManyPlaces();
    void whoChoosesAPasswordHoldsNobodyUp_data() { support::addEngines(); }
    void whoChoosesAPasswordHoldsNobodyUp();
    void aStationThatStopsInTheMiddleHoldsNobodyUpForLong();
    void whatIsTooLongForTheServerIsAValueThatIsNotAllowed();
    void aClassListIsTriedWhileOthersWrite_data() { support::addEngines(); }
    void aClassListIsTriedWhileOthersWrite();
    void howItEndedIsAskedForWhereNobodyAnswered_data();
    void howItEndedIsAskedForWhereNobodyAnswered();
    void whoMayOnlyReadHoldsNobodyUp();
};

void TestAtOnce::oneAdminAtLeastStays()
{
    SCHOOL_RIG(rig);
    rig.populate();
    const Entered entered = addPerson(rig.school(), rig.admin, {"second", "Bo", "Two", Role::Admin}).value();
    const Session second = Logins::redeem(rig.school(), "second", entered.code, SchoolRig::kPassword).value();
    for (int round = 0; round < kRounds; ++round) {
        const auto disable = [&](const Session& me, const char* whom) {
            return [&me, whom](const School& school) {
                auto person = findPerson(school, me, whom);
                if (!person)
                    return;  // he was quicker
                person->disabled = true;
                static_cast<void>(changePerson(school, me, *person));
            };
        };
        atOnce(rig.address(), disable(rig.admin, "second"), disable(second, "admin"));
        QSqlQuery left(rig.school().db);
        QVERIFY(left.exec("SELECT count(*) FROM people WHERE role = 'admin' AND disabled = 0") && left.next());
        QCOMPARE(left.value(0).toInt(), 1);
        // Both again, by whoever is left.
        using Admin = std::pair<const Session*, const char*>;
        for (const auto& [me, whom] : {Admin(&rig.admin, "second"), Admin(&second, "admin")})
            if (auto person = findPerson(rig.school(), *me, whom); person && person->disabled) {
                person->disabled = false;
                VERIFY_DONE(changePerson(rig.school(), *me, *person));
            }
    }
}

void TestAtOnce::standingsKnowBothScores()
{
    SCHOOL_RIG(rig);
    rig.populate();
    for (int round = 0; round < kRounds; ++round) {
        const std::string lesson = "lesson-" + std::to_string(round);
        const AttemptId first = addAttempt(rig.school(), rig.student, SchoolRig::attempt(lesson, 500), {}).value();
        const AttemptId second = addAttempt(rig.school(), rig.student, SchoolRig::attempt(lesson, 600), {}).value();
        atOnce(
            rig.address(),
            [&](const School& school) { QVERIFY(overrideScore(school, rig.instructor, first, 990, "neat")); },
            [&](const School& school) {
                QVERIFY(round % 2 == 0
                            ? overrideScore(school, rig.instructor, second, 100, "not his").has_value()
                            : addAttempt(school, rig.student, SchoolRig::attempt(lesson, 700), {}).has_value());
            });
    }
    const auto report = checkDatabase(rig.school().db, {});
    VERIFY_DONE(report);
    QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
    const auto standings = standingsOf(rig.school(), rig.student, rig.student.person());
    VERIFY_DONE(standings);
    for (const LessonStanding& standing : *standings)
        QCOMPARE(standing.bestTenths, 990);
}

void TestAtOnce::whatWasGivenLastCounts()
{
    SCHOOL_RIG(rig);
    rig.populate();
    const AttemptId id = addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500), {}).value();
    for (int round = 0; round < kRounds; ++round)
        atOnce(
            rig.address(),
            [&](const School& school) { QVERIFY(overrideScore(school, rig.instructor, id, 600 + round, "one")); },
            [&](const School& school) { QVERIFY(overrideScore(school, rig.instructor, id, 800 + round, "two")); });
    const auto report = checkDatabase(rig.school().db, {});
    VERIFY_DONE(report);
    QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
}

void TestAtOnce::guessesAtOnceAreNoMoreThanOneAfterTheOther()
{
    SCHOOL_RIG(rig);
    rig.populate();
    makePasswordDear(rig.school(), "s1001");
    for (const char* name : {"s1001", "nobody"}) {
        for (int k = 0; k < Logins::kFreeFailures; ++k)
            static_cast<void>(Logins::login(rig.school(), name, "wrong horse"));
        for (int wait = 1; wait <= 2; wait *= 2) {
            rig.nowUtc = rig.nowUtc.addSecs(wait);
            std::atomic<int> compared = 0;
            std::atomic<int> refused = 0;
            atMany(rig.address(), kStations, [&](School school) {
                school.nowUtc = [&rig] { return rig.nowUtc; };
                const auto session = Logins::login(school, name, "wrong horse");
                if (!session)
                    ++(session.error().code == core::ErrorCode::TooSoon ? refused : compared);
            });
            QCOMPARE(compared, 1);
            QCOMPARE(refused, kStations - 1);
        }
    }
}

void TestAtOnce::whoKnowsHisPasswordIsLetInAtManyPlaces()
{
    SCHOOL_RIG(rig);
    rig.populate();
    makePasswordDear(rig.school(), "s1001");
    std::atomic<int> in = 0;
    atMany(rig.address(), kStations, [&](const School& school) {
        const auto session = Logins::login(school, "s1001", SchoolRig::kPassword);
        VERIFY_DONE(session);
        ++in;
    });
    QCOMPARE(in, kStations);
    QSqlQuery left(rig.school().db);
    QVERIFY(left.exec("SELECT count(*) FROM failed_logins") && left.next());
    QCOMPARE(left.value(0).toInt(), 0);
}

/// Hashing takes its time, but not that of the others.
void TestAtOnce::whoChoosesAPasswordHoldsNobodyUp()
{
    SCHOOL_RIG(rig);
    rig.populate();
    VERIFY_DONE(raisePasswordCost(rig.school(), rig.admin, {6, std::size_t{64} << 20U}));
    const std::string code = resetPassword(rig.school(), rig.admin, rig.classmate.person()).value().code;
    std::atomic<bool> isDone = false;
    std::thread other([&] {
        const Station station(rig.address(), std::chrono::milliseconds(100));
        const School school = station.school();
        while (!isDone) {
            VERIFY_DONE(Logins::logout(school, rig.student));
            std::this_thread::sleep_for(std::chrono::milliseconds(10));  // a file has no queue: let the other in
        }
    });
    const auto redeemed = Logins::redeem(rig.school(), "s1002", code, "another horse");
    const auto changed = redeemed ? Logins::changePassword(rig.school(), *redeemed, "another horse", "a third horse")
                                  : core::Status(tl::unexpected(redeemed.error()));
    isDone = true;
    other.join();
    VERIFY_DONE(redeemed);
    VERIFY_DONE(changed);
}

void TestAtOnce::aStationThatStopsInTheMiddleHoldsNobodyUpForLong()
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

/// Nor does what it can never take hold up what stands behind it: that is not called a matter of waiting.
void TestAtOnce::whatIsTooLongForTheServerIsAValueThatIsNotAllowed()
{
    if (!support::sharedServer().fault().isEmpty())
        QSKIP(qPrintable(support::sharedServer().fault()));
    SchoolRig rig(true);
    QVERIFY(rig.isOpen());
    rig.populate();
    std::string lesson;  // that cannot be made shorter
    for (unsigned k = 0, next = 1; k < 20000; ++k, next = next * 1664525U + 1013904223U)
        lesson += static_cast<char>('a' + (next >> 16U) % 26U);
    VERIFY_REFUSED(addAttempt(rig.school(), rig.student, SchoolRig::attempt(lesson, 500), {}),
                   core::ErrorCode::OutOfRange);
}

void TestAtOnce::aClassListIsTriedWhileOthersWrite()
{
    SCHOOL_RIG(rig);
    rig.populate();
    const std::string list = "username,given_name,class\nnew1,Ada,A|B\nnew2,Bo,B\ns1001,,A\n";
    const Station other(rig.address());
    const School writer = other.school();
    VERIFY_DONE(execute(writer.db, dialect::beginWrite(writer.db), "begin"));
    VERIFY_DONE(takeTurn(writer));
    const auto tried = importRoster(rig.school(), rig.admin, list, true);
    VERIFY_DONE(tried);
    QCOMPARE(tried->people.size(), std::size_t{3});
    QCOMPARE(tried->newClasses, (std::vector<std::string>{"A", "B"}));
    VERIFY_DONE(execute(writer.db, "ROLLBACK", "end it"));
    // Somebody else has entered one of them since it was looked at, under another name.
    VERIFY_DONE(addPerson(rig.school(), rig.admin, {"new1", "Otto", "Other", Role::Student}));
    VERIFY_REFUSED(importRoster(rig.school(), rig.admin, list, false, &*tried), core::ErrorCode::ChangedSince);
    QCOMPARE(findPerson(rig.school(), rig.admin, "new1")->givenName, std::string("Otto"));
    VERIFY_REFUSED(findPerson(rig.school(), rig.admin, "new2"), core::ErrorCode::UnknownName);
    const auto triedNow = importRoster(rig.school(), rig.admin, list, true);
    VERIFY_DONE(triedNow);
    const auto entered = importRoster(rig.school(), rig.admin, list, false, &*triedNow);
    VERIFY_DONE(entered);
    QCOMPARE(entered->newClasses, tried->newClasses);
    // The same once more changes nothing, and the audit is as whole as before.
    const AuditHead head = auditHead(rig.school()).value();
    VERIFY_DONE(importRoster(rig.school(), rig.admin, list, false));
    QVERIFY(auditHead(rig.school()).value() == head);
    const auto report = checkDatabase(rig.school().db, {});
    VERIFY_DONE(report);
    QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
}

/// Two teachers look at the same list, and change it one after the other.
void TestAtOnce::whatAnotherHasGivenIsNotOverwritten()
{
    SCHOOL_RIG(rig);
    rig.populate();
    const School& school = rig.school();
    const ClassAssignment seen{0, rig.first, "class1-36", "", 3};
    ClassAssignment mine = seen;
    mine.attemptLimit = 5;
    ClassAssignment theirs = seen;
    theirs.dueUtc = "2027-02-15T22:59:59Z";
    const auto given = [&] {
        auto all = listAssignments(school, rig.instructor).value();
        for (ClassAssignment& one : all)
            one.id = 0;
        return all;
    };
    VERIFY_DONE(assign(school, rig.instructor, seen));
    VERIFY_REFUSED(assign(school, rig.instructor, mine), ErrorCode::ChangedSince);
    VERIFY_DONE(assign(school, rig.admin, theirs, seen));
    VERIFY_REFUSED(assign(school, rig.instructor, mine, seen), ErrorCode::ChangedSince);
    VERIFY_REFUSED(unassign(school, rig.instructor, seen), ErrorCode::ChangedSince);
    QCOMPARE(given(), std::vector{theirs});
    VERIFY_DONE(unassign(school, rig.instructor, theirs));
    VERIFY_REFUSED(assign(school, rig.instructor, mine, seen), ErrorCode::ChangedSince);
    VERIFY_DONE(unassign(school, rig.instructor, seen));  // gone already
    QVERIFY(given().empty());
    VERIFY_DONE(assign(school, rig.instructor, mine));
    QCOMPARE(given(), std::vector{mine});
}

/// He can lock any number there is: what a station waits for is none.
void TestAtOnce::howItEndedIsAskedForWhereNobodyAnswered_data()
{
    QTest::addColumn<bool>("isStopped");
    QTest::addColumn<bool>("comesBack");
    QTest::newRow("the connection is lost") << false << true;
    QTest::newRow("the server stops, and comes back") << true << true;
    QTest::newRow("the server stays away") << true << false;
}

/// Somebody is entered, and the server goes after it has kept that and before it has said so: it waits for a second
/// server, which there is not.
void TestAtOnce::howItEndedIsAskedForWhereNobodyAnswered()
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

void TestAtOnce::whoMayOnlyReadHoldsNobodyUp()
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

QTEST_GUILESS_MAIN(TestAtOnce)
#include "tst_at_once.moc"
