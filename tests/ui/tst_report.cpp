// SPDX-License-Identifier: GPL-3.0-or-later
// Reports have one painting code. Here it paints into pictures and drawings, in the program onto paper and into PDF.
#include <QApplication>
#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QPrintDialog>
#include <QPrinter>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QSvgGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <memory>

#include <sys/inotify.h>
#include <unistd.h>

#include "core/servo/ServoState.h"
#include "tests/support/Files.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/ui/PseudoLanguage.h"
#include "tests/ui/WindowTest.h"
#include "ui/kit/Theme.h"
#include "ui/report/Printing.h"
#include "ui/report/Report.h"
#include "ui/scoring/ScorePage.h"

using database::AttemptRecord;
using ui::report::ClassReport;
using ui::scoring::ScoreCard;

namespace {

constexpr QSizeF kA4{510.0, 757.0};  ///< points within margins of 15 mm
constexpr QSizeF kLetter{527.0, 707.0};
constexpr double kDotsPerPoint = 2.0;
const QString kCode = "K7QF-93XM-2ND8";
constexpr const char* kOverdue = "2026-11-19T22:59:59Z";

ui::scoring::Proof proof()
{
    return {kCode, "0.1.0", QDateTime(QDate(2026, 11, 20), QTime(12, 0), Qt::UTC)};
}

/// Returns the score card of a shipped lesson whose cavity has a pit in its floor.
ScoreCard scoreCard()
{
    ScoreCard card;
    const lessons::Assignment assignment = support::assigned("class1-36");
    const core::terrain::ToothAnatomy& anatomy = *assignment.anatomy;
    ui::scoring::ScoredWork work;
    work.ideal = assignment.shownIdeal();
    std::vector<float> top = *work.ideal;
    for (int j = 0; j < anatomy.grid.side; ++j)
        for (int i = 0; i < anatomy.grid.side; ++i)
            if (const std::size_t k = anatomy.grid.index(i, j);
                top[k] < anatomy.top[k] && anatomy.grid.nodeMm(i, j).x < anatomy.grid.middleMm().x - 1.0)
                top[k] -= 0.4F;
    auto tooth = core::terrain::restored(assignment.anatomy, top);
    const auto marked = lessons::mark(assignment, tooth).value();
    work.tooth = std::make_shared<const core::terrain::Tooth>(std::move(tooth));
    work.measured = marked.measured;
    card.work = work;
    card.sheet = marked.sheet;
    card.lesson = "Class I on 36";
    card.person = "Ada Lovelace";
    card.proof = proof();
    AttemptRecord& attempt = card.attempt;
    attempt.id = 9;
    attempt.uid = "0123456789abcdef0123456789abcdef";
    attempt.finishedUtc = "2026-11-20T10:15:00Z";
    attempt.scoreTenths = card.sheet.totalTenths;
    attempt.passMarkTenths = card.sheet.passMarkTenths;
    attempt.passed = card.sheet.passed();
    attempt.expectedTenths = 900;
    attempt.durationMs = 727'000;
    attempt.meanForceMn = 850;
    attempt.peakForceMn = 2100;
    attempt.preset = "natural v4";
    attempt.presetHash = std::string(64, 'b');
    attempt.device = "pointer";
    attempt.method = "spring";
    attempt.grid = 256;
    attempt.viewMode = "flat";
    attempt.seed = "42";
    attempt.program = "0.1.0";
    attempt.recordingHash = std::string(64, 'c');
    for (int k = 9; k > 0; --k) {
        AttemptRecord one = attempt;
        one.id = k;
        one.scoreTenths = 400 + 45 * k;
        one.passed = one.scoreTenths >= one.passMarkTenths;
        one.durationMs = 900'000 - 30'000 * k;
        card.history << one;
        card.band.insert(card.band.begin(), {k, 12, 340 + 40 * k, 450 + 42 * k, 560 + 41 * k});
    }
    card.talk.comments.push_back(
        {1, "Grace Hopper", "2026-11-20T11:00:00Z", "Here you pressed too hard.", {}, 102'000});
    return card;
}

ClassReport classReport(int students, int lessonCount)
{
    ClassReport report;
    report.className = "DEN101-A";
    report.teacher = "Grace Hopper";
    report.proof = proof();
    report.passMarkTenths = 750;
    report.rubricHash = std::string(60, 'a') + "beef";
    report.rubricVersion = 3;
    for (int k = 0; k < lessonCount; ++k) {
        report.overview.lessons.push_back("lesson-" + std::to_string(k));
        report.titles.insert(QString("lesson-%1").arg(k), QString("Class %1 on tooth 36, mesial").arg(k + 1));
    }
    for (int k = 0; k < students; ++k) {
        database::MatrixStudent one;
        one.id = {k + 1};
        one.fullName = "Student " + std::to_string(1001 + k);
        one.lastLoginUtc = k == 1 ? "" : "2026-11-19T08:00:00Z";
        one.lastAttemptUtc = k == 1 ? "" : "2026-11-18T08:00:00Z";
        if (k == 0) {
            one.recentTenths = {500, 500, 500};
            one.recentPassed = {false, false, false};
        }
        std::vector<database::MatrixCell> row(report.overview.lessons.size());
        for (std::size_t lesson = 0; lesson < row.size(); ++lesson)
            if ((static_cast<std::size_t>(k) + lesson) % 4 != 1) {
                const int best = 300 + (k * 97 + static_cast<int>(lesson) * 61) % 700;
                row[lesson] = {2, best, best >= 750, "2026-11-18T08:00:00Z"};
            }
        report.overview.students.push_back(one);
        report.overview.cells.push_back(row);
    }
    report.results.lessonId = "lesson-0";
    for (int k = 0; k < students; ++k)
        report.results.bestTenths.push_back(300 + 700 * k / students);
    if (students >= 5)
        for (int k = 1; k < 7; ++k)
            report.results.curve.push_back({k, students, 380 + 50 * k, 500 + 50 * k, 640 + 45 * k});
    report.results.difficulty = {"lesson-0", students, students - 3, 583.0, 2.4, {{"depth", 0.42}, {"walls", 0.2}}};
    return report;
}

/// Returns the pages as pictures.
template <typename Content>
QList<QImage> pagesOf(const Content& content, const QSizeF& paper)
{
    QList<QImage> pages;
    QImage page((paper * kDotsPerPoint).toSize(), QImage::Format_RGB32);
    QPainter painter;
    const auto begin = [&] {
        page.fill(Qt::white);
        painter.begin(&page);
        painter.scale(kDotsPerPoint, kDotsPerPoint);
    };
    begin();
    const int count = ui::report::paint(
        painter, paper,
        [&] {
            painter.end();
            pages << page.copy();
            begin();
        },
        content);
    painter.end();
    pages << page;
    return count == pages.size() ? pages : QList<QImage>{};
}

/// Returns all words of the drawing.
template <typename Content>
QString wordsOf(const Content& content, const QSizeF& paper)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(paper.toSize());
    QPainter painter(&generator);
    ui::report::paint(
        painter, paper, [] {}, content);
    painter.end();
    static const QRegularExpression tags("<[^>]*>");
    return QString::fromUtf8(bytes).replace(tags, " ").replace("&quot;", "\"").simplified();
}

/// Returns the share of the picture that is not white.
double inkOf(const QImage& page)
{
    qint64 dark = 0;
    for (int y = 0; y < page.height(); ++y)
        for (int x = 0; x < page.width(); ++x)
            dark += qGray(page.pixel(x, y)) < 200 ? 1 : 0;
    return static_cast<double>(dark) / static_cast<double>(page.width() * page.height());
}

/// A home folder that is also the working folder, with a database file in it. Reports whether the file was opened.
class WatchedHome
{
public:
    WatchedHome() : m_home(qgetenv("HOME")), m_before(QDir::currentPath()), m_watch(inotify_init1(IN_NONBLOCK))
    {
        QFile file(m_folder.filePath("school.sqlite-shm"));  // its suffix does not identify its type
        m_isReady = file.open(QIODevice::WriteOnly) && file.write(QByteArray(4096, '\1')) == 4096;
        file.close();
        m_isReady = m_isReady && inotify_add_watch(m_watch, QFile::encodeName(file.fileName()), IN_OPEN) >= 0 &&
                    QDir::setCurrent(m_folder.path()) && qputenv("HOME", m_folder.path().toLocal8Bit());
    }
    ~WatchedHome()
    {
        ::close(m_watch);
        qputenv("HOME", m_home);
        QDir::setCurrent(m_before);
    }
    Q_DISABLE_COPY_MOVE(WatchedHome)
    [[nodiscard]] bool isReady() const { return m_isReady; }
    [[nodiscard]] bool wasOpened()
    {
        std::array<char, 4096> events{};
        return m_isOpened = m_isOpened || ::read(m_watch, events.data(), events.size()) > 0;
    }

private:
    QTemporaryDir m_folder;
    QByteArray m_home;
    QString m_before;
    int m_watch;
    bool m_isReady = false;
    bool m_isOpened = false;
};

}  // namespace

class TestReport : public QObject
{
    Q_OBJECT
private slots:
    /// Closing a database file would drop SQLite's locks on it, so the print dialog must not open it.
    void noFileIsOpenedToAskForAPrinter()
    {
        QPrinter printer;
        QWidget window;
        WatchedHome ours;
        QVERIFY(ours.isReady());
        const QByteArray home = qgetenv("HOME");
        const std::unique_ptr<QPrintDialog> dialog(ui::report::makePrintDialog(printer, &window));
        dialog->show();
        QVERIFY(QTest::qWaitForWindowExposed(dialog.get()));
        QVERIFY(!dialog->testOption(QAbstractPrintDialog::PrintToFile));
        QCOMPARE(qgetenv("HOME"), home);
        // Qt's own dialog must open the file; otherwise the test proves nothing. It is shown later than our dialog,
        // which would have had more time to open the file.
        WatchedHome theirs;
        QVERIFY(theirs.isReady());
        QPrintDialog plain(&printer, &window);
        plain.show();
        QTRY_VERIFY(theirs.wasOpened());
        QVERIFY(!ours.wasOpened());
    }

