// SPDX-License-Identifier: GPL-3.0-or-later
// The main window while somebody works: lessons and exams, unsaved and unfinished work, replays.
#include <cmath>
#include <numbers>

#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/ui/WindowTest.h"
#include "ui/inside/SectionView.h"
#include "ui/lessoneditor/LessonEditor.h"
#include "ui/practice/InfractionCard.h"
#include "ui/practice/LessonStrip.h"
#include "ui/practice/ViewMenu.h"
#include "ui/replay/TimeLine.h"
#include "ui/scoring/ScorePage.h"

using namespace core::session;
using namespace core::servo;
using namespace ui::kit;
using namespace ui::practice;
using namespace ui::window;
using core::grading::RuleViolation;
using core::terrain::Material;
using lessons::Task;
using support::assigned;
using support::course;
using support::sheet;
using ui::inside::SectionView;
using ui::practice::InfractionCard;
using ui::practice::LessonStrip;
using ui::replay::TimeLine;

class TestWindowWork : public support::WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void aBreachStopsTheBurAndIsExplained()
    {
        const auto* card = child<InfractionCard>();
        QSignalSpy back(&m_window->infractionView(), &ui::window::InfractionView::takeBackRequested);
        m_window->infractionView().show(breach(RuleViolation::TooDeep), true);
        QVERIFY(card->isVisible());
        QCOMPARE(child<QLabel>("infraction")->text(), QString("Deeper than 2.50 mm"));
        QCOMPARE(drillSent().value(0, true), false);
        press(Qt::Key_Return);
        QVERIFY(!card->isVisible());
        QCOMPARE(back.count(), 1);
        QCOMPARE(back.front().front().toULongLong(), qulonglong{4321});
        // Undo is the same, or the card would go on telling what is no longer there.
        m_window->infractionView().show(breach(RuleViolation::TooDeep), true);
        press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!card->isVisible());
        QCOMPARE(back.count(), 2);
        // Also if the tooth has been pressed meanwhile.
        m_window->infractionView().show(breach(RuleViolation::TooDeep), true);
        m_window->view().setFocus(Qt::MouseFocusReason);
        press(Qt::Key_Return);
        QVERIFY(!card->isVisible());
        QCOMPARE(back.count(), 3);
        QVERIFY(m_window->view().hasFocus());
        // Where there is nothing to go back to, only going on is offered; and in the air nothing was cut.
        for (const auto& [kind, canTakeBack] :
             {std::pair(RuleViolation::TooDeep, false), {RuleViolation::BurInAir, true}}) {
            m_window->infractionView().show(breach(kind), canTakeBack);
            QVERIFY(!child<QPushButton>("takeBack")->isVisible());
            press(Qt::Key_Escape);
            QVERIFY(!card->isVisible());
        }
        QCOMPARE(back.count(), 3);
    }

    void aBreachShowsWhereItIs()
    {
        spoil();
        auto* section = child<SectionView>();
        m_window->infractionView().show(breach(RuleViolation::BurInAir), true);
        QVERIFY2(!section->isVisible(), "there is nothing to be seen");
        // How wide a marginal ridge is, is seen along the tooth only.
        m_window->infractionView().show(breach(RuleViolation::RidgeCut), true);
        QVERIFY(section->isVisible());
        QCOMPARE(section->angleDeg(), 0);
        // What was to be cut lies in the plane that shows where it was cut instead.
        for (const glm::dvec2 place : {glm::dvec2(-4.0, 0.0), {0.0, -4.0}, {-4.0, -4.0}}) {
            core::grading::Infraction infraction = breach(RuleViolation::WrongPlace);
            infraction.placeMm = glm::dvec3(place, 0.0);
            m_window->infractionView().show(infraction, true);
            const double angle = section->angleDeg() * std::numbers::pi / 180.0;
            const glm::dvec2 there = glm::dvec2(support::kLesionX, support::kLesionY) - place;
            QVERIFY(std::abs(there.x * std::sin(angle) - there.y * std::cos(angle)) < support::kLesionRadiusMm);
        }
    }

    void whatARuleStoppedTurnsAgainInTheNextLesson()
    {
        const auto practice = lessons::practiceOn(support::syntheticMolar()).value();
        actions().drill->setChecked(true);
        m_window->infractionView().show(breach(RuleViolation::BurInAir), false);
        QCOMPARE(drillSent(), QList<bool>{false});
        beginLesson(practice);
        QCOMPARE(drillSent(), QList<bool>{true});
        // If the user has stopped the drill, it stays off.
        actions().drill->setChecked(true);
        m_window->infractionView().show(breach(RuleViolation::BurInAir), false);
        press(Qt::Key_Escape);
        QCOMPARE(drillSent(), (QList<bool>{false, true}));
        actions().drill->setChecked(false);
        beginLesson(practice);
        QCOMPARE(drillSent(), QList<bool>{});
    }

    void theBurRestsWhileAnotherPageIsRead()
    {
        spoil();
        for (const bool turned : {true, false}) {
            turn(turned);
            static_cast<void>(drillSent());
            actions().lessons->trigger();
            QCOMPARE(drillSent(), turned ? QList<bool>{false} : QList<bool>{});
            turn(false);
            actions().back->trigger();
            QCOMPARE(drillSent(), turned ? QList<bool>{true} : QList<bool>{});
        }
    }

    void anExerciseHasNoFiguresOfACut()
    {
        const std::array ofACut{"decayFigure", "overcut", "depthFigure"};
        const auto told = [this](const char* name) { return child<TabularDigitsLabel>(name)->isVisible(); };
        QVERIFY(std::all_of(ofACut.begin(), ofACut.end(), told));
        for (const Task task : {Task::TouchPoints, Task::HoldForce}) {
            beginLesson(assigned(task));
            QVERIFY(std::none_of(ofACut.begin(), ofACut.end(), told) && !told("pulpFigure"));
            QVERIFY2(told("enamelRemoved") && told("forceFigure"), "a scratch is told all the same");
            // R begins it anew, and no stroke is to be brought back.
            QSignalSpy again(&m_window->lessonController(), &ui::window::LessonController::attemptAgainRequested);
            static_cast<void>(sent());
            press(Qt::Key_R);
            QCOMPARE(again.size(), 1);
            QVERIFY(sent().empty());
            QVERIFY2(message().isEmpty(), "the school may still refuse it");
            m_window->lessonController().showBegunAgain();
            QVERIFY2(message().contains("starts again"), qPrintable(message()));
            child<MessageBar>()->dismiss();
        }
        beginLesson(assigned("class1-36"));
        QVERIFY(std::all_of(ofACut.begin(), ofACut.end(), told));
    }

    void aLessonBeginsWithItsOwnColours()
    {
        beginLesson(assigned("block-line"));
        QVERIFY(actions().idealColours->isChecked());
        actions().section->trigger();
        QVERIFY(actions().section->isChecked());
        beginLesson(assigned("decay-36-moderate"));
        QVERIFY(!actions().idealColours->isChecked() && !actions().depthColours->isChecked());
        QVERIFY(!actions().section->isChecked());
    }

    void whatAStepNamesIsMarkedOnTheTooth()
    {
        const auto marked = [this] { return m_window->view().exercise().points.size(); };
        const auto goOn = [this] { child<LessonStrip>()->findChildren<QToolButton*>().back()->click(); };
        beginLesson(assigned("class1-36"));
        QCOMPARE(marked(), 1U);
        goOn();
        QCOMPARE(marked(), 0U);
        goOn();
        QCOMPARE(marked(), 2U);
        beginLesson(support::exam());
        QCOMPARE(marked(), 0U);
        beginLesson(assigned("decay-36-moderate"));
        QCOMPARE(marked(), 0U);
    }

    void aLessonsTimeEndsWithTheLesson()
    {
        lessons::Assignment assignment = assigned(Task::TouchPoints);
        assignment.lesson->minutes = 1.0;
        // A tooth that is practised on freely has all the time there is.
        for (const bool isLesson : {true, false, true}) {
            beginLesson(isLesson ? assignment : lessons::practiceOn(support::syntheticMolar()).value());
            record(30.0);
            QVERIFY2(message().isEmpty(), qPrintable(message()));
            record(100.0);
            QVERIFY2(message().contains("time for this lesson is over") == isLesson, qPrintable(message()));
            actions().lessons->trigger();
            QVERIFY2(message().isEmpty(), "it is said where the lesson is");
            actions().back->trigger();
        }
    }

    /// The clock of a lesson stops while nobody works. The clock of an exam runs until the attempt is graded.
    void aLessonsClockRestsWhereNobodyWorks()
    {
        double recordedS = 0.0;
        const auto begin = [&](bool isExam) {
            lessons::Assignment assignment = assigned("class1-36");
            assignment.lesson->minutes = 2.0;
            assignment.lesson->exam = isExam;
            recordedS = 0.0;
            beginLesson(assignment);
        };
        const auto pass = [&](double seconds) {
            recordedS += seconds;
            record(recordedS);
            return child<TabularDigitsLabel>("lessonTime")->text();
        };
        const auto passOnAnotherPage = [&](double seconds) {
            actions().lessons->trigger();
            pass(seconds);
            QVERIFY2(!message().contains("time for this"), qPrintable(message()));
            actions().back->trigger();
        };
        const auto passGraded = [&] {
            m_window->showScore(sheet(3.2, 40, 0.5), {});
            pass(300.0);
            actions().back->trigger();
            return pass(300.0);
        };
        begin(false);
        QCOMPARE(pass(30.0), QString("1:30"));
        passOnAnotherPage(300.0);
        QCOMPARE(pass(10.0), QString("1:20"));
        // Reloading the tooth does not begin a new attempt, so its time goes on.
        actions().reload->trigger();
        QCOMPARE(pass(20.0), QString("1:00"));
        QCOMPARE(passGraded(), QString("1:00"));
        QVERIFY2(!message().contains("time for this lesson"), qPrintable(message()));
        // A resumed attempt keeps the pauses that it had before.
        begin(false);
        m_window->lessonController().resumeClock(100.0, 40.0);
        recordedS = 100.0;
        QCOMPARE(pass(10.0), QString("1:10"));
        begin(true);
        pass(30.0);
        passOnAnotherPage(30.0);
        QCOMPARE(pass(10.0), QString("0:50"));
        QSignalSpy grade(m_window.get(), &MainWindow::gradeRequested);
        QCOMPARE(passGraded(), QString("0:50"));
        QVERIFY(grade.isEmpty());
    }

    /// So that it counts nowhere as time of the attempt. In an exam it does.
    void timeAwayFromTheWorkIsNoted()
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
        m_window->account().ask(ui::people::LoginMode::Locked);
        QCOMPARE(noted(), QList<quint64>{kRestNote});
        m_window->setWho({});
        QCOMPARE(noted(), QList<quint64>{kWorkNote});
        beginLesson(support::exam());
        m_window->account().ask(ui::people::LoginMode::Locked);
        QCOMPARE(noted(), QList<quint64>());
    }

    /// By its time or by its score: then nothing is cut any more, and another attempt is another attempt.
    void anExamEndsOnce()
    {
        spoil();
        lessons::Assignment exam = support::exam();
        const double overS = 60.0 * exam.lesson->minutes + 1.0;
        QSignalSpy again(&m_window->lessonController(), &ui::window::LessonController::attemptAgainRequested);
        QSignalSpy grade(m_window.get(), &MainWindow::gradeRequested);
        const auto mayCut = [&] {
            return actions().drill->isEnabled() && std::any_of(actions().burs.begin(), actions().burs.end(),
                                                               [](const QAction* bur) { return bur->isEnabled(); });
        };
        const auto showScoreAndGoBack = [&] {
            m_window->showScore(sheet(3.2, 40, 0.5), {});
            actions().back->trigger();  // to the lessons
            actions().back->trigger();
        };
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
                actions().back->trigger();
                QVERIFY(!mayCut() && !actions().saveRecording->isEnabled());
                QVERIFY(!actions().undo->isEnabled() && !actions().history->isEnabled());
                actions().reload->trigger();
                QCOMPARE(again.count(), 0);
                QVERIFY2(message().contains("not graded yet"), qPrintable(message()));
            }
            showScoreAndGoBack();
            QVERIFY(!mayCut() && !actions().undo->isEnabled() && !actions().history->isEnabled());
            QVERIFY(actions().saveRecording->isEnabled());
            actions().reload->trigger();
            click("questionSave");
            QCOMPARE(again.count(), byTime ? 1 : 2);
            // It begins as the first did, with the bur turning.
            static_cast<void>(sent());
            beginLesson(exam);
            const QList<bool> drills = drillSent();
            QVERIFY(!drills.isEmpty() && drills.back());
        }
        // If the student has cut nothing when the time is over, there is nothing to grade and the exam begins again.
        beginLesson(exam);
        record(overS, 0.0, true);
        QVERIFY2(message().contains("time for this exam is over"), qPrintable(message()));
        actions().reload->trigger();
        click("questionSave");
        QCOMPARE(again.count(), 3);
        exam.lesson->exam = false;
        beginLesson(exam);
        record(30.0, 0.5, true);
        QVERIFY(mayCut() && actions().undo->isEnabled() && actions().reload->isEnabled());
    }

    /// A program may be left open for a day. What was cut until then can be graded, and another attempt can begin.
    void anAttemptEndsWhenItIsAsLongAsARecordingMayBe()
    {
        constexpr double kSixHoursS = 6.0 * 60.0 * 60.0;
        QSignalSpy again(&m_window->lessonController(), &ui::window::LessonController::attemptAgainRequested);
        for (const bool isLesson : {true, false}) {
            lessons::Assignment lesson = assigned("class1-36");
            lesson.lesson->minutes = 0.0;
            beginLesson(isLesson ? lesson : lessons::practiceOn(support::syntheticMolar()).value());
            record(kSixHoursS, 0.5, true);
            QVERIFY(actions().drill->isEnabled());
            static_cast<void>(sent());
            record(kSixHoursS + 1.0, 0.5, true, true);
            QCOMPARE(drillSent(), QList<bool>{false});
            QVERIFY(!actions().drill->isEnabled() && actions().grade->isEnabled() && actions().undo->isEnabled());
            QVERIFY2(message().contains("six hours"), qPrintable(message()));
            const auto before = again.count();
            actions().reload->trigger();
            click("questionDiscard");
            QCOMPARE(again.count(), before + 1);
        }
        beginLesson(support::exam());
        QSignalSpy grade(m_window.get(), &MainWindow::gradeRequested);
        record(60.0, 0.5, true, true);
        QCOMPARE(grade.count(), 1);
        record(61.0, 0.5, true, true);
        QCOMPARE(grade.count(), 1);
    }

    /// The neighbouring tooth that is to be spared is there to be seen, whatever was chosen before. The choice stays.
    void aWatchedNeighbourIsShown()
    {
        const auto isShown = [&] { return child<ViewMenu>()->settings().showsNeighbours; };
        const auto showsIn = [&](const char* lesson) {
            beginLesson(assigned(lesson));
            return isShown();
        };
        const auto choose = [](QAction* action) {
            action->setEnabled(true);  // without OpenGL it is not
            action->trigger();
        };
        QVERIFY(!showsIn("class1-36"));
        for (const char* boxed : {"class2-36-distal", "class2-36-mesial", "exam-36-class2"})
            QVERIFY2(showsIn(boxed), boxed);
        choose(actions().wetLook);
        QVERIFY(!showsIn("class1-36"));
        QVERIFY(showsIn("class2-26-mesial"));
        choose(actions().neighbours);
        QVERIFY(!isShown());
        beginLesson(assigned("class1-36"));
        choose(actions().neighbours);
        QVERIFY(isShown() && showsIn("class2-26-mesial") && showsIn("class1-36"));
        choose(actions().neighbours);
        choose(actions().wetLook);
    }

    /// The exams that are shipped allow no aid, and tell so. Practice, which allows them, leaves some of them on.
    void aShippedExamLocksTheAids()
    {
        spoil();
        const QList<QAction*> aids{actions().section,      actions().turnSection, actions().radiograph,
                                   actions().depthColours, actions().mirror,      actions().burColour,
                                   actions().fixture,      actions().outline};
        const auto tips = [&] {
            QStringList all;
            for (const QAction* aid : aids)
                all << aid->toolTip();
            return all;
        };
        beginLesson(assigned("class1-36"));
        QVERIFY(actions().section->isEnabled() && actions().radiograph->isEnabled());
        const QStringList allowed = tips();
        for (const char* id : {"exam-36-decay", "exam-26-decay", "exam-36-class1", "exam-36-class2"}) {
            actions().section->setChecked(true);
            actions().mirror->setChecked(true);
            beginLesson(assigned(id));
            record(30.0, 0.5, true);
            const QStringList locked = tips();
            for (qsizetype k = 0; k < aids.size(); ++k)
                QVERIFY2(!aids[k]->isEnabled() && locked[k] != allowed[k], qPrintable(id + (": " + allowed[k])));
            press(Qt::Key_X);
            press(Qt::Key_F);
            QVERIFY(child<PracticeRoom>()->isVisible() && !child<SectionView>()->isVisible());
            for (const char* figure : {"decayFigure", "overcut", "depthFigure"})
                QVERIFY2(!child<QWidget>(figure)->isVisible(), figure);
            QVERIFY(!actions().expert->isVisible() && !actions().undo->isEnabled());
            beginLesson(assigned("class1-36"));
            QCOMPARE(tips(), allowed);
        }
    }

    /// One's own attempt, saved and played while the exam goes on, would tell what went wrong.
    void anExamTellsNothingByAReplay()
    {
        lessons::Assignment exam = support::exam();
        const auto* line = child<TimeLine>("timeLine");
        const auto links = std::make_unique<UiChannels>();
        beginLesson(exam);
        const std::uint64_t own = m_generation;
        const auto breachesTold = [&] {
            m_window->setReplaying(true, 60.0);
            m_window->replayView().setCourse(course());
            show();
            m_window->showBeside(*links, support::syntheticMolar(), 1, {}, "Before");
            m_window->replayView().setBesideCourse(course());
            // The pulp is opened while it is played.
            SessionState session;
            session.toothGeneration = m_generation;
            take({}, session);
            session.pulpExposedMm2 = 0.5;
            take({}, session);
            QStringList told;
            for (const int y : {12, 12 + 32})
                told << line->saidAt({qRound(line->xOf(20.5)), y});
            told = told.filter("pulp is exposed");
            if (child<QLabel>("notice")->isVisible())
                told << child<QLabel>("notice")->text();
            if (!line->saidAt({qRound(line->xOf(40.0)), 12}).join(' ').contains("Undone"))
                told << "the rest of the course is missing";
            m_window->replayView().hideBeside();
            m_window->setReplaying(false);
            m_window->showTooth(exam.anatomy, own, {});
            return told;
        };
        QCOMPARE(breachesTold(), QStringList());
        // Nor is a lesson's ideal looked at in the editor.
        m_window->lessonsPage().setLessons(support::catalog(), {});
        actions().lessons->trigger();
        actions().editLesson->trigger();
        QVERIFY(!child<ui::lessoneditor::LessonEditor>()->isVisible());
        QVERIFY2(message().contains("exam"), qPrintable(message()));
        actions().back->trigger();
        // After grading, and in a practice attempt, nothing is hidden.
        const QStringList all{"0:20  The pulp is exposed", "0:20  The pulp is exposed", "Pulp opened"};
        m_window->showScore(sheet(3.2, 40, 0.5), {});
        actions().back->trigger();
        QCOMPARE(breachesTold(), all);
        exam.lesson->exam = false;
        m_window->setAssignment(exam);
        m_window->showTooth(exam.anatomy, own, {});
        QCOMPARE(breachesTold(), all);
    }

    void theExpertIsOfferedWhereSomethingIsCut()
    {
        lessons::Assignment lesson;
        lesson.anatomy = support::syntheticMolar();
        lesson.lesson.emplace();
        lessons::Assignment exercise = lesson;
        exercise.exercise = core::grading::ForceToHold{};
        exercise.lesson->task = Task::HoldForce;
        lessons::Assignment withExpert = exercise;
        withExpert.lesson->expert.emplace();
        lessons::Assignment exam = withExpert;
        exam.lesson->exam = true;
        const auto isOffered = [this] {
            QSignalSpy wanted(&m_window->replayView(), &ui::window::ReplayView::expertRequested);
            press(Qt::Key_Y);
            const bool isVisible = actions().expert->isVisible();
            return isVisible == (wanted.size() == 1) ? std::optional(isVisible) : std::nullopt;
        };
        QCOMPARE(isOffered(), std::optional(false));
        for (const auto& [assignment, is] :
             {std::pair(&lesson, true), {&exercise, false}, {&withExpert, true}, {&exam, false}}) {
            m_window->setAssignment(*assignment);
            QCOMPARE(isOffered(), std::optional(is));
        }
        // In a replay, the played lesson decides, except during an exam.
        m_window->setReplaying(true, 10.0, nullptr, lessons::Lesson());
        QCOMPARE(isOffered(), std::optional(false));
        m_window->setReplaying(false);
        m_window->setAssignment(lessons::practiceOn(support::syntheticMolar()).value());
        m_window->setReplaying(true, 10.0, nullptr, lessons::Lesson());
        QCOMPARE(isOffered(), std::optional(true));
    }

    void theKeyOfTheExpertSaysWhyThereIsNone()
    {
        lessons::Assignment exercise = assigned(Task::HoldForce);
        exercise.lesson->expert.reset();
        for (const auto& [assignment, words] :
             {std::pair(lessons::practiceOn(support::syntheticMolar()).value(), "Only lessons"),
              {exercise, "exercise"},
              {support::exam(), "exam"}}) {
            beginLesson(assignment);
            press(Qt::Key_Y);
            QVERIFY2(message().contains(words), qPrintable(message()));
        }
    }

    void unsavedWorkIsAskedAbout_data()
    {
        support::rows<QString, QString>("leave", {"tooth", "scan", "window"}, "answer", {"save", "discard", "cancel"});
    }
    void unsavedWorkIsAskedAbout()
    {
        QFETCH(QString, leave);
        QFETCH(QString, answer);
        QSignalSpy tooth(m_window.get(), &MainWindow::toothChosen);
        QSignalSpy scan(m_window.get(), &MainWindow::scanChosen);
        QSignalSpy save(&m_window->unsavedWork(), &ui::window::UnsavedWork::recordingSaveRequested);
        const auto left = [&] { return tooth.size() + scan.size() + (m_window->isVisible() ? 0 : 1); };
        cutSomething(0.5);
        if (leave == "tooth") {
            takeAnotherTooth();
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
            accept(m_file);
            QCOMPARE(save.size(), 1);
            QCOMPARE(left(), 0);
            m_window->showSaved(m_file);
            QCOMPARE(left(), 1);
        }
    }

    void savedWorkIsLeftWithoutAQuestion()
    {
        QSignalSpy chosen(m_window.get(), &MainWindow::toothChosen);
        cutSomething(0.5);
        press(Qt::Key_S, Qt::ControlModifier);
        accept(m_file);
        m_window->showSaved(m_file);
        takeAnotherTooth();
        QCOMPARE(chosen.size(), 1);
        // What was cut since is in no recording.
        cutSomething(0.75);
        takeAnotherTooth();
        QVERIFY(question() != nullptr);
        QTest::keyClick(question(), Qt::Key_Escape);
        // Work that waits for a replay is asked about as well.
        m_window->setReplaying(true, 10.0);
        show();
        record(1.0);
        takeAnotherTooth();
        QVERIFY(question() != nullptr);
        QCOMPARE(chosen.size(), 1);
    }

    void anUnfinishedAttemptIsOffered()
    {
        spoil();
        QSignalSpy resumed(&m_window->resumeOffer(), &ui::window::ResumeOffer::resumeRequested);
        QSignalSpy discarded(&m_window->resumeOffer(), &ui::window::ResumeOffer::discardRequested);
        auto* resume = child<MessageBar>()->findChild<QPushButton*>();
        auto* discard = child<MessageBar>()->findChild<QPushButton*>("decline");
        offerUnfinished(false);
        QVERIFY(message().startsWith("Tooth 36: an attempt of"));
        QVERIFY(resume->isVisible() && discard->isVisible());
        QTest::mouseClick(resume, Qt::LeftButton);
        QCOMPARE(resumed.size(), 1);
        QVERIFY(message().isEmpty());
        // News does not push it out.
        offerUnfinished(false);
        m_window->showMessage("News.");
        QVERIFY(!discard->isVisible());
        press(Qt::Key_Escape);
        QVERIFY(discard->isVisible());
        QTest::mouseClick(discard, Qt::LeftButton);
        QCOMPARE(discarded.size(), 1);
        // Another that was waiting takes its place: a double click is not meant for it.
        offerUnfinished(false);
        QTest::mouseClick(discard, Qt::LeftButton);
        QCOMPARE(discarded.size(), 1);
        QVERIFY(discard->isVisible());
        // The page of lessons has a card for it, and needs no second offer.
        actions().lessons->trigger();
        QVERIFY(message().isEmpty() && child<QFrame>("continueCard")->isVisible());
        actions().back->trigger();
        // If the user closes the offer, it counts neither as accepted nor as declined.
        offerUnfinished(false);
        press(Qt::Key_Escape);
        QVERIFY(message().isEmpty());
        QCOMPARE(discarded.size() + resumed.size(), 2);
    }

    /// It costs an attempt, as to leave one does.
    void anExamIsNotDiscardedUnasked()
    {
        QSignalSpy resumed(&m_window->resumeOffer(), &ui::window::ResumeOffer::resumeRequested);
        QSignalSpy discarded(&m_window->resumeOffer(), &ui::window::ResumeOffer::discardRequested);
        for (const auto& [button, resumes, discards] :
             {std::tuple("questionStay", 0, 0), {"questionSave", 1, 0}, {"questionDiscard", 1, 1}}) {
            offerUnfinished(true);
            actions().lessons->trigger();
            QTest::mouseClick(child<QPushButton>("discardUnfinished"), Qt::LeftButton);
            QVERIFY(question("unfinishedQuestion") != nullptr);
            QVERIFY(child<QLabel>("questionDetail")->text().contains("counts as an attempt"));
            click(button);
            QTRY_VERIFY(question("unfinishedQuestion") == nullptr);
            QCOMPARE(resumed.size(), resumes);
            QCOMPARE(discarded.size(), discards);
            QVERIFY2(child<QFrame>("continueCard")->isVisible() == (resumes + discards == 0), button);
        }
    }

    /// Whoever made it, and whatever else would be lost.
    void aGradeThatIsNotKeptIsAskedAboutFirst()
    {
        spoil();
        cutSomething(1.0);
        m_window->showScore(sheet(40, 30, 0), {});
        child<ui::scoring::ScorePage>()->setKeeping(ui::scoring::ScorePage::Keeping::Refused);
        QVERIFY(child<QLabel>("historyRemark")->text().contains("tries again"));
        m_window->unsavedWork().setUnsavedGrades(1);
        m_window->close();
        QVERIFY(m_window->isVisible() && question("gradeQuestion") != nullptr);
        click("questionStay");
        QVERIFY(m_window->isVisible());
        m_window->unsavedWork().setUnsavedGrades(0);
        m_window->close();
        QVERIFY(question("gradeQuestion") == nullptr);
    }

    void aLessonOfAPackIsUnpackedToBeEdited()
    {
        QSignalSpy unpack(&m_window->lessonEditing(), &ui::window::LessonEditing::unpackRequested);
        lessons::CatalogEntry entry;
        entry.read = support::shipped("class1-36");
        entry.pack = "/folder/course.cusplessons";
        m_window->lessonsPage().setLessons({entry}, {});
        actions().lessons->trigger();
        actions().editLesson->trigger();
        QCOMPARE(unpack.size(), 1);
        QCOMPARE(unpack.front()[0].toString(), QString("/folder/course.cusplessons"));
        QVERIFY(!child<ui::lessoneditor::LessonEditor>()->isVisible());
    }

    void aReplayRestsTheControls()
    {
        QSignalSpy stop(m_window.get(), &MainWindow::replayStopRequested);
        const lessons::Lesson lesson = *support::shipped("class1-36").lesson;
        m_window->setReplaying(true, 60.0, {}, lesson, QStringLiteral("Ada Lovelace, 20/11/2026 10:15"));
        show();
        QVERIFY(m_window->windowTitle().startsWith(QString::fromStdString(lesson.title.at("en")) + " – Ada Lovelace"));
        for (const Qt::Key key : {Qt::Key_D, Qt::Key_R, Qt::Key_2})
            press(key);
        press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(sent().empty());
        m_window->replayView().showEnd();
        QVERIFY(!message().isEmpty());
        press(Qt::Key_Escape);
        QCOMPARE(stop.size(), 1);
        m_window->setReplaying(false);
        show();
        QVERIFY2(message().isEmpty(), "what was said about the replay went with it");
        press(Qt::Key_D);
        QCOMPARE(sent().size(), std::size_t{1});
    }

    void aReplayTellsItsTimeAndPauses()
    {
        QSignalSpy pause(&m_window->replayView(), &ReplayView::pauseRequested);
        m_window->setReplaying(true, 95.0);
        QCOMPARE(figure("replayTime"), QString("0:00 of 1:35"));
        record(67.9);
        QTRY_COMPARE(figure("replayTime"), QString("1:07 of 1:35"));
        for (const bool pauses : {true, false, true}) {
            press(Qt::Key_Space);
            QCOMPARE(actions().pauseReplay->text().startsWith("Resume"), pauses);
            QCOMPARE(pause.takeLast().front().toBool(), pauses);
        }
        QVERIFY2(sent().empty(), "the drill is not meant");
        m_window->setReplaying(false);
        QVERIFY2(actions().pauseReplay->text().startsWith("Pause"), "the next replay begins by running");
        press(Qt::Key_Space);
        QCOMPARE(sent().size(), std::size_t{1});
    }

    void aReplayHasEightSpeeds()
    {
        QSignalSpy speed(&m_window->replayView(), &ReplayView::speedChosen);
        m_window->setReplaying(true, 95.0);
        for (const auto& [key, speeds] :
             {std::pair(Qt::Key_BracketRight, QStringList{"2×", "4×", "8×", "16×", "16×"}),
              {Qt::Key_BracketLeft, QStringList{"8×", "4×", "2×", "1×", "0.5×", "0.25×", "0.1×", "0.1×"}}})
            for (const QString& shown : speeds) {
                press(key);
                QCOMPARE(figure("replaySpeed"), shown);
                QCOMPARE(speed.back().front().toDouble(), shown.chopped(1).toDouble());
            }
        QCOMPARE(speed.size(), 11);
        m_window->setReplaying(false);
        m_window->setReplaying(true, 95.0);
        QCOMPARE(figure("replaySpeed"), QString("1×"));
    }

    void keysGoThroughAReplayByStrokes()
    {
        QSignalSpy seek(&m_window->replayView(), &ReplayView::seekRequested);
        for (const Qt::Key key : {Qt::Key_Right, Qt::Key_Home, Qt::Key_End, Qt::Key_Period})
            press(key);
        QVERIFY2(seek.isEmpty(), "while one drills these keys are the tooth's");
        m_window->setReplaying(true, 60.0);
        m_window->replayView().setCourse(course());
        for (const auto& [key, to] : {std::pair(Qt::Key_Right, 9.01),
                                      {Qt::Key_Period, 21.01},
                                      {Qt::Key_Right, 40.0},
                                      {Qt::Key_Right, 60.0},
                                      {Qt::Key_Comma, 40.0},
                                      {Qt::Key_Left, 21.01},
                                      {Qt::Key_Home, 0.0},
                                      {Qt::Key_Left, 0.0},
                                      {Qt::Key_End, 60.0}}) {
            press(key);
            QCOMPARE(seek.size(), 1);
            QCOMPARE(seek.takeFirst().front().toDouble(), to);
            QVERIFY(actions().pauseReplay->text().startsWith("Resume"));
        }
        QCOMPARE(figure("replayTime"), QString("1:00 of 1:00"));
    }

    void theTimeLineIsScrubbedAndTellsWhatWas()
    {
        QSignalSpy seek(&m_window->replayView(), &ReplayView::seekRequested);
        m_window->setReplaying(true, 60.0);
        ui::replay::AttemptTimeline rested = course();
        rested.rests = {{28.0, 34.0}};
        m_window->replayView().setCourse(rested);
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
        for (const auto& [place, words] : {std::pair(at(20.5, 12), "pulp is exposed"),
                                           {at(40.0, 12), "Undone"},
                                           {at(15.0, 12), "Bur: Straight"},
                                           {at(26.0, 12), "Handpiece: Electric"},
                                           {at(50.0, 12), "Middle pad: answer dentin"},
                                           {at(7.0, 24), "Stroke 1, 4.0 s"},
                                           {at(30.0, 24), "Interruption of 0:06"}})
            QVERIFY2(line->saidAt(place).join(' ').contains(QLatin1String(words)), words);
        QVERIFY(line->saidAt(at(36.0, 24)).isEmpty());
    }

private:
    [[nodiscard]] static core::grading::Infraction breach(RuleViolation kind)
    {
        core::grading::Infraction infraction;
        infraction.breach = kind;
        infraction.limit = 2.5;
        infraction.tick = 4321;
        return infraction;
    }
    void offerUnfinished(bool isExam) const
    {
        m_window->resumeOffer().offer([] { return QString("Tooth 36"); }, QDateTime::currentDateTime(), isExam);
    }
    void takeAnotherTooth() const
    {
        press(Qt::Key_T);
        press(Qt::Key_Return);
    }
    /// Sets whether the servo reports a turning bur.
    void turn(bool on) const
    {
        ServoState servo;
        servo.tick = 1;
        servo.drillOn = on;
        take(servo, {});
        QTRY_COMPARE(actions().drill->isChecked(), on);
    }
    /// The attempt has been recorded for so long, and so much enamel is gone.
    void record(double seconds, double enamelMm3 = 0.0, bool drillOn = false, bool isFull = false) const
    {
        SessionState session;
        session.isFull = isFull;
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

    const QTemporaryDir m_folder;
    const QString m_file = m_folder.filePath("mine.cusprec");
};

CUSP_TEST(TestWindowWork)
#include "tst_window_work.moc"
