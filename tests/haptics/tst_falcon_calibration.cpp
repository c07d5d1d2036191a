// SPDX-License-Identifier: GPL-3.0-or-later
// The placement of a Falcon, the commands to its motors, and its calibration with a ruler and a weight.
#include <cmath>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/base/Rng.h"
#include "haptics/falcon/CalibrationSteps.h"
#include "haptics/falcon/Kinematics.h"
#include "haptics/falcon/Placement.h"
#include "tests/support/Suite.h"

using core::session::DeviceSetup;
using namespace haptics::falcon;

class TestFalconCalibration : public QObject
{
    Q_OBJECT
private slots:
    void uprightInFrontIsTheUsualFrame();
    void everyPlacementTurnsBackAndForth();
    void theTopOfTheToothIsAtTheHeightOfTheRest();
    void aPushTowardsTheUserIsAPush_data();
    void aPushTowardsTheUserIsAPush();
    void commandsKeepTheDirectionOfTheForce();
    void commandsOfNoNumberAreZero();
    void aRulerFindsTheAngleAtTheIndexMarks();
    void aWeightFindsTheScaleOfTheCommands();
    void aCalibrationOfNoFalconIsRefused();
};

void TestFalconCalibration::uprightInFrontIsTheUsualFrame()
{
    const Placement placement;
    const glm::dvec3 grip(12.0, -7.0, 101.0);
    QCOMPARE(glm::distance(placement.toothFromGripMm(grip), toothFromDevice(grip)), 0.0);
}

void TestFalconCalibration::everyPlacementTurnsBackAndForth()
{
    using Stand = DeviceSetup::Stand;
    using Side = DeviceSetup::Side;
    core::Rng rng(1);
    for (const Stand stand : {Stand::Upright, Stand::OnItsBack})
        for (const Side side : {Side::Front, Side::Right, Side::Left})
            for (const double scale : {0.5, 1.0, 2.5}) {
                const Placement placement({stand, side, scale});
                const glm::dvec3 tooth(rng.uniform(-9.0, 9.0), rng.uniform(-9.0, 9.0), rng.uniform(-9.0, 9.0));
                const glm::dvec3 grip = placement.gripFromToothMm(tooth);
                QVERIFY(glm::distance(placement.toothFromGripMm(grip), tooth) < 1e-12);
                QVERIFY(std::abs(glm::distance(grip, kCentreMm) - scale * glm::length(tooth)) < 1e-12);
                // The force that moves the hand along a direction in the tooth frame has the same direction at the
                // device.
                const glm::dvec3 way = placement.gripFromToothMm(glm::dvec3(0.0)) - grip;
                QVERIFY(glm::distance(placement.deviceFromToothN(-tooth) * scale, way) < 1e-12);
            }
}

void TestFalconCalibration::theTopOfTheToothIsAtTheHeightOfTheRest()
{
    using Stand = DeviceSetup::Stand;
    using Side = DeviceSetup::Side;
    for (const Stand stand : {Stand::Upright, Stand::OnItsBack})
        for (const double scale : {0.5, 1.0, 2.0}) {
            const Placement middle({stand, Side::Right, scale});
            const Placement raised({stand, Side::Right, scale, 10.0});
            const glm::dvec3 tooth(1.0, -2.0, 3.0);
            const glm::dvec3 grip = raised.gripFromToothMm(tooth);
            QVERIFY(glm::distance(raised.toothFromGripMm(grip), tooth) < 1e-12);
            // The hand is higher by the same distance at every scale.
            const glm::dvec3 up = raised.gripFromToothMm(glm::dvec3(0.0)) - middle.gripFromToothMm(glm::dvec3(0.0));
            QVERIFY(glm::distance(up, middle.deviceFromToothN({0.0, 0.0, 10.0})) < 1e-12);
        }
    // The whole tooth can be reached with any stored settings.
    const Placement far({Stand::Upright, Side::Front, 2.5, 500.0});
    QVERIFY(glm::distance(far.gripFromToothMm({8.0, 0.0, 6.0}), kCentreMm) <= haptics::falcon::kReachMm + 1e-9);
}

void TestFalconCalibration::aPushTowardsTheUserIsAPush_data()
{
    QTest::addColumn<int>("stand");
    QTest::addColumn<int>("side");
    QTest::addColumn<glm::dvec3>("towardsUser");  // device frame
    QTest::addColumn<glm::dvec3>("up");
    const glm::dvec3 x(1.0, 0.0, 0.0);
    const glm::dvec3 y(0.0, 1.0, 0.0);
    const glm::dvec3 z(0.0, 0.0, 1.0);
    QTest::newRow("upright, in front") << 0 << 0 << z << y;
    QTest::newRow("upright, at the right, its front to the left") << 0 << 1 << x << y;
    QTest::newRow("upright, at the left, its front to the right") << 0 << 2 << -x << y;
    QTest::newRow("on its back, in front") << 1 << 0 << -y << z;
    QTest::newRow("on its back, at the right") << 1 << 1 << x << z;
}

