// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <numeric>
#include <set>

#include <QElapsedTimer>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QSqlError>
#include <QSqlQuery>
#include <QTest>

#include "database/sql/Check.h"
#include "database/sql/Dialect.h"
#include "database/sql/Overview.h"
#include "database/sql/Presets.h"
#include "tests/database/SchoolRig.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::addAttempt;
using support::SchoolRig;

class TestAudit : public QObject
{
    Q_OBJECT

private slots:
    void aSoundChainHasNoFindings_data() { support::addEngines(); }
    void aSoundChainHasNoFindings();
    void theDatabaseItselfRefusesChanges_data() { support::addEngines(); }
    void theDatabaseItselfRefusesChanges();
    void namesTheRow_data();
    void namesTheRow();
    void whatStandsElsewhereIsAsItWasNoted_data();
    void whatStandsElsewhereIsAsItWasNoted();
    void whatOlderProgramsDidNotNoteIsNoFinding_data() { support::addEngines(); }
    void whatOlderProgramsDidNotNoteIsNoFinding();
    void whatAnOlderProgramSetIsLookedAtForItsForm_data() { support::addEngines(); }
    void whatAnOlderProgramSetIsLookedAtForItsForm();
    void whatGuardsIsThere_data();
    void whatGuardsIsThere();
    void whatStandsOnOthersTablesIsTheirs_data() { support::addEngines(); }
    void whatStandsOnOthersTablesIsTheirs();
    void aSchemaInFrontIsNoFinding();
    void whatCannotBeLookedAtHidesNothingElse_data() { support::addEngines(); }
    void whatCannotBeLookedAtHidesNothingElse();
    void whatIsCalledLikeTheServersOwnIsFound();
    void whoMayNotCompareIsTold();
    void whoeverElseSignsIsNamed();
    void workGoesOnBehindWhatWasSlippedIn_data();
    void workGoesOnBehindWhatWasSlippedIn();
    void everyPlaceIsNamed_data() { support::addEngines(); }
    void everyPlaceIsNamed();
    void aSealSetBackAccusesNobody_data() { support::addEngines(); }
    void aSealSetBackAccusesNobody();
    void aStationThatJoinedIsKnownWhenTheSealIsSetBack();
    void whatIsChainedBehindTheSealAccusesNobody_data() { support::addEngines(); }
    void whatIsChainedBehindTheSealAccusesNobody();
    void nothingGenuineIsAccused();
    void aSignedRowRewrittenIsNamed_data() { support::addEngines(); }
    void aSignedRowRewrittenIsNamed();
    void aSealFarAwayMakesNobodyForeign_data();
    void aSealFarAwayMakesNobodyForeign();
    void rowsBehindTheSignedOneAreLookedAt_data() { support::addEngines(); }
    void rowsBehindTheSignedOneAreLookedAt();
    void goingOnMakesNothingGood_data() { support::addEngines(); }
    void goingOnMakesNothingGood();
    void aStationThatNeverJoinedIsFound_data() { support::addEngines(); }
    void aStationThatNeverJoinedIsFound();
    void namesOfPeopleAreNotInIt();
    void manyMadeUpBreaksHoldNobodyUp();
    void whatItsLostRowsNotedIsNotAccused_data() { support::addEngines(); }
    void whatItsLostRowsNotedIsNotAccused();

private:
    /// Lets the test do what only somebody with the file in his hands can.
    static void unlock(const School& school)
    {
        QSqlQuery query(school.db);
        for (const char* sql :
             dialect::isPostgres(school.db)
                 ? std::vector{"DROP TRIGGER audit_no_change ON audit", "ALTER TABLE audit DROP CONSTRAINT audit_pkey"}
                 : std::vector{"DROP TRIGGER audit_no_update", "DROP TRIGGER audit_no_delete"})
            QVERIFY2(query.exec(QLatin1String(sql)), qPrintable(query.lastError().text()));
    }
    /// A row that follows from none, as somebody copies it who does not know how they hang together.
    static void slipIn(const School& school, const QList<qint64>& places)
    {
        QVERIFY(QSqlDatabase(school.db).transaction());
        QSqlQuery query(school.db);
        for (const qint64 seq : places)
            QVERIFY2(query.exec(QStringLiteral("INSERT INTO audit SELECT %1, at_utc, actor, action, object, detail, "
                                               "hash FROM audit WHERE seq = 3")
                                    .arg(seq)),
                     qPrintable(query.lastError().text()));
        QVERIFY(QSqlDatabase(school.db).commit());
    }
    /// One that follows from the last, of somebody who knows how they hang together.
    static void chain(const SchoolRig& rig, qint64 seq, const std::string& action = "attempt.add")
    {
        AuditRow row = readAudit(rig.school(), rig.admin, 1)->front();
        const std::string before = row.hash;
        row.seq = seq;
        row.action = action;
        row.hash = hashOf(row, before);
        QSqlQuery query(rig.school().db);
        QVERIFY2(
            query.exec(QStringLiteral("INSERT INTO audit SELECT %1, at_utc, actor, '%2', object, detail, '%3' FROM "
                                      "audit ORDER BY seq DESC LIMIT 1")
                           .arg(seq)
                           .arg(QString::fromStdString(action), QString::fromStdString(row.hash))),
            qPrintable(query.lastError().text()));
    }
    /// Rows of the program's own.
    static void work(const SchoolRig& rig, int times)
    {
        for (int k = 0; k < times; ++k)
            VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500), {}));
    }
    static void workUpTo(const SchoolRig& rig, qint64 seq)
    {
        work(rig, static_cast<int>(seq - auditHead(rig.school())->seq));
        QCOMPARE(auditHead(rig.school())->seq, seq);
    }
};

void TestAudit::aSoundChainHasNoFindings()
{
    SCHOOL_RIG(rig);
    QVERIFY(checkAudit(rig.school().db, {})->empty());
    QCOMPARE(auditHead(rig.school())->code(), std::string("0"));
    rig.populate();
    std::vector<std::string> witnesses;
    for (int k = 0; k < 20; ++k) {
        VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500), {}));
        witnesses.push_back(auditHead(rig.school())->code());
    }
    const auto findings = checkAudit(rig.school().db, witnesses);
    VERIFY_DONE(findings);
    QVERIFY2(findings->empty(), qPrintable(support::wordsOf(*findings)));
    const auto newest = readAudit(rig.school(), rig.admin, 5);
    VERIFY_DONE(newest);
    QCOMPARE(newest->size(), std::size_t{5});
    QCOMPARE(newest->front().action, std::string("attempt.add"));
    QCOMPARE(newest->front().actor, rig.student.uid());
    QCOMPARE(readAudit(rig.school(), rig.admin, 5, newest->back().seq)->front().seq, newest->back().seq - 1);
    // Those of attempts are left out before they are counted.
    const auto others = readAudit(rig.school(), rig.admin, 5, 0, AuditRows::WithoutAttempts);
    VERIFY_DONE(others);
    QCOMPARE(others->size(), std::size_t{5});
    for (const AuditRow& row : *others)
        QVERIFY2(row.action != "attempt.add" && row.action != "exam.begin", row.action.c_str());
    QVERIFY(others->front().seq < newest->back().seq);
    QCOMPARE(readAudit(rig.school(), rig.admin, 5, others->back().seq, AuditRows::WithoutAttempts)->front().seq,
             others->back().seq - 1);
    // A report of another school's.
    QVERIFY(!checkAudit(rig.school().db, {"3-000000000000"})->empty());
    QVERIFY(!checkAudit(rig.school().db, {"nonsense"})->empty());
}

void TestAudit::theDatabaseItselfRefusesChanges()
{
    SCHOOL_RIG(rig);
    rig.populate();
    QSqlQuery query(rig.school().db);
    for (const char* sql : {"UPDATE audit SET actor = ''", "DELETE FROM audit WHERE seq = 2", "DELETE FROM presets",
                            "UPDATE overrides SET reason = ''"})
        if (query.exec(QLatin1String(sql)))
            QVERIFY2(query.numRowsAffected() == 0, sql);
    QVERIFY(checkAudit(rig.school().db, {})->empty());
}

