// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include <QSqlError>
#include <QSqlQuery>
#include <QTest>

#include "database/sql/Check.h"
#include "database/sql/Dialect.h"
#include "database/sql/Presets.h"
#include "database/sql/StartedExams.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::addAttempt;
using support::SchoolRig;

namespace {

/// All columns of a row except its number.
const QString kColumns = QStringLiteral("at_utc, actor, action, object, detail, hash FROM audit");

}  // namespace

class TestAudit : public QObject
{
    Q_OBJECT

private slots:
    void cleanupTestCase()
    {
        m_chains = {};
        m_full = {};
    }

    void aSoundChainHasNoFindings_data() { support::addEngines(); }
    void aSoundChainHasNoFindings()
    {
        SCHOOL_RIG(rig);
        // On PostgreSQL, a schema with the name of the server's user comes first in the search path, before the schema
        // of the tables.
        if (onServer)
            rig.run({"CREATE SCHEMA school"});
        QVERIFY(checkAudit(rig.school().db, {})->empty());
        QCOMPARE(auditHead(rig.school())->code(), std::string("0"));
        rig.populate();
        std::vector<std::string> witnesses;
        for (int k = 0; k < 6; ++k) {
            work(rig, 1);
            witnesses.push_back(auditHead(rig.school())->code());
            QVERIFY(readAuditCode(witnesses.back()));
        }
        const auto report = checkDatabase(rig.school().db, witnesses);
        VERIFY_DONE(report);
        QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
        QVERIFY(report->isWhole && !report->isStopped && report->notes.empty());
        QCOMPARE(report->auditRows, auditHead(rig.school())->seq);
        QCOMPARE(report->auditCode, witnesses.back());
        QCOMPARE(report->signedBy, rig.school().key.publicHex());
        const auto newest = readAudit(rig.school(), rig.admin, 5);
        VERIFY_DONE(newest);
        QCOMPARE(newest->size(), std::size_t{5});
        QCOMPARE(newest->front().action, std::string("attempt.add"));
        const auto others = readAudit(rig.school(), rig.admin, 5, 0, AuditRows::WithoutAttempts);
        VERIFY_DONE(others);
        QCOMPARE(others->size(), std::size_t{5});
        for (const AuditRow& row : *others)
            QVERIFY2(row.action != "attempt.add" && row.action != "exam.begin", row.action.c_str());
        QVERIFY(others->front().seq < newest->back().seq);
        QCOMPARE(readAudit(rig.school(), rig.admin, 5, others->back().seq, AuditRows::WithoutAttempts)->front().seq,
                 others->back().seq - 1);
    }

    void theDatabaseItselfRefusesChanges_data() { support::addEngines(); }
    void theDatabaseItselfRefusesChanges()
    {
        COPY_OF(support::populatedSchool, rig);
        QSqlQuery query(rig.school().db);
        for (const char* sql : {"UPDATE audit SET actor = ''", "DELETE FROM audit WHERE seq = 2", "DELETE FROM presets",
                                "UPDATE overrides SET reason = ''"})
            if (query.exec(QLatin1String(sql)))
                QVERIFY2(query.numRowsAffected() == 0, sql);
        QVERIFY(checkAudit(rig.school().db, {})->empty());
    }

