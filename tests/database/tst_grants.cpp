// SPDX-License-Identifier: GPL-3.0-or-later
// A station that logs in to a server with an account of its own: what works as before, and what the server refuses to
// other programs, whoever has logged in.
#include <algorithm>
#include <array>
#include <set>

#include <QFile>
#include <QProcess>
#include <QSqlError>
#include <QTest>
#include <QUrl>

#include "database/sql/Copy.h"
#include "database/sql/Doubts.h"
#include "database/sql/Feedback.h"
#include "database/sql/Grants.h"
#include "database/sql/Migrations.h"
#include "database/sql/Overview.h"
#include "database/sql/Presets.h"
#include "database/sql/Recordings.h"
#include "database/sql/StartedExams.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Suite.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::SchoolRig;

namespace {

/// What a statement of another program has achieved.
struct Outcome
{
    int rows = 0;   ///< returned, or changed
    QString state;  ///< of the error (SQLSTATE); empty: none

    [[nodiscard]] bool isRefused() const { return rows == 0 && (state.isEmpty() || state == u"42501"); }
    [[nodiscard]] QString words() const { return QStringLiteral("%1 rows, error %2").arg(rows).arg(state); }
};

/// Executes a statement in the name of a person, as a program could that does not check roles, and undoes it.
Outcome tryAs(const DatabaseContext& school, const Login& who, const QString& sql)
{
    if (const auto bound = authorize(school, who, Operation::ReadSettings); !bound)
        return {-1, QString::fromStdString(bound.error().detail)};
    QSqlQuery begin(school.db);
    begin.exec("BEGIN");
    QSqlQuery query(school.db);
    Outcome outcome;
    if (!query.exec(sql))
        outcome.state = query.lastError().nativeErrorCode();
    else if (query.isSelect())
        outcome.rows = query.size();
    else
        outcome.rows = query.numRowsAffected();
    QSqlQuery(school.db).exec("ROLLBACK");
    return outcome;
}

/// A statement that does what an operation does, without the program's check.
struct Attack
{
    Operation operation;
    /// Who may do it: "c" the classmate, "i" the instructor of the class, "o" that of the other, "a" the admin.
    const char* allowed;
    const char* sql;
};
constexpr std::array kAttacks{
    Attack{Operation::ChangeOwnPassword, "c",
           "SELECT 1 WHERE cusp_set_password('s1002', '{hash}', '$argon2id$v=19$m=8,t=1,p=1$' || repeat('x', 22) || "
           "'$' || repeat('y', 43) || '')"},
    Attack{Operation::ListPeople, "cia", "SELECT username FROM people WHERE username = 's1002'"},
    Attack{Operation::AddPerson, "a",
           "INSERT INTO people (uid, username, given_name, family_name, role, disabled, password_hash, reset_hash, "
           "reset_until_utc, created_utc, last_login_utc) VALUES (repeat('a', 32), 'mallory', '', '', 'admin', 0, '', "
           "'', '', '2026-11-20T10:00:00Z', '')"},
    Attack{Operation::ChangePerson, "a", "UPDATE people SET role = 'admin' WHERE username = 's1001'"},
    Attack{Operation::ChangePerson, "a", "UPDATE people SET disabled = 1 WHERE username = 's1002'"},
    Attack{Operation::ResetPassword, "a", "SELECT cusp_reset({classmate}, 'x', '2036-11-20T10:00:00Z')"},
    Attack{Operation::ListClasses, "oa", "SELECT name FROM classes WHERE id = {second}"},
    Attack{Operation::ChangeClasses, "a", "INSERT INTO classes (name) VALUES ('mine')"},
    Attack{Operation::ChangeClasses, "a", "UPDATE classes SET name = 'mine' WHERE id = {first}"},
    Attack{Operation::ChangeClasses, "a", "INSERT INTO enrolments VALUES ({second}, {student})"},
    Attack{Operation::ChangeClasses, "a", "DELETE FROM enrolments WHERE person_id = {student}"},
    Attack{Operation::ListAssignments, "oa", "SELECT lesson_id FROM assignments WHERE class_id = {second}"},
    Attack{Operation::Assign, "ia",
           "INSERT INTO assignments (class_id, lesson_id, due_utc, attempt_limit, created_by, created_utc) VALUES "
           "({first}, 'other', '', 0, {me}, '2026-11-20T10:00:00Z')"},
    Attack{Operation::Assign, "ia", "UPDATE assignments SET attempt_limit = 0 WHERE class_id = {first}"},
    Attack{Operation::Assign, "ia", "DELETE FROM assignments WHERE class_id = {first}"},
    Attack{Operation::AddAttempt, "", "INSERT INTO attempts SELECT * FROM attempts"},
    Attack{Operation::AddAttempt, "", "INSERT INTO exam_starts SELECT * FROM exam_starts"},
    Attack{Operation::AddAttempt, "", "UPDATE attempts SET score_tenths = 1000"},
    Attack{Operation::ReadHistory, "cia", "SELECT score_tenths FROM attempts WHERE person_id = {classmate}"},
    Attack{Operation::ReadHistory, "cia", "SELECT best_tenths FROM standings WHERE person_id = {classmate}"},
    Attack{Operation::ReadHistory, "cia", "SELECT begun_utc FROM exam_starts WHERE person_id = {classmate}"},
    Attack{Operation::OpenAttempt, "cia", "SELECT json FROM score_sheets WHERE attempt_id = {attempt}"},
    Attack{Operation::OpenAttempt, "cia",
           "SELECT content FROM recordings WHERE content = convert_to('recording 1', 'UTF8')"},
    Attack{Operation::OpenAttempt, "cia", "SELECT words FROM comments WHERE attempt_id = {attempt}"},
    Attack{Operation::OpenAttempt, "cia", "SELECT reason FROM overrides WHERE attempt_id = {attempt}"},
    Attack{Operation::CompareWithClass, "", "SELECT score FROM cusp_band({classmate}, 'class1-36')"},
    Attack{Operation::Comment, "i",
           "INSERT INTO comments (attempt_id, author_id, words, written_utc) VALUES ({attempt}, {me}, 'bad', "
           "'2026-11-20T10:00:00Z')"},
    Attack{Operation::Comment, "i",
           "INSERT INTO comments (attempt_id, author_id, words, written_utc) VALUES ({attempt}, {instructor}, 'bad', "
           "'2026-11-20T10:00:00Z')"},
    Attack{Operation::WithdrawComment, "i",
           "UPDATE comments SET withdrawn_utc = '2026-11-20T10:00:00Z' WHERE attempt_id = {attempt}"},
    Attack{Operation::WithdrawComment, "", "DELETE FROM comments"},
    Attack{Operation::Override, "i", "SELECT cusp_override({attempt}, 1000, 'so', '2026-11-20T10:00:00Z')"},
    Attack{Operation::Override, "",
           "INSERT INTO overrides (attempt_id, author_id, given_utc, given_tenths, reason) VALUES ({attempt}, "
           "{instructor}, '2026-11-20T10:00:00Z', 1000, 'so')"},
    Attack{Operation::Override, "", "UPDATE attempts SET given_tenths = 1000"},
    Attack{Operation::CheckAttempt, "ia", "UPDATE attempts SET doubt = '', checked = 1 WHERE id = {attempt}"},
    Attack{Operation::ReadClass, "cia", "SELECT class_id FROM enrolments WHERE person_id = {classmate}"},
    Attack{Operation::ExportAttempts, "cia",
           "SELECT a.uid FROM attempts a JOIN people p ON p.id = a.person_id WHERE p.username = 's1002'"},
    Attack{Operation::ListPresets, "", "UPDATE presets SET json = '{}'"},
    Attack{Operation::AddPreset, "a",
           "INSERT INTO presets (name, version, hash, json, author_id, created_utc) VALUES ('mine', 1, repeat('a', "
           "64), '{}', {me}, '2026-11-20T10:00:00Z')"},
    Attack{Operation::ReadSettings, "a", "SELECT value FROM settings WHERE name = 'password.decoy'"},
    Attack{Operation::ChangeSettings, "a",
           "UPDATE settings SET value = '0' WHERE owner = '' AND name = 'idle.minutes'"},
    Attack{Operation::ChangeSettings, "a", "UPDATE settings SET value = '1' WHERE name = 'password.passes'"},
    Attack{Operation::ChangeSettings, "a", "INSERT INTO settings VALUES ('', 'mine', '1')"},
    Attack{Operation::ChangeOwnSettings, "c", "UPDATE settings SET value = 'de' WHERE owner = '{classmateUid}'"},
    Attack{Operation::ChangeOwnSettings, "c", "INSERT INTO settings VALUES ('{classmateUid}', 'mine', '1')"},
    Attack{Operation::ReadAudit, "a", "SELECT detail FROM audit WHERE action = 'person.add' AND seq > 1"},
    Attack{Operation::KeepBackups, "", "SELECT password_hash FROM people"},
    Attack{Operation::KeepBackups, "", "SELECT reset_hash FROM people"},
    Attack{Operation::CopySchool, "", "SELECT token_hash FROM cusp_sessions"},
};

/// Statements that nobody may execute as a station.
constexpr std::array kForbidden{
    "UPDATE people SET password_hash = ''",
    "UPDATE people SET reset_hash = 'x'",
    "UPDATE people SET uid = repeat('b', 32)",
    "DELETE FROM people",
    "SELECT * FROM people",
    "UPDATE attempts SET passed = 1",
    "UPDATE attempts SET person_id = 1",
    "DELETE FROM attempts",
    "UPDATE score_sheets SET json = ''",
    "UPDATE standings SET best_tenths = 1000",
    "DELETE FROM standings",
    "DELETE FROM overrides",
    "DELETE FROM exam_starts",
    "DELETE FROM recordings",
    "UPDATE recordings SET content = ''",
    "DELETE FROM lesson_versions",
    "UPDATE lesson_versions SET version = 9",
    "DELETE FROM audit",
    "UPDATE audit SET actor = ''",
    "TRUNCATE audit",
    "DELETE FROM audit_seal",
    "INSERT INTO audit VALUES (cusp_audit_last() + 9, '2026-11-20T10:00:00Z', '', 'login.failed', 'x', '{}', "
    "repeat('a', 64))",
    "INSERT INTO audit VALUES (cusp_audit_last() + 1, '2026-11-20T10:00:00Z', '{instructorUid}', 'attempt.override', "
    "'x', '{}', repeat('a', 64))",
    "UPDATE audit_seal SET seq = seq + 1000",
    "INSERT INTO cusp_sessions VALUES ('x', 1, now())",
    "DELETE FROM cusp_sessions",
    "UPDATE cusp_schema SET version = 99",
    "UPDATE cusp_grants SET station = 'x'",
    "DROP TABLE audit",
    "DROP TRIGGER audit_no_change ON audit",
    "ALTER TABLE audit DISABLE TRIGGER ALL",
    "ALTER TABLE people DISABLE ROW LEVEL SECURITY",
    "ALTER TABLE people OWNER TO station",
    "CREATE TABLE mine (id integer)",
    "CREATE FUNCTION mine() RETURNS integer LANGUAGE sql AS 'SELECT 1'",
    "CREATE OR REPLACE FUNCTION cusp_person() RETURNS bigint LANGUAGE sql AS 'SELECT 1::bigint'",
    "CREATE OR REPLACE FUNCTION cusp_role() RETURNS text LANGUAGE sql AS 'SELECT ''admin'''",
    "DROP FUNCTION cusp_role() CASCADE",
    "CREATE POLICY mine ON people USING (true)",
    "DROP POLICY cusp_read ON people",
    "CREATE TRIGGER mine BEFORE INSERT ON audit EXECUTE FUNCTION audit_is_append_only()",
    "SELECT cusp_inner_open(1)",
    "SELECT cusp_inner_proven('admin', '')",
    "SET ROLE school",
    "SET SESSION AUTHORIZATION school",
    "SET track_activities = on",
    "ALTER ROLE station RESET track_activities",
};

/// A school on the server, its owner's connection, and a station with an account of its own.
class Granted
{
public:
    Granted() : m_rig(support::populatedSchool(true))
    {
        m_owner = m_rig.address();
        m_rig.becomeStation();
    }
    [[nodiscard]] SchoolRig& rig() { return m_rig; }
    [[nodiscard]] std::unique_ptr<Database> owner() const { return Database::open(m_owner).value(); }

private:
    SchoolRig m_rig;
    QString m_owner;
};

}  // namespace

