// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/Program.h"

using support::Ending;
using support::runCusp;

/// Runs `cusp render` as a user does: it makes a display of its own where there is none.
class TestRenderCommand : public QObject
{
    Q_OBJECT

private slots:
    void drawsATooth_data();
    void drawsATooth();
    void drawsWhatAnAttemptLeft();
    void drawsTheMouthWithATooth();
    void whatStandsBesideAScanNobodyKnows();
    void wrongUsage_data();
    void wrongUsage();
    void aPictureThatCannotBeWrittenLeavesTheOlderOne();

private:
    QTemporaryDir m_folder;
};

void TestRenderCommand::drawsATooth_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QSize>("size");
    QTest::newRow("start") << QStringList{} << QSize(1280, 800);
    QTest::newRow("from above") << QStringList{"--view", "occlusal", "--size", "400x300"} << QSize(400, 300);
    QTest::newRow("a direction of the mouth")
        << QStringList{"--view", "buccal", "--size", "300X300"} << QSize(300, 300);
    QTest::newRow("a section") << QStringList{"--section", "90", "--size", "400x300"} << QSize(400, 300);
    QTest::newRow("an X-ray picture") << QStringList{"--xray", "--size", "400x300"} << QSize(400, 300);
    QTest::newRow("a bitewing") << QStringList{"--bitewing", "--size", "400x300"} << QSize(400, 300);
    QTest::newRow("a bitewing on a high picture") << QStringList{"--bitewing", "--size", "200x300"} << QSize(200, 300);
    QTest::newRow("the whole mouth") << QStringList{"--arch", "--size", "400x300"} << QSize(400, 300);
    QTest::newRow("the teeth beside it") << QStringList{"--show", "neighbours", "--size", "400x300"} << QSize(400, 300);
    QTest::newRow("for two eyes") << QStringList{"--stereo", "grey", "--size", "400x300"} << QSize(400, 300);
    QTest::newRow("turned over, with a mirror")
        << QStringList{"--flip", "both", "--show", "mirror,wet,light,depth", "--size", "400x300"} << QSize(400, 300);
    QTest::newRow("by angles") << QStringList{"--view", "-30,20,40", "--size", "64x64"} << QSize(64, 64);
}

void TestRenderCommand::drawsATooth()
{
    QFETCH(QStringList, options);
    QFETCH(QSize, size);
    const QString file = m_folder.filePath("tooth.png");
    const Ending ending = runCusp(QStringList{"render", "--tooth", "36", "--out", file} + options);
    QVERIFY2(ending.exitCode == 0, ending.error);
    const QImage picture(file);
    QCOMPARE(picture.size(), size);
    // The room is dark, the tooth in its middle is not.
    const int room = qGray(picture.pixel(2, 2));
    QVERIFY(room < 80);
    int brightest = 0;
    for (int x = 0; x < size.width(); ++x)
        brightest = std::max(brightest, qGray(picture.pixel(x, size.height() / 2)));
    QVERIFY(brightest > room + 30);
}

