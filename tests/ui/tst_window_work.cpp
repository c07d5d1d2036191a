// SPDX-License-Identifier: GPL-3.0-or-later
// The main window while somebody works: lessons and exams, unsaved and unfinished work, replays.
#include <cmath>
#include <numbers>

#include <QLabel>
#include <QPushButton>

#include "core/grading/IdealCavity.h"
#include "tests/ui/WindowTest.h"
#include "ui/inside/SectionView.h"
#include "ui/replay/TimeLine.h"
#include "ui/study/InfractionCard.h"
#include "ui/study/LessonEditor.h"
#include "ui/study/ScorePage.h"

using namespace core::session;
using namespace ui::shell;
using core::terrain::Material;
using support::assigned;
using support::course;
using support::sheet;
using ui::inside::SectionView;
using ui::replay::TimeLine;
using ui::study::InfractionCard;

class TestWindowWork : public support::WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void aBreachStopsTheBurAndIsExplained();
    void aBreachShowsWhereItIs();
    void whatARuleStoppedTurnsAgainInTheNextLesson();
    void theBurRestsWhileAnotherPageIsRead();
    void anExerciseHasNoFiguresOfACut();
    void aLessonBeginsWithItsOwnColours();
    void aLessonsTimeEndsWithTheLesson();
    void aLessonsClockRestsWhereNobodyWorks();
    void timeAwayFromTheWorkIsNoted();
    void anExamEndsOnce();
    void anExamTellsNothingByAReplay();
    void theExpertIsOfferedWhereSomethingIsCut();

    void unsavedWorkIsAskedAbout_data();
    void unsavedWorkIsAskedAbout();
    void savedWorkIsLeftWithoutAQuestion();
    void anUnfinishedAttemptIsOffered();
    void anExamIsNotDiscardedUnasked();
    void aGradeThatIsNotKeptIsAskedAboutFirst();

    void aLessonOfAPackIsUnpackedToBeEdited();

    void aReplayRestsTheControls();
    void aReplayTellsItsTimeAndPauses();
    void aReplayHasEightSpeeds();
    void keysGoThroughAReplayByStrokes();
    void theTimeLineIsScrubbedAndTellsWhatWas();

private:
    /// The attempt has been recorded for so long, and so much enamel is gone.
    void record(double seconds, double enamelMm3 = 0.0, bool drillOn = false) const
    {
        SessionState session;
        session.toothGeneration = m_generation;
        session.recordedS = seconds;
        session.removedMm3[1] = enamelMm3;
        session.undoSteps = 3;
        session.redoSteps = 1;
        ServoState servo;
        servo.tick = drillOn ? 1 : 0;
        servo.drillOn = drillOn;
        take(servo, session);
    }
};

void TestWindowWork::aBreachStopsTheBurAndIsExplained()
{
    const auto* card = child<InfractionCard>();
    core::grading::Infraction infraction;
    infraction.breach = core::grading::Breach::TooDeep;
    infraction.limit = 2.5;
    infraction.tick = 4321;
    QSignalSpy back(m_window.get(), &MainWindow::takeBackWanted);
    m_window->tellInfraction(infraction, true);
    QVERIFY(card->isVisible());
    QCOMPARE(child<QLabel>("infraction")->text(), QString("Deeper than 2.50 mm"));
    QCOMPARE(drillSent().value(0, true), false);
    press(Qt::Key_Return);
    QVERIFY(!card->isVisible());
    QCOMPARE(back.count(), 1);
    QCOMPARE(back.front().front().toULongLong(), qulonglong{4321});
    // Undo is the same, or the card would go on telling what is no longer there.
    m_window->tellInfraction(infraction, true);
    press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!card->isVisible());
    QCOMPARE(back.count(), 2);
    // Where there is nothing to go back to, only going on is offered; and in the air nothing was cut.
    for (const auto& [breach, canTakeBack] :
         {std::pair(core::grading::Breach::TooDeep, false), {core::grading::Breach::BurInAir, true}}) {
        infraction.breach = breach;
        m_window->tellInfraction(infraction, canTakeBack);
        QVERIFY(!child<QPushButton>("takeBack")->isVisible());
        press(Qt::Key_Escape);
        QVERIFY(!card->isVisible());
    }
    QCOMPARE(back.count(), 2);
}