class TestGrants : public QObject
{
    Q_OBJECT

private slots:
    void aProofIsTheStoredHash()
    {
        for (const char* password : {"correct horse", "", "ｆｕｌｌ width ünïcode"}) {
            const std::string hash = hashPassword(password, SchoolRig::kCheap).value();
            const std::string salt = hash.substr(0, hash.rfind('$') + 1);
            QCOMPARE(hashWithSalt(password, salt).value(), hash);
            QVERIFY(hashWithSalt("wrong", salt).value() != hash);
            QVERIFY(fits(password, hash).value());
        }
        for (const char* none : {"", "$", "$argon2id$v=19$m=8,t=1,p=1$", "$argon2id$v=19$m=8,t=1,p=1$x$",
                                 "$argon2id$v=19$m=8,t=99,p=1$c2FsdHNhbHRzYWx0c2FsdA$", "$2b$10$abc$"})
            VERIFY_REFUSED(hashWithSalt("correct horse", none), ErrorCode::OutOfRange);
    }

    void namesOfAccountsAreNoStatements()
    {
        for (const char* name : {"", "a b", "a\"; DROP TABLE people; --", "a'", "1a", "ä"})
            VERIFY_REFUSED(grantsFor(QString(name)), ErrorCode::OutOfRange);
        QVERIFY(!grantsFor("station")->contains('{'));  // nothing was left to fill in
        SchoolRig file(false);
        VERIFY_REFUSED(applyGrants(file.school().db, "station"), ErrorCode::WrongKind);
    }