    void initTestCase()
    {
        QLocale::setDefault(QLocale("en_GB"));
        ui::kit::applyTheme(*qApp, ui::kit::ThemeChoice::Dark);
        m_card = scoreCard();
    }

    void reportsSayWhatTheScreenSays_data()
    {
        using Words = QStringList;
        support::columns<QString, Words, Words>("words", "says", "saysNot");
        const auto row = [](const char* name, const auto& report, const Words& says, const Words& saysNot = {}) {
            QTest::newRow(name) << wordsOf(report, kA4) << says << saysNot;
        };
        QVERIFY(!m_card.sheet.criteria.empty());
        row("card", m_card,
            {"Class I on 36", "Ada Lovelace", kCode, "Cusp 0.1.0", "natural v4",
             "Device: mouse, pen or gamepad; contact: spring", "256 columns", "seed: 42", "Here you pressed too hard.",
             "at 1:42 of the replay", "undercuts", "90.0 points",
             QString::fromStdString(m_card.sheet.rubricHash.substr(0, 16)), QString(16, 'b')});
        ScoreCard card = m_card;
        card.attempt.scoreTenths = 684;
        card.attempt.givenTenths = 801;
        card.talk.overrides.push_back({"Grace Hopper", "2026-11-20T11:30:00Z", 801, "The wall is fine by hand."});
        row("another score was given", card,
            {"80.1 of 100 points", "Automatic score: 68.4", "Grace Hopper", "The wall is fine by hand.",
             "Automatic score: 100.0"});
        card = m_card;
        card.work->measured.process.emplace().totalS = 133.0;
        card.work->aids = core::servo::kSectionAid | core::servo::kIdealAid;
        card.work->infractions = {{core::grading::RuleViolation::BurInAir, 37000, 37.4, {}, 0, 20}};
        card.sheet.criteria.front().critical = true;
        card.sheet.criteria.front().share = 1.0;
        ScoreCard limited = m_card;
        limited.sheet.criteria.front().critical = true;
        limited.sheet.criteria.front().capTenths = 650;
        limited.sheet.criteria.front().share = 1.0;
        limited.sheet.totalTenths = 650;
        row("limited", limited, {"Not passed: limited to 65.0"});
        row("harm, aids and a breach", card,
            {ui::scoring::ScorePage::verdictWords(card.sheet, {}, {}), "Not passed: critical error",
             "1 breach(es) of the rules: ", " at 0:37", "Aids in use: section, ideal", "Middle half", "Class median",
             "Pass mark", "Not passed"},
            {"..."});
        card = m_card;
        card.proof.auditCode.clear();
        card.attempt.recordingHash.clear();
        row("not kept", card, {"there is no audit code", "recording –"}, {"Audit code:"});
        row("class", classReport(23, 5),
            {"Class: DEN101-A", "Grace Hopper", kCode, "Never logged in", "Stuck (", "20 of 23 passed",
             "Learning curve", "version 3, content aaaaaaaaaaaaaaaa"});
        row("four people", classReport(4, 3), {"5 people"}, {"of 4 passed"});
        ClassReport report = classReport(6, 3);
        report.overview.cells[4][0] = {3, 600, false, "2026-11-18T08:00:00Z"};
        report.given = {{1, report.overview.id, "lesson-0", kOverdue, 3}};
        row("late, and no attempts left", report,
            {"Late: a lesson is overdue", "No attempts left at a lesson that is not passed: Student 1005"});
    }

