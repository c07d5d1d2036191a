// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program and what a student has cut: it is graded, kept, offered again, and never another's.
#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QTest>

#include "app/Application.h"
#include "database/sql/Statement.h"
#include "lessons/LessonCatalog.h"
#include "tests/app/SchoolWindow.h"
#include "tests/support/OpenGlMain.h"
#include "ui/charts/ChartPanel.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryPage.h"
#include "ui/shell/MessageBar.h"
#include "ui/study/LessonsPage.h"
#include "ui/study/ScorePage.h"
#include "ui/tooth/ToothView.h"

using namespace database;
using support::kPatienceMs;
using ui::people::Door;

class TestSchoolWork : public support::SchoolWindow
{
    Q_OBJECT
private slots:
    void init() { makeSchool(); }
    void cleanup() { m_application.reset(); }

    void whatCostPointsInFreePracticeHasItsName();
    void theFolderOfLessonsIsNamed();
    void whatTheDiskRefusesIsKeptWhenItCanBe();
    void whatTheDiskRefusesIsKeptWhenItsMakerHasGone();
    void whatWaitsToBeKeptIsNotOffered();
    void whatIsKeptDuringAReplayIsNotOffered();
    void whatWasKeptBeforeAKillIsNotOffered();
    void whatWasGradedAndNotKeptIsUnfinished();
    void nothingIsCutWhileAGradeIsWorkedOut();
    void whoComesNextHasDecayToTakeOut();
    void aGuestsGradeIsKeptWhenHeLogsIn();
    void aGuestsGradeIsNobodysAfterAWhile();
    void aGuestsGradeIsNotAnothers();
    void aGuestsGradeCountsAsAnAttempt();
    void whatWasGradedIsNotUnfinished_data();
    void whatWasGradedIsNotUnfinished();
    void nobodyIsOfferedAnothersWork();
    void theLessonsForgetWhoLeft();
    void anOpenedAttemptHasThoseBeforeIt();
    void onesOwnAttemptsAreComparedInAReplay();
    void withoutADatabaseTheCardSaysSo();
};

/// As in the lessons, and one criterion once.
void TestSchoolWork::whatCostPointsInFreePracticeHasItsName()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    actions().attempts->trigger();
    const auto* chart = child<ui::charts::ChartPanel>("otherChart");
    const auto names = [chart] {
        QStringList all;
        if (const auto* bars = std::get_if<ui::charts::Bars>(&chart->chart().content))
            for (const auto& bar : bars->bars)
                all << bar.name;
        return all;
    };
    QTRY_VERIFY2_WITH_TIMEOUT(names().contains("Sound tissue removed beside the decay") ||
                                  names().contains("Pulp opened") || names().contains("Decay left"),
                              qPrintable(names().join(", ")), kPatienceMs);
    QVERIFY2(!names().contains("Sound tissue") && !names().contains("Caries left"), qPrintable(names().join(", ")));
}

void TestSchoolWork::theFolderOfLessonsIsNamed()
{
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
    click("practiseAsGuest");
    toTheTooth();
    // Nothing here shows folders.
    const QByteArray path = qgetenv("PATH");
    const auto asItWas = qScopeGuard([&path] { qputenv("PATH", path); });
    for (const char* name : {"BROWSER", "DEFAULT_BROWSER"})  // nor does a test need one
        qunsetenv(name);
    qputenv("PATH", "/nowhere");
    emit m_application->window().lessonFolderWanted();
    QVERIFY2(message().contains(QDir::toNativeSeparators(lessons::teachersFolder())), qPrintable(message()));
}

void TestSchoolWork::whatTheDiskRefusesIsKeptWhenItCanBe()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    // Not even root can write here.
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    grade("not kept yet");
    QVERIFY2(message().contains("Make room on the disk"), qPrintable(message()));
    QVERIFY(inTheWay.remove());
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("is kept now"), qPrintable(message()), kPatienceMs);
    // What was said before is over.
    child<ui::shell::MessageBar>()->dismiss();
    QVERIFY2(!message().contains("Make room on the disk"), qPrintable(message()));
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains("first grade"), qPrintable(keeping()), kPatienceMs);
}

