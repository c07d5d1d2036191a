// SPDX-License-Identifier: GPL-3.0-or-later
// Calls every operation as every role on the user's own data, a classmate's and a stranger's, and compares the outcome
// with this table. The table repeats the program's own on purpose.
#include <array>
#include <functional>
#include <map>
#include <set>
#include <type_traits>

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include "database/Outbox.h"
#include "database/sql/Backups.h"
#include "database/sql/Copy.h"
#include "database/sql/Doubts.h"
#include "database/sql/Erasing.h"
#include "database/sql/Export.h"
#include "database/sql/Feedback.h"
#include "database/sql/LessonVersions.h"
#include "database/sql/Overview.h"
#include "database/sql/Presets.h"
#include "database/sql/Roster.h"
#include "database/sql/StartedExams.h"
#include "lessons/LessonReader.h"
#include "lessons/LessonVersion.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Suite.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::SchoolRig;

namespace {

/// The owner of the data that an operation is called on.
enum Target { Mine, Classmates, Strangers, kTargets };
constexpr std::array kTargetNames{"one's own", "a classmate's", "a stranger's"};

/// What each role may do: "-" nothing, "o" with its own data, "c" with those of its classes, "a" with all.
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
    {Operation::CheckAttempt, "--ca"},
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

/// One function of the program and the owners it can be called for.
struct Call
{
    template <class Ask>
    Call(Operation of, const char* called, Ask ask)
        : operation(of), name(called), hasTarget(std::is_invocable_v<Ask, const Login&, Target>)
    {
        call = [ask](const Login& me, Target target) {
            const auto ended = [&] {
                if constexpr (std::is_invocable_v<Ask, const Login&, Target>)
                    return ask(me, target);
                else
                    return ask(me);
            }();
            return ended ? core::Status() : core::Status(tl::unexpected(ended.error()));
        };
    }

    Operation operation;
    const char* name;
    bool hasTarget;  ///< false: the function is about no user's data
    std::function<core::Status(const Login&, Target)> call;
};

/// A school in which every user has data, and all calls that a login can make.
class Asked
{
public:
    explicit Asked(SchoolRig& rig) : m_rig(rig)
    {
        for (const Login* who : {&rig.student, &rig.classmate, &rig.stranger, &rig.instructor, &rig.admin})
            m_attempts[who->person().value] = rig.add(*who, SchoolRig::attempt("class1-36", 700), "recording").value();
        const auto comment = [&](const Login& by, const Login& about) {
            return addComment(s, by, m_attempts[about.person().value], {"well", {}, {}}).value();
        };
        m_ownComment = comment(rig.instructor, rig.classmate);
        m_othersComment = comment(rig.otherInstructor, rig.stranger);
        m_classmate = findPerson(s, rig.admin, "s1002").value();
        const lessons::Lesson lesson = *lessons::readLesson(":/lessons/block-1-line.lesson.json").lesson;
        m_version = lesson.hash;
        if (!assign(s, rig.instructor, {0, rig.first, lesson.id, "", 0, lesson.hash}, {},
                    lessons::packVersion(lesson).value()))
            qWarning("not assigned");
    }
    Asked(const Asked&) = delete;
    Asked& operator=(const Asked&) = delete;

private:
    /// An admin is in no class, so each other user is a stranger to them.
    [[nodiscard]] PersonId personOf(const Login& me, Target target) const
    {
        return target == Mine ? me.person() : target == Classmates ? m_rig.classmate.person() : m_rig.stranger.person();
    }
    [[nodiscard]] AttemptId attempt(const Login& me, Target target) const
    {
        const auto found = m_attempts.find(personOf(me, target).value);
        return found == m_attempts.end() ? m_attempts.begin()->second : found->second;
    }
    [[nodiscard]] ClassId classOf(Target target) const { return target == Strangers ? m_rig.second : m_rig.first; }
    [[nodiscard]] std::string newName() { return "new" + std::to_string(++m_names); }
    [[nodiscard]] Outbox outbox() const { return {m_folder.path(), StationKey::make()}; }

