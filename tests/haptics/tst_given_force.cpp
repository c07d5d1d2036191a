// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <chrono>
#include <thread>

#include "haptics/falcon/GivenForce.h"
#include "tests/support/Suite.h"

using namespace std::chrono_literals;
using haptics::falcon::GivenForce;

namespace {

const GivenForce::Clock::time_point kFirst{1s};
const GivenForce::Clock::time_point kSecond{2s};

GivenForce::Value answering(GivenForce::Clock::time_point request)
{
    return {glm::dvec3(0.0, 0.0, 1.0), request, request};
}

GivenForce::Clock::time_point in(std::chrono::milliseconds time)
{
    return GivenForce::Clock::now() + time;
}

}  // namespace

class TestGivenForce : public QObject
{
    Q_OBJECT
private slots:
    void takesAForceThatWasGivenBefore()
    {
        GivenForce force;
        force.give(answering(kFirst));
        QVERIFY(force.waitFor(kFirst, in(0ms)));
        QCOMPARE(force.latest().forceN.z, 1.0);
    }

    void anOlderForceIsNoAnswer()
    {
        GivenForce force;
        QVERIFY(!force.waitFor(kFirst, in(1ms)));
        force.give(answering(kFirst));
        QVERIFY(!force.waitFor(kSecond, in(1ms)));
        force.give(answering(kSecond));
        QVERIFY(force.waitFor(kSecond, in(0ms)));
    }

    void waitsPastTheSignalOfAnOlderForce()
    {
        GivenForce force;
        force.give(answering(kFirst));
        std::thread servo([&force] { force.give(answering(kSecond)); });
        QVERIFY(force.waitFor(kSecond, in(20s)));
        QVERIFY(force.latest().answers == kSecond);
        servo.join();
    }
};

CUSP_TEST(TestGivenForce)
#include "tst_given_force.moc"
