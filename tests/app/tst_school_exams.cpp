// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program and what is given: due dates, how often one may try, and exams.
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QTableView>
#include <QTest>

#include "database/sql/Classes.h"
#include "database/sql/ExamStarts.h"
#include "database/sql/Statement.h"
#include "lessons/LessonReader.h"
#include "lessons/PresetFile.h"
#include "tests/app/SchoolWindow.h"
#include "tests/support/OpenGlMain.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryPage.h"
#include "ui/study/Forecast.h"
#include "ui/study/LessonCards.h"
#include "ui/study/LessonsPage.h"
#include "ui/tooth/ToothView.h"

using namespace database;
using support::Exam;
using support::kPatienceMs;
using support::OtherStation;

class TestSchoolExams : public support::SchoolWindow
{
    Q_OBJECT
private slots:
    void init() { makeSchool(); }
    void cleanup() { m_application.reset(); }

    void anExamThatWasNotKeptIsGradedAgain();
    void whatIsGivenIsDueAndLimited();
    void noneBeginsAgainWhenTheAttemptsAreUsedUp();
    void aPresetGivesNoAttemptBack();
    void anUnfinishedAttemptIsNotTakenUpWhenTheAttemptsAreUsedUp();
    void anExamThatIsBrokenOffIsToldOf();
    void whatComesAfterAnExamTakesNoTime();
    void anExamIsBegunInOneWindow();
    void anExamThatIsTakenUpWasBegunOnce();
    void anExamHidesEarlierAttempts();
    void aGuestsExamIsNobodys();

private:
    /// Sam, whom one attempt at the exam is left.
    void comeForOneAttempt();
};

void TestSchoolExams::comeForOneAttempt()
{
    give("exam-36", 1);
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::LessonsPage>()->isVisible(), kPatienceMs);
}

/// As it stands: its score was seen.
void TestSchoolExams::anExamThatWasNotKeptIsGradedAgain()
{
    const Exam exam;
    start();
    logIn("sam");
    beginLesson("exam-36");
    drill(-2.0);
    QFile inTheWay(m_folder->filePath("outbox"));
    QTRY_COMPARE_WITH_TIMEOUT(count("exam_starts"), 1, kPatienceMs);
    QVERIFY(QDir(m_folder->filePath("outbox")).removeRecursively());
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    gradeLesson();
    const int expectedTenths = 10 * child<QSlider>("expected")->value();
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains("not kept yet"), qPrintable(keeping()), kPatienceMs);
    QTest::qWait(300);
    const auto uid = sql::ask(sql::Database::open(file()).value()->handle(),
                              "SELECT uid FROM people WHERE username = 'sam'", "read");
    const QDir folder(m_folder->filePath("unfinished/" + uid.value().toString()));
    const QString journal = folder.filePath(folder.entryList({"*.cuspjournal"}, QDir::Files).value(0));
    QVERIFY(QFile::copy(journal, m_folder->filePath("kept")));
    m_application.reset();
    QVERIFY(QFile::rename(m_folder->filePath("kept"), journal));
    QVERIFY(inTheWay.remove());
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("continueWords")->text().contains("Continue where I stopped"), kPatienceMs);
    click("continue");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    // What he had expected is not asked again: he knows the score.
    QVERIFY(!child<ui::study::Forecast>()->isVisible());
    const auto kept =
        sql::ask(sql::Database::open(file()).value()->handle(), "SELECT expected_tenths FROM attempts", "read");
    QCOMPARE(kept.value().toInt(), expectedTenths);
    toTheTooth();
    QVERIFY(!actions().drill->isEnabled());
}