    /// The administrator may run the printed text instead, again and again.
    void thePrintedTextDoesTheSame()
    {
        NEEDS_SERVER();
        Granted school;
        QTemporaryDir folder;
        QFile file(folder.filePath("grants.sql"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(grantsFor("station")->toUtf8());
        file.close();
        const QString address = school.rig().address();
        const QString host = QUrl::fromPercentEncoding(address.section(u'@', 1).section(u'/', 0, 0).toUtf8());
        const auto run = [&](const char* user) {
            QProcess psql;
            psql.start("psql",
                       {"-q", "-X", "-h", host, "-U", user, "-d", address.section(u'/', -1), "-f", file.fileName()});
            psql.waitForFinished();
            return psql.exitCode();
        };
        for (int k = 0; k < 2; ++k)
            QCOMPARE(run("school"), 0);
        QVERIFY(run("station") != 0);
        school.rig().reopen();
        VERIFY_DONE(school.rig().logIn("teach"));
    }

    void accountsThatMayDoEverythingAreRefused()
    {
        NEEDS_SERVER();
        SchoolRig rig(support::populatedSchool(true));
        for (const auto& [name, words] : {std::pair("school", "may do everything"), std::pair("nobody", "no account")})
            VERIFY_REFUSED(applyGrants(rig.school().db, name), ErrorCode::ServerRefuses, words);
        QVERIFY(!dialect::isStation(rig.school().db));
    }

    /// The account that owns the tables need not be a superuser. One of those sets track_activities.
    void theOwnerNeedsNoOtherRights()
    {
        NEEDS_SERVER();
        SchoolRig rig(true);
        rig.run({"DO $$ BEGIN CREATE ROLE station LOGIN; EXCEPTION WHEN duplicate_object THEN NULL; END $$",
                 "CREATE ROLE keeper LOGIN", "CREATE DATABASE kept OWNER keeper",
                 "ALTER ROLE station SET track_activities = off"});
        const auto addressOf = [&](const char* account) {
            return rig.address().section(u'/', 0, -2).replace("//school@", QString("//%1@").arg(account)) + "/kept";
        };
        const auto keeper = Database::open(addressOf("keeper"));
        VERIFY_DONE(keeper);
        const DatabaseContext all{(*keeper)->handle(), StationKey::make(), &QDateTime::currentDateTimeUtc,
                                  SchoolRig::kCheap};
        VERIFY_DONE(
            Logins::createFirstAdmin(all, {"admin", "", "", Role::Admin}, SchoolRig::kPassword, SchoolRig::kCheap));
        for (int k = 0; k < 2; ++k)
            VERIFY_DONE(applyGrants(all.db, "station"));
        const support::Station other(addressOf("station"));
        const DatabaseContext station = other.school();
        const auto admin = Logins::login(station, "admin", SchoolRig::kPassword);
        VERIFY_DONE(admin);
        const auto student = addPerson(station, *admin, {"s1", "", "", Role::Student});
        VERIFY_DONE(student);
        VERIFY_DONE(Logins::redeem(station, "s1", student->code, SchoolRig::kPassword));
        VERIFY_REFUSED(applyGrants(station.db, "station"), ErrorCode::ServerRefuses, "owns the tables");
        QCOMPARE(support::faultsOf(all.db), QString());
    }

    void anotherAccountTakesTheRights()
    {
        NEEDS_SERVER();
        Granted school;
        const auto owner = school.owner();
        VERIFY_DONE(execute(owner->handle(), "CREATE ROLE other_station LOGIN", "try"));
        VERIFY_DONE(applyGrants(owner->handle(), "other_station"));
        VERIFY_REFUSED(listPeople(school.rig().school(), school.rig().admin), ErrorCode::ServerRefuses);
        QCOMPARE(school.rig().count("people"), -1);
        QCOMPARE(school.rig().count("attempts"), -1);
    }

    void everydayWorkGoesOn()
    {
        NEEDS_SERVER();
        Granted school;
        SchoolRig& rig = school.rig();
        const DatabaseContext& s = rig.school();
        QVERIFY(dialect::isStation(s.db));
        QCOMPARE(Logins::isNew(s).value(), false);
        for (const auto& [name, password] :
             {std::pair("s1001", "wrong horse"), std::pair("nobody", "correct horse"), std::pair("", "")})
            VERIFY_REFUSED(rig.logIn(name, password), ErrorCode::WrongLogin);
        VERIFY_DONE(assign(s, rig.instructor, {0, rig.first, "class1-36", "", 3}));
        // Attempts arrive whoever is logged in, each once.
        VERIFY_DONE(authorize(s, rig.stranger, Operation::ReadSettings));
        const AttemptRecord made = SchoolRig::attempt("class1-36", 700);
        const AttemptId id = rig.add(rig.student, made, "recording").value();
        QCOMPARE(rig.add(rig.student, made, "recording").value().value, id.value);
        VERIFY_REFUSED(rig.add(rig.classmate, made), ErrorCode::OutOfRange);
        const std::string exam = newUid();
        for (int k = 0; k < 2; ++k)
            VERIFY_DONE(deliverExam(s, rig.student.uid(), {exam, "exam-36", "2026-11-20T10:00:00Z"}));
        QCOMPARE(examStarts(s, rig.student, rig.student.person(), "exam-36")->size(), std::size_t{1});
        const auto copied = rig.add(rig.classmate, SchoolRig::attempt("class1-36", 900), "recording");
        QCOMPARE(openAttempt(s, rig.classmate, *copied)->doubt, Doubt::Recording);
        QCOMPARE(openRecording(s, rig.student, id).value(), QByteArray("recording"));
        // The instructor comments, gives another score and checks; the student reads it.
        VERIFY_DONE(addComment(s, rig.instructor, id, {"well", {}, {}}));
        VERIFY_DONE(overrideScore(s, rig.instructor, id, 800, "as seen"));
        VERIFY_DONE(noteCheck(s, rig.instructor, id, Doubt::None));
        const auto read = openAttempt(s, rig.student, id);
        QCOMPARE(read->givenTenths, std::optional(800));
        QCOMPARE(readTalk(s, rig.student, id)->comments.front().author, std::string("Ines Teach"));
        QCOMPARE(feedbackFor(s, rig.student, rig.student.person())->size(), std::size_t{1});
        VERIFY_DONE(seeFeedback(s, rig.student, *read));
        QCOMPARE(classOverview(s, rig.instructor, rig.first)->students.size(), std::size_t{2});
        QCOMPARE(standingsOf(s, rig.student, rig.student.person())->size(), std::size_t{1});
        // Passwords: changed by the student, replaced by the admin, set by the code.
        VERIFY_DONE(Logins::changePassword(s, rig.student, SchoolRig::kPassword, "another horse"));
        QVERIFY(fits("another horse", Logins::ownHash(s, rig.student).value()).value());
        VERIFY_REFUSED(rig.logIn("s1001"), ErrorCode::WrongLogin);
        VERIFY_DONE(rig.logIn("s1001", "another horse"));
        const auto reset = resetPassword(s, rig.admin, rig.student.person());
        VERIFY_DONE(reset);
        VERIFY_REFUSED(authorize(s, rig.student, Operation::ReadSettings), ErrorCode::OtherSchool);
        VERIFY_REFUSED(rig.logIn("s1001", reset->code), ErrorCode::NewPassword);
        VERIFY_REFUSED(Logins::redeem(s, "s1001", "AAAA-BBBB-CCCC", "third horse"), ErrorCode::WrongLogin);
        const auto again = Logins::redeem(s, "s1001", reset->code, "third horse");
        VERIFY_DONE(again);
        VERIFY_REFUSED(Logins::redeem(s, "s1001", reset->code, "fourth horse"), ErrorCode::WrongLogin);
        const Entered added = addPerson(s, rig.admin, {"new", "", "", Role::Student}, {rig.first}).value();
        VERIFY_DONE(Logins::redeem(s, "new", added.code, SchoolRig::kPassword));
        VERIFY_DONE(raisePasswordCost(s, rig.admin, {2, 8192}));
        VERIFY_DONE(rig.logIn("teach"));  // rehashes
        VERIFY_DONE(rig.logIn("teach"));
        VERIFY_DONE(Logins::logout(s, *again));
        VERIFY_REFUSED(authorize(s, *again, Operation::ReadSettings), ErrorCode::OtherSchool);
        VERIFY_DONE(Logins::logout(s, *again));
        VERIFY_DONE(isOlderThan(s, auditHead(s).value(), s.now()));
        // For the owner, everything is as the audit tells.
        QCOMPARE(support::faultsOf(school.owner()->handle()), QString());
    }

    void aLoginHoldsOnOtherConnections()
    {
        NEEDS_SERVER();
        Granted school;
        SchoolRig& rig = school.rig();
        {
            support::Station other(rig.address());
            const DatabaseContext there = other.school();
            QCOMPARE(listPeople(there, rig.instructor)->size(), std::size_t{3});
            QCOMPARE(listPeople(there, rig.admin)->size(), std::size_t{6});
            // A change of the password ends it.
            VERIFY_DONE(Logins::changePassword(rig.school(), rig.instructor, SchoolRig::kPassword, "another horse"));
            VERIFY_DONE(listPeople(there, rig.instructor));
            const Login elsewhere = rig.logIn("admin").value();
            VERIFY_DONE(Logins::changePassword(there, elsewhere, SchoolRig::kPassword, "another horse"));
            VERIFY_REFUSED(listPeople(rig.school(), rig.admin), ErrorCode::OtherSchool);
        }
        rig.reopen();
        VERIFY_DONE(listPeople(rig.school(), rig.instructor));
        const auto disable = [&](int disabled) {
            const auto owner = school.owner();
            VERIFY_DONE(execute(owner->handle(), QString("UPDATE people SET disabled = %1").arg(disabled), "try"));
        };
        disable(1);
        VERIFY_REFUSED(listPeople(rig.school(), rig.instructor), ErrorCode::Disabled);
        VERIFY_REFUSED(rig.logIn("s1001"), ErrorCode::WrongLogin);
    }

    void noOperationWorksWithTheProofOfAnother()
    {
        NEEDS_SERVER();
        Granted school;
        SchoolRig& rig = school.rig();
        const DatabaseContext& s = rig.school();
        const AttemptId attempt = rig.add(rig.classmate, SchoolRig::attempt("class1-36", 700), "recording 1").value();
        VERIFY_DONE(deliverExam(s, rig.classmate.uid(), {newUid(), "exam-36", "2026-11-20T10:00:00Z"}));
        VERIFY_DONE(addComment(s, rig.instructor, attempt, {"well", {}, {}}));
        VERIFY_DONE(overrideScore(s, rig.instructor, attempt, 800, "as seen"));
        VERIFY_DONE(assign(s, rig.instructor, {0, rig.first, "class1-36", "", 3}));
        VERIFY_DONE(assign(s, rig.otherInstructor, {0, rig.second, "class1-36", "", 3}));
        VERIFY_DONE(changeSetting(s, rig.admin, "idle.minutes", "5"));
        VERIFY_DONE(changeOwnSetting(s, rig.classmate, "language", "ja"));
        VERIFY_DONE(addPreset(s, rig.admin, {"natural", 1, std::string(64, 'd'), "{}"}));
        const std::array people{std::pair('g', &rig.guest),           std::pair('s', &rig.student),
                                std::pair('c', &rig.classmate),       std::pair('i', &rig.instructor),
                                std::pair('o', &rig.otherInstructor), std::pair('a', &rig.admin)};
        std::set<Operation> tried;
        for (const Attack& attack : kAttacks) {
            tried.insert(attack.operation);
            for (const auto& [letter, who] : people) {
                QString sql = QString::fromLatin1(attack.sql);
                sql.replace("{me}", QString::number(who->person().value))
                    .replace("{student}", QString::number(rig.student.person().value))
                    .replace("{classmate}", QString::number(rig.classmate.person().value))
                    .replace("{classmateUid}", QString::fromStdString(rig.classmate.uid()))
                    .replace("{instructor}", QString::number(rig.instructor.person().value))
                    .replace("{hash}",
                             who->isGuest() ? QString() : QString::fromStdString(Logins::ownHash(s, *who).value()))
                    .replace("{first}", QString::number(rig.first.value))
                    .replace("{second}", QString::number(rig.second.value))
                    .replace("{attempt}", QString::number(attempt.value));
                const bool isAllowed = std::string_view(attack.allowed).find(letter) != std::string_view::npos;
                const Outcome outcome = tryAs(s, *who, sql);
                QVERIFY2(isAllowed ? outcome.rows > 0 : outcome.isRefused(),
                         qPrintable(QString("as %1: %2: %3").arg(QLatin1Char(letter)).arg(sql, outcome.words())));
            }
        }
        QCOMPARE(tried.size(), kOperations);
    }

    void nobodyMayDoThese()
    {
        NEEDS_SERVER();
        Granted school;
        SchoolRig& rig = school.rig();
        VERIFY_DONE(rig.add(rig.student, "class1-36", 700));
        for (const char* sql : kForbidden)
            for (const Login* who : {&rig.guest, &rig.student, &rig.admin}) {
                const Outcome outcome =
                    tryAs(rig.school(), *who,
                          QString(sql).replace("{instructorUid}", QString::fromStdString(rig.instructor.uid())));
                QVERIFY2(outcome.state == u"42501", qPrintable(QString(sql) + ": " + outcome.words()));
            }
        VERIFY_REFUSED(checkDatabase(rig.school().db, {}), ErrorCode::ServerRefuses, "cusp db check --db");
        SchoolRig file(false);
        VERIFY_REFUSED(copySchool(rig.school(), rig.admin, file.school()), ErrorCode::ServerRefuses,
                       "cusp db copy --db");
        VERIFY_REFUSED(Logins::createFirstAdmin(rig.school(), {"second", "", "", Role::Admin}, SchoolRig::kPassword,
                                                SchoolRig::kCheap),
                       ErrorCode::ServerRefuses, "cusp db init");
    }

    /// An attempt that another program delivers gets no more than the outbox would.
    void deliveringGivesNoOtherScore()
    {
        NEEDS_SERVER();
        Granted school;
        SchoolRig& rig = school.rig();
        const DatabaseContext& s = rig.school();
        VERIFY_DONE(rig.add(rig.student, "class1-36", 500));
        const auto owner = school.owner();
        const auto row = ask(owner->handle(),
                             "SELECT to_jsonb(a) || jsonb_build_object('uid', repeat('e', 32), 'given_tenths', 1000, "
                             "'checked', 1, 'id', 1) FROM attempts a",
                             "look");
        VERIFY_DONE(execute(s.db, "SELECT cusp_deliver_attempt(CAST(? AS jsonb), '')", "try", {*row}));
        QCOMPARE(ask(owner->handle(),
                     "SELECT count(*) FROM attempts WHERE uid = repeat('e', 32) AND given_tenths IS NULL AND checked = "
                     "0 AND id <> 1",
                     "look")
                     ->toInt(),
                 1);
        const auto again = ask(s.db, "SELECT is_new FROM cusp_deliver_attempt(CAST(? AS jsonb), '')", "try", {*row});
        QVERIFY(again && !again->toBool());
        // A recording that the server does not have proves nothing, and neither does another one under its hash.
        const auto found = ask(s.db,
                               "SELECT doubt FROM cusp_deliver_attempt(CAST(? AS jsonb) || jsonb_build_object('uid', "
                               "repeat('d', 32), 'recording_hash', repeat('c', 64)), '')",
                               "try", {*row});
        QCOMPARE(found->toString(), QString("recording"));
        const std::string hash(64, 'c');
        VERIFY_REFUSED(recordingOf(owner->handle(), hash), ErrorCode::BadStructure);
        VERIFY_DONE(execute(s.db, "INSERT INTO recordings (hash, content) VALUES (repeat('c', 64), 'garbage')", "try"));
        VERIFY_REFUSED(recordingOf(owner->handle(), hash), ErrorCode::BadStructure);
    }

    /// A hash that no program can compare would tell unknown names apart, or keep its person out.
    void onlyHashesOfPasswordsAreStored()
    {
        NEEDS_SERVER();
        Granted school;
        const DatabaseContext& s = school.rig().school();
        const QString sound = "$argon2id$v=19$m=65536,t=2,p=1$" + QString(22, 'A') + '$' + QString(43, 'B');
        const auto isHash = [&](const QString& hash) {
            return ask(school.owner()->handle(), "SELECT cusp_inner_is_hash(?)", "try", {hash})->toBool();
        };
        QVERIFY(isHash(sound));
        QVERIFY(!isHash(QString(sound).replace("m=65536", "m=9999999")));
        QVERIFY(!isHash(QString(sound).replace("t=2", "t=99")));
        QVERIFY(!isHash(QString(sound).replace("p=1", "p=4")));
        QVERIFY(!isHash(sound + "BBBB"));
        QVERIFY(!isHash("$argon2id$" + QString(1000, 'B')));
        // Nobody but the server's own functions may ask, with the privileges or without.
        QVERIFY(!execute(s.db, "SELECT cusp_inner_open(1)", "try"));
        VERIFY_DONE(
            execute(school.owner()->handle(), "GRANT EXECUTE ON ALL FUNCTIONS IN SCHEMA public TO PUBLIC", "try"));
        QVERIFY(!execute(s.db, "SELECT cusp_inner_open(1)", "try"));
    }

    /// As on a server before PostgreSQL 15: what stations create there, others would call.
    void aSchemaWhereAllMayCreateIsRefused()
    {
        NEEDS_SERVER();
        Granted school;
        const auto owner = school.owner();
        const auto run = [&](const char* statement) {
            VERIFY_DONE(execute(owner->handle(), QLatin1String(statement), "try"));
        };
        run("GRANT CREATE ON SCHEMA public TO station");
        VERIFY_DONE(applyGrants(owner->handle(), "station"));
        QVERIFY(!execute(school.rig().school().db, "CREATE TABLE t (x integer)", "try"));
        QVERIFY(!execute(school.rig().school().db, "CREATE TEMP TABLE t (x integer)", "try"));
        // This cannot be taken away by a REVOKE from the account or from everybody.
        run("CREATE ROLE makers");
        run("GRANT CREATE ON SCHEMA public TO makers");
        run("GRANT makers TO station");
        const core::Status refused = applyGrants(owner->handle(), "station");
        QVERIFY(!refused && refused.error().detail.find("may create functions") != std::string::npos);
        QVERIFY(refused.error().detail.find("CONTEXT") == std::string::npos);
        run("REVOKE makers FROM station");
        run("DROP OWNED BY makers");
        run("DROP ROLE makers");
        VERIFY_DONE(applyGrants(owner->handle(), "station"));
    }

    /// Names that exist and names that do not look alike.
    void saltsTellNoNames()
    {
        NEEDS_SERVER();
        Granted school;
        std::set<QString> salts;
        const auto saltOf = [&](const char* name) {
            return ask(school.rig().school().db, "SELECT uid || ' ' || salt FROM cusp_salt(?)", "ask", {QString(name)})
                .value()
                .toString();
        };
        static const QRegularExpression kForm("^[0-9a-f]{32} \\$argon2id\\$v=19\\$m=8,t=1,p=1\\$[A-Za-z0-9+/]{22}\\$$");
        for (const char* name : {"admin", "s1001", "s1002", "nobody", "somebody", ""}) {
            QVERIFY2(kForm.match(saltOf(name)).hasMatch(), qPrintable(saltOf(name)));
            QCOMPARE(saltOf(name), saltOf(name));
            salts.insert(saltOf(name).section(u' ', 1));
        }
        QCOMPARE(salts.size(), std::size_t{6});
    }

    /// A false server could ask for one, and guess the password from it.
    void aCheapProofIsNotGiven()
    {
        NEEDS_SERVER();
        Granted school;
        DatabaseContext careful = school.rig().school();
        careful.leastCost = {2, 8192};
        VERIFY_REFUSED(Logins::login(careful, "s1001", SchoolRig::kPassword), ErrorCode::ServerRefuses, "guessed");
    }

    void otherStationsDoNotSeeStatements()
    {
        NEEDS_SERVER();
        Granted school;
        const auto seen =
            ask(school.rig().school().db,
                "SELECT count(*) FROM pg_stat_activity WHERE usename = 'station' AND query <> ''", "look");
        QCOMPARE(seen->toInt(), 0);
        // A server where they could is refused before a proof is sent.
        const auto owner = school.owner();
        VERIFY_DONE(execute(owner->handle(), "ALTER ROLE station SET track_activities = on", "try"));
        school.rig().reopen();
        VERIFY_REFUSED(school.rig().logIn("s1001"), ErrorCode::ServerRefuses, "track_activities");
        VERIFY_DONE(execute(owner->handle(), "ALTER ROLE station SET track_activities = off", "try"));
    }

    /// No table and no function is left open by mistake.
    void nothingIsLeftOpen()
    {
        NEEDS_SERVER();
        Granted school;
        const auto owner = school.owner();
        const auto none = [&](const QString& sql) {
            QStringList found;
            VERIFY_DONE(forEach(owner->handle(), sql, "look", {},
                                [&found](const QSqlQuery& row) { found << row.value(0).toString(); }));
            QCOMPARE(found.join(u' '), QString());
        };
        const QString functions = "SELECT proname FROM pg_proc WHERE pronamespace = current_schema()::regnamespace AND "
                                  "starts_with(proname::text, 'cusp_') AND ";
        none(functions + "NOT EXISTS (SELECT 1 FROM unnest(proconfig) c WHERE c = 'search_path=public, pg_temp')");
        none(functions + "has_function_privilege('public', oid, 'EXECUTE')");
        none(functions +
             "starts_with(proname::text, 'cusp_inner_') = has_function_privilege('station', oid, 'EXECUTE')");
        const QString tables = "SELECT relname FROM pg_class WHERE relnamespace = current_schema()::regnamespace AND "
                               "relkind IN ('r', 'p', 'v', 'm', 'f') AND ";
        none(tables + "NOT relrowsecurity");
        none(tables + "has_table_privilege('station', oid, 'TRUNCATE, TRIGGER, REFERENCES')");
        none(tables + "has_table_privilege('public', oid, 'SELECT, INSERT, UPDATE, DELETE')");
    }

    void comparisonsWithTheClassAreTheSame()
    {
        NEEDS_SERVER();
        Granted school;
        SchoolRig& rig = school.rig();
        for (int k = 0; k < 5; ++k) {
            const Entered entered =
                addPerson(rig.school(), rig.admin, {"m" + std::to_string(k), "", "", Role::Student}, {rig.first})
                    .value();
            AttemptRecord attempt = SchoolRig::attempt("class1-36", 500 + 50 * k);
            attempt.personUid = entered.person.uid;
            VERIFY_DONE(deliverAttempt(rig.school(), attempt, {}));
        }
        VERIFY_DONE(rig.add(rig.student, "class1-36", 620));
        VERIFY_DONE(rig.add(rig.stranger, "class1-36", 900));
        const auto owner = school.owner();
        DatabaseContext all{owner->handle(), StationKey::make()};
        for (const Login* who : {&rig.student, &rig.stranger, &rig.instructor, &rig.admin}) {
            const PersonId person = who == &rig.stranger ? rig.stranger.person() : rig.student.person();
            const auto standing = [&](const DatabaseContext& s) {
                return standingAmongClassmates(s, *who, "class1-36", std::string(64, 'b'), "mouse", 700).value();
            };
            QVERIFY(standing(rig.school()) == standing(all));
            const auto medians = [&](const DatabaseContext& s) {
                return classMedians(s, *who, person, "class1-36").value();
            };
            QVERIFY(medians(rig.school()) == medians(all));
            const auto band = [&](const DatabaseContext& s) { return classBand(s, *who, person, "class1-36").value(); };
            QVERIFY(band(rig.school()) == band(all));
        }
        QVERIFY(classMedians(rig.school(), rig.student, rig.student.person(), "class1-36")->has_value());
        // In a class of two, the scores of others are hidden from other programs too.
        QCOMPARE(tryAs(rig.school(), rig.stranger,
                       "SELECT * FROM cusp_bests('class1-36', repeat('b', 64), 'mouse') b "
                       "WHERE b NOT IN (0, 900)")
                     .rows,
                 0);
    }

    /// A migration may add tables and columns.
    void migrationsGrantAgain()
    {
        NEEDS_SERVER();
        Granted school;
        const auto owner = school.owner();
        auto steps = shippedMigrations().value();
        const QString policies = "SELECT count(*) FROM pg_policies";
        const int before = ask(owner->handle(), policies, "look")->toInt();
        // A policy names this column.
        steps.push_back(
            {static_cast<int>(steps.size()) + 1, "ALTER TABLE settings ALTER COLUMN name TYPE varchar(100);"});
        VERIFY_DONE(migrate(owner->handle(), steps));
        QCOMPARE(ask(owner->handle(), policies, "look")->toInt(), before);
        QCOMPARE(ask(owner->handle(), "SELECT schema FROM cusp_grants", "look")->toInt(), steps.back().number);
        // A migration that fails leaves the rights as they were.
        auto more = steps;
        more.push_back({steps.back().number + 1, "DROP TABLE nowhere;"});
        QVERIFY(!migrate(owner->handle(), more));
        QCOMPARE(ask(owner->handle(), policies, "look")->toInt(), before);
        // A station changes nothing.
        VERIFY_DONE(execute(owner->handle(), "UPDATE cusp_grants SET schema = 1", "try"));
        VERIFY_DONE(migrate(school.rig().school().db, steps));
    }
};

CUSP_TEST(TestGrants)
#include "tst_grants.moc"
