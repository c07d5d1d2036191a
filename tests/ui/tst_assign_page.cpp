// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QDateEdit>
#include <QFocusEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableView>
#include <QTest>

#include <memory>

#include "ui/people/AssignPage.h"
#include "ui/people/AssignTerms.h"
#include "ui/people/PeopleWords.h"
#include "ui/shell/Actions.h"
#include "ui/shell/Theme.h"

using database::ClassAssignment;
using ui::people::AssignmentChange;
using ui::people::AssignPage;

Q_DECLARE_METATYPE(QList<ui::people::AssignmentChange>)

namespace {

const QDateTime kNow(QDate(2026, 11, 20), QTime(12, 0), Qt::UTC);
constexpr database::ClassId kClass{7};

/// Four students. Lesson "a" was passed by two of them and tried by three.
database::ClassOverview overview()
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

class TestAssignPage : public QObject
{
    Q_OBJECT
private slots:
    void aLimitBeyondTheRangeIsNoOther();
    void initTestCase();
    void init();
    void severalLessonsAreGivenAtOnce();
    void whereALessonOfOnesOwnIsFoundIsToldBeforeItIsGiven();
    void aLessonIsTickedByKeyAndByAClickAnywhere();
    void keysGoToALessonThatIsSeen();
    void whatIsGivenCannotBeGivenAgain();
    void theSearchLooksAtTitlesTeethAndGroups();
    void theTableTellsWhenAndHowFar();
    void theEndOfTheDayHereIsMeant();
    void chosenOnesAreChangedAndOnlyThoseThatDiffer();
    void whatIsNotChangedStaysEachLessonsOwn();
    void aDayThatIsOverIsTold();
    void aDayIsTypedAsItIsWritten();
    void takenBackIsUndone();
    void theKeyboardStaysWhereItWorks();
    void whoHasNoAttemptsLeftIsTold();
    void whatIsRefusedIsSaid();
    void anotherClassBeginsAfresh();
    void anotherTeacherBeginsAfresh();
    void everyControlHasAName();

private:
    template <class T>
    T* get(const char* name)
    {
        return m_page->findChild<T*>(QString::fromLatin1(name));
    }
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
        const auto* model = get<QListView>("offers")->model();
        for (int row = 0; row < model->rowCount(); ++row)
            if (model->index(row, 0).data().toString() == title)
                return model->index(row, 0);
        return {};
    }
    QStringList offered()
    {
        const auto* list = get<QListView>("offers");
        QStringList shown;
        for (int row = 0; row < list->model()->rowCount(); ++row)
            if (!list->isRowHidden(row))
                shown << list->model()->index(row, 0).data().toString();
        return shown;
    }
    void click(const QString& title)
    {
        auto* list = get<QListView>("offers");
        const QRect row = list->visualRect(offer(title));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, QPoint(row.right() - 20, row.center().y()));
    }
    QStringList row(int k)
    {
        QStringList cells;
        const auto* model = get<QTableView>("given")->model();
        for (int column = 0; column < model->columnCount(); ++column)
            cells << model->index(k, column).data().toString();
        return cells;
    }
    QList<AssignmentChange> wanted(const QSignalSpy& spy)
    {
        return spy.isEmpty() ? QList<AssignmentChange>() : spy.back().front().value<QList<AssignmentChange>>();
    }

    std::unique_ptr<QWidget> m_window;
    ui::shell::Actions* m_actions = nullptr;
    AssignPage* m_page = nullptr;
};

void TestAssignPage::initTestCase()
{
    QLocale::setDefault(QLocale("en_GB"));
    ui::shell::applyTheme(*qApp, ui::shell::ThemeChoice::Light);
}

void TestAssignPage::init()
{
    m_window = std::make_unique<QWidget>();
    m_actions = new ui::shell::Actions(m_window.get());
    m_page = new AssignPage(*m_actions, m_window.get());
    m_window->resize(1280, 800);
    m_page->resize(1280, 800);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    m_page->setLessons({{"a", "Decay, small", "Upper left first molar (26)", "Removing decay", {}},
                        {"b", "Decay, deep", "Lower left first molar (36)", "Removing decay", {}},
                        {"c", "Class I", "Lower left first molar (36)", "Cavities", {}},
                        {"d", "Cross", "Practice block", "Blocks", "/lessons of ines/cross.lesson.json"}});
    m_page->setAssignments(
        overview(), {{1, kClass, "a", "2026-11-15T23:59:59Z", 3}, {2, {8}, "c", "", 0}, {3, kClass, "b", "", 0}}, kNow);
}

