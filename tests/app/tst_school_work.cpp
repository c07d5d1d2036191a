// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program and what a student cuts at a school: it is graded, saved, limited, offered again, commented on.
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSlider>

#include "database/sql/Audit.h"
#include "database/sql/Backups.h"
#include "database/sql/ExamStarts.h"
#include "lessons/PresetFile.h"
#include "tests/app/SchoolWindow.h"
#include "tests/support/OpenGlMain.h"
#include "ui/charts/ChartPanel.h"
#include "ui/people/HistoryModel.h"
#include "ui/people/HistoryPage.h"
#include "ui/people/TalkPanel.h"
#include "ui/study/Forecast.h"
#include "ui/study/HeatMap.h"
#include "ui/study/LessonsPage.h"
#include "ui/study/ScorePage.h"
#include "ui/tooth/ToothView.h"

using namespace database;
using support::Exam;
using support::kPatienceMs;
using support::OtherStation;
using ui::people::Door;

class TestSchoolWork : public support::SchoolWindow
{
    Q_OBJECT
private slots:
    void initTestCase() { makeSchool(); }
    void init() { takeCopyOfSchool(); }
    void cleanup() { m_application.reset(); }

    void whoLogsInBeforeTheFirstToothIsMadeGetsIt();
    void aGuestsGradeIsSavedWithALogin();
    void aGuestsGradeIsOtherwiseNobodys();
    void anAttemptIsGradedSavedAndShown();
    void aLessonIsDueAndLimited();
    void aPresetGivesNoAttemptBack();
    void anUnfinishedAttemptIsItsStudents();
    void anUnfinishedAttemptIsNotResumedBeyondTheLimit();
    void anAttemptIsGradedOnce();
    void whatTheDiskRefusesIsDeliveredLater();
    void whatWasNotDeliveredIsUnfinished();
    void aRestoredSchoolGetsItsAttemptsAgain();
    void anExamThatIsBrokenOffCounts();
    void anExamIsBegunInOneWindow();
    void anExamThatIsResumedWasBegunOnce();
    void anExamThatWasSeenIsGradedAsItStands();
    void anExamEndsWhenItsTimeIsOver();
    void anExamHidesEarlierAttempts();
    void aGuestsExamIsNotSaved();
    void aCommentAndAScoreReachTheStudent();
    void theAdminsPresetIsFelt();

private:
    void beginAs(const QString& name);
    /// Begins to cut the lesson, and has it graded.
    void doLesson(const std::string& lesson, int expectedAttempts) const;
    /// Prevents letters to the school, even for root: a file is where their folder belongs.
    void blockOutbox() const;
    void freeOutbox() const { QVERIFY(QFile::remove(m_folder->filePath("outbox"))); }
    /// Waits until the unfinished attempts of who is logged in have been looked for. Offered ones are on the lessons.
    void waitForLookingForUnfinished() const;
    [[nodiscard]] QList<QPushButton*> pins() const;
};

void TestSchoolWork::beginAs(const QString& name)
{
    start();
    logIn(name);
    goToTooth();
}

void TestSchoolWork::doLesson(const std::string& lesson, int expectedAttempts) const
{
    openLesson(lesson);
    drill(0.0);
    gradeLesson(expectedAttempts);
}

void TestSchoolWork::blockOutbox() const
{
    QDir(m_folder->filePath("outbox")).removeRecursively();
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
}

void TestSchoolWork::waitForLookingForUnfinished() const
{
    // The lessons are read after that, and the school answers in order.
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    actions().attempts->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::HistoryPage>()->isVisible(), kPatienceMs);
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::LessonsPage>()->isVisible(), kPatienceMs);
}

QList<QPushButton*> TestSchoolWork::pins() const
{
    QList<QPushButton*> found;
    for (QPushButton* button : child<ui::people::TalkPanel>()->findChildren<QPushButton*>())
        if (button->property("kind") == "chip")
            found << button;
    return found;
}

/// On a slow computer the tooth is made in the background while people log in and out.
void TestSchoolWork::whoLogsInBeforeTheFirstToothIsMadeGetsIt()
{
    app::WindowOptions options;
    options.source = {36};
    options.build.gridSide = 1000;
    options.asksWho = true;
    begin(options);
    logIn("sam");
    switchTo("sue");
    goToTooth();
}

