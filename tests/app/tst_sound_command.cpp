// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/Program.h"

using support::Ending;
using support::runCusp;

/// Runs `cusp sound` as a user does.
class TestSoundCommand : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        // The bur is in the air for a second, then cuts into a practice block for a second.
        write("path.csv", "t_s,x_mm,y_mm,z_mm,drill\n0,0,0,3,1\n0.5,0,0,1,1\n1.5,0,0,-0.5,1\n2,0,0,2,0\n");
    }

    void aWaveFileOfTheSimulationIsWritten()
    {
        const Ending ending = sound({"--json"});
        expectDone(ending);
        const QJsonObject figures = ending.json();
        // The path has 2,001 ticks, and the handpiece runs down for a second.
        QCOMPARE(figures["seconds"].toDouble(), 3.001);
        QCOMPARE(figures["rate_hz"].toInt(), 48'000);
        QVERIFY(figures["loudest"].toDouble() > 0.05 && figures["loudest"].toDouble() < 1.0);
        const QByteArray bytes = contentOf(at("out.wav"));
        QVERIFY(bytes.startsWith("RIFF"));
        QCOMPARE(bytes.size(), 44 + 2 * 3'001 * 48);
    }

    void aLowSpeedHandpieceSoundsOtherwise()
    {
        expectDone(sound({}));
        const QByteArray turbine = contentOf(at("out.wav"));
        expectDone(sound({}));
        QCOMPARE(contentOf(at("out.wav")), turbine);
        expectDone(sound({"--handpiece", "low-speed", "--bur", "2"}));
        QVERIFY(contentOf(at("out.wav")) != turbine);
    }

    void aSilentPathIsSaidToBeSilent()
    {
        write("path.csv", "t_s,x_mm,y_mm,z_mm,drill\n0,0,0,3,0\n0.5,0,0,1,0\n");
        const Ending ending = sound({});
        QCOMPARE(ending.exitCode, 0);
        QVERIFY(ending.error.contains("does not turn"));
    }

    void whatIsWrongIsSaidInASentence_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<int>("exitCode");
        QTest::addColumn<QString>("sentence");
        const QStringList all{"--render", "OUT", "--tooth", "block:line", "--path", "PATH"};
        QTest::newRow("no file") << QStringList{"--tooth", "36", "--path", "PATH"} << 2 << "--render is missing";
        QTest::newRow("no tooth") << QStringList{"--render", "OUT", "--path", "PATH"} << 2 << "--tooth is missing";
        QTest::newRow("no such bur") << all + QStringList{"--bur", "999"} << 2 << "999";
        QTest::newRow("no such handpiece") << all + QStringList{"--handpiece", "laser"} << 2 << "laser";
        QTest::newRow("surplus") << all + QStringList{"more"} << 2 << "belongs to no option";
        QTest::newRow("no path") << QStringList{"--render", "OUT", "--tooth", "36", "--path", "none.csv"} << 1
                                 << "none.csv";
        QTest::newRow("over the path") << QStringList{"--render", "PATH", "--tooth", "36", "--path", "PATH"} << 2
                                       << "would overwrite";
        QTest::newRow("no folder") << QStringList{"--render", "/no/such/folder/a.wav",
                                                  "--tooth",  "block:line",
                                                  "--path",   "PATH"}
                                   << 1 << "/no/such/folder";
    }
    void whatIsWrongIsSaidInASentence()
    {
        QFETCH(QStringList, options);
        QFETCH(const int, exitCode);
        QFETCH(const QString, sentence);
        options.replaceInStrings("OUT", at("out.wav"));
        options.replaceInStrings("PATH", at("path.csv"));
        const Ending ending = runCusp(QStringList{"sound"} + options);
        expectRefusal(ending, sentence.toUtf8(), exitCode);
        QVERIFY(!QFile::exists(at("out.wav")));
    }

private:
    static QByteArray contentOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    [[nodiscard]] QString at(const char* name) const { return m_folder->filePath(QString::fromLatin1(name)); }
    void write(const char* name, const QByteArray& bytes) const
    {
        QFile file(at(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }
    [[nodiscard]] Ending sound(const QStringList& options) const
    {
        return runCusp(
            QStringList{"sound", "--render", at("out.wav"), "--tooth", "block:line", "--path", at("path.csv")} +
            options);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(TestSoundCommand)
#include "tst_sound_command.moc"