void TestWindowWork::aBreachShowsWhereItIs()
{
    auto* section = child<SectionView>();
    core::grading::Infraction infraction;
    infraction.breach = core::grading::Breach::BurInAir;
    m_window->tellInfraction(infraction, true);
    QVERIFY2(!section->isVisible(), "there is nothing to be seen");
    // How wide a marginal ridge is, is seen along the tooth only.
    infraction.breach = core::grading::Breach::RidgeCut;
    m_window->tellInfraction(infraction, true);
    QVERIFY(section->isVisible());
    QCOMPARE(section->angleDeg(), 0);
    // What was to be cut lies in the plane that shows where it was cut instead.
    const auto molar = support::syntheticMolar();
    const auto ideal = core::grading::idealCavity(*molar);
    const core::terrain::Grid& grid = molar->grid;
    infraction.breach = core::grading::Breach::WrongPlace;
    for (const glm::dvec2 place : {grid.nodeMm(0, grid.side / 2), grid.nodeMm(grid.side / 2, 0), grid.nodeMm(0, 0)}) {
        infraction.placeMm = glm::dvec3(place, 0.0);
        m_window->tellInfraction(infraction, true);
        const double angle = section->angleDeg() * std::numbers::pi / 180.0;
        bool isThere = false;
        for (double mm = -40.0; mm < 40.0; mm += 0.5 * grid.cellMm) {
            const glm::dvec2 at = grid.latticeOf(place + mm * glm::dvec2(std::cos(angle), std::sin(angle)));
            const auto i = static_cast<int>(std::lround(at.x));
            const auto j = static_cast<int>(std::lround(at.y));
            if (grid.contains(i, j))
                isThere = isThere || (*ideal)[grid.index(i, j)] < molar->top[grid.index(i, j)];
        }
        QVERIFY(isThere);
    }
    spoil();
}

void TestWindowWork::whatARuleStoppedTurnsAgainInTheNextLesson()
{
    const auto practice = lessons::practiceOn(support::syntheticMolar()).value();
    actions().drill->setChecked(true);
    core::grading::Infraction infraction;
    infraction.breach = core::grading::Breach::BurInAir;
    m_window->tellInfraction(infraction, false);
    QCOMPARE(drillSent(), QList<bool>{false});
    beginLesson(practice);
    QCOMPARE(drillSent(), QList<bool>{true});
    // Whoever has stopped it finds it as they left it.
    actions().drill->setChecked(true);
    m_window->tellInfraction(infraction, false);
    press(Qt::Key_Escape);
    QCOMPARE(drillSent(), (QList<bool>{false, true}));
    actions().drill->setChecked(false);
    beginLesson(practice);
    QCOMPARE(drillSent(), QList<bool>{});
}

void TestWindowWork::theBurRestsWhileAnotherPageIsRead()
{
    spoil();
    const auto turns = [&](bool on) {
        ServoState servo;
        servo.tick = 1;
        servo.drillOn = on;
        take(servo, {});
        QTRY_COMPARE(actions().drill->isChecked(), on);
    };
    turns(true);
    static_cast<void>(drillSent());
    actions().lessons->trigger();
    QCOMPARE(drillSent(), QList<bool>{false});
    turns(false);
    actions().back->trigger();
    QCOMPARE(drillSent(), QList<bool>{true});
    // Whoever had stopped it finds it so.
    turns(false);
    actions().lessons->trigger();
    actions().back->trigger();
    QCOMPARE(drillSent(), QList<bool>{});
}

void TestWindowWork::anExerciseHasNoFiguresOfACut()
{
    const auto told = [this](const char* name) { return child<TabularLabel>(name)->isVisible(); };
    QVERIFY(told("decayFigure") && told("marginFigure") && told("overcut") && told("depthFigure"));
    for (const lessons::Task task : {lessons::Task::TouchPoints, lessons::Task::HoldForce}) {
        beginLesson(assigned(task));
        for (const char* name : {"decayFigure", "marginFigure", "overcut", "depthFigure", "dentinFigure"})
            QVERIFY2(!told(name), name);
        QVERIFY2(told("enamelRemoved") && told("forceFigure"), "a scratch is told all the same");
        // R begins it anew, and no stroke is to be brought back.
        QSignalSpy again(m_window.get(), &MainWindow::attemptAgainWanted);
        static_cast<void>(sent());
        press(Qt::Key_R);
        QCOMPARE(again.size(), 1);
        QVERIFY(sent().isEmpty());
        // The school may refuse it: it is said once it is so.
        QVERIFY2(message().isEmpty(), qPrintable(message()));
        m_window->showBegunAnew();
        QVERIFY2(message().contains("begins anew"), qPrintable(message()));
        child<MessageBar>()->dismiss();
    }
    beginLesson(assigned("class1-36"));
    QVERIFY(told("decayFigure") && told("marginFigure") && told("overcut") && told("depthFigure"));
}

