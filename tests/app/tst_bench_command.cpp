// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/Files.h"
#include "tests/support/Program.h"
#include "tests/support/Solids.h"

using support::Ending;
using support::runCusp;

class TestBenchCommand : public QObject
{
    Q_OBJECT

private slots:
    void keysAreForTools()
    {
        const Ending ending = runCusp({"bench", "volume", "--json"});
        expectDone(ending);
        const QJsonObject figures = ending.json();
        QCOMPARE(figures.keys(), (QStringList{"volume_box_error_percent", "volume_cone_error_percent",
                                              "volume_sphere_cap_error_percent", "volume_turned_box_error_percent",
                                              "volume_wedge_error_percent"}));
        for (const QString& key : figures.keys())
            QVERIFY2(std::abs(figures[key].toDouble()) < 0.5, qPrintable(key));
    }

    void everySuiteHasItsOwnFiles()
    {
        const QString out = m_folder.filePath("out");
        expectDone(runCusp({"bench", "volume", "--out", out}));
        expectDone(runCusp({"bench", "drilling", "--minutes", "0.02", "--out", out}));
        QCOMPARE(QDir(out).entryList(QDir::Files),
                 (QStringList{"bench-drilling.csv", "bench-drilling.json", "bench-volume.csv", "bench-volume.json"}));
        static const QRegularExpression snakeCase("^[a-z0-9]+(_[a-z0-9]+)*$");
        for (const char* suite : {"volume", "drilling"}) {
            QFile file(out + "/bench-" + suite + ".json");
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QJsonObject all = QJsonDocument::fromJson(file.readAll()).object();
            QCOMPARE(all["suite"].toString(), QString(suite));
            QVERIFY(!all["figures"].toArray().isEmpty());
            for (const QJsonValue& figure : all["figures"].toArray()) {
                const QString key = figure["key"].toString();
                QVERIFY2(snakeCase.match(key).hasMatch() && key.startsWith(suite), qPrintable(key));
            }
        }
    }

    void smoothnessNeedsNoScan()
    {
        qputenv("CUSP_SHARED_DATA", m_folder.path().toUtf8());
        const Ending ending = runCusp({"bench", "smoothness", "--json"});
        qunsetenv("CUSP_SHARED_DATA");
        expectDone(ending);
        QCOMPARE(ending.json().keys(), (QStringList{"smoothness_felt_p99_n", "smoothness_spring_p99_n"}));
        QVERIFY2(ending.error.contains("dundee_36"), ending.error);
    }

    void missedPeriodsAtFourKilohertzAreCounted()
    {
        const Ending ending = runCusp({"bench", "servo", "--minutes", "0.05", "--json"});
        expectDone(ending);
        const QJsonObject figures = ending.json();
        QVERIFY(figures.contains("servo_live_4000hz_missed"));
        QCOMPARE(figures["servo_4000hz_ticks"].toDouble(), 12000.0);
        QVERIFY2(figures["servo_4000hz_cutting_percent"].toDouble() > 50.0, ending.out);
        for (const char* hand : {"light", "medium", "firm"})
            for (const int rate : {1000, 2000, 4000})
                QVERIFY(figures[QString("servo_k_max_%1_%2hz_n_per_mm").arg(hand).arg(rate)].toDouble() > 2.0);
    }

