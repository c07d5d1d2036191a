// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <tuple>
#include <utility>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <sys/stat.h>

#include "database/Codes.h"
#include "database/Outbox.h"
#include "database/sql/Dialect.h"
#include "database/sql/Feedback.h"
#include "database/sql/Overview.h"
#include "database/sql/Recordings.h"
#include "database/sql/StartedExams.h"
#include "lessons/NeedsHelp.h"
#include "tests/database/SchoolRig.h"
#include "tests/fuzz/Exercises.h"
#include "tests/support/Files.h"
#include "tests/support/FullDisk.h"
#include "tests/support/Suite.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::addAttempt;
using support::SchoolRig;

namespace {

/// Adds four students to the rig's class "first". Returns all six students of the class.
std::vector<Login> sixStudents(SchoolRig& rig)
{
    std::vector<Login> six{rig.student, rig.classmate};
    for (const char* name : {"Three", "Four", "Five", "Six"})
        six.push_back(rig.join({std::string("s-") + name, "Sid", name, Role::Student}, rig.first));
    return six;
}

std::vector<AttemptRecord> ownHistory(const SchoolRig& rig, const HistoryQuery& filter = {})
{
    return history(rig.school(), rig.student, rig.student.person(), filter).value();
}

std::vector<LessonStanding> ownStandings(const SchoolRig& rig)
{
    return standingsOf(rig.school(), rig.student, rig.student.person()).value();
}

/// Returns the path of the only recording.
QString recordingOf(const SchoolRig& rig)
{
    const QString folder = QFileInfo(rig.address()).absolutePath() + "/recordings";
    return QDirIterator(folder, QDir::Files, QDirIterator::Subdirectories).next();
}

std::string dayOf(std::size_t turn)
{
    return "2026-11-0" + std::to_string(turn + 1) + "T10:15:00Z";
}

}  // namespace

class TestAttempts : public QObject
{
    Q_OBJECT

private slots:
    void everyFieldComesBack_data() { support::addEngines(); }
    void everyFieldComesBack()
    {
        COPY_OF(support::populatedSchool, rig);
        AttemptRecord attempt = SchoolRig::attempt("class1-36", 823);
        const QByteArray recording = QByteArray("a recording\0with a zero in it", 29).repeated(1000);
        const auto id = rig.add(rig.student, attempt, recording);
        VERIFY_DONE(id);
        rig.reopen();
        const auto kept = openAttempt(rig.school(), rig.student, *id);
        VERIFY_DONE(kept);
        attempt.id = id->value;
        attempt.person = rig.student.person();
        attempt.personUid = rig.student.uid();
        attempt.recordingHash = digestOf({recording.constData(), static_cast<std::size_t>(recording.size())});
        QVERIFY(*kept == attempt);
        QCOMPARE(openRecording(rig.school(), rig.student, *id).value(), recording);
        // An attempt without a prediction and without a recording.
        AttemptRecord bare = SchoolRig::attempt("", 100);
        bare.expectedTenths.reset();
        bare.criteria.clear();
        const AttemptId other = rig.add(rig.student, bare).value();
        QVERIFY(!openAttempt(rig.school(), rig.student, other)->expectedTenths.has_value());
        QVERIFY(openAttempt(rig.school(), rig.student, other)->criteria.empty());
        VERIFY_REFUSED(openRecording(rig.school(), rig.student, other), ErrorCode::FileMissing);
        VERIFY_REFUSED(openAttempt(rig.school(), rig.student, {999}), ErrorCode::UnknownName);
    }

    void theSameAttemptIsKeptOnce_data() { support::addEngines(); }
    void theSameAttemptIsKeptOnce()
    {
        COPY_OF(support::populatedSchool, rig);
        AttemptRecord attempt = SchoolRig::attempt("class1-36", 823);
        const AttemptId id = rig.add(rig.student, attempt).value();
        attempt.personUid = rig.student.uid();
        for (int k = 0; k < 3; ++k)
            QCOMPARE(deliverAttempt(rig.school(), attempt, {}).value(), id);
        QCOMPARE(ownHistory(rig).size(), std::size_t{1});
        QCOMPARE(ownStandings(rig).front().attempts, 1);
        // Another user cannot submit the same attempt, and an attempt without a uid or with an unknown person is
        // refused.
        VERIFY_REFUSED(rig.add(rig.classmate, attempt), ErrorCode::OutOfRange);
        attempt.uid.clear();
        VERIFY_REFUSED(rig.add(rig.student, attempt), ErrorCode::BadStructure);
        attempt.uid = newUid();
        attempt.personUid = newUid();
        VERIFY_REFUSED(deliverAttempt(rig.school(), attempt, {}), ErrorCode::UnknownName);
    }

    void historyIsNewestFirstAndOfOnePerson_data() { support::addEngines(); }
    void historyIsNewestFirstAndOfOnePerson()
    {
        COPY_OF(support::populatedSchool, rig);
        for (const std::size_t day : {std::size_t{0}, std::size_t{2}, std::size_t{1}}) {
            VERIFY_DONE(rig.add(rig.student, "class1-36", 800, dayOf(day)));
            VERIFY_DONE(rig.add(rig.classmate, "class1-36", 500, dayOf(day)));
        }
        VERIFY_DONE(rig.add(rig.student, "decay-21", 700, dayOf(0)));
        const auto times36 = [&](int limit) {
            std::vector<std::string> found;
            for (const AttemptRecord& record : ownHistory(rig, {"class1-36", "", limit}))
                found.push_back(record.finishedUtc);
            return found;
        };
        QCOMPARE(times36(0), (std::vector{dayOf(2), dayOf(1), dayOf(0)}));
        QCOMPARE(times36(2), (std::vector{dayOf(2), dayOf(1)}));
        QCOMPARE(ownHistory(rig).size(), std::size_t{4});
        // A lesson on tooth 36 does not count as free practice on that tooth.
        QCOMPARE(ownHistory(rig, {"", "36", 0}).size(), std::size_t{0});
        VERIFY_DONE(rig.add(rig.student, "", 700));
        QCOMPARE(ownHistory(rig, {"", "36", 0}).size(), std::size_t{1});
        QCOMPARE(ownHistory(rig, {"", "11", 0}).size(), std::size_t{0});
    }

    void standingsFollowTheAttempts_data() { support::addEngines(); }
    void standingsFollowTheAttempts()
    {
        COPY_OF(support::populatedSchool, rig);
        for (const auto& [tenths, day] : {std::pair(500, 0), std::pair(823, 2), std::pair(760, 1)})
            VERIFY_DONE(rig.add(rig.student, "class1-36", tenths, dayOf(static_cast<std::size_t>(day))));
        QVERIFY((ownStandings(rig) == std::vector{LessonStanding{"class1-36", 3, 823, true, dayOf(2)}}));
    }

