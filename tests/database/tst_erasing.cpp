// SPDX-License-Identifier: GPL-3.0-or-later
// Erasing a person: what goes, what stays, and what the check of the database finds afterwards.
#include <algorithm>

#include <QProcess>
#include <QSqlError>
#include <QSqlQuery>
#include <QTest>

#include "database/sql/Erasing.h"
#include "database/sql/Overview.h"
#include "database/sql/People.h"
#include "database/sql/Roster.h"
#include "database/sql/RowSum.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Suite.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::SchoolRig;

namespace {

const NewPerson kZoe{"zoe.quill", "Zoebelle", "Quillfeather", Role::Student};
/// What the database knows of her that must go.
const QStringList kPersonal{"zoe.quill",      "Zoebelle",       "Quillfeather",
                            "holds it badly", "improved a lot", "own-language"};

/// Returns the content of all tables, as text.
QString everythingIn(const QSqlDatabase& db)
{
    QString all;
    for (const QString& table : db.tables()) {
        const QString columns = columnsOf(db, table).join(',');
        const auto read = forEach(db, QStringLiteral("SELECT %1 FROM %2").arg(columns, table), "read all", {},
                                  [&](const QSqlQuery& row) {
                                      for (const QVariant& value : valuesOf(row, 0))
                                          all += value.toString() + '\n';
                                  });
        if (!read)
            qWarning("%s", read.error().detail.c_str());
    }
    return all;
}

/// Returns the bytes of an SQLite file and of its write-ahead log. Another process reads them, because closing the file
/// in this one would release the locks of its connections.
QByteArray bytesOf(const QString& path)
{
    QProcess cat;
    cat.start(QStringLiteral("cat"), {path, path + "-wal"});
    return cat.waitForFinished() ? cat.readAllStandardOutput() : QByteArray();
}

/// Returns whether a statement is refused, or changes no row.
bool isRefused(const QSqlDatabase& db, const QString& sql)
{
    QSqlQuery query(db);
    return !query.exec(sql) || query.numRowsAffected() == 0;
}

const QString kMark = QString::fromUtf8(kErasedText);

}  // namespace

class TestErasing : public QObject
{
    Q_OBJECT

private slots:
    /// Otherwise the person of that number could not be erased.
    void aPseudonymIsNobodysUsername_data() { support::addEngines(); }
    void aPseudonymIsNobodysUsername()
    {
        COPY_OF(support::populatedSchool, rig);
        const std::string pseudonym = "erased-" + rig.student.uid().substr(0, 12);
        VERIFY_REFUSED(addPerson(rig.school(), rig.admin, {pseudonym, "A", "B", Role::Student}),
                       core::ErrorCode::OutOfRange);
        VERIFY_DONE(addPerson(rig.school(), rig.admin, {"erased-nobody", "A", "B", Role::Student}));
        VERIFY_DONE(erasePerson(rig.school(), rig.admin, rig.student.person()));
    }

    void whatIsPersonalGoesAndTheAttemptsStay_data() { support::addEngines(); }
    void whatIsPersonalGoesAndTheAttemptsStay()
    {
        COPY_OF(support::populatedSchool, rig);
        fill(rig);
        const DatabaseContext& school = rig.school();
        QString all = everythingIn(school.db);
        for (const QString& personal : kPersonal)
            QVERIFY2(all.contains(personal), qPrintable(personal));
        const QString hash =
            ask(school.db, "SELECT password_hash FROM people WHERE username = 'zoe.quill'", "read")->toString();
        const QString nameKey = QString::fromStdString(digestOf(kZoe.username));
        QVERIFY(!hash.isEmpty() && all.contains(hash) && all.contains(nameKey));
        const int attempts = rig.count("attempts");
        const auto standing = standingsOf(school, rig.admin, m_zoe.person());

        const auto erased = erasePerson(school, rig.admin, m_zoe.person());
        VERIFY_DONE(erased);
        QVERIFY(erased->isFileClean && erased->person.isErased());
        QCOMPARE(erased->person.username, "erased-" + m_zoe.uid().substr(0, 12));

        all = everythingIn(school.db);
        for (const QString& personal : kPersonal + QStringList{hash, nameKey})
            QVERIFY2(!all.contains(personal), qPrintable(personal));
        // Texts about others stay, and so do all attempts and scores.
        QVERIFY(all.contains("neat work") && all.contains("of the classmate"));
        QCOMPARE(rig.count("attempts"), attempts);
        QCOMPARE(rig.count("attempts WHERE given_tenths = 900"), 1);
        QCOMPARE(standingsOf(school, rig.admin, m_zoe.person()).value(), standing.value());
        QCOMPARE(rig.count("comments WHERE words = '" + kMark + "'"), 2);
        // The person is in no class any more. The list of people has the pseudonym.
        QCOMPARE(rig.count("enrolments WHERE person_id = " + QString::number(m_zoe.person().value)), 0);
        const auto overview = classOverview(school, rig.instructor, rig.first);
        VERIFY_DONE(overview);
        for (const MatrixStudent& student : overview->students)
            QVERIFY(student.id.value != m_zoe.person().value);
        const Person listed = findPerson(school, rig.admin, erased->person.username).value();
        QCOMPARE(listed, erased->person);
        QVERIFY(listed.disabled && !listed.hasPassword && listed.fullName().empty() && listed.lastLoginUtc.empty());
        // The audit tells who has erased whom, and everything is as it was noted.
        QVERIFY(
            rig.count(QStringLiteral("audit WHERE action = 'person.erase' AND actor = '%1' AND object = 'person:%2'")
                          .arg(QString::fromStdString(rig.admin.uid()), QString::fromStdString(m_zoe.uid()))) == 1);
        QCOMPARE(support::faultsOf(school.db), QString());
    }