void TestSchoolWork::aGuestsGradeIsSavedWithALogin()
{
    assign("block-line", 1);
    start();
    beGuest();
    goToTooth();
    doLesson("block-line", 0);
    QVERIFY2(saved().contains("not logged in"), qPrintable(saved()));
    click("keepGrade");
    QVERIFY(child<QCheckBox>("keepOnLogin")->isVisible() && child<QCheckBox>("keepOnLogin")->isChecked());
    logIn("sam");
    QTRY_COMPARE_WITH_TIMEOUT(attempts(), 1, kPatienceMs);
    QVERIFY(child<ui::study::ScorePage>()->isVisible());
    QCOMPARE(count("attempts JOIN people ON people.id = attempts.person_id WHERE people.username = 'sam'"), 1);
    // It counts as an attempt: a second one is not saved, and cannot be begun again.
    logOut();
    beGuest();
    goToTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    doLesson("block-line", 1);
    click("keepGrade");
    logIn("sam");
    QTRY_VERIFY2_WITH_TIMEOUT(saved().contains("will not be here next time"), qPrintable(saved()), kPatienceMs);
    QVERIFY(!child<QPushButton>("keepGrade")->isVisible() && !actions().reload->isEnabled());
    goToTooth();
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    QCOMPARE(attempts(), 1);
}

/// Whoever unticks it gets neither the grade nor the tooth, nor does who logs in after a while.
void TestSchoolWork::aGuestsGradeIsOtherwiseNobodys()
{
    start();
    for (const bool isIdle : {false, true}) {
        beGuest();
        goToTooth();
        drill(-2.0);
        grade("not logged in");
        click("keepGrade");
        auto* const keep = child<QCheckBox>("keepOnLogin");
        QVERIFY(keep->isVisible());
        if (isIdle) {
            window().setIdleLimit(std::chrono::milliseconds(300));
            QTRY_VERIFY_WITH_TIMEOUT(!keep->isVisible(), kPatienceMs);
            window().setIdleLimit(std::chrono::minutes(10));
        } else {
            keep->setChecked(false);
        }
        logIn("sue");
        goToTooth();
        QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
        QCOMPARE(attempts(), 0);
        logOut();
    }
}

/// With its audit code on the PDF, in the charts, and to be replayed beside another.
void TestSchoolWork::anAttemptIsGradedSavedAndShown()
{
    beginAs("sam");
    // The bur is not lifted while the score is worked out: that is no new attempt.
    const QString before = removed();
    press({-2.0, 1.0, -1.0});
    QTRY_VERIFY_WITH_TIMEOUT(removed() != before, kPatienceMs);
    grade("first grade");
    release();
    QCOMPARE(attempts(), 1);
    const QString path = m_folder->filePath("new.pdf");
    savePdf(path);
    // The title of a PDF is UTF-16.
    QByteArray code;
    for (const QChar one : QString::fromStdString(sql::auditHead(OtherStation(file()).school)->code()))
        code += QByteArray(1, '\0') + one.toLatin1();
    QFile pdf(path);
    QVERIFY(code.size() > 20 && pdf.open(QIODevice::ReadOnly) && pdf.readAll().contains(code));
    goToTooth();
    drill(2.0);
    grade("");
    QTRY_COMPARE_WITH_TIMEOUT(attempts(), 2, kPatienceMs);
    // A criterion of free practice is called as in the lessons.
    actions().attempts->trigger();
    const auto* chart = child<ui::charts::ChartPanel>("otherChart");
    const auto names = [chart] {
        QStringList all;
        if (const auto* bars = std::get_if<ui::charts::Bars>(&chart->chart().content))
            for (const auto& bar : bars->bars)
                all << bar.name;
        return all.join(", ");
    };
    QTRY_VERIFY_WITH_TIMEOUT(!names().isEmpty(), kPatienceMs);
    QVERIFY2(!names().contains("Caries left"), qPrintable(names()));
    openNewest();
    QTRY_COMPARE_WITH_TIMEOUT(child<ui::study::ScorePage>()->card().history.size(), 2, kPatienceMs);
    // The other one is offered beside the replay, and a file.
    click("replayScored");
    QTRY_VERIFY_WITH_TIMEOUT(window().view().isVisible() && actions().beside->isEnabled(), kPatienceMs);
    actions().beside->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QMenu>("besideMenu") != nullptr, kPatienceMs);
    QCOMPARE(child<QMenu>("besideMenu")->actions().size(), 3);
    child<QMenu>("besideMenu")->actions().front()->trigger();
    child<QMenu>("besideMenu")->close();
    QTRY_COMPARE_WITH_TIMEOUT(window().findChildren<ui::tooth::ToothView*>().size(), 2, kPatienceMs);
    // A teacher goes the same way, and back step by step.
    switchTo("ines");
    openStudent();
    openNewest();
    QTRY_COMPARE_WITH_TIMEOUT(child<ui::study::ScorePage>()->card().history.size(), 2, kPatienceMs);
    actions().back->trigger();
    QVERIFY(child<ui::people::HistoryPage>()->isVisible());
    goBackTo<ui::tooth::ToothView>();
}