void TestAudit::namesTheRow_data()
{
    QTest::addColumn<bool>("onServer");
    QTest::addColumn<QStringList>("deeds");
    QTest::addColumn<QString>("finding");
    QTest::addColumn<int>("findings");
    for (const bool onServer : {false, true}) {
        const auto row = [onServer](const char* name) -> QTestData& {
            return QTest::addRow("%s %s", name, onServer ? "postgresql" : "sqlite") << onServer;
        };
        row("changed") << QStringList{"UPDATE audit SET action = 'login' WHERE seq = 9"} << "row 9 (" << 1;
        row("changed first") << QStringList{"UPDATE audit SET actor = 'x' WHERE seq = 1"} << "row 1 (" << 1;
        row("changed last") << QStringList{"UPDATE audit SET detail = '{}' WHERE seq = (SELECT max(seq) FROM audit)"}
                            << "row 30 (" << 1;
        row("two changed") << QStringList{"UPDATE audit SET at_utc = '2020-01-01T00:00:00Z' WHERE seq IN (7, 12)"}
                           << "row 12 (" << 2;
        row("removed") << QStringList{"DELETE FROM audit WHERE seq = 9"} << "row 9 was removed" << 1;
        row("some removed") << QStringList{"DELETE FROM audit WHERE seq BETWEEN 9 AND 11"}
                            << "rows 9 to 11 were removed" << 1;
        row("end cut off") << QStringList{"DELETE FROM audit WHERE seq > 27"} << "rows 28 to 30 were removed" << 1;
        row("removed, renumbered") << QStringList{"DELETE FROM audit WHERE seq = 9",
                                                  "UPDATE audit SET seq = seq + 999 WHERE seq > 9",
                                                  "UPDATE audit SET seq = seq - 1000 WHERE seq > 1000"}
                                   << "was removed, and those behind were renumbered" << 1;
        row("three removed, renumbered") << QStringList{"DELETE FROM audit WHERE seq BETWEEN 10 AND 12",
                                                        "UPDATE audit SET seq = seq + 997 WHERE seq > 12",
                                                        "UPDATE audit SET seq = seq - 1000 WHERE seq > 1000"}
                                         << "3 rows were removed" << 1;
        row("two inserted, renumbered")
            << QStringList{"UPDATE audit SET seq = seq + 1002 WHERE seq > 9",
                           "UPDATE audit SET seq = seq - 1000 WHERE seq > 1000",
                           "INSERT INTO audit SELECT 10, at_utc, actor, 'login', object, detail, hash FROM audit WHERE "
                           "seq = 3",
                           "INSERT INTO audit SELECT 11, at_utc, actor, 'login', object, detail, hash FROM audit WHERE "
                           "seq = 4"}
            << "rows 10 to 11 were inserted" << 1;
        row("inserted") << QStringList{"UPDATE audit SET seq = seq + 1001 WHERE seq > 9",
                                       "UPDATE audit SET seq = seq - 1000 WHERE seq > 1000",
                                       "INSERT INTO audit SELECT 10, at_utc, actor, 'login', object, detail, hash FROM "
                                       "audit WHERE seq = 3"}
                        << "row 10 (" << 1;
        row("appended") << QStringList{"INSERT INTO audit SELECT 31, at_utc, actor, action, object, detail, hash FROM "
                                       "audit WHERE seq = 3"}
                        << "no signature covers audit row 31:" << 1;
        row("appended at the end of numbers")
            << QStringList{"INSERT INTO audit SELECT 9223372036854775807, at_utc, actor, action, object, detail, hash "
                           "FROM audit WHERE seq = 30"}
            << "no signature covers audit row 9223372036854775807:" << 1;
        row("other numbers") << QStringList{"UPDATE audit SET seq = seq + 1000 WHERE seq > 9",
                                            "UPDATE audit SET seq = seq - 995 WHERE seq > 1000"}
                             << "row 15 (" << 1;
        row("far numbers") << QStringList{"UPDATE audit SET seq = seq + 1000000 WHERE seq > 9"}
                           << "and those behind it were renumbered" << 1;
        row("neighbours exchanged") << QStringList{"UPDATE audit SET seq = 1019 - seq WHERE seq IN (9, 10)",
                                                   "UPDATE audit SET seq = seq - 1000 WHERE seq > 1000"}
                                    << "row 9 (" << 1;
        row("last ones exchanged") << QStringList{"UPDATE audit SET seq = 1059 - seq WHERE seq IN (29, 30)",
                                                  "UPDATE audit SET seq = seq - 1000 WHERE seq > 1000"}
                                   << "row 29 (" << 1;
        row("exchanged") << QStringList{"UPDATE audit SET seq = 1021 - seq WHERE seq IN (7, 14)",
                                        "UPDATE audit SET seq = seq - 1000 WHERE seq > 1000"}
                         << "it was written as row 14" << 2;
        // Rows that stand elsewhere, where all numbers go on.
        row("moved behind others") << QStringList{"UPDATE audit SET seq = seq + 1000 WHERE seq BETWEEN 10 AND 20",
                                                  "UPDATE audit SET seq = 20 WHERE seq = 1010",
                                                  "UPDATE audit SET seq = seq - 1001 WHERE seq > 1000"}
                                   << "was moved: it was written as row 10" << 1;
        row("moved before others") << QStringList{"UPDATE audit SET seq = seq + 1000 WHERE seq BETWEEN 10 AND 20",
                                                  "UPDATE audit SET seq = 10 WHERE seq = 1020",
                                                  "UPDATE audit SET seq = seq - 999 WHERE seq > 1000"}
                                   << "was moved: it was written as row 20" << 1;
        row("three moved") << QStringList{"UPDATE audit SET seq = seq + 1000 WHERE seq BETWEEN 10 AND 20",
                                          "UPDATE audit SET seq = seq - 992 WHERE seq BETWEEN 1010 AND 1012",
                                          "UPDATE audit SET seq = seq - 1003 WHERE seq > 1000"}
                           << "rows 18 to 20 were moved: they were written as rows 10 to 12" << 1;
        row("moved round") << QStringList{"UPDATE audit SET seq = seq + 1000 WHERE seq BETWEEN 9 AND 11",
                                          "UPDATE audit SET seq = 11 WHERE seq = 1009",
                                          "UPDATE audit SET seq = seq - 1001 WHERE seq > 1000"}
                           << "row 11 (" << 1;
        row("moved behind the signed one")
            << QStringList{"UPDATE audit SET seq = 31 WHERE seq = 10"} << "was moved: it was written as row 10" << 1;
        row("moved, and one removed besides")
            << QStringList{"DELETE FROM audit WHERE seq = 25",
                           "UPDATE audit SET seq = seq + 1000 WHERE seq BETWEEN 10 AND 20",
                           "UPDATE audit SET seq = 20 WHERE seq = 1010",
                           "UPDATE audit SET seq = seq - 1001 WHERE seq > 1000"}
            << "row 25 was removed" << 2;
        row("seal gone") << QStringList{"DELETE FROM audit_seal"} << "signed head of the audit was removed" << 1;
        row("seal in capitals") << QStringList{"UPDATE audit_seal SET signature = upper(signature)"} << "signature"
                                << 1;
        row("seal of another") << QStringList{"UPDATE audit_seal SET signature = '" + QString(128, '0') + "'"}
                               << "signature" << 1;
    }
}

void TestAudit::namesTheRow()
{
    QFETCH(QStringList, deeds);
    QFETCH(QString, finding);
    QFETCH(int, findings);
    SCHOOL_RIG(rig);
    rig.populate();
    std::int64_t last = auditHead(rig.school())->seq;
    for (; last < 30; ++last)
        VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500), {}));
    unlock(rig.school());
    QCOMPARE(auditHead(rig.school())->seq, 30);
    QSqlQuery query(rig.school().db);
    for (const QString& deed : deeds)
        QVERIFY2(query.exec(deed), qPrintable(query.lastError().text()));
    const auto found = checkAudit(rig.school().db, {});
    VERIFY_DONE(found);
    const QString said = support::wordsOf(*found);
    QVERIFY2(said.contains(finding), qPrintable(said));
    QVERIFY2(static_cast<int>(found->size()) == findings, qPrintable(said));
}