    /// Neither the file nor its write-ahead log contains the names, even while another program has the file open.
    void theBytesOfTheFileAreGone()
    {
        SchoolRig rig(support::populatedSchool(false));
        const support::Station elsewhere(rig.address());
        QCOMPARE(ask(elsewhere.school().db, "SELECT count(*) FROM people", "read")->toInt(), 6);
        fill(rig);
        QVERIFY(bytesOf(rig.address()).contains("Quillfeather"));
        QVERIFY(erasePerson(rig.school(), rig.admin, m_zoe.person())->isFileClean);
        for (const QString& personal : kPersonal)
            QVERIFY2(!bytesOf(rig.address()).contains(personal.toUtf8()), qPrintable(personal));
        rig.close();
        for (const QString& personal : kPersonal)
            QVERIFY2(!bytesOf(rig.address()).contains(personal.toUtf8()), qPrintable(personal));
    }

    /// A row that moved to another page has left a copy behind, which is in no row any more.
    void copiesInUnusedPartsAreGone()
    {
        SchoolRig rig(support::populatedSchool(false));
        rig.run(
            {"WITH RECURSIVE k(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM k WHERE i < 1499) INSERT INTO people "
             "(uid, username, given_name, family_name, role, password_hash, reset_hash, reset_until_utc, disabled, "
             "created_utc, last_login_utc) SELECT printf('%032d', i), printf('copied%06d', i * 7919 % 1000003), "
             "'G', 'F', 'student', '', '', '', 0, '2026-11-20T10:15:00Z', '' FROM k",
             QStringLiteral("UPDATE people SET password_hash = '%1' WHERE password_hash = ''").arg(QString(97, 'x')),
             "PRAGMA wal_checkpoint(TRUNCATE)"});
        const auto timesIn = [](const QByteArray& bytes, const std::string& name) {
            return bytes.count(QByteArray::fromStdString(name));
        };
        const QByteArray before = bytesOf(rig.address());
        const auto people = listPeople(rig.school(), rig.admin);
        VERIFY_DONE(people);
        Person copied;
        for (const Person& person : *people)
            // A username is in its row and in an index.
            if (person.username.starts_with("copied") && timesIn(before, person.username) > 2)
                copied = person;
        QVERIFY(copied.id.value > 0);
        QVERIFY(erasePerson(rig.school(), rig.admin, copied.id)->isFileClean);
        QCOMPARE(timesIn(bytesOf(rig.address()), copied.username), 0);
    }

    /// While another program reads the file, its write-ahead log keeps what that program reads.
    void aFileThatIsBeingReadIsSaidToBeUnclean()
    {
        SchoolRig rig(support::populatedSchool(false));
        fill(rig);
        const support::Station elsewhere(rig.address());
        rig.run({"UPDATE people SET last_login_utc = last_login_utc"});
        VERIFY_DONE(execute(elsewhere.school().db, "BEGIN", "read"));
        VERIFY_DONE(ask(elsewhere.school().db, "SELECT count(*) FROM people", "read"));
        const auto erased = erasePerson(rig.school(), rig.admin, m_zoe.person());
        VERIFY_DONE(erased);
        QVERIFY(!erased->isFileClean && erased->person.isErased());
        VERIFY_DONE(execute(elsewhere.school().db, "ROLLBACK", "read"));
    }

