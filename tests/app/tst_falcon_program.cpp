// SPDX-License-Identifier: GPL-3.0-or-later
// The `cusp falcon` commands, run as a user does, with an emulated Falcon in place of the USB device.
#include <cmath>
#include <csignal>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/Program.h"
#include "tests/support/falcon/BootStream.h"

using support::Ending;
using support::runCusp;

namespace {

constexpr int kPatienceMs = 30'000;

}  // namespace

class TestFalconProgram : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void listsWhatIsPluggedIn();
    void withoutUsbEveryPartSaysSo_data();
    void withoutUsbEveryPartSaysSo();
    void probeLoadsTheFirmwareAndMeasures();
    void probeRefusesAFileThatIsNoFirmware();
    void homeSaysWhatToDo();
    void testPushesInSixDirections();
    void rulesPrintsTheUdevRule();
    void theForceIsZeroAfterASignal_data();
    void theForceIsZeroAfterASignal();
    void aWrongCalibrationFileIsRefused();
    void calibrateRefusesWrongMeasures();
    void calibrateFindsAngleScaleAndWeight();

private:
    [[nodiscard]] QStringList environment() const
    {
        return {QStringLiteral("LD_PRELOAD=" CUSP_BINARY_DIR "/tests/libemulated_falcon.so"),
                QStringLiteral("CUSP_EMULATED_FALCON=") + m_folder->path(),
                QStringLiteral("XDG_CONFIG_HOME=") + m_folder->path()};
    }
    void command(const QByteArray& lines)
    {
        QFile file(m_folder->filePath(QStringLiteral("command")));
        QVERIFY(file.open(QIODevice::Append));
        file.write(lines + '\n');
    }
    /// Returns the values of one line of the emulator's state; empty if there is no such line.
    [[nodiscard]] QByteArrayList state(const QByteArray& name) const
    {
        QFile file(m_folder->filePath(QStringLiteral("state")));
        if (!file.open(QIODevice::ReadOnly))
            return {};
        for (const QByteArray& line : file.readAll().split('\n'))
            if (line.startsWith(name + ' '))
                return line.mid(name.size() + 1).split(' ');
        return {};
    }
    [[nodiscard]] bool hasForce() const
    {
        const QByteArrayList motors = state("motors");
        return motors.size() == 3 && motors != QByteArrayList{"0", "0", "0"};
    }
    /// Returns whether the grip is at this distance from the base.
    [[nodiscard]] bool isAt(double zMm) const
    {
        const QByteArrayList grip = state("grip");
        return grip.size() == 3 && std::abs(grip[2].toDouble() - zMm) < 0.1;
    }
    /// Homes the grip repeatedly until a condition holds: when the program waits for it, pulls the grip out and pushes
    /// it in past the index marks.
    template <class Condition>
    [[nodiscard]] bool homeUntil(Condition condition)
    {
        command("hand none");
        int turns = 0;
        return QTest::qWaitFor(
            [&] {
                if (state("homing") == QByteArrayList{"1"} && state("homed") != QByteArrayList{"1", "1", "1"}) {
                    const double wanted = turns % 2 == 0 ? 165.0 : 90.0;
                    if (turns == 0 || isAt(turns % 2 == 0 ? 90.0 : 165.0)) {
                        command("grip 0 0 " + QByteArray::number(wanted) + " 0.3");
                        ++turns;
                    }
                }
                return condition();
            },
            kPatienceMs);
    }
    [[nodiscard]] QString file(const QByteArray& bytes)
    {
        const QString path = m_folder->filePath(QStringLiteral("given"));
        QFile file(path);
        if (file.open(QIODevice::WriteOnly))
            file.write(bytes);
        return path;
    }

    std::optional<QTemporaryDir> m_folder;
};

void TestFalconProgram::init()
{
    m_folder.emplace();
    QVERIFY(m_folder->isValid());
}

void TestFalconProgram::listsWhatIsPluggedIn()
{
    const Ending none = runCusp({"falcon", "list", "--json"}, environment());
    expectDone(none);
    QVERIFY(none.json()["falcons"].toArray().isEmpty());
    command("plug FT1\nplug FT2\ndeny");
    const Ending two = runCusp({"falcon", "list", "--json"}, environment());
    expectDone(two);
    const QJsonArray rows = two.json()["falcons"].toArray();
    QCOMPARE(rows.size(), 2);
    QCOMPARE(rows[0].toObject()["serial"].toString(), QStringLiteral("FT1"));
    QVERIFY(rows[0].toObject()["usable"].toBool());
    QVERIFY(!rows[1].toObject()["usable"].toBool());
    QVERIFY(!rows[1].toObject()["why"].toString().isEmpty());
}

