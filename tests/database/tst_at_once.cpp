// SPDX-License-Identifier: GPL-3.0-or-later
// Two stations do at the same moment what must not be done twice, or what each decides by what the other changes.
#include <atomic>
#include <thread>
#include <vector>

#include <QSemaphore>
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
using support::Station;

namespace {

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

constexpr int kRounds = 5;
constexpr int kStations = 4;

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
    void guessesAtOnceAreNoMoreThanOneAfterTheOther_data() { support::addEngines(); }
    void guessesAtOnceAreNoMoreThanOneAfterTheOther();
    void whoKnowsHisPasswordIsLetInAtManyPlaces_data() { support::addEngines(); }
    void whoKnowsHisPasswordIsLetInAtManyPlaces();
    void whoChoosesAPasswordHoldsNobodyUp_data() { support::addEngines(); }
    void whoChoosesAPasswordHoldsNobodyUp();
    void whatIsTooLongForTheServerIsAValueThatIsNotAllowed();
    void aClassListIsTriedWhileOthersWrite_data() { support::addEngines(); }
    void aClassListIsTriedWhileOthersWrite();
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
        const auto mark = [&](AttemptId id, int tenths) {
            return [&, id, tenths](const School& school) {
                VERIFY_DONE(overrideScore(school, rig.instructor, id, tenths, "as seen"));
            };
        };
        const auto deliver = [&](const School& school) {
            VERIFY_DONE(addAttempt(school, rig.student, SchoolRig::attempt(lesson, 700), {}));
        };
        atOnce(rig.address(), mark(first, 990), mark(second, 100));
        atOnce(rig.address(), mark(first, 990), deliver);
        atOnce(rig.address(), mark(second, 600 + round), mark(second, 800 + round));
    }
    const auto report = checkDatabase(rig.school().db, {});
    VERIFY_DONE(report);
    QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
    const auto standings = standingsOf(rig.school(), rig.student, rig.student.person());
    VERIFY_DONE(standings);
    QCOMPARE(standings->size(), static_cast<std::size_t>(kRounds));
    for (const LessonStanding& standing : *standings)
        QCOMPARE(standing.bestTenths, 990);
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
    QSemaphore done;
    std::thread other([&] {
        const Station station(rig.address(), std::chrono::milliseconds(100));
        const School school = station.school();
        do
            VERIFY_DONE(Logins::logout(school, rig.student));
        while (!done.tryAcquire(1, 10));  // ms: a file has no queue, and lets the other in then
    });
    const auto redeemed = Logins::redeem(rig.school(), "s1002", code, "another horse");
    const auto changed = redeemed ? Logins::changePassword(rig.school(), *redeemed, "another horse", "a third horse")
                                  : core::Status(tl::unexpected(redeemed.error()));
    done.release();
    other.join();
    VERIFY_DONE(redeemed);
    VERIFY_DONE(changed);
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

QTEST_GUILESS_MAIN(TestAtOnce)
#include "tst_at_once.moc"
