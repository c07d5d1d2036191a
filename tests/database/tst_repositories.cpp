// SPDX-License-Identifier: GPL-3.0-or-later
// The repositories on a real database, on both engines: what each use case guarantees beyond the functions it calls.
#include <algorithm>

#include <QDir>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "database/sql/Repositories.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Suite.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::SchoolRig;

namespace {

Person personCalled(const Repositories& school, const Login& who, const std::string& username)
{
    const auto people = school.people.list(who);
    const auto found =
        std::find_if(people->begin(), people->end(), [&](const Person& person) { return person.username == username; });
    return found == people->end() ? Person() : *found;
}

}  // namespace

class TestRepositories : public QObject
{
    Q_OBJECT

private slots:
    void aPersonIsEnteredWithTheirClasses_data() { support::addEngines(); }
    void aPersonIsEnteredWithTheirClasses()
    {
        COPY_OF(support::populatedSchool, rig);
        withRepositories(rig.school(), [&](const Repositories& school) {
            const auto entered =
                school.people.add(rig.admin, {"new1", "Nia", "New", Role::Student}, {rig.first, rig.second});
            VERIFY_DONE(entered);
            QVERIFY(!entered->code.empty());
            QVERIFY((personCalled(school, rig.admin, "new1").classes == std::vector{rig.first, rig.second}));
        });
        QCOMPARE(support::faultsOf(rig.school().db), QString());
    }

    /// A database sorts by bytes, or as its server was set up. The lists are in the order of a directory on both
    /// engines.
    void namesAreInTheOrderOfADirectory_data() { support::addEngines(); }
    void namesAreInTheOrderOfADirectory()
    {
        COPY_OF(support::populatedSchool, rig);
        withRepositories(rig.school(), [&](const Repositories& school) {
            int uid = 0;
            for (const auto& [given, family] : {std::pair("Ali", "Yılmaz"),
                                                {"Éva", "Çelik"},
                                                {"Eve", "çelik"},
                                                {"Bo", "Celik"},
                                                {"Ada", "Öz"},
                                                {"Ida", "de Boer"},
                                                {"Ola", "Zander"},
                                                {"Åse", "Oz"}})
                VERIFY_DONE(school.people.add(rig.admin, {"n" + std::to_string(++uid), given, family, Role::Student},
                                              {rig.first}));
            for (const char* name : {"Zz10", "Zz2", "Žy", "zz1"})
                VERIFY_DONE(school.classes.add(rig.admin, name));

            const QStringList sorted{"Bo Celik", "Eve çelik", "Éva Çelik",  "Ida de Boer",
                                     "Åse Oz",   "Ada Öz",    "Ali Yılmaz", "Ola Zander"};
            QStringList people;
            const auto all = school.people.list(rig.admin);
            for (const Person& person : *all)
                if (person.username.front() == 'n')
                    people << QString::fromStdString(person.fullName());
            QCOMPARE(people, sorted);
            QStringList matrix;
            const auto overview = school.classes.overview(rig.instructor, rig.first);
            for (const MatrixStudent& student : overview->students)
                if (student.username.front() == 'n')
                    matrix << QString::fromStdString(student.fullName);
            QCOMPARE(matrix, sorted);
            QCOMPARE(overview->cells.size(), overview->students.size());

            QStringList classes;
            const auto listed = school.classes.list(rig.admin);
            for (const SchoolClass& one : *listed)
                classes << QString::fromStdString(one.name);
            QCOMPARE(classes.filter(QRegularExpression("^[zZŽ]")), (QStringList{"Žy", "zz1", "Zz2", "Zz10"}));
        });
    }

    void aPersonIsNotEnteredWithoutTheirClasses_data() { support::addEngines(); }
    void aPersonIsNotEnteredWithoutTheirClasses()
    {
        COPY_OF(support::populatedSchool, rig);
        const int people = rig.count("people");
        const int audit = rig.count("audit");
        withRepositories(rig.school(), [&](const Repositories& school) {
            QVERIFY(!school.people.add(rig.admin, {"new1", "Nia", "New", Role::Student}, {rig.first, ClassId{4711}}));
        });
        QCOMPARE(rig.count("people"), people);
        QCOMPARE(rig.count("audit"), audit);
    }