/// Whoever works there by then.
void TestSchoolWork::whatTheDiskRefusesIsKeptWhenItsMakerHasGone()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    grade("not kept yet");
    leaveFor("sue");
    QVERIFY2(!message().contains("Make room on the disk"), qPrintable(message()));
    QVERIFY(inTheWay.remove());
    QTRY_COMPARE_WITH_TIMEOUT(count("attempts a JOIN people p ON p.id = a.person_id WHERE p.username = 'sam'"), 1,
                              kPatienceMs);
    QCOMPARE(attemptsKept(), 1);
    QVERIFY2(!message().contains("is kept now"), qPrintable(message()));
    // It is not offered to be gone on with: that would be another.
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QTest::qWait(500);
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
}

/// While it waits it is no unfinished work: it would become two attempts.
void TestSchoolWork::whatWaitsToBeKeptIsNotOffered()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    grade("not kept yet");
    leaveFor("sue");
    // Whoever quits is told of it.
    m_application->window().close();
    QVERIFY(m_application->window().isVisible());
    QVERIFY2(child<QLabel>("questionText")->text().contains("1 grade"),
             qPrintable(child<QLabel>("questionText")->text()));
    click("questionStay");
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QTest::qWait(500);
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
    QVERIFY(inTheWay.remove());
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
}

/// Its note cannot come to the recording then.
void TestSchoolWork::whatIsKeptDuringAReplayIsNotOffered()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    grade("not kept yet");
    m_application->showMoment(0.1);
    QTRY_VERIFY_WITH_TIMEOUT(actions().pauseReplay->isEnabled(), kPatienceMs);
    QVERIFY(inTheWay.remove());
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    leaveFor("sue");
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QTest::qWait(500);
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
}

/// A program that was killed then leaves the journal as it was before, and beside it as what it was graded.
void TestSchoolWork::whatWasKeptBeforeAKillIsNotOffered()
{
    for (const bool isKept : {true, false}) {
        start();
        logIn("sam");
        toTheTooth();
        drill(isKept ? -2.0 : 2.0);
        QTest::qWait(300);  // the last of it reaches the disk
        const auto uid = sql::ask(sql::Database::open(file()).value()->handle(),
                                  "SELECT uid FROM people WHERE username = 'sam'", "read");
        const QDir folder(m_folder->filePath("unfinished/" + uid.value().toString()));
        const QStringList journals = folder.entryList({"*.cuspjournal"}, QDir::Files);
        QCOMPARE(journals.size(), 1);
        const QString journal = folder.filePath(journals.front());
        QVERIFY(QFile::copy(journal, m_folder->filePath("kept")));
        const int before = attemptsKept();
        grade("");
        QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), before + 1, kPatienceMs);
        QFile mark(journal + ".graded");
        QVERIFY(mark.open(QIODevice::ReadOnly));
        QByteArray marked = mark.readAll();
        mark.close();
        m_application.reset();
        if (!isKept)  // as another, which never got so far
            marked[0] = marked[0] == 'a' ? 'b' : 'a';
        QVERIFY(QFile::rename(m_folder->filePath("kept"), journal));
        QVERIFY(mark.open(QIODevice::WriteOnly) && mark.write(marked) == marked.size());
        mark.close();
        start();
        logIn("sam");
        QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
        if (isKept) {
            QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(journal), kPatienceMs);
            QTest::qWait(300);
            QVERIFY(folder.entryList({"*.graded"}, QDir::Files).isEmpty());
            QVERIFY(!child<QLabel>("continueWords")->text().contains("Continue where I stopped"));
        } else {
            QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("continueWords")->text().contains("Continue where I stopped"),
                                     kPatienceMs);
        }
        m_application.reset();
    }
}

/// As if it had never been graded.
void TestSchoolWork::whatWasGradedAndNotKeptIsUnfinished()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    const QString own = removed();
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    grade("not kept yet");
    leaveFor("sue");
    m_application.reset();
    QVERIFY(inTheWay.remove());
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("continueWords")->text().contains("Continue where I stopped"), kPatienceMs);
    click("continue");
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
    grade("first grade");
    QCOMPARE(attemptsKept(), 1);
}

