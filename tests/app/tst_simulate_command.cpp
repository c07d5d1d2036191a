// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <thread>

#include <sys/stat.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "core/bur/Bur.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/FullDisk.h"
#include "tests/support/Program.h"
#include "tests/support/Solids.h"
#include "tests/support/Tables.h"

using support::Ending;
using support::runCusp;

/// Runs `cusp simulate` and `cusp replay` as a user does.
class TestSimulateCommand : public QObject
{
    Q_OBJECT
private slots:
    void traceHasARowATick()
    {
        const Ending ending = simulate({"--json"});
        expectDone(ending);
        const QJsonObject figures = ending.json();
        for (const char* key : {"ticks", "tick_us", "removed_mm3", "broken_mm3", "state_hash"})
            QVERIFY2(figures.contains(key), key);
        for (const char* key : {"p50", "p99", "p999", "max"})
            QVERIFY2(figures["tick_us"].toObject().contains(key), key);
        for (const char* key : {"caries", "enamel", "dentin", "pulp"})
            QVERIFY2(figures["removed_mm3"].toObject().contains(key), key);
        QCOMPARE(figures["ticks"].toInt(), 1201);
        const QList<QByteArray> lines = contentOf(m_trace).trimmed().split('\n');
        QCOMPARE(lines.size(), 1202);
        QVERIFY(lines[0].startsWith("t_s,x_mm,y_mm,z_mm,ax_mm,ay_mm,az_mm,fx_n,fy_n,fz_n,contact,"));
        for (const QByteArray& line : lines)
            QCOMPARE(line.count(','), lines[0].count(','));
    }

    /// The replay gives the same state hash, also with another handpiece and with thin fins that break off.
    void replayComesToTheSameHash()
    {
        const auto enamelOf = [&](const QStringList& options) {
            const QString recording = at("attempt.cusprec");
            const Ending made = simulate(QStringList{"--record", recording, "--json"} + options);
            const QJsonObject figures = runCusp({"replay", recording, "--json"}).json();
            [&] {
                expectDone(made);
                QCOMPARE(figures["state_hash"].toString(), made.json()["state_hash"].toString());
                QVERIFY(figures["verified"].toBool());
                QVERIFY(figures.contains("score") && figures.contains("measures") && figures.contains("removed_mm3"));
                QCOMPARE(figures["ticks"].toInt(), 1201);
            }();
            return made.json()["removed_mm3"].toObject()["enamel"].toDouble();
        };
        const double turbine = enamelOf({});
        const double slow = enamelOf({"--handpiece", "low-speed", "--break-off"});
        QVERIFY2(turbine > 0.0 && slow >= 0.0 && slow < 0.5 * turbine,
                 qPrintable(QString("%1, %2").arg(turbine).arg(slow)));
    }

    void helpNamesEveryBur_data() { support::rows<QString>("command", {"simulate", "sound"}); }

    void helpNamesEveryBur()
    {
        QFETCH(QString, command);
        const QString help = QString::fromUtf8(runCusp({command, "--help"}).out).simplified();
        QVERIFY2(help.contains("default 330"), qPrintable(help));
        QVERIFY2(help.contains("one of " + QString::fromStdString(core::bur::burIds())), qPrintable(help));
    }

    void replayComesToTheSameHashWithAnyBur_data()
    {
        support::rows<QString>("bur", {"1/4", "33-1/2", "171", "856", "860"});
    }

    void replayComesToTheSameHashWithAnyBur()
    {
        QFETCH(QString, bur);
        const QString recording = at("bur.cusprec");
        const Ending made = simulate({"--bur", bur, "--record", recording, "--json"});
        expectDone(made);
        const QJsonObject figures = runCusp({"replay", recording, "--json"}).json();
        QVERIFY(figures["verified"].toBool());
        QCOMPARE(figures["state_hash"].toString(), made.json()["state_hash"].toString());
        QVERIFY(made.json()["removed_mm3"].toObject()["enamel"].toDouble() > 0.0);
    }

