// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QTest>
#include <cmath>
#include <set>

#include "core/settings/StabilityBound.h"
#include "lessons/Assignment.h"
#include "lessons/LessonReader.h"
#include "lessons/PresetShelf.h"
#include "tests/lessons/LessonFolder.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using core::settings::FeelPreset;
using core::settings::Substance;

namespace {

FeelPreset hardTooth()
{
    FeelPreset preset;
    preset.name = "Zähne, hart";
    preset.notes = "for the second year\nwith a worn bur";
    preset.enamelRate = 0.45;
    preset.firmCariesRate = 2.75;
    preset.plasticFromN = 0.3;
    preset.stiffnessNPerMm = 2.5;
    preset.dampingNSPerM = 5.0;
    preset.clampN = 6.0;
    return lessons::hashed(preset);
}

QByteArray written(const QJsonObject& object)
{
    return QJsonDocument(object).toJson();
}

QString allFaults(const lessons::ReadPreset& read)
{
    QString text;
    for (const lessons::ValidationIssue& fault : read.faults)
        text += (fault.grave ? "grave " : "note ") + fault.key + ": " + fault.english() + u'\n';
    return text;
}

/// Returns whether the preset was read without faults.
bool isSound(const lessons::ReadPreset& read)
{
    if (!read.faults.empty())
        qWarning("%s", qPrintable(allFaults(read)));
    return read.preset && read.faults.empty();
}

/// Returns whether one of the preset's faults contains these words.
bool says(const lessons::ReadPreset& read, const QString& words)
{
    const bool is = allFaults(read).contains(words);
    if (!is)
        qWarning("%s", qPrintable(allFaults(read)));
    return is;
}

lessons::ReadPreset readText(const QByteArray& json)
{
    return lessons::readPresetText(json, "x");
}

}  // namespace

class TestPresets : public QObject
{
    Q_OBJECT
private slots:
    void fileComesBackEqual()
    {
        const support::LessonFolder folder;
        const QString path = folder.at("hard.cusppreset");
        QVERIFY(lessons::writePreset(path, hardTooth()));
        const lessons::ReadPreset read = lessons::readPreset(path);
        QVERIFY(isSound(read));
        QVERIFY(*read.preset == hardTooth());
        QCOMPARE(read.preset->hash.size(), std::size_t{64});
    }

    void everyNumberIsInTheFileAndTheHash()
    {
        std::set<std::string> hashes{lessons::hashOf(FeelPreset{})};
        for (const auto& field : core::settings::feelFields()) {
            FeelPreset changed;
            const double value = changed.*field.value;
            QVERIFY2(value >= field.minimum && value <= field.maximum, field.id);
            // A value slightly inside the range.
            changed.*field.value = value > field.minimum ? value - 0.01 * (value - field.minimum) : value + 0.01;
            QVERIFY2(hashes.insert(lessons::hashOf(changed)).second, field.id);
            const lessons::ReadPreset read = readText(written(lessons::toJson(changed)));
            QVERIFY(isSound(read));
            QCOMPARE((*read.preset).*field.value, changed.*field.value);
            for (const double beyond : {field.minimum - 1.0, field.maximum + 1.0}) {
                changed.*field.value = beyond;
                const lessons::ReadPreset refused = readText(written(lessons::toJson(changed)));
                QVERIFY2(!refused.preset && refused.faults.front().key == field.id, qPrintable(allFaults(refused)));
            }
        }
        for (const auto& change : {+[](FeelPreset& p) { p.name = "other"; }, +[](FeelPreset& p) { p.version = 2; },
                                   +[](FeelPreset& p) { p.notes = "n"; }}) {
            FeelPreset changed;
            change(changed);
            QVERIFY(hashes.insert(lessons::hashOf(changed)).second);
        }
    }