/// Those that somebody has made up tell of no break, and are not looked for from each row before them.
void TestAudit::manyMadeUpBreaksHoldNobodyUp()
{
    SchoolRig rig(false);
    rig.populate();
    const School& school = rig.school();
    VERIFY_DONE(inTransaction(school.db, "note many", [&]() -> core::Status {
        AuditBatch batch(school);
        for (int k = 0; k < 40'000; ++k)
            if (auto noted = batch.note("system", "test", "row"); !noted)
                return noted;
        return batch.seal();
    }));
    const auto msOf = [&school](std::size_t findings) {
        qint64 least = std::numeric_limits<qint64>::max();
        for (int k = 0; k < 3; ++k) {
            QElapsedTimer since;
            since.start();
            const auto found = checkAudit(school.db, {});
            least = std::min(least, since.nsecsElapsed());
            if (!found || found->size() != findings)
                qWarning("%s", found ? qPrintable(support::wordsOf(*found)) : found.error().detail.c_str());
        }
        return static_cast<double>(least) * 1.0e-6;
    };
    const double before = msOf(0);
    unlock(school);
    QSqlQuery query(school.db);
    QVERIFY2(
        query.exec("UPDATE audit SET action = 'audit.broken', object = 'audit' WHERE seq > 39000 AND seq % 10 = 0"),
        qPrintable(query.lastError().text()));
    const double after = msOf(100);
    QVERIFY2(after < 6.0 * before, qPrintable(QStringLiteral("%1 ms, and %2 ms").arg(before).arg(after)));
}

/// What it noted may be sound: whoever removes rows of the audit shall not have others accused.
void TestAudit::whatItsLostRowsNotedIsNotAccused()
{
    SCHOOL_RIG(rig);
    rig.populate();
    const School& school = rig.school();
    const AttemptId id = addAttempt(school, rig.student, SchoolRig::attempt("class1-36", 700), {}).value();
    VERIFY_DONE(overrideScore(school, rig.instructor, id, 800, "neat"));
    VERIFY_DONE(addComment(school, rig.instructor, id, {"too deep", {}, {}}));
    VERIFY_DONE(addAttempt(school, rig.student, SchoolRig::attempt("class1-36", 500), {}));
    const qint64 rows = checkDatabase(school.db, {})->auditRows;
    unlock(school);
    QSqlQuery query(school.db);
    const char* const gone = "('attempt.add', 'attempt.override', 'attempt.comment', 'person.add')";
    QVERIFY(query.exec(QStringLiteral("SELECT count(*) FROM audit WHERE action IN %1").arg(gone)) && query.next());
    const qint64 lost = query.value(0).toLongLong();
    QVERIFY2(query.exec(QStringLiteral("DELETE FROM audit WHERE action IN %1").arg(gone)),
             qPrintable(query.lastError().text()));
    const auto report = checkDatabase(school.db, {});
    VERIFY_DONE(report);
    QVERIFY(report->lacksNotes);
    // However high the last number is.
    QCOMPARE(report->auditRows, rows - lost);
    const QString said = support::wordsOf(report->findings);
    QVERIFY2(!said.contains("knows nothing of it"), qPrintable(said));
    for (const char* thing : {"attempt:", "an override of attempt:", "a comment on attempt:", "person:"})
        QVERIFY2(QRegularExpression(
                     QStringLiteral("(^|\n)%1\\S+( \\([^)]*\\))? is not noted in the audit").arg(QLatin1String(thing)))
                     .match(said)
                     .hasMatch(),
                 qPrintable(said));
    QVERIFY2(support::wordsOf(report->notes).contains("may be sound"), qPrintable(support::wordsOf(report->notes)));
}

void TestAudit::whatStandsElsewhereIsAsItWasNoted_data()
{
    QTest::addColumn<bool>("onServer");
    QTest::addColumn<QString>("deed");
    QTest::addColumn<QString>("finding");
    for (const bool onServer : {false, true}) {
        const auto row = [onServer](const char* name) -> QTestData& {
            return QTest::addRow("%s %s", name, onServer ? "postgresql" : "sqlite") << onServer;
        };
        row("nothing") << QString() << QString();
        row("a score nobody gave") << "UPDATE attempts SET given_tenths = 1000 WHERE given_tenths IS NULL"
                                   << "another score than the audit says";
        row("a score that was given") << "UPDATE attempts SET given_tenths = 999 WHERE given_tenths = 900"
                                      << "another score than the audit says";
        row("a score taken back") << "UPDATE attempts SET given_tenths = NULL WHERE given_tenths = 900"
                                  << "another score than the audit says";
        row("an override slipped in")
            << "INSERT INTO overrides (attempt_id, author_id, given_utc, given_tenths, reason) SELECT attempt_id, "
               "author_id, given_utc, 1000, reason FROM overrides"
            << "an override of attempt:";
        row("a comment slipped in")
            << "INSERT INTO comments (attempt_id, author_id, written_utc, words) SELECT attempt_id, author_id, "
               "written_utc, 'well done' FROM comments"
            << "a comment on attempt:";
        row("a comment changed") << "UPDATE comments SET words = 'well done'"
                                 << "a comment on attempt:";
        row("a comment moved to another place") << "UPDATE comments SET x_um = x_um + 1000"
                                                << "a comment on attempt:";
        row("a comment moved to another moment") << "UPDATE comments SET moment_ms = 1"
                                                 << "a comment on attempt:";
        row("a comment of another day") << "UPDATE comments SET written_utc = '2020-01-01T00:00:00Z'"
                                        << "a comment on attempt:";
        row("a comment hidden") << "UPDATE comments SET withdrawn_utc = '2026-11-20T10:15:00Z' WHERE words = 'too deep'"
                                << "was taken back, and it was not noted";
        row("a comment brought back") << "UPDATE comments SET withdrawn_utc = NULL WHERE words = 'of another'"
                                      << "that was taken back is there again, changed or removed";
        row("a comment taken back on another day")
            << "UPDATE comments SET withdrawn_utc = '2026-11-19T10:15:00Z' WHERE words = 'of another'"
            << "was taken back, and it was not noted";
        row("a comment that was taken back changed")
            << "UPDATE comments SET words = 'well done' WHERE words = 'of another'"
            << "a comment on attempt:";
        row("a preset slipped in") << "INSERT INTO presets (name, version, hash, json, author_id, created_utc) SELECT "
                                      "'soft', 9, hash, json, author_id, created_utc FROM presets"
                                   << "preset:soft v9 was inserted";
        row("a setting changed") << "UPDATE settings SET value = '999' WHERE name = 'idle.minutes'"
                                 << "setting:idle.minutes is not what the audit says";
        row("what passwords cost") << "UPDATE settings SET value = '7' WHERE name = 'password.passes'"
                                   << "setting:password.passes is not what the audit says";
        row("a setting slipped in") << "INSERT INTO settings (owner, name, value) VALUES ('', 'idle.hours', '9999')"
                                    << "setting:idle.hours was inserted";
        const QString off = onServer ? "DROP TRIGGER %1_no_change ON %1;" : "DROP TRIGGER %1_no_update;";
        row("a preset's values") << off.arg("presets") + "UPDATE presets SET json = '[]'"
                                 << "preset:soft v1 is not what the audit says";
        row("a preset of another's") << off.arg("presets") + "UPDATE presets SET author_id = NULL"
                                     << "preset:soft v1 is not what the audit says";
        row("a preset of another day") << off.arg("presets") + "UPDATE presets SET created_utc = '2020-01-01T00:00:00Z'"
                                       << "preset:soft v1 is not what the audit says";
        row("an override of another day")
            << off.arg("overrides") + "UPDATE overrides SET given_utc = '2020-01-01T00:00:00Z'"
            << "an override of attempt:";
        row("an attempt of nobody's slipped in")
            << "INSERT INTO attempts (finished_utc, tooth, duration_ms, state_hash, score_tenths, uid) VALUES "
               "('2026-03-01T10:00:00Z', '36', 1000, '0123456789abcdef', 820, 'legacy-9')"
            << "attempt:legacy-9 was inserted";
        row("a comment gone") << "DELETE FROM comments"
                              << "a comment on attempt:";
        row("a role") << "UPDATE people SET role = 'admin' WHERE username = 's1001'"
                      << "has the role admin, the audit says student";
        row("another's password") << "UPDATE people SET password_hash = (SELECT password_hash FROM people WHERE "
                                     "username = 's1001') WHERE username = 'admin'"
                                  << "was changed without a note in the audit";
        row("a password nobody can read") << "UPDATE people SET password_hash = replace(password_hash, 'argon2id', "
                                             "'argon2ie') WHERE username = 'admin'"
                                          << "cannot be read, and lets nobody in";
        row("a code that is good for ever") << "UPDATE people SET reset_until_utc = '9999-01-01T00:00:00Z' WHERE "
                                               "username = 's1003'"
                                            << "was changed without a note in the audit";
        row("a code nobody gave")
            << QStringLiteral("UPDATE people SET reset_hash = '%1' WHERE username = 's1001'").arg(QString(64, 'e'))
            << "was changed without a note in the audit";
        row("let in again") << "UPDATE people SET disabled = 0 WHERE username = 's2001'"
                            << "and it was not noted";
        row("a limit") << "UPDATE assignments SET attempt_limit = 0"
                       << "is not what the audit says";
        row("an assignment of another's")
            << "UPDATE assignments SET created_by = (SELECT id FROM people WHERE username = 'teach2')"
            << "is not what the audit says";
        row("an assignment of another day") << "UPDATE assignments SET created_utc = '2020-01-01T00:00:00Z'"
                                            << "is not what the audit says";
        row("an assignment gone") << "DELETE FROM assignments"
                                  << "was removed";
        row("standings gone") << "DELETE FROM standings"
                              << "has attempts in class1-36 and no standing";
        row("an attempt made nobody's") << "UPDATE attempts SET person_id = NULL WHERE score_tenths = 600"
                                        << "was taken from the person who made it";
        row("another user's name") << "UPDATE people SET username = 's1009' WHERE username = 's1002'"
                                   << "was given another name";
        row("another family name") << "UPDATE people SET family_name = 'Else' WHERE username = 's1002'"
                                   << "was given another name";
        row("a class renamed") << "UPDATE classes SET name = 'DEN999' WHERE name = 'DEN101-B'"
                               << "was renamed, and it was not noted";
        row("put into a class") << "INSERT INTO enrolments (class_id, person_id) SELECT c.id, p.id FROM classes c, "
                                   "people p WHERE c.name = 'DEN101-B' AND p.username = 's1001'"
                                << "was put into class:";
        row("taken out of a class") << "DELETE FROM enrolments WHERE person_id = (SELECT id FROM people WHERE username "
                                       "= 's1002')"
                                    << "was taken out of class:";
        row("a recording gone") << QStringLiteral("UPDATE attempts SET recording_hash = '%1'").arg(QString(64, 'd'))
                                << "is not there any more";
        row("last activity") << "UPDATE standings SET last_utc = '2020-01-01T00:00:00Z'"
                             << "do not add up to";
        row("a standing passed") << "UPDATE standings SET passed = 1 WHERE passed = 0"
                                 << "do not add up to";
    }
}

void TestAudit::whatStandsElsewhereIsAsItWasNoted()
{
    QFETCH(QString, deed);
    QFETCH(QString, finding);
    SCHOOL_RIG(rig);
    rig.populate();
    const School& school = rig.school();
    const AttemptId first = addAttempt(school, rig.student, SchoolRig::attempt("class1-36", 700), {}).value();
    VERIFY_DONE(addAttempt(school, rig.classmate, SchoolRig::attempt("class1-36", 600), {}));
    VERIFY_DONE(overrideScore(school, rig.instructor, first, 800, "neat"));
    VERIFY_DONE(overrideScore(school, rig.instructor, first, 900, "very neat"));
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
    // Whoever changes what was given, it stays his who gave it.
    VERIFY_DONE(assign(school, rig.admin, {0, rig.first, "class1-36", "", 4},
                       ClassAssignment{0, rig.first, "class1-36", "", 3}));
    VERIFY_DONE(addPerson(school, rig.admin, {"s1003", "Cod", "Three", Role::Student}));
    Person far = findPerson(school, rig.admin, "s2001").value();
    far.disabled = true;
    VERIFY_DONE(changePerson(school, rig.admin, far));
    if (!deed.isEmpty()) {
        QSqlQuery query(school.db);
        for (const QString& part : deed.split(u';'))
            QVERIFY2(query.exec(part), qPrintable(query.lastError().text()));
        QVERIFY(query.numRowsAffected() > 0);
    }
    const auto report = checkDatabase(school.db, {});
    VERIFY_DONE(report);
    const QString said = support::wordsOf(report->findings);
    if (deed.isEmpty())
        QVERIFY2(said.isEmpty(), qPrintable(said));
    else
        QVERIFY2(said.contains(finding), qPrintable(said));
}

/// Nor are attempts from before there were people.
void TestAudit::whatOlderProgramsDidNotNoteIsNoFinding()
{
    SCHOOL_RIG(rig);
    QSqlQuery query(rig.school().db);
    for (const char* sql : {"INSERT INTO settings (owner, name, value) VALUES ('', 'password.passes', '2')",
                            "INSERT INTO attempts (finished_utc, tooth, duration_ms, state_hash, score_tenths, uid) "
                            "VALUES ('2026-03-01T10:00:00Z', '36', 1000, '0123456789abcdef', 820, 'legacy-1')",
                            "INSERT INTO score_sheets SELECT id, '{}' FROM attempts"})
        QVERIFY2(query.exec(QLatin1String(sql)), qPrintable(query.lastError().text()));
    const auto report = checkDatabase(rig.school().db, {});
    VERIFY_DONE(report);
    QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
}

/// Of a password that an older program has set the form alone is known.
void TestAudit::whatAnOlderProgramSetIsLookedAtForItsForm()
{
    SCHOOL_RIG(rig);
    rig.populate();
    const School& school = rig.school();
    QSqlQuery query(school.db);
    QVERIFY(query.exec("UPDATE people SET password_hash = (SELECT password_hash FROM people WHERE username = 's1002') "
                       "WHERE username = 's1001'"));
    VERIFY_DONE(note(school, rig.student.uid(), "password.change", "person:" + rig.student.uid()));
    const auto sound = checkDatabase(school.db, {});
    VERIFY_DONE(sound);
    QVERIFY2(sound->findings.empty(), qPrintable(support::wordsOf(sound->findings)));
    QVERIFY(query.exec("UPDATE people SET password_hash = '$argon2id$v=19$m=8,t=1,p=1$x$' WHERE username = 's1001'"));
    const auto report = checkDatabase(school.db, {});
    VERIFY_DONE(report);
    QCOMPARE(report->findings.size(), std::size_t{1});
    QVERIFY2(support::wordsOf(report->findings).contains("cannot be read"),
             qPrintable(support::wordsOf(report->findings)));
}

void TestAudit::whatGuardsIsThere_data()
{
    QTest::addColumn<bool>("onServer");
    QTest::addColumn<QStringList>("deeds");
    QTest::addColumn<QString>("finding");
    QTest::newRow("index, sqlite") << false << QStringList{"DROP INDEX attempts_by_uid"}
                                   << "index attempts_by_uid is no longer there";
    QTest::newRow("index, postgresql") << true << QStringList{"DROP INDEX attempts_by_uid"}
                                       << "index attempts_by_uid is no longer there";
    QTest::newRow("guard, sqlite") << false << QStringList{"DROP TRIGGER audit_no_delete"}
                                   << "trigger audit_no_delete is no longer there";
    QTest::newRow("guard, postgresql") << true << QStringList{"ALTER TABLE audit DISABLE TRIGGER audit_no_change"}
                                       << "trigger audit_no_change is no longer there";
    QTest::newRow("guard of straw") << false
                                    << QStringList{"DROP TRIGGER audit_no_delete",
                                                   "CREATE TRIGGER audit_no_delete BEFORE DELETE ON audit BEGIN SELECT "
                                                   "1; END"}
                                    << "trigger audit_no_delete is not as this program makes it";
    for (const auto& [name, deed, said] :
         {std::tuple("guard for copies only", "ALTER TABLE audit ENABLE REPLICA TRIGGER audit_no_change",
                     "trigger audit_no_change is no longer there"),
          std::tuple("guard of straw, postgresql",
                     "CREATE OR REPLACE FUNCTION audit_is_append_only() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN "
                     "RETURN NULL; END $$",
                     "trigger audit_no_change is not as this program makes it"),
          std::tuple("index of other columns, postgresql",
                     "DROP INDEX attempts_by_uid; CREATE INDEX attempts_by_uid ON attempts (uid)",
                     "index attempts_by_uid is not as this program makes it"),
          std::tuple("bounds, postgresql", "ALTER TABLE attempts DROP CONSTRAINT attempts_score_tenths_check",
                     "constraint attempts.attempts_score_tenths_check is no longer there"),
          std::tuple("foreign key, postgresql", "ALTER TABLE comments DROP CONSTRAINT comments_author_id_fkey",
                     "constraint comments.comments_author_id_fkey is no longer there"),
          std::tuple("primary key, postgresql", "ALTER TABLE failed_logins DROP CONSTRAINT failed_logins_pkey",
                     "constraint failed_logins.failed_logins_pkey is no longer there"),
          std::tuple("column, postgresql", "ALTER TABLE people ALTER COLUMN username DROP NOT NULL",
                     "column people.username is not as this program makes it"),
          std::tuple("rule, postgresql", "CREATE RULE quiet AS ON DELETE TO comments DO INSTEAD NOTHING",
                     "rule comments.quiet is not from this program")})
        QTest::newRow(name) << true << QStringList{deed} << said;
    for (const auto& [name, deed, said] :
         {std::tuple("bounds of somebody's, postgresql",
                     "ALTER TABLE attempts ADD CONSTRAINT at_most CHECK (score_tenths < 500)",
                     "constraint attempts.at_most is not from this program: it may refuse"),
          std::tuple("all guards rest, postgresql", "SET session_replication_role = replica",
                     "(session_replication_role is replica): what they guard is not guarded"),
          std::tuple("another column, postgresql", "ALTER TABLE comments ADD COLUMN more TEXT NOT NULL",
                     "column comments.more is not from this program: it may refuse"),
          std::tuple("one attempt only, postgresql", "CREATE UNIQUE INDEX one_only ON attempts ((1))",
                     "index one_only is not from this program: it may refuse")})
        QTest::newRow(name) << true << QStringList{deed} << said;
    QTest::newRow("one attempt only, sqlite") << false << QStringList{"CREATE UNIQUE INDEX one_only ON attempts ((1))"}
                                              << "index one_only is not from this program: it may refuse";
    QTest::newRow("a row that another holds, sqlite")
        << false << QStringList{"CREATE TABLE innocent (x REFERENCES Failed_Logins (name_hash))"}
        << "reference innocent.x(failed_logins) is not from this program: it may refuse";
    QTest::newRow("a row that another holds, postgresql")
        << true << QStringList{"CREATE TABLE innocent (x TEXT CONSTRAINT hold REFERENCES failed_logins)"}
        << "reference innocent.hold is not from this program: it may refuse";
    QTest::newRow("rows of another table") << true << QStringList{"CREATE TABLE more () INHERITS (attempts)"}
                                           << "heir more is not from this program: its rows are read among those of "
                                              "the table attempts";
    QTest::newRow("guard of another table, sqlite")
        << false
        << QStringList{"CREATE TABLE \"audit \" (x)", "DROP TRIGGER audit_no_delete",
                       "CREATE TRIGGER audit_no_delete BEFORE DELETE ON \"audit \" BEGIN SELECT RAISE(ABORT, 'audit is "
                       "append-only'); END"}
        << "trigger audit_no_delete is not as this program makes it";
    QTest::newRow("guard of another table, postgresql")
        << true
        << QStringList{"CREATE TABLE \"audit \" (LIKE audit)", "DROP TRIGGER audit_no_change ON audit",
                       "CREATE TRIGGER audit_no_change BEFORE UPDATE OR DELETE OR TRUNCATE ON \"audit \" FOR EACH "
                       "STATEMENT EXECUTE FUNCTION audit_is_append_only()"}
        << "trigger audit_no_change is not as this program makes it";
    // SQLite takes for a text what stands in double quotes and is no column.
    QTest::newRow("guard in quotes")
        << false
        << QStringList{"DROP TRIGGER audit_no_update",
                       "CREATE TRIGGER audit_no_update BEFORE UPDATE ON audit BEGIN SELECT "
                       "\"RAISE(ABORT, 'audit is append-only')\"; END",
                       "UPDATE audit SET at_utc = at_utc"}
        << "trigger audit_no_update is not as this program makes it";
    QTest::newRow("index of a text") << false
                                     << QStringList{"DROP INDEX attempts_by_person",
                                                    "CREATE INDEX attempts_by_person ON attempts (\"person_id, "
                                                    "lesson_id, finished_utc, id, score_tenths, given_tenths, passed, "
                                                    "pass_mark_tenths, duration_ms\")"}
                                     << "index attempts_by_person is not as this program makes it";
    QTest::newRow("space in a text")
        << false
        << QStringList{"DROP TRIGGER audit_no_update",
                       "CREATE TRIGGER audit_no_update BEFORE UPDATE ON audit BEGIN SELECT "
                       "RAISE(ABORT, 'audit is append- only'); END"}
        << "trigger audit_no_update is not as this program makes it";
    QTest::newRow("rows that can be changed elsewhere")
        << true
        << QStringList{"CREATE SCHEMA other", "CREATE TABLE other.par (LIKE audit)",
                       "ALTER TABLE audit INHERIT other.par"}
        << "parent other.par of audit is not from this program: who changes its rows changes those of the table audit";
    QTest::newRow("rows that can be changed beside it")
        << true << QStringList{"CREATE TABLE par (LIKE audit)", "ALTER TABLE audit INHERIT par"}
        << "parent par of audit is not from this program: who changes its rows changes those of the table audit";
    QTest::newRow("names that are alike")
        << true
        << QStringList{"CREATE COLLATION alike (provider = icu, locale = 'und-u-ks-level1', deterministic = false)",
                       "ALTER TABLE people ALTER COLUMN username TYPE TEXT COLLATE alike"}
        << "column people.username is not as this program makes it";
    QTest::newRow("a table in front of it")
        << true
        << QStringList{"CREATE SCHEMA school",
                       "CREATE TABLE school.failed_logins (LIKE failed_logins INCLUDING CONSTRAINTS)",
                       "SET search_path = school, public"}
        << "constraint failed_logins.failed_logins_pkey is no longer there";
    QTest::newRow("gift, sqlite") << false
                                  << QStringList{"CREATE TRIGGER gift AFTER INSERT ON attempts BEGIN UPDATE attempts "
                                                 "SET score_tenths = 1000 WHERE id = NEW.id; END"}
                                  << "trigger gift is not from this program";
    QTest::newRow("gift under a name of SQLite's")
        << false
        << QStringList{"PRAGMA writable_schema = ON",
                       "INSERT INTO sqlite_master VALUES ('trigger', 'sqlite_gift', 'attempts', 0, 'CREATE TRIGGER "
                       "sqlite_gift AFTER INSERT ON attempts BEGIN UPDATE attempts SET score_tenths = 1000 WHERE id = "
                       "NEW.id; END')",
                       "PRAGMA writable_schema = OFF"}
        << "trigger sqlite_gift is not from this program";
    QTest::newRow("gift, postgresql")
        << true
        << QStringList{"CREATE FUNCTION gift() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN NEW.score_tenths = 1000; "
                       "RETURN NEW; END $$",
                       "CREATE TRIGGER gift BEFORE INSERT ON attempts FOR EACH ROW EXECUTE FUNCTION gift()"}
        << "trigger gift is not from this program";
    QTest::newRow("gift that calls itself the server's own")
        << true
        << QStringList{"CREATE FUNCTION gift() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN NEW.score_tenths = 1000; "
                       "RETURN NEW; END $$",
                       "CREATE TRIGGER gift BEFORE INSERT ON attempts FOR EACH ROW EXECUTE FUNCTION gift()",
                       "UPDATE pg_trigger SET tgisinternal = true WHERE tgname = 'gift'"}
        << "trigger gift is not from this program";
}

void TestAudit::whatGuardsIsThere()
{
    QFETCH(QStringList, deeds);
    QFETCH(QString, finding);
    SCHOOL_RIG(rig);
    QVERIFY(checkDatabase(rig.school().db, {})->findings.empty());
    QSqlQuery query(rig.school().db);
    for (const QString& deed : deeds)
        QVERIFY2(query.exec(deed), qPrintable(query.lastError().text()));
    const auto report = checkDatabase(rig.school().db, {});
    VERIFY_DONE(report);
    QCOMPARE(report->findings.size(), std::size_t{1});
    QVERIFY2(support::wordsOf(report->findings).contains(finding), qPrintable(support::wordsOf(report->findings)));
}

/// A table of somebody's own beside the school, with what stands on it.
void TestAudit::whatStandsOnOthersTablesIsTheirs()
{
    SCHOOL_RIG(rig);
    QSqlQuery query(rig.school().db);
    QStringList deeds{"CREATE TABLE theirs (word TEXT NOT NULL, n INTEGER CHECK (n > 0))",
                      "CREATE UNIQUE INDEX theirs_by_n ON theirs (n)"};
    if (dialect::isPostgres(rig.school().db))
        deeds << "CREATE FUNCTION theirs_stamp() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN RETURN NEW; END $$"
              << "CREATE TRIGGER theirs_stamped BEFORE INSERT ON theirs FOR EACH ROW EXECUTE FUNCTION theirs_stamp()";
    else
        deeds << "CREATE TRIGGER theirs_stamped AFTER INSERT ON theirs BEGIN SELECT 1; END";
    for (const QString& deed : std::as_const(deeds))
        QVERIFY2(query.exec(deed), qPrintable(query.lastError().text()));
    const auto report = checkDatabase(rig.school().db, {});
    VERIFY_DONE(report);
    QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
}

/// One that is called like the server's user comes before the one in which the tables lie.
void TestAudit::aSchemaInFrontIsNoFinding()
{
    if (!support::sharedServer().fault().isEmpty())
        QSKIP(qPrintable(support::sharedServer().fault()));
    SchoolRig rig(true);
    QVERIFY(rig.isOpen());
    QSqlQuery query(rig.school().db);
    QVERIFY2(query.exec("CREATE SCHEMA school"), qPrintable(query.lastError().text()));
    rig.populate();
    const auto report = checkDatabase(rig.school().db, {});
    VERIFY_DONE(report);
    QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
}

void TestAudit::whatCannotBeLookedAtHidesNothingElse()
{
    SCHOOL_RIG(rig);
    rig.populate();
    VERIFY_DONE(support::addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500), {}));
    QSqlQuery query(rig.school().db);
    for (const char* deed : {"UPDATE attempts SET score_tenths = 999", "DROP TABLE exam_starts"})
        QVERIFY2(query.exec(deed), qPrintable(query.lastError().text()));
    const auto report = checkDatabase(rig.school().db, {});
    VERIFY_DONE(report);
    QVERIFY(!report->isWhole);
    const QString said = support::wordsOf(report->findings);
    for (const char* words : {"table exam_starts is no longer there", "was changed after it had been kept",
                              "the exams that were begun could not be looked at"})
        QVERIFY2(said.contains(words), qPrintable(said));
    QCOMPARE(report->auditCode, auditHead(rig.school())->code());
}