    SchoolRig& m_rig;
    const DatabaseContext& s = m_rig.school();
    QTemporaryDir m_folder;
    std::map<std::int64_t, AttemptId> m_attempts;
    std::int64_t m_ownComment = 0;
    std::int64_t m_othersComment = 0;
    Person m_classmate;
    std::string m_version;  ///< of a lesson, assigned to the first class
    int m_names = 0;

public:
    const std::vector<Call> calls{
        {Operation::ChangeOwnPassword, "changePassword",
         [this](auto& me) { return Logins::changePassword(s, me, SchoolRig::kPassword, SchoolRig::kPassword); }},
        {Operation::ChangeOwnPassword, "ownHash", [this](auto& me) { return Logins::ownHash(s, me); }},
        {Operation::ListPeople, "listPeople", [this](auto& me) { return listPeople(s, me); }},
        {Operation::AddPerson, "addPerson",
         [this](auto& me) {
             return addPerson(s, me, {newName(), "", "", Role::Student});
         }},
        {Operation::AddPerson, "importRoster",
         [this](auto& me) { return importRoster(s, me, "username\nroster" + newName() + "\n", false); }},
        {Operation::ChangePerson, "changePerson", [this](auto& me) { return changePerson(s, me, m_classmate); }},
        {Operation::ChangePerson, "erasePerson",
         [this](auto& me) {
             return erasePerson(s, me, addPerson(s, m_rig.admin, {newName(), "", "", Role::Student})->person.id);
         }},
        {Operation::ChangePerson, "findPerson", [this](auto& me) { return findPerson(s, me, "s1002"); }},
        {Operation::ResetPassword, "resetPassword",
         [this](auto& me) { return resetPassword(s, me, m_rig.classmate.person()); }},
        {Operation::ListClasses, "listClasses", [this](auto& me) { return listClasses(s, me); }},
        {Operation::ChangeClasses, "addClass", [this](auto& me) { return addClass(s, me, "class " + newName()); }},
        {Operation::ChangeClasses, "renameClass",
         [this](auto& me) { return renameClass(s, me, m_rig.second, "DEN101-B"); }},
        {Operation::ChangeClasses, "enrol",
         [this](auto& me) { return enrol(s, me, m_rig.first, m_rig.student.person(), true); }},
        {Operation::ListAssignments, "listAssignments", [this](auto& me) { return listAssignments(s, me); }},
        {Operation::ListAssignments, "versionPack", [this](auto& me) { return versionPack(s, me, m_version); }},
        {Operation::Assign, "assign",
         [this](auto& me, auto t) {
             return assign(s, me, {0, classOf(t), "class1-" + newUid(), "", 0});
         }},
        {Operation::Assign, "unassign",
         [this](auto& me, auto t) {
             return unassign(s, me, {0, classOf(t), "class1-36", "", 0});
         }},
        {Operation::AddAttempt, "Outbox::put, attempt",
         [this](auto& me) { return outbox().put(me, SchoolRig::attempt("class1-36", 500), {}); }},
        {Operation::AddAttempt, "Outbox::put, exam",
         [this](auto& me) {
             return outbox().put(me, ExamStart{newUid(), "exam-36", "2026-11-20T10:00:00Z"});
         }},
        {Operation::ReadHistory, "feedbackFor",
         [this](auto& me, auto t) { return feedbackFor(s, me, personOf(me, t)); }},
        {Operation::ChangeOwnSettings, "seeFeedback",
         [this](auto& me) { return seeFeedback(s, me, SchoolRig::attempt("class1-36", 500)); }},
        {Operation::ReadHistory, "examsWithoutScore",
         [this](auto& me, auto t) { return examsWithoutScore(s, me, personOf(me, t)); }},
        {Operation::ReadHistory, "examStarts",
         [this](auto& me, auto t) { return examStarts(s, me, personOf(me, t), "exam-36"); }},
        {Operation::ReadHistory, "history", [this](auto& me, auto t) { return history(s, me, personOf(me, t), {}); }},
        {Operation::ReadHistory, "standingsOf",
         [this](auto& me, auto t) { return standingsOf(s, me, personOf(me, t)); }},
        {Operation::OpenAttempt, "openAttempt",
         [this](auto& me, auto t) { return openAttempt(s, me, attempt(me, t)); }},
        {Operation::OpenAttempt, "openRecording",
         [this](auto& me, auto t) { return openRecording(s, me, attempt(me, t)); }},
        {Operation::OpenAttempt, "readTalk", [this](auto& me, auto t) { return readTalk(s, me, attempt(me, t)); }},
        {Operation::OpenAttempt, "sheetsOfLesson",
         [this](auto& me) { return sheetsOfLesson(s, me, "class1-36", std::string(64, 'a'), 9); }},
        {Operation::CompareWithClass, "classBand",
         [this](auto& me, auto t) { return classBand(s, me, personOf(me, t), "class1-36"); }},
        {Operation::CompareWithClass, "classMedians",
         [this](auto& me, auto t) { return classMedians(s, me, personOf(me, t), "class1-36"); }},
        {Operation::CompareWithClass, "standingAmongClassmates",
         [this](auto& me) { return standingAmongClassmates(s, me, "class1-36", std::string(64, 'b'), "mouse", 700); }},
        {Operation::Comment, "addComment",
         [this](auto& me, auto t) {
             return addComment(s, me, attempt(me, t), {"well", {}, {}});
         }},
        {Operation::WithdrawComment, "withdrawComment",
         [this](auto& me, auto t) { return withdrawComment(s, me, t == Mine ? m_ownComment : m_othersComment); }},
        {Operation::Override, "overrideScore",
         [this](auto& me, auto t) { return overrideScore(s, me, attempt(me, t), 800, "as seen"); }},
        {Operation::CheckAttempt, "attemptsToCheck", [this](auto& me) { return attemptsToCheck(s, me, 10); }},
        {Operation::CheckAttempt, "noteCheck",
         [this](auto& me, auto t) { return noteCheck(s, me, attempt(me, t), Doubt::None); }},
        {Operation::ReadClass, "classOverview", [this](auto& me, auto t) { return classOverview(s, me, classOf(t)); }},
        {Operation::ReadClass, "lessonResults",
         [this](auto& me, auto t) { return lessonResults(s, me, classOf(t), "class1-36"); }},
        {Operation::ReadClass, "noteClassExport",
         [this](auto& me, auto t) { return noteClassExport(s, me, classOf(t)); }},
        {Operation::ExportAttempts, "exportAttempts",
         [this](auto& me) { return exportAttempts(s, me, [](std::string_view) { return true; }); }},
        {Operation::ListPresets, "listPresets", [this](auto& me) { return listPresets(s, me); }},
        {Operation::AddPreset, "addPreset",
         [this](auto& me) {
             return addPreset(s, me, {"mine", ++m_names, std::string(64, 'd'), "{}"});
         }},
        {Operation::ReadSettings, "readSettings", [this](auto& me) { return readSettings(s, me); }},
        {Operation::ChangeSettings, "changeSetting",
         [this](auto& me) { return changeSetting(s, me, "idle.minutes", "5"); }},
        {Operation::ChangeSettings, "raisePasswordCost",
         [this](auto& me) {
             return raisePasswordCost(s, me, {1, 8192});
         }},
        {Operation::ChangeSettings, "replaceSetting",
         [this](auto& me) { return replaceSetting(s, me, "idle.minutes", "5"); }},
        {Operation::ChangeOwnSettings, "changeOwnSetting",
         [this](auto& me) { return changeOwnSetting(s, me, "language", "de"); }},
        {Operation::ReadAudit, "readAudit", [this](auto& me) { return readAudit(s, me, 10); }},
        {Operation::KeepBackups, "mayRestore", [this](auto& me) { return mayRestore(s, me); }},
        {Operation::KeepBackups, "noteBackup",
         [this](auto& me) { return noteBackup(s, me, QStringLiteral("backup.sqlite")); }},
        {Operation::CopySchool, "copySchool",
         [this](auto& me) {
             SchoolRig other(false);
             return copySchool(s, me, other.school());
         }},
    };
};

/// Adds the engines, and a server where the school is used with the account of a station.
void addEnginesAndStation()
{
    support::addEngines();
    QTest::newRow("postgresql, account of a station") << true;
}

bool isOfStation()
{
    return QByteArray(QTest::currentDataTag()).endsWith("station");
}

}  // namespace

