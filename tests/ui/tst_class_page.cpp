// SPDX-License-Identifier: GPL-3.0-or-later
#include <QButtonGroup>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>

#include "tests/support/Files.h"
#include "tests/support/Suite.h"
#include "tests/ui/PageTest.h"
#include "ui/charts/ChartPanel.h"
#include "ui/people/ClassPage.h"

using database::ClassOverview;
using database::LessonResults;
using database::MatrixCell;
using database::MatrixStudent;
using ui::charts::ChartPanel;
using ui::people::ClassPage;
using ui::people::Need;

namespace {

const QDateTime kNow(QDate(2026, 11, 20), QTime(12, 0), Qt::UTC);

/// Returns a class of this many students and lessons. The first student needs help, the second has never logged in, the
/// third has not begun.
ClassOverview overview(int students, int lessons)
{
    ClassOverview made{{7}, "DEN101-A", {}, {}, {}};
    for (int k = 0; k < lessons; ++k)
        made.lessons.push_back("lesson-" + std::to_string(10 + k));
    for (int k = 0; k < students; ++k) {
        MatrixStudent one;
        one.id = {100 + k};
        one.username = "s-" + std::to_string(1001 + k);
        one.fullName = "Student " + std::to_string(1001 + k);
        std::vector<MatrixCell> row(made.lessons.size());
        if (k == 0) {
            one.recentTenths = {520, 510, 530, 700};
            one.recentPassed = {false, false, false, false};
        }
        if (k != 1)
            one.lastLoginUtc = "2026-11-19T08:00:00Z";
        if (k != 1 && k != 2) {
            one.lastAttemptUtc = kNow.addDays(-(k % 30)).toString(Qt::ISODate).toStdString();
            for (std::size_t lesson = 0; lesson < row.size(); ++lesson)
                if ((static_cast<std::size_t>(k) + 2 * lesson) % 5 != 4) {
                    const int best = 330 + (k * 97 + static_cast<int>(lesson) * 61) % 640;
                    row[lesson] = {1 + k % 4, best, best >= 750, one.lastAttemptUtc};
                }
        }
        made.students.push_back(one);
        made.cells.push_back(row);
    }
    return made;
}

LessonResults results(int people)
{
    LessonResults made;
    made.lessonId = "lesson-10";
    for (int k = 0; k < people; ++k)
        made.bestTenths.push_back(1000 - (people - 1 - k) * 700 / std::max(1, people - 1));
    if (people >= 5)
        for (int k = 1; k <= 6; ++k)
            made.curve.push_back({k, people, 380 + 50 * k, 500 + 50 * k, 640 + 45 * k});
    made.difficulty = {"lesson-10", people, people - 2,
                       583.0,       2.4,    {{"depth", 0.42}, {"outline", 0.2}, {"walls", 0.1}}};
    return made;
}

}  // namespace