    void anErasedTeacherLeavesTheScoresThatTheyGave_data() { support::addEngines(); }
    void anErasedTeacherLeavesTheScoresThatTheyGave()
    {
        COPY_OF(support::populatedSchool, rig);
        fill(rig);
        VERIFY_DONE(erasePerson(rig.school(), rig.admin, rig.instructor.person()));
        const auto talk = readTalk(rig.school(), rig.admin, m_attempt);
        VERIFY_DONE(talk);
        QCOMPARE(talk->comments.front().words, std::string(kErasedText));
        QCOMPARE(talk->overrides.front().reason, std::string("improved a lot"));
        QCOMPARE(talk->overrides.front().author.rfind("erased-", 0), std::size_t{0});
        QCOMPARE(support::faultsOf(rig.school().db), QString());
        VERIFY_REFUSED(addComment(rig.school(), rig.instructor, m_attempt, {"again", {}, {}}), ErrorCode::Disabled);
        // Both are erased: a text of the one about the other is erased once more.
        VERIFY_DONE(erasePerson(rig.school(), rig.admin, m_zoe.person()));
        QCOMPARE(support::faultsOf(rig.school().db), QString());
    }

    void whatCannotBeErased_data() { support::addEngines(); }
    void whatCannotBeErased()
    {
        COPY_OF(support::populatedSchool, rig);
        fill(rig);
        const DatabaseContext& school = rig.school();
        const auto head = auditHead(school)->seq;
        VERIFY_REFUSED(erasePerson(school, rig.admin, rig.admin.person()), ErrorCode::NobodyLeft, "the last admin");
        VERIFY_REFUSED(erasePerson(school, rig.admin, {4711}), ErrorCode::UnknownName,
                       "nobody here has the number 4711");
        VERIFY_REFUSED(erasePerson(school, rig.instructor, m_zoe.person()), ErrorCode::NotAllowed);
        QCOMPARE(auditHead(school)->seq, head);
        const Login second = rig.join({"admin2", "", "", Role::Admin}, rig.first);
        VERIFY_REFUSED(erasePerson(school, rig.admin, rig.admin.person()), ErrorCode::NotAllowed,
                       "the account that you are using");
        QCOMPARE(findPerson(school, second, "admin")->fullName(), std::string("Ada Admin"));
        VERIFY_DONE(erasePerson(school, second, rig.admin.person()));
        VERIFY_REFUSED(erasePerson(school, second, rig.admin.person()), ErrorCode::ChangedSince, "erased already");
        VERIFY_REFUSED(erasePerson(school, rig.admin, m_zoe.person()), ErrorCode::Disabled);
        QCOMPARE(support::faultsOf(school.db), QString());
    }

    void anErasedPersonDoesNotComeBack_data() { support::addEngines(); }
    void anErasedPersonDoesNotComeBack()
    {
        COPY_OF(support::populatedSchool, rig);
        fill(rig);
        const DatabaseContext& school = rig.school();
        Person person = erasePerson(school, rig.admin, m_zoe.person())->person;
        const std::string pseudonym = person.username;
        VERIFY_REFUSED(resetPassword(school, rig.admin, person.id), ErrorCode::ChangedSince, "cannot come back");
        person.disabled = false;
        VERIFY_REFUSED(changePerson(school, rig.admin, person), ErrorCode::ChangedSince, "cannot come back");
        person.disabled = true;
        person.familyName = "Quillfeather";
        VERIFY_REFUSED(changePerson(school, rig.admin, person), ErrorCode::ChangedSince, "cannot come back");
        VERIFY_REFUSED(rig.logIn(pseudonym), ErrorCode::WrongLogin);
        VERIFY_REFUSED(rig.logIn(kZoe.username), ErrorCode::WrongLogin);
        const auto back = importRoster(school, rig.admin, "username,class\n" + pseudonym + ",DEN101-A\n", false);
        VERIFY_DONE(back);
        QVERIFY(back->faults.size() == 1 && back->faults.front().kind == RosterFault::Kind::Erased);
        // The same username again is another person.
        const auto anew = importRoster(school, rig.admin, "username\nzoe.quill\n", false);
        VERIFY_DONE(anew);
        QVERIFY(anew->faults.empty() && anew->people.front().isNew);
        QVERIFY(findPerson(school, rig.admin, "zoe.quill")->uid != m_zoe.uid());
        QCOMPARE(support::faultsOf(school.db), QString());
    }