void TestRenderCommand::drawsWhatAnAttemptLeft()
{
    QFile path(m_folder.filePath("p.csv"));
    QVERIFY(path.open(QIODevice::WriteOnly));
    path.write("t_s,x_mm,y_mm,z_mm,drill\n0,0,0,3,1\n0.5,0,0,-4,1\n2,0.5,0,-4,1\n2.2,0.5,0,5,1\n");
    path.close();
    const QString recording = m_folder.filePath("a.cusprec");
    QCOMPARE(runCusp({"simulate", "--tooth", "36", "--path", path.fileName(), "--out", m_folder.filePath("t.csv"),
                      "--record", recording})
                 .exitCode,
             0);
    const QStringList common{"--view", "occlusal", "--size", "400x300", "--out"};
    const QString cut = m_folder.filePath("cut.png");
    const QString whole = m_folder.filePath("whole.png");
    const Ending ending =
        runCusp(QStringList{"render", "--tooth", "36", "--recording", recording} + common + QStringList{cut});
    QVERIFY2(ending.exitCode == 0, ending.error);
    const Ending other = runCusp(QStringList{"render", "--tooth", "37", "--recording", recording} + common +
                                 QStringList{m_folder.filePath("other.png")});
    QCOMPARE(other.exitCode, 1);
    QVERIFY2(other.isOneSentence() && other.error.contains("'36'"), other.error);
    // Two films beside each other: the left one is whole, the right one is not.
    const auto films = [&](const QStringList& more) {
        const QString file = m_folder.filePath("films.png");
        return runCusp(QStringList{"render", "--recording", recording, "--xray", "--size", "812x400", "--out", file} +
                       more)
                           .exitCode == 0
                   ? QImage(file)
                   : QImage();
    };
    const QImage both = films({"--show", "before"});
    QCOMPARE(both.size(), QSize(812, 400));
    int darker = 0;
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 400; ++x)
            darker += qGray(both.pixel(x, y)) > qGray(both.pixel(x + 412, y)) + 10 ? 1 : 0;
    QVERIFY2(darker > 100, qPrintable(QString::number(darker)));
    const auto mean = [](const QImage& film) {
        double sum = 0.0;
        for (int y = 0; y < film.height(); ++y)
            for (int x = 0; x < film.width(); ++x)
                sum += qGray(film.pixel(x, y));
        return sum / film.width() / film.height();
    };
    QVERIFY(mean(films({"--exposure", "2"})) < mean(films({})) - 5.0);
    QVERIFY(films({"--angle", "40"}) != films({}));
    QCOMPARE(runCusp(QStringList{"render", "--tooth", "36"} + common + QStringList{whole}).exitCode, 0);
    const QImage a(cut);
    const QImage b(whole);
    int different = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            different += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 20 ? 1 : 0;
    QVERIFY2(different > 500, qPrintable(QString::number(different)));
}

void TestRenderCommand::drawsTheMouthWithATooth()
{
    const auto mouth = [&](const char* name, const QStringList& options) {
        const QString file = m_folder.filePath(name);
        const Ending ending = runCusp(QStringList{"render", "--arch", "--size", "400x300", "--out", file} + options);
        return ending.exitCode == 0 ? QImage(file) : QImage();
    };
    const QImage nobody = mouth("nobody.png", {});
    const QImage one = mouth("one.png", {"--tooth", "36"});
    QVERIFY(!nobody.isNull() && !one.isNull());
    // The marked tooth alone: some of the picture, on its right half, where the patient's left is.
    QRect changed;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x)
            if (one.pixel(x, y) != nobody.pixel(x, y))
                changed |= QRect(x, y, 1, 1);
    QVERIFY(changed.left() > 200);
    QVERIFY(changed.width() > 10 && changed.width() < 60);
    QVERIFY(changed.height() > 10 && changed.height() < 60);
}

void TestRenderCommand::whatStandsBesideAScanNobodyKnows()
{
    const QString recording = QStringLiteral(CUSP_SOURCE_DIR "/tests/golden/attempt.cusprec");
    const QStringList scan{"render", "--recording", recording, "--out", m_folder.filePath("scan.png")};
    for (const QStringList& what : {QStringList{"--show", "neighbours"}, QStringList{"--bitewing"}}) {
        const Ending ending = runCusp(scan + what);
        QCOMPARE(ending.exitCode, 1);
        QVERIFY2(ending.isOneSentence() && ending.error.contains("'synthetic'"), ending.error);
    }
}