    void theFirstBadRowIsNamed_data()
    {
        support::columns<bool, QStringList, QString>("onServer", "deeds", "finding");
        const auto row = [](const char* name, const QStringList& deeds, const char* finding, bool onServer = false) {
            QTest::addRow("%s, %s", name, onServer ? "postgresql" : "sqlite") << onServer << deeds << finding;
        };
        for (const bool onServer : {false, true}) {
            row("changed", {"UPDATE audit SET action = 'login' WHERE seq = 9"}, "row 9 (", onServer);
            row("removed", {"DELETE FROM audit WHERE seq = 9"}, "row 9 was removed", onServer);
            row("end cut off", {"DELETE FROM audit WHERE seq > 27"}, "row 28 was removed", onServer);
        }
        row("changed first", {"UPDATE audit SET actor = 'x' WHERE seq = 1"}, "row 1 (");
        row("changed last", {"UPDATE audit SET detail = '{}' WHERE seq = 30"}, "row 30 (");
        row("two changed", {"UPDATE audit SET at_utc = '2020-01-01T00:00:00Z' WHERE seq IN (7, 12)"}, "row 7 (");
        row("some removed", {"DELETE FROM audit WHERE seq BETWEEN 9 AND 11"}, "row 9 was removed");
        row("all removed", {"DELETE FROM audit"}, "row 1 was removed");
        row("removed, renumbered",
            {"DELETE FROM audit WHERE seq = 9", "UPDATE audit SET seq = seq + 999 WHERE seq > 9",
             "UPDATE audit SET seq = seq - 1000 WHERE seq > 1000"},
            "row 9 (");
        row("inserted, renumbered",
            {"UPDATE audit SET seq = seq + 1001 WHERE seq > 9", "UPDATE audit SET seq = seq - 1000 WHERE seq > 1000",
             "INSERT INTO audit SELECT 10, at_utc, actor, 'login', object, detail, hash FROM audit WHERE seq = 3"},
            "row 10 (");
        row("appended", {"INSERT INTO audit SELECT 31, " + kColumns + " WHERE seq = 3"}, "row 31 (");
        row("other numbers", {"UPDATE audit SET seq = seq + 1000 WHERE seq > 9"}, "row 10 was removed");
        row("exchanged",
            {"UPDATE audit SET seq = 1021 - seq WHERE seq IN (7, 14)",
             "UPDATE audit SET seq = seq - 1000 WHERE seq > 1000"},
            "row 7 (");
        row("head gone", {"DELETE FROM audit_seal"}, "signed head of the audit was removed");
        row("head set back", {"UPDATE audit_seal SET seq = 10, hash = (SELECT hash FROM audit WHERE seq = 10)"},
            "no signature covers audit row 11:");
        row("head far away", {"UPDATE audit_seal SET seq = 5000"}, "row 31 was removed");
        row("signature in capitals", {"UPDATE audit_seal SET signature = upper(signature)"}, "signature");
        row("signature of another", {"UPDATE audit_seal SET signature = '" + QString(128, '0') + "'"}, "signature");
    }

    void theFirstBadRowIsNamed()
    {
        QFETCH(QStringList, deeds);
        QFETCH(QString, finding);
        COPY_OF(chain, rig);
        QCOMPARE(auditHead(rig.school())->seq, 30);
        QCOMPARE(chainFault(rig.school()), QString());
        rig.run(deeds);
        const QString said = chainFault(rig.school());
        QVERIFY2(said.contains(finding) && !said.contains('\n'), qPrintable(said));
    }

    void goingOnMakesNothingGood_data()
    {
        support::columns<bool, QStringList, QString>("onServer", "deeds", "finding");
        QTest::newRow("a row behind the head")
            << false << QStringList{"INSERT INTO audit SELECT 31, " + kColumns + " WHERE seq = 3"} << "row 31 (";
        const QString back = "UPDATE audit_seal SET seq = 20, hash = (SELECT hash FROM audit WHERE seq = 20)";
        for (const bool onServer : {false, true})
            QTest::addRow("the end is cut off, %s", onServer ? "postgresql" : "sqlite")
                << onServer << QStringList{"DELETE FROM audit WHERE seq > 20", back} << "row 21 (";
        QTest::newRow("the head is set back") << false << QStringList{back} << "row 31 (";
        QTest::newRow("the head is far away")
            << false << QStringList{"UPDATE audit_seal SET seq = 5000"} << "row 31 was removed";
    }

    /// Damages the chain and logs in: the station notes once that the chain does not end as it was signed, and the
    /// finding remains.
    void goingOnMakesNothingGood()
    {
        QFETCH(QStringList, deeds);
        QFETCH(QString, finding);
        COPY_OF(chain, rig);
        rig.run(deeds);
        static_cast<void>(rig.logIn("s1001", "wrong"));
        VERIFY_DONE(rig.logIn("s1001"));
        const QString said = chainFault(rig.school());
        QVERIFY2(said.contains(finding), qPrintable(said));
        const auto rows = readAudit(rig.school(), rig.admin, 4);
        QCOMPARE(
            std::count_if(rows->begin(), rows->end(), [](const AuditRow& row) { return row.action == "audit.broken"; }),
            1);
        QVERIFY(readAuditCode(auditHead(rig.school())->code()));
    }

