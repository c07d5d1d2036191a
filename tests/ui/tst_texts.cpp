// SPDX-License-Identifier: GPL-3.0-or-later
// Codes and values in words: every code has its sentence, in both languages.
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QSet>
#include <QTest>
#include <QTranslator>
#include <QXmlStreamReader>

#include "core/drilling/Bur.h"
#include "core/session/Links.h"
#include "ui/text/Texts.h"

using core::ErrorCode;
using core::terrain::Material;

class TestTexts : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale("en_GB")); }
    void everyErrorCodeHasASentenceOfItsOwn();
    void errorsSpeakOfWhatWasDone();
    void notesOfAScanAreSentences();
    void everyMaterialHasANameAndALetterOfItsOwn();
    void allSixteenTeethHaveNames();
    void whatIsNoToothHasNoName_data();
    void whatIsNoToothHasNoName();
    void aScanIsCalledByItsFile();
    void everyBurHasAName();
    void theGravestTroubleIsTold();
    void criteriaAreWorkedInNumbers_data();
    void criteriaAreWorkedInNumbers();
    void theSumIsExactAlsoBelowZero();
    void numbersFollowTheLanguage();
    void germanIsComplete();
    void germanPlaceholdersMatch();
    void germanIsEmbedded();
};

namespace {

constexpr std::array kAllCodes{ErrorCode::FileMissing,  ErrorCode::FileUnreadable, ErrorCode::FileUnwritable,
                               ErrorCode::FileEmpty,    ErrorCode::FileTruncated,  ErrorCode::FileTooLarge,
                               ErrorCode::WrongKind,    ErrorCode::NewerVersion,   ErrorCode::BadNumber,
                               ErrorCode::BadStructure, ErrorCode::NoTriangles,    ErrorCode::UnknownName,
                               ErrorCode::OutOfRange};
static_assert(kAllCodes.size() == static_cast<std::size_t>(ErrorCode::OutOfRange) + 1, "a new code needs a sentence");

struct Entry
{
    QString context;
    QString source;
    QString type;  ///< "unfinished", "vanished" or empty
    QStringList translations;
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
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == u"name")
            context = xml.readElementText();
        else if (xml.name() == u"message")
            now = Entry{context, {}, {}, {}};
        else if (xml.name() == u"source")
            now.source = xml.readElementText();
        else if (xml.name() == u"translation") {
            now.type = xml.attributes().value("type").toString();
            const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
            now.translations << text.split('\n', Qt::SkipEmptyParts);
            entries << now;
        }
    }
    return entries;
}

QString germanFile()
{
    return QStringLiteral(CUSP_SOURCE_DIR "/translations/cusp_de.ts");
}

lessons::Criterion criterion(std::string_view id, double measured, std::string_view unit, double free, double perUnit,
                             int most)
{
    lessons::Criterion c;
    c.id = std::string(id);
    c.measured = measured;
    c.unit = std::string(unit);
    c.free = free;
    c.pointsPerUnit = perUnit;
    c.rule = perUnit > 0.0 ? lessons::PointRule::PerUnit : lessons::PointRule::Once;
    c.maxPoints = most;
    c.pointsLost = lessons::pointsLostBy(c);
    return c;
}

}  // namespace

void TestTexts::everyErrorCodeHasASentenceOfItsOwn()
{
    using ui::text::Failed;
    for (const Failed failed :
         {Failed::OpeningScan, Failed::MakingTooth, Failed::OpeningRecording, Failed::SavingRecording,
          Failed::KeepingGrades, Failed::KeepingAttempt, Failed::ResumingAttempt}) {
        QSet<QString> seen;
        for (const ErrorCode code : kAllCodes) {
            const QString text = ui::text::errorText({code, "molar.stl: the exact detail."}, failed);
            QVERIFY2(text.size() > 15 && (text.endsWith('.') || text.endsWith('?')), qPrintable(text));
            QVERIFY2(!text.contains("molar.stl"), "the detail is for who asks");
            seen << text;
        }
        QCOMPARE(seen.size(), static_cast<qsizetype>(kAllCodes.size()));
    }
}