void TestRenderCommand::wrongUsage_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("nothing to draw") << QStringList{"--out", "a.png"};
    QTest::newRow("a beam without a film") << QStringList{"--tooth", "36", "--out", "a.png", "--angle", "10"};
    QTest::newRow("a beam from behind") << QStringList{"--tooth", "36", "--out", "a.png", "--xray", "--angle", "100"};
    QTest::newRow("no exposure") << QStringList{"--tooth", "36", "--out", "a.png", "--xray", "--exposure", "0"};
    QTest::newRow("before in space") << QStringList{"--tooth", "36", "--out", "a.png", "--show", "before"};
    QTest::newRow("no picture") << QStringList{"--tooth", "36"};
    QTest::newRow("another format") << QStringList{"--tooth", "36", "--out", "a.bmp"};
    QTest::newRow("no size") << QStringList{"--tooth", "36", "--out", "a.png", "--size", "big"};
    QTest::newRow("huge") << QStringList{"--tooth", "36", "--out", "a.png", "--size", "100000x100000"};
    QTest::newRow("nowhere") << QStringList{"--tooth", "36", "--out", "a.png", "--view", "heaven"};
    QTest::newRow("half a place") << QStringList{"--tooth", "36", "--out", "a.png", "--view", "1,2"};
    QTest::newRow("no angle") << QStringList{"--tooth", "36", "--out", "a.png", "--section", "east"};
    QTest::newRow("two pictures") << QStringList{"--tooth", "36", "--out", "a.png", "--section", "0", "--xray"};
    QTest::newRow("two films") << QStringList{"--tooth", "36", "--out", "a.png", "--bitewing", "--xray"};
    QTest::newRow("mouth and film") << QStringList{"--tooth", "36", "--out", "a.png", "--bitewing", "--arch"};
    QTest::newRow("the mouth of an attempt") << QStringList{"--recording", "a.cusprec", "--out", "a.png", "--arch"};
    QTest::newRow("the mouth of a scan") << QStringList{"--tooth", "a.stl", "--out", "a.png", "--arch"};
    QTest::newRow("a mouth from above") << QStringList{"--out", "a.png", "--arch", "--view", "occlusal"};
    QTest::newRow("a film for two eyes") << QStringList{"--tooth", "36",       "--out", "a.png",
                                                        "--xray",  "--stereo", "grey"};
    QTest::newRow("a section turned over")
        << QStringList{"--tooth", "36", "--out", "a.png", "--section", "0", "--flip", "both"};
    QTest::newRow("a wet section") << QStringList{"--tooth", "36", "--out", "a.png", "--section", "0", "--show", "wet"};
    QTest::newRow("a bitewing with neighbours")
        << QStringList{"--tooth", "36", "--out", "a.png", "--bitewing", "--show", "neighbours"};
    QTest::newRow("no such glasses") << QStringList{"--tooth", "36", "--out", "a.png", "--stereo", "blue"};
    QTest::newRow("no such flip") << QStringList{"--tooth", "36", "--out", "a.png", "--flip", "over"};
    QTest::newRow("nothing of that name") << QStringList{"--tooth", "36", "--out", "a.png", "--show", "halo"};
    QTest::newRow("a word too many") << QStringList{"36", "--tooth", "36", "--out", "a.png"};
}

void TestRenderCommand::wrongUsage()
{
    QFETCH(QStringList, arguments);
    const Ending ending = runCusp(QStringList{"render"} + arguments);
    QCOMPARE(ending.exitCode, 2);
    QVERIFY2(ending.error.startsWith("cusp: ") && ending.error.count('\n') == 1, ending.error);
}

void TestRenderCommand::aPictureThatCannotBeWrittenLeavesTheOlderOne()
{
    const QString folder = m_folder.filePath("there.png");
    QVERIFY(QDir().mkpath(folder));
    const Ending ending = runCusp({"render", "--tooth", "36", "--size", "64x64", "--out", folder});
    QVERIFY2(ending.exitCode == 1 && ending.isOneSentence(), ending.error);
    QVERIFY(QFileInfo(folder).isDir());
}

QTEST_GUILESS_MAIN(TestRenderCommand)
#include "tst_render_command.moc"
