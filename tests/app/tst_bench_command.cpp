// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/Program.h"
#include "tests/support/Solids.h"

using support::Ending;
using support::runCusp;

class TestBenchCommand : public QObject
{
    Q_OBJECT

private slots:
    void keysAreForTools();
    void everySuiteHasItsOwnFiles();
    void meshesAreLoadedToo();
    void badMeshesAndSuitesAreRefused();

private:
    QTemporaryDir m_folder;
};

void TestBenchCommand::keysAreForTools()
{
    const Ending ending = runCusp({"bench", "volume", "--json"});
    QVERIFY2(ending.exitCode == 0, ending.error);
    const QJsonObject figures = ending.json();
    QCOMPARE(figures.keys(),
             (QStringList{"volume_box_error_percent", "volume_cone_error_percent", "volume_sphere_cap_error_percent",
                          "volume_turned_box_error_percent", "volume_wedge_error_percent"}));
    for (const QString& key : figures.keys())
        QVERIFY2(std::abs(figures[key].toDouble()) < 0.5, qPrintable(key));
}

void TestBenchCommand::everySuiteHasItsOwnFiles()
{
    const QString out = m_folder.filePath("out");
    QCOMPARE(runCusp({"bench", "volume", "--out", out}).exitCode, 0);
    QCOMPARE(runCusp({"bench", "drilling", "--minutes", "0.02", "--out", out}).exitCode, 0);
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

void TestBenchCommand::meshesAreLoadedToo()
{
    QFile file(m_folder.filePath("A scan, No. 1.obj"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(support::asObj(support::box(8.0F, 9.0F, 7.0F))));
    file.close();
    const Ending ending = runCusp({"bench", "load", "--mesh", file.fileName(), "--json"});
    QVERIFY2(ending.exitCode == 0, ending.error);
    QVERIFY2(ending.json()["load_a_scan_no_1_ms"].toDouble() > 0.0, ending.out);
    QVERIFY(ending.json()["load_generated_36_ms"].toDouble() > 0.0);
}

void TestBenchCommand::badMeshesAndSuitesAreRefused()
{
    const Ending missing = runCusp({"bench", "load", "--mesh", "/nowhere/a.obj"});
    QCOMPARE(missing.exitCode, 1);
    QVERIFY2(missing.error.contains("cusp: /nowhere/a.obj does not exist"), missing.error);
    QCOMPARE(runCusp({"bench", "everything"}).exitCode, 2);
    QCOMPARE(runCusp({"bench", "volume", "--minutes", "soon"}).exitCode, 2);
}

QTEST_GUILESS_MAIN(TestBenchCommand)
#include "tst_bench_command.moc"