/// The better it fits, the rather it is taken: also for what the check itself asks.
void TestAudit::whatIsCalledLikeTheServersOwnIsFound()
{
    if (!support::sharedServer().fault().isEmpty())
        QSKIP(qPrintable(support::sharedServer().fault()));
    SchoolRig rig(true);
    QVERIFY(rig.isOpen());
    const QSqlDatabase& db = rig.school().db;
    QVERIFY(checkDatabase(db, {})->findings.empty());
    QSqlQuery query(db);
    for (const char* sql :
         {"CREATE FUNCTION concat(\"char\", \"char\", boolean) RETURNS text LANGUAGE sql AS $$ SELECT 'rpf' $$",
          "CREATE FUNCTION of_another_name(text) RETURNS text LANGUAGE sql AS $$ SELECT 'x' $$",
          "CREATE FUNCTION same(name, text) RETURNS boolean LANGUAGE sql AS $$ SELECT true $$",
          "CREATE OPERATOR = (LEFTARG = name, RIGHTARG = text, FUNCTION = same)",
          "CREATE OPERATOR === (LEFTARG = name, RIGHTARG = name, FUNCTION = nameeq)"})
        QVERIFY2(query.exec(sql), qPrintable(query.lastError().text()));
    const QString said = support::wordsOf(checkDatabase(db, {})->findings);
    for (const char* named : {"function public.concat(\"char\",\"char\",boolean)", "operator public.=(name,text)"})
        QVERIFY2(said.contains(QLatin1String(named) + " is not from this program"), qPrintable(said));
    QVERIFY2(!said.contains("another_name"), qPrintable(said));
}

