// SPDX-License-Identifier: GPL-3.0-or-later
// Two stations use the database at the same moment: both do what may be done only once, or one changes what the other's
// decision depends on.
#include <atomic>
#include <functional>
#include <thread>
#include <vector>

#include <QSemaphore>
#include <QTest>

#include "database/sql/Dialect.h"
#include "database/sql/Roster.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Suite.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::addAttempt;
using support::SchoolRig;
using support::Station;

namespace {

using Work = std::function<void(DatabaseContext)>;

/// Runs each task on its own connection. All of them start at the same time.
void atOnce(const QString& address, const std::vector<Work>& works)
{
    std::atomic<std::size_t> ready = 0;
    std::vector<std::thread> threads;
    for (const Work& work : works)
        threads.emplace_back([&] {
            const Station station(address);
            const DatabaseContext school = station.school();
            ++ready;
            while (ready < works.size())
                std::this_thread::yield();
            work(school);
        });
    for (std::thread& thread : threads)
        thread.join();
}

/// Gives a user a password hash of the usual cost. Comparing with it takes some time, as in a real school.
void makePasswordDear(const SchoolRig& rig, const QString& username)
{
    const std::string hash = hashPassword(SchoolRig::kPassword, PasswordCost{}).value();
    rig.run({QStringLiteral("UPDATE people SET password_hash = '%1' WHERE username = '%2'")
                 .arg(QString::fromStdString(hash), username)});
}

constexpr int kRounds = 5;
constexpr int kStations = 4;

}  // namespace

class TestAtOnce : public QObject
{
    Q_OBJECT

private slots:
    /// Two teachers look at the same list of assignments and change it one after the other.
    void whatAnotherHasGivenIsNotOverwritten_data() { support::addEngines(); }
    void whatAnotherHasGivenIsNotOverwritten()
    {
        COPY_OF(support::populatedSchool, rig);
        const DatabaseContext& school = rig.school();
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
        VERIFY_DONE(unassign(school, rig.instructor, seen));  // already removed
        QVERIFY(given().empty());
        VERIFY_DONE(assign(school, rig.instructor, mine));
        QCOMPARE(given(), std::vector{mine});
    }

    void oneAdminAtLeastStays_data() { support::addEngines(); }
    void oneAdminAtLeastStays()
    {
        COPY_OF(support::populatedSchool, rig);
        const Entered entered = addPerson(rig.school(), rig.admin, {"second", "Bo", "Two", Role::Admin}).value();
        const Login second = Logins::redeem(rig.school(), "second", entered.code, SchoolRig::kPassword).value();
        for (int round = 0; round < kRounds; ++round) {
            const auto disable = [&](const Login& me, const char* whom) {
                return [&me, whom](const DatabaseContext& school) {
                    auto person = findPerson(school, me, whom);
                    if (!person)
                        return;  // the other admin has already disabled this one
                    person->disabled = true;
                    static_cast<void>(changePerson(school, me, *person));
                };
            };
            atOnce(rig.address(), {disable(rig.admin, "second"), disable(second, "admin")});
            QCOMPARE(rig.count("people WHERE role = 'admin' AND disabled = 0"), 1);
            // The remaining admin enables the other one again.
            using Admin = std::pair<const Login*, const char*>;
            for (const auto& [me, whom] : {Admin(&rig.admin, "second"), Admin(&second, "admin")})
                if (auto person = findPerson(rig.school(), *me, whom); person && person->disabled) {
                    person->disabled = false;
                    VERIFY_DONE(changePerson(rig.school(), *me, *person));
                }
        }
    }

    void standingsKnowBothScores_data() { support::addEngines(); }
    void standingsKnowBothScores()
    {
        COPY_OF(support::populatedSchool, rig);
        for (int round = 0; round < kRounds; ++round) {
            const std::string lesson = "lesson-" + std::to_string(round);
            const AttemptId first = rig.add(rig.student, lesson, 500).value();
            const AttemptId second = rig.add(rig.student, lesson, 600).value();
            const auto mark = [&](AttemptId id, int tenths) {
                return [&, id, tenths](const DatabaseContext& school) {
                    VERIFY_DONE(overrideScore(school, rig.instructor, id, tenths, "as seen"));
                };
            };
            const auto deliver = [&](const DatabaseContext& school) {
                VERIFY_DONE(addAttempt(school, rig.student, SchoolRig::attempt(lesson, 700), {}));
            };
            atOnce(rig.address(), {mark(first, 990), mark(second, 100)});
            atOnce(rig.address(), {mark(first, 990), deliver});
            atOnce(rig.address(), {mark(second, 600 + round), mark(second, 800 + round)});
        }
        QCOMPARE(support::faultsOf(rig.school().db), QString());
        const auto standings = standingsOf(rig.school(), rig.student, rig.student.person()).value();
        QCOMPARE(standings.size(), static_cast<std::size_t>(kRounds));
        for (const LessonStanding& standing : standings)
            QCOMPARE(standing.bestTenths, 990);
    }