class TestClassPage : public support::PageTest<ClassPage>
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        openPage();
        m_page->setLessonTitles({{"lesson-10", "Class I on 36"}, {"lesson-11", "Decay on 26"}});
        m_page->setClasses({{{7}, "DEN101-A", 12, 1}, {{8}, "DEN101-B", 3, 1}});
        m_page->setOverview(overview(12, 6), kNow);
    }

    void itSaysWhoNeedsTheTeacher()
    {
        QCOMPARE(textOf("needs"), QString("3 need(s) you:"));
        QVERIFY(name(0).contains("stuck") && name(1).contains("no login") && name(2).contains("new"));
        QCOMPARE(name(3), QString("Student 1004"));
        // Each number leads to the list of its students.
        button("1 stuck")->click();
        QCOMPARE(students(), 1);
        QVERIFY(name(0).startsWith("Student 1001"));
        button("1 no login")->click();
        QVERIFY(name(0).startsWith("Student 1002") && !button("1 stuck")->isChecked());
        // When the only student of the list no longer needs help, all students are shown again.
        ClassOverview fine = overview(12, 6);
        fine.students.erase(fine.students.begin(), fine.students.begin() + 3);
        fine.cells.erase(fine.cells.begin(), fine.cells.begin() + 3);
        m_page->setOverview(fine, kNow);
        QCOMPARE(textOf("needs"), QString("Nobody needs you just now"));
        QCOMPARE(students(), 9);
    }

    void aStudentIsSearchedFor()
    {
        m_page->setOverview(overview(200, 6), kNow);
        QVERIFY(search()->isVisible());
        search()->setText(" student 107");
        QCOMPARE(students(), 10);
        QVERIFY(name(0).startsWith("Student 1070"));
        QCOMPARE(textOf("studentsFound"), QString("10 student(s)"));
        search()->setText("S-1002");  // a username
        QCOMPARE(students(), 1);
        // The search also applies to the students who need help.
        button("1 stuck")->click();
        QCOMPARE(students(), 0);
        button("1 stuck")->click();
        // Another class is shown without the search.
        showOther(3);
        QVERIFY(search()->text().isEmpty());
        QCOMPARE(students(), 3);
    }

    void whatIsReadAgainLeavesEverythingInItsPlace()
    {
        const ClassOverview large = overview(200, 40);
        const QList<database::ClassAssignment> given{{1, {7}, "lesson-10", "2026-11-19T23:59:59Z", 0}};
        m_page->setOverview(large, kNow);
        m_page->setAssignments(given);
        auto* late = child<QButtonGroup>()->button(static_cast<int>(Need::Late));
        late->click();
        search()->setText("Student 1");
        matrix()->setCurrentIndex(matrix()->model()->index(60, 20));
        choose("lessonChooser", 3);
        const QString who = name(60);
        const QPoint scrolled(matrix()->horizontalScrollBar()->value(), matrix()->verticalScrollBar()->value() - 20);
        QVERIFY(scrolled.x() > 0 && scrolled.y() > 0);
        matrix()->verticalScrollBar()->setValue(scrolled.y());

        ClassOverview later = large;
        later.students.erase(later.students.begin());
        later.cells.erase(later.cells.begin());
        QSignalSpy charted(m_page, &ClassPage::lessonChosen);
        m_page->setOverview(later, kNow);
        m_page->setAssignments(given);
        QVERIFY(late->isChecked());
        QCOMPARE(name(matrix()->currentIndex().row()), who);
        QCOMPARE(matrix()->currentIndex().column(), 20);
        QCOMPARE(QPoint(matrix()->horizontalScrollBar()->value(), matrix()->verticalScrollBar()->value()), scrolled);
        QCOMPARE(m_page->chosenLesson(), QString("lesson-13"));
        QCOMPARE(charted.count(), 0);
    }

    void aUserWhoIsLoggedOutLeavesNothing()
    {
        m_page->setResults(results(12), 750, {});
        search()->setText("Student 1004");
        m_page->say([] { return QString("The report was saved."); });
        m_page->forget();
        QCOMPARE(students(), 0);
        QVERIFY(m_page->table().rows.isEmpty());
        QVERIFY(m_page->chosenLesson().isEmpty());
        for (const ChartPanel* panel : m_page->findChildren<ChartPanel*>()) {
            QVERIFY(panel->chart().title.isEmpty() || ui::charts::stopsOf(panel->chart()).isEmpty());
            QVERIFY2(!panel->chart().of.contains("DEN101"), qPrintable(panel->chart().of));
        }
        for (const QLabel* label : m_page->findChildren<QLabel*>())
            QVERIFY2(!label->text().contains("report was saved"), qPrintable(label->text()));
        QVERIFY(search()->text().isEmpty());
    }

    /// The teacher was removed from the class, or has selected another one.
    void aClassThatIsTakenAwayIsNotShown()
    {
        QSignalSpy wanted(m_page, &ClassPage::classChosen);
        m_page->setClasses({{{8}, "DEN101-B", 3, 1}});
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted[0][0].toLongLong(), 8);
        QCOMPARE(students(), 0);
        showOther(3);
        QCOMPARE(students(), 3);
        m_page->setClasses({});
        QCOMPARE(students(), 0);
        QVERIFY(child<QLabel>("classEmpty")->isVisible());
        QVERIFY(!child<QWidget>("classReport")->isEnabled());
    }

    void whatCouldNotBeReadSaysSo()
    {
        const auto refuse = [this] { m_page->refuse([] { return QString("The server does not answer."); }); };
        refuse();  // the answer for the class that is shown
        QCOMPARE(students(), 12);
        choose("classChooser", 1);
        QCOMPARE(students(), 0);
        QVERIFY(child<QLabel>("classEmpty")->isVisible());
        refuse();
        QVERIFY2(textOf("classEmpty").startsWith("The server does not answer. F5"), qPrintable(textOf("classEmpty")));
        m_page->readAgain();
        QVERIFY(!textOf("classEmpty").contains("does not answer"));
        // Students practise at other computers, so the class is read again when the page is shown again.
        QSignalSpy wanted(m_page, &ClassPage::classChosen);
        m_page->hide();
        m_page->show();
        QCOMPARE(wanted.count(), 1);
    }

    /// A student with an overdue lesson or without attempts left who has not passed. The list gives this precedence
    /// over needing help and being late.
    void whoIsLateNeedsTheTeacher()
    {
        ClassOverview shown = overview(6, 2);
        shown.cells[0][0] = {3, 530, false, "2026-11-18T08:00:00Z"};  // needs help
        shown.cells[3][0] = {3, 749, false, "2026-11-18T08:00:00Z"};
        shown.cells[4][0] = {1, 800, true, "2026-11-18T08:00:00Z"};
        shown.cells[5][0] = {2, 600, false, "2026-11-18T08:00:00Z"};
        m_page->setOverview(shown, kNow);
        m_page->setAssignments({{1, {7}, "lesson-10", "2026-11-19T23:59:59Z", 3},
                                {2, {7}, "lesson-11", "2026-11-27T23:59:59Z", 0},
                                {3, {8}, "lesson-11", "2026-11-01T23:59:59Z", 0}});
        const QStringList expected{"out of tries", "no login", "late", "out of tries", "Student 1005", "late"};
        for (int row = 0; row < expected.size(); ++row)
            QVERIFY2(name(row).contains(expected[row]), qPrintable(name(row)));
        // A score is shown as everywhere else, so a failing one is not rounded up to the pass mark.
        QCOMPARE(cell(3, 1), QString("74.9"));
        QVERIFY2(tip(3).contains("no attempts left"), qPrintable(tip(3)));
        QVERIFY2(tip(5).contains("overdue"), qPrintable(tip(5)));
        QVERIFY(matrix()->model()->headerData(2, Qt::Horizontal).toString().endsWith("due 27 Nov"));
        button("2 out of tries")->click();
        QCOMPARE(students(), 2);
        button("5 late")->click();  // all but the student who has passed
        QCOMPARE(students(), 5);
    }

    /// An exam counts as an attempt once it was begun. Another class of the student may allow more attempts.
    void anExamWithoutAScoreIsSeen()
    {
        ClassOverview shown = overview(6, 1);
        MatrixCell& begun = shown.cells[3][0];
        for (const std::size_t student : {3U, 4U, 5U}) {
            shown.cells[student][0] = {};
            shown.cells[student][0].withoutScore = 1;
        }
        shown.cells[4][0].limitElsewhere = 2;
        shown.cells[5][0].limitElsewhere = 0;
        const auto hasNoneLeft = [&](int row) {
            m_page->setOverview(shown, kNow);
            m_page->setAssignments({{1, {7}, "lesson-10", "", 1}});
            return tip(row).contains("begun") && tip(row).contains("no attempts left") &&
                   name(row).contains("out of tries");
        };
        QVERIFY(hasNoneLeft(3) && !hasNoneLeft(4) && !hasNoneLeft(5));
        QVERIFY2(tip(4).contains("begun") && !tip(4).contains("no attempts left"), qPrintable(tip(4)));
        QVERIFY(!name(4).contains("out of tries") && !name(5).contains("out of tries"));
        // A student who can continue an exam has an attempt left. The program does not notice when an exam is
        // abandoned.
        begun.begunUtc = "2026-11-20T11:20:00Z";
        QVERIFY(!hasNoneLeft(3));
        QVERIFY2(tip(3).contains("begun") && !tip(3).contains("no attempts left"), qPrintable(tip(3)));
        QVERIFY2(!name(3).contains("out of tries"), qPrintable(name(3)));
        begun.begunUtc = "2026-11-20T08:20:00Z";
        QVERIFY(hasNoneLeft(3));
        // The student's attempts show when the exam was begun.
        QSignalSpy wanted(m_page, &ClassPage::attemptsRequested);
        matrix()->setCurrentIndex(matrix()->model()->index(3, 1));
        QTest::keyClick(matrix(), Qt::Key_Return);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted[0][0].toLongLong(), 103);
    }

    /// Disabled students are listed as disabled and do not count.
    void whoIsDisabledNeedsNobody()
    {
        ClassOverview shown = overview(6, 2);
        shown.cells[4][0] = {1, 600, false, "2026-11-18T08:00:00Z"};
        const auto show = [&] {
            m_page->setOverview(shown, kNow);
            m_page->setAssignments({{1, {7}, "lesson-10", "2026-11-19T23:59:59Z", 1}});
            return child<QComboBox>("lessonChooser")->itemText(0);
        };
        const QString before = show();
        QVERIFY2(name(0).contains("out of tries") && name(4).contains("out of tries"), qPrintable(name(4)));
        for (const std::size_t student : {0U, 1U, 4U})
            shown.students[student].isDisabled = true;
        const QString after = show();
        QVERIFY2(before.contains(" of 4 passed") && after.contains(" of 2 passed"), qPrintable(before + after));
        for (const int row : {0, 1, 4}) {
            QVERIFY2(name(row).endsWith("– disabled"), qPrintable(name(row)));
            QVERIFY2(!tip(row).contains("overdue") && !tip(row).contains("no attempts left"), qPrintable(tip(row)));
        }
        QVERIFY2(textOf("needs").startsWith("2 "), qPrintable(textOf("needs")));
        QCOMPARE(m_page->table().rows.size(), qsizetype{6});
    }

    void theMatrixSortsByValueAndEmptyCellsComeLast()
    {
        for (const auto order : {Qt::AscendingOrder, Qt::DescendingOrder}) {
            matrix()->sortByColumn(1, order);
            QStringList scores;
            for (int row = 0; row < 12; ++row)
                scores << cell(row, 1);
            const auto firstEmpty = std::find(scores.begin(), scores.end(), "–");
            QVERIFY(std::all_of(firstEmpty, scores.end(), [](const QString& one) { return one == "–"; }));
            QVERIFY(firstEmpty != scores.end());
            QVERIFY(std::is_sorted(scores.begin(), firstEmpty, [order](const QString& a, const QString& b) {
                return order == Qt::AscendingOrder ? a.toDouble() < b.toDouble() : a.toDouble() > b.toDouble();
            }));
        }
        matrix()->sortByColumn(0, Qt::DescendingOrder);
        QCOMPARE(cell(0, 0), QString("today"));
        QCOMPARE(cell(11, 0), QString("–"));
        // The third click on a heading sorts by name again.
        QHeaderView* heads = matrix()->horizontalHeader();
        const QPoint at(heads->sectionViewportPosition(1) + 20, 20);
        for (int k = 0; k < 3; ++k)
            QTest::mouseClick(heads->viewport(), Qt::LeftButton, {}, at);
        QCOMPARE(name(11), QString("Student 1012"));
    }

    void aCellOpensTheAttempts()
    {
        QSignalSpy wanted(m_page, &ClassPage::attemptsRequested);
        QSignalSpy student(m_page, &ClassPage::studentRequested);
        const auto click = [&](int row, int column) {
            const QModelIndex index = matrix()->model()->index(row, column);
            QTest::mouseClick(matrix()->viewport(), Qt::LeftButton, {}, matrix()->visualRect(index).center());
        };
        click(3, 1);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted[0], (QVariantList{qint64{103}, "lesson-10"}));
        click(4, 1);  // not tried
        click(1, 1);  // has never logged in
        QCOMPARE(wanted.count(), 1);
        click(3, 0);
        click(1, 0);
        QCOMPARE(student.count(), 1);
        // The keyboard works as well.
        matrix()->setCurrentIndex(matrix()->model()->index(2, 1));
        matrix()->setFocus();
        for (const Qt::Key key : {Qt::Key_Down, Qt::Key_Right, Qt::Key_Return})
            QTest::keyClick(matrix(), key);
        QCOMPARE(wanted.count(), 2);
        QCOMPARE(wanted[1], (QVariantList{qint64{103}, "lesson-11"}));
        QCOMPARE(m_page->chosenLesson(), QString("lesson-11"));
    }

    void aLessonIsChosen()
    {
        QSignalSpy chosen(m_page, &ClassPage::lessonChosen);
        QCOMPARE(m_page->chosenLesson(), QString("lesson-10"));
        choose("lessonChooser", 1);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen[0][0].toString(), QString("lesson-11"));
        m_page->setOverview(overview(12, 6), kNow);  // read again: the same lesson
        QCOMPARE(m_page->chosenLesson(), QString("lesson-11"));
        QSignalSpy classes(m_page, &ClassPage::classChosen);
        choose("classChooser", 1);
        QCOMPARE(classes.count(), 1);
        QCOMPARE(classes[0][0].toLongLong(), 8);
        showOther(4);  // for comparison
        QCOMPARE(m_page->chosenLesson(), QString("lesson-11"));
    }

    /// Ten columns of ten points: a score on the border counts in the upper column, and the maximum in the last.
    void eachBestScoreIsInItsColumn()
    {
        const auto isTold = [this](const char* name) {
            return !ui::charts::stopsOf(child<ChartPanel>(name)->chart()).isEmpty();
        };
        for (const int people : {4, 5}) {  // a chart hides the results of fewer than five students
            m_page->setResults(results(people), 750, {{"depth", "Pulpal floor"}});
            for (const char* name : {"distribution", "learning", "difficulty"})
                QCOMPARE(isTold(name), people == 5);
        }
        const auto bars = std::get<ui::charts::Bars>(chart("difficulty").content).bars;
        QCOMPARE(bars[0].words, QString("Pulpal floor: the class loses 42 % of its points"));
        LessonResults eight = results(8);
        eight.bestTenths = {0, 99, 100, 499, 500, 750, 999, 1000};
        eight.curve = {{1, 8, 325, 505, 719}, {2, 6, 520, 640, 700}};
        m_page->setResults(eight, 750, {});
        QList<int> counts;
        const auto distribution = chart("distribution");
        for (const auto& bin : std::get<ui::charts::Histogram>(distribution.content).bins)
            counts << bin.count;
        QCOMPARE(counts, (QList<int>{2, 1, 0, 0, 1, 1, 0, 1, 0, 2}));
        // The learning curve: median and quartiles, attempt by attempt.
        const auto learning = chart("learning");
        const auto& slices = std::get<ui::charts::Curve>(learning.content).band.slices;
        QCOMPARE(slices.size(), 2);
        QCOMPARE((QList<double>{slices[0].low, slices[0].middle, slices[0].high, slices[1].middle}),
                 (QList<double>{32.5, 50.5, 71.9, 64.0}));
        // An answer for another lesson arrives too late.
        choose("lessonChooser", 1);
        m_page->setResults(results(23), 750, {});
        QVERIFY(!isTold("distribution"));
    }

    void theTableIsSaved()
    {
        const QTemporaryDir folder;
        ClassOverview odd = overview(12, 2);
        odd.students[3].fullName = "=HYPERLINK(\"x\")";
        m_page->setOverview(odd, kNow);
        QVERIFY(m_page->saveTable(folder.filePath("class.csv")));
        const auto table = QByteArray::fromStdString(support::bytesOf(folder.filePath("class.csv").toStdString()));
        const QList<QByteArray> lines = table.split('\n');
        QCOMPARE(lines.size(), 14);
        QCOMPARE(lines[1].trimmed(),
                 QByteArray("s-1001,Student 1001,stuck,2026-11-19T08:00:00Z,2026-11-20T12:00:00Z,33,1,0,39.1,1,0"));
        QVERIFY(lines[4].contains("\"'=HYPERLINK"));
        QCOMPARE(textOf("said"), "Saved: " + folder.filePath("class.csv"));
        QVERIFY(!m_page->saveTable("/nowhere/at/all.csv"));
    }

    void everyControlHasAName() { QCOMPARE(support::controlsWithoutNames(*m_page), QStringList()); }

