// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QDateEdit>
#include <QLineEdit>
#include <QListView>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableView>

#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/ui/PageTest.h"
#include "ui/people/AssignPage.h"
#include "ui/text/PeopleTexts.h"

using database::ClassAssignment;
using ui::people::AssignmentChange;
using ui::people::AssignPage;

Q_DECLARE_METATYPE(QList<ui::people::AssignmentChange>)

namespace {

const QDateTime kToday(QDate(2026, 11, 20), QTime(12, 0), Qt::UTC);
constexpr database::ClassId kClass{7};

/// Returns a class of four students. Two of them have passed lesson "a", and three have tried it.
database::ClassOverview classOf()
{
    database::ClassOverview made{kClass, "DEN101-A", {}, {"a", "b"}, {}};
    for (int k = 0; k < 4; ++k) {
        database::MatrixStudent one;
        one.id = {k + 1};
        made.students.push_back(one);
        made.cells.push_back({{k < 3 ? 1 : 0, 800, k < 2, ""}, {}});
    }
    return made;
}

}  // namespace

class TestAssignPage : public support::PageTest<AssignPage>
{
    Q_OBJECT
private slots:
    /// A limit of 150 is refused, and not changed to 15.
    void aLimitBeyondTheRangeIsNoOther()
    {
        auto* limit = first<QSpinBox>("attemptLimit");
        limit->setValue(3);
        for (const auto& [typed, value] : {std::pair("150", 3), {"1000", 3}, {"12", 12}}) {
            limit->setFocus();
            limit->selectAll();
            QTest::keyClicks(limit, typed);
            QTest::keyClick(limit, Qt::Key_Return);
            QCOMPARE(limit->value(), value);
        }
    }

    void initTestCase() { prepare(); }
    void init()
    {
        openPage();
        m_page->setLessons({{"a", "Decay, small", "Upper left first molar (26)", "Removing decay", {}, 0},
                            {"b", "Decay, deep", "Lower left first molar (36)", "Removing decay", {}, 0},
                            {"c", "Class I", "Lower left first molar (36)", "Cavities", {}, 0},
                            {"d", "Cross", "Practice block", "Blocks", "dd", 4}});
        m_page->setAssignments(
            classOf(), {{1, kClass, "a", "2026-11-15T23:59:59Z", 3}, {2, {8}, "c", "", 0}, {3, kClass, "b", "", 0}},
            kToday);
    }

    void severalLessonsAreGivenAtOnce()
    {
        QSignalSpy spy(m_page, &AssignPage::changeRequested);
        const auto* assign = child<QPushButton>("assignTicked");
        QVERIFY(!assign->isEnabled());
        tick("Class I");
        tick("Cross");
        const QDate day(2026, 12, 4);
        first<QDateEdit>("dueDay")->setDate(day);
        first<QSpinBox>("attemptLimit")->setValue(5);
        click("assignTicked");
        const std::string due = ui::text::endOfDay(day);
        const QList<AssignmentChange> expected{{{}, ClassAssignment{0, kClass, "c", due, 5}},
                                               {{}, ClassAssignment{0, kClass, "d", due, 5, "dd", 4}}};
        QCOMPARE(wanted(spy), expected);
        QVERIFY(!assign->isEnabled());  // disabled until the answer
        m_page->refuse("The database is locked.");
        QVERIFY(textOf("assignSaid").contains("locked"));
        QVERIFY(assign->isEnabled() && !child<QPushButton>("undoAssign")->isVisible());
        click("assignTicked");
        m_page->confirm(expected);
        QVERIFY(child<QPushButton>("undoAssign")->isVisible());
    }

