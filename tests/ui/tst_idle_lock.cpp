// SPDX-License-Identifier: GPL-3.0-or-later
// After some time without input, the idle lock reports that the program is idle.
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/Suite.h"
#include "ui/window/IdleLock.h"

using namespace std::chrono_literals;
using ui::window::IdleLock;

class TestIdleLock : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_lock = std::make_unique<IdleLock>([this] { return m_now; }, nullptr);
        m_lock->setLimit(10min);
    }
    void cleanup() { m_lock.reset(); }

    void expiresAfterItsLimit()
    {
        QSignalSpy expired(m_lock.get(), &IdleLock::expired);
        pass(10min);
        QCOMPARE(expired.count(), 0);
        pass(1ms);
        QCOMPARE(expired.count(), 1);
        pass(1min);
        QCOMPARE(expired.count(), 2);
    }

    void waitsAgainAfterATouch()
    {
        QSignalSpy expired(m_lock.get(), &IdleLock::expired);
        pass(9min);
        m_lock->touch();
        pass(9min);
        QCOMPARE(expired.count(), 0);
        pass(2min);
        QCOMPARE(expired.count(), 1);
    }

    void keysAndMouseAreTouches()
    {
        QLineEdit field;
        QSignalSpy expired(m_lock.get(), &IdleLock::expired);
        pass(9min);
        QTest::keyClick(&field, Qt::Key_A);
        pass(9min);
        QTest::mouseClick(&field, Qt::LeftButton);
        pass(9min);
        QCOMPARE(expired.count(), 0);
    }

private:
    void pass(std::chrono::milliseconds time)
    {
        m_now += time;
        m_lock->check();
    }

    std::chrono::milliseconds m_now = 1h;
    std::unique_ptr<IdleLock> m_lock;
};

CUSP_TEST(TestIdleLock)
#include "tst_idle_lock.moc"
