// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program at a school of many stations: a real PostgreSQL server, which goes, comes back and takes its time.
#include <QFile>
#include <QLabel>
#include <QListView>
#include <QStandardPaths>
#include <QTest>

#include "app/Application.h"
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
    void whatALateAnswerDecidesIsOffered();
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

/// As an admin does who drops the database, makes it anew and copies a school into it.
void TestSchoolServer::anotherSchoolInItsPlaceLetsNobodyStay()
{
    const QString other = m_postgres.newDatabase();
    {
        const OtherStation elsewhere(other);
        QVERIFY(sql::Logins::createFirstAdmin(elsewhere.school, {"admin", "", "", Role::Admin}, support::kPassword,
                                              {1, 8192}));
    }
    start();
    logIn("ines");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::ClassPage>()->isVisible(), kPatienceMs);
    {
        const auto beside = sql::Database::open(m_postgres.newDatabase()).value();
        const QString name = place().section('/', -1);
        for (const QString& step : {"DROP DATABASE " + name + " WITH (FORCE)",
                                    "ALTER DATABASE " + other.section('/', -1) + " RENAME TO " + name})
            QVERIFY(sql::execute(beside->handle(), step, "put another in its place"));
    }
    actions().classes->trigger();
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
