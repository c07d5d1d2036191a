// SPDX-License-Identifier: GPL-3.0-or-later
// The emulated Falcon in a program that is linked with the real libusb.
#include <QFile>
#include <QMap>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace {

/// The folder of the emulator, and the programs that run with it.
class Station
{
public:
    void command(const QByteArray& lines)
    {
        QFile file(m_folder.filePath("command"));
        if (file.open(QIODevice::Append))
            file.write(lines);
    }
    /// Returns the values by their names; empty if there are none yet.
    [[nodiscard]] QMap<QByteArray, QByteArray> state() const
    {
        QFile file(m_folder.filePath("state"));
        QMap<QByteArray, QByteArray> values;
        if (file.open(QIODevice::ReadOnly))
            for (const QByteArray& line : file.readAll().split('\n'))
                if (const auto space = line.indexOf(' '); space > 0)
                    values[line.left(space)] = line.mid(space + 1);
        return values.value("begin") == values.value("end") ? values : QMap<QByteArray, QByteArray>();
    }
    [[nodiscard]] QByteArray unknown() const
    {
        QFile file(m_folder.filePath("unknown"));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void start(QProcess& program) const
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("LD_PRELOAD", CUSP_BINARY_DIR "/tests/libemulated_falcon.so");
        environment.insert("CUSP_EMULATED_FALCON", m_folder.path());
        program.setProcessEnvironment(environment);
        program.start(CUSP_BINARY_DIR "/tests/usb_program", {});
    }
    /// Starts a program and returns the first line of its output.
    [[nodiscard]] QByteArray firstLineOf(QProcess& program) const
    {
        start(program);
        while (!program.canReadLine() && program.waitForReadyRead()) {
        }
        return program.readLine().trimmed();
    }

private:
    QTemporaryDir m_folder;
};

void kill(QProcess& program)
{
    program.kill();
    program.waitForFinished();
}

}  // namespace

class TestPreloadedFalcon : public QObject
{
    Q_OBJECT
private slots:
    void anEmptyFileIsAnEmptyBus()
    {
        Station station;
        QProcess program;
        QCOMPARE(station.firstLineOf(program), "list LIBUSB_ERROR_NOT_FOUND");
        program.waitForFinished();
    }

    void whatWasSentLastIsReadAfterAKill()
    {
        Station station;
        station.command("plug F1\nfirmware\n");
        QProcess program;
        QCOMPARE(station.firstLineOf(program), "answer 16");
        kill(program);
        const auto state = station.state();
        QCOMPARE(state["serial"], "F1");
        QCOMPARE(state["firmware"], "1");
        QCOMPARE(state["requests"], "1");
        QCOMPARE(state["motors"], "5 6 7");
        QCOMPARE(state["leds"], "0 0 1");
        QVERIFY(state["nonzero_ms_ago"].toLong() >= 0);
        QCOMPARE(state["nonzero_ms"], state["request_ms"]);
    }

    void commandsAreObeyedWhileTheProgramRuns()
    {
        Station station;
        station.command("plug F1 fast\nhand none\nfirmware\n");
        QProcess program;
        QCOMPARE(station.firstLineOf(program), "answer 16");
        station.command("grip 10 0 130\n");
        QTRY_COMPARE(station.state()["grip"], "10.000 0.000 130.000");
        station.command("tip 1 2 3 0.05\n");
        QTRY_COMPARE(station.state()["tip"], "1.000 2.000 3.000");
        station.command("press plus\nmains off\n# a remark\n\nnonsense\npress nothing\nboot zero stray try 3 echo 5\n");
        QTRY_COMPARE(station.state()["mains"], "0");
        station.command("power off\n");
        QTRY_COMPARE(station.state()["firmware"], "0");
        station.command("unplug\n");
        QTRY_COMPARE(station.state()["plugged"], "0");
        station.command("plug F1\n");
        QTRY_COMPARE(station.state()["plugged"], "1");
        QCOMPARE(station.unknown(), "nonsense\npress nothing\n");
        kill(program);
    }

    void refusals_data()
    {
        QTest::addColumn<QByteArray>("commands");
        QTest::addColumn<QByteArray>("line");
        QTest::newRow("no USB") << QByteArray("usb off\n") << QByteArray("init LIBUSB_ERROR_OTHER");
        QTest::newRow("no permission") << QByteArray("plug F\ndeny\n") << QByteArray("open LIBUSB_ERROR_ACCESS");
        QTest::newRow("busy") << QByteArray("plug F\nbusy\n") << QByteArray("claim LIBUSB_ERROR_BUSY");
        QTest::newRow("vanishes") << QByteArray("plug F\nat claim 1 unplug\n")
                                  << QByteArray("claim LIBUSB_ERROR_NO_DEVICE");
    }
    void refusals()
    {
        QFETCH(QByteArray, commands);
        QFETCH(QByteArray, line);
        Station station;
        station.command(commands);
        QProcess program;
        QCOMPARE(station.firstLineOf(program), line);
        program.waitForFinished();
    }

    void aSecondProgramFindsItBusy()
    {
        Station station;
        station.command("plug F\nfirmware\n");
        QProcess first;
        QCOMPARE(station.firstLineOf(first), "answer 16");
        QProcess second;
        QCOMPARE(station.firstLineOf(second), "claim LIBUSB_ERROR_BUSY");
        second.waitForFinished();
        kill(first);
        QProcess third;
        QCOMPARE(station.firstLineOf(third), "answer 16");
        kill(third);
    }
};

QTEST_GUILESS_MAIN(TestPreloadedFalcon)
#include "tst_preloaded_falcon.moc"
