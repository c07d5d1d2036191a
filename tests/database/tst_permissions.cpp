// SPDX-License-Identifier: GPL-3.0-or-later
// Calls every operation as every role, on what is one's own, a classmate's and a stranger's, and compares what happens
// with this table. It is written out here a second time on purpose.
#include <array>
#include <functional>
#include <map>
#include <set>

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include "database/Outbox.h"
#include "database/sql/Backups.h"
#include "database/sql/Copy.h"
#include "database/sql/ExamStarts.h"
#include "database/sql/Export.h"
#include "database/sql/Feedback.h"
#include "database/sql/Overview.h"
#include "database/sql/Presets.h"
#include "database/sql/Roster.h"
#include "tests/database/SchoolRig.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::addAttempt;
using support::SchoolRig;

namespace {

/// Whose thing is asked for.
enum Target { Mine, Classmates, Strangers, kTargets };
constexpr std::array kTargetNames{"one's own", "a classmate's", "a stranger's"};

/// What each role may: "-" nothing, "o" on one's own, "c" on those of one's classes, "a" on all.
const std::map<Operation, const char*> kAllowed{
    //                                 guest student instructor admin
    {Operation::ChangeOwnPassword, "-ooo"},
    {Operation::ListPeople, "--ca"},
    {Operation::AddPerson, "---a"},
    {Operation::ChangePerson, "---a"},
    {Operation::ResetPassword, "---a"},
    {Operation::ListClasses, "-cca"},
    {Operation::ChangeClasses, "---a"},
    {Operation::ListAssignments, "-cca"},
    {Operation::Assign, "--ca"},
    {Operation::AddAttempt, "-ooo"},
    {Operation::ReadHistory, "-oca"},
    {Operation::OpenAttempt, "-oca"},
    {Operation::CompareWithClass, "-oca"},
    {Operation::Comment, "--c-"},
    {Operation::WithdrawComment, "--o-"},
    {Operation::Override, "--c-"},
    {Operation::ReadClass, "--ca"},
    {Operation::ExportAttempts, "--ca"},
    {Operation::ListPresets, "aaaa"},
    {Operation::AddPreset, "---a"},
    {Operation::ReadSettings, "aaaa"},
    {Operation::ChangeSettings, "---a"},
    {Operation::ChangeOwnSettings, "-ooo"},
    {Operation::ReadAudit, "---a"},
    {Operation::KeepBackups, "---a"},
    {Operation::CopySchool, "---a"},
};

template <class T>
core::Status plain(const core::Result<T>& result)
{
    return result ? core::Status() : core::Status(tl::unexpected(result.error()));
}

/// One function of the program, with what it is asked about.
struct Call
{
    Operation operation;
    const char* name;
    std::function<core::Status(const Session&, Target)> call;
    bool hasTarget = true;  ///< else it is about nobody's thing
};

}  // namespace

class TestPermissions : public QObject
{
    Q_OBJECT

private slots:
    void everyOperationAsEveryRole_data() { support::addEngines(); }
    void everyOperationAsEveryRole();
    void everyFunctionOfASessionIsAmongThem();
    void scoresAreGivenToStudentsOnly();
    void listsHoldOnlyWhatOneMaySee_data() { support::addEngines(); }
    void listsHoldOnlyWhatOneMaySee();

private:
    static std::vector<Call> callsOn(SchoolRig& rig);
};