    void aRowAtTheEndOfNumbersLetsNobodyWrite()
    {
        SchoolRig rig(chain(false));
        rig.run({QStringLiteral("INSERT INTO audit SELECT %1, %2 WHERE seq = 30")
                     .arg(std::numeric_limits<qint64>::max())
                     .arg(kColumns)});
        VERIFY_REFUSED(rig.add(rig.student, "class1-36", 500), ErrorCode::BadStructure);
        QVERIFY2(chainFault(rig.school()).contains("row 31 was removed"), qPrintable(chainFault(rig.school())));
    }

    void aReportOfAnotherChainIsFound()
    {
        SchoolRig rig(chain(false));
        const std::string code = auditHead(rig.school())->code();
        QCOMPARE(chainFault(rig.school(), {code}), QString());
        QVERIFY(chainFault(rig.school(), {"3-000000000000"}).contains("row 3 ("));
        QVERIFY(chainFault(rig.school(), {"31-000000000000"}).contains("row 31, which a report names, is not there"));
        QVERIFY(!chainFault(rig.school(), {"nonsense"}).isEmpty());
        // Someone with access to the file changes a row and signs the chain again. The code of a printed report still
        // reveals it.
        const auto newest = readAudit(rig.school(), rig.admin, 2);
        AuditRow row = newest->front();
        row.actor = "nobody";
        const QString hash = QString::fromStdString(hashOf(row, newest->back().hash));
        rig.run({QStringLiteral("UPDATE audit SET actor = 'nobody', hash = '%1' WHERE seq = 30").arg(hash)});
        QVERIFY(chainFault(rig.school()).contains("row 30 (") && chainFault(rig.school()).contains("that was signed"));
        rig.run({QStringLiteral("UPDATE audit_seal SET hash = '%1', signature = '%2'")
                     .arg(hash, QString::fromStdString(rig.school().key.sign("cusp audit 30 " + hash.toStdString())))});
        QCOMPARE(chainFault(rig.school()), QString());
        QVERIFY(chainFault(rig.school(), {code}).contains("is not the one that a report names"));
    }

    /// The end of the chain is removed, and the rest is signed with a key made for the purpose.
    void aStationThatNeverJoinedIsFound()
    {
        SchoolRig rig(chain(false));
        const auto joined = readAudit(rig.school(), rig.admin, 1, 2);
        QCOMPARE(joined->front().action, std::string("station.join"));
        QCOMPARE(joined->front().object, "station:" + rig.school().key.publicHex());
        const StationKey stranger = StationKey::make();
        const std::string hash = readAudit(rig.school(), rig.admin, 1, 9)->front().hash;
        rig.run({"DELETE FROM audit WHERE seq > 8",
                 QStringLiteral("UPDATE audit_seal SET seq = 8, hash = '%1', station_key = '%2', signature = '%3'")
                     .arg(QString::fromStdString(hash), QString::fromStdString(stranger.publicHex()),
                          QString::fromStdString(stranger.sign("cusp audit 8 " + hash)))});
        QVERIFY(chainFault(rig.school())
                    .contains("signed with the key " + QString::fromStdString(stranger.publicHex()).left(12)));
        static_cast<void>(rig.logIn("admin"));
        QVERIFY(chainFault(rig.school()).contains("did not end as they had been signed"));
    }

    /// The chain and its signature are valid, but the key is not this computer's.
    void whoeverElseSignsIsNamed()
    {
        SchoolRig rig(support::populatedSchool(false));
        const std::string own = rig.school().key.publicHex();
        QVERIFY(checkDatabase(rig.school().db, {}, {}, own)->findings.empty());
        const DatabaseContext stranger{rig.school().db, StationKey::make()};
        VERIFY_DONE(addAttempt(stranger, rig.student, SchoolRig::attempt("class1-36", 1000), {}));
        QVERIFY(checkDatabase(rig.school().db, {})->findings.empty());
        const auto report = checkDatabase(rig.school().db, {}, {}, own);
        QCOMPARE(report->findings.size(), std::size_t{1});
        QVERIFY(support::wordsOf(report->findings).contains("not this computer's"));
    }