void TestWindowWork::aLessonBeginsWithItsOwnColours()
{
    beginLesson(assigned("block-line"));
    QVERIFY(actions().idealColours->isChecked());
    actions().section->trigger();
    QVERIFY(actions().section->isChecked());
    beginLesson(assigned("decay-36-moderate"));
    QVERIFY(!actions().idealColours->isChecked() && !actions().depthColours->isChecked());
    QVERIFY(!actions().section->isChecked());
}

void TestWindowWork::aLessonsTimeEndsWithTheLesson()
{
    lessons::Assignment assignment = assigned(lessons::Task::TouchPoints);
    assignment.anatomy = support::syntheticMolar();
    assignment.lesson->minutes = 1.0;
    beginLesson(assignment);
    record(30.0);
    // A tooth that is practised on freely has all the time there is.
    beginLesson(lessons::practiceOn(assignment.anatomy).value());
    record(100.0);
    QVERIFY2(message().isEmpty(), qPrintable(message()));
    beginLesson(assignment);
    record(100.0);
    QVERIFY2(message().contains("time of this lesson is over"), qPrintable(message()));
    // It is said where the lesson is.
    actions().lessons->trigger();
    QVERIFY2(message().isEmpty(), qPrintable(message()));
}

/// The clock of a lesson is that of the work on it.
void TestWindowWork::aLessonsClockRestsWhereNobodyWorks()
{
    lessons::Assignment assignment = assigned("class1-36");
    assignment.lesson->minutes = 2.0;
    double recordedS = 0.0;
    const auto begin = [&] {
        recordedS = 0.0;
        beginLesson(assignment);
    };
    const auto pass = [&](double seconds) {
        recordedS += seconds;
        record(recordedS);
        return child<TabularLabel>("lessonTime")->text();
    };
    begin();
    QCOMPARE(pass(30.0), QString("1:30"));
    actions().lessons->trigger();
    pass(300.0);
    QVERIFY2(message().isEmpty(), qPrintable(message()));
    actions().back->trigger();
    QCOMPARE(pass(10.0), QString("1:20"));
    // A tooth that is whole again is still the same attempt, whose time is counted; who has a grade needs none.
    actions().reload->trigger();
    QCOMPARE(pass(20.0), QString("1:00"));
    m_window->showScore(sheet(3.2, 40, 0.5), {});
    pass(300.0);
    actions().back->trigger();
    QCOMPARE(pass(300.0), QString("1:00"));
    QVERIFY2(!message().contains("time of this lesson"), qPrintable(message()));
    // One that is gone on with has rested before as well.
    begin();
    m_window->resumeClock(100.0, 40.0);
    recordedS = 100.0;
    QCOMPARE(pass(10.0), QString("1:10"));
    // An exam's goes on, until there is a grade.
    assignment.lesson->exam = true;
    begin();
    pass(30.0);
    actions().lessons->trigger();
    pass(30.0);
    actions().back->trigger();
    QCOMPARE(pass(10.0), QString("0:50"));
    m_window->showScore(sheet(3.2, 40, 0.5), {});
    QSignalSpy grade(m_window.get(), &MainWindow::gradeRequested);
    pass(300.0);
    actions().back->trigger();
    QCOMPARE(pass(300.0), QString("0:50"));
    QVERIFY(grade.isEmpty());
}

/// So that it counts nowhere as time of the attempt. In an exam it does.
void TestWindowWork::timeAwayFromTheWorkIsNoted()
{
    const auto noted = [this] {
        frame();
        QList<quint64> codes;
        for (const SessionCommand& command : allSent())
            if (isRest(command))
                codes << std::get<AddNote>(command).code;
        return codes;
    };
    static_cast<void>(noted());
    QCOMPARE(noted(), QList<quint64>());
    m_window->askWho(ui::people::Door::Locked);
    QCOMPARE(noted(), QList<quint64>{kRestNote});
    m_window->setWho({});
    QCOMPARE(noted(), QList<quint64>{kWorkNote});
    lessons::Assignment exam;
    exam.anatomy = support::syntheticMolar();
    exam.lesson.emplace();
    exam.lesson->exam = true;
    beginLesson(exam);
    m_window->askWho(ui::people::Door::Locked);
    QCOMPARE(noted(), QList<quint64>());
}