    void reportsSayWhatTheScreenSays()
    {
        QFETCH(QString, words);
        QFETCH(QStringList, says);
        QFETCH(QStringList, saysNot);
        for (const QString& part : says)
            QVERIFY2(words.contains(part), qPrintable(part + " in " + words));
        for (const QString& part : saysNot)
            QVERIFY2(!words.contains(part), qPrintable(part + " in " + words));
    }

    /// Pictures become smaller so that a few lines do not go to a second page.
    void onePageHoldsAShortCard()
    {
        ScoreCard card = m_card;
        card.talk = {};
        while (card.sheet.criteria.size() > 4)
            card.sheet.criteria.pop_back();
        for (const QSizeF& paper : {kA4, kLetter})
            QCOMPARE(pagesOf(card, paper).size(), 1);
    }

    /// Prints the report in an invented language. Every text must be translated, except names and the texts of lessons.
    void everyWordIsOfTheLanguage()
    {
        pseudo::Translator strange;
        QCoreApplication::installTranslator(&strange);
        const auto back = qScopeGuard([&] { QCoreApplication::removeTranslator(&strange); });
        ScoreCard card = m_card;
        card.lesson = card.person = "[···]";
        card.attempt.preset = "[···]";
        card.attempt.method = "continuous";
        card.attempt.program = "";
        card.proof.program = "1";
        card.attempt.uid = "1";
        card.attempt.presetHash = card.attempt.recordingHash = card.sheet.rubricHash = std::string(64, '1');
        card.sheet.rubricTitle = pseudo::said(card.sheet.rubricTitle);
        for (lessons::Criterion& one : card.sheet.criteria)
            one.title = pseudo::said(one.title);
        card.talk.comments.front().author = card.talk.comments.front().words = "[···]";

        ClassReport report = classReport(7, 3);
        report.className = report.teacher = "[···]";
        report.rubricHash = std::string(64, '1');
        report.proof.program = "1";
        for (auto& title : report.titles)
            title = "[···]";
        for (database::MatrixStudent& student : report.overview.students)
            student.fullName = "[···]";
        report.criteria = {{"depth", "[···]"}, {"walls", "[····]"}};
        report.given = {{1, report.overview.id, "lesson-0", kOverdue, 0}};

        for (QString words : {wordsOf(card, kA4), wordsOf(report, kA4)}) {
            static const QRegularExpression kOfQt(
                "^Qt SVG Document Generated with Qt|\\b(?:K7QF-93XM-2ND8|Nov|Jan|AM|PM|am|pm)\\b");
            QStringList english = words.remove(kOfQt).split(' ');
            english.removeIf([](const QString& word) { return pseudo::untranslated(word).isEmpty(); });
            QVERIFY2(english.isEmpty(), qPrintable(english.join(", ") + " in: " + words));
        }
    }