    void whatStandsElsewhereIsAsItWasNoted_data()
    {
        support::columns<bool, QString, QString>("onServer", "deed", "finding");
        const auto row = [](const char* name, const QString& deed, const char* finding, bool onServer = false) {
            QTest::addRow("%s, %s", name, onServer ? "postgresql" : "sqlite") << onServer << deed << finding;
        };
        for (const bool onServer : {false, true}) {
            row("a comment changed", "UPDATE comments SET words = 'well done'",
                "table comments differs from the audit: the row of attempt:", onServer);
            row("a role", "UPDATE people SET role = 'admin' WHERE username = 's1001'",
                "table people differs from the audit: the row of person:", onServer);
            row("a limit", "UPDATE assignments SET attempt_limit = 0",
                "table assignments differs from the audit: the row of class:", onServer);
            row("an attempt changed", "UPDATE attempts SET score_tenths = 1000 WHERE score_tenths = 600",
                "was changed after it had been kept", onServer);
        }
        row("an attempt made nobody's", "UPDATE attempts SET person_id = NULL WHERE score_tenths = 600",
            "was removed; row");
        row("a score nobody gave", "UPDATE attempts SET given_tenths = 1000 WHERE given_tenths IS NULL",
            "table attempts differs");
        row("a score that was given", "UPDATE attempts SET given_tenths = 999 WHERE given_tenths = 900",
            "table attempts differs");
        row("a score taken back", "UPDATE attempts SET given_tenths = NULL WHERE given_tenths = 900",
            "table attempts differs");
        row("an override slipped in",
            "INSERT INTO overrides (attempt_id, author_id, given_utc, given_tenths, reason) SELECT attempt_id, "
            "author_id, given_utc, 1000, reason FROM overrides",
            "table overrides differs");
        row("an override of another day", "UPDATE overrides SET given_utc = '2020-01-01T00:00:00Z'",
            "table overrides differs");
        row("a comment slipped in",
            "INSERT INTO comments (attempt_id, author_id, written_utc, words) SELECT attempt_id, author_id, "
            "written_utc, 'well done' FROM comments",
            "table comments differs");
        row("a comment moved to another place", "UPDATE comments SET x_um = x_um + 1000", "table comments differs");
        row("a comment moved to another moment", "UPDATE comments SET moment_ms = 1", "table comments differs");
        row("a comment of another day", "UPDATE comments SET written_utc = '2020-01-01T00:00:00Z'",
            "table comments differs");
        row("a comment hidden", "UPDATE comments SET withdrawn_utc = '2026-11-20T10:15:00Z' WHERE words = 'too deep'",
            "table comments differs");
        row("a comment brought back", "UPDATE comments SET withdrawn_utc = NULL WHERE words = 'of another'",
            "table comments differs");
        row("a comment gone", "DELETE FROM comments", "table comments differs");
        row("a preset slipped in",
            "INSERT INTO presets (name, version, hash, json, author_id, created_utc) SELECT 'soft', 9, hash, json, "
            "author_id, created_utc FROM presets",
            "table presets differs from the audit: the row of preset:soft v9");
        row("a preset's values", "UPDATE presets SET json = '[]'", "the row of preset:soft v1");
        row("a preset of another's", "UPDATE presets SET author_id = NULL", "the row of preset:soft v1");
        row("a setting changed", "UPDATE settings SET value = '999' WHERE name = 'idle.minutes'",
            "table settings differs from the audit: the row of setting:idle.minutes");
        row("what passwords cost", "UPDATE settings SET value = '7' WHERE name = 'password.passes'",
            "the row of setting:password.passes");
        row("a setting slipped in", "INSERT INTO settings (owner, name, value) VALUES ('', 'idle.hours', '9999')",
            "the row of setting:idle.hours");
        row("an exam of another day", "UPDATE exam_starts SET begun_utc = '2020-01-01T00:00:00Z'",
            "table exam_starts differs from the audit: the row of exam:");
        row("another's password",
            "UPDATE people SET password_hash = (SELECT password_hash FROM people WHERE username = 's1001') WHERE "
            "username = 'admin'",
            "table people differs");
        row("a password nobody can read",
            "UPDATE people SET password_hash = replace(password_hash, 'argon2id', 'argon2ie') WHERE username = 'admin'",
            "table people differs");
        row("a code that is good for ever",
            "UPDATE people SET reset_until_utc = '9999-01-01T00:00:00Z' WHERE username = 's1003'",
            "table people differs");
        row("a code nobody gave",
            QStringLiteral("UPDATE people SET reset_hash = '%1' WHERE username = 's1001'").arg(QString(64, 'e')),
            "table people differs");
        row("let in again", "UPDATE people SET disabled = 0 WHERE username = 's2001'", "table people differs");
        row("another user's name", "UPDATE people SET username = 's1009' WHERE username = 's1002'",
            "table people differs");
        row("another family name", "UPDATE people SET family_name = 'Else' WHERE username = 's1002'",
            "table people differs");
        row("an assignment of another's",
            "UPDATE assignments SET created_by = (SELECT id FROM people WHERE username = 'teach2')",
            "table assignments differs");
        row("an assignment gone", "DELETE FROM assignments", "table assignments differs");
        row("a class renamed", "UPDATE classes SET name = 'DEN999' WHERE name = 'DEN101-B'",
            "table classes differs from the audit: the row of class:");
        row("put into a class",
            "INSERT INTO enrolments (class_id, person_id) SELECT c.id, p.id FROM classes c, people p WHERE c.name = "
            "'DEN101-B' AND p.username = 's1001'",
            "table enrolments differs from the audit: the row of person:");
        row("taken out of a class",
            "DELETE FROM enrolments WHERE person_id = (SELECT id FROM people WHERE username = 's1002')",
            "table enrolments differs");
        row("a recording gone", QStringLiteral("UPDATE attempts SET recording_hash = '%1'").arg(QString(64, 'd')),
            "is not there any more");
        row("standings gone", "DELETE FROM standings", "has attempts in class1-36 and no standing");
        row("last activity", "UPDATE standings SET last_utc = '2020-01-01T00:00:00Z'", "do not add up to");
        row("a standing passed", "UPDATE standings SET passed = 1 WHERE passed = 0", "do not add up to");
    }