    void guessesAtOnceAreNoMoreThanOneAfterTheOther_data() { support::addEngines(); }
    void guessesAtOnceAreNoMoreThanOneAfterTheOther()
    {
        COPY_OF(support::populatedSchool, rig);
        makePasswordDear(rig, "s1001");
        for (const char* name : {"s1001", "nobody"}) {
            for (int k = 0; k < Logins::kFreeFailures; ++k)
                static_cast<void>(rig.logIn(name, "wrong horse"));
            for (int wait = 1; wait <= 2; wait *= 2) {
                rig.nowUtc = rig.nowUtc.addSecs(wait);
                std::atomic<int> compared = 0;
                std::atomic<int> refused = 0;
                atOnce(rig.address(), std::vector<Work>(kStations, [&](DatabaseContext school) {
                           school.nowUtc = [&rig] { return rig.nowUtc; };
                           school.key = rig.school().key;  // several windows of one computer
                           const auto session = Logins::login(school, name, "wrong horse");
                           if (!session)
                               ++(session.error().code == ErrorCode::TooSoon ? refused : compared);
                       }));
                QCOMPARE(compared, 1);
                QCOMPARE(refused, kStations - 1);
            }
        }
    }

    void whoKnowsHisPasswordIsLetInAtManyPlaces_data() { support::addEngines(); }
    void whoKnowsHisPasswordIsLetInAtManyPlaces()
    {
        COPY_OF(support::populatedSchool, rig);
        makePasswordDear(rig, "s1001");
        std::atomic<int> in = 0;
        atOnce(rig.address(), std::vector<Work>(kStations, [&in](const DatabaseContext& school) {
                   VERIFY_DONE(Logins::login(school, "s1001", SchoolRig::kPassword));
                   ++in;
               }));
        QCOMPARE(in, kStations);
        QCOMPARE(rig.count("failed_logins"), 0);
    }

    /// Hashing a password takes time, but does not block the other stations meanwhile.
    void whoChoosesAPasswordHoldsNobodyUp_data() { support::addEngines(); }
    void whoChoosesAPasswordHoldsNobodyUp()
    {
        COPY_OF(support::populatedSchool, rig);
        VERIFY_DONE(raisePasswordCost(rig.school(), rig.admin, {6, std::size_t{64} << 20U}));
        const std::string code = resetPassword(rig.school(), rig.admin, rig.classmate.person()).value().code;
        QSemaphore done;
        std::thread other([&] {
            const Station station(rig.address(), std::chrono::milliseconds(100));
            const DatabaseContext school = station.school();
            do
                VERIFY_DONE(Logins::logout(school, rig.student));
            while (!done.tryAcquire(1, 10));  // ms: SQLite has no queue; this lets the other station in
        });
        const auto redeemed = Logins::redeem(rig.school(), "s1002", code, "another horse");
        const auto changed = redeemed
                                 ? Logins::changePassword(rig.school(), *redeemed, "another horse", "a third horse")
                                 : core::Status(tl::unexpected(redeemed.error()));
        done.release();
        other.join();
        VERIFY_DONE(redeemed);
        VERIFY_DONE(changed);
    }

    /// A lesson id that is too long for the server is an error at once. It does not keep later attempts waiting.
    void whatIsTooLongForTheServerIsAValueThatIsNotAllowed()
    {
        NEEDS_SERVER();
        SchoolRig rig(support::populatedSchool(true));
        std::string lesson;  // random letters, which the server cannot compress
        for (unsigned k = 0, next = 1; k < 20000; ++k, next = next * 1664525U + 1013904223U)
            lesson += static_cast<char>('a' + (next >> 16U) % 26U);
        VERIFY_REFUSED(rig.add(rig.student, lesson, 500), ErrorCode::OutOfRange);
    }

    void aClassListIsTriedWhileOthersWrite_data() { support::addEngines(); }
    void aClassListIsTriedWhileOthersWrite()
    {
        COPY_OF(support::populatedSchool, rig);
        const std::string list = "username,given_name,class\nnew1,Ada,A|B\nnew2,Bo,B\ns1001,,A\n";
        const Station other(rig.address());
        const DatabaseContext writer = other.school();
        VERIFY_DONE(execute(writer.db, dialect::beginWrite(writer.db), "begin"));
        VERIFY_DONE(takeTurn(writer));
        const auto tried = importRoster(rig.school(), rig.admin, list, true);
        VERIFY_DONE(tried);
        QCOMPARE(tried->people.size(), std::size_t{3});
        QCOMPARE(tried->newClasses, (std::vector<std::string>{"A", "B"}));
        VERIFY_DONE(execute(writer.db, "ROLLBACK", "end it"));
        // Since the trial, another user has added one of them under another name.
        VERIFY_DONE(addPerson(rig.school(), rig.admin, {"new1", "Otto", "Other", Role::Student}));
        VERIFY_REFUSED(importRoster(rig.school(), rig.admin, list, false, &*tried), ErrorCode::ChangedSince);
        QCOMPARE(findPerson(rig.school(), rig.admin, "new1")->givenName, std::string("Otto"));
        VERIFY_REFUSED(findPerson(rig.school(), rig.admin, "new2"), ErrorCode::UnknownName);
        const auto triedNow = importRoster(rig.school(), rig.admin, list, true);
        VERIFY_DONE(triedNow);
        const auto entered = importRoster(rig.school(), rig.admin, list, false, &*triedNow);
        VERIFY_DONE(entered);
        QCOMPARE(entered->newClasses, tried->newClasses);
        // Importing the same list again changes nothing, and the audit stays valid.
        const AuditHead head = auditHead(rig.school()).value();
        VERIFY_DONE(importRoster(rig.school(), rig.admin, list, false));
        QVERIFY(auditHead(rig.school()).value() == head);
        QCOMPARE(support::faultsOf(rig.school().db), QString());
    }
};

CUSP_TEST(TestAtOnce)
#include "tst_at_once.moc"