/// Who may not make a schema beside it sees names alone, and is told: it is no fault of the school's.
void TestAudit::whoMayNotCompareIsTold()
{
    if (!support::sharedServer().fault().isEmpty())
        QSKIP(qPrintable(support::sharedServer().fault()));
    SchoolRig rig(true);
    QVERIFY(rig.isOpen());
    const QSqlDatabase& db = rig.school().db;
    QSqlQuery query(db);
    const QString role = "reader_" + QString::fromStdString(newUid());
    for (const char* sql : {"CREATE ROLE %1", "GRANT SELECT ON ALL TABLES IN SCHEMA public TO %1", "SET ROLE %1"})
        QVERIFY2(query.exec(QString::fromLatin1(sql).arg(role)), qPrintable(query.lastError().text()));
    const auto report = checkDatabase(db, {});
    VERIFY_DONE(report);
    QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
    const QString said = support::wordsOf(report->notes);
    QVERIFY2(said.contains("names alone"), qPrintable(said));
    QVERIFY(query.exec("RESET ROLE"));
    for (const char* sql : {"DROP OWNED BY %1", "DROP ROLE %1"})
        QVERIFY2(query.exec(QString::fromLatin1(sql).arg(role)), qPrintable(query.lastError().text()));
}

/// The end of the audit is cut off and the seal set back; then somebody logs in, and the station signs.
void TestAudit::workGoesOnBehindWhatWasSlippedIn_data()
{
    QTest::addColumn<bool>("onServer");
    QTest::addColumn<QList<qint64>>("slipped");
    QTest::addColumn<QString>("finding");
    QTest::addColumn<int>("findings");  // also the program's own note of what it found
    for (const bool onServer : {false, true}) {
        const auto row = [onServer](const char* name) -> QTestData& {
            return QTest::addRow("%s %s", name, onServer ? "postgresql" : "sqlite") << onServer;
        };
        row("one") << QList<qint64>{31} << "no signature covers audit row 31:" << 2;
        row("three") << QList<qint64>{31, 32, 33} << "no signature covers audit rows 31 to 33:" << 2;
        QList<qint64> many(1500);
        std::iota(many.begin(), many.end(), 31);
        row("many") << many << "no signature covers audit rows 31 to 1530:" << 2;
        row("far behind") << QList<qint64>{5000} << "no signature covers audit row 5000:" << 2;
        row("far apart") << QList<qint64>{40, 500, 501, 900} << "no signature covers audit rows 500 to 501:" << 4;
        row("beyond belief") << QList<qint64>{4'000'000'000'000'000'000}
                             << "no signature covers audit row 4000000000000000000:" << 1;
        row("where numbers end") << QList<qint64>{std::numeric_limits<qint64>::max() - 1}
                                 << "no signature covers audit row 9223372036854775806:" << 1;
    }
}

