// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QHeaderView>
#include <QSignalSpy>
#include <QTableView>

#include "tests/support/Suite.h"
#include "tests/ui/PageTest.h"
#include "ui/charts/ChartPanel.h"
#include "ui/charts/Table.h"
#include "ui/people/HistoryModel.h"
#include "ui/people/HistoryPage.h"

using database::AttemptRecord;
using ui::charts::ChartPanel;
using ui::people::HistoryPage;

namespace {

/// Returns this many attempts at three lessons in turn, newest first, each better and faster than the one before.
QList<AttemptRecord> attemptRecords(int count)
{
    QList<AttemptRecord> made;
    const QDateTime first(QDate(2026, 9, 1), QTime(9, 0), Qt::UTC);
    for (int k = count; k-- > 0;) {
        AttemptRecord one;
        one.id = k + 1;
        one.finishedUtc = first.addSecs(86400LL * k).toString(Qt::ISODate).toStdString();
        one.lessonId = std::array{"c1-36", "decay-26", "pad-cross"}.at(static_cast<std::size_t>(k % 3));
        one.scoreTenths = std::min(980, 400 + 37 * (k / 3) + 90 * (k % 3) % 120);
        one.passMarkTenths = 750;
        one.passed = one.scoreTenths >= 750;
        one.durationMs = 900'000 - 11'000 * std::min(k, 60);
        one.meanForceMn = 900 - 6 * std::min(k, 60);
        one.peakForceMn = 2600 - 20 * std::min(k, 60);
        one.criteria = {{"depth", 100, 300}, {"outline", 40, 400}, {"walls", 20 + k % 3, 300}};
        one.recordingHash = k == 0 ? "" : "abc";
        made << one;
    }
    return made;
}

std::vector<database::BandPoint> band(int people)
{
    std::vector<database::BandPoint> made;
    for (int k = 1; k <= 8; ++k)
        made.push_back({k, people, 300 + 40 * k, 420 + 45 * k, 560 + 40 * k});
    return made;
}

}  // namespace