    void anOverrideCountsAndTheMachinesScoreStays_data() { support::addEngines(); }
    void anOverrideCountsAndTheMachinesScoreStays()
    {
        COPY_OF(support::populatedSchool, rig);
        VERIFY_DONE(rig.add(rig.student, "class1-36", 500));
        const AttemptId id = rig.add(rig.student, "class1-36", 600).value();
        VERIFY_REFUSED(overrideScore(rig.school(), rig.instructor, id, 760, "  "), ErrorCode::OutOfRange);
        VERIFY_REFUSED(overrideScore(rig.school(), rig.instructor, id, 1001, "far too much"), ErrorCode::OutOfRange);
        VERIFY_DONE(overrideScore(rig.school(), rig.instructor, id, 760, "The isthmus is sound; the scan misled."));
        AttemptRecord given = openAttempt(rig.school(), rig.student, id).value();
        QCOMPARE(given.scoreTenths, 600);
        QCOMPARE(given.countingTenths(), 760);
        QVERIFY(given.countsAsPassed() && !given.passed);
        LessonStanding standing = ownStandings(rig).front();
        QCOMPARE(standing.bestTenths, 760);
        QVERIFY(standing.passed);
        // An override can be withdrawn; the list of overrides keeps its reason.
        VERIFY_DONE(overrideScore(rig.school(), rig.instructor, id, {}, "I was wrong."));
        given = openAttempt(rig.school(), rig.student, id).value();
        QCOMPARE(given.countingTenths(), 600);
        standing = ownStandings(rig).front();
        QCOMPARE(standing.bestTenths, 600);
        QVERIFY(!standing.passed);
        QCOMPARE(rig.count("overrides"), 2);
        for (const char* change : {"UPDATE overrides SET reason = 'x'", "DELETE FROM overrides"})
            QVERIFY(!execute(rig.school().db, QLatin1String(change), "change them"));
    }