/// A teacher assigns a lesson that was due yesterday, to be tried twice.
void TestSchoolWork::aLessonIsDueAndLimited()
{
    assign("block-line", 2, QDateTime::currentDateTimeUtc().addDays(-1).toString(Qt::ISODate).toStdString());
    start();
    logIn("sam");
    auto* const list = child<QListView>("lessonList");
    const auto heading = [list] { return list->model()->index(0, 0).data().toString(); };
    QTRY_COMPARE_WITH_TIMEOUT(heading(), QString("Given to you"), kPatienceMs);
    list->setCurrentIndex(list->model()->index(1, 0));
    waitForNewTooth([this] { click("startLesson"); });
    drill(0.0);
    gradeLesson(1);
    QTRY_VERIFY2_WITH_TIMEOUT(saved().contains("first grade"), qPrintable(saved()), kPatienceMs);
    QVERIFY(actions().reload->isEnabled());
    waitForNewTooth([this] { actions().reload->trigger(); });
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    drill(0.0);
    gradeLesson(2);
    // It is not begun again, from the card, the tooth or the list, nor graded again after another cut.
    QTRY_VERIFY_WITH_TIMEOUT(!actions().reload->isEnabled(), kPatienceMs);
    goToTooth();
    QVERIFY(!actions().reload->isEnabled());
    drill(2.0);
    actions().grade->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("used up your attempts"), qPrintable(message()), kPatienceMs);
    QVERIFY(!child<ui::study::Forecast>()->isVisible());
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("whyNotStart")->isVisible(), kPatienceMs);
    QVERIFY(!child<QPushButton>("startLesson")->isEnabled());
    openLesson("block-circle");
    QVERIFY(actions().reload->isEnabled());
    // It was not assigned to Sue's class.
    switchTo("sue");
    QTRY_VERIFY_WITH_TIMEOUT(list->model()->rowCount() > 2 && heading() != "Given to you", kPatienceMs);
}

