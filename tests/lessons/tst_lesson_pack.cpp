// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QStandardPaths>
#include <QTest>

#include "core/recording/Format.h"
#include "core/teeth/ToothBuilder.h"
#include "lessons/Assignment.h"
#include "lessons/IdealFromRecordings.h"
#include "lessons/LessonCatalog.h"
#include "lessons/LessonPack.h"
#include "tests/fuzz/Exercises.h"
#include "tests/lessons/LessonFolder.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using namespace lessons;
using support::isSound;
using support::says;
using support::sentencesOf;

/// A lesson with a captured ideal, and lessons in a pack.

class TestLessonPack : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void init() { m_folder.emplace(); }

    void aCapturedIdealEarnsFullPointsOnItself()
    {
        writeCaptured("own.cuspideal");
        const ReadLesson read = m_folder->read("own.lesson.json", lesson());
        QVERIFY(isSound(read));
        const auto assigned = assign(*read.lesson);
        QVERIFY(support::succeeds(assigned));
        const Assignment& assignment = assigned->assignment;
        const auto marked = mark(assignment, core::terrain::restored(assignment.anatomy, *assignment.ideal->top));
        QVERIFY(marked);
        for (const Criterion& line : marked->sheet.criteria)
            QVERIFY2(line.lostTenths == 0 && line.measured, line.id.c_str());
        QCOMPARE(marked->sheet.totalTenths, kFullTenths);
        QVERIFY(!mark(assignment, core::terrain::Tooth(assignment.anatomy))->sheet.passed());
    }

    void aRecordingTakesTheCapturedIdealAlong()
    {
        const QString ideal = writeCaptured("own.cuspideal");
        const ReadLesson read = m_folder->read("own.lesson.json", lesson());
        const Assignment assignment = assign(*read.lesson)->assignment;
        QVERIFY(core::recording::checkLesson(read.lesson->json));
        const core::recording::Recording recording({}, assignment.anatomy, read.lesson->json);
        QFile::remove(ideal);
        const auto again = core::recording::Recording::fromBytes(recording.toBytes());
        const auto marked = markAgain(*again);
        QVERIFY(support::succeeds(marked));
        QVERIFY(marked->mark.measured.deviation->idealMm3 > 5.0);
        const auto text = readLessonText(QByteArray::fromStdString(read.lesson->json), QStringLiteral("text"));
        QVERIFY2(text.lesson, qPrintable(sentencesOf(text)));
        QVERIFY(*text.lesson == *read.lesson);
    }

    void faultsOfACapturedIdealNameFileAndKey()
    {
        const auto saysOf = [&](const QByteArray& content, const char* words) {
            m_folder->write("own.cuspideal", content);
            const ReadLesson read = m_folder->read("own.lesson.json", lesson());
            QVERIFY(!read.lesson);
            QVERIFY(support::says(read, "own.lesson.json, ideal.captured: \"own.cuspideal\"") &&
                    support::says(read, words));
        };
        const QByteArray good = QByteArray::fromStdString(core::preparation::toBytes(captured()));
        saysOf(QByteArray(), "is empty");
        saysOf("hello", "not a captured ideal");
        saysOf(good.left(good.size() / 2), "ends early");
        QByteArray flipped = good;
        flipped[100] = static_cast<char>(flipped[100] ^ 4);
        saysOf(flipped, "is damaged");
        saysOf(QByteArray(10 * 1024 * 1024, 'x'), "has 10.0 MB");
        QFile::remove(m_folder->at("own.cuspideal"));
        QVERIFY(says(m_folder->read("own.lesson.json", lesson()), "there is no file \"own.cuspideal\""));
        QJsonObject out = lesson();
        out["ideal"] = QJsonObject{{"captured", "../own.cuspideal"}};
        QVERIFY(says(m_folder->read("own.lesson.json", out), "leads out of the lesson's folder"));
        // An ideal captured on another tooth or another grid is refused.
        m_folder->write("own.cuspideal", good);
        for (const auto& [key, value] :
             {std::pair<const char*, QJsonValue>{"tooth", QJsonObject{{"fdi", 36}, {"seed", 5}}}, {"grid", 151}}) {
            QJsonObject other = lesson();
            other[QLatin1String(key)] = value;
            const ReadLesson read = m_folder->read("own.lesson.json", other);
            QVERIFY(!read.lesson);
            QVERIFY(says(read, "own.lesson.json, ideal.captured: \"own.cuspideal\" was captured on the tooth '36' "
                               "(seed 0, grid "));
        }
    }

    void aCapturedIdealTakesThePlaceOfARule()
    {
        writeCaptured("own.cuspideal");
        QJsonObject object{{"format", 1},
                           {"based_on", "ideal-1-class1-1-36.lesson.json"},
                           {"id", "own"},
                           {"ideal", QJsonObject{{"captured", "own.cuspideal"}}}};
        QVERIFY(says(m_folder->read("own.lesson.json", object), "\"kind\": null"));
        object["ideal"] = QJsonObject{{"captured", "own.cuspideal"}, {"kind", QJsonValue()}, {"sizes", QJsonValue()}};
        const ReadLesson read = m_folder->read("own.lesson.json", object);
        QVERIFY2(read.lesson, qPrintable(sentencesOf(read)));
        QVERIFY(read.lesson->ideal->captured && read.lesson->ideal->kind.empty());
    }

    void theHashKnowsTheCapturedIdeal()
    {
        writeCaptured("own.cuspideal");
        const QString file = m_folder->write("own.lesson.json", lesson());
        const std::string first = readLesson(file).lesson->hash;
        QCOMPARE(readLesson(file).lesson->hash, first);
        auto other = captured();
        other.heightsMm.front() -= 0.01F;
        m_folder->write("own.cuspideal", QByteArray::fromStdString(core::preparation::toBytes(other)));
        QVERIFY(readLesson(file).lesson->hash != first);
    }

    void tolerancesGoIntoTheRubric()
    {
        QFile shipped(QStringLiteral(":/lessons/class1.rubric.json"));
        QVERIFY(shipped.open(QIODevice::ReadOnly));
        const core::preparation::Tolerances wanted{0.12, 0.34, 3.5, 0.07};
        QJsonObject object = lesson();
        writeCaptured("own.cuspideal");
        object["rubric"] = withTolerances(QJsonDocument::fromJson(shipped.readAll()).object(), wanted);
        const ReadLesson read = m_folder->read("own.lesson.json", object);
        QVERIFY2(read.lesson, qPrintable(sentencesOf(read)));
        QVERIFY(tolerancesOf(read.lesson->rubric) == wanted);
        QVERIFY(tolerancesOf(Rubric{}, wanted) == wanted);
    }

    void aPackHoldsAllThatItsLessonsNeed()
    {
        const QString file = writeLesson();
        const auto bytes = packLessons({file, file});
        QVERIFY(support::succeeds(bytes));
        const auto files = unpackLessons(*bytes);
        QVERIFY(support::succeeds(files));
        QStringList names;
        for (const PackedFile& packedFile : *files)
            names << packedFile.name;
        names.sort();
        QCOMPARE(names, (QStringList{"own.base.json", "own.cuspideal", "own.lesson.json", "parts/own.rubric.json"}));
        QTemporaryDir elsewhere;
        QVERIFY(putInto(elsewhere.filePath("mine"), *files));
        const ReadLesson there = readLesson(elsewhere.filePath("mine/own.lesson.json"));
        QVERIFY2(there.lesson, qPrintable(sentencesOf(there)));
        QCOMPARE(there.lesson->hash, readLesson(file).lesson->hash);
    }

    void anExpertsRecordingGoesAlong()
    {
        QJsonObject object = lesson();
        writeCaptured("own.cuspideal");
        object["expert"] = QJsonObject{{"recording", "expert.cusprec"}};
        m_folder->write("expert.cusprec", QByteArray("an attempt"));
        QTemporaryDir elsewhere;
        const ReadLesson there = packedTo(elsewhere, object);
        QVERIFY2(there.lesson, qPrintable(sentencesOf(there)));
        QCOMPARE(QString::fromStdString(there.lesson->expert->file), elsewhere.filePath("expert.cusprec"));
    }

    void aHardnessPresetGoesAlong()
    {
        core::settings::FeelPreset preset = shippedPresets().front();
        preset.name = "second year";
        QVERIFY(writePreset(m_folder->at("second-year.cusppreset"), preset));
        QJsonObject object = lesson();
        writeCaptured("own.cuspideal");
        object["hardness"] = "second-year.cusppreset";
        QTemporaryDir elsewhere;
        const ReadLesson there = packedTo(elsewhere, object);
        QVERIFY2(there.lesson && there.lesson->hardness, qPrintable(sentencesOf(there)));
        QVERIFY(QString::fromStdString(there.lesson->hardness->name).startsWith("second year v2"));
    }

    /// With CUSP_REWRITE_CORPUS=1, writes the seeds of the fuzzer again.
    void corpusOfTheFuzzerIsHarmless()
    {
        if (support::rewritesSeeds()) {
            for (const char* name : {"0-orientation-1-touch", "0-orientation-2-hold", "0-orientation-3-layers",
                                     "decay-36-1-small", "block-3-cross", "ideal-1-class1-1-36"})
                support::writeSeed("lesson", name,
                                   readLesson(QStringLiteral(":/lessons/%1.lesson.json").arg(name)).lesson->json);
            m_folder->write("small.lesson.json",
                            QJsonObject{{"format", 1}, {"based_on", "ideal-1-class1-1-36.lesson.json"}});
            const QByteArray small = packLessons({m_folder->at("small.lesson.json")}).value();
            support::writeSeed("pack", "small", small.toStdString());
            support::writeSeed("pack", "unpacked",
                               core::recording::unpack(small.toStdString(), kLargestPackBytes).value());
        }
        QVERIFY(support::forEachSeed("lesson", fuzz::exerciseLesson));
        QVERIFY(support::forEachSeed("pack", fuzz::exercisePack));
    }

    void aPackInTheFolderIsOffered()
    {
        const auto bytes = packLessons({writeLesson()});
        QTemporaryDir teachers;
        support::write(teachers.filePath("course.cusplessons"), bytes->toStdString());
        support::write(teachers.filePath("damaged.cusplessons"), bytes->left(bytes->size() / 2).toStdString());
        const auto shipped = readCatalog({}).size();
        auto entries = readCatalog(teachers.path());
        QCOMPARE(entries.size(), shipped + 2);
        const CatalogEntry& offered = entries[shipped];
        QVERIFY2(offered.read.lesson && offered.read.lesson->id == "own-36", qPrintable(sentencesOf(offered.read)));
        QVERIFY(assign(*offered.read.lesson));
        QVERIFY(entries.back().isFaulty() && says(entries.back().read, "damaged.cusplessons"));
        // If the pack has also been unpacked next to it, its lessons are listed once.
        QVERIFY(putInto(teachers.path(), *unpackLessons(*bytes)));
        QCOMPARE(readCatalog(teachers.path()).size(), shipped + 2);
    }

    void whatWasUnpackedStandsForThePack()
    {
        const auto bytes = packLessons({writeLesson()});
        QTemporaryDir teachers;
        const QString pack = teachers.filePath("course.cusplessons");
        support::write(pack, bytes->toStdString());
        QCOMPARE(readCatalog(teachers.path()).back().pack, pack);
        QVERIFY(putInto(teachers.path(), *unpackLessons(*bytes)));
        const QString own = teachers.filePath("own.lesson.json");
        const std::string unpacked = support::bytesOf(own.toStdString());
        QJsonObject changed = QJsonDocument::fromJson(QByteArray::fromStdString(unpacked)).object();
        changed["minutes"] = 3;
        support::write(own, QJsonDocument(changed).toJson().toStdString());
        const auto entries = readCatalog(teachers.path());
        QCOMPARE(entries.size(), readCatalog({}).size() + 1);
        QVERIFY2(entries.back().read.lesson && entries.back().pack.isEmpty(),
                 qPrintable(sentencesOf(entries.back().read)));
        QCOMPARE(entries.back().read.lesson->minutes, 3.0);
    }

    void aFaultNamesThePack()
    {
        QTemporaryDir teachers;
        const QByteArray bytes = packed(pack({entry("odd.lesson.json", "{\"format\": 1}")}));
        support::write(teachers.filePath("course.cusplessons"), bytes.toStdString());
        const ReadLesson read = readCatalog(teachers.path()).back().read;
        QVERIFY(says(read, "odd.lesson.json, ") && says(read, "(in the pack course.cusplessons)"));
    }

    void theCacheIsNotTrusted()
    {
        const auto bytes = packLessons({writeLesson()});
        const QString pack = m_folder->write("course.cusplessons", *bytes);
        const auto folder = openPack(pack);
        QVERIFY(folder);
        const QString ideal = QDir(*folder).filePath("own.cuspideal");
        QVERIFY(QFile::remove(ideal));
        QCOMPARE(*openPack(pack), *folder);
        QVERIFY(QFile::exists(ideal));
        const QString changed = QDir(*folder).filePath("own.lesson.json");
        support::write(changed, "{}");
        QVERIFY(openPack(pack));
        QVERIFY(readLesson(changed).lesson);
    }

    void unpackingOverwritesNothing()
    {
        const auto files = *unpackLessons(*packLessons({writeLesson()}));
        QVERIFY(putInto(m_folder->path(), files));  // the folder has the same files as the pack
        m_folder->write("own.base.json", QByteArray("mine"));
        QFile::remove(m_folder->at("own.cuspideal"));
        QVERIFY(support::isRefused(putInto(m_folder->path(), files), "own.base.json"));
        QVERIFY(!QFileInfo::exists(m_folder->at("own.cuspideal")));  // nothing was written
    }

    void whatCannotBeUnpackedWholeLeavesNothing()
    {
        // The second file cannot be written, as on a full disk: its name is longer than any file system allows.
        const QString tooLong = QString(240, u'x') + QStringLiteral(".longer.than.names.may.be.json");
        QVERIFY(!putInto(m_folder->path(), {{"first.json", "{}"}, {tooLong, "{}"}}));
        QVERIFY(QDir(m_folder->path()).isEmpty());
        QVERIFY(putInto(m_folder->path(), {{"first.json", "{}"}, {"second.json", "{}"}}));
    }

    void refusesNamesThatLeadElsewhere_data()
    {
        support::rows<QString>("name", {"../a.json", "/etc/a.json", "a/../../b.json", "C:\\a.json", ":/lessons/a.json",
                                        "", ".bashrc.json", "a/.hidden/b.json", "a//b.json", "run.sh", "a.json/",
                                        "C:a.json", "tab\t.json", "a.desktop", "turned\u202Enosj.json"});
    }

    void refusesNamesThatLeadElsewhere()
    {
        QFETCH(QString, name);
        const auto refused = unpackLessons(packed(pack({entry("good.json", "{}"), entry(name, "x")})));
        QVERIFY(support::isRefused(refused, "leads out of its folder"));
        for (const QChar letter : QString::fromStdString(refused.error().detail))
            QVERIFY(letter.isPrint());
    }

    void refusesAWrongHash()
    {
        QJsonObject wrong = entry("a.json", "{}");
        wrong["sha256"] = entry("a.json", "{ }")["sha256"];
        QVERIFY(support::isRefused(unpackLessons(packed(pack({wrong}))), "not what its hash says"));
        wrong = entry("a.json", "{}");
        wrong["base64"] = "e30=*";
        QVERIFY(!unpackLessons(packed(pack({wrong}))));
        QVERIFY(!unpackLessons(packed(pack({entry("a.json", "{}"), entry("A.json", "{}")}))));
    }

    void refusesABomb()
    {
        // 200 MB of spaces, packed into a few kilobytes.
        std::string nothing;
        nothing.resize(200'000'000, ' ');
        const QByteArray bomb = QByteArray::fromStdString(core::recording::pack(nothing));
        QVERIFY(bomb.size() < 100'000);
        QVERIFY(support::isRefused(unpackLessons(bomb), "more than 64.0 MB"));
        // Millions of values, which would take a gigabyte when they are parsed.
        const std::string values = R"({"format":1,"cusp":"lessons","files":[0)";
        for (const char* one : {",0", "],[", ",\"\""}) {
            std::string bombText = values;
            for (int k = 0; k < 1'000'000; ++k)
                bombText += one;
            QVERIFY(support::isRefused(unpackLessons(QByteArray::fromStdString(core::recording::pack(bombText + "]}"))),
                                       "no pack of lessons"));
        }
        QJsonArray many;
        for (int k = 0; k < 600; ++k)
            many << entry(QStringLiteral("%1.json").arg(k), "{}");
        QVERIFY(support::isRefused(unpackLessons(packed(pack(many))), "600 files"));
        QVERIFY(!unpackLessons(packed(pack({}))));
    }

    void truncatedOrFlippedIsRefused()
    {
        const QByteArray whole = *packLessons({m_folder->write("own.lesson.json", [] {
            QJsonObject plain = lesson();
            plain["ideal"] = QJsonObject{{"kind", "class1"}};
            return plain;
        }())});
        for (qsizetype length = 0; length < whole.size(); ++length)
            QVERIFY(!unpackLessons(whole.left(length)));
        QByteArray bytes = whole;
        int accepted = 0;
        for (qsizetype k = 0; k < bytes.size(); ++k)
            for (int bit = 0; bit < 8; ++bit) {
                bytes[k] = static_cast<char>(bytes[k] ^ (1 << bit));
                // A flipped bit that changes no file, such as an unused bit of the frame's header, is harmless.
                if (const auto files = unpackLessons(bytes)) {
                    ++accepted;
                    QCOMPARE(files->size(), std::size_t{1});
                    QCOMPARE(files->front().content, unpackLessons(whole)->front().content);
                }
                bytes[k] = static_cast<char>(bytes[k] ^ (1 << bit));
            }
        qInfo("%d of %d flipped bits changed no file", accepted, static_cast<int>(8 * bytes.size()));
    }

    void refusesANewerFormat()
    {
        QJsonObject newer = pack({entry("a.json", "{}")});
        newer["format"] = 2;
        QVERIFY(unpackLessons(packed(newer)).error().code == core::ErrorCode::NewerVersion);
        QVERIFY(unpackLessons(packed(QJsonObject{{"format", 1}})).error().code == core::ErrorCode::WrongKind);
        QVERIFY(unpackLessons("hello").error().code == core::ErrorCode::WrongKind);
    }

    void refusesLinks()
    {
        QTemporaryDir outside;
        QVERIFY(QFile::link(outside.path(), m_folder->at("sub")));
        QVERIFY(support::isRefused(putInto(m_folder->path(), {{"sub/a.json", "{}"}}), "is a link to elsewhere"));
        QVERIFY(!QFileInfo::exists(outside.filePath("a.json")));
    }

    void aFaultyLessonIsNotPacked()
    {
        QJsonObject faulty = lesson();
        faulty["grid"] = 3;
        QVERIFY(support::isRefused(packLessons({m_folder->write("faulty.lesson.json", faulty)}),
                                   "faulty.lesson.json, grid"));
        QVERIFY(!packLessons({}));
        QVERIFY(!packLessons({m_folder->at("none.lesson.json")}));
        QJsonObject scanned = lesson();
        m_folder->write("noise.stl", QByteArray("no mesh at all"));
        scanned["tooth"] = QJsonObject{{"fdi", 36}, {"scan", "noise.stl"}};
        scanned.remove("ideal");
        scanned["task"] = "remove_decay";
        scanned["lesion"] = QJsonObject{{"extent", 0.5}};
        scanned["rubric"] = "decay_removal";
        QVERIFY(support::isRefused(packLessons({m_folder->write("scanned.lesson.json", scanned)}), "noise.stl"));
    }

private:
    /// Packs a lesson, unpacks it elsewhere, and reads it there.
    ReadLesson packedTo(const QTemporaryDir& elsewhere, const QJsonObject& object) const
    {
        const auto bytes = packLessons({m_folder->write("own.lesson.json", object)}).value();
        if (!putInto(elsewhere.path(), unpackLessons(bytes).value()))
            qFatal("not unpacked");
        return readLesson(elsewhere.filePath("own.lesson.json"));
    }
    /// Returns the ideal of the shipped Class I lesson on tooth 36 as a captured ideal.
    static core::preparation::CapturedIdeal captured()
    {
        const Lesson lesson = *readLesson(QStringLiteral(":/lessons/ideal-1-class1-1-36.lesson.json")).lesson;
        const Assignment assignment = assign(lesson)->assignment;
        const core::terrain::Tooth tooth = core::terrain::restored(assignment.anatomy, *assignment.ideal->top);
        const core::terrain::Tooth* const one = &tooth;
        return *core::preparation::capture(std::span(&one, 1), {}, {"shown.cusprec"});
    }
    QString writeCaptured(const QString& name) const
    {
        const std::string bytes = core::preparation::toBytes(captured());
        return m_folder->write(name, QByteArray::fromStdString(bytes));
    }
    static QJsonObject lesson()
    {
        return {{"format", 1},
                {"id", "own-36"},
                {"title", "Own"},
                {"goal", "Cut as shown."},
                {"task", "cut_ideal"},
                {"tooth", QJsonObject{{"fdi", 36}, {"seed", 0}}},
                {"ideal", QJsonObject{{"captured", "own.cuspideal"}}},
                {"rubric", "class1"}};
    }
    /// Writes a lesson with a base, a rubric of its own and a captured ideal. Returns its path.
    QString writeLesson() const
    {
        writeCaptured("own.cuspideal");
        QFile shipped(QStringLiteral(":/lessons/class1.rubric.json"));
        if (!shipped.open(QIODevice::ReadOnly))
            qFatal("a rubric is missing");
        m_folder->write("parts/own.rubric.json", shipped.readAll());
        QJsonObject base = lesson();
        base["rubric"] = "parts/own.rubric.json";
        m_folder->write("own.base.json", base);
        return m_folder->write("own.lesson.json", QJsonObject{{"format", 1}, {"based_on", "own.base.json"}});
    }
    static QByteArray packed(const QJsonObject& pack)
    {
        return QByteArray::fromStdString(core::recording::pack(QJsonDocument(pack).toJson().toStdString()));
    }
    static QJsonObject entry(const QString& name, const QByteArray& content)
    {
        return {{"name", name},
                {"sha256", QString::fromLatin1(QCryptographicHash::hash(content, QCryptographicHash::Sha256).toHex())},
                {"base64", QString::fromLatin1(content.toBase64())}};
    }
    static QJsonObject pack(const QJsonArray& files) { return {{"format", 1}, {"cusp", "lessons"}, {"files", files}}; }

    std::optional<support::LessonFolder> m_folder;
};

CUSP_TEST(TestLessonPack)
#include "tst_lesson_pack.moc"