std::vector<Call> TestPermissions::callsOn(SchoolRig& rig)
{
    const School& s = rig.school();
    // What is there before anybody asks.
    std::map<std::int64_t, AttemptId> attemptOf;
    for (const Session* who : {&rig.student, &rig.classmate, &rig.stranger, &rig.instructor, &rig.admin})
        attemptOf[who->person().value] = addAttempt(s, *who, SchoolRig::attempt("class1-36", 700), "recording").value();
    const std::int64_t ownComment =
        addComment(s, rig.instructor, attemptOf[rig.classmate.person().value], {"well", {}, {}}).value();
    const std::int64_t othersComment =
        addComment(s, rig.otherInstructor, attemptOf[rig.stranger.person().value], {"well", {}, {}}).value();
    const auto personOf = [&rig](const Session& me, Target target) {
        // An admin is in no class: everybody's things are a stranger's to him.
        return target == Mine ? me.person() : target == Classmates ? rig.classmate.person() : rig.stranger.person();
    };
    const auto attempt = [attemptOf, personOf](const Session& me, Target target) {
        const auto found = attemptOf.find(personOf(me, target).value);
        return found == attemptOf.end() ? attemptOf.begin()->second : found->second;
    };
    const auto classOf = [&rig](Target target) { return target == Strangers ? rig.second : rig.first; };
    const auto person = [&rig, &s](PersonId id) {
        Person p;
        const auto people = listPeople(s, rig.admin);
        for (const Person& one : *people)
            if (one.id == id)
                p = one;
        return p;
    };
    static int counter = 0;
    const auto folder = std::make_shared<QTemporaryDir>();
    return {
        {Operation::ChangeOwnPassword, "changePassword",
         [&s](const Session& me, Target) {
             return Logins::changePassword(s, me, SchoolRig::kPassword, SchoolRig::kPassword);
         },
         false},
        {Operation::ChangeOwnPassword, "ownHash",
         [&s](const Session& me, Target) { return plain(Logins::ownHash(s, me)); }, false},
        {Operation::ListPeople, "listPeople", [&s](const Session& me, Target) { return plain(listPeople(s, me)); },
         false},
        {Operation::AddPerson, "addPerson",
         [&s](const Session& me, Target) {
             return plain(addPerson(s, me, {"new" + std::to_string(++counter), "", "", Role::Student}));
         },
         false},
        {Operation::AddPerson, "importRoster",
         [&s](const Session& me, Target) {
             return plain(importRoster(s, me, "username\nroster" + std::to_string(++counter) + "\n", false));
         },
         false},
        {Operation::ChangePerson, "changePerson",
         [&s, person](const Session& me, Target) { return plain(changePerson(s, me, person({3}))); }, false},
        {Operation::ChangePerson, "findPerson",
         [&s](const Session& me, Target) { return plain(findPerson(s, me, "s1002")); }, false},
        {Operation::ResetPassword, "resetPassword",
         [&s, &rig](const Session& me, Target) { return plain(resetPassword(s, me, rig.classmate.person())); }, false},
        {Operation::ListClasses, "listClasses", [&s](const Session& me, Target) { return plain(listClasses(s, me)); },
         false},
        {Operation::ChangeClasses, "addClass",
         [&s](const Session& me, Target) { return plain(addClass(s, me, "class " + std::to_string(++counter))); },
         false},
        {Operation::ChangeClasses, "renameClass",
         [&s, &rig](const Session& me, Target) { return renameClass(s, me, rig.second, "DEN101-B"); }, false},
        {Operation::ChangeClasses, "enrol",
         [&s, &rig](const Session& me, Target) { return enrol(s, me, rig.first, rig.student.person(), true); }, false},
        {Operation::ListAssignments, "listAssignments",
         [&s](const Session& me, Target) { return plain(listAssignments(s, me)); }, false},
        {Operation::Assign, "assign",
         [&s, classOf](const Session& me, Target target) {
             return assign(s, me, {0, classOf(target), "class1-" + newUid(), "", 0});
         }},
        {Operation::Assign, "unassign",
         [&s, classOf](const Session& me, Target target) {
             return unassign(s, me, {0, classOf(target), "class1-36", "", 0});
         }},
        {Operation::AddAttempt, "Outbox::put, attempt",
         [folder](const Session& me, Target) {
             return Outbox(folder->path(), StationKey::make()).put(me, SchoolRig::attempt("class1-36", 500), {});
         },
         false},
        {Operation::AddAttempt, "Outbox::put, exam",
         [folder](const Session& me, Target) {
             return Outbox(folder->path(), StationKey::make())
                 .put(me, ExamStart{newUid(), "exam-36", "2026-11-20T10:00:00Z"});
         },
         false},
        {Operation::ReadHistory, "feedbackFor",
         [&s, personOf](const Session& me, Target target) { return plain(feedbackFor(s, me, personOf(me, target))); }},
        {Operation::ChangeOwnSettings, "seeFeedback",
         [&s](const Session& me, Target) { return seeFeedback(s, me, SchoolRig::attempt("class1-36", 500)); }, false},
        {Operation::ReadHistory, "examsWithoutScore",
         [&s, personOf](const Session& me, Target target) {
             return plain(examsWithoutScore(s, me, personOf(me, target)));
         }},
        {Operation::ReadHistory, "history",
         [&s, personOf](const Session& me, Target t) { return plain(history(s, me, personOf(me, t), {})); }},
        {Operation::ReadHistory, "standingsOf",
         [&s, personOf](const Session& me, Target t) { return plain(standingsOf(s, me, personOf(me, t))); }},
        {Operation::OpenAttempt, "openAttempt",
         [&s, attempt](const Session& me, Target t) { return plain(openAttempt(s, me, attempt(me, t))); }},
        {Operation::OpenAttempt, "openRecording",
         [&s, attempt](const Session& me, Target t) { return plain(openRecording(s, me, attempt(me, t))); }},
        {Operation::OpenAttempt, "readTalk",
         [&s, attempt](const Session& me, Target t) { return plain(readTalk(s, me, attempt(me, t))); }},
        {Operation::OpenAttempt, "sheetsOfLesson",
         [&s](const Session& me, Target) { return plain(sheetsOfLesson(s, me, "class1-36", std::string(64, 'a'), 9)); },
         false},
        {Operation::CompareWithClass, "classBand",
         [&s, personOf](const Session& me, Target t) { return plain(classBand(s, me, personOf(me, t), "class1-36")); }},
        {Operation::CompareWithClass, "classMedians",
         [&s, personOf](const Session& me, Target t) {
             return plain(classMedians(s, me, personOf(me, t), "class1-36"));
         }},
        {Operation::CompareWithClass, "standingAmongClassmates",
         [&s](const Session& me, Target) {
             return plain(standingAmongClassmates(s, me, "class1-36", std::string(64, 'b'), 700));
         },
         false},
        {Operation::Comment, "addComment",
         [&s, attempt](const Session& me, Target t) {
             return plain(addComment(s, me, attempt(me, t), {"well", {}, {}}));
         }},
        {Operation::WithdrawComment, "withdrawComment",
         [&s, ownComment, othersComment](const Session& me, Target t) {
             return withdrawComment(s, me, t == Mine ? ownComment : othersComment);
         }},
        {Operation::Override, "overrideScore",
         [&s, attempt](const Session& me, Target t) { return overrideScore(s, me, attempt(me, t), 800, "as seen"); }},
        {Operation::ReadClass, "classOverview",
         [&s, classOf](const Session& me, Target t) { return plain(classOverview(s, me, classOf(t))); }},
        {Operation::ReadClass, "lessonResults",
         [&s, classOf](const Session& me, Target t) { return plain(lessonResults(s, me, classOf(t), "class1-36")); }},
        {Operation::ReadClass, "noteClassExport",
         [&s, classOf](const Session& me, Target t) { return noteClassExport(s, me, classOf(t)); }},
        {Operation::ExportAttempts, "exportAttempts",
         [&s](const Session& me, Target) {
             return plain(exportAttempts(s, me, [](std::string_view) { return true; }));
         },
         false},
        {Operation::ListPresets, "listPresets", [&s](const Session& me, Target) { return plain(listPresets(s, me)); },
         false},
        {Operation::AddPreset, "addPreset",
         [&s](const Session& me, Target) {
             return addPreset(s, me, {"mine", ++counter, std::string(64, 'd'), "{}"});
         },
         false},
        {Operation::ReadSettings, "readSettings",
         [&s](const Session& me, Target) { return plain(readSettings(s, me)); }, false},
        {Operation::ChangeSettings, "changeSetting",
         [&s](const Session& me, Target) { return changeSetting(s, me, "idle.minutes", "5"); }, false},
        {Operation::ChangeSettings, "raisePasswordCost",
         [&s](const Session& me, Target) {
             return raisePasswordCost(s, me, {1, 8192});
         },
         false},
        {Operation::ChangeSettings, "replaceSetting",
         [&s](const Session& me, Target) { return plain(replaceSetting(s, me, "idle.minutes", "5")); }, false},
        {Operation::ChangeOwnSettings, "changeOwnSetting",
         [&s](const Session& me, Target) { return changeOwnSetting(s, me, "language", "de"); }, false},
        {Operation::ReadAudit, "readAudit", [&s](const Session& me, Target) { return plain(readAudit(s, me, 10)); },
         false},
        {Operation::KeepBackups, "mayRestore", [&s](const Session& me, Target) { return mayRestore(s, me); }, false},
        {Operation::KeepBackups, "noteBackup",
         [&s](const Session& me, Target) { return noteBackup(s, me, QStringLiteral("backup.sqlite")); }, false},
        {Operation::CopySchool, "copySchool",
         [&s](const Session& me, Target) {
             SchoolRig other(false);
             return plain(copySchool(s, me, other.school()));
         },
         false},
    };
}

