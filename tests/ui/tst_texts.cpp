// SPDX-License-Identifier: GPL-3.0-or-later
// Texts for codes and values: every code has its sentence, in all languages.
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QSet>
#include <QTest>
#include <QTranslator>
#include <QXmlStreamReader>

#include "core/bur/Bur.h"
#include "core/preparation/CapturedIdeal.h"
#include "core/preparation/ToothDesign.h"
#include "core/servo/ServoState.h"
#include "core/teeth/Block.h"
#include "core/teeth/ToothBuilder.h"
#include "lessons/LessonCatalog.h"
#include "lessons/LessonReader.h"
#include "lessons/PresetFile.h"
#include "lessons/Rubric.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "ui/admin/AdminWords.h"
#include "ui/kit/Theme.h"
#include "ui/replay/TimeLine.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/PeopleTexts.h"
#include "ui/text/ScanNotes.h"
#include "ui/text/Search.h"
#include "ui/text/Texts.h"
#include "ui/text/ValidationTexts.h"

using core::ErrorCode;
using core::terrain::Material;

namespace {

constexpr int kCodes = static_cast<int>(ErrorCode::ChangedSince) + 1;

/// Words that show that a sentence is English.
const QRegularExpression kEnglish("\\b(is|the|must|there|with|write|missing|leave|which|and|choose|this|from)\\b");

/// Sets the language of the program until the returned object is deleted.
std::unique_ptr<QTranslator> spoken(const QLocale& locale)
{
    auto words = std::make_unique<QTranslator>();
    if (!words->load(locale, "cusp", "_", ":/i18n"))
        qFatal("a language is missing");
    QCoreApplication::installTranslator(words.get());
    return words;
}

struct Entry
{
    QString context;
    QString source;
    QString type;  ///< "unfinished", "vanished" or empty
    bool isPlural = false;
    QStringList translations;  ///< the forms of a plural; otherwise the lines of the text
};

QList<Entry> entriesOf(const QString& file)
{
    QFile ts(file);
    if (!ts.open(QIODevice::ReadOnly))
        return {};
    QXmlStreamReader xml(&ts);
    QList<Entry> entries;
    QString context;
    Entry now;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isEndElement() && xml.name() == u"message")
            entries << now;
        if (!xml.isStartElement())
            continue;
        if (xml.name() == u"name")
            context = xml.readElementText();
        else if (xml.name() == u"message")
            now = Entry{context, {}, {}, xml.attributes().value("numerus") == u"yes", {}};
        else if (xml.name() == u"source")
            now.source = xml.readElementText();
        else if (xml.name() == u"numerusform")
            now.translations << xml.readElementText(QXmlStreamReader::IncludeChildElements);
        else if (xml.name() == u"translation") {
            now.type = xml.attributes().value("type").toString();
            if (!now.isPlural)
                now.translations =
                    xml.readElementText(QXmlStreamReader::IncludeChildElements).split('\n', Qt::SkipEmptyParts);
        }
    }
    return entries;
}

QString tsFile(const QString& language)
{
    return QStringLiteral(CUSP_SOURCE_DIR "/translations/cusp_%1.ts").arg(language);
}

/// Returns a criterion as marking returns it, with 100 points shared with another one.
lessons::Criterion criterion(const std::string& id, std::optional<double> measured, const std::string& unit,
                             lessons::Side side, double target, double tolerance, double span, int weightTenths)
{
    lessons::CriterionRule rule;
    rule.id = rule.measure = id;
    rule.unit = unit;
    rule.side = side;
    rule.target = target;
    rule.tolerance = tolerance;
    rule.span = span;
    rule.weightTenths = weightTenths;
    rule.critical = weightTenths == 0;
    lessons::Rubric rubric;
    rubric.criteria = {rule};
    return lessons::grade(rubric, measured ? lessons::Values{{id, *measured}} : lessons::Values{}).criteria.front();
}

}  // namespace