/// A tooth that is whole again because of undo has a grade all the same, and can be redone.
void TestSchoolWork::aPresetGivesNoAttemptBack()
{
    assign("block-line", 1);
    beginAs("sam");
    openLesson("block-line");
    drill(0.0);
    const auto undoAndLoadSoft = [this] {
        const auto isUndone = [this] {
            actions().undo->trigger();
            return removed() == "0.00";
        };
        QTRY_VERIFY_WITH_TIMEOUT(isUndone(), kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(actions().redo->isEnabled(), kPatienceMs);
        emit window().feelWanted(lessons::shippedPresets().back());
        waitForTicks(500);
        QVERIFY(actions().redo->isEnabled());
    };
    undoAndLoadSoft();
    drill(0.0);
    gradeLesson(1);
    QTRY_VERIFY_WITH_TIMEOUT(!actions().reload->isEnabled(), kPatienceMs);
    goToTooth();
    undoAndLoadSoft();
    QVERIFY(!actions().reload->isEnabled());
}

/// Another user gets a whole tooth, of which Sam sees nothing; the idle lock keeps it for Sam as well.
void TestSchoolWork::anUnfinishedAttemptIsItsStudents()
{
    beginAs("sam");
    const auto onTheTable = [this] { return window().view().tooth()->anatomy; };
    const auto whole = onTheTable();
    openLesson("class1-36");
    QVERIFY(onTheTable() != whole);
    drill(-2.0);
    const QString own = removed();
    window().setIdleLimit(std::chrono::milliseconds(300));
    QTRY_VERIFY_WITH_TIMEOUT(isAtDoor() && door() == Door::Locked, kPatienceMs);
    window().setIdleLimit(std::chrono::minutes(10));
    tryPassword(QString::fromStdString(support::kPassword));
    QTRY_VERIFY_WITH_TIMEOUT(window().view().isVisible(), kPatienceMs);
    QCOMPARE(removed(), own);
    switchTo("sue");
    goToTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    QCOMPARE(onTheTable().get(), whole.get());  // the one of practice, which has decay to be removed
    waitForLookingForUnfinished();
    QVERIFY(!isUnfinishedOffered());
    goToTooth();
    drill(2.0);
    switchTo("sam");
    QTRY_VERIFY_WITH_TIMEOUT(isUnfinishedOffered(), kPatienceMs);
    waitForNewTooth([this] { click("continue"); });
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(actions().undo->isEnabled(), kPatienceMs);
    gradeLesson(1);
}

/// The teacher has assigned the lesson meanwhile, and counts what was done before.
void TestSchoolWork::anUnfinishedAttemptIsNotResumedBeyondTheLimit()
{
    beginAs("sam");
    doLesson("block-line", 1);
    goToTooth();
    drill(2.0);
    switchTo("sue");
    switchTo("sam");
    QTRY_VERIFY_WITH_TIMEOUT(isUnfinishedOffered(), kPatienceMs);
    assign("block-line", 1);
    click("continue");
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("used up your attempts"), qPrintable(message()), kPatienceMs);
    QCOMPARE(removed(), QString("0.00"));
    switchTo("sue");
    switchTo("sam");
    waitForLookingForUnfinished();
    QVERIFY(!isUnfinishedOffered());
    // It is offered again with a higher limit.
    OtherStation(file()).execute("UPDATE assignments SET attempt_limit = 2");
    switchTo("sue");
    switchTo("sam");
    QTRY_VERIFY_WITH_TIMEOUT(isUnfinishedOffered(), kPatienceMs);
}

/// What is graded is not offered as unfinished, even if the program is killed before the journal says so.
void TestSchoolWork::anAttemptIsGradedOnce()
{
    const QString uid = uidOf("sam");
    for (const bool isKept : {true, false}) {
        beginAs("sam");
        drill(isKept ? -2.0 : 2.0);
        QTRY_COMPARE_WITH_TIMEOUT(journals(uid).size(), 1, kPatienceMs);
        const QString journal = m_folder->filePath("unfinished/" + uid + '/' + journals(uid).front());
        QVERIFY(QFile::copy(journal, m_folder->filePath("kept")));
        const int before = attempts();
        grade("");
        QTRY_COMPARE_WITH_TIMEOUT(attempts(), before + 1, kPatienceMs);
        QFile mark(journal + ".graded");
        QVERIFY(mark.open(QIODevice::ReadOnly));
        QByteArray marked = mark.readAll();
        mark.close();
        if (isKept) {
            switchTo("sue");
            switchTo("sam");
            waitForLookingForUnfinished();
            QVERIFY(!isUnfinishedOffered());
        }
        m_application.reset();
        if (!isKept)  // as of another attempt, which never got so far
            marked[0] = marked[0] == 'a' ? 'b' : 'a';
        QVERIFY(QFile::rename(m_folder->filePath("kept"), journal));
        QVERIFY(mark.open(QIODevice::WriteOnly) && mark.write(marked) == marked.size());
        mark.close();
        start();
        logIn("sam");
        if (isKept) {
            QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(journal) && !mark.exists(), kPatienceMs);
            waitForLookingForUnfinished();
            QVERIFY(!isUnfinishedOffered());
        } else {
            QTRY_VERIFY_WITH_TIMEOUT(isUnfinishedOffered(), kPatienceMs);
        }
        m_application.reset();
    }
}