    void meshesAreLoadedToo()
    {
        QFile file(m_folder.filePath("A scan, No. 1.obj"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(support::asObj(support::box(8.0F, 9.0F, 7.0F))));
        file.close();
        const Ending ending = runCusp({"bench", "load", "--mesh", file.fileName(), "--json"});
        expectDone(ending);
        QVERIFY2(ending.json()["load_a_scan_no_1_ms"].toDouble() > 0.0, ending.out);
        QVERIFY(ending.json()["load_generated_36_ms"].toDouble() > 0.0);
    }

    void badArgumentsAreRefused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* arguments, int code, const char* says = "") {
            QTest::newRow(arguments) << QString(arguments).split(' ') << code << QByteArray(says);
        };
        row("load --mesh /nowhere/a.obj", 1, "cusp: /nowhere/a.obj does not exist");
        row("load --mesh /", 1, "/ is not a file");
        row("everything", 2);
        row("", 2);
        row("volume --minutes soon", 2);
        row("volume --minutes 3", 2);
        row("volume --mesh /nowhere/a.obj", 2);
        row("volume --out ", 2);
        row("volume --out /proc/cusp", 1, "/proc/cusp");
        row("volume --out /etc/hostname/in", 1, "/etc/hostname/in");
    }

    void badArgumentsAreRefused()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, says);
        const Ending ending = runCusp(QStringList("bench") + arguments);
        QTEST(ending.exitCode, "code");
        QVERIFY2(ending.error.contains(says), ending.error);
    }

    void chartsShowWhatTheFiguresSay()
    {
        const QString out = m_folder.filePath("charts");
        const Ending ending = runCusp({"bench", "stiffness", "--out", out, "--json"});
        expectDone(ending);
        const QStringList names{"bench-stiffness.csv", "bench-stiffness.json", "bench-stiffness.png",
                                "bench-stiffness.svg"};
        QCOMPARE(QDir(out).entryList(QDir::Files), names);
        for (const QString& name : names)
            QVERIFY2(ending.error.contains(name.toUtf8()), ending.error);
        QCOMPARE(QImage(out + "/bench-stiffness.png").size(), QSize(1920, 1200));
        const auto contents = [&](const char* end) {
            return QByteArray::fromStdString(support::bytesOf((out + "/bench-stiffness." + end).toStdString()));
        };
        const QByteArray svg = contents("svg");
        const QByteArray csv = contents("csv");
        const QJsonObject all = QJsonDocument::fromJson(contents("json")).object();
        QCOMPARE(all["charts"].toArray(), (QJsonArray{"stiffness"}));
        for (const char* key : {"processor", "date", "version", "compiler", "build_type", "kernels"}) {
            QVERIFY2(!all[key].toString().isEmpty(), key);
            QVERIFY2(svg.contains(all[key].toString().toHtmlEscaped().toUtf8()), key);
        }
        const QJsonObject figures = ending.json();
        QVERIFY(figures.size() > 20);
        for (const QString& key : figures.keys())
            QVERIFY2(csv.contains(key.toUtf8() + ","), qPrintable(key));
    }

    void progressTellsHowFarItIs()
    {
        const Ending ending = runCusp({"bench", "load"});
        expectDone(ending);
        static const QRegularExpression line("^load: tooth 21 \\(1 of 3; 0:00 gone, about \\d+:\\d\\d left\\)\n");
        QVERIFY2(line.match(QString::fromUtf8(ending.error)).hasMatch(), ending.error);
    }

    void noDisplayIsNeeded()
    {
        // The command needs no display, even if Qt's settings name one that does not exist.
        for (const char* platform : {"QT_QPA_PLATFORM=xcb", "QT_QPA_PLATFORM=wayland", "DISPLAY=:4711"}) {
            const Ending ending = runCusp({"bench", "volume", "--json"}, {platform});
            QVERIFY2(ending.exitCode == 0 && !ending.json().isEmpty(), ending.error);
        }
    }

    void whatIsDoneSurvivesAnInterruption()
    {
        const QString out = m_folder.filePath("interrupted");
        QProcess cusp;
        cusp.start(CUSP_BINARY_DIR "/bin/cusp", {"bench", "--out", out});
        QByteArray told;
        const auto nextHasBegun = [&] {
            told += cusp.readAllStandardError();
            return told.contains("\nload: ");
        };
        QTRY_VERIFY_WITH_TIMEOUT(nextHasBegun(), 60'000);
        cusp.terminate();
        QVERIFY(cusp.waitForFinished());
        QVERIFY(cusp.exitStatus() == QProcess::CrashExit || cusp.exitCode() != 0);
        QFile file(out + "/bench-volume.json");
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(QJsonDocument::fromJson(file.readAll()).object()["figures"].toArray().size(), 5);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestBenchCommand)
#include "tst_bench_command.moc"
