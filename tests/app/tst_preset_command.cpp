// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include "lessons/PresetShelf.h"
#include "tests/support/Program.h"

using support::Ending;
using support::runCusp;

class TestPresetCommand : public QObject
{
    Q_OBJECT
private slots:
    void listsShowsAndChecks();
    void wrongUsageIsExplained();
};

void TestPresetCommand::listsShowsAndChecks()
{
    QTemporaryDir folder;
    lessons::PresetFolder shelf(folder.path());
    core::settings::FeelPreset mine;
    mine.name = "mine";
    mine.stiffnessNPerMm = 2.5;
    QVERIFY(shelf.save(mine));
    const QJsonArray listed =
        runCusp({"preset", "list", "--folder", folder.path(), "--json"}).json()["presets"].toArray();
    QCOMPARE(listed.size(), 2);
    QCOMPARE(listed[0].toObject()["name"].toString(), QString("mine"));
    QCOMPARE(listed[0].toObject()["shipped"].toBool(), false);
    QCOMPARE(listed[1].toObject()["shipped"].toBool(), true);
    const Ending text = runCusp({"preset", "list", "--folder", folder.path()});
    QVERIFY2(text.out.contains("mine v1 #"), text.out);
    const QJsonObject shown = runCusp({"preset", "show", "mine", "--folder", folder.path(), "--json"}).json();
    QCOMPARE(shown["force"].toObject()["stiffness_n_per_mm"].toDouble(), 2.5);
    QVERIFY(shown["bound_n_per_mm"].toDouble() > 2.5);
    QVERIFY(runCusp({"preset", "show", "natural"}).out.contains("enamel.rate_mm3_per_ns"));

    const QString bad = folder.filePath("bad.json");
    QFile file(bad);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(file.write(R"({"force": {"stiffness_n_per_mm": 15}})") > 0);
    file.close();
    const Ending refused = runCusp({"preset", "check", bad});
    QCOMPARE(refused.exitCode, 1);
    QVERIFY2(refused.error.contains("the stiffness is 15 N/mm"), refused.error);
    const QJsonObject checked = runCusp({"preset", "check", bad, "--json"}).json()["presets"].toArray()[0].toObject();
    QCOMPARE(checked["sound"].toBool(), false);
    QCOMPARE(checked["faults"].toArray().size(), 1);
    // What is not in the file is sound, and told.
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(R"({"force": {"stiffness_n_per_mm": 1.5}})") > 0);
    file.close();
    const Ending sparse = runCusp({"preset", "check", bad});
    QCOMPARE(sparse.exitCode, 0);
    QVERIFY2(sparse.out.contains("says nothing of ") && sparse.out.contains("pulp"), sparse.out);
}

void TestPresetCommand::wrongUsageIsExplained()
{
    for (const QStringList& arguments :
         {QStringList{"preset"}, {"preset", "paint"}, {"preset", "check"}, {"preset", "show"}}) {
        const Ending ending = runCusp(arguments);
        QCOMPARE(ending.exitCode, 2);
        QVERIFY2(ending.isOneSentence(), ending.error);
    }
    const Ending unknown = runCusp({"preset", "show", "nobody's"});
    QCOMPARE(unknown.exitCode, 1);
    QVERIFY2(unknown.error.contains("there are"), unknown.error);
    QVERIFY(runCusp({"preset", "--help"}).out.contains("cusp preset check"));
}

QTEST_GUILESS_MAIN(TestPresetCommand)
#include "tst_preset_command.moc"
