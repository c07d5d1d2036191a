// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonObject>
#include <QTest>

#include "tests/support/Program.h"

/// Runs `cusp frames` as a user does. The reported times depend on this computer; what the program sends to the driver
/// does not.
class TestFramesCommand : public QObject
{
    Q_OBJECT

private slots:
    void wrongUsageIsExplained_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("no size") << QStringList{"--size", "large"};
        QTest::newRow("too small") << QStringList{"--size", "2x2"};
        QTest::newRow("a stray word") << QStringList{"now"};
    }

    void wrongUsageIsExplained()
    {
        QFETCH(QStringList, arguments);
        const support::Ending ending = support::runCusp(QStringList{"frames"} + arguments);
        expectRefusal(ending, {}, 2);
    }

    void cuttingUploadsLittleMoreThanItChanges()
    {
        const support::Ending ending = support::runCusp({"frames", "--size", "320x200", "--json"});
        expectDone(ending);
        const QJsonObject figures = ending.json();
        QVERIFY(figures["upload_ratio"].toDouble() > 1.0);
        QVERIFY(figures["upload_ratio"].toDouble() <= 2.0);
        QCOMPARE(figures["upload_wholes"].toInt(-1), 0);
        QVERIFY(figures["latency_frames"].toInt() > 0);
        for (const char* scene : {"plain", "drilling", "turning", "effects", "effects_drilling", "stereo"})
            QVERIFY(figures[QLatin1String(scene) + QLatin1String("_ratio")].toDouble() > 0.0);
        QVERIFY(!figures["driver"].toString().isEmpty());
    }
};

QTEST_APPLESS_MAIN(TestFramesCommand)
#include "tst_frames_command.moc"
