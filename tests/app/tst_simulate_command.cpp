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

#include "tests/support/FullDisk.h"
#include "tests/support/Program.h"
#include "tests/support/Solids.h"

using support::Ending;
using support::runCusp;

namespace {

const QByteArray kPath = "t_s,x_mm,y_mm,z_mm,drill\n0,0,0,3,0\n0.5,0,0,-4,1\n1,0.5,0,-4,1\n1.2,0.5,0,3,0\n";

}  // namespace

/// Runs simulate and replay as a user does.
class TestSimulateCommand : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { m_path = write("path.csv", kPath); }

    void traceHasARowATick()
    {
        const QString trace = m_folder.filePath("trace.csv");
        const Ending ending = runCusp({"simulate", "--tooth", "36", "--path", m_path, "--out", trace, "--json"});
        QVERIFY2(ending.exitCode == 0, ending.error);
        const QJsonObject figures = ending.json();
        for (const char* key : {"ticks", "tick_us", "removed_mm3", "broken_mm3", "state_hash"})
            QVERIFY2(figures.contains(key), key);
        for (const char* key : {"p50", "p99", "p999", "max"})
            QVERIFY2(figures["tick_us"].toObject().contains(key), key);
        for (const char* key : {"caries", "enamel", "dentin", "pulp"})
            QVERIFY2(figures["removed_mm3"].toObject().contains(key), key);
        QCOMPARE(figures["ticks"].toInt(), 1201);
        QFile file(trace);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), 1202);
        QVERIFY(lines[0].startsWith("t_s,x_mm,y_mm,z_mm,ax_mm,ay_mm,az_mm,fx_n,fy_n,fz_n,contact,"));
        for (const QByteArray& line : lines)
            QCOMPARE(line.count(','), lines[0].count(','));
    }

    void replayComesToTheSameHash()
    {
        const QString recording = m_folder.filePath("attempt.cusprec");
        const Ending made = runCusp({"simulate", "--tooth", "36", "--path", m_path, "--out", m_folder.filePath("t.csv"),
                                     "--record", recording, "--json"});
        QVERIFY2(made.exitCode == 0, made.error);
        const Ending replayed = runCusp({"replay", recording, "--json"});
        QVERIFY2(replayed.exitCode == 0, replayed.error);
        const QJsonObject figures = replayed.json();
        QCOMPARE(figures["state_hash"].toString(), made.json()["state_hash"].toString());
        QVERIFY(figures["verified"].toBool());
        QVERIFY(figures.contains("score") && figures.contains("measures") && figures.contains("removed_mm3"));
        QCOMPARE(figures["ticks"].toInt(), 1201);
    }

    void handpieceAndBreakingGoIntoTheRecording()
    {
        const auto enamelOf = [&](const QStringList& options, const char* name) {
            const QString recording = m_folder.filePath(name);
            const Ending made = runCusp(QStringList{"simulate", "--tooth", "36", "--path", m_path, "--out",
                                                    m_folder.filePath("t.csv"), "--record", recording, "--json"} +
                                        options);
            const Ending replayed = runCusp({"replay", recording, "--json"});
            return made.exitCode == 0 && replayed.json()["state_hash"] == made.json()["state_hash"]
                       ? made.json()["removed_mm3"].toObject()["enamel"].toDouble()
                       : -1.0;
        };
        const double turbine = enamelOf({}, "turbine.cusprec");
        const double slow = enamelOf({"--handpiece", "low-speed", "--break-off"}, "slow.cusprec");
        QVERIFY2(turbine > 0.0 && slow >= 0.0 && slow < 0.5 * turbine,
                 qPrintable(QString("%1, %2").arg(turbine).arg(slow)));
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
        QFETCH(int, ticks);
        const Ending ending = runCusp(
            QStringList{"simulate", "--tooth", "36", "--path", m_path, "--out", m_folder.filePath("t.csv"), "--json"} +
            options);
        QVERIFY2(ending.exitCode == 0, ending.error);
        QCOMPARE(ending.json()["ticks"].toInt(), ticks);
    }

    void frameOfTheFileIsKept()
    {
        // A block whose top lies at z = 9 of the file; the path comes down onto its middle in the file's coordinates.
        const QString block = write("block.obj", QByteArray::fromStdString(support::asObj(support::moved(
                                                     support::box(8.0F, 9.0F, 7.0F), {30.0F, -4.0F, 2.0F}))));
        const QString path = write("down.csv", "t_s,x_mm,y_mm,z_mm,drill\n0,34,0.5,12,0\n1,34,0.5,8.5,0\n");
        const QString trace = m_folder.filePath("down-trace.csv");
        const auto lastRow = [&](const QStringList& options) {
            const Ending ending =
                runCusp(QStringList{"simulate", "--tooth", block, "--path", path, "--out", trace} + options);
            QFile file(trace);
            if (ending.exitCode != 0 || !file.open(QIODevice::ReadOnly))
                return QList<QByteArray>{};
            return file.readAll().trimmed().split('\n').back().split(',');
        };
        const QList<QByteArray> kept = lastRow({"--frame", "file"});
        QCOMPARE(kept.size(), 15);
        QCOMPARE(kept[1].toDouble(), 34.0);  // the device
        QCOMPARE(kept[3].toDouble(), 8.5);
        QVERIFY(std::abs(kept[4].toDouble() - 34.0) < 0.01);  // the anchor rests on the block
        QVERIFY2(std::abs(kept[6].toDouble() - 9.0) < 0.01, kept[6]);
        QVERIFY(kept[9].toDouble() > 0.1);
        QCOMPARE(kept[10], QByteArray("1"));
        // In the tooth's frame the same path passes far beside the block.
        const QList<QByteArray> moved = lastRow({"--up", "+z"});
        QCOMPARE(moved.size(), 15);
        QCOMPARE(moved[10], QByteArray("0"));
    }

    void warningsOfTheScanAreShown()
    {
        // A millimetre wide, it can be no tooth in millimetres: the importer guesses a unit and says so.
        const QString scan =
            write("cap.stl", QByteArray::fromStdString(support::asBinaryStl(support::sphereCap(0.5F, 0.5F, 40, 10))));
        const QStringList arguments{"simulate", "--tooth", scan, "--path", m_path, "--out", m_folder.filePath("t.csv")};
        const Ending text = runCusp(arguments);
        QCOMPARE(text.exitCode, 0);
        const QJsonArray listed = runCusp(arguments + QStringList{"--json"}).json()["warnings"].toArray();
        QVERIFY(!listed.isEmpty());
        QCOMPARE(text.error.count('\n'), static_cast<int>(listed.size()));
        for (const QJsonValue& warning : listed)
            QVERIFY2(text.error.contains("cusp: warning: " + warning.toString().toLocal8Bit()), text.error);
        QCOMPARE(runCusp({"tooth", scan, "--json"}).json()["warnings"].toArray(), listed);
    }

    void badPresetsSayWhatToDo_data()
    {
        QTest::addColumn<QString>("preset");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("a folder") << m_folder.path() << QByteArray("name natural, typodont or a JSON file");
        QTest::newRow("out of range")
            << write("hard.json", R"({"enamel": {"rate_mm3_per_ns": 1e9}})")
            << QByteArray("enamel.rate_mm3_per_ns: is 1000000000, it must lie between 0 and 100 mm³/(N s)");
        QTest::newRow("unknown figure") << write("odd.json", R"({"enamel": {"rate": 1}})") << QByteArray("--help");
        QTest::newRow("no JSON") << write("no.json", "rate: 1") << QByteArray("--help");
    }

    void badPresetsSayWhatToDo()
    {
        QFETCH(QString, preset);
        QFETCH(QByteArray, says);
        const Ending ending = runCusp(
            {"simulate", "--tooth", "36", "--path", m_path, "--out", m_folder.filePath("t.csv"), "--preset", preset});
        QCOMPARE(ending.exitCode, 1);
        QVERIFY2(ending.isOneSentence() && ending.error.contains(says), ending.error);
    }

    void aFailureLeavesTheOlderTrace()
    {
        const QString trace = write("older.csv", "older");
        const QString users = write("older.csv.part", "mine");
        const QStringList arguments{"simulate", "--tooth", "36", "--path", m_path, "--out", trace};
        {
            const support::FullDisk full(10'000);  // inherited by the program
            const Ending ending = runCusp(arguments);
            QCOMPARE(ending.exitCode, 1);
            QVERIFY2(ending.isOneSentence(), ending.error);
        }
        const auto contents = [](const QString& name) {
            QFile file(name);
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        QCOMPARE(contents(trace), QByteArray("older"));
        QCOMPARE(runCusp(arguments).exitCode, 0);
        QVERIFY(contents(trace).startsWith("t_s,"));
        QCOMPARE(contents(users), QByteArray("mine"));
        QCOMPARE(QDir(m_folder.path()).entryList({"older*"}).size(), 2);
    }

    void theTraceGoesIntoStreams()
    {
        const QStringList arguments{"simulate", "--tooth", "36", "--path", m_path, "--json", "--out"};
        const QString hash =
            runCusp(arguments + QStringList{m_folder.filePath("t.csv")}).json()["state_hash"].toString();
        QVERIFY(!hash.isEmpty());
        for (const char* name : {"-", "/dev/stdout"}) {
            const Ending ending = runCusp(arguments + QStringList{name});
            QCOMPARE(ending.exitCode, 0);
            QVERIFY(ending.out.startsWith("t_s,x_mm,"));
            QCOMPARE(ending.out.count('\n'), 1202);
            QCOMPARE(QJsonDocument::fromJson(ending.error).object()["state_hash"].toString(), hash);
        }
        const Ending nowhere = runCusp(arguments + QStringList{"/dev/null"});
        QCOMPARE(nowhere.exitCode, 0);
        QCOMPARE(nowhere.json()["state_hash"].toString(), hash);
        const Ending full = runCusp(arguments + QStringList{"/dev/full"});
        QCOMPARE(full.exitCode, 1);
        QVERIFY2(full.isOneSentence(), full.error);

        const QString pipe = m_folder.filePath("pipe");
        QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
        QByteArray read;
        std::thread reader([&] {
            QFile file(pipe);
            if (file.open(QIODevice::ReadOnly))
                read = file.readAll();
        });
        const Ending piped = runCusp(arguments + QStringList{pipe});
        reader.join();
        QCOMPARE(piped.exitCode, 0);
        QCOMPARE(read.count('\n'), 1202);
        QVERIFY2(!QFileInfo(pipe).isFile(), "the pipe is still one");
    }

    void aPathThatBeginsTooDeepIsWarnedAbout()
    {
        const auto warning = [&](const QByteArray& firstZ) {
            const QString path = write("deep.csv", "t_s,x_mm,y_mm,z_mm,drill\n0,0,0," + firstZ + ",0\n0.1,0,0,3,0\n");
            const QStringList arguments{
                "simulate", "--tooth", "36", "--path", path, "--out", m_folder.filePath("t.csv")};
            const Ending text = runCusp(arguments);
            const QJsonArray listed = runCusp(arguments + QStringList{"--json"}).json()["warnings"].toArray();
            return listed.size() == 1 && text.error == "cusp: warning: " + listed[0].toString().toUtf8() + ".\n"
                       ? listed[0].toString()
                       : QString::fromUtf8(text.error);
        };
        QVERIFY2(warning("-12.5").contains("begins at z -12.50 mm"), qPrintable(warning("-12.5")));
        QCOMPARE(warning("-7.9"), QString());
    }

    void aPathThatLeapsIsWarnedAbout()
    {
        // 30 mm within one tick, and back five ticks later.
        const QString path = write("leap.csv", "t_s,x_mm,y_mm,z_mm,drill\n0,0,0,3,0\n0.1,0,0,3,0\n0.101,30,0,3,0\n"
                                               "0.105,30,0,3,0\n0.106,0,0,3,0\n0.2,0,0,3,0\n");
        const QStringList arguments{
            "simulate", "--tooth", "36", "--path", path, "--out", m_folder.filePath("leap.out.csv")};
        const Ending leaping = runCusp(arguments);
        QCOMPARE(leaping.exitCode, 0);
        QVERIFY2(leaping.error.contains("The path leaps: 5 ticks of it"), leaping.error);
        QCOMPARE(runCusp(arguments + QStringList{"--json"}).json()["warnings"].toArray().size(), 1);
    }

    void aRecordingThatCannotBeWrittenIsRefusedAtOnce()
    {
        const QString trace = m_folder.filePath("never.csv");
        const Ending ending = runCusp({"simulate", "--tooth", "36", "--path", m_path, "--out", trace, "--record",
                                       m_folder.filePath("nowhere/a.cusprec")});
        QCOMPARE(ending.exitCode, 1);
        QVERIFY2(ending.error.contains("nowhere/a.cusprec cannot be written"), ending.error);
        QVERIFY(!QFile::exists(trace));
    }

    void namesThatAreNotUtf8AreRefused()
    {
        // Latin 1, as old disks have it. runCusp() speaks UTF-8 only, so a shell passes the byte on.
        const QString script = write("latin.sh", "exec \"$1\" tooth \"$(printf 'pr\\344molar.obj')\"\n");
        QProcess shell;
        shell.start("sh", {script, CUSP_BINARY_DIR "/bin/cusp"});
        QVERIFY(shell.waitForFinished());
        QCOMPARE(shell.exitCode(), 1);
        const QByteArray said = shell.readAllStandardError();
        QVERIFY2(said.contains("not written in UTF-8; rename the file") && said.count('\n') == 1, said);
    }

    void wordsOutOfAFileSteerNoTerminal()
    {
        const QString odd = m_folder.filePath("odd\x1b[2J.obj");
        const Ending ending = runCusp({"tooth", odd});
        QCOMPARE(ending.exitCode, 1);
        QVERIFY2(ending.isOneSentence() && !ending.error.contains('\x1b') && ending.error.contains("odd?[2J"),
                 ending.error);
    }

    void badInputIsOneSentence_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("out");
        const QString trace = m_folder.filePath("t.csv");
        const auto bad = [&](const char* name, const QByteArray& bytes) {
            QTest::newRow(name) << write(QString(name) + ".csv", bytes) << trace;
        };
        bad("missing column", "t_s,x_mm,y_mm,drill\n0,0,0,0\n");
        bad("bad number", "t_s,x_mm,y_mm,z_mm,drill\n0,0,zero,0,0\n");
        bad("time back", "t_s,x_mm,y_mm,z_mm,drill\n1,0,0,0,0\n0,0,0,0,0\n");
        bad("empty", "");
        QTest::newRow("no such path") << m_folder.filePath("none.csv") << trace;
        QTest::newRow("path is a folder") << m_folder.path() << trace;
        QTest::newRow("out in no folder") << m_path << m_folder.filePath("none/t.csv");
        QTest::newRow("out in a folder that takes nothing") << m_path << "/proc/t.csv";
        QTest::newRow("out is a folder") << m_path << m_folder.path();
    }

    void badInputIsOneSentence()
    {
        QFETCH(QString, path);
        QFETCH(QString, out);
        const Ending ending = runCusp({"simulate", "--tooth", "36", "--path", path, "--out", out, "--json"});
        QCOMPARE(ending.exitCode, 1);
        QVERIFY2(ending.isOneSentence(), ending.error);
    }

    void wrongUsage_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("no path") << QStringList{"--out", "t.csv"};
        QTest::newRow("one file for trace and recording") << QStringList{
            "--path", m_path, "--out", m_folder.filePath("t.csv"), "--record", m_folder.filePath("./t.csv")};
        QTest::newRow("trace over the path") << QStringList{"--path", m_path, "--out", m_path};
        QTest::newRow("recording over the path") << QStringList{"--path", m_path, "--out", "t.csv", "--record", m_path};
        QTest::newRow("unknown option") << QStringList{"--path", m_path, "--out", "t.csv", "--fast"};
        QTest::newRow("rate twice") << QStringList{"--path", m_path, "--out",  "t.csv",
                                                   "--rate", "500",  "--rate", "1000"};
        QTest::newRow("unit of no file") << QStringList{"--path", m_path, "--out", "t.csv", "--unit", "mm"};
        QTest::newRow("unknown bur") << QStringList{"--path", m_path, "--out", "t.csv", "--bur", "9"};
        QTest::newRow("unknown handpiece") << QStringList{"--path", m_path, "--out", "t.csv", "--handpiece", "chisel"};
        QTest::newRow("unknown method") << QStringList{"--path", m_path, "--out", "t.csv", "--method", "magic"};
        QTest::newRow("rate 0") << QStringList{"--path", m_path, "--out", "t.csv", "--rate", "0"};
        QTest::newRow("rate nan") << QStringList{"--path", m_path, "--out", "t.csv", "--rate", "nan"};
        QTest::newRow("grid 63") << QStringList{"--path", m_path, "--out", "t.csv", "--grid", "63"};
        QTest::newRow("grid 1025") << QStringList{"--path", m_path, "--out", "t.csv", "--grid", "1025"};
    }

    void wrongUsage()
    {
        QFETCH(QStringList, options);
        const Ending ending = runCusp(QStringList{"simulate", "--tooth", "36"} + options);
        QCOMPARE(ending.exitCode, 2);
        QCOMPARE(ending.error.count('\n'), 1);
    }

    void aMinuteStaysUnder80MiB()
    {
        const QString path =
            write("minute.csv", "t_s,x_mm,y_mm,z_mm,drill\n0,-2,0,-3,1\n30,2,0,-3,1\n60,-2,0.5,-3.5,1\n");
        const Ending ending = runCusp({"simulate", "--tooth", "36", "--path", path, "--out", m_folder.filePath("t.csv"),
                                       "--record", m_folder.filePath("minute.cusprec"), "--json"});
        QVERIFY2(ending.exitCode == 0, ending.error);
        qInfo("peak memory %ld MiB", ending.peakMiB);
        QVERIFY(ending.peakMiB < 80);
    }

    void aPathOfTenMinutesStaysUnder80MiB()
    {
        QFile file(m_folder.filePath("ten-minutes.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("t_s,x_mm,y_mm,z_mm,drill\n");
        for (int tick = 0; tick <= 600'000; ++tick)
            file.write(QByteArray::number(tick * 0.001, 'f', 3) + ",0.123456,-0.234567,-2.345678,1\n");
        file.close();
        const Ending ending = runCusp({"simulate", "--tooth", "36", "--path", file.fileName(), "--rate", "20", "--out",
                                       m_folder.filePath("t.csv")});
        file.remove();
        QVERIFY2(ending.exitCode == 0, ending.error);
        qInfo("peak memory %ld MiB", ending.peakMiB);
        QVERIFY(ending.peakMiB < 80);
    }

private:
    QString write(const QString& name, const QByteArray& bytes)
    {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            return {};
        return file.fileName();
    }

    QTemporaryDir m_folder;
    QString m_path;
};

QTEST_GUILESS_MAIN(TestSimulateCommand)
#include "tst_simulate_command.moc"