void TestTexts::errorsSpeakOfWhatWasDone()
{
    using ui::text::Failed;
    const core::Error error{ErrorCode::WrongKind, {}};
    QVERIFY(ui::text::errorText(error, Failed::OpeningScan).contains("scan"));
    for (const Failed failed : {Failed::OpeningRecording, Failed::KeepingGrades, Failed::ResumingAttempt})
        for (const ErrorCode code : {ErrorCode::WrongKind, ErrorCode::FileTruncated, ErrorCode::FileEmpty,
                                     ErrorCode::FileTooLarge, ErrorCode::BadStructure})
            QVERIFY(!ui::text::errorText({code, {}}, failed).contains("scan", Qt::CaseInsensitive));
    QVERIFY(ui::text::errorText(error, Failed::KeepingGrades).contains("Grades will not be kept"));
}

void TestTexts::notesOfAScanAreSentences()
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

void TestTexts::everyMaterialHasANameAndALetterOfItsOwn()
{
    QSet<QString> names;
    QSet<QString> letters;
    for (int k = 0; k < core::terrain::kMaterialCount; ++k) {
        names << ui::text::materialName(static_cast<Material>(k));
        letters << ui::text::materialLetter(static_cast<Material>(k));
    }
    QCOMPARE(names.size(), core::terrain::kMaterialCount);
    QCOMPARE(letters.size(), core::terrain::kMaterialCount);
    QVERIFY(!names.contains(QString()));
}

void TestTexts::allSixteenTeethHaveNames()
{
    QSet<QString> names;
    for (const int quadrant : {2, 3})
        for (int position = 1; position <= 8; ++position)
            names << ui::text::toothName(10 * quadrant + position);
    QCOMPARE(names.size(), 16);
    QCOMPARE(ui::text::toothName(36), QString("lower left first molar"));
    QCOMPARE(ui::text::toothName(21), QString("upper left central incisor"));
}

void TestTexts::whatIsNoToothHasNoName_data()
{
    QTest::addColumn<int>("fdi");
    for (const int fdi : {0, -1, 9, 19, 20, 29, 49, 50, 51, 111})
        QTest::addRow("%d", fdi) << fdi;
}

void TestTexts::whatIsNoToothHasNoName()
{
    QFETCH(int, fdi);
    QCOMPARE(ui::text::toothName(fdi), QString());
}

void TestTexts::aScanIsCalledByItsFile()
{
    core::terrain::ToothAnatomy tooth;
    QCOMPARE(ui::text::toothTitle(tooth), QString("Tooth without a name"));
    tooth.name = std::string("patient.stl");
    QCOMPARE(ui::text::toothTitle(tooth), QString("patient.stl"));
    tooth.name = std::string("36");
    tooth.fdi = 36;
    QCOMPARE(ui::text::toothTitle(tooth), QString("Tooth 36"));
}

void TestTexts::everyBurHasAName()
{
    for (const core::drilling::Bur& bur : core::drilling::burs()) {
        const QString id = QString::fromUtf8(bur.id.data(), static_cast<qsizetype>(bur.id.size()));
        const QString name = ui::text::burName(bur.id);
        QVERIFY2(name != id && name.endsWith(id), qPrintable(name));
    }
    QCOMPARE(ui::text::burName("9999"), QString("9999"));
}

void TestTexts::theGravestTroubleIsTold()
{
    using namespace core::session;
    QCOMPARE(ui::text::healthText(0), QString());
    QVERIFY(ui::text::healthText(kDeviceLost | kForceClamped | kRecordGap).contains("handpiece"));
    QVERIFY(ui::text::healthText(kPatchQueueFull | kRecordGap).contains("recording"));
    QVERIFY(!ui::text::healthText(kForceClamped).isEmpty());
    QVERIFY(!ui::text::healthText(kPatchQueueFull).isEmpty());
}