class TestPermissions : public QObject
{
    Q_OBJECT

private slots:
    void everyOperationAsEveryRole_data() { addEnginesAndStation(); }
    void everyOperationAsEveryRole()
    {
        COPY_OF(support::populatedSchool, rig);
        const bool isStation = isOfStation();
        if (isStation)
            rig.becomeStation();
        const Asked asked(rig);
        std::set<Operation> called;
        const std::array<const Login*, kRoles> sessions{&rig.guest, &rig.student, &rig.instructor, &rig.admin};
        for (const Call& call : asked.calls) {
            called.insert(call.operation);
            for (std::size_t role = 0; role < kRoles; ++role)
                for (const Target target : {Mine, Classmates, Strangers}) {
                    const Login& me = *sessions.at(role);
                    if (!call.hasTarget && target != Mine)
                        continue;
                    if (role == 0 && target == Mine && call.hasTarget)
                        continue;  // a guest has no data
                    const char may = kAllowed.at(call.operation)[role];
                    // Students of a teacher's class belong to the teacher too. A teacher cannot mark their own work.
                    const bool marks = call.operation == Operation::Comment || call.operation == Operation::Override;
                    const bool isOwners = isStation && (call.operation == Operation::CopySchool ||
                                                        std::string_view(call.name) == "erasePerson");
                    const bool expected =
                        !isOwners && (may == 'a' || (may != '-' && !call.hasTarget) || (may == 'o' && target == Mine) ||
                                      (may == 'c' && target != Strangers && !(marks && target == Mine)));
                    const core::Status done = call.call(me, target);
                    const QString what =
                        QStringLiteral("%1 as %2 on %3: %4")
                            .arg(QLatin1String(call.name))
                            .arg(QString::fromUtf8(roleName(static_cast<Role>(role)).data()),
                                 QLatin1String(kTargetNames.at(target)),
                                 done ? QStringLiteral("done") : QString::fromStdString(done.error().detail));
                    QVERIFY2(done.has_value() == expected, qPrintable(what));
                    // For the account of a station, rows that the user may not read do not exist.
                    const bool isHidden =
                        isStation && call.hasTarget && !expected && done.error().code == ErrorCode::UnknownName;
                    const bool isRefusedThere = isOwners && !expected && done.error().code == ErrorCode::ServerRefuses;
                    if (!expected)
                        QVERIFY2(isHidden || isRefusedThere || done.error().code == ErrorCode::NotAllowed,
                                 qPrintable(what));
                }
        }
        QCOMPARE(called.size(), kOperations);
        QCOMPARE(kAllowed.size(), kOperations);
        // The table of the program is the same.
        for (const auto& [operation, roles] : kAllowed)
            for (std::size_t role = 0; role < kRoles; ++role) {
                const Reach reach = reachOf(operation, static_cast<Role>(role));
                QCOMPARE("-oca"[static_cast<std::size_t>(reach)], roles[role]);
            }
    }