/// Under the name of who made it, whoever works there by then, and once.
void TestSchoolWork::whatTheDiskRefusesIsDeliveredLater()
{
    beginAs("sam");
    drill(-2.0);
    blockOutbox();
    grade("not kept yet");
    QVERIFY2(message().contains("Make room on the disk"), qPrintable(message()));
    switchTo("sue");
    QVERIFY2(!message().contains("Make room on the disk"), qPrintable(message()));
    // Whoever quits is asked.
    window().close();
    QVERIFY(window().isVisible());
    click("questionStay");
    freeOutbox();
    QTRY_COMPARE_WITH_TIMEOUT(count("attempts a JOIN people p ON p.id = a.person_id WHERE p.username = 'sam'"), 1,
                              kPatienceMs);
    QCOMPARE(attempts(), 1);
    switchTo("sam");
    waitForLookingForUnfinished();
    QVERIFY(!isUnfinishedOffered());
    // During a replay the journal cannot be told that the attempt is saved.
    goToTooth();
    drill(2.0);
    blockOutbox();
    grade("not kept yet");
    m_application->showMoment(0.1);
    QTRY_VERIFY_WITH_TIMEOUT(actions().pauseReplay->isEnabled(), kPatienceMs);
    freeOutbox();
    QTRY_COMPARE_WITH_TIMEOUT(attempts(), 2, kPatienceMs);
    switchTo("sue");
    switchTo("sam");
    waitForLookingForUnfinished();
    QVERIFY(!isUnfinishedOffered());
}

/// As if it had never been graded: the program ended before it could be saved anywhere.
void TestSchoolWork::whatWasNotDeliveredIsUnfinished()
{
    beginAs("sam");
    drill(-2.0);
    const QString own = removed();
    blockOutbox();
    grade("not kept yet");
    switchTo("sue");
    m_application.reset();
    freeOutbox();
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(isUnfinishedOffered(), kPatienceMs);
    waitForNewTooth([this] { click("continue"); });
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
    grade("first grade");
    QCOMPARE(attempts(), 1);
}

/// An attempt that was delivered after the backup is delivered again.
void TestSchoolWork::aRestoredSchoolGetsItsAttemptsAgain()
{
    beginAs("sam");
    QVERIFY(sql::backUp(OtherStation(file()).school.db, sql::backupFolder(file()),
                        QDateTime::currentDateTimeUtc().addSecs(1)));
    drill(-2.0);
    grade("first grade");
    QTRY_COMPARE_WITH_TIMEOUT(attempts(), 1, kPatienceMs);
    m_application.reset();
    QFile database(file());
    QVERIFY(database.open(QIODevice::WriteOnly) && database.write(QByteArray(100'000, 'n')) == 100'000);
    database.close();
    start();
    click("restoreBackup");
    QTRY_VERIFY2_WITH_TIMEOUT(saidAtDoor().contains("is in place"), qPrintable(saidAtDoor()), kPatienceMs);
    logIn("sam");
    QTRY_COMPARE_WITH_TIMEOUT(attempts(), 1, kPatienceMs);
}

/// To break it off gives no attempt back. To have looked at it is not to have begun.
void TestSchoolWork::anExamThatIsBrokenOffCounts()
{
    const Exam exam;
    assign("exam-36", 2);
    start();
    logIn("sam");
    auto* const list = child<QListView>("lessonList");
    QTRY_VERIFY_WITH_TIMEOUT(list->model()->rowCount() > 2, kPatienceMs);
    list->setCurrentIndex(list->model()->index(1, 0));
    waitForNewTooth([this] { click("startLesson"); });
    QCOMPARE(count("exam_starts"), 0);
    drill(-2.0);
    QTRY_COMPARE_WITH_TIMEOUT(count("exam_starts"), 1, kPatienceMs);
    const auto beginAnew = [this, list] {
        actions().lessons->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(list->isVisible(), kPatienceMs);
        click("startLesson");
        QVERIFY(child<QLabel>("questionDetail")->text().contains("counts as an attempt"));
        click("questionDiscard");
    };
    waitForNewTooth(beginAnew);
    drill(-2.0);
    QTRY_COMPARE_WITH_TIMEOUT(count("exam_starts"), 2, kPatienceMs);
    beginAnew();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("used up your attempts"), qPrintable(message()), kPatienceMs);
    m_application.reset();
    start();
    logIn("ines");
    openStudent();
    const auto* const told = child<QLabel>("examsWithoutScore");
    QTRY_VERIFY_WITH_TIMEOUT(told->isVisible() && told->text().count("The exam, begun") == 2, kPatienceMs);
}

/// It was opened in two windows, with one attempt left.
void TestSchoolWork::anExamIsBegunInOneWindow()
{
    const Exam exam;
    assign("exam-36", 1);
    beginAs("sam");
    openLesson("exam-36");
    {
        const OtherStation elsewhere(file());
        QVERIFY(sql::deliverExam(elsewhere.school, elsewhere.logIn("sam").uid(),
                                 {newUid(), "exam-36", "2026-01-01T00:00:00Z"}));
    }
    press({-2.0, 1.0, -1.0});
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("begun in another window"), qPrintable(message()), kPatienceMs);
    release();
    for (const QAction* action : {actions().drill, actions().reload, actions().grade})
        QVERIFY2(!action->isEnabled(), qPrintable(action->text()));
    QCOMPARE(count("exam_starts"), 1);
    // Nothing is lost by leaving it, so nothing is asked.
    window().close();
    QVERIFY(child<QWidget>("workQuestion") == nullptr);
}