void TestAssignPage::severalLessonsAreGivenAtOnce()
{
    QSignalSpy spy(m_page, &AssignPage::changeWanted);
    auto* assign = get<QPushButton>("assignTicked");
    QVERIFY(!assign->isEnabled());
    click("Class I");
    click("Cross");
    QCOMPARE(assign->text(), QString("Assign 2 lesson(s)"));
    const QDate day(2026, 12, 4);
    first<QDateEdit>("dueDay")->setDate(day);
    first<QSpinBox>("attemptLimit")->setValue(5);
    assign->click();
    const std::string due = ui::people::endOfDay(day);
    const QList<AssignmentChange> expected{{{}, ClassAssignment{0, kClass, "c", due, 5}},
                                           {{}, ClassAssignment{0, kClass, "d", due, 5}}};
    QCOMPARE(wanted(spy), expected);
    QVERIFY(!assign->isEnabled());  // until it has been done
    m_page->confirm(expected);
    QCOMPARE(get<QLabel>("assignSaid")->text(), QString("2 lesson(s) assigned."));
    QVERIFY(get<QPushButton>("undoAssign")->isVisible());
}

void TestAssignPage::whereALessonOfOnesOwnIsFoundIsToldBeforeItIsGiven()
{
    const auto* where = get<QLabel>("whereLessonsAre");
    click("Class I");  // shipped
    QVERIFY(!where->isVisible());
    click("Cross");
    QVERIFY(where->isVisible());
    QVERIFY2(where->text().startsWith("1 lesson(s) of your own: Cross.") &&
                 where->text().contains("/lessons of ines/cross.lesson.json"),
             qPrintable(where->text()));
    click("Cross");
    QVERIFY(!where->isVisible());
}