    /// A bur from a user's file cuts like the built-in bur of the same profile, but cannot be used for a recording.
    void takesABurOfTheUser()
    {
        const QByteArray same = "bur mine\nshape straight\nmaterial carbide\nneck 0.4\nflat 0.4\narc 0.5 0.1 0.1\n"
                                "line 0.5 3.8\nend\n";
        const QString file = written("mine.txt", same.toStdString());
        const auto removedWith = [&](const QString& bur) {
            return simulate({"--bur", bur, "--json"}).json()["removed_mm3"].toObject()["enamel"].toDouble();
        };
        QVERIFY(removedWith("57") > 0.0);
        QCOMPARE(removedWith(file), removedWith("57"));
        const Ending kept = simulate({"--bur", file, "--record", at("own.cusprec")});
        QVERIFY(kept.exitCode != 0 && kept.error.contains("goes into no recording"));
        QVERIFY(!QFile::exists(at("own.cusprec")));
        const QString crossed = written(
            "crossed.txt",
            QByteArray(same).replace("line 0.5 3.8\n", "line 0.5 3.8\nline 0.35 0.02\nline 0.55 0.4\n").toStdString());
        const Ending refused = simulate({"--bur", crossed});
        QVERIFY(refused.exitCode != 0);
        QVERIFY2(refused.error.contains("Line 9 of the bur file: the profile crosses itself"),
                 refused.error.constData());
        QVERIFY(simulate({"--bur", at("missing.txt")}).error.contains("There is no bur"));
    }

