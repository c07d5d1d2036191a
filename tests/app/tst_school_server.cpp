// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program at a school of many stations: a real PostgreSQL server, which goes, comes back and takes its time.
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QListView>
#include <QStandardPaths>
#include <QTableView>
#include <QTest>

#include "app/Application.h"
#include "database/sql/Classes.h"
#include "database/sql/Logins.h"
#include "database/sql/Statement.h"
#include "tests/app/SchoolWindow.h"
#include "tests/support/OpenGlMain.h"
#include "tests/support/PostgresServer.h"
#include "ui/people/ClassPage.h"

using namespace database;
using support::kPatienceMs;
using support::OtherStation;
using ui::people::Door;

class TestSchoolServer : public support::SchoolWindow
{
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup() { m_application.reset(); }

    void workGoesOnWithoutTheServer();
    void whatCouldNotBeReadIsReadWhenItCanBe();
    void whatWaitsIsNamedAmongTheAttempts();
    void whatALateAnswerDecidesIsOffered();
    void anotherSchoolInItsPlaceLetsNobodyStay_data();
    void anotherSchoolInItsPlaceLetsNobodyStay();

private:
    [[nodiscard]] QString offered() const { return child<QLabel>("continueWords")->text(); }

    support::PostgresServer m_postgres;
};

void TestSchoolServer::initTestCase()
{
    QVERIFY2(m_postgres.fault().isEmpty(), qPrintable(m_postgres.fault()));
}

void TestSchoolServer::init()
{
    makeSchool(m_postgres.newDatabase());
    qputenv("XDG_DATA_HOME", QFile::encodeName(m_folder->path()));  // where a station keeps what waits
}

/// In mid-attempt, as by a cable that is pulled. What was graded meanwhile arrives once.
void TestSchoolServer::workGoesOnWithoutTheServer()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    const QString before = removed();
    m_postgres.kill();
    drill(2.0);
    QVERIFY(removed() != before);
    grade("kept on this computer");
    QVERIFY(m_postgres.start());
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains("first grade"), qPrintable(keeping()), kPatienceMs);
    QCOMPARE(attemptsKept(), 1);
    // Nor is it sent again by the next who looks for what waits.
    m_application.reset();
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QTest::qWait(500);
    QCOMPARE(attemptsKept(), 1);
}

/// By itself, on the page that is open; and what was said against it goes.
void TestSchoolServer::whatCouldNotBeReadIsReadWhenItCanBe()
{
    start();
    logIn("ines");
    const auto* const matrix = child<QTableView>("matrix")->model();
    QTRY_COMPARE_WITH_TIMEOUT(matrix->rowCount(), 1, kPatienceMs);
    m_postgres.stop();
    actions().readAgain->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("does not answer"), qPrintable(message()), kPatienceMs);
    // What is wanted of it for a paper is told of where it was asked for.
    emit child<ui::people::ClassPage>()->pdfWanted();
    auto* const dialog = child<QFileDialog>("QFileDialog");
    QVERIFY(dialog != nullptr);
    emit dialog->fileSelected(m_folder->filePath("class.pdf"));
    dialog->reject();
    const auto* const said = child<ui::people::ClassPage>()->findChild<QLabel*>("said");
    QTRY_VERIFY2_WITH_TIMEOUT(said->text().contains("Nothing was written"), qPrintable(said->text()), kPatienceMs);
    QVERIFY(m_postgres.start());
    {
        const OtherStation elsewhere(place());
        const auto admin = elsewhere.logIn("admin");
        const ClassId ofClass = sql::listClasses(elsewhere.school, admin).value().front().id;
        const auto sue = sql::ask(elsewhere.school.db, "SELECT id FROM people WHERE username = 'sue'", "read").value();
        QVERIFY(sql::enrol(elsewhere.school, admin, ofClass, {sue.toLongLong()}, true));
    }
    QTRY_COMPARE_WITH_TIMEOUT(matrix->rowCount(), 2, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(message().isEmpty(), qPrintable(message()), kPatienceMs);
}

