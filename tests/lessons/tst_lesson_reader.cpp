// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QStringConverter>
#include <QTest>

#include "core/teeth/LesionSite.h"
#include "core/terrain/Lying.h"
#include "lessons/Assignment.h"
#include "lessons/LessonCatalog.h"
#include "lessons/RubricReader.h"
#include "tests/lessons/LessonFolder.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

using namespace lessons;
using support::isSound;
using support::says;
using support::sentencesOf;

class TestLessonReader : public QObject
{
    Q_OBJECT

private slots:
    void init() { m_folder.emplace(); }

    void readsEveryKey()
    {
        QJsonObject object = lesson();
        object["version"] = 3;
        object["course"] = QJsonObject{{"en", "First year"}, {"de", "Erstes Jahr"}};
        object["not_modelled"] = "Undercuts.";
        object["grid"] = 200;
        object["ideal"] = QJsonObject{{"kind", "class1"}, {"sizes", QJsonObject{{"depth_mm", 1.75}}}};
        object["leeway"] = QJsonObject{{"sides_mm", 0.2}, {"bottom_mm", 0.4}};
        object["touch"] =
            QJsonObject{{"points", QJsonArray{QJsonArray{1.5, -2}, QJsonArray{0, 0.25}}}, {"reach_mm", 0.4}};
        object["hold"] = QJsonObject{{"force_n", 1.5}, {"within_n", 0.1}, {"seconds", 5}};
        object["burs"] = QJsonArray{"330", "2"};
        object["handpieces"] = QJsonArray{"low-speed", "turbine"};
        object["hardness"] = QJsonObject{{"name", "soft"},
                                         {"like", "typodont"},
                                         {"dentin", QJsonObject{{"rate_mm3_per_ns", 4.0}, {"threshold_n", 0.2}}},
                                         {"axial_share", 0.5}};
        object["breaks_off"] = true;
        object["aids"] = QJsonArray{"section", "mirror", "fixture"};
        object["steps"] = QJsonArray{QJsonObject{{"text", "Look."}, {"hint", "Closer."}, {"mark", "distal_pit"}}};
        object["minutes"] = 12.5;
        object["exam"] = true;
        object["rules"] = QJsonObject{{"pulp_exposed", false}, {"perforated", false},   {"neighbour_hit", true},
                                      {"depth_limit_mm", 2.5}, {"ridge_limit_mm", 1.2}, {"beside_mm", 0.5},
                                      {"force_limit_n", 3.0},  {"air_limit_s", 30}};
        const ReadLesson read = m_folder->read("try.lesson.json", object);
        QVERIFY(isSound(read));
        const Lesson& got = *read.lesson;
        QCOMPARE(got.id, std::string("try-36"));
        QCOMPARE(got.version, 3);
        QCOMPARE(inLanguage(got.title, "de_AT"), std::string("Versuch"));
        QCOMPARE(inLanguage(got.title, "ja"), std::string("Try"));
        QCOMPARE(inLanguage(got.goal, "de"), std::string("Take the decay out."));
        QCOMPARE(inLanguage(got.course, "de"), std::string("Erstes Jahr"));
        QCOMPARE(std::get<MadeTooth>(got.tooth), (MadeTooth{36, 7, {}}));
        QCOMPARE(got.gridSide, 200);
        QCOMPARE(got.lesion->extent, 0.5);
        QCOMPARE(got.ideal->sizes.at("depth_mm"), 1.75);
        QCOMPARE(*got.leeway, (LeewayZone{0.2, 0.4}));
        QCOMPARE(*got.touch, (core::grading::PointsToTouch{{{1.5, -2.0}, {0.0, 0.25}}, 0.4}));
        QCOMPARE(*got.hold, (core::grading::ForceToHold{1.5, 0.1, 5.0}));
        QCOMPARE(got.burs, (std::vector<std::string>{"330", "2"}));
        QVERIFY(got.aids.section && got.aids.mirror && !got.aids.radiograph && !got.aids.ideal && got.aids.fixture &&
                !got.aids.burColour);
        QCOMPARE(got.handpieces.size(), 2U);
        QCOMPARE(got.handpieces[0], core::settings::findHandpiece("low-speed").value());
        core::settings::HardnessPreset soft = core::settings::findHardnessPreset("typodont").value();
        soft.name = "soft";
        soft.material[2] = {4.0, 0.2};
        soft = core::settings::withoutEndsAndFullLoad(soft);  // the effect of a lesson that gives only one share
        soft.axialShare = 0.5;
        QVERIFY(got.hardness == soft);
        QVERIFY(got.breakOff);
        QCOMPARE(inLanguage(got.steps.at(0).hint, "en"), std::string("Closer."));
        QCOMPARE(got.steps.at(0).mark, core::guidance::Landmark::DistalPit);
        QCOMPARE(got.minutes, 12.5);
        QVERIFY(got.exam);
        QCOMPARE(got.rules, (Rules{false, false, true, 2.5, 1.2, 0.5, 3.0, 30.0}));
        QCOMPARE(got.rubric.id, std::string("decay_removal"));
        QCOMPARE(got.rubric.hash.size(), std::size_t{64});
    }