    void otherRatesAndGrids_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<int>("ticks");
        QTest::newRow("250 Hz") << QStringList{"--rate", "250"} << 301;
        QTest::newRow("4 kHz") << QStringList{"--rate", "4000"} << 4801;
        QTest::newRow("grid 64") << QStringList{"--grid", "64"} << 1201;
        QTest::newRow("grid 1024") << QStringList{"--grid", "1024", "--rate", "250"} << 301;
        QTest::newRow("lattice") << QStringList{"--method", "lattice", "--bur", "57", "--drill"} << 1201;
    }

    void otherRatesAndGrids()
    {
        QFETCH(QStringList, options);
        const Ending ending = simulate(options + QStringList{"--json"});
        expectDone(ending);
        QTEST(ending.json()["ticks"].toInt(), "ticks");
    }

    void frameOfTheFileIsKept()
    {
        // The top of the block is at z = 9 in the coordinates of the file. The path moves down onto its middle, in the
        // same coordinates.
        const QString block =
            written("block.obj", support::asObj(support::moved(support::box(8.0F, 9.0F, 7.0F), {30.0F, -4.0F, 2.0F})));
        const QString path = written("down.csv", kHead + "0,34,0.5,12,0\n1,34,0.5,8.5,0\n");
        const auto lastRow = [&](const QStringList& options) {
            const Ending ending =
                runCusp(QStringList{"simulate", "--tooth", block, "--path", path, "--out", m_trace} + options);
            return ending.exitCode == 0 ? contentOf(m_trace).trimmed().split('\n').back().split(',')
                                        : QList<QByteArray>{};
        };
        const QList<QByteArray> kept = lastRow({"--frame", "file"});
        QCOMPARE(kept.size(), 15);
        QCOMPARE(kept[1].toDouble(), 34.0);  // the device
        QCOMPARE(kept[3].toDouble(), 8.5);
        QVERIFY(support::near(kept[4].toDouble(), 34.0, 0.01));  // the anchor rests on the block
        QVERIFY(support::near(kept[6].toDouble(), 9.0, 0.01));
        QVERIFY(kept[9].toDouble() > 0.1);
        QCOMPARE(kept[10], QByteArray("1"));
        // In the tooth's frame the same path misses the block.
        const QList<QByteArray> moved = lastRow({"--up", "+z"});
        QCOMPARE(moved.size(), 15);
        QCOMPARE(moved[10], QByteArray("0"));
    }

    void warningsOfTheScanAreShown()
    {
        // A scan one millimetre wide cannot be in millimetres: the importer guesses a unit and reports that.
        const QString scan = written("cap.stl", support::asBinaryStl(support::sphereCap(0.5F, 0.5F, 40, 10)));
        const QStringList arguments{"simulate", "--tooth", scan, "--path", m_path, "--out", m_trace};
        const Ending text = runCusp(arguments);
        expectDone(text);
        const QJsonArray listed = runCusp(arguments + QStringList{"--json"}).json()["warnings"].toArray();
        QVERIFY(!listed.isEmpty());
        QCOMPARE(text.error.count('\n'), static_cast<int>(listed.size()));
        for (const QJsonValue& warning : listed)
            QVERIFY2(text.error.contains("cusp: warning: " + warning.toString().toLocal8Bit()), text.error);
        QCOMPARE(runCusp({"tooth", scan, "--json"}).json()["warnings"].toArray(), listed);
    }

    void strangePathsAreWarnedAbout_data()
    {
        QTest::addColumn<std::string>("lines");
        QTest::addColumn<QString>("says");
        QTest::newRow("begins too deep") << std::string("0,0,0,-12.5,0\n0.1,0,0,3,0\n") << "begins at z -12.50 mm";
        QTest::newRow("begins deep enough") << std::string("0,5.2,5.2,-7.9,0\n0.1,5.2,5.2,3,0\n") << "";
        QTest::newRow("begins inside") << std::string("0,0,0,-3.5,1\n0.1,0,0,-4,1\n") << "begins inside the tooth";
        QTest::newRow("begins just below the surface")
            << std::string("0,0,0,-2.5,1\n0.1,0,0,-4,1\n") << "begins inside the tooth";
        QTest::newRow("begins with its side in the tooth")
            << std::string("0,5.5,0,-5,1\n0.1,5.5,0,-5.1,1\n") << "begins inside the tooth";
        QTest::newRow("begins on the surface and leaves it") << std::string("0,0,0,3,1\n0.1,0,0,-2.5,1\n") << "";
        QTest::newRow("30 mm within one tick, and back")
            << std::string("0,0,0,3,0\n0.1,0,0,3,0\n0.101,30,0,3,0\n0.105,30,0,3,0\n0.106,0,0,3,0\n0.2,0,0,3,0\n")
            << "The path leaps: 5 ticks of it";
    }

    void strangePathsAreWarnedAbout()
    {
        QFETCH(std::string, lines);
        QFETCH(QString, says);
        const QString path = written("strange.csv", kHead + lines);
        const Ending text = simulate({}, path);
        expectDone(text);
        const QJsonArray listed = simulate({"--json"}, path).json()["warnings"].toArray();
        QCOMPARE(listed.size(), says.isEmpty() ? 0 : 1);
        QCOMPARE(text.error.isEmpty(), says.isEmpty());
        QVERIFY2(text.error.contains(says.toUtf8()), text.error);
        if (!listed.isEmpty())
            QCOMPARE(text.error, "cusp: warning: " + listed[0].toString().toUtf8() + ".\n");
    }

    void badPresetsSayWhatToDo_data()
    {
        QTest::addColumn<QString>("preset");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("a folder") << m_folder.path() << QByteArray("name natural, typodont or a JSON file");
        QTest::newRow("out of range")
            << written("hard.json", R"({"enamel": {"rate_mm3_per_ns": 1e9}})")
            << QByteArray("enamel.rate_mm3_per_ns: is 1000000000, it must lie between 0 and 100 mm³/(N s)");
        QTest::newRow("unknown figure") << written("odd.json", R"({"enamel": {"rate": 1}})") << QByteArray("--help");
        QTest::newRow("no JSON") << written("no.json", "rate: 1") << QByteArray("--help");
    }

    void badPresetsSayWhatToDo()
    {
        QFETCH(QString, preset);
        QFETCH(QByteArray, says);
        expectRefusal(simulate({"--preset", preset}), says);
    }

    void aFailureLeavesTheOlderTrace()
    {
        const QString trace = written("older.csv", "older");
        const QString users = written("older.csv.part", "mine");
        {
            const support::FullDisk full(10'000);  // inherited by the program
            expectRefusal(simulate({}, m_path, trace));
        }
        QCOMPARE(contentOf(trace), QByteArray("older"));
        expectDone(simulate({}, m_path, trace));
        QVERIFY(contentOf(trace).startsWith("t_s,"));
        QCOMPARE(contentOf(users), QByteArray("mine"));
        QCOMPARE(QDir(m_folder.path()).entryList({"older*"}).size(), 2);
    }

    void theTraceGoesIntoStreams()
    {
        const auto into = [this](const QString& out) { return simulate({"--json"}, m_path, out); };
        const QString hash = into(m_trace).json()["state_hash"].toString();
        QVERIFY(!hash.isEmpty());
        for (const char* name : {"-", "/dev/stdout"}) {
            const Ending ending = into(name);
            expectDone(ending);
            QVERIFY(ending.out.startsWith("t_s,x_mm,"));
            QCOMPARE(ending.out.count('\n'), 1202);
            QCOMPARE(QJsonDocument::fromJson(ending.error).object()["state_hash"].toString(), hash);
        }
        QCOMPARE(into("/dev/null").json()["state_hash"].toString(), hash);
        const Ending full = into("/dev/full");
        expectRefusal(full);

        const QString pipe = at("pipe");
        QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
        QByteArray read;
        std::thread reader([&] { read = contentOf(pipe); });
        const Ending piped = into(pipe);
        reader.join();
        expectDone(piped);
        QCOMPARE(read.count('\n'), 1202);
        QVERIFY2(!QFileInfo(pipe).isFile(), "the pipe is still one");
    }

    void aRecordingThatCannotBeWrittenIsRefusedAtOnce()
    {
        const QString trace = at("never.csv");
        const Ending ending = simulate({"--record", at("nowhere/a.cusprec")}, m_path, trace);
        QCOMPARE(ending.exitCode, 1);
        QVERIFY2(ending.error.contains("nowhere/a.cusprec cannot be written"), ending.error);
        QVERIFY(!QFile::exists(trace));
    }

    void namesThatAreNotUtf8AreRefused()
    {
        // A Latin-1 file name, as on an old disk. runCusp() passes only UTF-8, so a shell passes the byte.
        const QString script = written("latin.sh", "exec \"$1\" tooth \"$(printf 'pr\\344molar.obj')\"\n");
        QProcess shell;
        shell.start("sh", {script, CUSP_BINARY_DIR "/bin/cusp"});
        QVERIFY(shell.waitForFinished());
        QCOMPARE(shell.exitCode(), 1);
        const QByteArray said = shell.readAllStandardError();
        QVERIFY2(said.contains("not written in UTF-8; rename the file") && said.count('\n') == 1, said);
    }

    void wordsOutOfAFileSteerNoTerminal()
    {
        const Ending ending = runCusp({"tooth", at("odd\x1b[2J.obj")});
        QCOMPARE(ending.exitCode, 1);
        QVERIFY2(ending.isOneSentence() && !ending.error.contains('\x1b') && ending.error.contains("odd?[2J"),
                 ending.error);
    }

    void badInputIsOneSentence_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("out");
        const auto bad = [&](const char* name, const std::string& bytes) {
            QTest::newRow(name) << written(QString(name) + ".csv", bytes) << m_trace;
        };
        bad("missing column", "t_s,x_mm,y_mm,drill\n0,0,0,0\n");
        bad("bad number", kHead + "0,0,zero,0,0\n");
        bad("time back", kHead + "1,0,0,0,0\n0,0,0,0,0\n");
        bad("empty", "");
        QTest::newRow("no such path") << at("none.csv") << m_trace;
        QTest::newRow("path is a folder") << m_folder.path() << m_trace;
        QTest::newRow("out in no folder") << m_path << at("none/t.csv");
        QTest::newRow("out in a folder that takes nothing") << m_path << "/proc/t.csv";
        QTest::newRow("out is a folder") << m_path << m_folder.path();
    }

    void badInputIsOneSentence()
    {
        QFETCH(QString, path);
        QFETCH(QString, out);
        expectRefusal(simulate({"--json"}, path, out));
    }

    void wrongUsage_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("no path") << QStringList{"--out", "t.csv"};
        QTest::newRow("trace over the path") << QStringList{"--path", m_path, "--out", m_path};
        const QString bur = m_folder.filePath("mine.txt");
        QTest::newRow("trace over the bur") << QStringList{"--path", m_path, "--bur", bur, "--out", bur};
        const auto row = [this](const char* name, const QStringList& options) {
            QTest::newRow(name) << QStringList{"--path", m_path, "--out", m_trace} + options;
        };
        row("one file for trace and recording", {"--record", at("./t.csv")});
        row("recording over the path", {"--record", m_path});
        row("unknown option", {"--fast"});
        row("rate twice", {"--rate", "500", "--rate", "1000"});
        row("unit of no file", {"--unit", "mm"});
        row("unknown bur", {"--bur", "9"});
        row("unknown handpiece", {"--handpiece", "chisel"});
        row("unknown method", {"--method", "magic"});
        row("rate 0", {"--rate", "0"});
        row("rate nan", {"--rate", "nan"});
        row("grid 63", {"--grid", "63"});
        row("grid 1025", {"--grid", "1025"});
    }

    void wrongUsage()
    {
        QFETCH(QStringList, options);
        const Ending ending = runCusp(QStringList{"simulate", "--tooth", "36"} + options);
        QCOMPARE(ending.exitCode, 2);
        QCOMPARE(ending.error.count('\n'), 1);
    }

    void memoryStaysUnder80MiB_data()
    {
        QTest::addColumn<std::string>("lines");
        QTest::addColumn<int>("ticks");
        QTest::addColumn<QStringList>("options");
        QTest::newRow("a minute") << std::string("0,-2,0,-3,1\n30,2,0,-3,1\n60,-2,0.5,-3.5,1\n") << 0
                                  << QStringList{"--record", at("minute.cusprec")};
        QTest::newRow("a path of ten minutes") << std::string() << 600'001 << QStringList{"--rate", "20"};
    }

    void memoryStaysUnder80MiB()
    {
        QFETCH(std::string, lines);
        QFETCH(int, ticks);
        QFETCH(QStringList, options);
        // The file is written line by line, because the memory of this process would count for the program that it
        // starts.
        QFile file(written("long.csv", kHead + lines));
        QVERIFY(file.open(QIODevice::Append));
        for (int tick = 0; tick < ticks; ++tick)
            file.write(QByteArray::number(tick * 0.001, 'f', 3) + ",0.123456,-0.234567,-2.345678,1\n");
        file.close();
        const Ending ending = simulate(options, file.fileName());
        expectDone(ending);
        qInfo("peak memory %ld MiB", ending.peakMiB);
        QVERIFY(ending.peakMiB < 80);
    }