class TestHistoryPage : public support::PageTest<HistoryPage>
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        openPage();
        const ui::text::CriterionNames names{{"depth", "Pulpal floor"}, {"outline", "Outline"}};
        m_page->setCriterionNames({{"c1-36", names}, {"decay-26", names}, {"pad-cross", names}});
        m_page->setLessonTitles({{"c1-36", "Class I on 36"}, {"decay-26", "Decay on 26"}, {"pad-cross", "Pad: cross"}});
    }

    void theNewestIsFirstAndChosen()
    {
        auto* words = child<QLabel>("emptyWords");
        m_page->setHistory({});
        QVERIFY(words->isVisible());
        m_page->setHistory(attemptRecords(30));
        QVERIFY(!words->isVisible());
        QCOMPARE(table()->model()->rowCount(), 30);
        QCOMPARE(m_page->chosen(), 30);
        QCOMPARE(cell(0, 1), QString("Pad: cross"));
        // The selection is preserved.
        table()->selectRow(7);
        const auto kept = m_page->chosen();
        m_page->setHistory(attemptRecords(31));
        QCOMPARE(m_page->chosen(), kept);
    }

    void aLessonFiltersListAndCharts()
    {
        m_page->setHistory(attemptRecords(1200));
        QSignalSpy lesson(m_page, &HistoryPage::lessonChosen);
        auto* combo = child<QComboBox>("lessonFilter");
        QCOMPARE(combo->count(), 4);
        QCOMPARE(ui::charts::stopsOf(scores()).size(), ui::scoring::kMostCharted);  // the newest
        combo->setCurrentIndex(1);
        QCOMPARE(lesson.count(), 1);
        QCOMPARE(lesson.front().front().toString(), QString("c1-36"));
        QCOMPARE(table()->model()->rowCount(), 400);
        QCOMPARE(ui::charts::stopsOf(scores()).back().x, 400.0);
        QCOMPARE(scores().of, QString("Class I on 36"));  // the title is from the lesson's file
        m_page->setLesson({});
        QCOMPARE(table()->model()->rowCount(), 1200);
    }

    void everyAttemptHasAPlaceOfItsOwn()
    {
        // Three lessons on the same morning. On an axis of days their points would overlap.
        QList<AttemptRecord> some = attemptRecords(9);
        for (AttemptRecord& one : some)
            one.finishedUtc = "2026-09-01T09:00:00Z";
        m_page->setHistory(some);
        QList<double> places;
        for (const ui::charts::Dot& dot : ui::charts::stopsOf(scores()))
            places << dot.x;
        QCOMPARE(places, (QList<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
        const auto x = ui::charts::axesOf(scores()).first;
        QVERIFY(x.isWhole && x.low < 1.0 && x.high > 9.0 && x.high < 11.0);
    }

    void aTableOfSeveralLessonsNamesThem()
    {
        m_page->setHistory(attemptRecords(3));
        ui::charts::Table table = ui::charts::tableOf(scores());
        QCOMPARE(table.heads.size(), 4);
        QCOMPARE(table.heads.back(), QString("Lesson"));
        QStringList lessons;
        for (const auto& row : table.rows)
            lessons << std::get<QString>(row.back());
        lessons.sort();
        QCOMPARE(lessons, (QStringList{"Class I on 36", "Decay on 26", "Pad: cross"}));
        m_page->setLesson("decay-26");
        table = ui::charts::tableOf(scores());
        QCOMPARE(table.heads.size(), 3);
        for (const auto& row : table.rows)
            QCOMPARE(row.size(), 3);
    }

    void listsAreSortedByKeys()
    {
        QList<AttemptRecord> some = attemptRecords(9);
        some[3].durationMs = 3'700'000;  // "1:01:40" sorts after "9:59"
        some[4].scoreTenths = 1000;      // and "100.0" after "99.0"
        some[5].meanForceMn = 10'500;
        m_page->setHistory(some);
        const auto* heads = table()->horizontalHeader();
        QCOMPARE(heads->sortIndicatorSection(), 0);
        for (int column = 1; column <= 5; ++column) {
            QTest::keyClick(table(), Qt::Key_Right, Qt::AltModifier);
            QCOMPARE(heads->sortIndicatorSection(), column);
            QTest::keyClick(table(), Qt::Key_Down, Qt::AltModifier);
            QCOMPARE(heads->sortIndicatorOrder(), Qt::DescendingOrder);
            table()->selectRow(0);
            if (column == 2 || column >= 4)  // sorted by value
                QCOMPARE(m_page->chosen(), some[column == 2 ? 4 : column - 1 + (column == 5 ? 1 : 0)].id);
        }
        QTest::keyClick(table(), Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(heads->sortIndicatorOrder(), Qt::AscendingOrder);
        QTest::keyClick(table(), Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(heads->sortIndicatorSection(), 4);
    }

    void theBandNeedsFivePeople()
    {
        m_page->setHistory(attemptRecords(30));
        m_page->setLesson("c1-36");
        const auto slices = [&] { return std::get<ui::charts::Curve>(scores().content).band.slices.size(); };
        m_page->setBand(band(4));
        QCOMPARE(slices(), 0);
        m_page->setBand(band(5));
        QCOMPARE(slices(), 8);
        m_page->setLesson("decay-26");  // the selection belonged to the other lesson
        QCOMPARE(slices(), 0);
        m_page->setClassMedians(ui::scoring::ClassMedians{4, 700, 600'000});
        for (auto* button : m_page->findChildren<QPushButton*>())
            if (button->text() == "Speed")
                button->click();
        QCOMPARE(std::get<ui::charts::Curve>(other().content).limits.size(), 0);
        m_page->setClassMedians(ui::scoring::ClassMedians{5, 700, 600'000});
        QCOMPARE(std::get<ui::charts::Curve>(other().content).limits.size(), 2);
    }

    void anAttemptOpens()
    {
        m_page->setHistory(attemptRecords(30));
        QSignalSpy opened(m_page, &HistoryPage::attemptOpenRequested);
        QSignalSpy replayed(m_page, &HistoryPage::replayRequested);
        auto* replay = child<QPushButton>("replayAttempt");
        table()->setFocus();
        QTest::keyClick(table(), Qt::Key_Down);
        QCOMPARE(m_page->chosen(), 29);
        QTest::keyClick(table(), Qt::Key_Return);
        QCOMPARE(opened.count(), 1);
        QCOMPARE(opened.takeFirst().front().toLongLong(), 29);
        click("openAttempt");
        QCOMPARE(opened.takeFirst().front().toLongLong(), 29);
        replay->click();
        QCOMPARE(replayed.front().front().toLongLong(), 29);
        auto* score = child<ChartPanel>("scoreChart");
        score->setFocus();
        QTest::keyClick(score, Qt::Key_Home);
        QTest::keyClick(score, Qt::Key_Return);
        QCOMPARE(opened.takeFirst().front().toLongLong(), 1);
        // An attempt without a recording has no replay, but it has a score sheet.
        table()->selectRow(29);
        QVERIFY(!replay->isEnabled() && child<QLabel>("recordingMissing")->isVisible());
        QVERIFY(child<QPushButton>("openAttempt")->isEnabled());
    }

    void anInstructorsScoreCounts()
    {
        QList<AttemptRecord> some = attemptRecords(3);
        some[0].givenTenths = 885;
        m_page->setHistory(some);
        QCOMPARE(cell(0, 2), QString("88.5"));
        QCOMPARE(cell(0, 3), QString("passed"));
        QVERIFY(table()->model()->index(0, 2).data(Qt::ToolTipRole).toString().contains("46.0"));
        QVERIFY(ui::charts::stopsOf(scores()).back().words.endsWith("88.5 points, passed (machine: 46.0)"));
    }

    void whatCostMostIsFirstThoughItHasNoWeight()
    {
        QList<AttemptRecord> some = attemptRecords(3);
        for (AttemptRecord& one : some)
            one.criteria = {{"caries_left", 300, 300}, {"pulp_opened", 609, 0}, {"pulp_grazed", 0, 0}};
        m_page->setHistory(some);
        const auto bars = std::get<ui::charts::Bars>(other().content);
        QCOMPARE(bars.bars.size(), 2);  // a criterion without a loss has no bar
        QCOMPARE(bars.bars[0].value, 60.9);
        QCOMPARE(bars.bars[1].value, 30.0);
        QVERIFY2(bars.bars[0].words.endsWith(": 60.9 points lost"), qPrintable(bars.bars[0].words));
        QCOMPARE(bars.value.high, 100.0);
    }

    void aCriterionIsCalledAsItsLessonSays()
    {
        m_page->setCriterionNames({{"c1-36", {{"left", "Part of the ideal"}, {"walls", "Walls"}}},
                                   {"decay-26", {{"left", "Part of the opening"}, {"sides", "Walls"}}}});
        QList<AttemptRecord> some = attemptRecords(2);
        some[0].criteria = {{"left", 100, 300}, {"sides", 60, 300}};
        some[1].criteria = {{"left", 200, 300}, {"walls", 40, 300}};
        QCOMPARE(some[1].lessonId, std::string("c1-36"));
        m_page->setHistory(some);
        const auto bars = [this] { return std::get<ui::charts::Bars>(other().content).bars; };
        QCOMPARE(bars().size(), 3);
        QCOMPARE(bars()[0].words, QString("Part of the ideal: 20.0 points lost"));
        QCOMPARE(bars()[1].words, QString("Part of the opening: 10.0 points lost"));
        QCOMPARE(bars()[2].words, QString("Walls: 5.0 points lost"));  // common to two lessons, shown once
        m_page->setLesson("decay-26");
        QCOMPARE(bars()[0].name, QString("Part of the opening"));
    }

    /// The titles of lessons may arrive after the attempts.
    void examsWithoutAScoreHaveTheirTitle()
    {
        m_page->setLessonTitles({});
        m_page->setExamsWithoutScore({{"a", "c1-36", "2026-09-01T09:00:00Z"}});
        m_page->setLessonTitles({{"c1-36", "Class I on 36"}});
        QVERIFY(child<QLabel>("examsWithoutScore")->text().contains("Class I on 36, begun"));
    }

    void everyControlHasAName() { QCOMPARE(support::controlsWithoutNames(*m_page), QStringList()); }

private:
    [[nodiscard]] ui::charts::Chart scores() const { return child<ChartPanel>("scoreChart")->chart(); }
    /// Returns the chart next to it.
    [[nodiscard]] ui::charts::Chart other() const { return child<ChartPanel>("otherChart")->chart(); }
    [[nodiscard]] QTableView* table() const { return child<QTableView>("attempts"); }
    [[nodiscard]] QString cell(int row, int column) const
    {
        return table()->model()->index(row, column).data().toString();
    }
};

CUSP_TEST(TestHistoryPage)
#include "tst_history_page.moc"
