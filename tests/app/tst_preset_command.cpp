// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "database/sql/Presets.h"
#include "lessons/PresetFile.h"
#include "lessons/PresetShelf.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Program.h"

using support::Ending;
using support::runCusp;

class TestPresetCommand : public QObject
{
    Q_OBJECT
private slots:
    void listsShowsAndChecks()
    {
        QTemporaryDir folder;
        lessons::PresetFolder shelf(folder.path());
        core::settings::FeelPreset mine;
        mine.name = "mine";
        mine.stiffnessNPerMm = 2.5;
        QVERIFY(shelf.save(mine));
        const QJsonArray listed =
            runCusp({"preset", "list", "--folder", folder.path(), "--json"}).json()["presets"].toArray();
        QCOMPARE(listed.size(), 3);
        QCOMPARE(listed[0].toObject()["name"].toString(), QString("mine"));
        QCOMPARE(listed[0].toObject()["shipped"].toBool(), false);
        QCOMPARE(listed[1].toObject()["shipped"].toBool(), true);
        const Ending text = runCusp({"preset", "list", "--folder", folder.path()});
        QVERIFY2(text.out.contains("mine v1 #"), text.out);
        const QJsonObject shown = runCusp({"preset", "show", "mine", "--folder", folder.path(), "--json"}).json();
        QCOMPARE(shown["force"].toObject()["stiffness_n_per_mm"].toDouble(), 2.5);
        QVERIFY(shown["bound_n_per_mm"].toDouble() > 2.5);
        QVERIFY(runCusp({"preset", "show", "natural"}).out.contains("enamel.rate_mm3_per_ns"));
        QVERIFY(runCusp({"preset", "show", "natural"}).out.contains("full_load_n"));

        const QString bad = folder.filePath("bad.json");
        QFile file(bad);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.write(R"({"force": {"stiffness_n_per_mm": 15}})") > 0);
        file.close();
        const Ending refused = runCusp({"preset", "check", bad});
        QCOMPARE(refused.exitCode, 1);
        QVERIFY2(refused.error.contains("the stiffness is 15 N/mm"), refused.error);
        const QJsonObject checked =
            runCusp({"preset", "check", bad, "--json"}).json()["presets"].toArray()[0].toObject();
        QCOMPARE(checked["sound"].toBool(), false);
        QCOMPARE(checked["faults"].toArray().size(), 1);
        // A value that the file leaves out is valid, and the output names it.
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(R"({"force": {"stiffness_n_per_mm": 1.5}})") > 0);
        file.close();
        const Ending sparse = runCusp({"preset", "check", bad});
        expectDone(sparse);
        QVERIFY2(sparse.out.contains("says nothing of ") && sparse.out.contains("pulp"), sparse.out);
    }

    void aSchoolsPresetsAreListed()
    {
        support::SchoolRig rig(false);
        rig.populate();
        core::settings::FeelPreset mine;
        mine.name = "mine";
        for (mine.version = 1; mine.version <= 2; ++mine.version) {
            mine.stiffnessNPerMm = 1.0 + 0.5 * mine.version;
            const auto hashed = lessons::hashed(mine);
            const QByteArray json = QJsonDocument(lessons::toJson(hashed)).toJson(QJsonDocument::Compact);
            VERIFY_DONE(database::sql::addPreset(rig.school(), rig.admin,
                                                 {hashed.name, hashed.version, hashed.hash, json.toStdString()}));
        }
        const auto listed = [&rig](const char* who) {
            return runCusp({"preset", "list", "--db", rig.address(), "--as", who, "--json"}, {}, "correct horse\n");
        };
        const auto inUse = [&] {
            QStringList names;
            for (const QJsonValue& one : listed("s1001").json()["presets"].toArray())
                if (one["in_use"].toBool())
                    names << one["name"].toString() + " v" + QString::number(one["version"].toInt());
            return names;
        };
        QCOMPARE(listed("s1001").json()["presets"].toArray().size(), 4);
        QCOMPARE(inUse(), QStringList{"natural v2"});
        VERIFY_DONE(database::sql::changeSetting(rig.school(), rig.admin, "preset.in_use", "mine v1"));
        QCOMPARE(inUse(), QStringList{"mine v1"});
        VERIFY_DONE(database::sql::changeSetting(rig.school(), rig.admin, "preset.retired", "natural"));
        const Ending text = runCusp({"preset", "list", "--db", rig.address(), "--as", "admin"}, {}, "correct horse\n");
        QVERIFY2(text.out.contains("(in use)") && text.out.count("(retired)") == 2, text.out);
        QCOMPARE(runCusp({"preset", "list", "--db", rig.address()}).exitCode, 2);
        QCOMPARE(runCusp({"preset", "list", "--db", rig.address(), "--as", "admin", "--folder", "x"}).exitCode, 2);
        expectRefusal(runCusp({"preset", "list", "--db", rig.address(), "--as", "admin"}, {}, "wrong\n"));
    }

    /// A version is written as an integer, not with an exponent.
    void wholeNumbersAreWrittenOut()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath("far.json"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(R"({"version": 20000000})") > 0);
        file.close();
        const Ending far = runCusp({"preset", "check", file.fileName()});
        QVERIFY2(far.error.contains("is 20000000, it must lie between 1 and 1000000"), far.error);
    }

    void wrongUsageIsExplained()
    {
        for (const QStringList& arguments :
             {QStringList{"preset"}, {"preset", "paint"}, {"preset", "check"}, {"preset", "show"}}) {
            expectRefusal(runCusp(arguments), {}, 2);
        }
        const Ending unknown = runCusp({"preset", "show", "nobody's"});
        QCOMPARE(unknown.exitCode, 1);
        QVERIFY2(unknown.error.contains("natural"), unknown.error);
        QVERIFY(runCusp({"preset", "--help"}).out.contains("cusp preset check"));
    }
};

QTEST_GUILESS_MAIN(TestPresetCommand)
#include "tst_preset_command.moc"