/// By its time or by its score: then nothing is cut any more, and another attempt is another attempt.
void TestWindowWork::anExamEndsOnce()
{
    spoil();
    lessons::Assignment exam = assigned("class1-36");
    exam.lesson->exam = true;
    const double overS = 60.0 * exam.lesson->minutes + 1.0;
    QSignalSpy again(m_window.get(), &MainWindow::attemptAgainWanted);
    QSignalSpy grade(m_window.get(), &MainWindow::gradeRequested);
    const auto mayCut = [&] { return actions().drill->isEnabled() && actions().burs[0]->isEnabled(); };
    for (const bool byTime : {true, false}) {
        beginLesson(exam);
        record(30.0, 0.5, true);
        QVERIFY(mayCut());
        // As in a clinic, no step is taken back; and nobody looks at the work with other means.
        for (QAction* locked : {actions().undo, actions().redo, actions().history, actions().reload,
                                actions().saveRecording, actions().saveReference})
            QVERIFY2(!locked->isEnabled(), qPrintable(locked->text()));
        if (byTime) {
            record(overS, 0.5, true);
            QCOMPARE(grade.count(), 1);
        } else {
            m_window->showScore(sheet(3.2, 40, 0.5), {});
        }
        actions().back->trigger();
        QVERIFY(!mayCut());
        QVERIFY(!actions().undo->isEnabled() && !actions().history->isEnabled());
        if (byTime) {
            QVERIFY(!actions().saveRecording->isEnabled());
            actions().reload->trigger();
            QCOMPARE(again.count(), 0);
            QVERIFY2(message().contains("no grade yet"), qPrintable(message()));
            m_window->showScore(sheet(3.2, 40, 0.5), {});
            actions().back->trigger();
        }
        QVERIFY(!mayCut());
        QVERIFY(actions().saveRecording->isEnabled());
        actions().reload->trigger();
        QCOMPARE(again.count(), byTime ? 1 : 2);
        // It begins as the first did, with the bur turning.
        static_cast<void>(sent());
        beginLesson(exam);
        const QList<bool> drills = drillSent();
        QVERIFY(!drills.isEmpty() && drills.back());
    }
    // Who has cut nothing until the time was over has nothing to be graded, and begins anew.
    beginLesson(exam);
    record(overS, 0.0, true);
    QVERIFY2(message().contains("time of this exam is over"), qPrintable(message()));
    actions().reload->trigger();
    QCOMPARE(again.count(), 3);
    exam.lesson->exam = false;
    beginLesson(exam);
    record(30.0, 0.5, true);
    QVERIFY(mayCut() && actions().undo->isEnabled() && actions().reload->isEnabled());
}

/// One's own attempt, saved and played while the exam goes on, would tell what went wrong.
void TestWindowWork::anExamTellsNothingByAReplay()
{
    lessons::Assignment exam = assigned("class1-36");
    exam.lesson->exam = true;
    const auto* line = child<TimeLine>("timeLine");
    const auto links = std::make_unique<UiLinks>();
    beginLesson(exam);
    const std::uint64_t own = m_generation;
    const auto breachesTold = [&] {
        m_window->setReplaying(true, 60.0);
        m_window->setReplayCourse(course());
        show();
        m_window->showBeside(*links, support::syntheticMolar(), 1, {}, "Before");
        m_window->setBesideCourse(course());
        // The pulp is opened while it is played.
        SessionState session;
        session.toothGeneration = m_generation;
        take({}, session);
        session.removedMm3[static_cast<std::size_t>(Material::Pulp)] = 0.5;
        take({}, session);
        QStringList told;
        for (const int y : {12, 12 + 32})
            told << line->saidAt({qRound(line->xOf(20.5)), y});
        told = told.filter("pulp is open");
        if (child<QLabel>("notice")->isVisible())
            told << child<QLabel>("notice")->text();
        if (!line->saidAt({qRound(line->xOf(40.0)), 12}).join(' ').contains("Undone"))
            told << "the rest of the course is missing";
        m_window->hideBeside();
        m_window->setReplaying(false);
        m_window->showTooth(exam.anatomy, own, {});
        return told;
    };
    QCOMPARE(breachesTold(), QStringList());
    // Nor is a lesson's ideal looked at in the editor.
    m_window->setLessons(support::catalog(), {});
    actions().lessons->trigger();
    actions().editLesson->trigger();
    QVERIFY(!child<ui::study::LessonEditor>()->isVisible());
    QVERIFY2(message().contains("exam"), qPrintable(message()));
    actions().back->trigger();
    // Graded, it is over.
    m_window->showScore(sheet(3.2, 40, 0.5), {});
    actions().back->trigger();
    const QStringList all{"0:20  The pulp is open", "0:20  The pulp is open", "Pulp opened"};
    QCOMPARE(breachesTold(), all);
    // In practice nothing is hidden.
    exam.lesson->exam = false;
    m_window->setAssignment(exam);
    m_window->showTooth(exam.anatomy, own, {});
    QCOMPARE(breachesTold(), all);
}

