// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of a timed lesson runs while the student works, and ends once.
#include <QTest>

#include "tests/support/Suite.h"
#include "ui/window/ExamClock.h"

using ui::window::ExamClock;

class TestExamClock : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_recordedS = 0.0;
        m_clock.begin(60.0);
    }

    void countsRecordedTime()
    {
        QCOMPARE(m_clock.workedS(), 0.0);
        QVERIFY(!passes(12.0));
        QCOMPARE(m_clock.workedS(), 12.0);
    }

    void pausesWhileTheStudentDoesNotWork()
    {
        QVERIFY(!passes(10.0));
        QVERIFY(!passes(500.0, false));
        QCOMPARE(m_clock.workedS(), 10.0);
        QVERIFY(!passes(5.0));
        QCOMPARE(m_clock.workedS(), 15.0);
    }

    void endsOnce()
    {
        QVERIFY(!passes(60.0));
        QVERIFY(passes(0.1));
        QVERIFY(!passes(10.0));
        m_clock.begin(60.0);
        m_recordedS = 0.0;
        QVERIFY(!passes(59.0));
        QVERIFY(passes(2.0));
    }

    void doesNotEndDuringAPause()
    {
        QVERIFY(!passes(59.0));
        QVERIFY(!passes(100.0, false));
        QVERIFY(!passes(0.5));
        QVERIFY(passes(1.0));
    }

    void doesNotEndWithoutALimitOrAfterTheExam()
    {
        m_clock.begin(0.0);
        QVERIFY(!passes(100'000.0));
        m_recordedS = 0.0;
        m_clock.begin(60.0);
        m_clock.stop();
        QVERIFY(!passes(61.0));
    }

    void resumesWhereTheAttemptWasInterrupted()
    {
        m_recordedS = 100.0;
        m_clock.resume(100.0, 40.0);
        QCOMPARE(m_clock.workedS(), 40.0);
        QVERIFY(!passes(20.0));
        QCOMPARE(m_clock.workedS(), 60.0);
        QVERIFY(passes(1.0));
    }

    /// Undo may set the recorded time back before the pauses are known.
    void neverGoesBelowZero()
    {
        m_clock.resume(10.0, 0.0);
        m_recordedS = 4.0;
        QVERIFY(!m_clock.advance(true));
        QCOMPARE(m_clock.workedS(), 0.0);
    }

private:
    [[nodiscard]] bool passes(double seconds, bool isWorking = true)
    {
        m_recordedS += seconds;
        return m_clock.advance(isWorking);
    }

    double m_recordedS = 0.0;
    ExamClock m_clock{[this] { return m_recordedS; }};
};

CUSP_TEST(TestExamClock)
#include "tst_exam_clock.moc"