/// Which would be an attempt of its own.
void TestSchoolWork::nothingIsCutWhileAGradeIsWorkedOut()
{
    start();
    logIn("sam");
    toTheTooth();
    ui::tooth::ToothView& view = m_application->window().view();
    const QString before = removed();
    const glm::dvec2 pixel = view.camera().pixelOf({-2.0, 1.0, -1.0});
    const QPoint at(qRound(pixel.x), qRound(pixel.y));
    QTest::mouseMove(&view, at);
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    QTRY_VERIFY_WITH_TIMEOUT(removed() != before, kPatienceMs);
    grade("first grade");
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at);
    leaveFor("sue");
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QTest::qWait(500);
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
    QCOMPARE(attemptsKept(), 1);
}

/// The tooth of a lesson may have none, and practice is graded by it.
void TestSchoolWork::whoComesNextHasDecayToTakeOut()
{
    start();
    logIn("sam");
    toTheTooth();
    const auto onTheTable = [this] { return m_application->window().view().tooth()->anatomy; };
    const auto whole = onTheTable();
    beginLesson("class1-36");
    QTRY_VERIFY_WITH_TIMEOUT(onTheTable() != whole, kPatienceMs);
    leaveFor("sue");
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(onTheTable().get(), whole.get(), kPatienceMs);
}

void TestSchoolWork::aGuestsGradeIsKeptWhenHeLogsIn()
{
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
    click("practiseAsGuest");
    toTheTooth();
    drill(-2.0);
    grade("not logged in");
    QCOMPARE(attemptsKept(), 0);
    click("keepGrade");
    QVERIFY(child<QCheckBox>("keepOnLogin")->isVisible() && child<QCheckBox>("keepOnLogin")->isChecked());
    logIn("sue");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    QVERIFY(child<ui::study::ScorePage>()->isVisible());
    const auto owner =
        sql::ask(sql::Database::open(file()).value()->handle(),
                 "SELECT people.username FROM attempts JOIN people ON people.id = attempts.person_id", "read");
    QCOMPARE(owner.value().toString(), QString("sue"));
    // Whoever comes next gets a whole tooth.
    leaveFor("sam");
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
}

/// Whoever says so gets neither his grade nor his tooth.
void TestSchoolWork::aGuestsGradeIsNotAnothers()
{
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
    QVERIFY(!child<QCheckBox>("keepOnLogin")->isVisible());
    click("practiseAsGuest");
    toTheTooth();
    drill(-2.0);
    grade("not logged in");
    actions().account->trigger();  // of a guest's score card: to keep it
    child<QCheckBox>("keepOnLogin")->setChecked(false);
    logIn("sue");
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    QVERIFY(!child<ui::study::ScorePage>()->isVisible());
    QCOMPARE(attemptsKept(), 0);
}

/// Whoever logs in then is somebody else.
void TestSchoolWork::aGuestsGradeIsNobodysAfterAWhile()
{
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
    click("practiseAsGuest");
    toTheTooth();
    drill(-2.0);
    grade("not logged in");
    click("keepGrade");
    QVERIFY(child<QCheckBox>("keepOnLogin")->isVisible());
    m_application->window().setIdleLimit(std::chrono::milliseconds(300));
    QTRY_VERIFY_WITH_TIMEOUT(!child<QCheckBox>("keepOnLogin")->isVisible(), kPatienceMs);
    m_application->window().setIdleLimit(std::chrono::minutes(10));
    logIn("sue");
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    QCOMPARE(attemptsKept(), 0);
}