/// Another station holds what is written to; it can be read.
void TestSchoolServer::whatWaitsIsNamedAmongTheAttempts()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    const OtherStation elsewhere(place());
    QVERIFY(sql::execute(elsewhere.school.db, "BEGIN", "lock"));
    QVERIFY(sql::execute(elsewhere.school.db, "LOCK TABLE attempts IN SHARE MODE", "lock"));
    grade("kept on this computer");
    actions().attempts->trigger();
    const auto* const waiting = child<QLabel>("attemptsWaiting");
    const auto* const attempts = child<QTableView>("attempts")->model();
    QTRY_VERIFY_WITH_TIMEOUT(waiting->isVisible(), kPatienceMs);
    QVERIFY2(waiting->text().startsWith("1 attempt waits"), qPrintable(waiting->text()));
    QCOMPARE(attempts->rowCount(), 0);
    QVERIFY(sql::execute(elsewhere.school.db, "ROLLBACK", "lock"));
    QTRY_COMPARE_WITH_TIMEOUT(attempts->rowCount(), 1, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(!waiting->isVisible(), kPatienceMs);
}

/// Whether an attempt that was graded is kept, only the school knows; until it says so nobody waits, nor is it
/// forgotten.
void TestSchoolServer::whatALateAnswerDecidesIsOffered()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    QFile inTheWay(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/outbox");
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    grade("not kept yet");
    leaveFor("sue");
    m_application.reset();
    QVERIFY(inTheWay.remove());
    const OtherStation elsewhere(place());
    QVERIFY(sql::execute(elsewhere.school.db, "BEGIN", "lock"));
    QVERIFY(sql::execute(elsewhere.school.db, "LOCK TABLE attempts IN ACCESS EXCLUSIVE MODE", "lock"));
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QTest::qWait(2000);
    QVERIFY2(!offered().contains("Continue where I stopped"), qPrintable(offered()));
    QVERIFY(sql::execute(elsewhere.school.db, "ROLLBACK", "lock"));
    QTRY_VERIFY2_WITH_TIMEOUT(offered().contains("Continue where I stopped"), qPrintable(offered()), kPatienceMs);
}

void TestSchoolServer::anotherSchoolInItsPlaceLetsNobodyStay_data()
{
    QTest::addColumn<bool>("isEmptyFirst");
    QTest::newRow("at once") << false;
    QTest::newRow("it is made where an empty one was seen") << true;
}

/// As an admin does who drops the database, makes it anew and copies a school into it.
void TestSchoolServer::anotherSchoolInItsPlaceLetsNobodyStay()
{
    QFETCH(bool, isEmptyFirst);
    const auto makeIn = [](const QString& at) {
        const OtherStation elsewhere(at);
        QVERIFY(sql::Logins::createFirstAdmin(elsewhere.school, {"admin", "", "", Role::Admin}, support::kPassword,
                                              {1, 8192}));
    };
    start();
    logIn("ines");
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount(), 1, kPatienceMs);
    const QString name = place().section('/', -1);
    const auto beside = sql::Database::open(m_postgres.newDatabase()).value();
    QVERIFY(sql::execute(beside->handle(), "DROP DATABASE " + name + " WITH (FORCE)", "drop it"));
    if (isEmptyFirst) {
        QVERIFY(sql::execute(beside->handle(), "CREATE DATABASE " + name, "make it"));
        actions().classes->trigger();
        QTRY_VERIFY2_WITH_TIMEOUT(message().contains("says no"), qPrintable(message()), kPatienceMs);
        makeIn(place());
        actions().readAgain->trigger();
    } else {
        const QString other = m_postgres.newDatabase();
        makeIn(other);
        QVERIFY(sql::execute(beside->handle(), "ALTER DATABASE " + other.section('/', -1) + " RENAME TO " + name,
                             "rename it"));
        actions().classes->trigger();
    }
    QTRY_VERIFY_WITH_TIMEOUT(m_application->window().isAtDoor() && door() == Door::Login, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(saidAtDoor().contains("Another school is now where yours was"), qPrintable(saidAtDoor()),
                              kPatienceMs);
    logIn("admin");
    QCOMPARE(count("people"), 1);
}

int main(int argc, char** argv)
{
    return support::openGlMain<TestSchoolServer>(argc, argv);
}

#include "tst_school_server.moc"