    /// A station delivers an attempt that had to wait until after its person was erased.
    void aLateAttemptArrivesUnderThePseudonym_data() { support::addEngines(); }
    void aLateAttemptArrivesUnderThePseudonym()
    {
        COPY_OF(support::populatedSchool, rig);
        fill(rig);
        VERIFY_DONE(erasePerson(rig.school(), rig.admin, m_zoe.person()));
        const auto late = rig.add(m_zoe, "class1-36", 800, "2026-11-20T10:10:00Z", "late");
        VERIFY_DONE(late);
        QCOMPARE(openAttempt(rig.school(), rig.admin, *late)->personUid, m_zoe.uid());
        QCOMPARE(support::faultsOf(rig.school().db), QString());
    }

    /// The mark hides no text of somebody who was not erased.
    void aTextThatSomebodyElseBlanksIsFound_data() { support::addEngines(); }
    void aTextThatSomebodyElseBlanksIsFound()
    {
        COPY_OF(support::populatedSchool, rig);
        fill(rig);
        const QSqlDatabase db = rig.school().db;
        const QString blank = QStringLiteral("UPDATE overrides SET reason = '%1' WHERE attempt_id = ").arg(kMark);
        const QString zoes = QString::number(m_attempt.value);
        QVERIFY(isRefused(db, blank + zoes));
        VERIFY_DONE(erasePerson(rig.school(), rig.admin, m_zoe.person()));
        // Only the mark may be written, and only into a reason about an erased person.
        QVERIFY(isRefused(db, blank + QString::number(m_classmates.value)));
        QVERIFY(isRefused(db, "UPDATE overrides SET reason = 'very good' WHERE attempt_id = " + zoes));
        QVERIFY(isRefused(db, QStringLiteral("UPDATE overrides SET reason = '%1', given_tenths = 1000 WHERE attempt_id "
                                             "= %2")
                                  .arg(kMark, zoes)));
        QVERIFY(isRefused(db, "DELETE FROM overrides"));
        QCOMPARE(support::faultsOf(db), QString());
        rig.run({QStringLiteral("UPDATE comments SET words = '%1' WHERE words = 'of the classmate'").arg(kMark)});
        const QString said = support::faultsOf(db);
        QVERIFY2(said.contains("table comments differs from the audit") && !said.contains('\n'), qPrintable(said));
    }

    /// An instructor who signs rows of their own cannot note the erasing of a text.
    void onlyAnAdminErases_data() { support::addEngines(); }
    void onlyAnAdminErases()
    {
        COPY_OF(support::populatedSchool, rig);
        const DatabaseContext& school = rig.school();
        VERIFY_DONE(inTurn(school, "forge", [&] {
            return note(school, rig.instructor.uid(), "attempt.comment.erase", "attempt:" + newUid());
        }));
        QVERIFY(support::faultsOf(school.db).contains("did not permit attempt.comment.erase"));
    }

private:
    /// Adds a student with everything that the database can know of a person.
    void fill(SchoolRig& rig)
    {
        const DatabaseContext& school = rig.school();
        m_zoe = rig.join(kZoe, rig.first);
        m_attempt = rig.add(m_zoe, "class1-36", 700).value();
        m_classmates = rig.add(rig.classmate, "class1-36", 600).value();
        VERIFY_DONE(rig.add(m_zoe, "class1-37", 400));
        VERIFY_DONE(addComment(school, rig.instructor, m_attempt, {"Zoebelle holds it badly", {}, {}}));
        const auto withdrawn = addComment(school, rig.instructor, m_attempt, {"Quillfeather again", {}, {}});
        VERIFY_DONE(withdrawn);
        VERIFY_DONE(withdrawComment(school, rig.instructor, *withdrawn));
        VERIFY_DONE(addComment(school, rig.instructor, m_classmates, {"of the classmate", {}, {}}));
        VERIFY_DONE(overrideScore(school, rig.instructor, m_attempt, 900, "improved a lot"));
        VERIFY_DONE(overrideScore(school, rig.instructor, m_classmates, 650, "neat work"));
        VERIFY_DONE(changeOwnSetting(school, m_zoe, "own-language", "de"));
        VERIFY_REFUSED(rig.logIn(kZoe.username, "wrong"), ErrorCode::WrongLogin);
        QCOMPARE(support::faultsOf(school.db), QString());
    }

    Login m_zoe;
    AttemptId m_attempt;     ///< hers, with a comment, a withdrawn comment and an override
    AttemptId m_classmates;  ///< with a comment and an override
};

CUSP_TEST(TestErasing)
#include "tst_erasing.moc"