    void everyShippedLessonIsSoundAndHasItsDecay()
    {
        int decays = 0;
        for (const CatalogEntry& entry : readCatalog({})) {
            QVERIFY(isSound(entry.read));
            const Lesson& shipped = *entry.read.lesson;
            for (const LocalText* text : {&shipped.title, &shipped.goal})
                for (const char* language : {"en", "de", "es", "ja"})
                    QVERIFY2(text->contains(language), shipped.id.c_str());
            if (shipped.task != Task::RemoveDecay)
                continue;
            if (!support::isTried(decays++))
                continue;
            Lesson coarse = shipped;
            coarse.gridSide = 100;
            const auto assigned = assign(coarse);
            QVERIFY(support::succeeds(assigned));
            const double decayMm3 = assigned->report.layersMm3[0];
            QVERIFY2(decayMm3 > 0.1, qPrintable(QStringLiteral("%1: %2 mm3").arg(shipped.id.c_str()).arg(decayMm3)));
        }
        QVERIFY(decays > 0);
    }

    /// An exam is marked like the practice lesson, with a time limit and without aids, steps or hints.
    void shippedExamsAllowNoAid()
    {
        QStringList exams;
        for (const CatalogEntry& entry : readCatalog({})) {
            if (!entry.read.lesson->exam)
                continue;
            const Lesson& exam = *entry.read.lesson;
            exams << QString::fromStdString(exam.id + ' ' + exam.rubric.id);
            QVERIFY2(exam.aids == Aids::none(), exam.id.c_str());
            QVERIFY2(exam.steps.empty() && exam.minutes > 0.0 && !exam.expert, exam.id.c_str());
            QVERIFY2(inLanguage(exam.title, "en").starts_with("Exam: "), exam.id.c_str());
        }
        QCOMPARE(exams, (QStringList{"exam-36-decay decay_removal", "exam-26-decay decay_removal",
                                     "exam-36-class1 class1", "exam-36-class2 class2"}));
    }

    /// A lesson can set on which side its tooth lies. Some of the other settings are then not allowed.
    void aToothLiesAsTheLessonSays()
    {
        QJsonObject object{
            {"format", 1}, {"id", "class5"}, {"title", "Class V"}, {"goal", "g"}, {"task", "remove_decay"}};
        object["rubric"] = "decay_removal";
        object["tooth"] = QJsonObject{{"fdi", 33}, {"seed", 2}, {"lies", "buccal"}, {"tilt_deg", 80}};
        object["lesion"] = QJsonObject{{"extent", 0.5}, {"site", "cervical"}};
        const ReadLesson read = m_folder->read("laid.lesson.json", object);
        QVERIFY(isSound(read));
        const auto made = std::get<MadeTooth>(read.lesson->tooth);
        QCOMPARE(made.lying, (core::terrain::Lying{core::terrain::ToothSide::MinusY, 80.0}));
        QCOMPARE(read.lesson->lesion->site, core::teeth::LesionSite::Cervical);
        object["rules"] = QJsonObject{{"neighbour_hit", true}, {"ridge_limit_mm", 1.0}};
        const ReadLesson ruled = m_folder->read("laid.lesson.json", object);
        QVERIFY(!ruled.lesson);
        QCOMPARE(ruled.faults.size(), std::size_t{2});
        object["rules"] = QJsonObject();
        object["task"] = "cut_ideal";
        object["ideal"] = QJsonObject{{"kind", "access"}};
        QVERIFY(!m_folder->read("laid.lesson.json", object).lesson);
        object["tooth"] = QJsonObject{{"fdi", 21}, {"lies", "lingual"}};
        object["lesion"] = QJsonObject{{"extent", 0.0}};
        QVERIFY(isSound(m_folder->read("laid.lesson.json", object)));
    }