/// What was written before it and after it is looked at as ever.
void TestAudit::workGoesOnBehindWhatWasSlippedIn()
{
    QFETCH(QList<qint64>, slipped);
    QFETCH(QString, finding);
    QFETCH(int, findings);
    SCHOOL_RIG(rig);
    rig.populate();
    workUpTo(rig, 30);
    unlock(rig.school());
    slipIn(rig.school(), slipped);
    work(rig, 6);
    QSqlQuery query(rig.school().db);
    const auto found = checkAudit(rig.school().db, {});
    VERIFY_DONE(found);
    QVERIFY2(support::wordsOf(*found).contains(finding), qPrintable(support::wordsOf(*found)));
    QVERIFY2(static_cast<int>(found->size()) == findings, qPrintable(support::wordsOf(*found)));
    // What a report shows by now is an audit code.
    const std::string code = auditHead(rig.school())->code();
    QVERIFY2(isAuditCode(code), code.c_str());
    QCOMPARE(checkAudit(rig.school().db, {code})->size(), found->size());
    // The third one of that work.
    const qint64 changed = auditHead(rig.school())->seq - 3;
    QVERIFY(query.exec(QStringLiteral("UPDATE audit SET actor = 'nobody' WHERE seq = %1").arg(changed)));
    const QString said = support::wordsOf(*checkAudit(rig.school().db, {}));
    QVERIFY2(said.contains(QStringLiteral("row %1 (").arg(changed)), qPrintable(said));
}