    /// A preset from before flat ends and full loads existed keeps its values and its hash.
    void aPresetOfFormat1StaysWhatItIs()
    {
        FeelPreset older = core::settings::withoutEndsAndFullLoad(hardTooth());
        const QJsonObject object = lessons::toJson(older);
        QCOMPARE(object["format"].toInt(), 1);
        QVERIFY(!object.contains("flat_end_share") && !object.contains("full_load_n"));
        const lessons::ReadPreset read = readText(written(object));
        QVERIFY(isSound(read));
        QVERIFY(*read.preset == lessons::hashed(older));
        QVERIFY(!lessons::leftOutFault(read));
        QCOMPARE(lessons::toJson(hardTooth())["format"].toInt(), 2);
        // The first shipped preset, identified by its hash at that time.
        QVERIFY(lessons::shippedPresets().back().hash.starts_with("67fbb52c"));
        QCOMPARE(lessons::shippedPresets().back().version, 1);
        QCOMPARE(lessons::shippedPresets().front().version, 2);
        QCOMPARE(lessons::shippedPresets().front().flatEndShare, 0.615);
    }

    /// If a school made "natural", version 2, before Cusp shipped one, the school keeps its own.
    void aSchoolsOwnVersionGoesBeforeAShippedOne()
    {
        FeelPreset own = core::settings::withoutEndsAndFullLoad(FeelPreset{});
        own.version = 2;
        own.enamelRate = 0.5;
        own = lessons::hashed(own);
        const auto all = lessons::shelved({{"own", own, {}}});
        QCOMPARE(all.size(), std::size_t{3});
        QVERIFY(lessons::findPreset(all, "natural v2").value() == own);
        const FeelPreset usual = lessons::usualPreset(all);
        QCOMPARE(usual.version, 3);
        QVERIFY(lessons::findPreset(all, "natural").value() == usual);
        QVERIFY(core::settings::hardnessFor(usual, {}).material == core::settings::HardnessPreset{}.material);
        QVERIFY(lessons::usualPreset(lessons::shelved({})) == lessons::shippedPresets().front());
    }

    void whatIsLeftOutIsAsShipped()
    {
        const lessons::ReadPreset empty = lessons::readPresetText("{}", "/somewhere/soft teeth.cusppreset");
        QVERIFY2(empty.preset, qPrintable(allFaults(empty)));
        QCOMPARE(empty.preset->name, std::string("soft teeth"));
        QCOMPARE(empty.preset->enamelRate, FeelPreset{}.enamelRate);
        const lessons::ReadPreset both =
            readText(R"({"caries": {"rate_mm3_per_ns": 4.5}, "enamel": {"threshold_n": 0.2}})");
        QVERIFY(isSound(both));
        QCOMPARE(both.preset->softCariesRate, 4.5);
        QCOMPARE(both.preset->firmCariesRate, 4.5);
        QCOMPARE(both.preset->enamelFromN, 0.2);
        QCOMPARE(both.preset->enamelRate, FeelPreset{}.enamelRate);
        // The value may be intended, so it is accepted and reported.
        QVERIFY(!both.leftOut.contains("enamel") && both.leftOut.contains("enamel.rate_mm3_per_ns"));
        QVERIFY(both.leftOut.contains("pulp") && both.leftOut.contains("soft_caries.threshold_n"));
        QVERIFY(!both.leftOut.contains("soft_caries.rate_mm3_per_ns"));
        QJsonObject all = lessons::toJson(hardTooth());
        QVERIFY(!lessons::leftOutFault(readText(written(all))));
        all.remove("pulp");
        const auto fault = lessons::leftOutFault(readText(written(all)));
        QVERIFY(fault && !fault->grave);
        QCOMPARE(fault->english(), QString("says nothing of pulp: that is as shipped"));
    }

    void cutAnywhereIsAFault()
    {
        const QByteArray whole = written(lessons::toJson(hardTooth())).trimmed();
        for (qsizetype length = 0; length < whole.size(); ++length) {
            const lessons::ReadPreset read = readText(whole.left(length));
            QVERIFY2(!read.preset && lessons::anyGrave(read.faults), qPrintable(QString::number(length)));
        }
    }