/// A teacher gives a class a lesson, due yesterday, to be tried once.
void TestSchoolExams::whatIsGivenIsDueAndLimited()
{
    {
        const OtherStation elsewhere(file());
        const sql::School& school = elsewhere.school;
        const auto admin = elsewhere.logIn("admin");
        const ClassId ofClass = sql::listClasses(school, admin).value().front().id;
        const std::string due = QDateTime::currentDateTimeUtc().addDays(-1).toString(Qt::ISODate).toStdString();
        QVERIFY(sql::assign(school, admin, {0, ofClass, "decay-36-small", due, 1}));
        QVERIFY(sql::assign(school, admin, {0, ofClass, "somebodys-own", "", 0}));
    }
    start();
    logIn("sam");
    auto* const list = child<QListView>("lessonList");
    QTRY_VERIFY_WITH_TIMEOUT(list->model()->rowCount() > 2, kPatienceMs);
    QCOMPARE(list->model()->index(0, 0).data().toString(), QString("Given to you"));
    const QModelIndex card = list->model()->index(1, 0);
    QVERIFY2(card.data(ui::study::CardDue).toString().endsWith(", 1 day late · DEN101-A"),
             qPrintable(card.data(ui::study::CardDue).toString()));
    QVERIFY(card.data(ui::study::CardIsLate).toBool());
    const auto* const page = child<ui::study::LessonsPage>();
    const auto words = page->findChildren<QLabel*>();
    QVERIFY(std::any_of(words.begin(), words.end(), [](const QLabel* label) {
        return label->isVisible() && label->text().contains("not on this computer: somebodys-own");
    }));
    QVERIFY(!child<QFrame>("continueCard")->isVisible());
    list->setCurrentIndex(card);
    click("startLesson");
    QTRY_VERIFY_WITH_TIMEOUT(!page->isVisible() && actions().grade->isEnabled(), kPatienceMs);
    drill(-2.0);
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::Forecast>()->isVisible(), kPatienceMs);
    QTest::keyClick(child<QSlider>("expected"), Qt::Key_Right);
    QTest::keyClick(child<ui::study::Forecast>()->findChild<QRadioButton*>(), Qt::Key_Space);
    click("showScore");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    // It was the only one: the lesson is there to be read, and is not begun again.
    actions().lessons->trigger();
    const auto chooseIt = [list] {
        for (int row = 0; row < list->model()->rowCount(); ++row)
            if (list->model()->index(row, 0).data().toString() == u"Decay on 36, small")
                list->setCurrentIndex(list->model()->index(row, 0));
    };
    chooseIt();
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("whyNotStart")->isVisible(), kPatienceMs);
    QVERIFY(!child<QPushButton>("startLesson")->isEnabled());
    QVERIFY(!child<QFrame>("continueCard")->isVisible());
    // To cut on and have it graded again is another one, too.
    toTheTooth();
    drill(2.0);
    actions().grade->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("used up your attempts"), qPrintable(message()), kPatienceMs);
    QVERIFY(!child<ui::study::Forecast>()->isVisible());
    // Sue's class has not been given it.
    leaveFor("sue");
    QTRY_VERIFY_WITH_TIMEOUT(list->model()->rowCount() > 2, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(list->model()->index(0, 0).data().toString() != "Given to you", kPatienceMs);
}

/// From the score card, by its button and by R, as from the list of lessons.
void TestSchoolExams::noneBeginsAgainWhenTheAttemptsAreUsedUp()
{
    give("block-line", 2);
    start();
    logIn("sam");
    toTheTooth();
    beginLesson("block-line");
    drill(0.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains("first grade"), qPrintable(keeping()), kPatienceMs);
    QVERIFY(actions().reload->isEnabled());
    actions().reload->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("Another attempt at the lesson"), qPrintable(message()), kPatienceMs);
    QVERIFY(m_application->window().view().isVisible());
    QTest::qWait(500);  // the tooth has come to the servo
    QCOMPARE(removed(), QString("0.00"));
    drill(0.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 2, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(!actions().reload->isEnabled(), kPatienceMs);
    QVERIFY2(actions().reload->toolTip().contains("used up your attempts"), qPrintable(actions().reload->toolTip()));
    toTheTooth();
    QVERIFY(!actions().reload->isEnabled());
    // Another lesson is another matter.
    beginLesson("block-circle");
    QVERIFY(actions().reload->isEnabled());
    QVERIFY(!actions().reload->toolTip().contains("used up"));
}