void TestPermissions::everyOperationAsEveryRole()
{
    COPY_OF(support::populatedSchool, rig);
    const std::vector<Call> calls = callsOn(rig);
    std::set<Operation> called;
    const std::array<const Session*, kRoles> sessions{&rig.guest, &rig.student, &rig.instructor, &rig.admin};
    for (const Call& call : calls) {
        called.insert(call.operation);
        for (std::size_t role = 0; role < kRoles; ++role)
            for (const Target target : {Mine, Classmates, Strangers}) {
                const Session& me = *sessions.at(role);
                if (!call.hasTarget && target != Mine)
                    continue;
                if (role == 0 && target == Mine && call.hasTarget)
                    continue;  // a guest has nothing of his own
                const char may = kAllowed.at(call.operation)[role];
                // One's own class is what its students are in, too. Nobody marks himself.
                const bool marks = call.operation == Operation::Comment || call.operation == Operation::Override;
                const bool expected = may == 'a' || (may != '-' && !call.hasTarget) || (may == 'o' && target == Mine) ||
                                      (may == 'c' && target != Strangers && !(marks && target == Mine));
                const core::Status done = call.call(me, target);
                const QString what =
                    QStringLiteral("%1 as %2 on %3: %4")
                        .arg(QLatin1String(call.name))
                        .arg(QString::fromUtf8(roleName(static_cast<Role>(role)).data()),
                             QLatin1String(kTargetNames.at(target)),
                             done ? QStringLiteral("done") : QString::fromStdString(done.error().detail));
                QVERIFY2(done.has_value() == expected, qPrintable(what));
                if (!expected)
                    QVERIFY2(done.error().code == ErrorCode::NotAllowed, qPrintable(what));
            }
    }
    QCOMPARE(called.size(), kOperations);
    QCOMPARE(kAllowed.size(), kOperations);
    // The program's own table says the same.
    for (const auto& [operation, roles] : kAllowed)
        for (std::size_t role = 0; role < kRoles; ++role) {
            const Reach reach = reachOf(operation, static_cast<Role>(role));
            QCOMPARE("-oca"[static_cast<std::size_t>(reach)], roles[role]);
        }
}