    void tellsEachFaultByFileAndKey_data()
    {
        support::columns<QString, QByteArray, QString>("key", "value", "words");
        const auto row = [](const char* name, const char* key, const char* value, const char* words) {
            QTest::newRow(name) << QString(key) << QByteArray(value) << QString(words);
        };
        row("no format", "format", "null", "format: is missing");
        row("a newer format", "format", "2", "newer Cusp");
        row("format in words", "format", "\"1\"", "format: is a text");
        row("no title", "title", "null", "title: is missing");
        row("title a number", "title", "3", "title: is a number");
        row("title in no language", "title", "{}", "title: has texts in 0 languages");
        row("an odd id", "id", "\"Try 36\"", "id: may hold small letters");
        row("no id", "id", "null", "id: is missing");
        row("an unknown task", "task", "\"remove\"", "task: \"remove\" is not known; there are remove_decay");
        row("a tooth that does not exist", "tooth", "{\"fdi\": 39}", "tooth.fdi: there is no tooth 39");
        row("a tooth of the right", "tooth", "{\"fdi\": 46}", "tooth.fdi: there is no tooth 46");
        row("a tooth beyond counting", "tooth", "{\"fdi\": 1e300}", "tooth.fdi: is 1e+300");
        row("half a tooth", "tooth", "{\"fdi\": 36.5}", "tooth.fdi: is 36.5, it must be a whole number");
        row("a base that is no name", "based_on", "7", "based_on: must be the name of a file");
        const QByteArray endless = '"' + QByteArray("𠮷").repeated(4001) + '"';
        row("a title of rare kanji without end", "title", endless.constData(), "title: has 4001 characters");
        row("a title of nothing", "title", "\"\"", "title: has 0 characters");
        row("a block's size with its unit", "tooth", R"({"block": "line", "sizes": {"depth_mm": "2 mm"}})",
            "tooth.sizes.depth_mm: is a text; write a number of mm without its unit");
        row("a depth of the ideal in micrometres", "ideal", R"({"kind": "class1", "sizes": {"depth_mm": 1750}})",
            "ideal.sizes.depth_mm: is 1750, it must lie between 0.5 and 3.5 mm");
        row("half a floor along the junction", "ideal", R"({"kind": "class1", "sizes": {"follows_junction": 0.5}})",
            "ideal.sizes.follows_junction: is 0.5, it must be a whole number");
        row("two teeth", "tooth", "{\"scan\": \"a.stl\", \"block\": \"line\"}", "tooth: must name one of");
        row("a scan that is not there", "tooth", "{\"scan\": \"a.stl\"}", "tooth.scan: there is no file \"a.stl\"");
        row("a unit unheard of", "tooth", "{\"scan\": \"a.stl\", \"unit\": \"ell\"}", "tooth.unit: \"ell\" is no unit");
        row("no tooth", "tooth", "null", "tooth: is missing");
        row("a side of no tooth", "tooth", R"({"fdi": 36, "lies": "left"})",
            "tooth.lies: \"left\" is no side of a tooth");
        row("a side of a scan", "tooth", R"({"fdi": 36, "lies": "+x"})", "tooth.lies: \"+x\" is no side of a tooth");
        row("a tilt to no side", "tooth", R"({"fdi": 36, "tilt_deg": 45})",
            "tooth.tilt_deg: is how far the tooth lies on a side; say which in \"lies\"");
        row("a tooth upside down", "tooth", R"({"fdi": 36, "lies": "buccal", "tilt_deg": 180})",
            "tooth.tilt_deg: is 180, it must lie between 5 and 90");
        row("decay at the neck from above", "lesion", R"({"extent": 0.5, "site": "cervical"})",
            "lesion.site: decay at the neck or in a pit of a side is on the buccal or lingual side");
        row("a site unheard of", "lesion", R"({"extent": 0.5, "site": "root"})", "lesion.site: \"root\" is not known");
        row("an extent with its unit", "lesion", "{\"extent\": \"50 %\"}", "lesion.extent: is a text; write a number");
        row("an extent over 1", "lesion", "{\"extent\": 50}", "lesion.extent: is 50, it must lie between 0 and 1");
        row("no decay", "lesion", "null", "lesion: to remove decay there must be some");
        row("a grid too fine", "grid", "4096", "grid: is 4096, it must lie between 64 and 1024");
        row("an unknown bur", "burs", "[\"331x\"]", "burs: ");
        row("burs as a text", "burs", "\"330\"", "burs: must be a list");
        row("an unknown aid", "aids", "[\"x-ray\"]", "aids: \"x-ray\" is no aid");
        row("a handpiece unheard of", "handpieces", "[\"laser\"]", "handpieces: There is no handpiece 'laser'");
        row("a hardness unheard of", "hardness", "\"stone\"", "hardness: There is no hardness preset 'stone'");
        row("caries unheard of", "caries", "\"hard\"", "caries: \"hard\" is not known; there are soft, firm, graded");
        row("plastic in words", "plastic", "\"yes\"", "plastic: is a text; write true or false");
        row("a hardness like none", "hardness", R"({"name": "x", "like": "stone"})",
            "hardness.like: There is no hardness preset 'stone'");
        row("a hardness without a name", "hardness", "{\"axial_share\": 0.5}", "hardness.name: is missing");
        row("enamel too soft", "hardness", R"({"name": "x", "enamel": {"rate_mm3_per_ns": 1000}})",
            "hardness.enamel.rate_mm3_per_ns: is 1000, it must lie between 0 and 100 mm³/(N s)");
        row("points that are not said", "task", "\"touch_points\"", "touch: is missing");
        row("an empty list of points", "touch", "{\"points\": []}", "touch.points: must be a list of 1 to 40 places");
        row("points as a text", "touch", "{\"points\": \"all\"}", "touch.points: must be a list of 1 to 40 places");
        row("half a point", "touch", "{\"points\": [[1, 2], [3]]}", "touch.points[1]: must be [x, y]");
        row("a point in words", "touch", "{\"points\": [[\"left\", 2]]}", "touch.points[0]: must be [x, y]");
        row("a point in micrometres", "touch", "{\"points\": [[1000, 2]]}",
            "touch.points[0]: must be [x, y], two numbers between -30 and 30 mm");
        row("a reach that is none", "touch", R"({"points": [[1, 2]], "reach_mm": 0})",
            "touch.reach_mm: is 0, it must lie between 0.1 and 3 mm");
        row("a force that is not said", "task", "\"hold_force\"", "hold: is missing");
        row("a force in grams", "hold", "{\"force_n\": 100}", "hold.force_n: is 100, it must lie between 0.2 and 5 N");
        row("held for ever", "hold", "{\"seconds\": 1e9}",
            "hold.seconds: is 1000000000, it must lie between 1 and 120 s");
        row("layers of a tooth", "task", "\"tell_layers\"", "tooth: layers are told apart in a block of them");
        row("no rubric", "rubric", "null", "rubric: is missing");
        row("a rubric unheard of", "rubric", "\"fair\"", "rubric: there is no rubric \"fair\"");
        row("a title that turns round", "title", "\"Class \\u202e I\"",
            "title: holds the character U+202e, which cannot be seen; leave it out");
        row("a goal with a bell", "goal", "{\"en\": \"Ring \\u0007\"}",
            "goal: holds the character U+0007, which cannot be seen; leave it out");
        row("a depth in micrometres", "rules", "{\"depth_limit_mm\": 2500}",
            "rules.depth_limit_mm: is 2500, it must lie between 0.1 and 10 mm");
        row("exam maybe", "exam", "\"maybe\"", "exam: is a text; write true or false");
        row("an allowance of nothing", "rubric",
            R"({"id": "r", "title": "R", "criteria": [{"id": "c", "measure": "caries_left_percent", "weight": 100,
                "allowance": {"measure": "removed_mm3"}}]})",
            "rubric.criteria[0].allowance.each: is missing");
        row("once of nothing", "rubric",
            R"({"id": "r", "title": "R", "criteria": [{"id": "c", "measure": "caries_left_percent", "weight": 100,
                "once": {"measure": "removed_mm3"}}]})",
            "rubric.criteria[0].once.reaches: is missing");
        row("a measure that is none", "rubric",
            R"({"id": "r", "title": "R", "criteria": [{"id": "c", "measure": "beauty", "weight": 100}]})",
            "rubric.criteria[0].measure: \"beauty\" is no measure");
        row("weights that make 90", "rubric",
            R"({"id": "r", "title": "R", "criteria": [{"id": "c", "measure": "caries_left_percent", "weight": 90}]})",
            "those of all criteria make 90.0 points");
        row("a weight in hundredths", "rubric",
            R"({"id": "r", "title": "R", "criteria": [{"id": "c", "measure": "caries_left_percent", "weight": 33.33}]})",
            "rubric.criteria[0].weight: is 33.33; points are given to a tenth");
    }

    void tellsEachFaultByFileAndKey()
    {
        QFETCH(QString, key);
        QFETCH(QByteArray, value);
        QFETCH(QString, words);
        QJsonObject object = lesson();
        const QJsonValue parsed = QJsonDocument::fromJson("[" + value + "]").array().at(0);
        if (parsed.isNull())
            object.remove(key);
        else
            object[key] = parsed;
        const ReadLesson read = m_folder->read("odd.lesson.json", object);
        QVERIFY(!read.lesson);
        QVERIFY(says(read, "odd.lesson.json, "));
        QVERIFY(says(read, words));
    }

    void layersAreToldWithoutAids()
    {
        QJsonObject object = lesson();
        object["task"] = "tell_layers";
        object["tooth"] = QJsonObject{{"block", "layers"}, {"seed", 3}};
        object.remove("lesion");
        const ReadLesson read = m_folder->read("odd.lesson.json", object);
        QVERIFY2(read.lesson, qPrintable(sentencesOf(read)));
        QCOMPARE(read.lesson->aids, Aids::none());
        object["aids"] = QJsonArray{"section"};
        const ReadLesson peeking = m_folder->read("odd.lesson.json", object);
        QVERIFY(!peeking.lesson);
        QVERIFY(says(peeking, "aids: layers are told apart without any"));
    }

    void tellsAllFaultsAtOnce()
    {
        QJsonObject object = lesson();
        object["tooth"] = QJsonObject{{"fdi", 99}};
        object["grid"] = 3;
        object["exam"] = "maybe";
        const ReadLesson read = m_folder->read("odd.lesson.json", object);
        QCOMPARE(read.faults.size(), std::size_t{3});
        // A missing rubric does not hide the other faults.
        for (const char* rubric : {"fair", "../fair.json"}) {
            object["rubric"] = rubric;
            const ReadLesson without = m_folder->read("odd.lesson.json", object);
            QVERIFY(!without.lesson);
            QCOMPARE(without.faults.size(), std::size_t{4});
        }
    }

    void unknownKeysAreNotedWithTheNearest()
    {
        QJsonObject object = lesson();
        object["minuts"] = 3;
        object["colour of the sky"] = "blue";
        const ReadLesson read = m_folder->read("odd.lesson.json", object);
        QVERIFY2(read.lesson, qPrintable(sentencesOf(read)));
        QCOMPARE(read.faults.size(), std::size_t{2});
        QVERIFY(says(read, "minuts: is not a key that is known here; did you mean \"minutes\"?"));
        QVERIFY(!read.faults[0].grave && !read.faults[1].grave);
    }

    void whatIsBasedOnAnotherTakesItsKeys()
    {
        m_folder->write("base.json", lesson());
        const ReadLesson read =
            m_folder->read("own.lesson.json", own({{"minutes", 20}, {"tooth", QJsonObject{{"seed", 9}}}}));
        QVERIFY2(read.lesson, qPrintable(sentencesOf(read)));
        QCOMPARE(read.lesson->id, std::string("own"));
        QCOMPARE(std::get<MadeTooth>(read.lesson->tooth), (MadeTooth{36, 9, {}}));
        QCOMPARE(read.lesson->minutes, 20.0);
    }

    /// A title replaces the base's title in all languages.
    void aNameIsTakenAsAWhole()
    {
        QJsonObject base = lesson();
        base["title"] = QJsonObject{{"en", "Base"}, {"ja", "基"}};
        m_folder->write("base.json", base);
        const ReadLesson read =
            m_folder->read("own.lesson.json", own({{"title", QJsonObject{{"en", "Own"}, {"de", "Eigen"}}}}));
        QVERIFY2(read.lesson, qPrintable(sentencesOf(read)));
        QCOMPARE(read.lesson->title, (LocalText{{"en", "Own"}, {"de", "Eigen"}}));
        QCOMPARE(inLanguage(read.lesson->title, "ja"), std::string("Own"));
    }

    void nullTakesAKeyBack()
    {
        QJsonObject base = lesson();
        base["minutes"] = 7;
        base["rules"] = QJsonObject{{"force_limit_n", 3}};
        m_folder->write("base.json", base);
        const QJsonObject noLimit{{"force_limit_n", QJsonValue::Null}};
        const ReadLesson read =
            m_folder->read("own.lesson.json", own({{"minutes", QJsonValue::Null}, {"rules", noLimit}}));
        QVERIFY(isSound(read));
        QCOMPARE(read.lesson->minutes, 0.0);
        QVERIFY(!read.lesson->rules.forceLimitN);
        // If the base has no value, null is accepted and has no effect.
        base["grid"] = QJsonValue::Null;
        base["rules"] = noLimit;
        const ReadLesson alone = m_folder->read("alone.lesson.json", base);
        QVERIFY(isSound(alone));
        QCOMPARE(alone.lesson->gridSide, 150);
        // Each file must state its own format.
        QVERIFY(says(m_folder->read("silent.lesson.json", QJsonObject{{"based_on", "base.json"}, {"id", "silent"}}),
                     "silent.lesson.json, format: is missing"));
    }

    void namesTheFileThatIsWrong()
    {
        QJsonObject base = lesson();
        base["grid"] = 3;
        base["rubric"] = "mine.rubric.json";
        m_folder->write("base.json", base);
        const QJsonArray criteria{
            QJsonObject{{"id", "c"}, {"measure", "caries_left_percent"}, {"weight", 100}, {"tolerance", "2 mm"}}};
        m_folder->write("criteria.json", QJsonObject{{"format", 1}, {"criteria", criteria}});
        m_folder->write(
            "mine.rubric.json",
            QJsonObject{
                {"format", 1}, {"based_on", "criteria.json"}, {"id", "mine"}, {"title", "M"}, {"pass_mark", 101}});
        const QJsonObject faulty = own({{"minutes", -1}});
        const ReadLesson read = m_folder->read("own.lesson.json", faulty);
        for (const char* words :
             {"own.lesson.json, minutes: is -1", "base.json, grid: is 3", "mine.rubric.json, pass_mark: is 101",
              "criteria.json, criteria[0].tolerance: is a text; write a number of percent"})
            QVERIFY(says(read, words));
        base["format"] = 2;
        m_folder->write("base.json", base);
        QVERIFY(says(m_folder->read("own.lesson.json", faulty), "base.json, format: is 2, from a newer Cusp"));
        // A rubric inside a lesson may be based on another rubric as well.
        QJsonObject object = lesson();
        object["rubric"] = QJsonObject{{"based_on", "decay_removal.rubric.json"}, {"id", "strict"}, {"pass_mark", 90}};
        const ReadLesson strict = m_folder->read("strict.lesson.json", object);
        QVERIFY(isSound(strict));
        QCOMPARE(strict.lesson->rubric.passMarkTenths, 900);
        QCOMPARE(strict.lesson->rubric.criteria.size(), shippedRubric("decay_removal")->criteria.size());
    }

    void refusesACircleOfFiles()
    {
        m_folder->write("a.json", QJsonObject{{"format", 1}, {"based_on", "b.json"}});
        const QString file = m_folder->write("b.json", QJsonObject{{"format", 1}, {"based_on", "a.json"}});
        const ReadLesson read = readLesson(file);
        QVERIFY(!read.lesson);
        QVERIFY(says(read, "a.json, based_on: b.json: is based on itself by way of a.json"));
        // A chain that is too long is refused as well.
        for (int k = 0; k < 12; ++k)
            m_folder->write(QStringLiteral("%1.json").arg(k),
                            QJsonObject{{"format", 1}, {"based_on", QStringLiteral("%1.json").arg(k + 1)}});
        QVERIFY(!readLesson(m_folder->at("0.json")).lesson);
    }

    void refusesAFileThatIsNotThere()
    {
        QVERIFY(says(readLesson(m_folder->at("none.lesson.json")), "none.lesson.json does not exist"));
        QVERIFY(says(readLesson(m_folder->path()), "is a folder"));
        QVERIFY(says(m_folder->read("empty.lesson.json", QByteArray()), "is empty"));
        const QString file = m_folder->write("a.lesson.json", QJsonObject{{"format", 1}, {"based_on", "gone.json"}});
        QVERIFY(says(readLesson(file), "based_on: gone.json: does not exist"));
        QVERIFY(
            says(m_folder->read("text.lesson.json", QByteArray("Dear all,\nhello")), "is not JSON: line 1, column"));
        QVERIFY(says(m_folder->read("list.lesson.json", QByteArray("[]")), "one JSON object"));
        // Syntax errors have Qt's error texts.
        for (const QByteArray json :
             {"{", "{\"a\" 1}", "{\"a\": [1", "{\"a\": 1 \"b\": 2}", "{\"a\": 1e}", "{\"a\": \"\\u1\"}", "{\"a\": \"",
              "{\"a\": 1,}", "{\"a\": 1} {", "{\"a\": x}", "{\"a\": \"\xFF\"}"}) {
            QJsonParseError error{};
            QVERIFY2(QJsonDocument::fromJson(json, &error).isNull(), json);
            const QString said = sentencesOf(m_folder->read("broken.lesson.json", json));
            QVERIFY2(said.contains(error.errorString()), qPrintable(said + " / " + error.errorString()));
        }
        QVERIFY(!m_folder->read("latin.lesson.json", QByteArray("{\"id\": \"\xE4\"}")).lesson);
        // A byte order mark, which some editors write, is accepted.
        QVERIFY(m_folder->read("bom.lesson.json", "\xEF\xBB\xBF" + QJsonDocument(lesson()).toJson()).lesson);
    }

    void refusesNamesThatLeadElsewhere()
    {
        for (const char* name :
             {"../secret.json", "/etc/passwd", "a/../../b.json", "C:\\x.json", ":/lessons/x.json", ""}) {
            const ReadLesson read = m_folder->read("a.lesson.json", QJsonObject{{"format", 1}, {"based_on", name}});
            QVERIFY(!read.lesson);
            QVERIFY(says(read, "leads out of the lesson's folder"));
            QJsonObject object = lesson();
            object["tooth"] = QJsonObject{{"scan", name}};
            QVERIFY(!m_folder->read("b.lesson.json", object).lesson);
        }
    }

    void refusesTenMegabytes()
    {
        QJsonObject object = lesson();
        object["goal"] = QString(10 * 1024 * 1024, QLatin1Char('x'));
        const ReadLesson read = m_folder->read("large.lesson.json", object);
        QVERIFY(says(read, "has 10.0 MB; a lesson has at most 1.0 MB"));
        const QByteArray nested = QByteArray(200'000, '[') + QByteArray(200'000, ']');
        QVERIFY(!m_folder->read("deep.lesson.json", "{\"format\": 1, \"steps\": " + nested + "}").lesson);
    }

    void refusesAKeySaidTwice()
    {
        QByteArray json = QJsonDocument(lesson()).toJson();
        QVERIFY(m_folder->read("once.lesson.json", json).lesson);
        json.insert(json.indexOf('{') + 1, "\"minutes\": 5, \"goal\": \"say \\\"{\\\": [\", \"minutes\": 50,");
        const ReadLesson read = m_folder->read("twice.lesson.json", json);
        QVERIFY(!read.lesson);
        QVERIFY(says(read, "twice.lesson.json, minutes: is said twice"));
        QVERIFY(says(read, "goal: is said twice"));
        QCOMPARE(read.faults.size(), std::size_t{2});
    }

    void refusesOtherEncodings()
    {
        const QString text = QString::fromUtf8(QJsonDocument(lesson()).toJson());
        for (const auto encoding : {QStringConverter::Utf16LE, QStringConverter::Utf16BE, QStringConverter::Utf32LE}) {
            for (const auto flag : {QStringConverter::Flag::Default, QStringConverter::Flag::WriteBom}) {
                QStringEncoder encode(encoding, flag);
                const ReadLesson read = m_folder->read("other.lesson.json", QByteArray(encode(text)));
                QVERIFY(says(read, "save it as UTF-8"));
            }
        }
        const ReadLesson latin = m_folder->read("latin.lesson.json", QByteArray("{\"id\": \"\xE4\"}"));
        QVERIFY(says(latin, "latin.lesson.json is not JSON") && says(latin, "as UTF-8"));
    }

    /// A device that yields bytes without end is not read.
    void readsFilesAlone()
    {
        QVERIFY(QFile::link("/dev/zero", m_folder->at("endless.stl")));
        QJsonObject object = lesson();
        object["tooth"] = QJsonObject{{"scan", "endless.stl"}};
        QVERIFY(says(m_folder->read("a.lesson.json", object), "tooth.scan: there is no file"));
        const ReadLesson read =
            m_folder->read("b.lesson.json", QJsonObject{{"format", 1}, {"based_on", "endless.stl"}, {"id", "b"}});
        QVERIFY(says(read, "it is no file"));
    }

    void anExpertsRecordingLiesBeside()
    {
        QJsonObject object = lesson();
        const std::string without = m_folder->read("e.lesson.json", object).lesson->hash;
        object["expert"] = QJsonObject{{"recording", "expert.cusprec"}};
        QVERIFY(says(m_folder->read("e.lesson.json", object),
                     "expert.recording: there is no file \"expert.cusprec\" beside the lesson"));
        m_folder->write("expert.cusprec", QByteArray("one"));
        const ReadLesson one = m_folder->read("e.lesson.json", object);
        QVERIFY2(one.lesson, qPrintable(sentencesOf(one)));
        QVERIFY(QFileInfo(QString::fromStdString(one.lesson->expert->file)).isAbsolute());
        QCOMPARE(one.lesson->expert->hash.size(), std::size_t{64});
        QVERIFY(one.lesson->hash != without);
        // With another recording the lesson has another hash.
        m_folder->write("expert.cusprec", QByteArray("two"));
        QVERIFY(m_folder->read("e.lesson.json", object).lesson->hash != one.lesson->hash);
        // A recording of an attempt stores the name and the hash of the expert's recording, not its folder.
        const ReadLesson kept = readLessonText(QByteArray::fromStdString(one.lesson->json), QStringLiteral("kept"));
        QVERIFY2(kept.lesson, qPrintable(sentencesOf(kept)));
        QCOMPARE(kept.lesson->expert->file, std::string("expert.cusprec"));
        QCOMPARE(kept.lesson->expert->hash, one.lesson->expert->hash);
        QCOMPARE(kept.lesson->hash, one.lesson->hash);
        for (const char* name : {"../expert.cusprec", "/etc/passwd"}) {
            object["expert"] = QJsonObject{{"recording", name}};
            QVERIFY(!m_folder->read("e.lesson.json", object).lesson);
        }
    }

    void truncatedAnywhereNeverCrashes()
    {
        const QByteArray whole = QJsonDocument(lesson()).toJson();
        for (qsizetype length = 1; length < whole.size() - 2; ++length) {
            const ReadLesson read = readLessonText(whole.left(length), QStringLiteral("cut"));
            QVERIFY(!read.lesson);
            QVERIFY(!read.faults.empty());
        }
    }

    void theHashTellsContentApart()
    {
        const QJsonObject object = lesson();
        const auto hashOf = [&](const QByteArray& bytes) {
            const ReadLesson read = m_folder->read("h.lesson.json", bytes);
            return read.lesson ? read.lesson->hash : std::string();
        };
        const std::string first = hashOf(QJsonDocument(object).toJson());
        QCOMPARE(first.size(), std::size_t{64});
        // Whitespace and the folder of the file do not change the hash.
        QCOMPARE(hashOf(QJsonDocument(object).toJson(QJsonDocument::Compact)), first);
        QJsonObject other = object;
        other["minutes"] = 1;
        QVERIFY(hashOf(QJsonDocument(other).toJson()) != first);
        // The rubric is part of the lesson's hash, as if it were written in the lesson.
        const auto rubric = shippedRubric(QStringLiteral("decay_removal"));
        QVERIFY(rubric.has_value());
        QFile shipped(QStringLiteral(":/lessons/decay_removal.rubric.json"));
        QVERIFY(shipped.open(QIODevice::ReadOnly));
        other = object;
        other["rubric"] = QJsonDocument::fromJson(shipped.readAll()).object();
        QCOMPARE(hashOf(QJsonDocument(other).toJson()), first);
    }

    void theTextOfALessonIsTheLesson()
    {
        for (const CatalogEntry& entry : readCatalog({})) {
            const Lesson& original = *entry.read.lesson;
            const ReadLesson again = readLessonText(QByteArray::fromStdString(original.json), QStringLiteral("text"));
            QVERIFY2(again.lesson, qPrintable(sentencesOf(again)));
            QVERIFY(*again.lesson == original);
        }
    }

    void aFaultyFileLeavesTheOthers()
    {
        m_folder->write("good.lesson.json", lesson());
        m_folder->write("bad.lesson.json", QByteArray("{"));
        m_folder->write("notes.txt", QByteArray("not a lesson"));
        const auto entries = readCatalog(m_folder->path());
        int own = 0;
        int faulty = 0;
        for (const CatalogEntry& entry : entries) {
            own += entry.isShipped ? 0 : 1;
            faulty += entry.isFaulty() ? 1 : 0;
        }
        QCOMPARE(own, 2);
        QCOMPARE(faulty, 1);
        QVERIFY(readCatalog(m_folder->at("nowhere")).size() == entries.size() - 2);
    }

    void anIdBelongsToOneLesson()
    {
        QJsonObject object = lesson();
        object["id"] = "decay-36-moderate";
        m_folder->write("mine.lesson.json", object);
        const auto entries = readCatalog(m_folder->path());
        QVERIFY(entries.back().isFaulty());
        QVERIFY(says(entries.back().read, "belongs to another lesson"));
    }

private:
    /// Returns a lesson that is based on "base.json".
    static QJsonObject own(QJsonObject keys)
    {
        keys["format"] = 1;
        keys["based_on"] = "base.json";
        keys["id"] = "own";
        return keys;
    }
    static QJsonObject lesson()
    {
        return {{"format", 1},
                {"id", "try-36"},
                {"title", QJsonObject{{"en", "Try"}, {"de", "Versuch"}}},
                {"goal", "Take the decay out."},
                {"task", "remove_decay"},
                {"tooth", QJsonObject{{"fdi", 36}, {"seed", 7}}},
                {"lesion", QJsonObject{{"extent", 0.5}}},
                {"rubric", "decay_removal"}};
    }

    std::optional<support::LessonFolder> m_folder;
};

CUSP_TEST(TestLessonReader)
#include "tst_lesson_reader.moc"