/// What is whole again because it was undone has a grade all the same, and can be redone.
void TestSchoolExams::aPresetGivesNoAttemptBack()
{
    give("block-line", 1);
    start();
    logIn("sam");
    toTheTooth();
    beginLesson("block-line");
    drill(0.0);
    const auto loadSoft = [this] {
        auto soft = lessons::shippedPresets().back();
        emit m_application->window().feelWanted(soft);
        QTest::qWait(500);
    };
    const auto undo = [this] {
        for (int k = 0; k < 20 && actions().undo->isEnabled(); ++k) {
            actions().undo->trigger();
            QTest::qWait(200);
        }
        QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    };
    undo();
    QVERIFY(actions().redo->isEnabled());
    loadSoft();
    QVERIFY(actions().redo->isEnabled());
    drill(0.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(!actions().reload->isEnabled(), kPatienceMs);
    toTheTooth();
    undo();
    loadSoft();
    QVERIFY(!actions().reload->isEnabled());
    QVERIFY(actions().redo->isEnabled());
}

/// The teacher has given it meanwhile, and counts what was done before.
void TestSchoolExams::anUnfinishedAttemptIsNotTakenUpWhenTheAttemptsAreUsedUp()
{
    start();
    logIn("sam");
    toTheTooth();
    beginLesson("block-line");
    drill(0.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    toTheTooth();
    drill(2.0);  // goes on with it
    leaveFor("sue");
    leaveFor("sam");
    const auto isOffered = [this] {
        return child<QPushButton>("continue")->isVisible() &&
               child<QLabel>("continueWords")->text().contains("Continue where I stopped");
    };
    QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatienceMs);
    give("block-line", 1);
    click("continue");
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("used up your attempts"), qPrintable(message()), kPatienceMs);
    QCOMPARE(removed(), QString("0.00"));
    // From then on it is not offered, and is there again once there may be another attempt.
    const auto* list = child<QListView>("lessonList");
    actions().lessons->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(list->model()->index(0, 0).data().toString(), QString("Given to you"), kPatienceMs);
    QVERIFY(!isOffered());
    leaveFor("sue");
    leaveFor("sam");
    QTRY_COMPARE_WITH_TIMEOUT(list->model()->index(0, 0).data().toString(), QString("Given to you"), kPatienceMs);
    QTest::qWait(1000);  // what is unfinished is looked for
    QVERIFY(!isOffered());
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
    QVERIFY(sql::execute(sql::Database::open(file()).value()->handle(), "UPDATE assignments SET attempt_limit = 2",
                         "write"));
    leaveFor("sue");
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatienceMs);
}

