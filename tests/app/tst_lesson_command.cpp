// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/Files.h"
#include "tests/support/Program.h"

using support::Ending;
using support::runCusp;

/// Runs the subcommands of `cusp lesson` that write files, as a teacher does.
class TestLessonCommand : public QObject
{
    Q_OBJECT

private slots:
    void init() { m_folder.emplace(); }

    void whatIsBegunCanBeGiven_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("nothing said") << QStringList{};
        QTest::newRow("decay on 24") << QStringList{"--tooth", "24", "--task", "remove_decay", "--seed", "3"};
        QTest::newRow("a Class I on 26") << QStringList{"--tooth", "26", "--task", "cut_ideal"};
        QTest::newRow("an access on 21") << QStringList{"--tooth", "21", "--task", "cut_ideal"};
        QTest::newRow("a block") << QStringList{"--tooth", "block:cross"};
        QTest::newRow("from a shipped one") << QStringList{"--from", "class1-36", "--title", "Mine"};
        QTest::newRow("from a shipped one, on another tooth") << QStringList{"--from", "class1-36", "--tooth", "37"};
    }

    void whatIsBegunCanBeGiven()
    {
        QFETCH(QStringList, options);
        const QString out = file("mine.lesson.json");
        expectDone(runCusp(QStringList{"lesson", "new", "--id", "mine", "--out", out} + options));
        const QJsonObject lesson = checkedLesson(out);
        QCOMPARE(lesson["id"].toString(), QString("mine"));
        QCOMPARE(lesson["faults"].toArray(), QJsonArray());
    }

    void anExpertAtAnotherToothIsNoted()
    {
        QVERIFY(QFile::copy(golden(), file("expert.cusprec")));
        const QString lesson = written("mine.lesson.json", R"({"format": 1, "id": "mine",
            "based_on": "ideal-1-class1-1-36.lesson.json", "expert": {"recording": "expert.cusprec"}})");
        const QJsonArray faults = checkedLesson(lesson)["faults"].toArray();
        QCOMPARE(faults.size(), 1);
        const QJsonObject fault = faults[0].toObject();
        QCOMPARE(fault["key"].toString(), QString("expert.recording"));
        QVERIFY2(fault["what"].toString().startsWith("expert.cusprec: the attempt is at the tooth"),
                 qPrintable(fault["what"].toString()));
        QVERIFY(!fault["grave"].toBool());
        const Ending told = runCusp({"lesson", "check", lesson});
        QVERIFY2(told.out.contains("mine.lesson.json, expert.recording: expert.cusprec"), told.out.constData());
        QVERIFY(told.out.contains("is sound"));
        // A lesson can be named by its id as well as by its file. A name that is neither gives one more line in the
        // output and does not end the command.
        const Ending named = runCusp({"lesson", "check", "class1-99", "block-line", "--json"});
        QCOMPARE(named.exitCode, 1);
        const QJsonArray both = named.json()["lessons"].toArray();
        QCOMPARE(both.size(), 2);
        QVERIFY(!both[0].toObject()["sound"].toBool() && both[1].toObject()["sound"].toBool());
        QCOMPARE(both[1].toObject()["id"].toString(), QString("block-line"));
    }

    void aCapturedIdealGoesIntoALesson()
    {
        const Ending captured =
            runCusp({"lesson", "capture", "--out", file("own.cuspideal"), golden(), "--outline", "0.4", "--json"});
        expectDone(captured);
        QCOMPARE(captured.json()["outline_mm"].toDouble(), 0.4);
        QCOMPARE(captured.json()["sources"].toArray().size(), 1);
        QVERIFY(captured.json()["columns"].toInt() > 10);
        // The lesson has no way to name that tooth. The command says so and writes nothing.
        const QString out = file("mine.lesson.json");
        expectRefusal(runCusp({"lesson", "new", "--id", "mine", "--from", "class1-36", "--captured",
                               file("own.cuspideal"), "--out", out}),
                      "ideal.captured: \"own.cuspideal\" was captured on the tooth");
        QVERIFY(!QFileInfo::exists(out));

        // An ideal captured on a tooth of the program makes a lesson on that tooth, whether or not the tooth is given.
        // The tolerances are taken over.
        const QString work = file("work");
        QVERIFY(runCusp({"demo", "--lesson", "class1-24", "--out", work}).exitCode != 2);
        expectDone(runCusp(
            {"lesson", "capture", "--out", file("cut.cuspideal"), work + "/attempt.cusprec", "--depth", "0.33"}));
        const QStringList begin{"lesson", "new", "--id", "mine", "--captured", file("cut.cuspideal"), "--out", out};
        expectDone(runCusp(begin + QStringList{"--tooth", "24"}));
        const std::string json = support::bytesOf(out.toStdString());
        const QJsonObject made = QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
        QCOMPARE(made["task"].toString(), QString("cut_ideal"));
        const QJsonObject depth = made["rubric"].toObject()["criteria"].toArray()[0].toObject();
        QCOMPARE(depth["measure"].toString(), QString("depth_error_p95_mm"));
        QCOMPARE(depth["tolerance"].toDouble(), 0.33);
        QCOMPARE(checkedLesson(out)["faults"].toArray(), QJsonArray());
        QVERIFY(QFile::remove(out));
        for (const QStringList& otherwise :
             {QStringList{"--tooth", "24", "--task", "remove_decay"}, QStringList{"--from", "decay-24-small"}}) {
            expectRefusal(runCusp(begin + otherwise), "cut_ideal");
            QVERIFY(!QFileInfo::exists(out));
        }
    }

    void aScanGoesIntoALesson()
    {
        // Any mesh of a tooth serves as a scan.
        const QString scan = file("tooth.obj");
        expectDone(runCusp({"tooth", "36", "--export", scan}));
        const QString out = file("course/scan.lesson.json");
        QVERIFY(QDir(m_folder->path()).mkdir("course"));
        const QStringList begin{"lesson", "new", "--id", "scan", "--tooth", scan, "--out", out};
        expectDone(runCusp(begin + QStringList{"--unit", "mm", "--up", "+z", "--fdi", "36"}));
        QCOMPARE(checkedLesson(out)["tooth"].toString(), QString("tooth.obj"));
        // An unusable scan is not copied next to the lesson.
        const QString noise = written("noise.stl", "hello");
        expectRefusal(runCusp({"lesson", "new", "--id", "a", "--tooth", noise, "--out", file("course/a.lesson.json")}));
        QVERIFY(!QFileInfo::exists(file("course/noise.stl")) && !QFileInfo::exists(file("course/a.lesson.json")));
        // If the scan is damaged later, the check names its key.
        written("course/tooth.obj", "hello");
        const Ending told = runCusp({"lesson", "check", out});
        QVERIFY2(told.exitCode == 1 && told.error.contains("scan.lesson.json tooth.scan: "), told.error.constData());
    }

    void checkSaysWhatCannotBeEarned()
    {
        const auto told = [&](const std::string& content) {
            const Ending ending = runCusp({"lesson", "check", written("a.lesson.json", content)});
            expectDone(ending);
            return ending.out;
        };
        const QByteArray noted = told(R"({"format": 1, "based_on": "block-1-line.lesson.json", "id": "odd",
            "rubric": {"id": "odd", "title": "Odd", "criteria": [
                {"id": "target", "measure": "target_removed_percent", "side": "under", "target": 100, "weight": 60},
                {"id": "decay", "measure": "caries_left_percent", "weight": 40}]}})");
        QVERIFY2(noted.contains("gets 60.0 of 100 points, because of decay (cannot be measured here)"), noted);
        // Decay is measured here. A criterion about the course of an attempt cannot be measured beforehand.
        const QByteArray held = told(R"({"format": 1, "based_on": "decay-36-1-small.lesson.json", "id": "held",
            "rubric": {"id": "held", "title": "Held", "criteria": [
                {"id": "left", "measure": "caries_left_percent", "weight": 50},
                {"id": "start", "measure": "time_to_first_cut_s", "tolerance": 60, "weight": 20},
                {"id": "hold", "measure": "hold_longest_s", "side": "under", "target": 5, "weight": 30}]}})");
        QVERIFY2(held.contains("gets 70.0 of 100 points, because of hold (cannot be measured here)"), held);
        // The expert's recording cannot be replayed. The lesson stays usable without it, and the check warns the
        // teacher.
        written("expert.cusprec", "CUSPREC");
        const QByteArray led = told(R"({"format": 1, "based_on": "block-1-line.lesson.json", "id": "led",
            "expert": {"recording": "expert.cusprec"}})");
        QVERIFY2(led.contains("a.lesson.json, expert.recording: ") && led.contains("is not a Cusp recording"), led);
    }

    void captureRefusesWithASentence()
    {
        const QString out = file("own.cuspideal");
        const QString noise = written("noise.cusprec", "hello");
        for (const QStringList& recordings : {QStringList{file("none.cusprec")}, QStringList{golden(), noise}}) {
            expectRefusal(runCusp(QStringList{"lesson", "capture", "--out", out} + recordings), "cusprec");
        }
        QVERIFY(QFile::copy(golden(), file("again.cusprec")));
        expectRefusal(runCusp({"lesson", "capture", "--out", out, golden(), file("again.cusprec")}), "once more");
        expectRefusal(runCusp({"lesson", "capture", "--out", out, golden(), "--depth", "-1"}),
                      "tolerance of the depth");
        QVERIFY(!QFileInfo::exists(out));
    }

    void overwritesNothing()
    {
        for (const char* name : {"a.lesson.json", "a.cuspideal", "a.cusplessons"})
            written(name, "mine");
        for (const QStringList& command :
             {QStringList{"new", "--id", "a", "--out", file("a.lesson.json")},
              QStringList{"capture", golden(), "--out", file("a.cuspideal")},
              QStringList{"pack", file("a.lesson.json"), "--out", file("a.cusplessons")}}) {
            expectRefusal(runCusp(QStringList{"lesson"} + command), "is not overwritten");
        }
    }

    void wrongUsage_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("no id") << QStringList{"new", "--out", "x.lesson.json"};
        QTest::newRow("a task unheard of") << QStringList{"new", "--id", "a", "--task", "polish"};
        QTest::newRow("a tooth in words") << QStringList{"new", "--id", "a", "--tooth", "molar"};
        QTest::newRow("another suffix") << QStringList{"new", "--id", "a", "--out", "a.txt"};
        QTest::newRow("nothing to pack") << QStringList{"pack", "--out", "a.cusplessons"};
        QTest::newRow("no pack named") << QStringList{"unpack"};
        QTest::newRow("no recording") << QStringList{"capture", "--out", "a.cuspideal"};
        QTest::newRow("a tolerance in words")
            << QStringList{"capture", "--out", "a.cuspideal", "a.cusprec", "--depth", "x"};
        QTest::newRow("no picture named") << QStringList{"preview", "a.lesson.json"};
        QTest::newRow("a picture too small")
            << QStringList{"preview", "a.lesson.json", "--out", "a.png", "--size", "100x100"};
    }

    void wrongUsage()
    {
        QFETCH(QStringList, arguments);
        expectRefusal(runCusp(QStringList{"lesson"} + arguments), {}, 2);
    }

    void aPackGoesThere()
    {
        const QString lesson = file("mine.lesson.json");
        expectDone(runCusp({"lesson", "new", "--id", "mine", "--from", "class1-36", "--out", lesson}));
        const QString pack = file("course.cusplessons");
        const Ending packed = runCusp({"lesson", "pack", lesson, "--out", pack});
        expectDone(packed);
        QVERIFY(packed.out.contains("mine.lesson.json"));
        expectDone(runCusp({"lesson", "unpack", pack, "--folder", file("theirs")}));
        expectDone(runCusp({"lesson", "check", file("theirs/mine.lesson.json")}));
        // The pack is also found without being unpacked, if it is in a folder that is searched for packs.
        const Ending listed =
            runCusp({"lesson", "list", "--folder", m_folder->path(), "--json"}, {"XDG_CACHE_HOME=" + file("cache")});
        bool offered = false;
        for (const QJsonValue entry : listed.json()["lessons"].toArray())
            offered = offered || entry.toObject()["id"].toString() == "mine";
        QVERIFY(offered);
        // A damaged pack is refused, and nothing is written.
        QFile damaged(pack);
        QVERIFY(damaged.resize(damaged.size() / 2));
        expectRefusal(runCusp({"lesson", "unpack", pack, "--folder", file("nobody")}), "course.cusplessons");
        QVERIFY(!QFileInfo::exists(file("nobody")));
    }

    void drawsWhatALessonAsksFor()
    {
        const QString lesson = file("mine.lesson.json");
        expectDone(runCusp({"lesson", "new", "--id", "mine", "--from", "class1-36", "--out", lesson}));
        const Ending drawn = runCusp({"lesson", "preview", lesson, "--out", file("a.png"), "--size", "1000x700"});
        expectDone(drawn);
        QCOMPARE(QImage(file("a.png")).size(), QSize(1000, 700));
        QVERIFY(drawn.out.isEmpty());
        const QString faulty = written("faulty.lesson.json", "{\"format\": 1}");
        expectRefusal(runCusp({"lesson", "preview", faulty, "--out", file("b.png")}));
        QVERIFY(!QFileInfo::exists(file("b.png")));
    }

private:
    QString file(const QString& name) const { return m_folder->filePath(name); }
    QString written(const QString& name, const std::string& content) const
    {
        support::write(file(name), content);
        return file(name);
    }
    /// Returns the output of the command for a valid lesson.
    static QJsonObject checkedLesson(const QString& lesson)
    {
        const Ending ending = runCusp({"lesson", "check", lesson, "--json"});
        expectDone(ending);
        return ending.json()["lessons"].toArray()[0].toObject();
    }
    static QString golden() { return QStringLiteral(CUSP_SOURCE_DIR "/tests/golden/attempt.cusprec"); }

    std::optional<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(TestLessonCommand)
#include "tst_lesson_command.moc"