void TestWindowWork::theExpertIsOfferedWhereSomethingIsCut()
{
    const auto* expert = actions().expert;
    lessons::Assignment assignment;
    assignment.anatomy = support::syntheticMolar();
    QVERIFY(!expert->isVisible());
    assignment.lesson.emplace();
    m_window->setAssignment(assignment);
    QSignalSpy wanted(m_window.get(), &MainWindow::expertWanted);
    press(Qt::Key_Y);
    QCOMPARE(wanted.size(), 1);
    assignment.exercise = core::grading::ForceToHold{};
    assignment.lesson->task = lessons::Task::HoldForce;
    m_window->setAssignment(assignment);
    QVERIFY(!expert->isVisible());
    assignment.lesson->expert.emplace();
    m_window->setAssignment(assignment);
    QVERIFY(expert->isVisible());
    assignment.lesson->exam = true;
    m_window->setAssignment(assignment);
    press(Qt::Key_Y);
    QCOMPARE(wanted.size(), 1);
    QVERIFY(!expert->isVisible());
    // In a replay it is that of the lesson which is played, whatever lies on the table; but in an exam nothing is told.
    m_window->setReplaying(true, 10.0, nullptr, lessons::Lesson());
    QVERIFY(!expert->isVisible());
    m_window->setReplaying(false);
    m_window->setAssignment(lessons::practiceOn(support::syntheticMolar()).value());
    m_window->setReplaying(true, 10.0, nullptr, lessons::Lesson());
    press(Qt::Key_Y);
    QCOMPARE(wanted.size(), 2);
}

void TestWindowWork::unsavedWorkIsAskedAbout_data()
{
    QTest::addColumn<QString>("leave");
    QTest::addColumn<QString>("answer");
    for (const QString leave : {"tooth", "scan", "window"})
        for (const QString answer : {"save", "discard", "cancel"})
            QTest::newRow(qPrintable(leave + ", " + answer)) << leave << answer;
}

void TestWindowWork::unsavedWorkIsAskedAbout()
{
    QFETCH(QString, leave);
    QFETCH(QString, answer);
    QSignalSpy tooth(m_window.get(), &MainWindow::toothChosen);
    QSignalSpy scan(m_window.get(), &MainWindow::scanChosen);
    QSignalSpy save(m_window.get(), &MainWindow::recordingSaveRequested);
    const auto left = [&] { return tooth.size() + scan.size() + (m_window->isVisible() ? 0 : 1); };
    cutSomething(0.5);
    if (leave == "tooth") {
        press(Qt::Key_T);
        press(Qt::Key_Return);
    } else if (leave == "window") {
        spoil();
        m_window->close();
    } else {
        QVERIFY(dropFile("/tmp/molar.stl"));
    }
    QVERIFY(question() != nullptr);
    QCOMPARE(left(), 0);
    if (answer == "cancel") {
        QTest::keyClick(question(), Qt::Key_Escape);
        QTRY_VERIFY(question() == nullptr);
        QCOMPARE(left(), 0);
        QVERIFY(save.isEmpty());
    } else if (answer == "discard") {
        QTest::keyClick(child<QPushButton>("questionDiscard"), Qt::Key_Space);
        QCOMPARE(left(), 1);
        QVERIFY(save.isEmpty());
    } else {
        QTest::keyClick(question(), Qt::Key_Return);
        const QTemporaryDir folder;
        const QString file = folder.filePath("mine.cusprec");
        accept(file);
        QCOMPARE(save.size(), 1);
        QCOMPARE(left(), 0);
        m_window->showSaved(file);
        QCOMPARE(left(), 1);
    }
}