/// Whenever the program has gone on behind what was slipped in.
void TestAudit::everyPlaceIsNamed()
{
    SCHOOL_RIG(rig);
    rig.populate();
    workUpTo(rig, 30);
    unlock(rig.school());
    QStringList places;
    for (int k = 0; k < 3; ++k) {
        const qint64 last = auditHead(rig.school())->seq;
        slipIn(rig.school(), {last + 5, last + 50, last + 51});
        places << QStringLiteral("no signature covers audit row %1:").arg(last + 5)
               << QStringLiteral("no signature covers audit rows %1 to %2:").arg(last + 50).arg(last + 51);
        work(rig, 4);
    }
    const auto found = checkAudit(rig.school().db, {});
    VERIFY_DONE(found);
    const QString said = support::wordsOf(*found);
    for (const QString& place : std::as_const(places))
        QVERIFY2(said.contains(place), qPrintable(said));
    // And the program's three notes of it.
    QVERIFY2(found->size() == 9 && said.count("did not end as they had been signed") == 3, qPrintable(said));
}

/// A station has made that signature, only long ago.
void TestAudit::aSealSetBackAccusesNobody()
{
    SCHOOL_RIG(rig);
    rig.populate();
    const School& school = rig.school();
    const qint64 back = auditHead(school)->seq;
    QSqlQuery query(school.db);
    QVERIFY(query.exec("CREATE TABLE old_seal AS SELECT * FROM audit_seal"));
    const auto setBack = [&query] {
        return query.exec("UPDATE audit_seal SET (seq, hash, signature, station_key) = (SELECT seq, hash, signature, "
                          "station_key FROM old_seal)");
    };
    workUpTo(rig, 30);
    unlock(school);
    QVERIFY2(setBack(), qPrintable(query.lastError().text()));
    const QString told =
        "no signature covers audit rows %1 to %2: they were inserted, or the signed head was set back, "
        "or the row behind them was changed";
    QCOMPARE(support::wordsOf(*checkAudit(school.db, {})), told.arg(back + 1).arg(30));
    // The program goes on from the row that is signed, and once more when it is set back again.
    for (const qint64 last : {qint64{30}, qint64{33}}) {
        QVERIFY2(setBack(), qPrintable(query.lastError().text()));
        work(rig, 2);
        const auto found = checkAudit(school.db, {});
        VERIFY_DONE(found);
        const QString said = support::wordsOf(*found);
        QVERIFY2(said.contains(told.arg(back + 1).arg(last)), qPrintable(said));
        QVERIFY2(said.contains(QStringLiteral("row %1 (").arg(last + 1)), qPrintable(said));
        QVERIFY2(found->size() == 2, qPrintable(said));
    }
}

/// To before it joined; it does not join again.
void TestAudit::aStationThatJoinedIsKnownWhenTheSealIsSetBack()
{
    SchoolRig rig(false);
    rig.populate();
    QSqlQuery query(rig.school().db);
    QVERIFY(query.exec("CREATE TABLE old_seal AS SELECT * FROM audit_seal"));
    const School other{rig.school().db, StationKey::make()};
    VERIFY_DONE(addAttempt(other, rig.student, SchoolRig::attempt("class1-36", 500), {}));
    QVERIFY(query.exec("UPDATE audit_seal SET (seq, hash, signature, station_key) = (SELECT seq, hash, signature, "
                       "station_key FROM old_seal)"));
    VERIFY_DONE(addAttempt(other, rig.student, SchoolRig::attempt("class1-36", 500), {}));
    const auto found = checkAudit(rig.school().db, {});
    VERIFY_DONE(found);
    const QString said = support::wordsOf(*found);
    QVERIFY2(found->size() == 2 && said.contains("no signature covers audit rows"), qPrintable(said));
}

void TestAudit::whatIsChainedBehindTheSealAccusesNobody()
{
    SCHOOL_RIG(rig);
    rig.populate();
    workUpTo(rig, 30);
    chain(rig, 31);
    chain(rig, 33);
    const auto found = checkAudit(rig.school().db, {});
    VERIFY_DONE(found);
    const QString said = support::wordsOf(*found);
    for (const char* place : {"no signature covers audit row 31:", "no signature covers audit row 33:"})
        QVERIFY2(said.contains(place), qPrintable(said));
    QVERIFY2(found->size() == 2, qPrintable(said));
}

/// Whatever somebody puts behind the signed row, wherever he sets the head back to, and whenever the program goes on:
/// of its own rows none is said to be changed, removed or moved. Where the head stayed, exactly the others are named.
void TestAudit::nothingGenuineIsAccused()
{
    static const QRegularExpression kNumber("row (\\d+) \\(");
    static const QRegularExpression kUnsigned("audit rows? (\\d+)(?: to (\\d+))?:");
    for (quint32 seed = 1; seed <= 60; ++seed) {
        QRandomGenerator random(seed);
        SchoolRig rig(false);
        rig.populate();
        unlock(rig.school());
        QSqlQuery query(rig.school().db);
        QVERIFY(query.exec("CREATE TABLE seals AS SELECT * FROM audit_seal"));
        const auto last = [&query] {
            return query.exec("SELECT MAX(seq) FROM audit") && query.next() ? query.value(0).toLongLong() : 0;
        };
        int seals = 1;
        std::set<qint64> others;
        for (int step = 0; step < 15; ++step)
            switch (random.bounded(seed % 2 == 0 ? 4 : 3)) {
            case 0:
                work(rig, random.bounded(1, 4));
                QVERIFY(query.exec("INSERT INTO seals SELECT * FROM audit_seal"));
                ++seals;
                break;
            case 1:
                others.insert(last() + random.bounded(1, 4));
                slipIn(rig.school(), {*others.rbegin()});
                break;
            case 2:
                others.insert(last() + 1);
                chain(rig, *others.rbegin(), random.bounded(3) == 0 ? "audit.broken" : "attempt.add");
                break;
            default:
                QVERIFY(query.exec(
                    QStringLiteral("UPDATE audit_seal SET (seq, hash, signature, station_key) = (SELECT seq, "
                                   "hash, signature, station_key FROM seals ORDER BY rowid LIMIT 1 OFFSET %1)")
                        .arg(random.bounded(seals))));
            }
        for (const bool hasGoneOn : {false, true}) {
            if (hasGoneOn)
                work(rig, 2);
            const QString said = support::wordsOf(*checkAudit(rig.school().db, {}));
            const QString where = QStringLiteral("seed %1:\n%2").arg(seed).arg(said);
            std::set<qint64> named;
            for (const QString& line : said.split(u'\n', Qt::SkipEmptyParts)) {
                if (const auto found = kUnsigned.match(line); found.hasMatch())
                    for (qint64 seq = found.captured(1).toLongLong();
                         seq <= std::max(found.captured(1).toLongLong(), found.captured(2).toLongLong()); ++seq)
                        named.insert(seq);
                else if (!line.contains("did not end as they had been signed"))
                    QVERIFY2(others.count(kNumber.match(line).captured(1).toLongLong()) == 1, qPrintable(where));
            }
            QVERIFY2(seed % 2 == 0 || named == others, qPrintable(where));
        }
    }
}