    void whatStandsElsewhereIsAsItWasNoted()
    {
        QFETCH(QString, deed);
        QFETCH(QString, finding);
        COPY_OF(fullSchool, rig);
        QSqlQuery query(rig.school().db);
        QVERIFY2(query.exec(deed), qPrintable(query.lastError().text()));
        QVERIFY(query.numRowsAffected() > 0);
        const QString said = support::faultsOf(rig.school().db);
        QVERIFY2(said.contains(finding), qPrintable(said));
    }

    /// If a row of the audit was removed, the change that it noted is reported with the remark that it may be
    /// legitimate.
    void whatALostRowNotedMayBeRight()
    {
        SchoolRig rig(chain(false));
        rig.run({"DELETE FROM audit WHERE seq = 30"});
        const auto report = checkDatabase(rig.school().db, {});
        VERIFY_DONE(report);
        QCOMPARE(report->auditRows, 29);
        const QString said = support::wordsOf(report->findings);
        QVERIFY2(said.contains("row 30 was removed") && said.contains("is not noted in the audit"), qPrintable(said));
        QVERIFY(support::wordsOf(report->notes).contains("the audit itself was changed"));
    }

    void attemptsFromBeforeThereWerePeopleAreNoFinding()
    {
        SchoolRig rig(false);
        rig.run({"INSERT INTO attempts (finished_utc, tooth, duration_ms, state_hash, score_tenths, uid) VALUES "
                 "('2026-03-01T10:00:00Z', '36', 1000, '0123456789abcdef', 820, 'legacy-1')",
                 "INSERT INTO score_sheets SELECT id, '{}' FROM attempts"});
        const auto report = checkDatabase(rig.school().db, {});
        VERIFY_DONE(report);
        QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
        QCOMPARE(report->attempts, 1);
    }

    void whatGuardsIsThere_data()
    {
        support::columns<bool, QString, QString>("onServer", "deed", "finding");
        QTest::newRow("sqlite") << false << "DROP TRIGGER audit_no_delete"
                                << "trigger audit_no_delete is no longer there";
        QTest::newRow("postgresql") << true << "DROP TRIGGER audit_no_change ON audit"
                                    << "trigger audit_no_change is no longer there";
        QTest::newRow("switched off") << true << "ALTER TABLE overrides DISABLE TRIGGER overrides_no_change"
                                      << "trigger overrides_no_change is no longer there";
        QTest::newRow("for copies only") << true << "ALTER TABLE audit ENABLE REPLICA TRIGGER audit_no_change"
                                         << "trigger audit_no_change is no longer there";
    }

