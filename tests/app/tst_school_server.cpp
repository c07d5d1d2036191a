// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program at a school of many stations: a real PostgreSQL server, which goes, comes back and takes its time.
#include <QListView>
#include <QStandardPaths>

#include "database/sql/Classes.h"
#include "database/sql/Logins.h"
#include "tests/app/SchoolWindow.h"
#include "tests/support/OpenGlMain.h"
#include "tests/support/PostgresServer.h"

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

    void anAttemptArrivesOnceWhenTheServerReturns();
    void anAttemptOfUnknownFateIsOfferedLate();
    void whatCouldNotBeReadIsReadWhenTheServerReturns();
    void anotherSchoolInItsPlaceLetsNobodyStay();

private:
    support::PostgresServer m_postgres;
};

void TestSchoolServer::initTestCase()
{
    QVERIFY2(m_postgres.fault().isEmpty(), qPrintable(m_postgres.fault()));
}

void TestSchoolServer::init()
{
    makeSchool(m_postgres.newDatabase());
    qputenv("XDG_DATA_HOME", QFile::encodeName(m_folder->path()));  // where a station keeps its outbox
}

/// The server goes in the middle of the attempt.
void TestSchoolServer::anAttemptArrivesOnceWhenTheServerReturns()
{
    start();
    logIn("sam");
    goToTooth();
    drill(-2.0);
    m_postgres.kill();
    drill(2.0);
    grade("kept on this computer");
    QVERIFY(m_postgres.start());
    QTRY_VERIFY2_WITH_TIMEOUT(saved().contains("first grade"), qPrintable(saved()), kPatienceMs);
    QCOMPARE(attempts(), 1);
    // The next start delivers nothing again.
    m_application.reset();
    start();
    logIn("sam");
    actions().attempts->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("attempts")->model()->rowCount(), 1, kPatienceMs);
    QVERIFY(!child<QLabel>("attemptsWaiting")->isVisible());
    QCOMPARE(attempts(), 1);
}

/// Only the school knows whether a graded attempt was saved. Nobody waits for its answer, which comes late.
void TestSchoolServer::anAttemptOfUnknownFateIsOfferedLate()
{
    start();
    logIn("sam");
    goToTooth();
    drill(-2.0);
    const QString outbox = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/outbox";
    QFile inTheWay(outbox);
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    grade("not kept yet");
    switchTo("sue");
    m_application.reset();
    QVERIFY(inTheWay.remove());
    const OtherStation elsewhere(place());
    elsewhere.execute("BEGIN");
    elsewhere.execute("LOCK TABLE attempts IN ACCESS EXCLUSIVE MODE");
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QVERIFY(!isUnfinishedOffered());
    elsewhere.execute("ROLLBACK");
    QTRY_VERIFY_WITH_TIMEOUT(isUnfinishedOffered(), kPatienceMs);
}

/// By itself, on the page that is open.
void TestSchoolServer::whatCouldNotBeReadIsReadWhenTheServerReturns()
{
    start();
    logIn("ines");
    QTRY_COMPARE_WITH_TIMEOUT(studentsShown(), 1, kPatienceMs);
    m_postgres.stop();
    actions().readAgain->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("does not answer"), qPrintable(message()), kPatienceMs);
    QVERIFY(m_postgres.start());
    {
        const OtherStation elsewhere(place());
        const auto admin = elsewhere.logIn("admin");
        const ClassId ofClass = sql::listClasses(elsewhere.school, admin).value().front().id;
        QVERIFY(sql::enrol(elsewhere.school, admin, ofClass, {elsewhere.idOf("sue")}, true));
    }
    QTRY_COMPARE_WITH_TIMEOUT(studentsShown(), 2, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(message().isEmpty(), qPrintable(message()), kPatienceMs);
}

/// An admin drops the database, and gives its name to that of another school.
void TestSchoolServer::anotherSchoolInItsPlaceLetsNobodyStay()
{
    const QString other = m_postgres.newDatabase();
    QVERIFY(sql::Logins::createFirstAdmin(OtherStation(other).school, {"admin", "", "", Role::Admin},
                                          support::kPassword, {1, 8192}));
    start();
    logIn("ines");
    QTRY_COMPARE_WITH_TIMEOUT(studentsShown(), 1, kPatienceMs);
    const OtherStation beside(m_postgres.newDatabase());
    const QString name = place().section('/', -1);
    beside.execute("DROP DATABASE " + name + " WITH (FORCE)");
    beside.execute("ALTER DATABASE " + other.section('/', -1) + " RENAME TO " + name);
    actions().classes->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(isAtDoor() && door() == Door::Login, kPatienceMs);
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