class TestTexts : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale("en_GB")); }

    void everyErrorCodeHasASentenceOfItsOwn()
    {
        using ui::text::FailedOperation;
        for (const FailedOperation failed :
             {FailedOperation::OpeningScan, FailedOperation::MakingTooth, FailedOperation::OpeningRecording,
              FailedOperation::SavingRecording, FailedOperation::KeepingGrades, FailedOperation::KeepingGrade,
              FailedOperation::KeepingAttempt, FailedOperation::KeepingExam, FailedOperation::ResumingAttempt}) {
            QSet<QString> seen;
            for (int code = 0; code < kCodes; ++code) {
                const QString text =
                    ui::text::errorText({static_cast<ErrorCode>(code), "molar.stl: the exact detail."}, failed);
                QVERIFY2(text.size() > 15 && (text.endsWith('.') || text.endsWith('?')), qPrintable(text));
                QVERIFY2(!text.contains("molar.stl"), "the detail is for who asks");
                seen << text;
            }
            QCOMPARE(seen.size(), kCodes);
        }
    }

    void notesOfAScanAreSentences()
    {
        core::teeth::ToothReport report;
        report.lowMm = {-5.0, -5.0, -12.0};
        report.highMm = {5.0, 5.0, 0.0};
        QVERIFY(ui::text::scanNotes(report).isEmpty());
        report.placement.unitDoubtful = report.placement.upDoubtful = true;
        report.boundaryEdges = report.zeroAreaFaces = report.duplicateFaces = 3;
        report.nonManifoldEdges = report.flippedEdges = report.shellsInsideOut = 1;
        report.shells = 2;
        QSet<QString> seen;
        for (const char* unit : {"mm", "cm", "m", "3.71"}) {
            report.placement.unit.name = unit;
            const QStringList notes = ui::text::scanNotes(report);
            QCOMPARE(notes.size(), 9);
            QVERIFY2(notes.front().contains("12.0"), qPrintable(notes.front()));
            seen << notes.front();
            for (const QString& note : notes) {
                QVERIFY2((note.front().isUpper() || note.front().isDigit()) && note.endsWith('.'), qPrintable(note));
                QVERIFY2(!note.contains("--"), "no command line in the window");
            }
        }
        QCOMPARE(seen.size(), 4);
    }

    void datesFollowTheLanguage_data()
    {
        QTest::addColumn<QString>("locale");
        QTest::addColumn<QString>("words");
        QTest::newRow("en") << "en_GB"
                            << "17/11/2026 14:05|17 Nov|Nov 2026|17 Nov, 1 day late|17 Nov, 5 days late|"
                               "due today 14:05|due Tuesday|due 17/11/2026";
        QTest::newRow("de") << "de_DE"
                            << "17.11.26 14:05|17. Nov.|Nov. 2026|17. Nov., 1 Tag zu spät|17. Nov., 5 Tage zu spät|"
                               "heute fällig, 14:05|fällig: Dienstag|fällig: 17.11.26";
        QTest::newRow("es") << "es_ES"
                            << "17/11/26 14:05|17 nov|nov 2026|17 nov, 1 día de retraso|17 nov, 5 días de retraso|"
                               "vence hoy, 14:05|vence: martes|vence: 17/11/26";
        QTest::newRow("ja") << "ja_JP"
                            << "2026/11/17 14:05|11月17日|2026年11月|11月17日、1 日遅れ|11月17日、5 日遅れ|"
                               "今日 14:05 締切|締切：火曜日|締切：2026/11/17";
    }

    /// The order of day, month and year, their names, and the texts around them.
    void datesFollowTheLanguage()
    {
        QFETCH(QString, locale);
        QFETCH(QString, words);
        const auto back = qScopeGuard([] { QLocale::setDefault(QLocale("en_GB")); });
        QLocale::setDefault(QLocale(locale));
        const auto translator = spoken(QLocale());
        const QDateTime at(QDate(2026, 11, 17), QTime(14, 5));
        const std::string utc = at.toUTC().toString(Qt::ISODate).toStdString();
        QCOMPARE((QStringList{ui::text::when(utc), ui::text::whenShort(utc, at.addDays(30)),
                              ui::text::whenShort(utc, at.addDays(320)), ui::text::dueWords(at, at.addDays(1)),
                              ui::text::dueWords(at, at.addDays(5)), ui::text::dueWords(at, at.addSecs(-3600)),
                              ui::text::dueWords(at, at.addDays(-3)), ui::text::dueWords(at, at.addDays(-30))}),
                 words.split('|'));
    }

    void everyBlockHasATitleOfItsOwn()
    {
        using core::teeth::BlockShape;
        QSet<QString> titles;
        for (int k = 0; k <= static_cast<int>(BlockShape::Junction); ++k) {
            core::teeth::BuildOptions build;
            build.gridSide = 64;
            const auto source = core::teeth::parseSource(core::teeth::blockName(static_cast<BlockShape>(k)));
            const auto built = core::teeth::buildTooth(source, build);
            QVERIFY(built);
            const QString title = ui::text::toothTitle(*built->anatomy);
            QVERIFY2(title.startsWith("Practice block: "), qPrintable(title));
            titles << title;
        }
        QCOMPARE(titles.size(), static_cast<int>(BlockShape::Junction) + 1);
    }

    void whatAnAuditRowIsAboutIsToldInWords()
    {
        const QString sam = "Samantha Katharina Johannes-Featherstonehaugh (s1001)";
        const ui::admin::NamesByUid names{{"1f", sam}, {"2e", sam}, {"class:5", "DEN101-A"}};
        const QDateTime made({2026, 11, 24}, {21, 19, 40}, Qt::UTC);
        for (const auto& [object, words] : std::initializer_list<std::pair<const char*, QString>>{
                 {"backup:backup-2026-11-24-21.19.40",
                  "backup of " + QLocale().toString(made.toLocalTime(), QLocale::ShortFormat)},
                 {"person:1f", sam},
                 {"name:2e", sam},
                 {"name:77", "a name that nobody has"},
                 {"class:5", "DEN101-A"},
                 {"class:6", "class 6"},
                 {"preset:my v2 soft v1", "preset my v2 soft, version 1"},
                 {"backup:before exams", "backup of \"before exams\""},
                 {"attempt:8614f873a47d", "attempt 8614f873a47d"},
                 {"setting:idle.minutes", "when a place that was left is locked"},
                 {"setting:some.thing", "setting some.thing"},
                 {"attempts", "all attempts"},
                 {"robot:1", "robot:1"}}) {
            database::AuditRow row;
            row.object = object;
            QCOMPARE(ui::admin::objectWords(row, names), words);
        }
    }

    void whatACheckFoundIsToldInWords()
    {
        const ui::admin::NamesByUid names{{"1f", "Sam %2 (s1001)"}, {"class:5", "DEN101-A"}};
        const database::IntegrityIssue differs{"%1 differs from the audit: the row of %2 was changed, added or removed",
                                               {"table enrolments", "person:1f"}};
        QCOMPARE(
            differs.english(),
            QString("table enrolments differs from the audit: the row of person:1f was changed, added or removed"));
        QCOMPARE(
            ui::admin::findingWords(differs, names, {}),
            QString(
                "table enrolments differs from the audit: the row of Sam %2 (s1001) was changed, added or removed"));
        const database::IntegrityIssue row{"audit row %1 (%2, %3, %4) is not the one that was signed",
                                           {"9", "2026-11-20T10:15:00Z", "login", "person:1f"}};
        QCOMPARE(ui::admin::findingWords(row, names, {}),
                 QString("audit row 9 (%1, logged in, Sam %2 (s1001)) is not the one that was signed")
                     .replace("%1", ui::text::when("2026-11-20T10:15:00Z")));
        // A lesson is named by its title, if that is known.
        const database::IntegrityIssue standing{"%1 has attempts in %2 and no standing", {"person:1f", "class1-36"}};
        QCOMPARE(ui::admin::findingWords(standing, names, {{"class1-36", "Class I, 36"}}),
                 QString("Sam %2 (s1001) has attempts in Class I, 36 and no standing"));
        QCOMPARE(ui::admin::findingWords(standing, names, {}),
                 QString("Sam %2 (s1001) has attempts in class1-36 and no standing"));
        database::AuditRow assigned;
        assigned.action = "lesson.assign";
        assigned.detail = R"({"lesson": "class1-36"})";
        QCOMPARE(ui::admin::detailWords(assigned, names, {{"class1-36", "Class I, 36"}}), QString("Class I, 36"));
    }

    void faultsAreToldInEveryLanguage_data() { support::rows<QString>("language", {"de", "es", "ja"}); }
    void faultsAreToldInEveryLanguage()
    {
        QFETCH(QString, language);
        const char* lesson = R"({"format": 1, "id": "A b", "title": "", "goal": {"en": 3}, "task": "fly", "grid": 3,
            "tooth": {"scan": "../a.stl", "fdi": 9, "unit": "ell", "up": "x"}, "exam": 1, "minutes": "8", "burs": ["x"],
            "handpieces": ["x"], "aids": ["x"], "hardness": "x", "ideal": {"kind": "x", "captured": "a"}, "version": 1.5,
            "lesion": 1, "touch": {"points": [[99, 0]]}, "rules": {"neighbour_hit": true, "air_limit_s": 0}, "minuts": 1,
            "steps": [1], "rubric": {"id": "r", "criteria": [{"id": "c", "measure": "x", "weight": 1.23}, 2]}})";
        std::vector<lessons::ValidationIssue> faults = lessons::readLessonText(lesson, "a.json").faults;
        QVERIFY(faults.size() > 20);
        for (const QByteArray json :
             {"", "{", "[]", "{\"a\" 1}", "{\"a\": 1, \"a\": 2}", "{\"a\": \"\xFF\"}", "{\"a\": [1}"})
            faults.push_back(lessons::readLessonText(json, "a.json").faults.front());
        for (const QByteArray json :
             {R"({"format": 9})", R"({"kind": "x"})", R"({"name": ""})", R"({"force": {"stiffness_n_per_mm": 15}})",
              R"({"enamel": {"rate_mm3_per_ns": -1}})"})
            faults.push_back(lessons::readPresetText(json, "a.cusppreset").faults.front());
        faults.push_back(*lessons::leftOutFault(lessons::readPresetText("{}", "a.cusppreset")));
        for (const char* rubric :
             {R"({"id": "r", "title": "R"})",
              R"({"id": "r", "title": "R", "criteria": [{"id": "c", "measure": "caries_left_percent",
                                       "weight": 90}]})",
              R"({"id": "r", "title": "R", "criteria": [{"id": "c", "measure": "caries_left_percent",
                                       "weight": 10, "critical": true}]})"}) {
            QByteArray json(
                R"({"format": 1, "id": "a", "title": "A", "goal": "A", "task": "remove_decay", "tooth": {"fdi": 36},
                               "lesion": {"extent": 0.5}, "rubric": %1})");
            faults.push_back(lessons::readLessonText(json.replace("%1", rubric), "a.json").faults.front());
        }
        const auto words = spoken(QLocale(language));
        for (const lessons::ValidationIssue& fault : faults) {
            const QString said = ui::text::faultWords(fault);
            QVERIFY2(said.contains("a.") && said.contains(fault.key), qPrintable(said));
            QVERIFY2(!ui::text::faultWords(fault.what).contains(kEnglish), qPrintable(said));
            QVERIFY2(!said.contains("%"), qPrintable(said));
        }
    }

    void whatCoreRefusesIsToldInEveryLanguage_data() { support::rows<QString>("language", {"de", "es", "ja"}); }
    void whatCoreRefusesIsToldInEveryLanguage()
    {
        using namespace core::preparation;
        QFETCH(QString, language);
        std::vector<core::Error> errors;
        const auto refused = [&](const auto& result) {
            if (!result)
                errors.push_back(result.error());
        };
        refused(core::bur::findBur("x"));
        refused(core::settings::findHandpiece("x"));
        refused(core::settings::findHardnessPreset("x"));
        refused(*core::teeth::findBlock("block:x"));
        refused(findKind("x"));
        refused(usualDesign(Kind::ClassOne, 31));
        refused(capturedFrom({}));
        refused(capturedFrom("x"));
        refused(capturedFrom(toBytes({}).substr(0, 9)));
        const ToothDesign usual = usualDesign(Kind::ClassOne, 36).value();
        for (const auto& [number, value] : {std::pair(&ToothDesign::depthMm, 99.0),
                                            {&ToothDesign::lineAngleMm, usual.burRadiusMm + 0.01},
                                            {&ToothDesign::isthmusMm, 2.0 * usual.burRadiusMm - 0.01}}) {
            ToothDesign design = usual;
            design.*number = value;
            refused(validate(Kind::ClassOne, design));
        }
        using core::teeth::BlockDesign;
        for (const auto& [number, value] :
             {std::pair(&BlockDesign::enamelMm, 9.9), {&BlockDesign::steps, 2.5}, {&BlockDesign::lengthMm, 28.0}}) {
            BlockDesign design;
            design.*number = value;
            refused(core::teeth::validate(design));
        }
        QCOMPARE(errors.size(), std::size_t{15});
        const auto words = spoken(QLocale(language));
        for (const core::Error& error : errors) {
            const QString said = ui::text::faultWords(core::wordsOf(error));
            QVERIFY2(!said.contains(kEnglish) && !said.contains("%"), qPrintable(said));
            QVERIFY2(said != QString::fromStdString(error.detail), qPrintable(said));
        }
    }

    void theGravestTroubleIsTold()
    {
        using namespace core::servo;
        QCOMPARE(ui::text::healthText(0), QString());
        QVERIFY(ui::text::healthText(kDeviceLost | kForceClamped | kRecordGap).contains("handpiece"));
        QVERIFY(ui::text::healthText(kPatchQueueFull | kRecordGap).contains("recording"));
        for (const std::uint32_t alone : {kForceClamped, kPatchQueueFull})
            QVERIFY(!ui::text::healthText(alone).isEmpty());
    }

    void criteriaAreWorkedInNumbers_data()
    {
        using lessons::Side;
        QTest::addColumn<lessons::Criterion>("what");
        QTest::addColumn<QString>("worked");
        QTest::newRow("over what is free") << criterion("a", 3.2, "percent", Side::Over, 0, 1, 30, 600)
                                           << "(3.20 − 1.00 free) / 30.00 % × 60.0 points = 4.4";
        QTest::newRow("at the cap") << criterion("a", 40, "mm3", Side::Over, 0, 4, 20, 400)
                                    << "(40.00 − 4.00 free) / 20.00 mm³ × 40.0 points, at most all of them";
        QTest::newRow("nothing free") << criterion("a", 1.25, "mm3", Side::Over, 0, 0, 20, 400)
                                      << "(1.25) / 20.00 mm³ × 40.0 points = 2.5";
        QTest::newRow("a target, both sides") << criterion("a", 1.95, "mm", Side::Both, 1.5, 0.25, 1, 200)
                                              << "(|1.95 − 1.50| − 0.25 free) / 1.00 mm × 20.0 points = 4.0";
        QTest::newRow("too little") << criterion("a", 1.2, "mm", Side::Under, 1.6, 0.2, 0.4, 100)
                                    << "(1.60 − 1.20 − 0.20 free) / 0.40 mm × 10.0 points = 5.0";
        QTest::newRow("within what is free")
            << criterion("a", 3, "mm3", Side::Over, 0, 4, 20, 400) << "up to 4.00 mm³: nothing lost";
        QTest::newRow("within the band") << criterion("a", 1.6, "mm", Side::Both, 1.5, 0.25, 1, 200)
                                         << "1.50 ± 0.25 mm: nothing lost";
        QTest::newRow("enough") << criterion("a", 1.7, "mm", Side::Under, 1.6, 0.2, 0.4, 100)
                                << "at least 1.40 mm: nothing lost";
        QTest::newRow("at once") << criterion("a", 0.2, "mm2", Side::Over, 0, 0.1, 0, 50)
                                 << "up to 0.10 mm²; beyond it all of its 5.0 points are lost";
        QTest::newRow("critical")
            << criterion("a", 0.2, "mm2", Side::Over, 0, 0, 0, 0)
            << "Allowed: up to 0.00 mm². The attempt fails and the remaining 100.0 points are lost";
        lessons::Criterion capped = criterion("a", 1.2, "mm", Side::Under, 1.4, 0, 0, 0);
        capped.capTenths = 650;
        QTest::newRow("limited") << capped << "Allowed: at least 1.40 mm. The score is limited to 65.0 points";
        capped.measured.reset();
        QTest::newRow("limited, not measured") << capped << "Not measured, so the score is limited to 65.0 points";
        capped.share = 0.0;
        capped.isTooEarly = true;
        capped.once = lessons::Once{"caries_removed_percent", "percent", 50.0};
        QTest::newRow("too early for a limit") << capped << "Counts as soon as 50 % of the decay is removed";
        QTest::newRow("not measured") << criterion("a", {}, "mm", Side::Over, 0, 0, 1, 150)
                                      << "Not measured, so it earns none of its 15.0 points";
        lessons::Criterion early = criterion("a", 0, "mm3", Side::Over, 0, 4, 20, 400);
        early.isTooEarly = true;
        early.lostTenths = 400;
        early.once = lessons::Once{"caries_removed_percent", "percent", 50.0};
        QTest::newRow("too early") << early << "None of its 40.0 points are earned before 50 % of the decay is removed";
        early.once = lessons::Once{"deepest_cut_mm", "mm", 0.5};
        QTest::newRow("too early by another")
            << early << "None of its 40.0 points are earned before deepest_cut_mm has reached 0.5 mm";
    }

    void criteriaAreWorkedInNumbers()
    {
        QFETCH(lessons::Criterion, what);
        QFETCH(QString, worked);
        QCOMPARE(ui::text::criterionWorked(what, lessons::Verdict::SumOfErrors), worked);
    }

    void searchesKnowNoAccents()
    {
        using ui::text::holds;
        using ui::text::holdsEach;
        QVERIFY(holds(QString("Bloque: línea"), "linea") && holds("Bloque: linea", QString("LÍNEA")));
        QVERIFY(holds(QString("Özil Çelik"), "oz") && holds(QString("Straße"), "strasse"));
        QVERIFY(holds("anything", {}) && !holds("line", "lime"));
        QVERIFY(holdsEach(QString("Bloque: círculo"), "circulo bloq") && !holdsEach("Bloque", "bloque linea"));
        // "ga" does not count as "ka" with an accent.
        QVERIFY(!holds(QString("が"), QString("か")) && holds(QString("がか"), QString("が")));
    }

    void teethMaterialsAndBursHaveNames()
    {
        QSet<QString> names;
        QSet<QString> letters;
        for (int k = 0; k < core::terrain::kMaterialCount; ++k) {
            names << ui::text::materialName(static_cast<Material>(k));
            letters << ui::text::materialLetter(static_cast<Material>(k));
        }
        QVERIFY(names.size() == core::terrain::kMaterialCount && letters.size() == core::terrain::kMaterialCount);
        QVERIFY(!names.contains(QString()));
        names.clear();
        for (const int quadrant : {2, 3})
            for (int position = 1; position <= 8; ++position)
                names << ui::text::toothName(10 * quadrant + position);
        QCOMPARE(names.size(), 16);
        QCOMPARE(ui::text::toothName(36), QString("lower left first molar"));
        for (const int fdi : {0, -1, 9, 19, 20, 29, 49, 50, 51, 111})
            QVERIFY2(ui::text::toothName(fdi).isEmpty(), qPrintable(QString::number(fdi)));
        for (const core::bur::Bur& bur : core::bur::burs()) {
            const QString id = QString::fromUtf8(bur.id.data(), static_cast<qsizetype>(bur.id.size()));
            const QString name = ui::text::burName(bur.id);
            QVERIFY2(name != id && name.endsWith(id), qPrintable(name));
        }
        core::terrain::ToothAnatomy tooth;
        QCOMPARE(ui::text::toothTitle(tooth), QString("Tooth without a name"));
        tooth.name = std::string("patient.stl");
        QCOMPARE(ui::text::toothTitle(tooth), QString("patient.stl"));
        tooth.name = std::string("36");
        tooth.fdi = 36;
        QCOMPARE(ui::text::toothTitle(tooth), QString("Tooth 36"));
    }

    void everyBurIsNamedInEveryLanguage_data() { support::rows<QString>("language", {"de", "es", "ja"}); }
    void everyBurIsNamedInEveryLanguage()
    {
        QFETCH(QString, language);
        QStringList sources;
        for (const core::bur::Bur& bur : core::bur::burs()) {
            QString name = ui::text::burName(bur.id);
            name.chop(static_cast<qsizetype>(bur.id.size()));
            sources << name + "%1";
        }
        const auto words = spoken(QLocale(language));
        for (const QString& source : sources)
            QVERIFY2(!words->translate("Bur", source.toUtf8()).isEmpty(),
                     qPrintable(QString("translations/cusp_%1.ts lacks the bur \"%2\": run the target "
                                        "update_translations and fill it in")
                                    .arg(language, source)));
    }

    /// The condition of a criterion is shown in words, not as the id of a measure.
    void conditionsOfShippedRubricsHaveWords()
    {
        int conditions = 0;
        for (const lessons::CatalogEntry& entry : lessons::readCatalog({}))
            for (const lessons::CriterionRule& rule :
                 entry.read.lesson ? entry.read.lesson->rubric.criteria : std::vector<lessons::CriterionRule>()) {
                if (!rule.once)
                    continue;
                ++conditions;
                QVERIFY2(
                    !ui::text::onceWords(*rule.once).contains(QString::fromStdString(rule.once->measure)),
                    (rule.once->measure + " has no words: add a sentence to onceWords() in ui/text/Texts.cpp").c_str());
            }
        QVERIFY(conditions > 0);
    }

    void everyBurHasAColourOfItsOwn()
    {
        const QPalette room = ui::kit::roomPalette();
        QSet<QRgb> colours;
        for (std::size_t k = 0; k < core::bur::burs().size(); ++k) {
            const QColor colour = ui::replay::burColour(static_cast<std::uint8_t>(k));
            QVERIFY2(!colours.contains(colour.rgb()), core::bur::burs()[k].id.c_str());
            colours << colour.rgb();
            QVERIFY2(ui::kit::contrast(colour, room.color(QPalette::Midlight)) >= 3.0, core::bur::burs()[k].id.c_str());
        }
    }

    void numbersFollowTheLanguage()
    {
        const core::LocalizableText fault{"%1 of %2 in %3",
                                          {core::noted("95.5"), core::noted("1.0 MB"), core::noted("a-1.5.json")}};
        lessons::ScoreSheet sheet;
        sheet.criteria = {criterion("a", 3.2, "percent", lessons::Side::Over, 0, 1, 30, 600),
                          criterion("b", 0, "mm2", lessons::Side::Over, 0, 0, 1, 400)};
        sheet.totalTenths = 956;
        lessons::Criterion line;
        line.measure = "overcut_mm3";
        QCOMPARE(ui::text::criterionName(line), QString("overcut_mm3"));
        line.title = {{"en", "Too much"}, {"de", "Zu viel"}};
        const auto words = [&] {
            return QStringList{ui::text::number(-1.5, 2), ui::text::scoreSum(sheet), ui::text::faultWords(fault),
                               ui::text::criterionName(line)};
        };
        QCOMPARE(words(),
                 (QStringList{"−1.50", "100.0 − 4.4 − 0.0 = 95.6", "95.5 of 1.0 MB in a-1.5.json", "Too much"}));
        const auto back = qScopeGuard([] { QLocale::setDefault(QLocale("en_GB")); });
        QLocale::setDefault(QLocale("de_DE"));
        QCOMPARE(words(),
                 (QStringList{"−1,50", "100,0 − 4,4 − 0,0 = 95,6", "95,5 of 1,0 MB in a-1.5.json", "Zu viel"}));
    }

    void everythingIsTranslated_data() { support::rows<QString>("language", {"de", "es", "ja"}); }
    void everythingIsTranslated()
    {
        QFETCH(QString, language);
        static const QRegularExpression tag("</?[a-z][^>]*>");
        static const QRegularExpression mark("%[1-9]|%L?n");
        static const QRegularExpression threeWords(
            "[a-z]{2,} [a-z]{2,} [a-z]{2,}");  // untranslated, if found in Japanese
        const QList<Entry> entries = entriesOf(tsFile(language));
        QVERIFY(entries.size() > 150);
        // Sentences of the lower layers, which are only marked for translation there.
        for (const char* context : {"Finding", "Fault"})
            QVERIFY2(
                std::any_of(entries.begin(), entries.end(), [&](const Entry& one) { return one.context == context; }),
                context);
        for (const Entry& entry : entries) {
            const QString where = entry.context + ": " + entry.source;
            QVERIFY2(entry.type.isEmpty(), qPrintable(where + " is " + entry.type));
            QVERIFY2(!entry.translations.join(QString()).trimmed().isEmpty(),
                     qPrintable(where + " has no translation"));
            for (const QString& form : entry.translations) {
                if (form.trimmed().isEmpty())
                    continue;
                const auto partsOf = [](const QString& words, const QRegularExpression& part) {
                    QStringList parts;
                    for (const auto& match : part.globalMatch(words))
                        parts << match.captured();
                    parts.sort();
                    return parts;
                };
                const auto marksOf = [&](const QString& words) {
                    const QStringList marks = partsOf(words, mark);
                    return QSet<QString>(marks.begin(), marks.end());
                };
                QVERIFY2(partsOf(entry.source, tag) == partsOf(form, tag), qPrintable(entry.source + " / " + form));
                QVERIFY2(marksOf(entry.source) == marksOf(form), qPrintable(entry.source + " / " + form));
                QVERIFY2(language != "ja" || !form.contains(threeWords), qPrintable(form));
            }
        }
    }

    void everyPluralHasAllItsForms_data() { support::rows<QString>("language", {"en", "de", "es", "ja"}); }
    void everyPluralHasAllItsForms()
    {
        QFETCH(QString, language);
        int plurals = 0;
        for (const Entry& entry : entriesOf(tsFile(language))) {
            const QString where = entry.context + ": " + entry.source;
            QVERIFY2(entry.isPlural == (entry.source.contains("%n") || entry.source.contains("%Ln")),
                     qPrintable(where));
            QVERIFY2(entry.isPlural || language != "en", "English is written down for its plurals only");
            if (!entry.isPlural)
                continue;
            ++plurals;
            QVERIFY2(entry.translations.size() == (language == "ja" ? 1 : 2), qPrintable(where));
            for (const QString& form : entry.translations)
                QVERIFY2(!form.trimmed().isEmpty(), qPrintable(where + " lacks a form"));
        }
        QVERIFY(plurals > 50);
    }

    /// Neither the program nor the shipped lessons address the user in the familiar form. An imperative can only be
    /// recognized if it begins a sentence with a verb that the texts use.
    void nobodyIsSpokenToLikeAChild()
    {
        for (const auto& [language, familiar] :
             {std::pair("de", "\\b([Dd]u|[Dd]ich|[Dd]ir|[Dd]ein(e[mnrs]?)?)\\b|(^|[.:;!?] )(Achte|Beginne|Bleib|"
                              "Drücke|Entferne|Folge|Führe|Geh|Halte|Hebe|Lass|Nimm|Öffne|Präpariere|Senke|Setze|Sieh|"
                              "Wähle|Zeige) "),
              {"es", "\\b([Tt]ú|[Tt]us?|[Tt]e|[Tt]i|[Cc]ontigo|[Tt]uy[oa]s?)\\b|\\b([Pp]uedes|[Qq]uieres|[Hh]as|"
                     "[Ee]stás)\\b|(^|[.:;!?] )(Abre|Busca|Elige|Espera|Haz clic|Inténtalo|Mira|Pulsa|Presiona|Sigue|"
                     "Talla|Toca|Usa|Vuelve) "}}) {
            const QRegularExpression isFamiliar(familiar, QRegularExpression::UseUnicodePropertiesOption);
            for (const Entry& entry : entriesOf(tsFile(language)))
                for (const QString& form : entry.translations)
                    QVERIFY2(!form.contains(isFamiliar), qPrintable(form));
            const QRegularExpression inLesson(QStringLiteral("\"%1\": \"([^\"]*)\"").arg(language));
            int found = 0;
            const QDir lessons(QStringLiteral(CUSP_SOURCE_DIR "/lessons/data"));
            for (const QString& name : lessons.entryList({"*.json"}, QDir::Files)) {
                QFile file(lessons.filePath(name));
                QVERIFY(file.open(QIODevice::ReadOnly));
                for (const auto& match : inLesson.globalMatch(QString::fromUtf8(file.readAll()))) {
                    ++found;
                    QVERIFY2(!match.captured(1).contains(isFamiliar), qPrintable(name + ": " + match.captured(1)));
                }
            }
            QVERIFY(found > 100);
        }
    }

    /// In each language, the letter of a side must differ from that of the tissue whose English letter is the same.
    void lettersDifferInEveryLanguage_data() { support::rows<QString>("language", {"de", "es", "ja"}); }
    void lettersDifferInEveryLanguage()
    {
        QFETCH(QString, language);
        const auto words = spoken(QLocale(language));
        QSet<QString> letters;
        for (int k = 0; k < core::terrain::kMaterialCount; ++k)
            letters << ui::text::materialLetter(static_cast<Material>(k));
        QCOMPARE(letters.size(), core::terrain::kMaterialCount);
        if (language == "ja")
            QCOMPARE(ui::text::surfaceLetters(26), QStringList({"M", "D", "P", "B", "", "O"}));
    }
};

CUSP_TEST(TestTexts)
#include "tst_texts.moc"
