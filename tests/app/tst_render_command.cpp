// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/Program.h"

using support::Ending;
using support::runCusp;

/// Runs `cusp render` as a user does. The command starts a display if there is none.
class TestRenderCommand : public QObject
{
    Q_OBJECT

private slots:
    void drawsATooth_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QSize>("size");
        QTest::newRow("start") << QStringList{} << QSize(1280, 800);
        QTest::newRow("a direction of the mouth")
            << QStringList{"--view", "buccal", "--size", "300X300"} << QSize(300, 300);
        QTest::newRow("a bitewing on a high picture")
            << QStringList{"--bitewing", "--size", "200x300"} << QSize(200, 300);
        QTest::newRow("turned over, with a mirror")
            << QStringList{"--flip", "both", "--show", "mirror,wet,light,depth", "--size", "400x300"}
            << QSize(400, 300);
        QTest::newRow("by angles") << QStringList{"--view", "-30,20,40", "--size", "64x64"} << QSize(64, 64);
    }

    /// Checks that a picture is drawn. tst_pictures compares what each option shows.
    void drawsATooth()
    {
        QFETCH(QStringList, options);
        QFETCH(QSize, size);
        const QString file = m_folder.filePath("tooth.png");
        expectDone(runCusp(QStringList{"render", "--tooth", "36", "--out", file} + options));
        const QImage picture(file);
        QCOMPARE(picture.size(), size);
        // The background is dark, and the tooth in the middle is not.
        const int room = qGray(picture.pixel(2, 2));
        QVERIFY(room < 80);
        int brightest = 0;
        for (int x = 0; x < size.width(); ++x)
            brightest = std::max(brightest, qGray(picture.pixel(x, size.height() / 2)));
        QVERIFY(brightest > room + 30);
    }

    void whatAnAttemptDoesNotShowIsRefused_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("what stands beside a scan") << QStringList{"--show", "neighbours"};
        QTest::newRow("a film of a scan and its neighbours") << QStringList{"--bitewing"};
        QTest::newRow("another tooth") << QStringList{"--tooth", "37"};
    }

    void whatAnAttemptDoesNotShowIsRefused()
    {
        QFETCH(QStringList, options);
        const QString recording = QStringLiteral(CUSP_SOURCE_DIR "/tests/golden/attempt.cusprec");
        expectRefusal(
            runCusp(QStringList{"render", "--recording", recording, "--out", m_folder.filePath("scan.png")} + options),
            "'synthetic'");
    }

    void wrongUsage_data()
    {
        QTest::addColumn<QString>("arguments");
        const auto row = [](const char* name, const QString& arguments) { QTest::newRow(name) << arguments; };
        row("nothing to draw", "--out a.png");
        row("no picture", "--tooth 36");
        row("another format", "--tooth 36 --out a.bmp");
        row("the mouth of an attempt", "--recording a.cusprec --out a.png --arch");
        row("the mouth of a scan", "--tooth a.stl --out a.png --arch");
        row("a mouth from above", "--out a.png --arch --view occlusal");
        row("a word too many", "36 --tooth 36 --out a.png");
        const auto of36 = [&](const char* name, const char* more) {
            row(name, QStringLiteral("--tooth 36 --out a.png ") + more);
        };
        of36("a beam without a film", "--angle 10");
        of36("a beam from behind", "--xray --angle 100");
        of36("no exposure", "--xray --exposure 0");
        of36("before in space", "--show before");
        of36("no size", "--size big");
        of36("huge", "--size 100000x100000");
        of36("nowhere", "--view heaven");
        of36("half a place", "--view 1,2");
        of36("no angle", "--section east");
        of36("two pictures", "--section 0 --xray");
        of36("two films", "--bitewing --xray");
        of36("mouth and film", "--bitewing --arch");
        of36("a film for two eyes", "--xray --stereo grey");
        of36("a section turned over", "--section 0 --flip both");
        of36("a wet section", "--section 0 --show wet");
        of36("a bitewing with neighbours", "--bitewing --show neighbours");
        of36("no such glasses", "--stereo blue");
        of36("no such flip", "--flip over");
        of36("nothing of that name", "--show halo");
    }

    void wrongUsage()
    {
        QFETCH(QString, arguments);
        const Ending ending = runCusp(QStringList{"render"} + arguments.split(u' '));
        QCOMPARE(ending.exitCode, 2);
        QVERIFY2(ending.error.startsWith("cusp: ") && ending.error.count('\n') == 1, ending.error);
    }

    void aPictureThatCannotBeWrittenLeavesTheOlderOne()
    {
        const QString folder = m_folder.filePath("there.png");
        QVERIFY(QDir().mkpath(folder));
        expectRefusal(runCusp({"render", "--tooth", "36", "--size", "64x64", "--out", folder}));
        QVERIFY(QFileInfo(folder).isDir());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestRenderCommand)
#include "tst_render_command.moc"