void TestAssignPage::aLessonIsTickedByKeyAndByAClickAnywhere()
{
    auto* list = get<QListView>("offers");
    list->setFocus();
    list->setCurrentIndex(offer("Class I"));
    QTest::keyClick(list, Qt::Key_Space);
    QCOMPARE(offer("Class I").data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
    click("Class I");
    QCOMPARE(offer("Class I").data(Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
}

/// What the search has put away is not ticked unseen.
void TestAssignPage::keysGoToALessonThatIsSeen()
{
    auto* list = get<QListView>("offers");
    list->setCurrentIndex(offer("Class I"));
    get<QLineEdit>("offerSearch")->setText("cross");
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Space);
    QCOMPARE(offer("Class I").data(Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
    QCOMPARE(offer("Cross").data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
    QVERIFY(!get<QLabel>("noneFits")->isVisibleTo(m_page));
    get<QLineEdit>("offerSearch")->setText("no such lesson");
    QVERIFY(get<QLabel>("noneFits")->isVisibleTo(m_page));
    QTest::keyClick(list, Qt::Key_Space);
    QCOMPARE(get<QPushButton>("assignTicked")->text(), QString("Assign 1 lesson(s)"));
}

void TestAssignPage::whatIsGivenCannotBeGivenAgain()
{
    click("Decay, small");
    QVERIFY(!get<QPushButton>("assignTicked")->isEnabled());
    // What is ticked stays when the class is told again, unless it has been given meanwhile.
    click("Class I");
    click("Cross");
    m_page->setAssignments(overview(), {{4, kClass, "c", "", 0}}, kNow);
    QCOMPARE(get<QPushButton>("assignTicked")->text(), QString("Assign 1 lesson(s)"));
    QCOMPARE(offer("Cross").data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
}

void TestAssignPage::theSearchLooksAtTitlesTeethAndGroups()
{
    auto* search = get<QLineEdit>("offerSearch");
    search->setText("36");
    QCOMPARE(offered(), QStringList({"Removing decay", "Decay, deep", "Cavities", "Class I"}));
    search->setText("decay 26");
    QCOMPARE(offered(), QStringList({"Removing decay", "Decay, small"}));
    search->setText("nothing of that");
    QCOMPARE(offered(), QStringList());
    search->clear();
    QCOMPARE(offered().size(), 7);
    // What is ticked and not found is given all the same: the button says how many.
    click("Cross");
    search->setText("36");
    QCOMPARE(get<QPushButton>("assignTicked")->text(), QString("Assign 1 lesson(s)"));
}

void TestAssignPage::theTableTellsWhenAndHowFar()
{
    QCOMPARE(get<QTableView>("given")->model()->rowCount(), 2);
    QVERIFY2(row(0)[1].endsWith("over"), qPrintable(row(0)[1]));
    QCOMPARE(row(0)[0], QString("Decay, small"));
    QCOMPARE(row(0)[2], QString("3"));
    QCOMPARE(row(0)[3], QString("2 of 4"));
    QCOMPARE(row(1), QStringList({"Decay, deep", "–", "no limit", "0 of 4"}));
}

void TestAssignPage::theEndOfTheDayHereIsMeant()
{
    const QByteArray before = qgetenv("TZ");
    qputenv("TZ", "America/New_York");
    const QDate day(2026, 7, 1);
    QCOMPARE(ui::people::endOfDay(day), std::string("2026-07-02T03:59:59Z"));
    QCOMPARE(ui::people::dueDay("2026-07-02T03:59:59Z"), day);
    if (before.isEmpty())
        qunsetenv("TZ");
    else
        qputenv("TZ", before);
    QVERIFY(!ui::people::dueDay("").isValid());
}

void TestAssignPage::chosenOnesAreChangedAndOnlyThoseThatDiffer()
{
    QSignalSpy spy(m_page, &AssignPage::changeWanted);
    auto* table = get<QTableView>("given");
    QVERIFY(!get<QPushButton>("changeGiven")->isEnabled());
    table->selectAll();
    QCOMPARE(last<QSpinBox>("attemptLimit")->value(), 3);  // of the first of them
    last<QCheckBox>("isDue")->setChecked(false);
    last<QSpinBox>("attemptLimit")->setValue(0);
    get<QPushButton>("changeGiven")->click();
    const QList<AssignmentChange> expected{
        {ClassAssignment{1, kClass, "a", "2026-11-15T23:59:59Z", 3}, ClassAssignment{1, kClass, "a", "", 0}}};
    QCOMPARE(wanted(spy), expected);
    m_page->confirm(expected);
    QCOMPARE(get<QLabel>("assignSaid")->text(), QString("1 lesson(s) changed."));
}

void TestAssignPage::whatIsNotChangedStaysEachLessonsOwn()
{
    QSignalSpy spy(m_page, &AssignPage::changeWanted);
    get<QTableView>("given")->selectAll();
    QVERIFY(last<QLabel>("termsNote")->text().contains("Each lesson keeps"));
    last<QSpinBox>("attemptLimit")->setValue(5);
    get<QPushButton>("changeGiven")->click();
    const ClassAssignment a{1, kClass, "a", "2026-11-15T23:59:59Z", 3};
    const ClassAssignment b{3, kClass, "b", "", 0};
    const QList<AssignmentChange> limits{{a, ClassAssignment{1, kClass, "a", a.dueUtc, 5}},
                                         {b, ClassAssignment{3, kClass, "b", "", 5}}};
    QCOMPARE(wanted(spy), limits);
    m_page->refuse("Not now.");
    // And the other way round.
    get<QTableView>("given")->clearSelection();
    get<QTableView>("given")->selectAll();
    const QDate day(2100, 12, 4);
    last<QDateEdit>("dueDay")->setDate(day);
    get<QPushButton>("changeGiven")->click();
    const std::string due = ui::people::endOfDay(day);
    const QList<AssignmentChange> days{{a, ClassAssignment{1, kClass, "a", due, 3}},
                                       {b, ClassAssignment{3, kClass, "b", due, 0}}};
    QCOMPARE(wanted(spy), days);
}

void TestAssignPage::aDayThatIsOverIsTold()
{
    const auto* note = first<QLabel>("termsNote");
    QVERIFY(!note->isVisible());
    first<QDateEdit>("dueDay")->setDate(QDate::currentDate().addDays(-1));
    QVERIFY(note->isVisible());
    QVERIFY2(note->text().contains("over"), qPrintable(note->text()));
    first<QCheckBox>("isDue")->setChecked(false);
    QVERIFY(!note->isVisible());
    first<QCheckBox>("isDue")->setChecked(true);
    first<QDateEdit>("dueDay")->setDate(QDate::currentDate());
    QVERIFY(!note->isVisible());
}

/// Whatever of it was pointed at.
void TestAssignPage::aDayIsTypedAsItIsWritten()
{
    auto* day = first<QDateEdit>("dueDay");
    day->setDate(QDate(2026, 12, 2));
    const QString typed = QLocale().toString(QDate(2027, 2, 15), day->displayFormat());
    QTest::keyClick(day, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(day, typed);
    QCOMPARE(day->date(), QDate(2027, 2, 15));
    day->setDate(QDate(2026, 12, 2));
    day->setCurrentSectionIndex(2);
    QFocusEvent come(QEvent::FocusIn, Qt::MouseFocusReason);  // without a window manager none comes of itself
    QApplication::sendEvent(day, &come);
    QTRY_COMPARE(day->currentSectionIndex(), 0);
    QTest::keyClicks(day, typed);
    QCOMPARE(day->date(), QDate(2027, 2, 15));
}

void TestAssignPage::takenBackIsUndone()
{
    QSignalSpy spy(m_page, &AssignPage::changeWanted);
    get<QTableView>("given")->selectRow(1);
    get<QPushButton>("takeBack")->click();
    const ClassAssignment given{3, kClass, "b", "", 0};
    QCOMPARE(wanted(spy), (QList<AssignmentChange>{{given, {}}}));
    m_page->confirm(wanted(spy));
    QCOMPARE(get<QLabel>("assignSaid")->text(), QString("1 lesson(s) taken back; attempts stay."));
    get<QPushButton>("undoAssign")->click();
    QCOMPARE(wanted(spy), (QList<AssignmentChange>{{{}, given}}));
    m_page->confirm(wanted(spy));
    QCOMPARE(get<QLabel>("assignSaid")->text(), QString("That was undone."));
    QVERIFY(!get<QPushButton>("undoAssign")->isVisible());
}

void TestAssignPage::theKeyboardStaysWhereItWorks()
{
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    QSignalSpy spy(m_page, &AssignPage::changeWanted);
    get<QTableView>("given")->selectRow(0);
    last<QSpinBox>("attemptLimit")->setValue(9);
    get<QPushButton>("changeGiven")->setFocus();
    QTest::keyClick(get<QPushButton>("changeGiven"), Qt::Key_Return);
    QCOMPARE(QApplication::focusWidget(), get<QTableView>("given"));
    m_page->confirm(wanted(spy));
    QCOMPARE(QApplication::focusWidget(), get<QPushButton>("undoAssign"));
    // Into an empty list.
    m_page->setAssignments(overview(), {}, kNow);
    click("Cross");
    get<QPushButton>("assignTicked")->setFocus();
    QTest::keyClick(get<QPushButton>("assignTicked"), Qt::Key_Return);
    QCOMPARE(QApplication::focusWidget(), get<QListView>("offers"));
    const QList<AssignmentChange> given = wanted(spy);
    m_page->confirm(given);
    m_page->setAssignments(overview(), {*given.front().after}, kNow);
    QCOMPARE(QApplication::focusWidget(), get<QPushButton>("undoAssign"));
    // And undone, so that it is empty again.
    QTest::keyClick(get<QPushButton>("undoAssign"), Qt::Key_Return);
    m_page->confirm(wanted(spy));
    m_page->setAssignments(overview(), {}, kNow);
    QCOMPARE(QApplication::focusWidget(), get<QListView>("offers"));
}

void TestAssignPage::whoHasNoAttemptsLeftIsTold()
{
    const ClassAssignment given{1, kClass, "a", "", 0};
    const ClassAssignment once{1, kClass, "a", "", 1};
    m_page->confirm({{given, once}});
    // Two have passed, one has tried, one has not.
    QVERIFY2(get<QLabel>("assignSaid")->text().contains("1 student(s) who have not passed have no attempts left"),
             qPrintable(get<QLabel>("assignSaid")->text()));
    m_page->confirm({{once, ClassAssignment{1, kClass, "a", "", 2}}});
    QCOMPARE(get<QLabel>("assignSaid")->text(), QString("1 lesson(s) changed."));
    // Of two lessons everybody is counted once: another is stuck at each, and one at both.
    database::ClassOverview two = overview();
    two.lessons = {"a", "b"};
    two.cells.assign(two.students.size(), std::vector<database::MatrixCell>(2));
    for (const auto& [student, lesson] : {std::pair(0, 0), std::pair(1, 1), std::pair(2, 0), std::pair(2, 1)})
        two.cells[static_cast<std::size_t>(student)][static_cast<std::size_t>(lesson)].attempts = 1;
    m_page->setAssignments(two, {given}, kNow);
    m_page->confirm({{given, once}, {{}, ClassAssignment{2, kClass, "b", "", 1}}});
    QVERIFY2(get<QLabel>("assignSaid")->text().contains("3 student(s) who have not passed have no attempts left"),
             qPrintable(get<QLabel>("assignSaid")->text()));
}

void TestAssignPage::whatIsRefusedIsSaid()
{
    click("Cross");
    get<QPushButton>("assignTicked")->click();
    m_page->refuse("The database is locked.");
    QVERIFY(get<QLabel>("assignSaid")->text().contains("locked"));
    QVERIFY(get<QPushButton>("assignTicked")->isEnabled());  // to be tried again
    QVERIFY(!get<QPushButton>("undoAssign")->isVisible());
}

void TestAssignPage::anotherClassBeginsAfresh()
{
    click("Cross");
    m_page->confirm({{{}, ClassAssignment{0, kClass, "d", "", 0}}});
    database::ClassOverview other = overview();
    other.id = {8};
    other.name = "DEN101-B";
    m_page->setAssignments(other, {{2, {8}, "c", "", 0}}, kNow);
    QVERIFY(get<QLabel>("givenTitle")->text().contains("DEN101-B"));
    QVERIFY(get<QLabel>("assignSaid")->text().isEmpty());
    QVERIFY(!get<QPushButton>("undoAssign")->isVisible());
    QCOMPARE(get<QPushButton>("assignTicked")->text(), QString("Assign"));
    m_page->setAssignments(other, {}, kNow);
    QVERIFY(get<QLabel>("nothingGiven")->isVisible());
}

/// Nothing of the one before is there to be given, or undone, under another's name.
void TestAssignPage::anotherTeacherBeginsAfresh()
{
    auto* due = first<QCheckBox>("isDue");
    const bool wasDue = due->isChecked();
    click("Cross");
    QCOMPARE(get<QPushButton>("assignTicked")->text(), QString("Assign 1 lesson(s)"));
    due->setChecked(!wasDue);
    first<QSpinBox>("attemptLimit")->setValue(3);
    m_page->confirm({{{}, ClassAssignment{0, kClass, "c", "", 0}}});
    m_page->forget();
    m_page->setAssignments(overview(), {}, kNow);
    QVERIFY(get<QLabel>("assignSaid")->text().isEmpty());
    QVERIFY(!get<QPushButton>("undoAssign")->isVisible());
    QCOMPARE(get<QPushButton>("assignTicked")->text(), QString("Assign"));
    QCOMPARE(due->isChecked(), wasDue);
    QCOMPARE(first<QSpinBox>("attemptLimit")->value(), 0);
}

void TestAssignPage::everyControlHasAName()
{
    for (QWidget* widget : m_page->findChildren<QWidget*>())
        if (widget->focusPolicy() != Qt::NoFocus && widget->isVisible() && !widget->inherits("QAbstractScrollArea") &&
            widget->parentWidget() != nullptr && !widget->parentWidget()->inherits("QAbstractItemView") &&
            !widget->inherits("QLineEdit"))
            QVERIFY2(!widget->accessibleName().isEmpty(),
                     qPrintable(QString("%1 %2").arg(widget->metaObject()->className(), widget->objectName())));
}

/// 150 is no 15.
void TestAssignPage::aLimitBeyondTheRangeIsNoOther()
{
    ui::people::AssignTerms terms(nullptr);
    terms.show();
    auto* limit = terms.findChild<QSpinBox*>("attemptLimit");
    limit->setValue(3);
    for (const char* typed : {"150", "1000"}) {
        limit->setFocus();
        limit->selectAll();
        QTest::keyClicks(limit, typed);
        QTest::keyClick(limit, Qt::Key_Return);
        QCOMPARE(limit->value(), 3);
    }
    limit->setFocus();
    limit->selectAll();
    QTest::keyClicks(limit, "12");
    QTest::keyClick(limit, Qt::Key_Return);
    QCOMPARE(limit->value(), 12);
}

QTEST_MAIN(TestAssignPage)
#include "tst_assign_page.moc"