    void aPersonIsChangedWithTheirClasses_data() { support::addEngines(); }
    void aPersonIsChangedWithTheirClasses()
    {
        COPY_OF(support::populatedSchool, rig);
        withRepositories(rig.school(), [&](const Repositories& school) {
            const Person sam = personCalled(school, rig.admin, "s1001");
            Person moved = sam;
            moved.familyName = "Moved";
            moved.classes = {rig.second};
            VERIFY_DONE(school.people.change(rig.admin, moved, sam));
            const Person now = personCalled(school, rig.admin, "s1001");
            QCOMPARE(now.familyName, std::string("Moved"));
            QVERIFY(now.classes == std::vector{rig.second});
        });
        QCOMPARE(support::faultsOf(rig.school().db), QString());
    }

    void classesOfAnotherAdminStay_data() { support::addEngines(); }
    void classesOfAnotherAdminStay()
    {
        COPY_OF(support::populatedSchool, rig);
        withRepositories(rig.school(), [&](const Repositories& school) {
            const Person sam = personCalled(school, rig.admin, "s1001");
            VERIFY_DONE(enrol(rig.school(), rig.admin, rig.second, sam.id, true));
            Person renamed = sam;
            renamed.familyName = "Renamed";
            VERIFY_DONE(school.people.change(rig.admin, renamed, sam));
            QVERIFY((personCalled(school, rig.admin, "s1001").classes == std::vector{rig.first, rig.second}));
        });
    }

    void aRefusedChangeLeavesTheClasses_data() { support::addEngines(); }
    void aRefusedChangeLeavesTheClasses()
    {
        COPY_OF(support::populatedSchool, rig);
        withRepositories(rig.school(), [&](const Repositories& school) {
            const Person ada = personCalled(school, rig.admin, "admin");
            Person left = ada;
            left.disabled = true;
            left.classes = {rig.first};
            VERIFY_REFUSED(school.people.change(rig.admin, left, ada), ErrorCode::NobodyLeft);
            QVERIFY(personCalled(school, rig.admin, "admin").classes.empty());
        });
    }

    void anAttemptIsReadWithItsCommentsAndItsRecording_data() { support::addEngines(); }
    void anAttemptIsReadWithItsCommentsAndItsRecording()
    {
        COPY_OF(support::populatedSchool, rig);
        const auto id = rig.add(rig.student, "class1-36", 700, "2026-11-20T10:15:00Z", "bytes");
        VERIFY_DONE(id);
        withRepositories(rig.school(), [&](const Repositories& school) {
            VERIFY_DONE(school.comments.add(rig.instructor, *id, {"well done", {}, {}}));
            VERIFY_DONE(school.comments.giveScore(rig.instructor, *id, 900, "clean walls", 0));
            VERIFY_REFUSED(school.comments.giveScore(rig.instructor, *id, 950, "again", 0), ErrorCode::ChangedSince);
            const auto record = school.attempts.open(rig.student, *id);
            VERIFY_DONE(record);
            QVERIFY(record->givenTenths == std::optional(900));
            QCOMPARE(school.attempts.recording(rig.student, *id).value(), QByteArray("bytes"));
            QCOMPARE(school.attempts.history(rig.student, rig.student.person(), {})->size(), std::size_t{1});
            QCOMPARE(school.comments.list(rig.student, *id)->comments.size(), std::size_t{1});
            QVERIFY(school.comments.feedbackFor(rig.student, rig.student.person())->front().isNew);
            VERIFY_DONE(school.comments.markSeen(rig.student, *record));
            QVERIFY(!school.comments.feedbackFor(rig.student, rig.student.person())->front().isNew);
            VERIFY_REFUSED(school.attempts.open(rig.stranger, *id), ErrorCode::NotAllowed);
        });
    }

    void onlyAdminsCheckAndBackUp_data() { support::addEngines(); }
    void onlyAdminsCheckAndBackUp()
    {
        COPY_OF(support::populatedSchool, rig);
        QTemporaryDir folder;
        const auto goesOn = [] { return true; };
        withRepositories(rig.school(), [&](const Repositories& school) {
            VERIFY_REFUSED(school.maintenance.check(rig.instructor, {}, goesOn), ErrorCode::NotAllowed);
            VERIFY_REFUSED(school.maintenance.backUp(rig.student, folder.path(), rig.nowUtc, goesOn),
                           ErrorCode::NotAllowed);
            QVERIFY(QDir(folder.path()).isEmpty());
            const auto report = school.maintenance.check(rig.admin, {school.audit.head()->code()}, goesOn);
            VERIFY_DONE(report);
            QVERIFY(report->findings.empty() && !report->isStopped);
        });
    }
};

CUSP_TEST(TestRepositories)
#include "tst_repositories.moc"