void TestWindowWork::savedWorkIsLeftWithoutAQuestion()
{
    QSignalSpy chosen(m_window.get(), &MainWindow::toothChosen);
    const auto leave = [this] {
        press(Qt::Key_T);
        press(Qt::Key_Return);
    };
    cutSomething(0.5);
    press(Qt::Key_S, Qt::ControlModifier);
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.cusprec");
    accept(file);
    m_window->showSaved(file);
    leave();
    QCOMPARE(chosen.size(), 1);
    // What was cut since is in no recording.
    cutSomething(0.75);
    leave();
    QCOMPARE(chosen.size(), 1);
    QVERIFY(question() != nullptr);
    QTest::keyClick(question(), Qt::Key_Escape);
    // Work that waits for a replay is asked about as well.
    m_window->setReplaying(true, 10.0);
    show();
    record(1.0);
    leave();
    QCOMPARE(chosen.size(), 1);
    QVERIFY(question() != nullptr);
}

void TestWindowWork::anUnfinishedAttemptIsOffered()
{
    spoil();
    QSignalSpy resumed(m_window.get(), &MainWindow::resumeRequested);
    QSignalSpy discarded(m_window.get(), &MainWindow::discardRequested);
    auto* resume = child<MessageBar>()->findChild<QPushButton*>();
    auto* discard = child<MessageBar>()->findChild<QPushButton*>("decline");
    const auto offer = [this] {
        m_window->offerUnfinished([] { return QString("Tooth 36"); }, QDateTime::currentDateTime(), false);
        QVERIFY(message().startsWith("Tooth 36: an attempt of"));
    };
    offer();
    QVERIFY(resume->isVisible() && discard->isVisible());
    QTest::mouseClick(resume, Qt::LeftButton);
    QCOMPARE(resumed.size(), 1);
    QVERIFY(message().isEmpty());
    // News does not push it out.
    offer();
    m_window->showMessage("News.");
    QVERIFY(!discard->isVisible());
    press(Qt::Key_Escape);
    QVERIFY(discard->isVisible());
    QTest::mouseClick(discard, Qt::LeftButton);
    QCOMPARE(discarded.size(), 1);
    // Another that was waiting takes its place: a double click is not meant for it.
    offer();
    QTest::mouseClick(discard, Qt::LeftButton);
    QCOMPARE(discarded.size(), 1);
    QVERIFY(discard->isVisible());
    // The page of lessons has a card for it, and needs no second offer.
    actions().lessons->trigger();
    QVERIFY(message().isEmpty() && child<QFrame>("continueCard")->isVisible());
    actions().back->trigger();
    // Closed: neither, and it is offered again another time.
    offer();
    press(Qt::Key_Escape);
    QVERIFY(message().isEmpty());
    QCOMPARE(discarded.size() + resumed.size(), 2);
}

/// It costs an attempt, as to leave one does.
void TestWindowWork::anExamIsNotDiscardedUnasked()
{
    QSignalSpy resumed(m_window.get(), &MainWindow::resumeRequested);
    QSignalSpy discarded(m_window.get(), &MainWindow::discardRequested);
    m_window->offerUnfinished([] { return QString("The exam"); }, QDateTime::currentDateTime(), true);
    actions().lessons->trigger();
    const auto answer = [this](const char* button) {
        QTest::mouseClick(child<QPushButton>("discardUnfinished"), Qt::LeftButton);
        QVERIFY(question("unfinishedQuestion") != nullptr);
        QVERIFY(child<QLabel>("questionDetail")->text().contains("counts as an attempt"));
        click(button);
        QTRY_VERIFY(question("unfinishedQuestion") == nullptr);
    };
    answer("questionStay");
    QVERIFY(discarded.isEmpty() && child<QFrame>("continueCard")->isVisible());
    answer("questionSave");
    QCOMPARE(resumed.size(), 1);
    m_window->offerUnfinished([] { return QString("The exam"); }, QDateTime::currentDateTime(), true);
    actions().lessons->trigger();
    answer("questionDiscard");
    QCOMPARE(discarded.size(), 1);
    QVERIFY(!child<QFrame>("continueCard")->isVisible());
}

