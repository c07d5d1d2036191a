// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a student may begin another attempt at a lesson, on a school in memory.
#include <memory>

#include <QSignalSpy>
#include <QTest>

#include "app/school/AttemptLimit.h"
#include "tests/app/FakeSchool.h"
#include "tests/database/SchoolRig.h"

using app::AttemptLimit;

class TestAttemptLimit : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        // Only the database makes logins.
        const support::SchoolRig rig(support::populatedSchool(false));
        m_admin = rig.admin;
        m_student = rig.student;
    }
    void init()
    {
        m_fake = std::make_unique<support::FakeSchool>();
        m_fake->lessons.left = {{"used up", 0}, {"one left", 1}};
        m_session = {m_fake.get(), m_student};
        m_loads = {};
        m_limit = std::make_unique<AttemptLimit>(m_session, m_loads);
    }
    void cleanup() { m_limit.reset(); }

    void answersOfTheSchool_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<bool>("may");
        QTest::newRow("used up") << "used up" << false;
        QTest::newRow("one left") << "one left" << true;
        QTest::newRow("no limit") << "free" << true;
    }
    void answersOfTheSchool()
    {
        QFETCH(const QString, lesson);
        QFETCH(const bool, may);
        std::optional<bool> decided;
        m_limit->ask(lesson.toStdString(), [&](bool is) { decided = is; });
        QVERIFY(!decided);  // the database has not answered yet
        m_fake->answer();
        QCOMPARE(decided, std::optional(may));
    }

    /// A student may begin an attempt while the connection is lost. The attempt is counted when the database is back.
    void mayBeginWhileTheDatabaseIsLost()
    {
        m_fake->outage = core::Error{core::ErrorCode::ConnectionLost, "gone"};
        std::optional<bool> decided;
        m_limit->ask("used up", [&](bool is) { decided = is; });
        m_fake->answer();
        QCOMPARE(decided, std::optional(true));
    }

    void othersAreNotAsked()
    {
        int allowed = 0;
        m_session.user = m_admin;
        m_limit->ask("used up", [&](bool is) { allowed += is ? 1 : 0; });
        m_session.user = {};
        m_limit->ask("used up", [&](bool is) { allowed += is ? 1 : 0; });
        m_session = {nullptr, m_student};
        m_limit->ask("used up", [&](bool is) { allowed += is ? 1 : 0; });
        QCOMPARE(allowed, 3);
        QVERIFY(!m_fake->isAsked());
    }

    void refusesAUsedUpLesson()
    {
        const QSignalSpy usedUp(m_limit.get(), &AttemptLimit::usedUp);
        bool goes = false;
        bool isRefused = false;
        m_limit->whenAllowed(
            "used up", [&] { goes = true; }, [&] { isRefused = true; });
        m_fake->answer();
        QVERIFY(!goes && isRefused);
        QCOMPARE(usedUp.count(), 1);
    }

    /// The student has chosen another tooth while the request was pending.
    void aLaterRequestDropsTheAnswer()
    {
        const QSignalSpy usedUp(m_limit.get(), &AttemptLimit::usedUp);
        int calls = 0;
        for (const char* lesson : {"used up", "one left"})
            m_limit->whenAllowed(
                lesson, [&] { ++calls; }, [&] { ++calls; });
        m_loads.begin();
        m_fake->answer();
        QCOMPARE(calls, 0);
        QCOMPARE(usedUp.count(), 0);
    }

private:
    database::Login m_admin;
    database::Login m_student;
    std::unique_ptr<support::FakeSchool> m_fake;
    app::SchoolSession m_session;
    app::LatestRequest m_loads;
    std::unique_ptr<AttemptLimit> m_limit;
};

QTEST_GUILESS_MAIN(TestAttemptLimit)
#include "tst_attempt_limit.moc"