/// The school could not be told before the program was killed, is told later, and not twice.
void TestSchoolWork::anExamThatIsResumedWasBegunOnce()
{
    const Exam exam;
    assign("exam-36", 1);
    beginAs("sam");
    openLesson("exam-36");
    blockOutbox();
    drill(-2.0);
    QCOMPARE(count("exam_starts"), 0);
    const QString uid = uidOf("sam");
    for (const bool isFirst : {true, false}) {
        static_cast<void>(killWithJournal(uid));
        if (isFirst)
            freeOutbox();
        start();
        logIn("sam");
        QTRY_VERIFY_WITH_TIMEOUT(isUnfinishedOffered(), kPatienceMs);
        waitForNewTooth([this] { click("continue"); });
        QTRY_COMPARE_WITH_TIMEOUT(count("exam_starts"), 1, kPatienceMs);
        QVERIFY(actions().drill->isEnabled());
    }
    gradeLesson(1);
    QCOMPARE(count("exam_starts"), 1);
}

/// Its score was seen, and the program killed before it could be saved.
void TestSchoolWork::anExamThatWasSeenIsGradedAsItStands()
{
    const Exam exam;
    beginAs("sam");
    openLesson("exam-36");
    drill(-2.0);
    QTRY_COMPARE_WITH_TIMEOUT(count("exam_starts"), 1, kPatienceMs);
    blockOutbox();
    gradeLesson(0);
    const int expectedTenths = 10 * child<QSlider>("expected")->value();
    QTRY_VERIFY2_WITH_TIMEOUT(saved().contains("not kept yet"), qPrintable(saved()), kPatienceMs);
    static_cast<void>(killWithJournal(uidOf("sam")));
    freeOutbox();
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(isUnfinishedOffered(), kPatienceMs);
    click("continue");
    QTRY_COMPARE_WITH_TIMEOUT(attempts(), 1, kPatienceMs);
    // The forecast is not asked again: the student knows the score.
    QVERIFY(!child<ui::study::Forecast>()->isVisible());
    QCOMPARE(OtherStation(file()).ask("SELECT expected_tenths FROM attempts").toInt(), expectedTenths);
    goToTooth();
    QVERIFY(!actions().drill->isEnabled());
}