/// Whoever made it, and whatever else would be lost.
void TestWindowWork::aGradeThatIsNotKeptIsAskedAboutFirst()
{
    spoil();
    cutSomething(1.0);
    m_window->showScore(sheet(40, 30, 0), {});
    child<ui::study::ScorePage>()->setKeeping(ui::study::ScorePage::Keeping::Refused);
    QVERIFY(child<QLabel>("historyRemark")->text().contains("tried again"));
    m_window->setUnkeptGrades(1);
    m_window->close();
    QVERIFY(m_window->isVisible() && question("gradeQuestion") != nullptr);
    QVERIFY(child<QLabel>("questionText")->text().contains("1 grade"));
    click("questionStay");
    QVERIFY(m_window->isVisible());
    m_window->setUnkeptGrades(0);
    m_window->close();
    QVERIFY(question("gradeQuestion") == nullptr);
}

void TestWindowWork::aLessonOfAPackIsUnpackedToBeEdited()
{
    QSignalSpy unpack(m_window.get(), &MainWindow::unpackWanted);
    lessons::CatalogEntry entry =
        *std::find_if(support::catalog().begin(), support::catalog().end(),
                      [](const lessons::CatalogEntry& one) { return one.read.lesson->id == "class1-36"; });
    entry.isShipped = false;
    entry.pack = "/folder/course.cusplessons";
    m_window->setLessons({entry}, {});
    actions().lessons->trigger();
    actions().editLesson->trigger();
    QCOMPARE(unpack.size(), 1);
    QCOMPARE(unpack.front()[0].toString(), QString("/folder/course.cusplessons"));
    QVERIFY(!child<ui::study::LessonEditor>()->isVisible());
}

void TestWindowWork::aReplayRestsTheControls()
{
    QSignalSpy stop(m_window.get(), &MainWindow::replayStopRequested);
    m_window->setReplaying(true, 10.0);
    for (const Qt::Key key : {Qt::Key_D, Qt::Key_R, Qt::Key_2})
        press(key);
    press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(sent().isEmpty());
    m_window->showReplayEnd();
    QVERIFY(!message().isEmpty());
    press(Qt::Key_Escape);
    QCOMPARE(stop.size(), 1);
    m_window->setReplaying(false);
    show();
    QVERIFY2(message().isEmpty(), "what was said about the replay went with it");
    press(Qt::Key_D);
    QCOMPARE(sent().size(), 1);
    // It is called by its lesson, and by whose it is.
    const lessons::Lesson lesson = *support::shipped("class1-36").lesson;
    m_window->setReplaying(true, 60.0, {}, lesson, QStringLiteral("Ada Lovelace, 20/11/2026 10:15"));
    show();
    QVERIFY(m_window->windowTitle().startsWith(QString::fromStdString(lesson.title.at("en")) + " – Ada Lovelace"));
}

void TestWindowWork::aReplayTellsItsTimeAndPauses()
{
    QSignalSpy pause(m_window.get(), &MainWindow::replayPauseRequested);
    m_window->setReplaying(true, 95.0);
    QCOMPARE(figure("replayTime"), QString("0:00 of 1:35"));
    record(67.9);
    QTRY_COMPARE(figure("replayTime"), QString("1:07 of 1:35"));
    press(Qt::Key_Space);
    QCOMPARE(actions().pauseReplay->text(), QString("Resume the replay"));
    press(Qt::Key_Space);
    QCOMPARE(actions().pauseReplay->text(), QString("Pause the replay"));
    QCOMPARE(pause.size(), 2);
    QVERIFY(pause[0].front().toBool() && !pause[1].front().toBool());
    QVERIFY2(sent().isEmpty(), "the drill is not meant");
    press(Qt::Key_Space);
    m_window->setReplaying(false);
    QVERIFY2(actions().pauseReplay->text().startsWith("Pause"), "the next replay begins by running");
    press(Qt::Key_Space);
    QCOMPARE(sent().size(), 1);
}