    void valuesAreBoundNotPasted_data() { support::addEngines(); }
    void valuesAreBoundNotPasted()
    {
        COPY_OF(support::populatedSchool, rig);
        const char* nasty = "36'); DROP TABLE attempts; --";
        AttemptRecord attempt = SchoolRig::attempt(nasty, 500);
        attempt.tooth = nasty;
        attempt.device = "Gerät \"ü\" \\ 歯";
        const AttemptId id = rig.add(rig.student, attempt).value();
        QCOMPARE(openAttempt(rig.school(), rig.student, id)->tooth, attempt.tooth);
        QCOMPARE(openAttempt(rig.school(), rig.student, id)->device, attempt.device);
        QVERIFY(ownHistory(rig, {"' OR 1 = 1 --", "", 0}).empty());
        VERIFY_DONE(addComment(rig.school(), rig.instructor, id, {nasty, {{1.0, -2.5, 0.125}}, 61'500}));
    }

    void refusesWhatTheSchemaForbids_data() { support::addEngines(); }
    void refusesWhatTheSchemaForbids()
    {
        COPY_OF(support::populatedSchool, rig);
        for (void (*const spoil)(AttemptRecord&) :
             {+[](AttemptRecord& a) { a.scoreTenths = 1001; }, +[](AttemptRecord& a) { a.scoreTenths = -1; },
              +[](AttemptRecord& a) { a.durationMs = -1; },
              +[](AttemptRecord& a) { a.finishedUtc = "2026-11-20 10:15:00"; },
              +[](AttemptRecord& a) { a.tooth.clear(); }, +[](AttemptRecord& a) { a.stateHash = "abc"; }}) {
            AttemptRecord attempt = SchoolRig::attempt("class1-36", 500);
            spoil(attempt);
            VERIFY_REFUSED(rig.add(rig.student, attempt), ErrorCode::OutOfRange, "a value is not allowed");
            QVERIFY(ownHistory(rig).empty() && ownStandings(rig).empty());
        }
        VERIFY_DONE(rig.add(rig.student, "class1-36", 500));
    }

    void aRecordingThatWasChangedIsNotPlayed_data() { support::addEngines(); }
    void aRecordingThatWasChangedIsNotPlayed()
    {
        COPY_OF(support::populatedSchool, rig);
        const AttemptId id = rig.add(rig.student, SchoolRig::attempt("class1-36", 500), QByteArray(5000, 'r')).value();
        if (onServer) {
            rig.run({"UPDATE recordings SET content = 'abc'"});
        } else {
            QFile file(recordingOf(rig));
            QVERIFY(file.open(QIODevice::ReadWrite) && file.write("x") == 1);
        }
        VERIFY_REFUSED(openRecording(rig.school(), rig.student, id), ErrorCode::BadStructure);
    }

    void whatIsKeptOfPeopleIsForTheOwnerOfTheFilesOnly()
    {
        SchoolRig rig(support::populatedSchool(false));
        const QDir folder(QFileInfo(rig.address()).absolutePath());
        VERIFY_DONE(rig.add(rig.student, SchoolRig::attempt("class1-36", 500), "a recording"));
        Outbox outbox(folder.filePath("outbox"), StationKey::make());
        VERIFY_DONE(outbox.put(rig.student, SchoolRig::attempt("class1-36", 500), {}));
        VERIFY_DONE(outbox.put(rig.student, SchoolRig::attempt("class1-36", 600), {}));
        outbox.keepArrived(outbox.waiting().constFirst());
        constexpr QFile::Permissions kOthers = QFile::ReadGroup | QFile::WriteGroup | QFile::ExeGroup |
                                               QFile::ReadOther | QFile::WriteOther | QFile::ExeOther;
        int seen = 0;
        for (const char* name : {"outbox", "recordings"}) {
            QVERIFY(!(QFile::permissions(folder.filePath(name)) & kOthers));
            QDirIterator all(folder.filePath(name), QDir::AllEntries | QDir::NoDotAndDotDot,
                             QDirIterator::Subdirectories);
            for (; all.hasNext(); ++seen)
                QVERIFY2(!(QFile::permissions(all.next()) & kOthers), qPrintable(all.filePath()));
        }
        QCOMPARE(seen, 5);  // two pending attempts, the folder "arrived", a recording and its folder
    }

    void classmatesAreComparedWithoutNames_data() { support::addEngines(); }
    void classmatesAreComparedWithoutNames()
    {
        COPY_OF(support::populatedSchool, rig);
        const std::string rubric(64, 'b');
        for (const auto& [who, tenths] :
             {std::pair(rig.student, 500), std::pair(rig.student, 700), std::pair(rig.classmate, 900),
              std::pair(rig.stranger, 100), std::pair(rig.instructor, 1000)})
            VERIFY_DONE(rig.add(who, "class1-36", tenths));
        AttemptRecord other = SchoolRig::attempt("class1-36", 1000);
        other.rubricHash = std::string(64, 'z');
        VERIFY_DONE(rig.add(rig.classmate, other));
        const auto standing = [&](const Login& who, const char* device = "mouse") {
            return standingAmongClassmates(rig.school(), who, "class1-36", rubric, device, 800).value();
        };
        // In a class of fewer than five, no student sees how the others did. A teacher who practises in the class does
        // not count as a student.
        for (const auto& [who, people] :
             {std::pair(rig.student, 2), std::pair(rig.stranger, 1), std::pair(rig.instructor, 3)}) {
            QCOMPARE(standing(who).people, people);
            QVERIFY(!standing(who).percentBelow);
        }
        for (const auto& [name, tenths] : {std::pair("s1003", 600), std::pair("s1004", 750), std::pair("s1005", 950)})
            VERIFY_DONE(rig.add(rig.join({name, "", "", Role::Student}, rig.first),
                                SchoolRig::attempt("class1-36", tenths), {}));
        QCOMPARE(standing(rig.student).people, 5);
        QCOMPARE(standing(rig.student).percentBelow.value(), 60.0);
        // A better score with another input device belongs to another ranking.
        AttemptRecord withPen = SchoolRig::attempt("class1-36", 990);
        withPen.device = "pen";
        VERIFY_DONE(rig.add(rig.student, withPen));
        QCOMPARE(standing(rig.student).percentBelow.value(), 60.0);
        QCOMPARE(standing(rig.student, "pointer").people, 5);
        QCOMPARE(standing(rig.student, "pen").people, 1);
        // A student whose account is disabled or who has left the class does not count as a classmate.
        const Person left = findPerson(rig.school(), rig.admin, "s1003").value();
        Person disabled = left;
        disabled.disabled = true;
        VERIFY_DONE(changePerson(rig.school(), rig.admin, disabled));
        QCOMPARE(standing(rig.student).people, 4);
        VERIFY_DONE(changePerson(rig.school(), rig.admin, left));
        QCOMPARE(standing(rig.student).people, 5);
        VERIFY_DONE(enrol(rig.school(), rig.admin, rig.first, left.id, false));
        QCOMPARE(standing(rig.student).people, 4);
    }

    /// Quartiles are of R's type 7: linear interpolation between two neighbouring values.
    void aClassesNumbersAreThoseWorkedOutByHand_data() { support::addEngines(); }
    void aClassesNumbersAreThoseWorkedOutByHand()
    {
        COPY_OF(support::populatedSchool, rig);
        const std::string lesson = "class1-36";
        const std::vector<Login> six = sixStudents(rig);
        // The graded scores: a row for each student, in the order of their attempts.
        const std::vector<std::vector<int>> given{{400, 500, 800}, {300, 540, 450}, {610, 520, 740, 770},
                                                  {700, 700},      {900, 810},      {760}};
        std::map<std::pair<std::size_t, std::size_t>, AttemptId> kept;
        int minutes = 0;
        const auto work = [&](const Login& who, std::size_t turn, int tenths) {
            AttemptRecord attempt = SchoolRig::attempt(lesson, tenths, dayOf(turn));
            attempt.durationMs = ++minutes * 60'000;
            attempt.criteria = {{"depth", 30, 300}, {"outline", 100, 200}, {"pulp", 0, 0}};
            if (who == six[0] && turn == 0)
                attempt.criteria = {{"depth", 600, 600}, {"outline", 0, 200}, {"pulp", 0, 0}};
            return rig.add(who, attempt);
        };
        // The last attempts arrive first. Their order is by the time when they were made, not when they arrived.
        for (std::size_t turn = 4; turn-- > 0;)
            for (std::size_t who = 0; who < six.size(); ++who)
                if (turn < given[who].size()) {
                    const auto id = work(six[who], turn, given[who][turn]);
                    VERIFY_DONE(id);
                    kept[{who, turn}] = *id;
                }
        QCOMPARE(minutes, 15);
        // An instructor's score replaces the graded one: one more student passes, another no longer does.
        VERIFY_DONE(overrideScore(rig.school(), rig.instructor, kept[{1, 1}], 640, "It is better than that."));
        VERIFY_DONE(overrideScore(rig.school(), rig.instructor, kept[{3, 0}], 755, "It is better than that."));
        VERIFY_DONE(overrideScore(rig.school(), rig.instructor, kept[{5, 0}], 205, "It is worse than that."));
        // Attempts by teachers, by students of another class, and at another lesson do not count.
        VERIFY_DONE(rig.add(rig.instructor, lesson, 1000));
        VERIFY_DONE(rig.add(rig.stranger, lesson, 1000));
        VERIFY_DONE(rig.add(rig.student, "decay-21", 1000));

        // First attempts 205 300 400 610 755 900: the quartiles are 300 + 0.25 * 100, 400 + 0.5 * 210 and 610 + 0.75 *
        // 145. Second attempts 500 520 640 700 810: the quartiles are values of the list. There are only three third
        // attempts, which is too few.
        const std::vector<BandPoint> curve{{1, 6, 325, 505, 719}, {2, 5, 520, 640, 700}};
        QVERIFY(classBand(rig.school(), rig.student, rig.student.person(), lesson).value() == curve);
        const LessonResults results = lessonResults(rig.school(), rig.instructor, rig.first, lesson).value();
        QVERIFY(results.curve == curve);
        QCOMPARE(results.bestTenths, (std::vector<int>{205, 640, 755, 770, 800, 900}));
        // Four students passed: one in the third attempt, one in the fourth, two in the first.
        QCOMPARE(results.difficulty.lessonId, lesson);
        QCOMPARE(results.difficulty.people, 6);
        QCOMPARE(results.difficulty.passed, 4);
        QCOMPARE(results.difficulty.meanTenths, 3170.0 / 6.0);
        QCOMPARE(results.difficulty.attemptsToPass, 9.0 / 4.0);
        // Of fifteen attempts, 14 earned 100 of 200 points and one earned 0; 14 earned 30 of 300 and one earned all.
        QCOMPARE(results.difficulty.items.size(), std::size_t{2});
        QCOMPARE(results.difficulty.items[0].criterion, std::string("outline"));
        QCOMPARE(results.difficulty.items[0].share, 7.0 / 15.0);
        QCOMPARE(results.difficulty.items[1].criterion, std::string("depth"));
        QCOMPARE(results.difficulty.items[1].share, 2.4 / 15.0);
        // 205 300 400 450 500 520 610 640 700 740 755 770 800 810 900: the median is the eighth value, and the median
        // of 1 to 15 minutes is eight.
        const auto medians = [&] {
            return classMedians(rig.school(), rig.student, rig.student.person(), lesson).value();
        };
        QVERIFY((medians() == LessonMedians{6, 640, 480'000}));
        // With one more attempt of 660 in 16 minutes, the median is halfway between the eighth and the ninth value.
        VERIFY_DONE(work(six[5], 1, 660));
        QVERIFY((medians() == LessonMedians{6, 650, 510'000}));
        // Second attempts now: 500 520 640 660 700 810.
        QVERIFY((classBand(rig.school(), rig.student, rig.student.person(), lesson)->at(1) ==
                 BandPoint{2, 6, 550, 650, 690}));
    }

    /// Attempts with a mouse are compared with attempts with a mouse. An attempt from before mouse and pen were told
    /// apart counts as one with a mouse.
    void anotherDeviceIsNotCompared_data() { support::addEngines(); }
    void anotherDeviceIsNotCompared()
    {
        COPY_OF(support::populatedSchool, rig);
        const std::vector<Login> people = sixStudents(rig);
        const auto add = [&](const Login& who, int tenths, const char* device) {
            AttemptRecord attempt = SchoolRig::attempt("class1-36", tenths);
            attempt.device = device;
            return rig.add(who, attempt);
        };
        for (const Login& who : people) {
            VERIFY_DONE(add(who, 700, "pointer"));
            VERIFY_DONE(add(who, 500, "falcon"));
        }
        const auto median = [&] {
            return classMedians(rig.school(), rig.student, rig.student.person(), "class1-36").value()->tenths;
        };
        QCOMPARE(median(), 500);
        VERIFY_DONE(add(rig.student, 700, "mouse"));
        QCOMPARE(median(), 700);
        VERIFY_DONE(add(rig.student, 900, "pen"));
        QVERIFY(!classMedians(rig.school(), rig.student, rig.student.person(), "class1-36")->has_value());
    }

    /// With fewer than five students, a band would show who has which score.
    void ofFourPeopleNoBandIsShown_data() { support::addEngines(); }
    void ofFourPeopleNoBandIsShown()
    {
        COPY_OF(support::populatedSchool, rig);
        std::vector<Login> people = sixStudents(rig);
        people.resize(5);
        for (const Login& who : people) {
            QVERIFY(classBand(rig.school(), rig.student, rig.student.person(), "class1-36")->empty());
            QVERIFY(!classMedians(rig.school(), rig.student, rig.student.person(), "class1-36")->has_value());
            QVERIFY(lessonResults(rig.school(), rig.instructor, rig.first, "class1-36")->curve.empty());
            VERIFY_DONE(rig.add(who, "class1-36", 700));
        }
        const std::vector<BandPoint> alike{{1, 5, 700, 700, 700}};
        QVERIFY(classBand(rig.school(), rig.student, rig.student.person(), "class1-36").value() == alike);
        QCOMPARE(classMedians(rig.school(), rig.student, rig.student.person(), "class1-36").value()->people, 5);
    }

    /// A student of two classes is compared with both, a teacher only with their own class. A class of too few students
    /// is left out even if the student's other class is large enough.
    void aBandIsOfTheClassesOfWhoAsks_data() { support::addEngines(); }
    void aBandIsOfTheClassesOfWhoAsks()
    {
        COPY_OF(support::populatedSchool, rig);
        const DatabaseContext& school = rig.school();
        const std::string lesson = "class1-36";
        const PersonId sam = rig.student.person();
        const auto people = [&](const Login& who) {
            const auto band = classBand(school, who, sam, lesson).value();
            const auto medians = classMedians(school, who, sam, lesson).value();
            if (band.empty() != !medians || (medians && medians->people != band.front().people))
                return -1;
            return band.empty() ? 0 : band.front().people;
        };
        // Sam and Sue are the first class. Sam is also in the second class, with six others.
        VERIFY_DONE(enrol(school, rig.admin, rig.second, sam, true));
        std::vector<Login> others;
        for (int k = 0; k < 6; ++k)
            others.push_back(
                rig.join({"s300" + std::to_string(k), "Nn", std::to_string(k), Role::Student}, rig.second));
        for (const Login* who : {&rig.student, &rig.classmate})
            VERIFY_DONE(rig.add(*who, lesson, 700));
        for (const Login& who : others)
            VERIFY_DONE(rig.add(who, lesson, 600));
        QCOMPARE(people(rig.instructor), 0);
        QCOMPARE(people(rig.otherInstructor), 7);
        QCOMPARE(people(rig.student), 7);  // without Sue, whose class has only two students
        // Sue's class counts when it has five students.
        for (int k = 0; k < 3; ++k)
            VERIFY_DONE(enrol(school, rig.admin, rig.first, others[static_cast<std::size_t>(k)].person(), true));
        QCOMPARE(people(rig.instructor), 5);
        QCOMPARE(people(rig.student), 8);
        QCOMPARE(people(rig.admin), 8);
        // A disabled student is in no class any more.
        rig.run({"UPDATE people SET disabled = 1 WHERE username = 's3000'"});
        QCOMPARE(people(rig.instructor), 0);
        QCOMPARE(people(rig.otherInstructor), 6);
    }

    /// A student needs help if the latest attempts at the lesson tried last say so. Overridden scores count.
    void whoIsStuckIsToldByTheLastAttempts_data() { support::addEngines(); }
    void whoIsStuckIsToldByTheLastAttempts()
    {
        COPY_OF(support::populatedSchool, rig);
        const auto needsHelp = [](const MatrixStudent& student) {
            std::vector<lessons::AttemptOutcome> tries;
            for (std::size_t k = 0; k < student.recentTenths.size(); ++k)
                tries.push_back({student.recentTenths[k], student.recentPassed[k]});
            return lessons::needsHelp(tries);
        };
        std::vector<AttemptId> sams;
        const auto work = [&](const Login& who, const char* lesson, int tenths, std::size_t day) {
            sams.push_back(rig.add(who, lesson, tenths, dayOf(day)).value());
        };
        // Sam passed once, then tried another lesson, then the first one five times more. Free practice is not a
        // lesson.
        for (const auto& [lesson, tenths, day] :
             {std::tuple("class1-36", 800, 0), std::tuple("decay-21", 700, 2), std::tuple("class1-36", 510, 1),
              std::tuple("class1-36", 520, 3), std::tuple("class1-36", 530, 4), std::tuple("class1-36", 760, 5),
              std::tuple("class1-36", 540, 6), std::tuple("class1-36", 545, 6), std::tuple("", 900, 7)})
            work(rig.student, lesson, tenths, static_cast<std::size_t>(day));
        // Sue has just begun another lesson.
        for (std::size_t day = 0; day < 3; ++day)
            work(rig.classmate, "class1-36", 400, day);
        work(rig.classmate, "decay-21", 100, 3);
        VERIFY_DONE(assign(rig.school(), rig.instructor, {0, rig.first, "x-assigned", "", 0}));
        const auto read = [&] { return classOverview(rig.school(), rig.instructor, rig.first).value(); };
        ClassOverview overview = read();
        QCOMPARE(overview.students.size(), std::size_t{2});
        QCOMPARE(overview.students[0].fullName, std::string("Sam One"));
        QCOMPARE(overview.students[0].recentLesson, std::string("class1-36"));
        QCOMPARE(overview.students[0].recentTenths, (std::vector<int>{545, 540, 760, 530, 520}));
        QCOMPARE(overview.students[0].recentPassed, (std::vector<bool>{false, false, true, false, false}));
        QCOMPARE(overview.students[0].lastAttemptUtc, dayOf(7));
        QCOMPARE(overview.students[1].recentLesson, std::string("decay-21"));
        QCOMPARE(overview.students[1].recentTenths, (std::vector<int>{100}));
        QVERIFY(!needsHelp(overview.students[0]) && !needsHelp(overview.students[1]));
        // Sam's passing score is overridden: none of the last three attempts is passed, and none is better by five
        // points.
        VERIFY_DONE(overrideScore(rig.school(), rig.instructor, sams[5], 535, "The floor was not seen."));
        // Sue returns to the first lesson.
        work(rig.classmate, "class1-36", 410, 4);
        overview = read();
        QCOMPARE(overview.students[0].recentTenths, (std::vector<int>{545, 540, 535, 530, 520}));
        QCOMPARE(overview.students[0].recentPassed, std::vector<bool>(5, false));
        QVERIFY(needsHelp(overview.students[0]));
        QCOMPARE(overview.students[1].recentTenths, (std::vector<int>{410, 400, 400, 400}));
        QVERIFY(needsHelp(overview.students[1]));
        // The rows are students, the columns lessons: first the assigned ones, then others that were tried.
        QCOMPARE(overview.lessons, (std::vector<std::string>{"x-assigned", "class1-36", "decay-21"}));
        QVERIFY(
            (overview.cells[0] == std::vector<MatrixCell>{{}, {7, 800, true, dayOf(6)}, {1, 700, false, dayOf(2)}}));
        QVERIFY(
            (overview.cells[1] == std::vector<MatrixCell>{{}, {4, 410, false, dayOf(4)}, {1, 100, false, dayOf(3)}}));
    }

    /// Opening a pipe would block for ever, and reading a device would never end.
    void whatIsNoPlainFileIsNotRead()
    {
        SchoolRig rig(support::populatedSchool(false));
        const QDir folder(QFileInfo(rig.address()).absolutePath());
        const QString pipe = folder.filePath("pipe");
        QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
        const QByteArray recording(5000, 'r');
        const auto attempt = SchoolRig::attempt("class1-36", 500);
        const AttemptId id = rig.add(rig.student, attempt, recording).value();
        const QString file = recordingOf(rig);
        QVERIFY(QFile::remove(file));
        QCOMPARE(mkfifo(qPrintable(file), 0600), 0);
        VERIFY_REFUSED(openRecording(rig.school(), rig.student, id), ErrorCode::BadStructure);
        QVERIFY(QFile::remove(file));
        QFile large(file);
        QVERIFY(large.open(QIODevice::WriteOnly) && large.resize(5LL << 30U));
        VERIFY_REFUSED(openRecording(rig.school(), rig.student, id), ErrorCode::BadStructure);
        QVERIFY(large.remove());
        // A symbolic link in place of the recording is replaced. The file that it points to is not written.
        QVERIFY(QFile::link(pipe, file));
        VERIFY_DONE(putRecording(rig.school(), recording));
        QVERIFY(QFileInfo(file).isFile() && !QFileInfo(file).isSymLink());
        QCOMPARE(openRecording(rig.school(), rig.student, id).value(), recording);

        Outbox outbox(folder.filePath("outbox"), StationKey::make());
        VERIFY_DONE(outbox.put(rig.student, attempt, {}));
        const QString letter = outbox.waiting().constFirst();
        const QString elsewhere = folder.filePath("elsewhere");
        QVERIFY(QFile::rename(letter, elsewhere));
        for (const QString& target : {pipe, elsewhere}) {
            QVERIFY(QFile::link(target, letter));
            VERIFY_REFUSED(outbox.read(letter), ErrorCode::BadStructure);
            outbox.setAside(letter);
            QVERIFY(outbox.waiting().isEmpty());
            QVERIFY(QFileInfo::exists(target));
        }
    }

    /// A database would refuse some of them for ever and change others, which its check then reports for ever.
    void aLetterThatNoDatabaseKeepsAsItIsIsSetAside()
    {
        SchoolRig rig(support::populatedSchool(false));
        QTemporaryDir folder;
        Outbox outbox(folder.path(), StationKey::make());
        const AttemptRecord attempt = SchoolRig::attempt("class1-36", 500);
        const auto isSetAside = [&](const core::Status& put, const auto& read) {
            if (!put || outbox.waiting().size() != 1)
                return false;
            const auto found = read(outbox.waiting().constFirst());
            outbox.setAside(outbox.waiting().constFirst());
            return !found && found.error().code == ErrorCode::BadStructure;
        };
        const auto isAttemptSetAside = [&](const AttemptRecord& one) {
            return isSetAside(outbox.put(rig.student, one, {}), [&](const QString& file) { return outbox.read(file); });
        };
        const auto isExamSetAside = [&](const std::string& lesson, const std::string& utc) {
            return isSetAside(outbox.put(rig.student, ExamStart{newUid(), lesson, utc}),
                              [&](const QString& file) { return outbox.readExam(file); });
        };
        QVERIFY(!isAttemptSetAside(attempt));
        for (std::string AttemptRecord::*field :
             {&AttemptRecord::tooth, &AttemptRecord::lessonId, &AttemptRecord::device}) {
            AttemptRecord wrong = attempt;
            wrong.*field = "caf\xE9";
            QVERIFY(isAttemptSetAside(wrong));
        }
        for (const char* utc : {"", "yesterday", "2026-13-01T10:15:00Z", "2026-02-30T10:15:00Z", "2026-11-20T25:15:00Z",
                                "2026-11-20T10:15:00", "2026-11-20 10:15:00Z", "20261120T101500Z"}) {
            AttemptRecord wrong = attempt;
            wrong.finishedUtc = utc;
            QVERIFY2(isAttemptSetAside(wrong), utc);
            QVERIFY2(isExamSetAside("exam", utc), utc);
        }
        QVERIFY(isExamSetAside("ex\xC3", "2026-11-20T10:15:00Z"));
        QVERIFY(!isExamSetAside("exam", "2026-11-20T10:15:00Z"));
    }

    /// With CUSP_REWRITE_CORPUS=1, writes the seeds of the fuzzer again.
    void corpusOfTheFuzzerIsHarmless()
    {
        if (support::rewritesSeeds()) {
            constexpr std::size_t kHead = 8 + 64 + 128;  // magic, key and signature
            SchoolRig rig(support::populatedSchool(false));
            QTemporaryDir folder;
            Outbox outbox(folder.path(), StationKey::make(), "school.sqlite");
            VERIFY_DONE(outbox.put(rig.student, SchoolRig::attempt("class1-36", 500), "recording"));
            VERIFY_DONE(outbox.put(rig.student, ExamStart{newUid(), "exam", "2026-11-20T10:15:00Z"}));
            for (const QString& file : outbox.waiting()) {
                const std::string bytes = support::bytesOf(file.toStdString());
                const std::string kind = Outbox::isExam(file) ? "exam" : "attempt";
                support::writeSeed("letter", kind, bytes);
                support::writeSeed("letter", kind + "-content", std::string_view(bytes).substr(kHead));
            }
        }
        QVERIFY(support::forEachSeed("letter", fuzz::exerciseLetter));
    }

    void aStationKeyIsAFileOfItsOwn()
    {
        QTemporaryDir folder;
        const QString key = folder.filePath("station.key");
        const QString pipe = folder.filePath("pipe");
        const QString others = folder.filePath("others.key");
        QCOMPARE(mkfifo(qPrintable(pipe), 0640), 0);
        VERIFY_DONE(StationKey::readOrMake(others));
        QVERIFY(QFile::setPermissions(others, QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup));
        for (const QString& target : {pipe, others, folder.filePath("nothing")}) {
            const QFile::Permissions before = QFile::permissions(target);
            QVERIFY(QFile::link(target, key));
            VERIFY_REFUSED(StationKey::readOrMake(key), ErrorCode::FileUnreadable);
            QVERIFY(QFile::permissions(target) == before);
            QVERIFY(QFile::remove(key));
        }
        QVERIFY(!QFileInfo::exists(folder.filePath("nothing")));
        QCOMPARE(mkfifo(qPrintable(key), 0600), 0);
        VERIFY_REFUSED(StationKey::readOrMake(key), ErrorCode::FileUnreadable);
    }

    /// Nothing is left of a file that did not fit on the disk, however small it is.
    void aFullDiskTakesNothing()
    {
        SchoolRig rig(support::populatedSchool(false));
        const QDir folder(QFileInfo(rig.address()).absolutePath());
        Outbox outbox(folder.filePath("outbox"), StationKey::make());
        const auto attempt = SchoolRig::attempt("class1-36", 500);
        {
            const support::FullDisk full(10);
            QVERIFY(!outbox.put(rig.student, attempt, {}));
            QVERIFY(!outbox.put(rig.student, ExamStart{newUid(), "exam", "2026-11-20T10:15:00Z"}));
            QVERIFY(!putRecording(rig.school(), "more than ten bytes"));
            QVERIFY(!StationKey::readOrMake(folder.filePath("another.key")));
            QVERIFY(!writeCodes(folder.filePath("codes.csv"), {}));
        }
        QVERIFY(outbox.waiting().isEmpty());
        QVERIFY(!QFileInfo::exists(folder.filePath("another.key")));
        QVERIFY(!QFileInfo::exists(folder.filePath("codes.csv")));
        VERIFY_DONE(outbox.put(rig.student, attempt, {}));
        QCOMPARE(outbox.waiting().size(), 1);
        VERIFY_DONE(StationKey::readOrMake(folder.filePath("another.key")));
    }

    /// A begun exam counts as an attempt, whether or not it ends with a score.
    void anExamThatIsBegunIsAnAttempt_data() { support::addEngines(); }
    void anExamThatIsBegunIsAnAttempt()
    {
        COPY_OF(support::populatedSchool, rig);
        const DatabaseContext& school = rig.school();
        const std::string exam = "exam-36";
        VERIFY_DONE(assign(school, rig.instructor, {0, rig.first, exam, "", 3}));
        const auto left = [&] { return attemptsLeft(school, rig.student, exam)->value(); };
        const auto begin = [&](const char* at) {
            const ExamStart start{newUid(), exam, at};
            return deliverExam(school, rig.student.uid(), start) ? start : ExamStart{};
        };
        const auto without = [&] { return examsWithoutScore(school, rig.instructor, rig.student.person()).value(); };
        QCOMPARE(left(), 3);
        // A running exam has no score yet. With its score it is still one attempt, not two.
        const ExamStart finished = begin("2026-11-20T10:00:00Z");
        QVERIFY(without() == std::vector{finished});
        QCOMPARE(left(), 2);
        VERIFY_DONE(deliverExam(school, rig.student.uid(), finished));
        QCOMPARE(left(), 2);
        VERIFY_DONE(rig.add(rig.student, exam, 700, "2026-11-20T10:10:00Z"));
        QVERIFY(without().empty());
        QCOMPARE(left(), 2);
        // The exam is abandoned and begun again.
        const ExamStart brokenOff = begin("2026-11-20T11:00:00Z");
        const ExamStart second = begin("2026-11-20T11:05:00Z");
        QVERIFY((without() == std::vector{second, brokenOff}));
        VERIFY_DONE(rig.add(rig.student, exam, 900, "2026-11-20T11:20:00Z"));
        QVERIFY(without() == std::vector{brokenOff});
        QCOMPARE(left(), 0);
        // The exam start does not affect another lesson or another student.
        VERIFY_DONE(rig.add(rig.student, "other", 900, "2026-11-20T11:01:00Z"));
        QVERIFY(without() == std::vector{brokenOff});
        QCOMPARE(attemptsLeft(school, rig.classmate, exam)->value(), 3);
        QVERIFY(examsWithoutScore(school, rig.student, rig.student.person()).value() == std::vector{brokenOff});
        VERIFY_REFUSED(examsWithoutScore(school, rig.classmate, rig.student.person()), ErrorCode::NotAllowed);
        VERIFY_REFUSED(deliverExam(school, newUid(), brokenOff), ErrorCode::UnknownName);
        // Two exams run at the same time in two windows. Each gets its own score, whichever ends first.
        VERIFY_DONE(assign(school, rig.instructor, {0, rig.first, "at-once", "", 3}));
        for (const char* at : {"2026-11-20T11:30:00Z", "2026-11-20T11:32:00Z"})
            VERIFY_DONE(deliverExam(school, rig.student.uid(), {newUid(), "at-once", at}));
        for (const char* at : {"2026-11-20T11:33:00Z", "2026-11-20T11:34:00Z"})
            VERIFY_DONE(rig.add(rig.student, "at-once", 900, at));
        QVERIFY(without() == std::vector{brokenOff});
        QCOMPARE(attemptsLeft(school, rig.student, "at-once")->value(), 1);
        // The attempts left in all lessons. A lesson without a limit is not listed.
        VERIFY_DONE(assign(school, rig.instructor, {0, rig.first, "unlimited", "", 0}));
        const std::map<std::string, int> allLeft{{exam, 0}, {"at-once", 1}};
        QVERIFY(attemptsLeft(school, rig.student).value() == allLeft);
        QVERIFY(attemptsLeft(school, rig.guest)->empty());
        // Two exams begun in the same second count as two.
        for (int k = 0; k < 2; ++k)
            VERIFY_DONE(deliverExam(school, rig.student.uid(), {newUid(), "twins", "2026-11-20T12:00:00Z"}));
        VERIFY_DONE(rig.add(rig.student, "twins", 900, "2026-11-20T12:10:00Z"));
        QCOMPARE(without().size(), std::size_t{2});
        // If an exam start is removed to regain an attempt, checkDatabase() reports it.
        QVERIFY(checkDatabase(school.db, {})->findings.empty());
        rig.run(onServer ? QStringList{"DROP TRIGGER exam_starts_no_change ON exam_starts"}
                         : QStringList{"DROP TRIGGER exam_starts_no_update", "DROP TRIGGER exam_starts_no_delete"});
        rig.run({"DELETE FROM exam_starts WHERE uid = '" + QString::fromStdString(brokenOff.uid) + "'",
                 "UPDATE exam_starts SET lesson_id = 'x' WHERE uid = '" + QString::fromStdString(second.uid) + "'",
                 "INSERT INTO exam_starts SELECT '00000000000000000000000000000000', person_id, lesson_id, begun_utc "
                 "FROM exam_starts WHERE lesson_id = 'x'"});
        const QString said = support::faultsOf(school.db);
        QCOMPARE(said.count('\n') + 1, onServer ? 4 : 5);  // one trigger dropped there, two here
        QVERIFY2(said.contains("is no longer there"), qPrintable(said));
        for (const std::string& uid : {brokenOff.uid, second.uid, std::string(32, '0')})
            QVERIFY2(
                said.contains("exam_starts differs from the audit: the row of exam:" + QString::fromStdString(uid)),
                qPrintable(said));
    }

    /// The limit is checked when an attempt begins. Without a connection, or at two stations at once, one attempt
    /// more is possible. It is saved, and the teacher sees it.
    void anAttemptBeyondTheLimitIsKept_data() { support::addEngines(); }
    void anAttemptBeyondTheLimitIsKept()
    {
        COPY_OF(support::populatedSchool, rig);
        const DatabaseContext& school = rig.school();
        const std::string lesson = "class1-36";
        VERIFY_DONE(assign(school, rig.instructor, {0, rig.first, lesson, "", 1}));
        const auto left = [&] { return attemptsLeft(school, rig.student, lesson).value(); };
        QCOMPARE(left().value(), 1);
        VERIFY_DONE(rig.add(rig.student, lesson, 600, dayOf(0)));
        QCOMPARE(left().value(), 0);
        const auto beyond = rig.add(rig.student, lesson, 900, dayOf(1), "a recording");
        VERIFY_DONE(beyond);
        QCOMPARE(left().value(), 0);
        // The student's history, the teacher's view of it and the class overview list the attempt like any other.
        for (const Login* reader : {&rig.student, &rig.instructor}) {
            const auto listed = history(school, *reader, rig.student.person(), {lesson, "", 0});
            VERIFY_DONE(listed);
            QCOMPARE(listed->size(), std::size_t{2});
            QCOMPARE(listed->front().id, beyond->value);
            QCOMPARE(openRecording(school, *reader, *beyond).value(), QByteArray("a recording"));
        }
        const ClassOverview overview = classOverview(school, rig.instructor, rig.first).value();
        QVERIFY((overview.cells.at(0).at(0) == MatrixCell{2, 900, true, dayOf(1)}));
        QCOMPARE(lessonResults(school, rig.instructor, rig.first, lesson)->bestTenths, (std::vector<int>{900}));
        QVERIFY(checkDatabase(school.db, {})->findings.empty());
    }

    void whatATeacherSaysIsNewUntilItIsRead_data() { support::addEngines(); }
    void whatATeacherSaysIsNewUntilItIsRead()
    {
        COPY_OF(support::populatedSchool, rig);
        const DatabaseContext& school = rig.school();
        const AttemptRecord first = SchoolRig::attempt("class1-36", 700);
        const AttemptId one = rig.add(rig.student, first).value();
        const AttemptId two = rig.add(rig.student, "decay-21", 600).value();
        const auto feedback = [&](const Login& who) { return feedbackFor(school, who, rig.student.person()).value(); };
        QVERIFY(feedback(rig.student).empty());
        // A student's own comments, and comments on attempts of others, are not feedback for the student.
        VERIFY_DONE(addComment(school, rig.instructor, one, {"too deep", {}, {}}));
        const AttemptId others = rig.add(rig.classmate, "class1-36", 100).value();
        VERIFY_DONE(addComment(school, rig.instructor, others, {"deeper", {}, {}}));
        const auto told = feedback(rig.student);
        QCOMPARE(told.size(), std::size_t{1});
        QVERIFY(told.front() == (Feedback{one, "class1-36", "Ines Teach", "2026-11-20T10:15:00Z", true}));
        rig.nowUtc = rig.nowUtc.addSecs(60);
        VERIFY_DONE(seeFeedback(school, rig.student, first));
        QVERIFY(!feedback(rig.student).front().isNew);
        // The newest feedback comes first, and a new score is feedback as well.
        rig.nowUtc = rig.nowUtc.addSecs(60);
        VERIFY_DONE(overrideScore(school, rig.instructor, two, 900, "neat"));
        QVERIFY(feedback(rig.student).front().attempt == two && feedback(rig.student).front().isNew);
        QVERIFY(feedback(rig.student).back().attempt == one && !feedback(rig.student).back().isNew);
        rig.nowUtc = rig.nowUtc.addSecs(60);
        VERIFY_DONE(addComment(school, rig.instructor, one, {"look at the floor", {}, {}}));
        QVERIFY(feedback(rig.student).front().attempt == one && feedback(rig.student).front().isNew);
        VERIFY_REFUSED(feedbackFor(school, rig.classmate, rig.student.person()), ErrorCode::NotAllowed);
        QVERIFY(checkDatabase(school.db, {})->findings.empty());
    }

    /// The author of a comment can withdraw it. Its text stays in the database, but is shown to nobody.
    void aCommentIsTakenBackByWhoWroteIt_data() { support::addEngines(); }
    void aCommentIsTakenBackByWhoWroteIt()
    {
        COPY_OF(support::populatedSchool, rig);
        const DatabaseContext& school = rig.school();
        VERIFY_DONE(enrol(school, rig.admin, rig.first, rig.otherInstructor.person(), true));
        const AttemptRecord attempt = SchoolRig::attempt("class1-36", 700);
        const AttemptId id = rig.add(rig.student, attempt).value();
        const std::int64_t first =
            addComment(school, rig.instructor, id, {"too deep", {{1.0, 2.0, -0.5}}, 4200}).value();
        const std::int64_t again =
            addComment(school, rig.instructor, id, {"too deep", {{1.0, 2.0, -0.5}}, 4200}).value();
        const auto said = [&](const Login& who) { return readTalk(school, who, id)->comments; };
        QVERIFY(said(rig.instructor).front().isMine);
        for (const Login* who : {&rig.student, &rig.otherInstructor, &rig.admin}) {
            QVERIFY(!said(*who).front().isMine);
            VERIFY_REFUSED(withdrawComment(school, *who, first), ErrorCode::NotAllowed);
        }
        VERIFY_REFUSED(withdrawComment(school, rig.instructor, 999), ErrorCode::UnknownName);
        QCOMPARE(said(rig.student).size(), std::size_t{2});

        // Of two comments with the same text, the selected one is withdrawn.
        VERIFY_DONE(withdrawComment(school, rig.instructor, again));
        VERIFY_REFUSED(withdrawComment(school, rig.instructor, again), ErrorCode::ChangedSince);
        for (const Login* who : {&rig.student, &rig.instructor, &rig.admin}) {
            QCOMPARE(said(*who).size(), std::size_t{1});
            QCOMPARE(said(*who).front().id, first);
        }
        QCOMPARE(feedbackFor(school, rig.student, rig.student.person())->size(), std::size_t{1});
        VERIFY_DONE(withdrawComment(school, rig.instructor, first));
        QVERIFY(said(rig.student).empty());
        QVERIFY(feedbackFor(school, rig.student, rig.student.person())->empty());
        QCOMPARE(rig.count("comments WHERE words = 'too deep' AND withdrawn_utc = '2026-11-20T10:15:00Z'"), 2);
        const AuditRow noted = readAudit(school, rig.admin, 1)->front();
        QCOMPARE(noted.action, std::string("attempt.comment.withdraw"));
        QCOMPARE(noted.actor, rig.instructor.uid());
        QCOMPARE(noted.object, "attempt:" + attempt.uid);
        QCOMPARE(support::faultsOf(school.db), QString());
    }

    /// An abandoned exam uses up an attempt as well. If a student is in several classes, the highest limit applies both
    /// to the student and in the teacher's view.
    void aTeacherSeesWhoHasNoAttemptsLeft_data() { support::addEngines(); }
    void aTeacherSeesWhoHasNoAttemptsLeft()
    {
        COPY_OF(support::populatedSchool, rig);
        const DatabaseContext& school = rig.school();
        const std::string exam = "exam-36";
        const auto isUsedUp = [&](int limit) {
            return classOverview(school, rig.instructor, rig.first)->cells.at(0).at(0).isUsedUp(limit);
        };
        const auto give = [&](const Login& teacher, ClassId ofClass, int limit) {
            std::optional<ClassAssignment> before;
            const std::vector<ClassAssignment> given = listAssignments(school, teacher).value();
            for (const ClassAssignment& one : given)
                if (one.classId == ofClass)
                    before = one;
            return assign(school, teacher, {0, ofClass, exam, "", limit}, before);
        };
        const auto left = [&] { return attemptsLeft(school, rig.student, exam).value(); };
        VERIFY_DONE(give(rig.instructor, rig.first, 1));
        QVERIFY(left() == 1 && !isUsedUp(1));
        VERIFY_DONE(deliverExam(school, rig.student.uid(), {newUid(), exam, "2026-11-20T10:00:00Z"}));
        QVERIFY(left() == 0 && isUsedUp(1));
        const MatrixCell cell = classOverview(school, rig.instructor, rig.first)->cells.at(0).at(0);
        QCOMPARE(cell.attempts, 0);
        QCOMPARE(cell.withoutScore, 1);
        QCOMPARE(cell.begunUtc, std::string("2026-11-20T10:00:00Z"));
        // The classmate's cell is empty.
        QVERIFY(classOverview(school, rig.instructor, rig.first)->cells.at(1).at(0) == MatrixCell{});
        VERIFY_DONE(enrol(school, rig.admin, rig.second, rig.student.person(), true));
        QVERIFY(left() == 0 && isUsedUp(1));
        VERIFY_DONE(give(rig.otherInstructor, rig.second, 2));
        QVERIFY(left() == 1 && !isUsedUp(1));
        VERIFY_DONE(rig.add(rig.student, exam, 600, "2026-11-20T09:00:00Z"));
        QVERIFY(left() == 0 && isUsedUp(1));
        VERIFY_DONE(give(rig.otherInstructor, rig.second, 0));
        QVERIFY(!left() && !isUsedUp(1));
        VERIFY_DONE(give(rig.otherInstructor, rig.second, 1));
        VERIFY_DONE(give(rig.instructor, rig.first, 3));
        QVERIFY(left() == 1 && !isUsedUp(3));
    }

    void whoIsDisabledCountsNowhere_data() { support::addEngines(); }
    void whoIsDisabledCountsNowhere()
    {
        COPY_OF(support::populatedSchool, rig);
        for (const Login* who : {&rig.student, &rig.classmate})
            VERIFY_DONE(rig.add(*who, "class1-36", 700));
        const auto results = [&] {
            return lessonResults(rig.school(), rig.instructor, rig.first, "class1-36").value();
        };
        QCOMPARE(results().difficulty.people, 2);
        rig.run({"UPDATE people SET disabled = 1 WHERE username = 's1001'"});
        QCOMPARE(results().difficulty.people, 1);
        QCOMPARE(results().bestTenths.size(), std::size_t{1});
        const ClassOverview overview = classOverview(rig.school(), rig.instructor, rig.first).value();
        QVERIFY(overview.students.at(0).isDisabled && !overview.students.at(1).isDisabled);
    }

    void saysThatTheDiskIsFullAndGoesOnAfterwards()
    {
        SchoolRig rig(support::populatedSchool(false));
        const QString pages = ask(rig.school().db, "PRAGMA page_count", "look")->toString();
        rig.run({"PRAGMA max_page_count = " + pages});
        AttemptRecord large = SchoolRig::attempt("class1-36", 500);
        large.scoreSheetJson.assign(100'000, 'x');
        VERIFY_REFUSED(rig.add(rig.student, large), ErrorCode::FileUnwritable, "the disk is full");
        QVERIFY(ownHistory(rig).empty());
        rig.run({"PRAGMA max_page_count = 100000"});
        VERIFY_DONE(rig.add(rig.student, large));
    }

    void saysThatAnotherProgramWrites()
    {
        SchoolRig rig(support::populatedSchool(false));
        const support::Station other(rig.address());
        VERIFY_DONE(execute(other.school().db, "BEGIN IMMEDIATE", "hold it"));
        VERIFY_REFUSED(rig.add(rig.student, "class1-36", 500), ErrorCode::Busy);
        VERIFY_DONE(history(rig.school(), rig.student, rig.student.person(), {}));  // readers need not wait
        VERIFY_DONE(execute(other.school().db, "ROLLBACK", "let it go"));
        VERIFY_DONE(rig.add(rig.student, "class1-36", 500));
    }
};

CUSP_TEST(TestAttempts)
#include "tst_attempts.moc"