/// Not to have it graded gives no attempt back.
void TestSchoolExams::anExamThatIsBrokenOffIsToldOf()
{
    const Exam exam;
    {
        const OtherStation elsewhere(file());
        const sql::School& school = elsewhere.school;
        const auto admin = elsewhere.logIn("admin");
        const ClassId ofClass = sql::listClasses(school, admin).value().front().id;
        QVERIFY(sql::assign(school, admin, {0, ofClass, "exam-36", "", 2}));
    }
    start();
    logIn("sam");
    auto* const list = child<QListView>("lessonList");
    QTRY_VERIFY_WITH_TIMEOUT(list->model()->rowCount() > 2, kPatienceMs);
    list->setCurrentIndex(list->model()->index(1, 0));
    click("startLesson");
    QTRY_VERIFY_WITH_TIMEOUT(!list->isVisible() && actions().grade->isEnabled(), kPatienceMs);
    // To have looked at it is not to have begun.
    QTest::qWait(500);
    QCOMPARE(count("exam_starts"), 0);
    drill(-2.0);
    QTRY_COMPARE_WITH_TIMEOUT(count("exam_starts"), 1, kPatienceMs);
    // It is begun anew, which he is told the price of, and again.
    const auto beginAnew = [this, list] {
        actions().lessons->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(list->isVisible() && child<QPushButton>("startLesson")->isEnabled(), kPatienceMs);
        click("startLesson");
        QVERIFY(child<QWidget>("workQuestion") != nullptr);
        QVERIFY(child<QLabel>("questionDetail")->text().contains("counts as an attempt"));
        click("questionDiscard");
    };
    beginAnew();
    QTRY_VERIFY_WITH_TIMEOUT(!list->isVisible() && actions().grade->isEnabled(), kPatienceMs);
    QTest::qWait(500);
    drill(-2.0);
    QTRY_COMPARE_WITH_TIMEOUT(count("exam_starts"), 2, kPatienceMs);
    beginAnew();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("used up your attempts"), qPrintable(message()), kPatienceMs);
    m_application.reset();  // in the midst of it

    start();
    logIn("ines");
    actions().classes->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount() == 1, kPatienceMs);
    const auto sam = sql::ask(sql::Database::open(this->file()).value()->handle(),
                              "SELECT id FROM people WHERE username = 'sam'", "read");
    emit child<ui::people::ClassPage>()->studentWanted(sam.value().toLongLong());
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::HistoryPage>()->isVisible(), kPatienceMs);
    const QString told = child<QLabel>("examsWithoutScore")->text();
    QVERIFY2(child<QLabel>("examsWithoutScore")->isVisible() && told.count("The exam, begun") == 2, qPrintable(told));
}

/// Its time has run out; before he says what he expects its student looks at the tooth once more.
void TestSchoolExams::whatComesAfterAnExamTakesNoTime()
{
    constexpr int kLookingMs = 4000;
    const Exam exam;
    comeForOneAttempt();
    QElapsedTimer clock;
    clock.start();
    beginLesson("exam-36");
    drill(-2.0);
    m_application->window().endExam();
    emit m_application->window().gradeRequested();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::Forecast>()->isVisible(), kPatienceMs);
    const qint64 endMs = clock.elapsed();
    actions().back->trigger();
    QVERIFY(m_application->window().view().isVisible());
    QTest::qWait(kLookingMs);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    const OtherStation elsewhere(file());
    const auto durationMs = sql::ask(elsewhere.school.db, "SELECT duration_ms FROM attempts", "read")->toLongLong();
    QVERIFY2(durationMs > 0 && durationMs <= endMs, qPrintable(QString::number(durationMs)));
}

/// It was opened in two of them, with one attempt left.
void TestSchoolExams::anExamIsBegunInOneWindow()
{
    const Exam exam;
    comeForOneAttempt();
    beginLesson("exam-36");
    {
        const OtherStation elsewhere(file());
        const sql::School& school = elsewhere.school;
        const auto sam = elsewhere.logIn("sam");
        QVERIFY(sql::deliverExam(school, sam.uid(), {newUid(), "exam-36", "2026-01-01T00:00:00Z"}));
    }
    const QPoint at = press(-2.0);  // it stops at once, with less gone than the figures show
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("begun in another window"), qPrintable(message()), kPatienceMs);
    QTest::mouseRelease(&m_application->window().view(), Qt::LeftButton, {}, at);
    for (const QAction* action : {actions().drill, actions().reload, actions().grade})
        QVERIFY2(!action->isEnabled(), qPrintable(action->text()));
    QCOMPARE(count("exam_starts"), 1);
    // Nothing is lost by leaving it, so nothing is asked.
    m_application->window().close();
    QVERIFY(child<QWidget>("workQuestion") == nullptr);
}