    void aCommentsPlaceIsNumberedInThePicture()
    {
        ScoreCard card = m_card;
        const glm::dvec2 middle = card.work->tooth->grid().middleMm();
        card.talk.comments.clear();
        card.talk.comments.push_back({1, "Grace Hopper", "2026-11-20T11:00:00Z", "Well done.", {}, {}});
        card.talk.comments.push_back({2, "Grace Hopper", "2026-11-20T11:00:00Z", "The floor is uneven.", {}, {}});
        card.talk.comments.back().placeMm = {middle.x, middle.y, 0.0};
        const QString words = wordsOf(card, kA4);
        QVERIFY2(words.contains("(1) Grace Hopper") && words.contains("numbers of their places"), qPrintable(words));
        QCOMPARE(words.count("(1)"), 1);
    }

    void theMatrixHasItsTitleOnEveryPage()
    {
        const QString sign = "▲: overdue, or no attempts left";
        ClassReport report = classReport(35, 40);
        report.given = {{1, report.overview.id, "lesson-0", kOverdue, 0}};
        const QList<QImage> pages = pagesOf(report, kA4);
        // The parts follow each other without half-empty pages.
        QVERIFY2(pages.size() <= 6, qPrintable(QString::number(pages.size())));
        const QString words = wordsOf(report, kA4);
        QVERIFY2(words.count(sign) >= pages.size() - 1, qPrintable(QString::number(words.count(sign))));
        QVERIFY2(words.contains("▲ 30"), qPrintable(words));  // the cell of a student who is late, as on the screen
    }