private:
    const std::string kHead = "t_s,x_mm,y_mm,z_mm,drill\n";

    [[nodiscard]] QString at(const QString& name) const { return m_folder.filePath(name); }
    QString written(const QString& name, const std::string& bytes) const
    {
        support::write(at(name), bytes);
        return at(name);
    }
    static QByteArray contentOf(const QString& path)
    {
        return QByteArray::fromStdString(support::bytesOf(path.toStdString()));
    }

    /// Simulates a path on tooth 36. The overload without a path uses m_path and writes m_trace.
    [[nodiscard]] Ending simulate(const QStringList& options, const QString& path, const QString& out) const
    {
        return runCusp(QStringList{"simulate", "--tooth", "36", "--path", path, "--out", out} + options);
    }
    [[nodiscard]] Ending simulate(const QStringList& options, const QString& path) const
    {
        return simulate(options, path, m_trace);
    }
    [[nodiscard]] Ending simulate(const QStringList& options) const { return simulate(options, m_path); }

    QTemporaryDir m_folder;
    const QString m_path = written("path.csv", kHead + "0,0,0,3,0\n0.5,0,0,-4,1\n1,0.5,0,-4,1\n1.2,0.5,0,3,0\n");
    const QString m_trace = at("t.csv");
};

QTEST_GUILESS_MAIN(TestSimulateCommand)
#include "tst_simulate_command.moc"
