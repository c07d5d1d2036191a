// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program at a school of many stations: a real PostgreSQL server that stops, returns and is slow.
#include <QListView>
#include <QStandardPaths>

#include "database/sql/Classes.h"
#include "tests/app/SchoolWindow.h"
#include "tests/support/OpenGlMain.h"
#include "tests/support/PostgresServer.h"

using namespace database;
using support::OtherStation;

class TestSchoolServer : public support::SchoolWindow
{
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY2(m_postgres.fault().isEmpty(), qPrintable(m_postgres.fault())); }

    void init()
    {
        makeSchool(m_postgres.newDatabase());
        qputenv("XDG_DATA_HOME", QFile::encodeName(m_folder->path()));  // the station's outbox is in this folder
    }

    void cleanup() { m_application.reset(); }

    /// The server stops in the middle of the attempt.
    void anAttemptArrivesOnceWhenTheServerReturns()
    {
        startAs("sam");
        goToTooth();
        drill(-2.0);
        m_postgres.kill();
        drill(2.0);
        grade("saved on this computer");
        QVERIFY(m_postgres.start());
        waitForSaved("No earlier grades");
        QCOMPARE(attempts(), 1);
        // The next start of the program does not deliver the attempt again.
        m_application.reset();
        startAs("sam");
        openAttempts();
        WAIT_FOR_VALUE(child<QTableView>("attempts")->model()->rowCount(), 1);
        QVERIFY(!child<QLabel>("attemptsWaiting")->isVisible());
        QCOMPARE(attempts(), 1);
    }

    /// Only the database knows whether a graded attempt was saved. The window does not wait for its answer, which comes
    /// late.
    void anAttemptOfUnknownFateIsOfferedLate()
    {
        startAs("sam");
        goToTooth();
        drill(-2.0);
        const QString outbox = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/outbox";
        QFile inTheWay(outbox);
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        grade("not saved yet");
        switchTo("sue");
        m_application.reset();
        QVERIFY(inTheWay.remove());
        const OtherStation elsewhere(place());
        elsewhere.execute("BEGIN");
        elsewhere.execute("LOCK TABLE attempts IN ACCESS EXCLUSIVE MODE");
        startAs("sam");
        WAIT_FOR(child<QListView>("lessonList")->model()->rowCount() > 2);
        QVERIFY(!isUnfinishedOffered());
        elsewhere.execute("ROLLBACK");
        WAIT_FOR(isUnfinishedOffered());
    }

    /// The open page is reloaded without an action of the user.
    void whatCouldNotBeReadIsReadWhenTheServerReturns()
    {
        startAs("ines");
        WAIT_FOR_VALUE(studentsShown(), 1);
        m_postgres.stop();
        actions().readAgain->trigger();
        waitForMessage("does not answer");
        QVERIFY(m_postgres.start());
        {
            const OtherStation elsewhere(place());
            const auto admin = elsewhere.logIn("admin");
            const ClassId ofClass = sql::listClasses(elsewhere.school, admin).value().front().id;
            QVERIFY(sql::enrol(elsewhere.school, admin, ofClass, {elsewhere.idOf("sue")}, true));
        }
        WAIT_FOR_VALUE(studentsShown(), 2);
        WAIT_FOR(message().isEmpty());
    }

private:
    support::PostgresServer m_postgres;
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestSchoolServer>(argc, argv);
}

#include "tst_school_server.moc"