void TestTexts::criteriaAreWorkedInNumbers_data()
{
    QTest::addColumn<lessons::Criterion>("what");
    QTest::addColumn<QString>("worked");
    QTest::newRow("over the free part") << criterion("caries_left", 3.2, "%", 1, 2, 60)
                                        << "(3.20 − 1.00 free) % × 2 points = 4.40, rounded 4";
    QTest::newRow("at the cap") << criterion("sound_tissue", 40, "mm3", 4, 2, 40)
                                << "(40.00 − 4.00 free) mm³ × 2 points = 72.00, at most 40";
    QTest::newRow("nothing free") << criterion("sound_tissue", 1.25, "mm3", 0, 2, 40)
                                  << "1.25 mm³ × 2 points = 2.50, rounded 3";
    QTest::newRow("within what is free") << criterion("sound_tissue", 3, "mm3", 4, 2, 40)
                                         << "3.00 of 4.00 mm³ free: nothing lost";
    QTest::newRow("exactly what is free")
        << criterion("sound_tissue", 4, "mm3", 4, 2, 40) << "4.00 of 4.00 mm³ free: nothing lost";
    QTest::newRow("nothing at all") << criterion("pulp_exposure", 0, "mm2", 0, 0, 100) << "Nothing lost";
    QTest::newRow("once") << criterion("pulp_exposure", 0.2, "mm2", 0, 0, 100) << "Any at all: 100 points at once";
    QTest::newRow("once, past some") << criterion("pulp_exposure", 0.2, "mm2", 0.1, 0, 1)
                                     << "More than 0.10 mm²: 1 point at once";
}

void TestTexts::criteriaAreWorkedInNumbers()
{
    QFETCH(lessons::Criterion, what);
    QFETCH(QString, worked);
    QTranslator english;
    QVERIFY(english.load(":/i18n/cusp_en.qm"));
    QCoreApplication::installTranslator(&english);
    QCOMPARE(ui::text::criterionWorked(what), worked);
    QVERIFY(ui::text::criterionName(what) != QString::fromStdString(what.id));
}

void TestTexts::theSumIsExactAlsoBelowZero()
{
    lessons::ScoreSheet sheet;
    sheet.criteria = {criterion("caries_left", 3.2, "%", 1, 2, 60), criterion("pulp_exposure", 0, "mm2", 0, 0, 100)};
    lessons::addUp(sheet);
    QCOMPARE(ui::text::scoreSum(sheet), QString("100 − 4 − 0 = 96"));
    sheet.criteria.back().measured = 1;
    lessons::addUp(sheet);
    QCOMPARE(ui::text::scoreSum(sheet), QString("100 − 4 − 100 = −4, no less than 0"));
}

void TestTexts::numbersFollowTheLanguage()
{
    QCOMPARE(ui::text::number(-1.5, 2), QString("−1.50"));
    QLocale::setDefault(QLocale("de_DE"));
    QCOMPARE(ui::text::number(1234.5, 1), QLocale("de_DE").toString(1234.5, 'f', 1));
    QVERIFY(ui::text::number(0.5, 1).contains(','));
    QLocale::setDefault(QLocale("en_GB"));
    QCOMPARE(ui::text::unitName("mm3"), QString("mm³"));
    QCOMPARE(ui::text::unitName("N"), QString("N"));
}

void TestTexts::germanIsComplete()
{
    const QList<Entry> entries = entriesOf(germanFile());
    QVERIFY(entries.size() > 150);
    for (const Entry& entry : entries) {
        const QString where = entry.context + ": " + entry.source;
        QVERIFY2(entry.type.isEmpty(), qPrintable(where + " is " + entry.type));
        QVERIFY2(!entry.translations.join(QString()).trimmed().isEmpty(), qPrintable(where + " has no translation"));
    }
}

void TestTexts::germanPlaceholdersMatch()
{
    for (const Entry& entry : entriesOf(germanFile()))
        for (const QString& form : entry.translations) {
            if (form.trimmed().isEmpty())
                continue;
            for (const char* mark : {"%1", "%2", "%3", "%4", "%5", "%n"})
                QVERIFY2(entry.source.contains(mark) == form.contains(mark), qPrintable(entry.source + " / " + form));
        }
}

void TestTexts::germanIsEmbedded()
{
    QTranslator german;
    QVERIFY(german.load(QLocale("de_AT"), "cusp", "_", ":/i18n"));
    QCoreApplication::installTranslator(&german);
    QCOMPARE(ui::text::materialName(Material::Enamel), QString("Schmelz"));
    QCOMPARE(ui::text::toothName(36), QString("erster Molar unten links"));
    QSet<QString> letters;
    for (int k = 0; k < core::terrain::kMaterialCount; ++k)
        letters << ui::text::materialLetter(static_cast<Material>(k));
    QCOMPARE(letters.size(), core::terrain::kMaterialCount);
}

QTEST_GUILESS_MAIN(TestTexts)
#include "tst_texts.moc"
