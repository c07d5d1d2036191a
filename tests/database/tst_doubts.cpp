// SPDX-License-Identifier: GPL-3.0-or-later
// Assigned lessons belong to the school, and attempts count only if they are what their recordings prove.
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "core/recording/OriginNotes.h"
#include "core/recording/Recording.h"
#include "database/AttemptCheck.h"
#include "database/sql/Copy.h"
#include "database/sql/Doubts.h"
#include "database/sql/LessonVersions.h"
#include "database/sql/Overview.h"
#include "database/sql/Repositories.h"
#include "database/sql/StartedExams.h"
#include "lessons/Assignment.h"
#include "lessons/LessonReader.h"
#include "lessons/LessonVersion.h"
#include "lessons/ScoreSheetJson.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Files.h"
#include "tests/support/Suite.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::SchoolRig;

namespace {

const std::string kExam = "exam-layers";

/// Returns a version of an exam: of telling layers apart, whose pads are in the order of a seed.
lessons::Lesson examOf(int version, int minutes = 10)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath("exam.lesson.json");
    const QJsonObject object{{"format", 1},
                             {"based_on", "0-orientation-3-layers.lesson.json"},
                             {"id", QString::fromStdString(kExam)},
                             {"version", version},
                             {"minutes", minutes},
                             {"exam", true}};
    support::write(file, QJsonDocument(object).toJson().toStdString());
    const auto read = lessons::readLesson(file);
    if (!read.lesson)
        qWarning("%s", read.faults.front().sentence().toUtf8().constData());
    return *read.lesson;
}

struct GradedWork
{
    AttemptRecord attempt;
    QByteArray recording;
};