    void whatGuardsIsThere()
    {
        QFETCH(QString, deed);
        QFETCH(QString, finding);
        SCHOOL_RIG(rig);
        QCOMPARE(support::faultsOf(rig.school().db), QString());
        rig.run({deed});
        const QString said = support::faultsOf(rig.school().db);
        QVERIFY2(said.contains(finding) && !said.contains('\n'), qPrintable(said));
    }

    void theCheckSaysWhatItCouldNotLookAt()
    {
        SchoolRig rig(support::populatedSchool(false));
        work(rig, 1);
        rig.run({"UPDATE attempts SET score_tenths = 999", "DROP TABLE exam_starts"});
        const auto report = checkDatabase(rig.school().db, {});
        VERIFY_DONE(report);
        QVERIFY(!report->isWhole);
        const QString said = support::wordsOf(report->findings);
        for (const char* words : {"table exam_starts is no longer there", "was changed after it had been kept",
                                  "the check could not go on"})
            QVERIFY2(said.contains(words), qPrintable(said));
        QCOMPARE(report->auditCode, auditHead(rig.school())->code());
    }

    /// Who has the key of a station can write rows that are signed well, but not in the name of their own role.
    void anActIsComparedWithTheRoleOfItsActor_data() { support::addEngines(); }
    void anActIsComparedWithTheRoleOfItsActor()
    {
        COPY_OF(support::populatedSchool, rig);
        const DatabaseContext& school = rig.school();
        const auto forge = [&](const std::string& actor, const std::string& action, const std::string& object,
                               const QJsonObject& detail) {
            return inTurn(school, "forge", [&] { return note(school, actor, action, object, detail); });
        };
        rig.run({"INSERT INTO settings (owner, name, value) VALUES ('', 'idle.minutes', '999')"});
        VERIFY_DONE(forge(rig.student.uid(), "setting.change", "setting:idle.minutes", {{"value", "999"}}));
        QString said = support::faultsOf(school.db);
        QVERIFY2(said.contains("did not permit setting.change") && !said.contains('\n'), qPrintable(said));
        rig.run({QStringLiteral("INSERT INTO classes (name) VALUES ('forged')")});
        VERIFY_DONE(forge(rig.instructor.uid(), "class.add",
                          "class:" + ask(school.db, "SELECT max(id) FROM classes", "x")->toString().toStdString(),
                          {{"name", "forged"}}));
        said = support::faultsOf(school.db);
        QVERIFY2(said.contains("did not permit class.add") && said.count('\n') == 1, qPrintable(said));
        // The roles of that time count: an admin who is none any more has acted as one.
        VERIFY_DONE(addPerson(school, rig.admin, {"second", "", "", Role::Admin}));
        Person second = findPerson(school, rig.admin, "second").value();
        VERIFY_DONE(forge(second.uid, "class.add", "class:77", {{"name", "x"}}));
        second.role = Role::Student;
        VERIFY_DONE(changePerson(school, rig.admin, second));
        QVERIFY(!support::faultsOf(school.db).contains(QString::fromStdString(second.uid)));
        // Nobody but the first admin is entered by nobody.
        VERIFY_DONE(forge("system", "person.add", "person:" + newUid(), {{"role", "admin"}}));
        QVERIFY(support::faultsOf(school.db).contains("did not permit person.add"));
    }