    void refusesStrangers_data()
    {
        support::columns<QByteArray, QString>("json", "words");
        const auto row = [](const char* name, const QByteArray& json, const char* words) {
            QTest::newRow(name) << json << QString(words);
        };
        row("nothing", "", "is empty");
        row("a list", "[]", "must be one JSON object");
        row("a picture", QByteArray("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16), "");
        row("another kind", R"({"kind": "cusp-lesson"})", "is no hardness preset");
        row("the future", R"({"format": 3})", "from a newer Cusp");
        row("huge", "{\"notes\": \"" + QByteArray(200'000, 'x') + "\"}", "has ");
        row("deep", QByteArray(5000, '[') + QByteArray(5000, ']'), "");
        row("a number too large for a double", R"({"enamel": {"rate_mm3_per_ns": 1e999}})", "");
        row("a negative rate", R"({"enamel": {"rate_mm3_per_ns": -1}})", "enamel.rate_mm3_per_ns: is -1");
        row("a huge rate", R"({"enamel": {"rate_mm3_per_ns": 1e300}})", "must lie between 0 and 100");
        row("a text for a number", R"({"enamel": {"rate_mm3_per_ns": "0.7"}})", "is a text; write a number");
        row("null for a number", R"({"axial_share": null})", "axial_share: is null");
        row("a number for an object", R"({"force": 2})", "force: is a number; write an object");
        row("no stiffness", R"({"force": {"stiffness_n_per_mm": 0}})", "force.stiffness_n_per_mm: is 0");
        row("half a version", R"({"version": 1.5})", "must be a whole number");
        row("version 0", R"({"version": 0})", "version: is 0");
        row("a version beyond counting", R"({"version": 1e18})", "version: is 1e+18");
        row("no name", R"({"name": ""})", "name: must be one line");
        row("two lines for a name", R"({"name": "a\nb"})", "name: must be one line");
        row("a long name", "{\"name\": \"" + QByteArray(61, 'x') + "\"}", "has 61 characters");
        row("a long name of rare kanji", "{\"name\": \"" + QByteArray("𠮷").repeated(61) + "\"}", "has 61 characters");
        row("a name written backwards", R"({"name": "natural \u202egnp"})", "U+202e");
        row("a name with a zero", R"({"name": "nat\u0000ural"})", "U+0000");
        row("notes with a bell", R"({"notes": "\u0007"})", "U+0007");
        row("a key said twice", R"({"enamel": {}, "enamel": {}})", "is said twice");
        row("a wide encoding", QByteArray("\xFF\xFE{\0}\0", 6), "save it as UTF-8");
    }

    void refusesStrangers()
    {
        QFETCH(QByteArray, json);
        QFETCH(QString, words);
        const lessons::ReadPreset read = lessons::readPresetText(json, "x.cusppreset");
        QVERIFY(!read.preset);
        QVERIFY(lessons::anyGrave(read.faults));
        QVERIFY(says(read, words));
    }

    void unknownKeysWarn()
    {
        const lessons::ReadPreset read =
            readText(R"({"name": "x", "enamle": {}, "force": {"stiffness": 2}, "colour": 1})");
        QVERIFY2(read.preset, qPrintable(allFaults(read)));
        QCOMPARE(read.faults.size(), std::size_t{3});
        QVERIFY2(allFaults(read).contains("enamle: is not a key that is known here; did you mean \"enamel\"?"),
                 qPrintable(allFaults(read)));
        QVERIFY(says(read, "force.stiffness: is not a key"));
    }

    void aFileTooLargeIsToldItsSize()
    {
        const support::LessonFolder folder;
        const QString path = folder.write("big.json", QByteArray(200'000, ' '));
        const lessons::ReadPreset read = lessons::readPreset(path);
        QVERIFY(!read.preset && says(read, "has 200000 bytes"));
    }

    void outOfTheBoundIsRefusedWithIt()
    {
        FeelPreset stiff = hardTooth();
        stiff.stiffnessNPerMm = 9.0;
        const lessons::ReadPreset read = readText(written(lessons::toJson(stiff)));
        QVERIFY(!read.preset);
        QVERIFY(says(read, "the stiffness is 9 N/mm") && allFaults(read).contains("held up to 5.69 N/mm"));
        QVERIFY(read.beyondBound && read.beyondBound->stiffnessNPerMm == 9.0);
        const support::LessonFolder folder;
        lessons::PresetFolder shelf(folder.path());
        QVERIFY(support::isRefused(shelf.save(stiff), "held up to 5.69 N/mm"));
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void versionsAreKeptAndNeverChanged()
    {
        const support::LessonFolder folder;
        lessons::PresetFolder shelf(folder.at("presets"));  // the folder does not exist yet
        FeelPreset first = hardTooth();
        first.version = 0;
        QCOMPARE(shelf.save(first).value().version, 1);
        QCOMPARE(shelf.save(first).value().version, 1);  // saving it again unchanged adds no version
        FeelPreset second = first;
        second.enamelRate = 0.5;
        QCOMPARE(shelf.save(second).value().version, 2);
        QCOMPARE(shelf.save(first).value().version, 3);  // restoring an older version saves it as a new one
        // The versions of a shipped preset count as well.
        FeelPreset natural;
        natural.version = 0;
        natural.dentinRate = 2.0;
        QCOMPARE(shelf.save(natural).value().version, 3);
        std::vector<std::pair<std::string, int>> found;
        for (const lessons::ReadPreset& read : shelf.list()) {
            QVERIFY2(read.preset, qPrintable(allFaults(read)));
            found.emplace_back(read.preset->name, read.preset->version);
        }
        const std::string hard = first.name;
        QCOMPARE(found, (std::vector<std::pair<std::string, int>>{
                            {hard, 3}, {hard, 2}, {hard, 1}, {"natural", 3}, {"natural", 2}, {"natural", 1}}));
        QVERIFY(QDir(folder.at("presets")).entryList({"*.part"}, QDir::Files | QDir::Hidden).isEmpty());
    }

    void anImportKeepsItsNumberIfThatIsFree()
    {
        const support::LessonFolder folder;
        lessons::PresetFolder shelf(folder.path());
        FeelPreset theirs = hardTooth();
        theirs.version = 7;
        QCOMPARE(shelf.save(theirs).value().version, 7);
        QCOMPARE(shelf.save(theirs).value().version, 7);
        QCOMPARE(shelf.list().size(), std::size_t{3});
        theirs.notes = "another of the same number";
        QCOMPARE(shelf.save(theirs).value().version, 8);
        // There is no version after the highest number.
        theirs.name = "worn out";
        theirs.version = lessons::kNewestPresetVersion;
        QVERIFY(shelf.save(theirs));
        theirs.version = 0;
        theirs.enamelRate *= 0.9;
        QVERIFY(support::isRefused(shelf.save(theirs), "keep this under another name"));
    }

    void aFolderOfStrangersIsHarmless()
    {
        const support::LessonFolder folder;
        folder.write("a.cusppreset", "{");
        folder.write("b.cusppreset", R"({"name": "natural", "version": 1, "dentin": {"rate_mm3_per_ns": 9}})");
        folder.write("c.txt", "hello");
        QVERIFY(QDir(folder.path()).mkdir("d.cusppreset"));
        lessons::PresetFolder shelf(folder.path());
        const auto all = shelf.list();
        QCOMPARE(all.size(), std::size_t{4});
        QVERIFY(*all[0].preset == lessons::shippedPresets().front());
        QVERIFY(!all[2].preset && !all[3].preset);
        QVERIFY(says(all[3], "there is another natural of version 1"));
        QVERIFY(!lessons::readPreset(folder.path()).preset);
        QVERIFY(!lessons::readPreset(folder.at("none.cusppreset")).preset);
    }

    void whereNothingCanBeWrittenItSaysSo()
    {
        const support::LessonFolder folder;
        folder.write("file", "x");
        lessons::PresetFolder shelf(folder.at("file/presets"));
        QVERIFY(support::isRefused(shelf.save(hardTooth()), core::ErrorCode::FileUnwritable));
    }

    void namesAreFound()
    {
        const support::LessonFolder folder;
        lessons::PresetFolder shelf(folder.path());
        FeelPreset mine;
        mine.name = "mine";
        QVERIFY(shelf.save(mine));
        mine.version = 0;
        mine.dentinRate = 1.0;
        QVERIFY(shelf.save(mine));
        QCOMPARE(lessons::findPreset(shelf.list(), "mine").value().version, 2);
        QCOMPARE(lessons::findPreset(shelf.list(), "mine v1").value().version, 1);
        QVERIFY(support::isRefused(lessons::findPreset(shelf.list(), "theirs"), "mine, natural"));
    }

    void labelsAreReadBack()
    {
        const FeelPreset hard = hardTooth();
        const lessons::PresetUsed used = lessons::presetUsed(core::settings::labelOf(hard), true);
        QCOMPARE(used.name, QString("Zähne, hart"));
        QCOMPARE(used.version, 1);
        QCOMPARE(used.hash, QString::fromStdString(hard.hash).left(8));
        QVERIFY(used.isChanged);
        // An attempt refers to its preset by the whole hash.
        QCOMPARE(lessons::presetUsed(core::settings::hardnessFor(hard, {}).name, false).hash,
                 QString::fromStdString(hard.hash));
        QVERIFY(lessons::presetUsed("natural", false) == (lessons::PresetUsed{"natural", 0, {}, false}));
        FeelPreset odd;
        odd.hash = std::string(64, 'a');
        odd.name = "like natural v2 #12345678";
        odd.version = 3;
        QCOMPARE(lessons::presetUsed(core::settings::labelOf(odd), false).name, QString("like natural v2 #12345678"));
        QCOMPARE(lessons::presetUsed(core::settings::labelOf(odd), false).version, 3);
    }

    /// Values that the lesson does not set come from the preset in use. The lesson decides which of its rows apply.
    void lessonSaysWhichRowsCut()
    {
        using core::terrain::Material;
        const FeelPreset preset = hardTooth();
        const auto settingsOf = [&](const lessons::Lesson* lesson) {
            return lessons::servoSettings(lesson, {}, preset);
        };
        const auto rate = [](const core::servo::ServoSettings& settings, Material material) {
            return settings.hardness.material.at(static_cast<std::size_t>(material)).rateMm3PerNs;
        };
        QCOMPARE(rate(settingsOf(nullptr), Material::Caries), preset.softCariesRate);
        QCOMPARE(rate(settingsOf(nullptr), Material::Enamel), preset.enamelRate);
        QCOMPARE(settingsOf(nullptr).force.stiffnessNPerMm, preset.stiffnessNPerMm);
        QCOMPARE(settingsOf(nullptr).force.clampN, preset.clampN);
        QVERIFY(settingsOf(nullptr).hardness.name.starts_with(core::settings::labelOf(preset)));
        lessons::Lesson lesson;
        lesson.kind.decay = core::settings::DecayKind::Firm;
        QCOMPARE(rate(settingsOf(&lesson), Material::Caries), preset.firmCariesRate);
        lesson.kind.decay = core::settings::DecayKind::Graded;
        const core::settings::HardnessPreset graded = settingsOf(&lesson).hardness;
        QCOMPARE(rate(settingsOf(&lesson), Material::Caries), preset.softCariesRate);
        QCOMPARE(graded.decayZones->firm.rateMm3PerNs, preset.firmCariesRate);
        QCOMPARE(graded.decayZones->leathery.rateMm3PerNs, std::sqrt(preset.softCariesRate * preset.firmCariesRate));
        QCOMPARE(graded.decayZones->leathery.thresholdN, 0.5 * (preset.softCariesFromN + preset.firmCariesFromN));
        lesson.kind.isPlastic = true;
        QVERIFY(!settingsOf(&lesson).hardness.decayZones);
        for (const Material material : {Material::Caries, Material::Enamel, Material::Dentin, Material::Pulp})
            QCOMPARE(rate(settingsOf(&lesson), material), preset.plasticRate);
        lesson.hardness = core::settings::findHardnessPreset("typodont").value();
        QCOMPARE(settingsOf(&lesson).hardness.name, std::string("typodont"));
        // The conversion back to a preset, as for a resumed attempt.
        for (const core::settings::ToothKind kind : {core::settings::ToothKind{},
                                                     {true},
                                                     {false, core::settings::DecayKind::Firm},
                                                     {false, core::settings::DecayKind::Graded}}) {
            lesson = {};
            lesson.kind = kind;
            const core::servo::ServoSettings set = settingsOf(&lesson);
            const FeelPreset felt = core::settings::feltAs(FeelPreset{}, set.hardness, set.force, kind);
            QVERIFY(lessons::servoSettings(&lesson, {}, felt).hardness.material == set.hardness.material);
            QVERIFY(lessons::servoSettings(&lesson, {}, felt).hardness.decayZones == set.hardness.decayZones);
            QCOMPARE(felt.stiffnessNPerMm, preset.stiffnessNPerMm);
        }
        const lessons::ReadLesson read = lessons::readDraft(
            QJsonObject{
                {"format", 1}, {"based_on", "decay-36-2-moderate.lesson.json"}, {"id", "firm-36"}, {"caries", "firm"}},
            QDir::temp().filePath("firm.lesson.json"));
        QVERIFY(read.lesson && read.lesson->kind.decay == core::settings::DecayKind::Firm && !read.lesson->hardness);
        lesson.hardness = core::settings::findHardnessPreset("typodont").value();
        // The defaults are unchanged: plastic of the shipped preset is the typodont, and the shipped preset is the
        // default tooth.
        const FeelPreset shipped = lessons::shippedPresets().front();
        QVERIFY(core::settings::hardnessFor(shipped, {true}).material == lesson.hardness->material);
        QVERIFY(core::settings::hardnessFor(shipped, {}).material == core::settings::HardnessPreset{}.material);
        core::contact::ForceSettings force;
        core::settings::putForces(shipped, force);
        QVERIFY(force == core::contact::ForceSettings{});
    }

    /// A lesson may name a preset file next to it. The preset's values become part of recordings and packs of the
    /// lesson.
    void lessonNamesAPresetsFile()
    {
        const support::LessonFolder folder;
        const FeelPreset preset = hardTooth();
        QVERIFY(lessons::writePreset(folder.at("hard.cusppreset"), preset));
        QJsonObject object{{"format", 1},
                           {"based_on", "decay-36-2-moderate.lesson.json"},
                           {"id", "hard-36"},
                           {"caries", "firm"},
                           {"hardness", "hard.cusppreset"}};
        const auto read = [&] { return folder.read("hard.lesson.json", object); };
        const lessons::ReadLesson found = read();
        QVERIFY(support::isSound(found));
        const core::settings::HardnessPreset hardness =
            core::settings::hardnessFor(preset, {false, core::settings::DecayKind::Firm});
        QVERIFY(found.lesson->hardness == hardness);
        QVERIFY(found.uses.contains(folder.at("hard.cusppreset")));
        const lessons::ReadLesson again =
            lessons::readLessonText(QByteArray::fromStdString(found.lesson->json), "recording");
        QVERIFY(support::isSound(again));
        QVERIFY(again.lesson->hardness == hardness);
        QCOMPARE(lessons::presetUsed(again.lesson->hardness->name, false).name, QString("Zähne, hart"));
        // Another content of the preset file gives the lesson another hash.
        FeelPreset other = preset;
        other.enamelRate = 0.9;
        QVERIFY(lessons::writePreset(folder.at("hard.cusppreset"), other));
        QVERIFY(read().lesson->hash != found.lesson->hash);
        folder.write("hard.cusppreset", QByteArray(R"({"force": {"stiffness_n_per_mm": 15}})"));
        for (const char* name : {"hard.cusppreset", "none.cusppreset", "../hard.cusppreset"}) {
            object["hardness"] = name;
            QVERIFY(!read().lesson);
        }
    }
};

CUSP_TEST(TestPresets)
#include "tst_presets.moc"