void TestFalconProgram::withoutUsbEveryPartSaysSo_data()
{
    QTest::addColumn<QString>("part");
    for (const char* part : {"list", "probe", "home", "test", "calibrate"})
        QTest::newRow(part) << part;
}

void TestFalconProgram::withoutUsbEveryPartSaysSo()
{
    QFETCH(QString, part);
    command("usb off");
    QStringList arguments{"falcon", part};
    if (part != u"list")
        arguments << "--wait"
                  << "1";
    const Ending ending = runCusp(arguments, environment());
    QCOMPARE(ending.exitCode, 1);
    QVERIFY(ending.error.contains("USB"));
}

void TestFalconProgram::probeLoadsTheFirmwareAndMeasures()
{
    command("plug FT1");
    const auto image = support::falcon::bootStream();
    const QString firmware =
        file(QByteArray(reinterpret_cast<const char*>(image.data()), static_cast<qsizetype>(image.size())));
    const Ending ending = runCusp({"falcon", "probe", "--firmware", firmware, "--json"}, environment());
    expectDone(ending);
    QCOMPARE(ending.json()["serial"].toString(), QStringLiteral("FT1"));
    QVERIFY(ending.json()["rate_hz"].toDouble() > 0.0);
    QVERIFY(ending.json()["round_trip_us"].toObject()["p50"].toDouble() > 0.0);
    QCOMPARE(state("loads").value(0), QByteArray("1"));
}

void TestFalconProgram::probeRefusesAFileThatIsNoFirmware()
{
    command("plug FT1");
    const Ending ending = runCusp({"falcon", "probe", "--firmware", file("no firmware at all")}, environment());
    QCOMPARE(ending.exitCode, 1);
    QVERIFY(ending.error.contains("not firmware"));
    QCOMPARE(state("image_bytes").value(0), QByteArray("0"));
}

void TestFalconProgram::homeSaysWhatToDo()
{
    command("plug FT1\nfirmware");
    const Ending early = runCusp({"falcon", "home", "--wait", "1"}, environment());
    QCOMPARE(early.exitCode, 1);
    QVERIFY(early.error.contains("Pull the grip"));
}

void TestFalconProgram::testPushesInSixDirections()
{
    command("plug FT1\nfirmware");
    QProcess program;
    QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
    for (const QString& variable : environment())
        all.insert(variable.section('=', 0, 0), variable.section('=', 1));
    program.setProcessEnvironment(all);
    program.start(QStringLiteral(CUSP_BINARY_DIR "/bin/cusp"), {"falcon", "test", "--force", "800", "--json"});
    QVERIFY(homeUntil([&] { return hasForce(); }));
    QVERIFY(program.waitForFinished(kPatienceMs));
    QCOMPARE(program.exitCode(), 0);
    QCOMPARE(program.readAllStandardError().count("Pushing "), 6);
    QVERIFY(!hasForce());
}

void TestFalconProgram::rulesPrintsTheUdevRule()
{
    const Ending ending = runCusp({"falcon", "rules"});
    expectDone(ending);
    QVERIFY(ending.out.contains("ATTR{idVendor}==\"0403\""));
    QVERIFY(ending.out.contains("ATTR{idProduct}==\"cb48\""));
    // The installed rules file contains the same rule.
    QFile shipped(QStringLiteral(CUSP_SOURCE_DIR "/packaging/70-cusp-falcon.rules"));
    QVERIFY(shipped.open(QIODevice::ReadOnly));
    QCOMPARE(shipped.readAll().trimmed().split('\n').last(), ending.out.trimmed().split('\n').last());
}

void TestFalconProgram::theForceIsZeroAfterASignal_data()
{
    QTest::addColumn<int>("signal");
    QTest::newRow("terminated") << SIGTERM;
    QTest::newRow("Ctrl+C") << SIGINT;
    QTest::newRow("a crash") << SIGSEGV;
    QTest::newRow("abort") << SIGABRT;
}