    void namesOfPeopleAreNotInIt()
    {
        SchoolRig rig(support::populatedSchool(false));
        Person sam = findPerson(rig.school(), rig.admin, "s1001").value();
        sam.familyName = "Renamed";
        VERIFY_DONE(changePerson(rig.school(), rig.admin, sam));
        static_cast<void>(rig.logIn("s1001", "wrong"));
        const auto rows = readAudit(rig.school(), rig.admin, 1000);
        VERIFY_DONE(rows);
        for (const AuditRow& row : *rows)
            for (const char* name : {"Sam", "One", "Renamed", "s1001", "Ines", "wrong"})
                QVERIFY2((row.actor + row.object + row.detail).find(name) == std::string::npos, row.detail.c_str());
    }

private:
    /// Returns a school whose audit has 30 rows and no triggers that protect them.
    SchoolRig& chain(bool onServer)
    {
        auto& rig = m_chains[onServer];
        if (!rig) {
            rig = std::make_unique<SchoolRig>(onServer);
            rig->populate();
            work(*rig, static_cast<int>(30 - auditHead(rig->school())->seq));
            unlock(*rig);
        }
        return *rig;
    }
    /// Returns a school with examples of everything that the audit notes.
    SchoolRig& fullSchool(bool onServer)
    {
        auto& rig = m_full[onServer];
        if (!rig) {
            rig = std::make_unique<SchoolRig>(onServer);
            fill(*rig);
        }
        return *rig;
    }
    static void fill(SchoolRig& rig)
    {
        rig.populate();
        const DatabaseContext& school = rig.school();
        const AttemptId first = rig.add(rig.student, "class1-36", 700).value();
        const AttemptId other = rig.add(rig.classmate, "class1-36", 600).value();
        VERIFY_DONE(overrideScore(school, rig.instructor, first, 800, "neat"));
        VERIFY_DONE(overrideScore(school, rig.instructor, first, 900, "very neat"));
        VERIFY_DONE(overrideScore(school, rig.instructor, other, 900, "neat"));
        VERIFY_DONE(overrideScore(school, rig.instructor, other, {}, "of another"));
        NewComment pinned;
        pinned.words = "too deep";
        pinned.placeMm = {1.0, 2.0, -3.0};
        pinned.momentMs = 4200;
        VERIFY_DONE(addComment(school, rig.instructor, first, pinned));
        const auto wrong = addComment(school, rig.instructor, first, {"of another", {}, {}});
        VERIFY_DONE(wrong);
        VERIFY_DONE(withdrawComment(school, rig.instructor, *wrong));
        VERIFY_DONE(changeSetting(school, rig.admin, "idle.minutes", "12"));
        VERIFY_DONE(addPreset(school, rig.admin,
                              {"soft", 1, "44136fa355b3678a1146ad16f7e8649e94fb4fc21fe77e8310c060f61caaff8a", "{}"}));
        VERIFY_DONE(assign(school, rig.instructor, {0, rig.first, "class1-36", "", 3}));
        VERIFY_DONE(assign(school, rig.instructor, {0, rig.first, "class1-37", "", 3}));
        VERIFY_DONE(unassign(school, rig.instructor, {0, rig.first, "class1-37", "", 3}));
        // The creator of an assignment stays its creator, whoever changes it later.
        VERIFY_DONE(assign(school, rig.admin, {0, rig.first, "class1-36", "", 4},
                           ClassAssignment{0, rig.first, "class1-36", "", 3}));
        VERIFY_DONE(addPerson(school, rig.admin, {"s1003", "Cod", "Three", Role::Student}));
        VERIFY_DONE(deliverExam(school, rig.student.uid(), {newUid(), "exam-36", "2026-11-20T10:00:00Z"}));
        Person far = findPerson(school, rig.admin, "s2001").value();
        far.disabled = true;
        VERIFY_DONE(changePerson(school, rig.admin, far));
        QCOMPARE(support::faultsOf(school.db), QString());
        const QString off =
            dialect::isPostgres(school.db) ? "DROP TRIGGER %1_no_change ON %1" : "DROP TRIGGER %1_no_update";
        rig.run({off.arg("presets"), off.arg("overrides"), off.arg("exam_starts")});
    }

    /// Removes the triggers that protect the audit, which takes write access to the database itself.
    static void unlock(const SchoolRig& rig)
    {
        rig.run(
            dialect::isPostgres(rig.school().db)
                ? QStringList{"DROP TRIGGER audit_no_change ON audit", "ALTER TABLE audit DROP CONSTRAINT audit_pkey"}
                : QStringList{"DROP TRIGGER audit_no_update", "DROP TRIGGER audit_no_delete"});
    }
    /// Adds rows to the audit by way of the program.
    static void work(const SchoolRig& rig, int times)
    {
        for (int k = 0; k < times; ++k)
            VERIFY_DONE(rig.add(rig.student, "class1-36", 500));
    }
    static QString chainFault(const DatabaseContext& school, const std::vector<std::string>& witnesses = {})
    {
        const auto found = checkAudit(school.db, witnesses);
        return found ? support::wordsOf(*found) : QString::fromStdString(found.error().detail);
    }
    std::array<std::unique_ptr<SchoolRig>, 2> m_chains;
    std::array<std::unique_ptr<SchoolRig>, 2> m_full;
};

CUSP_TEST(TestAudit)
#include "tst_audit.moc"