/// Else the limit would be got round by logging in afterwards.
void TestSchoolWork::aGuestsGradeCountsAsAnAttempt()
{
    give("block-line", 1);
    start();
    const auto gradeAsGuest = [this] {
        QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
        click("practiseAsGuest");
        toTheTooth();
        beginLesson("block-line");
        drill(0.0);
        gradeLesson();
        click("keepGrade");
        logIn("sam");
    };
    gradeAsGuest();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    actions().lock->trigger();
    click("otherLogin");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    gradeAsGuest();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("this grade is not kept"), qPrintable(message()), kPatienceMs);
    QVERIFY2(keeping().contains("will not be here next time"), qPrintable(keeping()));
    QVERIFY(!child<QPushButton>("keepGrade")->isVisible());
    QVERIFY(!actions().reload->isEnabled());
    // Nor when the same work is graded once more.
    toTheTooth();
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    QTest::qWait(500);
    QCOMPARE(attemptsKept(), 1);
    // What was done can be kept as a recording.
    for (QPushButton* button : child<ui::shell::MessageBar>()->findChildren<QPushButton*>())
        if (button->text() == actions().saveRecording->text())
            button->click();
    QVERIFY(child<QFileDialog>("QFileDialog") != nullptr);
    child<QFileDialog>("QFileDialog")->reject();
}

void TestSchoolWork::whatWasGradedIsNotUnfinished_data()
{
    QTest::addColumn<bool>("asGuest");
    QTest::addColumn<bool>("looksAtItAgain");
    QTest::newRow("a student's own") << false << false;
    QTest::newRow("a student's own, looked at afterwards") << false << true;
    QTest::newRow("a guest's who has logged in for it") << true << false;
    QTest::newRow("a guest's who has logged in for it, looked at afterwards") << true << true;
}

/// Its grade is kept: it is offered to nobody, and so is not graded twice.
void TestSchoolWork::whatWasGradedIsNotUnfinished()
{
    QFETCH(bool, asGuest);
    QFETCH(bool, looksAtItAgain);
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
    if (asGuest)
        click("practiseAsGuest");
    else
        logIn("sue");
    toTheTooth();
    beginLesson("block-line");
    drill(0.0);
    gradeLesson();
    if (asGuest) {
        click("keepGrade");
        logIn("sue");
    }
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains("first grade"), qPrintable(keeping()), kPatienceMs);
    if (looksAtItAgain) {
        toTheTooth();
        QTest::qWait(500);  // with the bur turning
    }
    leaveFor("sam");
    leaveFor("sue");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QTest::qWait(500);  // what is unfinished is looked for
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
    QVERIFY2(!child<QLabel>("continueWords")->text().contains("Continue where I stopped"),
             qPrintable(child<QLabel>("continueWords")->text()));
}

/// Sam's half-done work is Sam's: Sue sees a whole tooth, and he finds it again.
void TestSchoolWork::nobodyIsOfferedAnothersWork()
{
    start();
    logIn("sam");
    toTheTooth();
    const QString whole = removed();
    drill(-2.0);
    const QString own = removed();
    QElapsedTimer since;
    since.start();
    leaveFor("sue");
    qInfo("another had the place after %lld ms", since.elapsed());
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), whole, kPatienceMs);
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
    QVERIFY(!child<QFrame>("continueCard")->isVisibleTo(&m_application->window()));
    drill(2.0);
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("continueWords")->text().contains("Continue where I stopped"), kPatienceMs);
    QVERIFY(child<QPushButton>("continue")->isVisible());
    click("continue");
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(actions().undo->isEnabled(), kPatienceMs);
    grade("first grade");
    QCOMPARE(attemptsKept(), 1);
}

void TestSchoolWork::theLessonsForgetWhoLeft()
{
    start();
    logIn("sam");
    actions().lessons->trigger();
    const auto* list = child<QListView>("lessonList");
    QTRY_VERIFY_WITH_TIMEOUT(list->isVisible() && list->model()->rowCount() > 10, kPatienceMs);
    const QString first = list->currentIndex().data().toString();
    auto* search = child<ui::study::LessonsPage>()->findChild<QLineEdit*>();
    search->setText("decay 26");
    QVERIFY(list->currentIndex().data().toString() != first);
    const auto* const clear = search->findChild<QAbstractButton*>();
    QTRY_VERIFY(clear->property("opacity").toDouble() > 0.0);
    leaveFor("sue");
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(list->isVisible() && list->model()->rowCount() > 10, kPatienceMs);
    QVERIFY2(search->text().isEmpty(), qPrintable(search->text()));
    QTRY_COMPARE(clear->property("opacity").toDouble(), 0.0);
    QTRY_COMPARE_WITH_TIMEOUT(list->currentIndex().data().toString(), first, kPatienceMs);
}