/// The student looks at the tooth once more before the forecast: that takes no time of the exam.
void TestSchoolWork::anExamEndsWhenItsTimeIsOver()
{
    const Exam exam;
    beginAs("sam");
    QElapsedTimer clock;
    clock.start();
    openLesson("exam-36");
    drill(-2.0);
    window().endExam();
    emit window().gradeRequested();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::Forecast>()->isVisible(), kPatienceMs);
    const qint64 endMs = clock.elapsed();
    actions().back->trigger();
    QVERIFY(window().view().isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(clock.hasExpired(2 * endMs), kPatienceMs);
    gradeLesson(1);
    const qint64 durationMs = OtherStation(file()).ask("SELECT duration_ms FROM attempts").toLongLong();
    QVERIFY2(durationMs > 0 && durationMs <= endMs, qPrintable(QString::number(durationMs)));
}

void TestSchoolWork::anExamHidesEarlierAttempts()
{
    const Exam exam;
    beginAs("sam");
    openLesson("exam-36");
    drill(-2.0);
    gradeLesson(1);
    openLesson("exam-36");
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    drill(-2.0);
    actions().attempts->trigger();
    const auto* const attemptsList = child<QTableView>("attempts")->model();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsList->rowCount(), 1, kPatienceMs);
    child<QTableView>("attempts")->selectRow(0);
    for (const char* button : {"openAttempt", "replayAttempt"}) {
        window().showMessage("Nothing yet.");
        click(button);
        QTRY_VERIFY2_WITH_TIMEOUT(message().contains("You are in an exam"), qPrintable(message()), kPatienceMs);
        QVERIFY(child<ui::people::HistoryPage>()->isVisible());
    }
    goToTooth();
    gradeLesson(2);
    actions().attempts->trigger();
    openNewest();
}

/// Guests could do it as often as they like, and log in for the best.
void TestSchoolWork::aGuestsExamIsNotSaved()
{
    const Exam exam;
    start();
    beGuest();
    goToTooth();
    openLesson("exam-36");
    drill(-2.0);
    gradeLesson(0);
    QTRY_VERIFY2_WITH_TIMEOUT(saved().contains("will not be here next time"), qPrintable(saved()), kPatienceMs);
    QVERIFY(!child<QPushButton>("keepGrade")->isVisible());
    emit window().keepWanted();
    logIn("sue");
    waitForLookingForUnfinished();
    QCOMPARE(attempts(), 0);
}