void TestFalconProgram::theForceIsZeroAfterASignal()
{
    QFETCH(int, signal);
    command("plug FT1\nfirmware");
    QProcess program;
    QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
    for (const QString& variable : environment())
        all.insert(variable.section('=', 0, 0), variable.section('=', 1));
    program.setProcessEnvironment(all);
    program.start(QStringLiteral(CUSP_BINARY_DIR "/bin/cusp"), {"falcon", "test", "--force", "1000"});
    QVERIFY(homeUntil([&] { return hasForce(); }));
    QCOMPARE(::kill(static_cast<pid_t>(program.processId()), signal), 0);
    QVERIFY(program.waitForFinished(kPatienceMs));
    QVERIFY(!hasForce());
}

void TestFalconProgram::aWrongCalibrationFileIsRefused()
{
    command("plug FT1\nfirmware");
    for (const QByteArray& text : {QByteArray(), QByteArray("text"), QByteArray("{\"format\": 2}"),
                                   QByteArray("{\"format\": 1, \"command_per_nm\": \"many\"}"),
                                   QByteArray("{\"format\": 1, \"command_per_nm\": 0}"),
                                   QByteArray("{\"format\": 1, \"home_deg\": [35, 35]}")}) {
        const Ending ending = runCusp({"falcon", "probe", "--calibration", file(text)}, environment());
        expectRefusal(ending);
    }
    expectRefusal(runCusp({"falcon", "probe", "--calibration", "/does/not/exist"}, environment()));
    expectDone(runCusp({"falcon", "probe", "--calibration", file("{\"format\": 1, \"command_per_nm\": 6616}")},
                       environment()));
}

void TestFalconProgram::calibrateRefusesWrongMeasures()
{
    expectRefusal(runCusp({"falcon", "calibrate", "--weight", "5"}, environment()), "--weight", 2);
}

void TestFalconProgram::calibrateFindsAngleScaleAndWeight()
{
    command("plug FT1\nfirmware\nscale 6616");
    const QString file = m_folder->filePath(QStringLiteral("found.json"));
    QProcess program;
    QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
    for (const QString& variable : environment())
        all.insert(variable.section('=', 0, 0), variable.section('=', 1));
    program.setProcessEnvironment(all);
    program.start(QStringLiteral(CUSP_BINARY_DIR "/bin/cusp"),
                  {"falcon", "calibrate", "--travel", "60", "--weight", "200", "--out", file});
    QByteArray said;
    const auto hasAsked = [&](int times) {
        said += program.readAllStandardError();
        return said.count("Then press Enter") == times;
    };
    QVERIFY(homeUntil([&] { return hasAsked(1); }));
    command("grip 0 0 78 0.2");
    QTRY_VERIFY_WITH_TIMEOUT(isAt(78.0), kPatienceMs);
    program.write("\n");
    QTRY_VERIFY_WITH_TIMEOUT(hasAsked(2), kPatienceMs);
    command("grip 0 0 138 0.2");
    QTRY_VERIFY_WITH_TIMEOUT(isAt(138.0), kPatienceMs);
    program.write("\n");
    QTRY_VERIFY_WITH_TIMEOUT(hasAsked(3), kPatienceMs);
    command("grip 0 0 125 0.2");
    QTRY_VERIFY_WITH_TIMEOUT(isAt(125.0), kPatienceMs);
    command("hand light");
    program.write("\n");
    QTRY_VERIFY_WITH_TIMEOUT(hasAsked(4), kPatienceMs);
    // The light hand is a spring of 60 N/m. It pulls at the grip like a weight of 200 g.
    program.write("\n");
    command("grip 0 -32.7 125 0.5");
    QVERIFY(program.waitForFinished(kPatienceMs));
    QCOMPARE(program.exitCode(), 0);
    QFile found(file);
    QVERIFY(found.open(QIODevice::ReadOnly));
    const QJsonObject values = QJsonDocument::fromJson(found.readAll()).object();
    QVERIFY(std::abs(values["home_deg"].toArray()[0].toDouble() - 35.0) < 0.5);
    QVERIFY2(std::abs(values["command_per_nm"].toDouble() / 6616.0 - 1.0) < 0.1,
             qPrintable(QString::number(values["command_per_nm"].toDouble())));
    QVERIFY(values["grip_weight_n"].toDouble() < 0.2);
}

QTEST_GUILESS_MAIN(TestFalconProgram)
#include "tst_falcon_program.moc"