/// The school is told when it could not be told before the program was killed, and never twice.
void TestSchoolExams::anExamThatIsTakenUpWasBegunOnce()
{
    const Exam exam;
    comeForOneAttempt();
    beginLesson("exam-36");
    QVERIFY(QDir(m_folder->path()).mkpath("outbox"));
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(QDir(m_folder->filePath("outbox")).removeRecursively());
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    drill(-2.0);
    QCOMPARE(count("exam_starts"), 0);
    const auto uid = sql::ask(sql::Database::open(file()).value()->handle(),
                              "SELECT uid FROM people WHERE username = 'sam'", "read");
    const QDir folder(m_folder->filePath("unfinished/" + uid.value().toString()));
    for (int kill = 0; kill < 2; ++kill) {
        const QString journal = folder.filePath(folder.entryList({"*.cuspjournal"}, QDir::Files).value(0));
        QVERIFY(QFile::copy(journal, m_folder->filePath("kept")));
        m_application.reset();
        QVERIFY(QFile::rename(m_folder->filePath("kept"), journal));
        if (kill == 0)
            QVERIFY(inTheWay.remove());
        start();
        logIn("sam");
        QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("continueWords")->text().contains("Continue where I stopped"),
                                 kPatienceMs);
        click("continue");
        QTRY_VERIFY2_WITH_TIMEOUT(message().contains("goes on where it was left"), qPrintable(message()), kPatienceMs);
        QTRY_COMPARE_WITH_TIMEOUT(count("exam_starts"), 1, kPatienceMs);
        QTest::qWait(500);
        QCOMPARE(count("exam_starts"), 1);
        QVERIFY(actions().drill->isEnabled());
    }
}

void TestSchoolExams::anExamHidesEarlierAttempts()
{
    const Exam exam;
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::LessonsPage>()->isVisible(), kPatienceMs);
    beginLesson("exam-36");
    drill(-2.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    beginLesson("exam-36");
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    drill(-2.0);
    actions().attempts->trigger();
    auto* const history = child<ui::people::HistoryPage>();
    QTRY_VERIFY_WITH_TIMEOUT(history->isVisible(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("attempts")->model()->rowCount() == 1, kPatienceMs);
    child<QTableView>("attempts")->selectRow(0);
    for (const char* button : {"openAttempt", "replayAttempt"}) {
        m_application->window().showMessage("Nothing yet.");
        click(button);
        QTRY_VERIFY2_WITH_TIMEOUT(message().contains("You are in an exam"), qPrintable(message()), kPatienceMs);
        QVERIFY(history->isVisible());
    }
    toTheTooth();
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 2, kPatienceMs);
    actions().attempts->trigger();
    openNewest();
}

/// Else he could do it as often as he likes, and log in for the best.
void TestSchoolExams::aGuestsExamIsNobodys()
{
    const Exam exam;
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
    click("practiseAsGuest");
    toTheTooth();
    emit m_application->window().lessonChosen(*lessons::readLesson(exam.file()).lesson);
    QTest::qWait(100);
    QTRY_VERIFY_WITH_TIMEOUT(actions().grade->isEnabled(), kPatienceMs);
    drill(-2.0);
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::Forecast>()->isVisible(), kPatienceMs);
    QTest::keyClick(child<QSlider>("expected"), Qt::Key_Right);
    QTest::keyClick(child<ui::study::Forecast>()->findChild<QRadioButton*>(), Qt::Key_Space);
    click("showScore");
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains("will not be here next time"), qPrintable(keeping()), kPatienceMs);
    QVERIFY(!child<QPushButton>("keepGrade")->isVisible());
    emit m_application->window().keepWanted();
    logIn("sue");
    QTest::qWait(500);
    QCOMPARE(attemptsKept(), 0);
}

int main(int argc, char** argv)
{
    return support::openGlMain<TestSchoolExams>(argc, argv);
}

#include "tst_school_exams.moc"