/// With a pin on the tooth and in the replay.
void TestSchoolWork::aCommentAndAScoreReachTheStudent()
{
    beginAs("sam");
    drill(-2.0);
    grade("first grade");
    switchTo("ines");
    openStudent();
    openNewest();
    auto* heat = child<ui::study::HeatMap>();
    QTRY_VERIFY_WITH_TIMEOUT(heat->height() > 100, kPatienceMs);
    QTest::mouseClick(heat, Qt::LeftButton, {}, heat->rect().center());
    QVERIFY(heat->pin());
    const auto* const atMoment = child<QCheckBox>("atMoment");
    QVERIFY(!atMoment->isVisible());
    // A moment is chosen in the replay, which leads back to the card.
    click("replayScored");
    QTRY_VERIFY_WITH_TIMEOUT(window().view().isVisible() && atMoment->text().contains("0:0"), kPatienceMs);
    actions().back->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible() && atMoment->isVisible(), kPatienceMs);
    child<QCheckBox>("atMoment")->setChecked(true);
    QVERIFY(child<QCheckBox>("atPlace")->isChecked());
    child<QPlainTextEdit>("commentWords")->setPlainText("Here you pressed too hard.");
    click("addComment");
    QTRY_COMPARE_WITH_TIMEOUT(pins().size(), 2, kPatienceMs);
    QCOMPARE(count("comments WHERE moment_ms IS NOT NULL AND x_um IS NOT NULL"), 1);
    const auto place = heat->pin();
    child<QDoubleSpinBox>("givenPoints")->setValue(91.5);
    child<QLineEdit>("reason")->setText("Seen by hand.");
    click("giveScore");
    const auto listed = [this](int column) {
        return child<QTableView>("attempts")->model()->index(0, column).data().toString();
    };
    QTRY_COMPARE_WITH_TIMEOUT(listed(ui::people::HistoryModel::Score), QString("91.5"), kPatienceMs);

    switchTo("sam");
    const auto* const news = child<QLabel>("feedbackWords");
    QTRY_VERIFY_WITH_TIMEOUT(news->isVisible() && news->text().contains("Ines Teach"), kPatienceMs);
    click("readFeedback");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(pins().size(), 2, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("counts")->text().contains("91.5"), kPatienceMs);
    QVERIFY(!child<QPlainTextEdit>("commentWords")->isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name LIKE 'feedback.%'"), 1, kPatienceMs);
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!news->isVisible() && child<QListView>("lessonList")->isVisible(), kPatienceMs);
    actions().attempts->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(listed(ui::people::HistoryModel::Feedback), QString("read"), kPatienceMs);
    openNewest();
    QTRY_COMPARE_WITH_TIMEOUT(pins().size(), 2, kPatienceMs);
    pins().back()->click();
    QVERIFY(heat->pin());
    for (std::size_t k = 0; k < 3; ++k)
        QVERIFY(std::abs((*heat->pin())[k] - (*place)[k]) < 0.001);
    pins().front()->click();
    const auto* remark = child<QLabel>("remark");
    QTRY_VERIFY_WITH_TIMEOUT(remark->isVisible() && remark->text().contains("Here you pressed too hard."), kPatienceMs);
    actions().back->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);

    // The teacher takes the comment back, and finds it in the field.
    switchTo("ines");
    openStudent();
    openNewest();
    QTRY_COMPARE_WITH_TIMEOUT(pins().size(), 2, kPatienceMs);
    QTest::mouseClick(child<ui::people::TalkPanel>()->findChild<QPushButton*>("takeBack"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(pins().size(), 0, kPatienceMs);
    QCOMPARE(count("comments WHERE withdrawn_utc IS NOT NULL"), 1);
    QCOMPARE(child<QPlainTextEdit>("commentWords")->toPlainText(), QString("Here you pressed too hard."));
    QVERIFY(child<QCheckBox>("atMoment")->isChecked() && child<QCheckBox>("atPlace")->isChecked());
}

/// Everybody's attempts feel as an admin has chosen, and say so.
void TestSchoolWork::theAdminsPresetIsFelt()
{
    core::settings::FeelPreset hard = lessons::shippedPresets().front();
    hard.name = "hard";
    hard.version = 0;
    hard.enamelRate *= 0.5;
    start();
    logIn("admin");
    actions().presets->trigger();
    emit window().presetSaveWanted(hard);
    QTRY_VERIFY_WITH_TIMEOUT(count("presets WHERE name = 'hard'") == 1, kPatienceMs);
    click("presetUse");
    const auto inUse = [this](const QString& preset) {
        return count("settings WHERE name = 'preset.in_use' AND value = '" + preset + "'") == 1;
    };
    QTRY_VERIFY_WITH_TIMEOUT(inUse("hard v1"), kPatienceMs);
    switchTo("sam");
    actions().presets->trigger();
    QVERIFY(!child<QPushButton>("presetUse")->isEnabled() && !child<QPushButton>("presetImport")->isEnabled());
    hard.dentinRate *= 0.5;
    emit window().presetSaveWanted(hard);
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("presetFault")->text().contains("only an admin"), kPatienceMs);
    QCOMPARE(count("presets WHERE name = 'hard'"), 1);
    goToTooth();
    drill(-2.0);
    grade("first grade");
    const auto felt = [this](int attempt) {
        return OtherStation(file())
            .ask(QStringLiteral("SELECT preset FROM attempts ORDER BY id LIMIT 1 OFFSET %1").arg(attempt))
            .toString();
    };
    QCOMPARE(felt(0), QString("hard v1"));
    // At another station an admin chooses another, which the next tooth feels like.
    OtherStation(file()).execute("UPDATE settings SET value = 'natural v1' WHERE name = 'preset.in_use'");
    waitForNewTooth([this] { emit window().toothChosen(26); });
    goToTooth();
    drill(-2.0);
    grade("");
    QTRY_COMPARE_WITH_TIMEOUT(attempts(), 2, kPatienceMs);
    QCOMPARE(felt(1), QString("natural v1"));
}

int main(int argc, char** argv)
{
    return support::openGlMain<TestSchoolWork>(argc, argv);
}

#include "tst_school_work.moc"