void TestSchoolWork::anOpenedAttemptHasThoseBeforeIt()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    actions().back->trigger();
    drill(2.0);
    grade("");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 2, kPatienceMs);
    leaveFor("ines");
    actions().classes->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount() == 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionClicked(0);
    openNewest();
    QTRY_COMPARE_WITH_TIMEOUT(child<ui::study::ScorePage>()->card().history.size(), 2, kPatienceMs);
    QVERIFY2(!keeping().contains("first grade"), qPrintable(keeping()));
    // And back step by step: to the student's attempts, to the class, to the tooth.
    QCOMPARE(actions().back->text(), QString("Back to the attempts"));
    actions().back->trigger();
    QVERIFY(child<ui::people::HistoryPage>()->isVisible());
    QCOMPARE(actions().back->text(), QString("Back to the class"));
    actions().back->trigger();
    QVERIFY(child<ui::people::ClassPage>()->isVisible());
    QCOMPARE(actions().back->text(), QString("Back to the tooth"));
    // What is done elsewhere meanwhile is read with F5.
    QVERIFY(sql::execute(sql::Database::open(file()).value()->handle(),
                         "UPDATE people SET given_name = 'Samuel' WHERE username = 'sam'", "write"));
    QCOMPARE(actions().readAgain->shortcut(), QKeySequence(Qt::Key_F5));
    actions().readAgain->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(
        child<QTableView>("matrix")->model()->headerData(0, Qt::Vertical).toString().contains("Samuel"), kPatienceMs);
    actions().back->trigger();
    QVERIFY(!actions().readAgain->isEnabled());
    QVERIFY(m_application->window().view().isVisible());
}

/// What an admin keeps and puts to use, everybody's teeth feel like; a student looks on.
void TestSchoolWork::onesOwnAttemptsAreComparedInAReplay()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    toTheTooth();
    drill(2.0);
    actions().grade->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 2, kPatienceMs);
    // The other one, and any file; never the one that is played.
    const auto offersTheOther = [this] {
        QTRY_VERIFY_WITH_TIMEOUT(m_application->window().view().isVisible() && actions().beside->isEnabled(),
                                 kPatienceMs);
        actions().beside->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(child<QMenu>("besideMenu") != nullptr, kPatienceMs);
        const QList<QAction*> offered = child<QMenu>("besideMenu")->actions();
        QCOMPARE(offered.size(), 3);
        QVERIFY2(offered[0]->text().startsWith("Free practice"), qPrintable(offered[0]->text()));
        QVERIFY(offered[1]->isSeparator());
        QCOMPARE(offered[2]->text(), QString("From a file …"));
    };
    emit m_application->window().momentWanted(0.0);
    offersTheOther();
    delete child<QMenu>("besideMenu");
    actions().attempts->trigger();
    openNewest();
    click("replayScored");
    offersTheOther();
    child<QMenu>("besideMenu")->actions().front()->trigger();
    child<QMenu>("besideMenu")->close();
    const auto views = [this] { return m_application->window().findChildren<ui::tooth::ToothView*>().size(); };
    QTRY_COMPARE_WITH_TIMEOUT(views(), 2, kPatienceMs);
    QVERIFY(actions().beside->isChecked());
}

void TestSchoolWork::withoutADatabaseTheCardSaysSo()
{
    app::WindowOptions options;
    options.source = {36};
    options.database = m_folder->filePath("no folder/no school.sqlite");
    m_application = app::Application::make(options).value();
    m_application->show();
    toTheTooth();
    drill(-2.0);
    grade("");
    saveCard(m_folder->filePath("guest.pdf"));
}

int main(int argc, char** argv)
{
    return support::openGlMain<TestSchoolWork>(argc, argv);
}

#include "tst_school_work.moc"
