// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <QTest>

#include "core/session/RestHeight.h"
#include "core/session/StillnessCheck.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"

using core::session::reachableRestMm;
using core::session::StillnessCheck;
using support::near;

namespace {

constexpr double kHz = 30.0;

/// Runs a check of a hand for its whole duration.
/// @param placeAt  returns the position of the hand at a time
template <class PlaceAt>
StillnessCheck held(const PlaceAt& placeAt, double hz = kHz)
{
    StillnessCheck check;
    for (int k = 0; !check.isOver(); ++k)
        check.add(k / hz, placeAt(k / hz));
    return check;
}

}  // namespace

class TestStillness : public QObject
{
    Q_OBJECT
private slots:
    void aHandAtRestIsStill()
    {
        const auto result = held([](double) { return glm::dvec3(3.0, -4.0, 5.0); }).result();
        QVERIFY(result.has_value());
        QVERIFY(near(result->driftMm, 0.0) && near(result->tremorMm, 0.0, 1e-6));
    }

    /// The drift is measured over the time between the middles of the first and the last second.
    void aSlowWayIsDrift()
    {
        const auto result = held([](double t) { return glm::dvec3(0.3 * t, 0.0, 0.4 * t); }).result();
        QVERIFY(result.has_value());
        QVERIFY(near(result->driftMm, 0.5 * (StillnessCheck::kDurationS - StillnessCheck::kEdgeS), 0.02));
        QVERIFY(result->tremorMm < 0.02);  // at both ends the window has only one side
    }

    /// A hand trembles at about 10 Hz. The root mean square of a sine is its amplitude / sqrt(2).
    void aFastWayIsTremor_data()
    {
        QTest::addColumn<double>("hz");
        QTest::newRow("as the page of devices asks") << kHz;
        QTest::newRow("as the servo asks") << 1000.0;
    }
    void aFastWayIsTremor()
    {
        QFETCH(const double, hz);
        const auto result =
            held([](double t) { return glm::dvec3(0.0, 0.2 * std::sin(2.0 * support::kPi * 9.3 * t), 0.0); }, hz)
                .result();
        QVERIFY(result.has_value());
        QVERIFY(near(result->tremorMm, 0.2 / std::sqrt(2.0), 0.015));  // within a tenth
        QVERIFY(result->driftMm < 0.02);
    }

    void badPlacesAreLeftOut()
    {
        constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
        StillnessCheck check;
        for (int k = 0; !check.isOver(); ++k) {
            check.add(k / kHz, glm::dvec3(1.0));
            check.add(k / kHz, glm::dvec3(99.0));        // at the same time as the one before
            check.add(k / kHz - 1.0, glm::dvec3(99.0));  // earlier than the one before
            check.add(k / kHz, glm::dvec3(kNan));
            check.add(kNan, glm::dvec3(99.0));
        }
        QVERIFY(check.result().has_value());
        QVERIFY(near(check.result()->tremorMm, 0.0, 1e-6));
    }

    void tooFewPlacesGiveNoResult()
    {
        QVERIFY(!StillnessCheck().result().has_value());
        StillnessCheck check;
        for (int k = 0; k < 100; ++k)
            check.add(k / kHz, glm::dvec3(0.0));
        QVERIFY(!check.isOver());
        QVERIFY(near(check.progress(), 3.3 / StillnessCheck::kDurationS, 1e-6));
        QVERIFY(!check.result().has_value());
        check.add(StillnessCheck::kDurationS, glm::dvec3(0.0));  // no readings in between
        QVERIFY(check.isOver());
        QVERIFY(!check.result().has_value());
        QVERIFY(!held([](double) { return glm::dvec3(0.0); }, 4.0).result().has_value());
    }

    void theToothStaysReachable()
    {
        constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(reachableRestMm(12.0, 1.0), 12.0);
        QCOMPARE(reachableRestMm(kNan, 1.0), 0.0);
        QCOMPARE(reachableRestMm(5.0, kNan), 0.0);
        for (const double scale : {0.5, 1.0, 1.7, 2.5})
            for (const double wanted : {-500.0, -20.0, 0.0, 20.0, 500.0}) {
                const double rest = reachableRestMm(wanted, scale);
                QVERIFY(std::abs(rest) <= std::abs(wanted));
                // The hand has to reach the bottom of a deep cavity and a bur lifted above the edge of the tooth.
                QVERIFY(std::hypot(8.0 * scale, rest - 9.0 * scale) <= core::session::kHandReachMm + 1e-9);
                QVERIFY(std::hypot(8.0 * scale, rest + 6.0 * scale) <= core::session::kHandReachMm + 1e-9);
            }
        QVERIFY(reachableRestMm(500.0, 1.0) > 30.0);
        QVERIFY(reachableRestMm(500.0, 2.5) < 30.0);
    }
};

CUSP_TEST(TestStillness)
#include "tst_stillness.moc"
