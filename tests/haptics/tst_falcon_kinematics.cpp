// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/Rng.h"
#include "haptics/falcon/Kinematics.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using namespace haptics::falcon;

class TestFalconKinematics : public QObject
{
    Q_OBJECT
private slots:
    /// The values are from an independent implementation of libnifalcon's geometry in double precision.
    void anglesAreThoseOfTheMechanism_data()
    {
        support::columns<double, double, double, double, double, double, double>("x", "y", "z", "first", "second",
                                                                                 "third", "countedX");
        QTest::newRow("low") << 28.062 << -20.044 << 96.115 << 0.545611576362 << -0.287981649495 << 0.269044826920
                             << 28.036850514;
        QTest::newRow("left") << -22.490 << -28.551 << 131.838 << 0.874930068739 << 0.832449640743 << 0.272494060020
                              << -22.471960973;
        QTest::newRow("high") << -9.824 << -23.780 << 136.684 << 0.871764572233 << 0.734114109215 << 0.436526323371
                              << -9.832430290;
        QTest::newRow("middle") << 2.664 << -22.505 << 122.991 << 0.720412244236 << 0.413329367512 << 0.334908553407
                                << 2.672520273;
    }

    void anglesAreThoseOfTheMechanism()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        QFETCH(double, first);
        QFETCH(double, second);
        QFETCH(double, third);
        QFETCH(double, countedX);
        const auto arms = armsAt({x, y, z});
        QVERIFY(arms.has_value());
        const glm::dvec3 apart = arms->angleRad - glm::dvec3(first, second, third);
        QVERIFY2(glm::length(apart) < 1.0e-9, qPrintable(QString::number(glm::length(apart))));
        const auto counted = gripAt(roundedToCounts(arms->angleRad), kCentreMm);
        QVERIFY(counted.has_value());
        QVERIFY2(std::abs(counted->x - countedX) < 1.0e-4, qPrintable(QString::number(counted->x, 'f', 9)));
    }

    void thereAndBack()
    {
        core::Rng rng(5);
        for (int n = 0; n < 20000; ++n) {
            glm::dvec3 apart(rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0));
            if (glm::length(apart) > 1.0)
                continue;
            const glm::dvec3 grip = kCentreMm + apart * kReachMm;
            const auto arms = armsAt(grip);
            QVERIFY(arms.has_value());
            const auto back = gripAt(arms->angleRad, kCentreMm);
            QVERIFY(back.has_value());
            QVERIFY2(glm::length(*back - grip) < 1.0e-6, qPrintable(QString::number(glm::length(*back - grip))));
        }
    }

    void gradientIsThatOfTheAngles()
    {
        constexpr double kStepMm = 1.0e-4;
        const glm::dvec3 grip = kCentreMm + glm::dvec3(12.0, -7.0, 9.0);
        const Arms here = armsAt(grip).value();
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 aside(0.0);
            aside[axis] = kStepMm;
            const glm::dvec3 rise = (armsAt(grip + aside)->angleRad - armsAt(grip - aside)->angleRad) / (2.0 * kStepMm);
            for (int arm = 0; arm < 3; ++arm)
                QVERIFY(std::abs(rise[arm] - here.perMm[static_cast<std::size_t>(arm)][axis]) < 1.0e-8);
        }
    }

    /// The motors do the same work as the force at the grip.
    void torquesDoTheWorkOfTheForce()
    {
        const glm::dvec3 grip = kCentreMm + glm::dvec3(-20.0, 11.0, 14.0);
        const Arms here = armsAt(grip).value();
        const glm::dvec3 forceN(1.5, -2.0, 0.7);
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec3 turnRad(here.perMm[0][axis], here.perMm[1][axis], here.perMm[2][axis]);
            const double workNmm = 1000.0 * glm::dot(torquesNm(here, forceN), turnRad);
            QVERIFY(std::abs(workNmm - forceN[axis]) < 1.0e-9);
        }
        const glm::dvec3 counts = countsAt(roundedToCounts(here.angleRad));
        QVERIFY(glm::length(counts - glm::round(countsAt(here.angleRad))) < 1.0e-9);
    }

    /// The resolution of the three arms along an axis: one count divided by the slope of all angles.
    void oneCountIsSoMuchAtTheCentre()
    {
        const Arms arms = armsAt(kCentreMm).value();
        const auto quantumUm = [&](int axis) {
            const glm::dvec3 rise(arms.perMm[0][axis], arms.perMm[1][axis], arms.perMm[2][axis]);
            return 1000.0 * kCountRad / glm::length(rise);
        };
        QVERIFY2(std::abs(quantumUm(0) - 48.0) < 1.0, qPrintable(QString::number(quantumUm(0))));
        QVERIFY2(std::abs(quantumUm(1) - 48.0) < 1.0, qPrintable(QString::number(quantumUm(1))));
        QVERIFY2(std::abs(quantumUm(2) - 28.0) < 1.0, qPrintable(QString::number(quantumUm(2))));
    }

    /// The solver starts anywhere in the work area and finds any other place in it.
    void aPositionIsFoundFromFarAway()
    {
        core::Rng rng(3);
        const auto anywhere = [&] {
            glm::dvec3 away(1.0);
            while (glm::length(away) > 1.0)
                away = {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
            return kCentreMm + kReachMm * away;
        };
        double worst = 0.0;
        for (int n = 0; n < 100'000; ++n) {
            const glm::dvec3 wanted = anywhere();
            const auto found = gripAt(armsAt(wanted).value().angleRad, anywhere());
            QVERIFY(found.has_value());
            worst = std::max(worst, glm::distance(*found, wanted));
        }
        QVERIFY2(worst < 1.0e-6, qPrintable(QString::number(worst)));  // mm
    }

    void outOfReachIsNothing()
    {
        QVERIFY(!armsAt(kCentreMm + glm::dvec3(150.0, 0.0, 0.0)).has_value());
        QVERIFY(!armsAt(kCentreMm + glm::dvec3(0.0, 0.0, 100.0)).has_value());
        QVERIFY(!gripAt({9.0, 9.0, 9.0}, kCentreMm).has_value());
        QVERIFY(!gripAt(glm::dvec3(std::nan("")), kCentreMm).has_value());
    }

    void framesGoThereAndBack()
    {
        const glm::dvec3 tooth(1.0, 2.0, 3.0);
        QCOMPARE(toothFromDevice(deviceFromTooth(tooth)), tooth);
        QCOMPARE(deviceFromTooth({0.0, 0.0, 1.0}) - kCentreMm, glm::dvec3(0.0, 1.0, 0.0));
    }
};

CUSP_TEST(TestFalconKinematics)
#include "tst_falcon_kinematics.moc"