    /// A lesson that the search hides cannot be ticked by the keyboard.
    void keysGoToALessonThatIsSeen()
    {
        auto* list = child<QListView>("offers");
        list->setCurrentIndex(offer("Class I"));
        child<QLineEdit>("offerSearch")->setText("cross");
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Space);
        QCOMPARE(offer("Class I").data(Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
        QCOMPARE(offer("Cross").data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
        QVERIFY(!child<QLabel>("noneFits")->isVisibleTo(m_page));
        child<QLineEdit>("offerSearch")->setText("no such lesson");
        QVERIFY(child<QLabel>("noneFits")->isVisibleTo(m_page));
        QTest::keyClick(list, Qt::Key_Space);
        QCOMPARE(child<QPushButton>("assignTicked")->text(), QString("Assign 1 lesson(s)"));
    }

    void whatIsGivenCannotBeGivenAgain()
    {
        const QStringList small{"Decay, small", row(0)[1], "3", "2 of 4"};
        QCOMPARE(row(0), small);
        QVERIFY2(row(0)[1].endsWith("over"), qPrintable(row(0)[1]));
        QCOMPARE(row(1), QStringList({"Decay, deep", "–", "no limit", "0 of 4"}));
        tick("Decay, small");
        QVERIFY(!child<QPushButton>("assignTicked")->isEnabled());
        // Ticked lessons stay ticked when the class is read again, unless they have been assigned meanwhile.
        tick("Class I");
        tick("Cross");
        m_page->setAssignments(classOf(), {{4, kClass, "c", "", 0}}, kToday);
        QCOMPARE(child<QPushButton>("assignTicked")->text(), QString("Assign 1 lesson(s)"));
        QCOMPARE(offer("Cross").data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
    }

    void theSearchLooksAtTitlesTeethAndGroups()
    {
        auto* search = child<QLineEdit>("offerSearch");
        for (const auto& [words, found] :
             {std::pair<QString, QStringList>("36", {"Removing decay", "Decay, deep", "Cavities", "Class I"}),
              {"decay 26", {"Removing decay", "Decay, small"}},
              {"nothing of that", {}}}) {
            search->setText(words);
            QCOMPARE(offered(), found);
        }
        search->clear();
        QCOMPARE(offered().size(), 7);
        // A ticked lesson that the search does not find is assigned as well. The button shows the number.
        tick("Cross");
        search->setText("36");
        QCOMPARE(child<QPushButton>("assignTicked")->text(), QString("Assign 1 lesson(s)"));
    }

    void theEndOfTheDayHereIsMeant()
    {
        const QByteArray before = qgetenv("TZ");
        const auto back = qScopeGuard([&before] { before.isNull() ? qunsetenv("TZ") : qputenv("TZ", before); });
        qputenv("TZ", "America/New_York");
        const QDate day(2026, 7, 1);
        QCOMPARE(ui::text::endOfDay(day), std::string("2026-07-02T03:59:59Z"));
        QCOMPARE(ui::text::dueDay("2026-07-02T03:59:59Z"), day);
        QVERIFY(!ui::text::dueDay("").isValid());
    }

    void whatIsNotChangedStaysEachLessonsOwn()
    {
        const ClassAssignment a{1, kClass, "a", "2026-11-15T23:59:59Z", 3};
        const ClassAssignment b{3, kClass, "b", "", 0};
        const QDate day(2100, 12, 4);
        const std::string due = ui::text::endOfDay(day);
        const auto change = [&](const std::function<void()>& turn) {
            QSignalSpy spy(m_page, &AssignPage::changeRequested);
            child<QTableView>("given")->clearSelection();
            child<QTableView>("given")->selectAll();
            turn();
            click("changeGiven");
            m_page->refuse("Not now.");
            return wanted(spy);
        };
        QCOMPARE(change([&] { last<QSpinBox>("attemptLimit")->setValue(5); }),
                 (QList<AssignmentChange>{{a, ClassAssignment{1, kClass, "a", a.dueUtc, 5}},
                                          {b, ClassAssignment{3, kClass, "b", "", 5}}}));
        QCOMPARE(change([&] { last<QDateEdit>("dueDay")->setDate(day); }),
                 (QList<AssignmentChange>{{a, ClassAssignment{1, kClass, "a", due, 3}},
                                          {b, ClassAssignment{3, kClass, "b", due, 0}}}));
        // Only assignments that differ are changed.
        QCOMPARE(change([&] {
                     last<QCheckBox>("isDue")->setChecked(false);
                     last<QSpinBox>("attemptLimit")->setValue(0);
                 }),
                 (QList<AssignmentChange>{{a, ClassAssignment{1, kClass, "a", "", 0}}}));
    }

    void takenBackIsUndone()
    {
        QSignalSpy spy(m_page, &AssignPage::changeRequested);
        child<QTableView>("given")->selectRow(1);
        click("takeBack");
        const ClassAssignment given{3, kClass, "b", "", 0};
        QCOMPARE(wanted(spy), (QList<AssignmentChange>{{given, {}}}));
        m_page->confirm(wanted(spy));
        click("undoAssign");
        QCOMPARE(wanted(spy), (QList<AssignmentChange>{{{}, given}}));
        m_page->confirm(wanted(spy));
        QVERIFY(!child<QPushButton>("undoAssign")->isVisible());
    }

    /// A class keeps the version that it was assigned until the teacher decides.
    void aLaterVersionIsOffered()
    {
        const ClassAssignment third{1, kClass, "d", "", 3, "cc", 3};
        const auto* later = child<QPushButton>("assignLater");
        const auto choose = [&](const QList<ClassAssignment>& given) {
            m_page->setAssignments(classOf(), given, kToday);
            child<QTableView>("given")->selectAll();
        };
        choose({third});
        QVERIFY2(later->isVisible() && later->text().contains("version 4"), qPrintable(later->text()));
        QVERIFY(row(0)[0] != "Cross");
        QSignalSpy spy(m_page, &AssignPage::changeRequested);
        click("assignLater");
        ClassAssignment fourth = third;
        fourth.lessonHash = "dd";
        fourth.lessonVersion = 4;
        QCOMPARE(wanted(spy), (QList<AssignmentChange>{{third, fourth}}));
        m_page->confirm({{third, fourth}});
        click("undoAssign");
        QCOMPARE(wanted(spy), (QList<AssignmentChange>{{fourth, third}}));
        m_page->confirm({{fourth, third}});
        // Nothing is offered in place of the same version or of a later one, and a changed file only as such.
        choose({fourth});
        QVERIFY(!later->isVisible());
        QCOMPARE(row(0)[0], QString("Cross"));
        choose({{1, kClass, "d", "", 3, "ee", 5}});
        QVERIFY(!later->isVisible());
        choose({{1, kClass, "d", "", 3, "ee", 4}});
        QVERIFY2(later->isVisible() && !later->text().contains("4"), qPrintable(later->text()));
        // A change of the due date keeps the version.
        choose({third});
        last<QSpinBox>("attemptLimit")->setValue(9);
        click("changeGiven");
        QCOMPARE(wanted(spy).front().after->lessonHash, third.lessonHash);
    }

    void whoHasNoAttemptsLeftIsTold()
    {
        const ClassAssignment given{1, kClass, "a", "", 0};
        const ClassAssignment once{1, kClass, "a", "", 1};
        const auto said = [this] { return textOf("assignSaid"); };
        m_page->confirm({{given, once}});
        // Two students have passed, one has tried, one has not.
        QVERIFY2(said().contains("1 student(s) who have not passed"), qPrintable(said()));
        m_page->confirm({{once, ClassAssignment{1, kClass, "a", "", 2}}});
        QVERIFY2(!said().contains("student(s)"), qPrintable(said()));
        // A student is counted once for both lessons: a different one has used up the attempts at each, and one at
        // both.
        database::ClassOverview two = classOf();
        two.lessons = {"a", "b"};
        two.cells.assign(two.students.size(), std::vector<database::MatrixCell>(2));
        for (const auto& [student, lesson] : {std::pair(0, 0), std::pair(1, 1), std::pair(2, 0), std::pair(2, 1)})
            two.cells[static_cast<std::size_t>(student)][static_cast<std::size_t>(lesson)].attempts = 1;
        m_page->setAssignments(two, {given}, kToday);
        m_page->confirm({{given, once}, {{}, ClassAssignment{2, kClass, "b", "", 1}}});
        QVERIFY2(said().contains("3 student(s) who have not passed"), qPrintable(said()));
    }

    void theNextBeginsAfresh_data() { support::rows<bool>("isTeacher", {false, true}); }
    /// No selection or undo of the previous teacher or class is left for the next one.
    void theNextBeginsAfresh()
    {
        QFETCH(bool, isTeacher);
        auto* due = first<QCheckBox>("isDue");
        const bool wasDue = due->isChecked();
        tick("Cross");
        m_page->confirm({{{}, ClassAssignment{0, kClass, "c", "", 0}}});
        if (isTeacher) {
            due->setChecked(!wasDue);
            first<QSpinBox>("attemptLimit")->setValue(3);
            m_page->forget();
        }
        database::ClassOverview other = classOf();
        other.id = {8};
        other.name = "DEN101-B";
        m_page->setAssignments(other, {}, kToday);
        QVERIFY(textOf("givenTitle").contains("DEN101-B"));
        QVERIFY(child<QLabel>("nothingGiven")->isVisible() && textOf("assignSaid").isEmpty());
        QVERIFY(!child<QPushButton>("undoAssign")->isVisible() && !child<QPushButton>("assignTicked")->isEnabled());
        QCOMPARE(due->isChecked(), wasDue);
        QCOMPARE(first<QSpinBox>("attemptLimit")->value(), 0);
    }

    void everyControlHasAName() { QCOMPARE(support::controlsWithoutNames(*m_page), QStringList()); }

private:
    template <class T>
    T* last(const char* name)
    {
        return m_page->findChildren<T*>(QString::fromLatin1(name)).back();
    }
    template <class T>
    T* first(const char* name)
    {
        return m_page->findChildren<T*>(QString::fromLatin1(name)).front();
    }
    QModelIndex offer(const QString& title)
    {
        const auto* model = child<QListView>("offers")->model();
        for (int row = 0; row < model->rowCount(); ++row)
            if (model->index(row, 0).data().toString() == title)
                return model->index(row, 0);
        return {};
    }
    QStringList offered()
    {
        const auto* list = child<QListView>("offers");
        QStringList shown;
        for (int row = 0; row < list->model()->rowCount(); ++row)
            if (!list->isRowHidden(row))
                shown << list->model()->index(row, 0).data().toString();
        return shown;
    }
    void tick(const QString& title)
    {
        auto* list = child<QListView>("offers");
        const QRect row = list->visualRect(offer(title));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, QPoint(row.right() - 20, row.center().y()));
    }
    QStringList row(int k)
    {
        QStringList cells;
        const auto* model = child<QTableView>("given")->model();
        for (int column = 0; column < model->columnCount(); ++column)
            cells << model->index(k, column).data().toString();
        return cells;
    }
    QList<AssignmentChange> wanted(const QSignalSpy& spy)
    {
        return spy.isEmpty() ? QList<AssignmentChange>() : spy.back().front().value<QList<AssignmentChange>>();
    }
};

CUSP_TEST(TestAssignPage)
#include "tst_assign_page.moc"