/// Whoever adds a function that takes a session and does not add it to the calls above is told here.
void TestPermissions::everyFunctionOfASessionIsAmongThem()
{
    SchoolRig rig(support::populatedSchool(false));
    std::set<QString> called;
    for (const Call& call : callsOn(rig))
        called.insert(QLatin1String(call.name));
    const std::set<QString> others{
        "admit",        "admitTo", "admitToClass",  // which do the refusing
        "logout",                                   // anybody may leave
        "attemptsLeft",                             // of one's own; a guest's are not counted
        "noteRestored"                              // after mayRestore(), by whom the restored school may not know
    };
    static const QRegularExpression kTakesSession(R"(\b(\w+)\(\s*const School& \w+,\s*const Session& \w+)");
    const QDir folder(QStringLiteral(CUSP_SOURCE_DIR "/database/sql"));
    int found = 0;
    for (const QString& name : folder.entryList({"*.h"})) {
        QFile header(folder.filePath(name));
        QVERIFY(header.open(QIODevice::ReadOnly));
        auto match = kTakesSession.globalMatch(QString::fromUtf8(header.readAll()));
        for (; match.hasNext(); ++found) {
            const QString function = match.next().captured(1);
            QVERIFY2(called.count(function) + others.count(function) == 1,
                     qPrintable(function + " of " + name + " is called as no role"));
        }
    }
    QVERIFY(found > 30);
}