void TestWindowWork::aReplayHasEightSpeeds()
{
    QSignalSpy speed(m_window.get(), &MainWindow::replaySpeedChosen);
    m_window->setReplaying(true, 95.0);
    for (const char* shown : {"2×", "4×", "8×", "16×", "16×"}) {
        press(Qt::Key_BracketRight);
        QCOMPARE(figure("replaySpeed"), QString::fromUtf8(shown));
    }
    QCOMPARE(speed.size(), 4);
    QCOMPARE(speed[3].front().toDouble(), 16.0);
    for (const char* shown : {"8×", "4×", "2×", "1×", "0.5×", "0.25×", "0.1×", "0.1×"}) {
        press(Qt::Key_BracketLeft);
        QCOMPARE(figure("replaySpeed"), QString::fromUtf8(shown));
    }
    QCOMPARE(speed.back().front().toDouble(), 0.1);
    m_window->setReplaying(false);
    m_window->setReplaying(true, 95.0);
    QCOMPARE(figure("replaySpeed"), QString::fromUtf8("1×"));
}

void TestWindowWork::keysGoThroughAReplayByStrokes()
{
    QSignalSpy seek(m_window.get(), &MainWindow::seekWanted);
    for (const Qt::Key key : {Qt::Key_Right, Qt::Key_Home, Qt::Key_End, Qt::Key_Period})
        press(key);
    QVERIFY2(seek.isEmpty(), "while one drills these keys are the tooth's");
    m_window->setReplaying(true, 60.0);
    m_window->setReplayCourse(course());
    for (const auto& [key, to] : {std::pair(Qt::Key_Right, 9.01),
                                  {Qt::Key_Period, 21.01},
                                  {Qt::Key_Right, 40.0},
                                  {Qt::Key_Right, 60.0},
                                  {Qt::Key_Comma, 40.0},
                                  {Qt::Key_Left, 21.01},
                                  {Qt::Key_Home, 0.0},
                                  {Qt::Key_Left, 0.0},
                                  {Qt::Key_End, 60.0}}) {
        seek.clear();
        press(key);
        QCOMPARE(seek.size(), 1);
        QCOMPARE(seek.front().front().toDouble(), to);
        QVERIFY(actions().pauseReplay->text().startsWith("Resume"));
    }
    QCOMPARE(figure("replayTime"), QString("1:00 of 1:00"));
}

void TestWindowWork::theTimeLineIsScrubbedAndTellsWhatWas()
{
    QSignalSpy seek(m_window.get(), &MainWindow::seekWanted);
    m_window->setReplaying(true, 60.0);
    ui::replay::Course rested = course();
    rested.rests = {{28.0, 34.0}};
    m_window->setReplayCourse(rested);
    auto* line = child<TimeLine>("timeLine");
    QTRY_VERIFY(line->width() > 400);
    const auto at = [&](double seconds, int y) { return QPoint(qRound(line->xOf(seconds)), y); };
    const double pixelS = 60.0 / (line->xOf(60.0) - line->xOf(0.0));
    const auto isAt = [&](double seconds) { return std::abs(seek.back().front().toDouble() - seconds) <= pixelS; };
    QTest::mousePress(line, Qt::LeftButton, {}, at(30.0, 24));
    QVERIFY(isAt(30.0));
    for (const double seconds : {10.0, 50.0}) {
        QTest::mouseMove(line, at(seconds, 24));
        QVERIFY(isAt(seconds));
    }
    QTest::mouseRelease(line, Qt::LeftButton, {}, at(50.0, 24));
    const auto seeks = seek.size();
    QTest::mouseMove(line, at(20.0, 24));
    QCOMPARE(seek.size(), seeks);
    // What led to the breach is seen.
    QTest::mouseClick(line, Qt::LeftButton, {}, at(20.5, 12));
    QVERIFY(isAt(19.5));
    for (const auto& [place, words] : {std::pair(at(20.5, 12), "pulp is open"),
                                       {at(40.0, 12), "Undone"},
                                       {at(15.0, 12), "Bur 4"},
                                       {at(26.0, 12), "Handpiece: Electric"},
                                       {at(50.0, 12), "Middle pad: said to be dentin"},
                                       {at(7.0, 24), "Stroke 1, 4.0 s"},
                                       {at(30.0, 24), "Elsewhere for 0:06"}})
        QVERIFY2(line->saidAt(place).join(' ').contains(QLatin1String(words)), words);
    QVERIFY(line->saidAt(at(36.0, 24)).isEmpty());
}

QTEST_MAIN(TestWindowWork)
#include "tst_window_work.moc"