    /// Fails if a function that takes a login is missing from the calls above.
    void everyFunctionOfASessionIsAmongThem()
    {
        SchoolRig rig(support::populatedSchool(false));
        std::set<QString> called;
        const Asked asked(rig);
        for (const Call& call : asked.calls)
            called.insert(QLatin1String(call.name));
        const std::set<QString> others{
            "authorize",    "authorizeFor", "authorizeForClass",  // they do the checking
            "logout",                                             // anybody may log out
            "attemptsLeft",                                       // own attempts; a guest's are not counted
            "noteRestored"  // follows mayRestore(); the restored school may not know the user
        };
        static const QRegularExpression kTakesSession(R"(\b(\w+)\(\s*const DatabaseContext& \w+,\s*const Login& \w+)");
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

    void scoresAreGivenToStudentsOnly()
    {
        SchoolRig rig(support::populatedSchool(false));
        VERIFY_DONE(enrol(rig.school(), rig.admin, rig.first, rig.otherInstructor.person(), true));
        const AttemptId own = rig.add(rig.instructor, "class1-36", 500).value();
        for (const Login* who : {&rig.instructor, &rig.otherInstructor})
            VERIFY_REFUSED(overrideScore(rig.school(), *who, own, 1000, "neat"), ErrorCode::NotAllowed);
        // A colleague may comment on the work, but a teacher may not comment on their own.
        VERIFY_REFUSED(addComment(rig.school(), rig.instructor, own, {"neat", {}, {}}), ErrorCode::NotAllowed);
        VERIFY_DONE(addComment(rig.school(), rig.otherInstructor, own, {"neat", {}, {}}));
        const AttemptId students = rig.add(rig.student, "class1-36", 500).value();
        VERIFY_DONE(overrideScore(rig.school(), rig.otherInstructor, students, 600, "neat"));
    }

    void listsHoldOnlyWhatOneMaySee_data() { addEnginesAndStation(); }
    void listsHoldOnlyWhatOneMaySee()
    {
        COPY_OF(support::populatedSchool, rig);
        if (isOfStation())
            rig.becomeStation();
        for (const Login* who : {&rig.student, &rig.classmate, &rig.stranger})
            VERIFY_DONE(rig.add(*who, "class1-36", 700));
        const auto names = [&](const Login& me) {
            std::set<std::string> found;
            const auto people = listPeople(rig.school(), me);
            for (const Person& person : *people)
                found.insert(person.username);
            return found;
        };
        QCOMPARE(names(rig.instructor), (std::set<std::string>{"s1001", "s1002", "teach"}));
        QCOMPARE(names(rig.otherInstructor), (std::set<std::string>{"s2001", "teach2"}));
        QCOMPARE(names(rig.admin).size(), std::size_t{6});
        for (const auto& [me, attempts] :
             {std::pair(&rig.instructor, 2), std::pair(&rig.otherInstructor, 1), std::pair(&rig.admin, 3)}) {
            int exported = -1;  // without the header line
            VERIFY_DONE(exportAttempts(rig.school(), *me, [&exported](std::string_view) {
                ++exported;
                return true;
            }));
            QCOMPARE(exported, attempts);
        }
        QCOMPARE(listClasses(rig.school(), rig.student)->size(), std::size_t{1});
        QCOMPARE(listClasses(rig.school(), rig.admin)->size(), std::size_t{2});
        const auto sheets = [&](const Login& me) {
            return sheetsOfLesson(rig.school(), me, "class1-36", std::string(64, 'a'), 9)->size();
        };
        QCOMPARE(sheets(rig.student), std::size_t{1});
        QCOMPARE(sheets(rig.instructor), std::size_t{2});
    }
};

CUSP_TEST(TestPermissions)
#include "tst_permissions.moc"