    void pagesAreFilledAndNotOverfull()
    {
        const ClassReport report = classReport(60, 14);
        for (const QSizeF& paper : {kA4, kLetter}) {
            const QList<QImage> ofClass = pagesOf(report, paper);
            QVERIFY(ofClass.size() >= 3 && ofClass.size() <= 8);
            for (const QImage& page : pagesOf(m_card, paper) + ofClass) {
                const double inked = inkOf(page);
                QVERIFY2(inked > 0.002 && inked < 0.35, qPrintable(QString::number(inked)));
                // The line above the footer is empty.
                const int foot = static_cast<int>((paper.height() - 29.0) * kDotsPerPoint);
                QCOMPARE(inkOf(page.copy(0, foot, page.width(), 1)), 0.0);
            }
        }
    }

    void paperIsWhiteInTheDarkThemeToo()
    {
        const QList<QImage> dark = pagesOf(m_card, kA4);
        ui::kit::applyTheme(*qApp, ui::kit::ThemeChoice::Light);
        const QList<QImage> light = pagesOf(m_card, kA4);
        ui::kit::applyTheme(*qApp, ui::kit::ThemeChoice::Dark);
        QCOMPARE(dark, light);
    }

    void aPdfIsWritten()
    {
        const QTemporaryDir folder;
        for (const auto& [size, box] :
             {std::pair(QPageSize::A4, "/MediaBox [0 0 595"), {QPageSize::Letter, "/MediaBox [0 0 612"}}) {
            QVERIFY(ui::report::savePdf(folder.filePath("card.pdf"), "Class I on 36", m_card, size));
            QVERIFY(ui::report::savePdf(folder.filePath("class.pdf"), "DEN101-A", classReport(60, 14), size));
            for (const char* name : {"card.pdf", "class.pdf"}) {
                const std::string bytes = support::bytesOf(folder.filePath(name).toStdString());
                QVERIFY2(bytes.starts_with("%PDF-") && bytes.find(box) != std::string::npos, name);
            }
        }
        QVERIFY(!ui::report::savePdf("/nowhere/at/all/card.pdf", "Class I on 36", m_card));
    }

private:
    ScoreCard m_card;
};

CUSP_TEST(TestReport)
#include "tst_report.moc"