/// It follows from the one before it, but it is not what the station has signed.
void TestAudit::aSignedRowRewrittenIsNamed()
{
    SCHOOL_RIG(rig);
    rig.populate();
    workUpTo(rig, 30);
    unlock(rig.school());
    const auto newest = readAudit(rig.school(), rig.admin, 2);
    VERIFY_DONE(newest);
    AuditRow row = newest->front();
    row.actor = "nobody";
    QSqlQuery query(rig.school().db);
    QVERIFY2(query.exec(QStringLiteral("UPDATE audit SET actor = 'nobody', hash = '%1' WHERE seq = 30")
                            .arg(QString::fromStdString(hashOf(row, newest->back().hash)))),
             qPrintable(query.lastError().text()));
    const auto found = checkAudit(rig.school().db, {});
    VERIFY_DONE(found);
    const QString said = support::wordsOf(*found);
    QVERIFY2(found->size() == 1 && said.contains("row 30 (") && said.contains("is not the one that was signed"),
             qPrintable(said));
}

void TestAudit::aSealFarAwayMakesNobodyForeign_data()
{
    QTest::addColumn<bool>("onServer");
    QTest::addColumn<qint64>("seq");
    constexpr qint64 kMost = std::numeric_limits<qint64>::max();
    for (const bool onServer : {false, true})
        for (const qint64 seq : {qint64{5000}, kMost / 8, kMost / 8 + 1, kMost / 4 - 1, kMost / 4, kMost})
            QTest::addRow("%lld %s", static_cast<long long>(seq), onServer ? "postgresql" : "sqlite")
                << onServer << seq;
}

/// Whatever number somebody writes into it: the program's own next rows are told from those that were slipped in.
void TestAudit::aSealFarAwayMakesNobodyForeign()
{
    QFETCH(qint64, seq);
    SCHOOL_RIG(rig);
    rig.populate();
    workUpTo(rig, 30);
    QSqlQuery query(rig.school().db);
    QVERIFY(query.exec(QStringLiteral("UPDATE audit_seal SET seq = %1").arg(seq)));
    work(rig, 4);
    const auto found = checkAudit(rig.school().db, {});
    VERIFY_DONE(found);
    const QString said = support::wordsOf(*found);
    QVERIFY2(found->size() == 1 && said.contains("did not end as they had been signed"), qPrintable(said));
}

/// Whoever sets the signed number back hides nothing of what stands behind it.
void TestAudit::rowsBehindTheSignedOneAreLookedAt()
{
    SCHOOL_RIG(rig);
    rig.populate();
    while (auditHead(rig.school())->seq < 30)
        VERIFY_DONE(addAttempt(rig.school(), rig.student, SchoolRig::attempt("class1-36", 500), {}));
    const std::string code = auditHead(rig.school())->code();
    unlock(rig.school());
    QSqlQuery query(rig.school().db);
    QVERIFY(query.exec("UPDATE audit_seal SET seq = 10"));
    const QString back = support::wordsOf(*checkAudit(rig.school().db, {code}));
    QVERIFY2(back.contains("no signature covers audit rows 11 to 30:"), qPrintable(back));
    QVERIFY2(!back.contains("which a report names") && !back.contains("is not the one"), qPrintable(back));
    QVERIFY(query.exec("UPDATE audit SET actor = 'nobody' WHERE seq = 20"));
    const QString said = support::wordsOf(*checkAudit(rig.school().db, {code}));
    QVERIFY2(said.contains("row 20 ("), qPrintable(said));
}

void TestAudit::goingOnMakesNothingGood()
{
    SCHOOL_RIG(rig);
    rig.populate();
    unlock(rig.school());
    QSqlQuery query(rig.school().db);
    for (const char* deed : {"DELETE FROM audit WHERE seq > 20",
                             "UPDATE audit_seal SET seq = 20, hash = (SELECT hash FROM audit WHERE seq = 20)"})
        QVERIFY2(query.exec(QLatin1String(deed)), qPrintable(query.lastError().text()));
    QVERIFY(!checkAudit(rig.school().db, {})->empty());
    static_cast<void>(Logins::login(rig.school(), "s1001", "wrong"));
    VERIFY_DONE(Logins::login(rig.school(), "s1001", SchoolRig::kPassword));
    const auto found = checkAudit(rig.school().db, {});
    VERIFY_DONE(found);
    QCOMPARE(found->size(), std::size_t{1});
    const QString said = support::wordsOf(*found);
    QVERIFY2(said.contains("did not end as they had been signed"), qPrintable(said));
}

/// The end is cut off, and somebody signs the rest with a key that he has just made. A station that goes on from there
/// does not make it good.
void TestAudit::aStationThatNeverJoinedIsFound()
{
    SCHOOL_RIG(rig);
    rig.populate();
    unlock(rig.school());
    const auto joined = readAudit(rig.school(), rig.admin, 1, 2);
    QCOMPARE(joined->front().action, std::string("station.join"));
    QCOMPARE(joined->front().object, "station:" + rig.school().key.publicHex());
    const StationKey stranger = StationKey::make();
    QSqlQuery query(rig.school().db);
    QVERIFY2(query.exec("DELETE FROM audit WHERE seq > 8"), qPrintable(query.lastError().text()));
    QVERIFY(query.exec("SELECT hash FROM audit WHERE seq = 8") && query.next());
    const QString hash = query.value(0).toString();
    QVERIFY2(query.exec(QStringLiteral("UPDATE audit_seal SET seq = 8, hash = '%1', station_key = '%2', signature = "
                                       "'%3'")
                            .arg(hash, QString::fromStdString(stranger.publicHex()),
                                 QString::fromStdString(stranger.sign("cusp audit 8 " + hash.toStdString())))),
             qPrintable(query.lastError().text()));
    const auto found = checkAudit(rig.school().db, {});
    QCOMPARE(support::wordsOf(*found), "the newest row of the audit was signed with the key " +
                                           QString::fromStdString(stranger.publicHex()).left(12) +
                                           ", and the audit knows no station that has it");
    static_cast<void>(Logins::login(rig.school(), "admin", SchoolRig::kPassword));
    const auto after = checkAudit(rig.school().db, {});
    QVERIFY2(support::wordsOf(*after).contains("did not end as they had been signed"),
             qPrintable(support::wordsOf(*after)));
}

/// The chain and its signature are whole, and still it is not this computer's.
void TestAudit::whoeverElseSignsIsNamed()
{
    SchoolRig rig(false);
    rig.populate();
    const std::string own = rig.school().key.publicHex();
    QVERIFY(checkDatabase(rig.school().db, {}, {}, own)->findings.empty());
    const School stranger{rig.school().db, StationKey::make()};
    VERIFY_DONE(addAttempt(stranger, rig.student, SchoolRig::attempt("class1-36", 1000), {}));
    QVERIFY(checkDatabase(rig.school().db, {})->findings.empty());
    const auto report = checkDatabase(rig.school().db, {}, {}, own);
    QCOMPARE(report->findings.size(), std::size_t{1});
    QVERIFY(support::wordsOf(report->findings).contains("not this computer's"));
}

void TestAudit::namesOfPeopleAreNotInIt()
{
    SchoolRig rig(false);
    rig.populate();
    Person sam = findPerson(rig.school(), rig.admin, "s1001").value();
    sam.familyName = "Renamed";
    VERIFY_DONE(changePerson(rig.school(), rig.admin, sam));
    static_cast<void>(Logins::login(rig.school(), "s1001", "wrong"));
    const auto rows = readAudit(rig.school(), rig.admin, 1000);
    VERIFY_DONE(rows);
    for (const AuditRow& row : *rows)
        for (const char* name : {"Sam", "One", "Renamed", "s1001", "Ines", "wrong"})
            QVERIFY2((row.actor + row.object + row.detail).find(name) == std::string::npos, row.detail.c_str());
}

QTEST_GUILESS_MAIN(TestAudit)
#include "tst_audit.moc"
