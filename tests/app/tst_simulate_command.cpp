// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

namespace {

/// How the real program ended.
struct Ending
{
    int exitCode = -1;  ///< -1: killed by a signal
    QByteArray out;
    QByteArray error;
    long peakMiB = 0;
};

const QByteArray kPath = "t_s,x_mm,y_mm,z_mm,drill\n0,0,0,3,0\n0.5,0,0,-4,1\n1,0.5,0,-4,1\n1.2,0.5,0,3,0\n";

}  // namespace

/// Runs simulate and replay as a user does.
class TestSimulateCommand : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void traceHasARowATick();
    void replayComesToTheSameHash();
    void otherRatesAndGrids_data();
    void otherRatesAndGrids();
    void badInputIsOneSentence_data();
    void badInputIsOneSentence();
    void wrongUsage_data();
    void wrongUsage();
    void aMinuteStaysUnder80MiB();

private:
    Ending run(const QStringList& arguments);
    QString write(const QString& name, const QByteArray& bytes);
    static QJsonObject json(const Ending& ending) { return QJsonDocument::fromJson(ending.out).object(); }

    QTemporaryDir m_folder;
    QString m_path;
};

void TestSimulateCommand::initTestCase()
{
    m_path = write("path.csv", kPath);
}

QString TestSimulateCommand::write(const QString& name, const QByteArray& bytes)
{
    QFile file(m_folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        return {};
    return file.fileName();
}

Ending TestSimulateCommand::run(const QStringList& arguments)
{
    // Not QProcess: wait4 tells the peak memory of this very process.
    const QByteArray outFile = m_folder.filePath("out").toLocal8Bit();
    const QByteArray errorFile = m_folder.filePath("error").toLocal8Bit();
    std::vector<QByteArray> words{QByteArray(CUSP_BINARY_DIR "/bin/cusp")};
    for (const QString& argument : arguments)
        words.push_back(argument.toLocal8Bit());
    std::vector<char*> argv;
    for (QByteArray& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        dup2(open(outFile.constData(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 1);
        dup2(open(errorFile.constData(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 2);
        execv(argv[0], argv.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    const auto read = [](const QByteArray& name) {
        QFile file(name);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(outFile), read(errorFile), usage.ru_maxrss / 1024};
}

void TestSimulateCommand::traceHasARowATick()
{
    const QString trace = m_folder.filePath("trace.csv");
    const Ending ending = run({"simulate", "--tooth", "36", "--path", m_path, "--out", trace, "--json"});
    QVERIFY2(ending.exitCode == 0, ending.error);
    const QJsonObject figures = json(ending);
    for (const char* key : {"ticks", "tick_us", "removed_mm3", "state_hash"})
        QVERIFY2(figures.contains(QLatin1String(key)), key);
    for (const char* key : {"p50", "p99", "p999", "max"})
        QVERIFY2(figures["tick_us"].toObject().contains(QLatin1String(key)), key);
    for (const char* key : {"caries", "enamel", "dentin", "pulp"})
        QVERIFY2(figures["removed_mm3"].toObject().contains(QLatin1String(key)), key);
    QCOMPARE(figures["ticks"].toInt(), 1201);
    QFile file(trace);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
    QCOMPARE(lines.size(), 1202);
    QVERIFY(lines[0].startsWith("t_s,x_mm,y_mm,z_mm,ax_mm,ay_mm,az_mm,fx_n,fy_n,fz_n,contact,"));
    for (const QByteArray& line : lines)
        QCOMPARE(line.count(','), lines[0].count(','));
}

void TestSimulateCommand::replayComesToTheSameHash()
{
    const QString recording = m_folder.filePath("attempt.cusprec");
    const Ending made = run({"simulate", "--tooth", "36", "--path", m_path, "--out", m_folder.filePath("t.csv"),
                             "--record", recording, "--json"});
    QVERIFY2(made.exitCode == 0, made.error);
    const Ending replayed = run({"replay", recording, "--json"});
    QVERIFY2(replayed.exitCode == 0, replayed.error);
    const QJsonObject figures = json(replayed);
    QCOMPARE(figures["state_hash"].toString(), json(made)["state_hash"].toString());
    QVERIFY(figures["verified"].toBool());
    QVERIFY(figures.contains("score") && figures.contains("measures") && figures.contains("removed_mm3"));
    QCOMPARE(figures["ticks"].toInt(), 1201);
}

void TestSimulateCommand::otherRatesAndGrids_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("ticks");
    QTest::newRow("250 Hz") << QStringList{"--rate", "250"} << 301;
    QTest::newRow("4 kHz") << QStringList{"--rate", "4000"} << 4801;
    QTest::newRow("grid 64") << QStringList{"--grid", "64"} << 1201;
    QTest::newRow("grid 1024") << QStringList{"--grid", "1024", "--rate", "250"} << 301;
    QTest::newRow("lattice") << QStringList{"--method", "lattice", "--bur", "57", "--drill"} << 1201;
}

void TestSimulateCommand::otherRatesAndGrids()
{
    QFETCH(QStringList, options);
    QFETCH(int, ticks);
    const Ending ending =
        run(QStringList{"simulate", "--tooth", "36", "--path", m_path, "--out", m_folder.filePath("t.csv"), "--json"} +
            options);
    QVERIFY2(ending.exitCode == 0, ending.error);
    QCOMPARE(json(ending)["ticks"].toInt(), ticks);
}

void TestSimulateCommand::badInputIsOneSentence_data()
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

void TestSimulateCommand::badInputIsOneSentence()
{
    QFETCH(QString, path);
    QFETCH(QString, out);
    const Ending ending = run({"simulate", "--tooth", "36", "--path", path, "--out", out, "--json"});
    QCOMPARE(ending.exitCode, 1);
    QVERIFY(ending.out.isEmpty());
    QVERIFY2(ending.error.startsWith("cusp: ") && ending.error.endsWith(".\n"), ending.error);
    QCOMPARE(ending.error.count('\n'), 1);
}

void TestSimulateCommand::wrongUsage_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::newRow("no path") << QStringList{"--out", "t.csv"};
    QTest::newRow("unknown option") << QStringList{"--path", m_path, "--out", "t.csv", "--fast"};
    QTest::newRow("unknown bur") << QStringList{"--path", m_path, "--out", "t.csv", "--bur", "9"};
    QTest::newRow("unknown method") << QStringList{"--path", m_path, "--out", "t.csv", "--method", "magic"};
    QTest::newRow("rate 0") << QStringList{"--path", m_path, "--out", "t.csv", "--rate", "0"};
    QTest::newRow("rate nan") << QStringList{"--path", m_path, "--out", "t.csv", "--rate", "nan"};
    QTest::newRow("grid 63") << QStringList{"--path", m_path, "--out", "t.csv", "--grid", "63"};
    QTest::newRow("grid 1025") << QStringList{"--path", m_path, "--out", "t.csv", "--grid", "1025"};
}

void TestSimulateCommand::wrongUsage()
{
    QFETCH(QStringList, options);
    const Ending ending = run(QStringList{"simulate", "--tooth", "36"} + options);
    QCOMPARE(ending.exitCode, 2);
    QCOMPARE(ending.error.count('\n'), 1);
}

void TestSimulateCommand::aMinuteStaysUnder80MiB()
{
    const QString path = write("minute.csv", "t_s,x_mm,y_mm,z_mm,drill\n0,-2,0,-3,1\n30,2,0,-3,1\n60,-2,0.5,-3.5,1\n");
    const Ending ending = run({"simulate", "--tooth", "36", "--path", path, "--out", m_folder.filePath("t.csv"),
                               "--record", m_folder.filePath("minute.cusprec"), "--json"});
    QVERIFY2(ending.exitCode == 0, ending.error);
    qInfo("peak memory %ld MiB", ending.peakMiB);
    QVERIFY(ending.peakMiB < 80);
}

QTEST_GUILESS_MAIN(TestSimulateCommand)
#include "tst_simulate_command.moc"