private:
    [[nodiscard]] QTableView* matrix() const { return child<QTableView>("matrix"); }
    [[nodiscard]] int students() const { return matrix()->model()->rowCount(); }
    [[nodiscard]] QLineEdit* search() const { return child<QLineEdit>("studentSearch"); }
    [[nodiscard]] QString tip(int row) const
    {
        return matrix()->model()->index(row, 1).data(Qt::ToolTipRole).toString();
    }
    [[nodiscard]] ui::charts::Chart chart(const char* panel) const { return child<ChartPanel>(panel)->chart(); }
    /// Shows another class of this many students.
    void showOther(int size)
    {
        ClassOverview other = overview(size, 6);
        other.id = {8};
        m_page->setOverview(other, kNow);
    }
    void choose(const char* chooser, int row) const { child<QComboBox>(chooser)->setCurrentIndex(row); }
    [[nodiscard]] QString cell(int row, int column) const
    {
        return matrix()->model()->index(row, column).data().toString();
    }
    [[nodiscard]] QString name(int row) const { return matrix()->model()->headerData(row, Qt::Vertical).toString(); }
    QPushButton* button(const QString& text) const
    {
        for (QPushButton* one : m_page->findChildren<QPushButton*>())
            if (one->text() == text)
                return one;
        return nullptr;
    }
};

CUSP_TEST(TestClassPage)
#include "tst_class_page.moc"