void TestPermissions::scoresAreGivenToStudentsOnly()
{
    SchoolRig rig(support::populatedSchool(false));
    VERIFY_DONE(enrol(rig.school(), rig.admin, rig.first, rig.otherInstructor.person(), true));
    const AttemptId own = addAttempt(rig.school(), rig.instructor, SchoolRig::attempt("class1-36", 500), {}).value();
    for (const Session* who : {&rig.instructor, &rig.otherInstructor})
        VERIFY_REFUSED(overrideScore(rig.school(), *who, own, 1000, "neat"), ErrorCode::NotAllowed);
    // What colleagues tell each other is another thing.
    VERIFY_REFUSED(addComment(rig.school(), rig.instructor, own, {"neat", {}, {}}), ErrorCode::NotAllowed);
    VERIFY_DONE(addComment(rig.school(), rig.otherInstructor, own, {"neat", {}, {}}));
    const AttemptId his = addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500), {}).value();
    VERIFY_DONE(overrideScore(rig.school(), rig.otherInstructor, his, 600, "neat"));
}

void TestPermissions::listsHoldOnlyWhatOneMaySee()
{
    COPY_OF(support::populatedSchool, rig);
    for (const Session* who : {&rig.student, &rig.classmate, &rig.stranger})
        VERIFY_DONE(addAttempt(rig.school(), *who, SchoolRig::attempt("class1-36", 700), {}));
    const auto names = [&](const Session& me) {
        std::set<std::string> found;
        const auto people = listPeople(rig.school(), me);
        for (const Person& person : *people)
            found.insert(person.username);
        return found;
    };
    QCOMPARE(names(rig.instructor), (std::set<std::string>{"s1001", "s1002", "teach"}));
    QCOMPARE(names(rig.otherInstructor), (std::set<std::string>{"s2001", "teach2"}));
    QCOMPARE(names(rig.admin).size(), std::size_t{6});
    int exported = 0;
    const auto lines = [&](const Session& me) {
        int count = -1;  // without the head
        VERIFY_DONE(exportAttempts(rig.school(), me, [&](std::string_view) {
            ++count;
            return true;
        }));
        exported = count;
    };
    lines(rig.instructor);
    QCOMPARE(exported, 2);
    lines(rig.otherInstructor);
    QCOMPARE(exported, 1);
    lines(rig.admin);
    QCOMPARE(exported, 3);
    QCOMPARE(listClasses(rig.school(), rig.student)->size(), std::size_t{1});
    QCOMPARE(listClasses(rig.school(), rig.admin)->size(), std::size_t{2});
    QCOMPARE(sheetsOfLesson(rig.school(), rig.student, "class1-36", std::string(64, 'a'), 9)->size(), std::size_t{1});
    QCOMPARE(sheetsOfLesson(rig.school(), rig.instructor, "class1-36", std::string(64, 'a'), 9)->size(),
             std::size_t{2});
}

QTEST_GUILESS_MAIN(TestPermissions)
#include "tst_permissions.moc"