/// Returns an attempt at the exam, with the answers of which `right` are right.
GradedWork workAt(const lessons::Lesson& lesson, std::size_t right = core::grading::kPads, std::uint64_t drawn = 7,
                  std::uint64_t note = core::servo::kWorkNote)
{
    using namespace core::grading;
    const lessons::Assignment assignment = lessons::assign(lesson, drawn).value().assignment;
    const auto& pads = std::get<PadsToName>(*assignment.exercise);
    core::recording::Recording recording({}, assignment.anatomy, lesson.json);
    recording.append({core::servo::ServoEvent::Kind::Note, 0, glm::vec3(0.0F), note});
    for (std::size_t pad = 0; pad < kPads; ++pad)
        recording.append({core::servo::ServoEvent::Kind::Note, 0, glm::vec3(0.0F),
                          answerNote(pad, pads.madeOf[pad < right ? pad : (pad + 1) % kPads])});
    recording.append({core::servo::ServoEvent::Kind::NoDevice, 50'000, glm::vec3(0.0F), 0});
    const lessons::Remarked marked = lessons::markAgain(recording).value();
    GradedWork work{SchoolRig::attempt(lesson.id, 0), QByteArray::fromStdString(recording.toBytes())};
    setProven(work.attempt, assignment, marked.mark.sheet, marked.conduct, marked.outcome.stateHash);
    work.attempt.scoreSheetJson = lessons::toJson(marked.mark.sheet).toStdString();
    return work;
}

}  // namespace

class TestDoubts : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void anAssignedLessonIsStored_data() { support::addEngines(); }
    void anAssignedLessonIsStored()
    {
        COPY_OF(support::populatedSchool, rig);
        const lessons::Lesson exam = examOf(3);
        const QByteArray pack = lessons::packVersion(exam).value();
        VERIFY_REFUSED(versionPack(rig.school(), rig.student, exam.hash), ErrorCode::UnknownName);
        VERIFY_DONE(assignExam(rig, exam));
        const ClassAssignment given = listAssignments(rig.school(), rig.student)->front();
        QCOMPARE(given.lessonHash, exam.hash);
        QCOMPARE(given.lessonVersion, 3);
        withRepositories(rig.school(), [&](const Repositories& school) {
            QCOMPARE(school.lessons.ofUser(rig.student)->assigned.front().lessonHash, exam.hash);
            QCOMPARE(school.lessons.version(rig.student, exam.hash).value(), pack);
        });
        QCOMPARE(versionPack(rig.school(), rig.instructor, exam.hash).value(), pack);
        QCOMPARE(versionPack(rig.school(), rig.admin, exam.hash).value(), pack);
        for (const Login* other : {&rig.stranger, &rig.otherInstructor})
            VERIFY_REFUSED(versionPack(rig.school(), *other, exam.hash), ErrorCode::UnknownName);
        VERIFY_REFUSED(versionPack(rig.school(), rig.guest, exam.hash), ErrorCode::NotAllowed);
        // A second class needs no pack, and a change of the due date none either.
        VERIFY_DONE(assign(rig.school(), rig.admin, {0, rig.second, kExam, "", 1, exam.hash}));
        ClassAssignment later = given;
        later.attemptLimit = 2;
        VERIFY_DONE(assign(rig.school(), rig.instructor, later, given));
        QCOMPARE(rig.count("lesson_versions"), 1);
        QCOMPARE(support::faultsOf(rig.school().db), QString());
    }

    void onlyTheLessonThatIsNamedIsStored_data() { support::addEngines(); }
    void onlyTheLessonThatIsNamedIsStored()
    {
        COPY_OF(support::populatedSchool, rig);
        const lessons::Lesson exam = examOf(3);
        const QByteArray other = lessons::packVersion(examOf(4)).value();
        const auto refused = [&](const ClassAssignment& assignment, const QByteArray& pack, ErrorCode code) {
            VERIFY_REFUSED(assign(rig.school(), rig.instructor, assignment, {}, pack), code);
            QCOMPARE(rig.count("assignments"), 0);
            QCOMPARE(rig.count("lesson_versions"), 0);
        };
        const ClassAssignment wanted{0, rig.first, kExam, "", 1, exam.hash};
        refused(wanted, other, ErrorCode::OutOfRange);
        refused(wanted, {}, ErrorCode::OutOfRange);
        refused(wanted, "no pack", ErrorCode::WrongKind);
        refused({0, rig.first, "decay-36-moderate", "", 1, exam.hash}, lessons::packVersion(exam).value(),
                ErrorCode::OutOfRange);
    }

    /// A student edits the file of an assigned exam. The school stores what they did, and it does not count.
    void anotherVersionIsPractice_data() { support::addEngines(); }
    void anotherVersionIsPractice()
    {
        COPY_OF(support::populatedSchool, rig);
        const lessons::Lesson exam = examOf(3);
        VERIFY_DONE(assignExam(rig, exam));
        VERIFY_DONE(deliverExam(rig.school(), rig.student.uid(), {newUid(), kExam, "2026-11-20T10:00:00Z"}));
        const AttemptId id = add(rig, rig.student, workAt(examOf(3, 90)));
        QVERIFY(doubtOf(rig, id) == Doubt::Version);
        const auto opened = openAttempt(rig.school(), rig.instructor, id);
        QVERIFY(opened->passed && !opened->countsAsPassed() && !opened->counts());
        QVERIFY(standingsOf(rig.school(), rig.student, rig.student.person())->empty());
        const auto overview = classOverview(rig.school(), rig.instructor, rig.first);
        for (const auto& row : overview->cells)
            QCOMPARE(row.front().attempts, 0);
        QVERIFY(lessonResults(rig.school(), rig.instructor, rig.first, kExam)->bestTenths.empty());
        // The exam that they have begun counts, and is without a score.
        QCOMPARE(attemptsLeft(rig.school(), rig.student, kExam).value(), std::optional(0));
        QCOMPARE(examsWithoutScore(rig.school(), rig.student, rig.student.person())->size(), std::size_t{1});
        QCOMPARE(support::faultsOf(rig.school().db), QString());
        // A teacher may let it count.
        VERIFY_DONE(overrideScore(rig.school(), rig.instructor, id, 400, "the file was changed"));
        QCOMPARE(standingsOf(rig.school(), rig.student, rig.student.person())->front().bestTenths, 400);
        QCOMPARE(support::faultsOf(rig.school().db), QString());
        VERIFY_DONE(overrideScore(rig.school(), rig.instructor, id, {}, "no"));
        QVERIFY(standingsOf(rig.school(), rig.student, rig.student.person())->empty());
    }

    /// Two versions in one class, and an attempt that was begun under the first and delivered under the second.
    void anEarlierVersionOfTheClassCounts_data() { support::addEngines(); }
    void anEarlierVersionOfTheClassCounts()
    {
        COPY_OF(support::populatedSchool, rig);
        const lessons::Lesson third = examOf(3);
        const lessons::Lesson fourth = examOf(4);
        VERIFY_DONE(assignExam(rig, third));
        const AttemptId first = add(rig, rig.student, workAt(third));
        VERIFY_DONE(assignExam(rig, fourth, listAssignments(rig.school(), rig.instructor)->front()));
        QCOMPARE(listAssignments(rig.school(), rig.student)->front().lessonVersion, 4);
        const AttemptId late = add(rig, rig.classmate, workAt(third, 2));
        const AttemptId second = add(rig, rig.student, workAt(fourth, 1));
        for (const AttemptId id : {first, late, second})
            QVERIFY(doubtOf(rig, id) == Doubt::None);
        QCOMPARE(standingsOf(rig.school(), rig.student, rig.student.person())->front().attempts, 2);
        QVERIFY(versionPack(rig.school(), rig.student, third.hash).has_value());
        // The other class was assigned only the fourth version.
        VERIFY_DONE(assign(rig.school(), rig.otherInstructor, {0, rig.second, kExam, "", 1, fourth.hash}));
        const AttemptId others = add(rig, rig.stranger, workAt(third, 3, 8));
        QVERIFY(doubtOf(rig, others) == Doubt::Version);
        // A change of the assignment does not make it one of this class.
        const ClassAssignment given = listAssignments(rig.school(), rig.otherInstructor)->front();
        ClassAssignment more = given;
        more.attemptLimit = 5;
        VERIFY_DONE(assign(rig.school(), rig.otherInstructor, more, given));
        QVERIFY(doubtOf(rig, others) == Doubt::Version);
        QCOMPARE(support::faultsOf(rig.school().db), QString());
    }

    /// GradedWork from before the assignment counts only if it was done with the version that is assigned now.
    void workBeforeTheAssignmentIsCompared_data() { support::addEngines(); }
    void workBeforeTheAssignmentIsCompared()
    {
        COPY_OF(support::populatedSchool, rig);
        const lessons::Lesson exam = examOf(3);
        const AttemptId forged = add(rig, rig.student, workAt(examOf(3, 90)));
        const AttemptId honest = add(rig, rig.classmate, workAt(exam, 2));
        const AttemptId elsewhere = add(rig, rig.stranger, workAt(examOf(2), 3, 8));
        QCOMPARE(standingsOf(rig.school(), rig.student, rig.student.person())->front().attempts, 1);
        VERIFY_DONE(assignExam(rig, exam));
        QVERIFY(doubtOf(rig, forged) == Doubt::Version);
        QVERIFY(doubtOf(rig, honest) == Doubt::None);
        QVERIFY(doubtOf(rig, elsewhere) == Doubt::None);
        QVERIFY(standingsOf(rig.school(), rig.student, rig.student.person())->empty());
        // Who joins the class later is compared, too.
        VERIFY_DONE(enrol(rig.school(), rig.admin, rig.first, rig.stranger.person(), true));
        QVERIFY(doubtOf(rig, elsewhere) == Doubt::Version);
        // The version is assigned after all.
        VERIFY_DONE(assignExam(rig, examOf(2), listAssignments(rig.school(), rig.instructor)->front()));
        QVERIFY(doubtOf(rig, elsewhere) == Doubt::None);
        QVERIFY(doubtOf(rig, forged) == Doubt::Version);
        QCOMPARE(support::faultsOf(rig.school().db), QString());
    }

    /// A class that was assigned a lesson before versions were stored keeps its scores.
    void oldAssignmentsKeepTheirScores_data() { support::addEngines(); }
    void oldAssignmentsKeepTheirScores()
    {
        COPY_OF(support::populatedSchool, rig);
        VERIFY_DONE(assign(rig.school(), rig.instructor, {0, rig.first, kExam, "", 3}));
        const AttemptId early = add(rig, rig.student, workAt(examOf(1)));
        VERIFY_DONE(assignExam(rig, examOf(2), listAssignments(rig.school(), rig.instructor)->front()));
        QVERIFY(doubtOf(rig, early) == Doubt::None);
        QVERIFY(doubtOf(rig, add(rig, rig.student, workAt(examOf(1), 2))) == Doubt::Version);
        const ClassAssignment stored = listAssignments(rig.school(), rig.instructor)->front();
        ClassAssignment later = stored;
        later.dueUtc = "2026-12-31T23:00:00Z";
        VERIFY_DONE(assign(rig.school(), rig.instructor, later, stored));
        QVERIFY(doubtOf(rig, early) == Doubt::None);
        // A lesson that is taken back is practice for everybody.
        VERIFY_DONE(unassign(rig.school(), rig.instructor, listAssignments(rig.school(), rig.instructor)->front()));
        QVERIFY(doubtOf(rig, add(rig, rig.student, workAt(examOf(5), 1))) == Doubt::None);
        QCOMPARE(support::faultsOf(rig.school().db), QString());
    }

    void theRecordingOfAnotherPersonDoesNotCount_data() { support::addEngines(); }
    void theRecordingOfAnotherPersonDoesNotCount()
    {
        COPY_OF(support::populatedSchool, rig);
        GradedWork work = workAt(examOf(3));
        QVERIFY(doubtOf(rig, add(rig, rig.student, work)) == Doubt::None);
        work.attempt.uid = newUid();
        const AttemptId copied = add(rig, rig.classmate, work);
        QVERIFY(doubtOf(rig, copied) == Doubt::Recording);
        QCOMPARE(standingsOf(rig.school(), rig.classmate, rig.classmate.person())->front().bestTenths, 0);
        // A check of the recording alone does not end that.
        VERIFY_DONE(noteCheck(rig.school(), rig.instructor, copied, Doubt::None));
        QVERIFY(doubtOf(rig, copied) == Doubt::Recording);
        QCOMPARE(support::faultsOf(rig.school().db), QString());
    }

    void aCheckEndsInADoubtOrNot_data() { support::addEngines(); }
    void aCheckEndsInADoubtOrNot()
    {
        COPY_OF(support::populatedSchool, rig);
        const std::uint64_t students = core::recording::personNote(rig.student.uid());
        const AttemptId sound = add(rig, rig.student, workAt(examOf(3), core::grading::kPads, 7, students));
        GradedWork forged = workAt(examOf(3), 0, 7, core::recording::personNote(rig.classmate.uid()));
        forged.attempt.scoreTenths = 1000;
        forged.attempt.passed = true;
        const AttemptId id = add(rig, rig.classmate, forged);
        const AttemptId teachers = add(rig, rig.instructor, workAt(examOf(3), 1));
        QVERIFY((attemptsToCheck(rig.school(), rig.instructor, 10).value() == std::vector{id, sound}));
        QCOMPARE(attemptsToCheck(rig.school(), rig.instructor, 1)->size(), std::size_t{1});
        QVERIFY(attemptsToCheck(rig.school(), rig.otherInstructor, 10)->empty());
        for (const AttemptId one : {id, sound}) {
            const auto attempt = openAttempt(rig.school(), rig.instructor, one);
            const auto recording = openRecording(rig.school(), rig.instructor, one);
            VERIFY_DONE(noteCheck(rig.school(), rig.instructor, one, checkAttempt(*attempt, *recording)));
        }
        QVERIFY(doubtOf(rig, sound) == Doubt::None);
        QVERIFY(doubtOf(rig, id) == Doubt::Score);
        QVERIFY(doubtOf(rig, teachers) == Doubt::None);
        QVERIFY(attemptsToCheck(rig.school(), rig.admin, 10)->empty());
        const LessonStanding standing = standingsOf(rig.school(), rig.classmate, rig.classmate.person())->front();
        QVERIFY(standing.attempts == 1 && standing.bestTenths == 0 && !standing.passed);
        const auto overview = classOverview(rig.school(), rig.instructor, rig.first);
        int inDoubt = 0;
        for (const auto& row : overview->cells)
            inDoubt += row.front().inDoubt;
        QCOMPARE(inDoubt, 1);
        QCOMPARE(support::faultsOf(rig.school().db), QString());
        // The next check of a sound program ends the doubt.
        VERIFY_DONE(noteCheck(rig.school(), rig.admin, id, Doubt::None));
        QVERIFY(doubtOf(rig, id) == Doubt::None);
        VERIFY_REFUSED(noteCheck(rig.school(), rig.admin, {999}, Doubt::None), ErrorCode::UnknownName);
    }

    void aDoubtIsNotRemovedUnnoticed_data() { support::addEngines(); }
    void aDoubtIsNotRemovedUnnoticed()
    {
        COPY_OF(support::populatedSchool, rig);
        const lessons::Lesson exam = examOf(3);
        VERIFY_DONE(assignExam(rig, exam));
        const AttemptId id = add(rig, rig.student, workAt(examOf(3, 90)));
        const auto named = [&](const QStringList& statements, const char* words) {
            SchoolRig changed(rig);
            changed.run(statements);
            QVERIFY2(support::faultsOf(changed.school().db).contains(QLatin1String(words)),
                     qPrintable(support::faultsOf(changed.school().db)));
            rig.reopen();
        };
        const bool isServer = dialect::isPostgres(rig.school().db);
        named({QStringLiteral("UPDATE attempts SET doubt = '' WHERE id = %1").arg(id.value)}, "table attempts differs");
        named({QStringLiteral("UPDATE attempts SET checked = 1 WHERE id = %1").arg(id.value)},
              "table attempts differs");
        named({QStringLiteral("UPDATE assignments SET lesson_hash = ''")}, "table assignments differs");
        const QString off = isServer ? "DROP TRIGGER %1_no_change ON %1" : "DROP TRIGGER %1_no_update";
        named({off.arg("lesson_versions"), isServer ? "UPDATE lesson_versions SET pack = '\\x00'::bytea"
                                                    : "UPDATE lesson_versions SET pack = x'00'"},
              "version 3 of the lesson exam-layers");
        named({off.arg("assigned_versions"),
               QStringLiteral("UPDATE assigned_versions SET class_id = %1").arg(rig.second.value)},
              "table assigned_versions differs");
        QVERIFY(!execute(rig.school().db, "UPDATE lesson_versions SET version = 9", "try it"));
    }

    void aCopyOfTheSchoolHasTheLessons_data() { support::addEngines(); }
    void aCopyOfTheSchoolHasTheLessons()
    {
        COPY_OF(support::populatedSchool, rig);
        const lessons::Lesson exam = examOf(3);
        VERIFY_DONE(assignExam(rig, exam));
        const AttemptId id = add(rig, rig.student, workAt(examOf(3, 90)));
        SchoolRig copy(!onServer && support::sharedServer().fault().isEmpty());
        VERIFY_DONE(copySchool(rig.school(), rig.admin, copy.school()));
        const Login student = copy.logIn("s1001").value();
        const auto pack = versionPack(copy.school(), student, exam.hash);
        VERIFY_DONE(pack);
        QCOMPARE(*pack, lessons::packVersion(exam).value());
        QVERIFY(openAttempt(copy.school(), student, id)->doubt == Doubt::Version);
        QCOMPARE(support::faultsOf(copy.school().db), QString());
    }

    void anAttemptIsWhatItsRecordingProves()
    {
        const lessons::Lesson exam = examOf(3);
        const GradedWork work = workAt(exam);
        QVERIFY(work.attempt.passed && work.attempt.scoreTenths == 1000);
        QVERIFY(checkAttempt(work.attempt, work.recording) == Doubt::None);
        QVERIFY(checkAttempt(work.attempt, work.recording, exam) == Doubt::None);
        const auto forged = [&](auto change) {
            AttemptRecord attempt = work.attempt;
            change(attempt);
            return checkAttempt(attempt, work.recording);
        };
        QVERIFY(forged([](AttemptRecord& one) { one.scoreTenths = 999; }) == Doubt::Score);
        QVERIFY(forged([](AttemptRecord& one) { one.passed = false; }) == Doubt::Score);
        QVERIFY(forged([](AttemptRecord& one) { one.passMarkTenths = 1; }) == Doubt::Score);
        QVERIFY(forged([](AttemptRecord& one) { one.durationMs /= 2; }) == Doubt::Score);
        QVERIFY(forged([](AttemptRecord& one) { one.stateHash.front() = 'x'; }) == Doubt::Score);
        QVERIFY(forged([](AttemptRecord& one) { one.criteria.front().lostTenths = 1; }) == Doubt::Score);
        QVERIFY(forged([](AttemptRecord& one) { one.tooth = "37"; }) == Doubt::Score);
        lessons::ScoreSheet sheet = lessons::sheetIn(work.attempt.scoreSheetJson).value();
        sheet.totalTenths = 400;
        const std::string shown = lessons::toJson(sheet).toStdString();
        QVERIFY(forged([&](AttemptRecord& one) { one.scoreSheetJson = shown; }) == Doubt::Score);
        QVERIFY(forged([](AttemptRecord& one) { one.scoreSheetJson = "{}"; }) == Doubt::Score);
        // What a student says of themselves is not proven by a recording.
        QVERIFY(forged([](AttemptRecord& one) { one.expectedTenths = 1; }) == Doubt::None);
    }

    void theRecordingIsOfTheLessonAndTheTooth()
    {
        const lessons::Lesson exam = examOf(3);
        const GradedWork work = workAt(exam);
        QVERIFY(checkAttempt(work.attempt, {}) == Doubt::Recording);
        QVERIFY(checkAttempt(work.attempt, "no recording") == Doubt::Recording);
        QVERIFY(checkAttempt(work.attempt, work.recording.left(work.recording.size() / 2)) == Doubt::Recording);
        // The recording of an easier version, reported as the exam.
        const GradedWork easier = workAt(examOf(3, 90));
        QVERIFY(checkAttempt(work.attempt, easier.recording) == Doubt::Recording);
        AttemptRecord practice = work.attempt;
        practice.lessonId.clear();
        practice.lessonHash.clear();
        QVERIFY(checkAttempt(practice, work.recording) == Doubt::Recording);
        // The lesson of the exam with another tooth.
        const lessons::Assignment other =
            lessons::assign(*lessons::readLesson(":/lessons/block-1-line.lesson.json").lesson).value().assignment;
        const core::recording::Recording swapped({}, other.anatomy, exam.json);
        QVERIFY(checkAttempt(work.attempt, QByteArray::fromStdString(swapped.toBytes())) == Doubt::Recording);
        // A tooth from which decay is gone already.
        const lessons::Lesson decay = *lessons::readLesson(":/lessons/decay-36-1-small.lesson.json").lesson;
        auto healthy = *lessons::assign(decay).value().assignment.anatomy;
        for (core::terrain::ColumnLayers& column : healthy.layers)
            column.cariesRoof = column.cariesFloor;
        const core::recording::Recording done({}, std::make_shared<const core::terrain::ToothAnatomy>(healthy),
                                              decay.json);
        AttemptRecord easy = work.attempt;
        easy.lessonId = decay.id;
        easy.lessonHash = decay.hash;
        QVERIFY(checkAttempt(easy, QByteArray::fromStdString(done.toBytes())) == Doubt::Recording);
    }

    /// That of somebody else, of a guest or of the simulated hand is not taken for one's own.
    void theRecordingIsOfThePerson()
    {
        const lessons::Lesson exam = examOf(3);
        const std::string own = "0123456789ab" + std::string(20, 'c');
        const std::string others = "1123456789ab" + std::string(20, 'c');
        const auto check = [&](std::uint64_t note) {
            GradedWork work = workAt(exam, core::grading::kPads, 7, note);
            work.attempt.personUid = own;
            return checkAttempt(work.attempt, work.recording);
        };
        QVERIFY(check(core::recording::personNote(own)) == Doubt::None);
        QVERIFY(check(core::recording::personNote(others)) == Doubt::Recording);
        QVERIFY(check(core::servo::kWorkNote) == Doubt::Recording);
        // The own note behind that of somebody else changes nothing.
        GradedWork taken = workAt(exam, core::grading::kPads, 7, core::recording::personNote(others));
        auto recording = core::recording::Recording::fromBytes(taken.recording.toStdString()).value();
        recording.append({core::servo::ServoEvent::Kind::Note, 0, glm::vec3(0.0F), core::recording::personNote(own)});
        taken.attempt.personUid = own;
        QVERIFY(checkAttempt(taken.attempt, QByteArray::fromStdString(recording.toBytes())) == Doubt::Recording);
    }

    /// A recording that was made without the school, or in less time than it says, is no exam.
    void anExamHasAStart()
    {
        const lessons::Lesson exam = examOf(3);
        const ExamStart own{"0123456789ab" + std::string(20, 'c'), kExam, "2026-11-20T10:00:00Z"};
        const GradedWork bare = workAt(exam);
        const GradedWork begun = workAt(exam, core::grading::kPads, 7, core::recording::examNote(own.uid));
        const auto check = [&](const GradedWork& work, const std::vector<ExamStart>& starts) {
            return checkAttempt(work.attempt, work.recording, {}, starts);
        };
        QVERIFY(check(begun, {own}) == Doubt::None);
        QVERIFY(check(bare, {own}) == Doubt::Start);
        QVERIFY(check(begun, {}) == Doubt::Start);
        ExamStart other = own;
        other.uid.front() = '1';
        QVERIFY(check(begun, {other}) == Doubt::Start);
        QVERIFY(check(begun, {other, own}) == Doubt::None);
        // It ended long before it began.
        ExamStart late = own;
        late.begunUtc = "2026-11-20T10:30:00Z";
        QVERIFY(check(begun, {late}) == Doubt::Start);
        // Starts are not known at the delivery, and practice has none.
        QVERIFY(checkAttempt(bare.attempt, bare.recording) == Doubt::None);
        const lessons::Lesson practice = *lessons::readLesson(":/lessons/0-orientation-3-layers.lesson.json").lesson;
        QVERIFY(check(workAt(practice), {}) == Doubt::None);
    }

    void practiceWithoutALessonIsChecked()
    {
        const lessons::Lesson decay = *lessons::readLesson(":/lessons/decay-36-1-small.lesson.json").lesson;
        const auto anatomy = lessons::assign(decay).value().assignment.anatomy;
        const core::recording::Recording recording({}, anatomy);
        const QByteArray bytes = QByteArray::fromStdString(recording.toBytes());
        const lessons::Remarked marked = lessons::markAgain(recording).value();
        AttemptRecord attempt = SchoolRig::attempt("", 0);
        setProven(attempt, lessons::practiceOn(anatomy).value(), marked.mark.sheet, marked.conduct,
                  marked.outcome.stateHash);
        attempt.scoreSheetJson = lessons::toJson(marked.mark.sheet).toStdString();
        QVERIFY(checkAttempt(attempt, bytes) == Doubt::None);
        attempt.scoreTenths = 1000;
        QVERIFY(checkAttempt(attempt, bytes) == Doubt::Score);
        // Another Cusp may have graded it by another rubric.
        attempt.rubricHash = std::string(64, 'e');
        QVERIFY(checkAttempt(attempt, bytes) == Doubt::None);
    }

private:
    static core::Status assignExam(const SchoolRig& rig, const lessons::Lesson& exam,
                                   const std::optional<ClassAssignment>& before = {})
    {
        return assign(rig.school(), rig.instructor, {0, rig.first, kExam, "", 1, exam.hash}, before,
                      lessons::packVersion(exam).value());
    }
    static AttemptId add(const SchoolRig& rig, const Login& who, const GradedWork& work)
    {
        return rig.add(who, work.attempt, work.recording).value();
    }
    static Doubt doubtOf(const SchoolRig& rig, AttemptId id)
    {
        return openAttempt(rig.school(), rig.admin, id).value().doubt;
    }
};

CUSP_TEST(TestDoubts)
#include "tst_doubts.moc"
