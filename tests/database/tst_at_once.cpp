// SPDX-License-Identifier: GPL-3.0-or-later
// Two stations do at the same moment what must not be done twice, or what each decides by what the other changes.
#include <thread>

#include <QTest>

#include "database/sql/Check.h"
#include "tests/database/SchoolRig.h"

using namespace database;
using namespace database::sql;
using support::addAttempt;
using support::SchoolRig;

namespace {

/// Another station at the rig's database. Made and used in one thread.
class Station
{
public:
    explicit Station(const QString& address) : m_database(Database::open(address).value()) {}
    [[nodiscard]] School school() const { return {m_database->handle(), m_key}; }

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

constexpr int kRounds = 15;

}  // namespace

class TestAtOnce : public QObject
{
    Q_OBJECT

private slots:
    void oneAdminAtLeastStays_data() { support::addEngines(); }
    void oneAdminAtLeastStays();
    void standingsKnowBothScores_data() { support::addEngines(); }
    void standingsKnowBothScores();
    void whatWasGivenLastCounts_data() { support::addEngines(); }
    void whatWasGivenLastCounts();
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
    QVERIFY2(report->findings.empty(), report->findings.empty() ? "" : report->findings.front().c_str());
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
    QVERIFY2(report->findings.empty(), report->findings.empty() ? "" : report->findings.front().c_str());
}

QTEST_GUILESS_MAIN(TestAtOnce)
#include "tst_at_once.moc"