void TestFalconCalibration::aPushTowardsTheUserIsAPush()
{
    QFETCH(int, stand);
    QFETCH(int, side);
    QFETCH(glm::dvec3, towardsUser);
    QFETCH(glm::dvec3, up);
    const Placement placement({static_cast<DeviceSetup::Stand>(stand), static_cast<DeviceSetup::Side>(side), 1.0});
    QVERIFY(glm::distance(placement.deviceFromToothN({0.0, -1.0, 0.0}), towardsUser) < 1e-12);
    QVERIFY(glm::distance(placement.deviceFromToothN({0.0, 0.0, 1.0}), up) < 1e-12);
}

void TestFalconCalibration::commandsKeepTheDirectionOfTheForce()
{
    const auto arms = armsAt({5.0, -10.0, 115.0});
    QVERIFY(arms);
    const glm::dvec3 weak(0.2, -0.3, 0.5);
    const glm::dvec3 torques = torquesNm(*arms, weak);
    const auto commands = motorCommands(*arms, weak, {});
    const auto most = motorCommands(*arms, weak * 1000.0, {});
    int largest = 0;
    for (int leg = 0; leg < 3; ++leg) {
        const auto n = static_cast<std::size_t>(leg);
        QVERIFY(std::abs(commands.at(n) + 10000.0 * torques[leg]) <= 1.0);
        largest = std::max(largest, std::abs(static_cast<int>(most.at(n))));
    }
    QCOMPARE(largest, 4095);
    for (std::size_t n = 0; n < 3; ++n)
        QVERIFY(std::abs(most.at(n) * torques[0] - most.at(0) * torques[static_cast<int>(n)]) <
                std::abs(torques[0]) * 2.0);
}

void TestFalconCalibration::commandsOfNoNumberAreZero()
{
    const auto arms = armsAt(kCentreMm);
    QVERIFY(arms);
    const std::array<std::int16_t, 3> none{};
    QCOMPARE(motorCommands(*arms, glm::dvec3(0.0, std::nan(""), 0.0), {}), none);
    QCOMPARE(motorCommands(*arms, glm::dvec3(0.0, INFINITY, 0.0), {}), none);
}

void TestFalconCalibration::aRulerFindsTheAngleAtTheIndexMarks()
{
    // On a device whose marks are at 40 degrees, the default calibration gives angles that are 5 degrees too small.
    constexpr double kDegree = std::numbers::pi / 180.0;
    const auto readAt = [&](const glm::dvec3& grip) {
        return gripAt(armsAt(grip)->angleRad - glm::dvec3(5.0 * kDegree), grip).value();
    };
    const glm::dvec3 inside(0.0, 0.0, 78.0);
    const glm::dvec3 outside(0.0, 0.0, 138.0);
    const auto found = withDistance({}, readAt(inside), readAt(outside), 60.0);
    QVERIFY(found);
    for (int leg = 0; leg < 3; ++leg)
        QVERIFY2(std::abs(found->homeRad[leg] / kDegree - 40.0) < 0.2,
                 qPrintable(QString::number(found->homeRad[leg])));
    QVERIFY(!withDistance({}, inside, outside, 30.0));
}

void TestFalconCalibration::aWeightFindsTheScaleOfTheCommands()
{
    // A device that needs 6,616 commands for 1 Nm is stronger than the default of 10,000 assumes: it holds 2 N with a
    // command for 1.32 N.
    const double share = 6616.0 / 10000.0;
    const auto found = withWeight({}, 0.6 * share, 2.6 * share, 2.0);
    QVERIFY(found);
    QVERIFY(std::abs(found->commandPerNm - 6616.0) < 1e-6);
    QVERIFY(std::abs(found->gripWeightN - 0.6) < 1e-9);
    QVERIFY(!withWeight({}, 1.0, 1.0, 2.0));
    QVERIFY(!withWeight({}, 1.0, 0.5, 2.0));
}

void TestFalconCalibration::aCalibrationOfNoFalconIsRefused()
{
    QVERIFY(check(Calibration{}));
    Calibration calibration;
    calibration.commandPerNm = 0.0;
    QVERIFY(!check(calibration));
    calibration = {};
    calibration.homeRad.y = std::nan("");
    QVERIFY(!check(calibration));
    calibration = {};
    calibration.geometry.b = 10.0;
    QVERIFY(!check(calibration));
}

CUSP_TEST(TestFalconCalibration)
#include "tst_falcon_calibration.moc"
