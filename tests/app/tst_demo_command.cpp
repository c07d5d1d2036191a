// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/Program.h"

using support::Ending;
using support::runCusp;

/// Runs `cusp demo` without a display, or with one that it starts itself.
class TestDemoCommand : public QObject
{
    Q_OBJECT

private slots:
    /// Makes the one attempt that all tests inspect. QT_QPA_PLATFORM=offscreen, which scripts often set, must not stop
    /// the command from drawing.
    void initTestCase()
    {
        const Ending ending =
            runCusp({"demo", "--out", m_folder.path()}, {"QT_QPA_PLATFORM=offscreen", "XDG_RUNTIME_DIR="});
        expectDone(ending);
        QCOMPARE(ending.error, QByteArray());
    }

    void drawsOnADisplayOfItsOwn()
    {
        for (const char* name : {"attempt.cusprec", "score.txt", "score.json"})
            QVERIFY2(QFile::exists(m_folder.filePath(name)), name);
        QVERIFY(!QImage(m_folder.filePath("picture.png")).isNull());
    }

    void withoutAPictureAllElseIsThere()
    {
        const QTemporaryDir folder;
        const Ending ending = runCusp({"demo", "--out", folder.path()}, {"PATH=/nowhere"});  // no xvfb-run is found
        QCOMPARE(ending.exitCode, 1);
        QVERIFY2(ending.error.startsWith("cusp: The picture could not be drawn") && ending.error.count('\n') == 1,
                 ending.error);
        for (const char* name : {"attempt.cusprec", "score.txt", "score.json"})
            QVERIFY2(QFile::exists(folder.filePath(name)), name);
    }

    void picturesWithoutOpenGlAreRefused()
    {
        const Ending ending =
            runCusp({"--recording", m_folder.filePath("attempt.cusprec"), "--picture", m_folder.filePath("none.png")},
                    {"QT_QPA_PLATFORM=offscreen"});
        QCOMPARE(ending.exitCode, 1);
        QVERIFY2(ending.error.contains("cusp: the picture could not be drawn"), ending.error);
        QVERIFY(!QFile::exists(m_folder.filePath("none.png")));
    }

    void theSimulatedFalconTakesTheDecayOutToo()
    {
        const QTemporaryDir folder;
        const Ending ending =
            runCusp({"demo", "--device", "simulated", "--out", folder.path()}, {"PATH=/nowhere"});  // no picture
        QVERIFY2(ending.out.contains("passed"), ending.out);
        QCOMPARE(runCusp({"demo", "--device", "robot", "--out", folder.path()}).exitCode, 2);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestDemoCommand)
#include "tst_demo_command.moc"
