// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <QTest>

#include "core/settings/PenSettings.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"

using core::settings::PenSettings;

class TestPenSettings : public QObject
{
    Q_OBJECT
private slots:
    void pressureBecomesForce_data()
    {
        constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
        constexpr double kInfinite = std::numeric_limits<double>::infinity();
        QTest::addColumn<double>("curve");
        QTest::addColumn<double>("pressure");
        QTest::addColumn<double>("share");
        QTest::newRow("light") << 1.0 << 0.01 << PenSettings::kLeastShare;
        QTest::newRow("a third") << 1.0 << 0.3 << 0.3;
        QTest::newRow("full") << 1.0 << 1.0 << 1.0;
        QTest::newRow("soft, half") << 2.0 << 0.5 << 0.25;
        QTest::newRow("soft, full") << 2.0 << 1.0 << 1.0;
        QTest::newRow("hard, a quarter") << 0.5 << 0.25 << 0.5;
        QTest::newRow("below the range") << 1.0 << -3.0 << PenSettings::kLeastShare;
        QTest::newRow("beyond the range") << 1.0 << 7.0 << 1.0;
        QTest::newRow("infinite") << 1.0 << kInfinite << 1.0;
        QTest::newRow("not a number") << 1.0 << kNan << PenSettings::kLeastShare;
        QTest::newRow("a curve beyond its range") << 99.0 << 0.5 << 0.125;
        QTest::newRow("a curve that is not a number") << kNan << 0.5 << PenSettings::kLeastShare;
    }
    void pressureBecomesForce()
    {
        QFETCH(const double, curve);
        QFETCH(const double, pressure);
        QFETCH(const double, share);
        QVERIFY(support::near(PenSettings{curve}.shareAt(pressure), share));
    }

    /// The default curve changes no pressure.
    void aStraightLineIsExact()
    {
        for (int k = 50; k <= 1000; ++k)
            QCOMPARE(PenSettings{}.shareAt(k / 1000.0), k / 1000.0);
    }
};

CUSP_TEST(TestPenSettings)
#include "tst_pen_settings.moc"
