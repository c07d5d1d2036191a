// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/LessonController.h"

#include <QAction>

#include "core/bur/Bur.h"
#include "ui/catalog/LessonsPage.h"
#include "ui/inside/SectionView.h"
#include "ui/kit/Actions.h"
#include "ui/kit/MessageBar.h"
#include "ui/practice/HandControls.h"
#include "ui/practice/LessonStrip.h"
#include "ui/practice/SidePanel.h"
#include "ui/practice/ViewMenu.h"
#include "ui/text/LessonTexts.h"
#include "ui/window/BurControl.h"
#include "ui/window/CommandSender.h"
#include "ui/window/ExerciseView.h"
#include "ui/window/Navigation.h"
#include "ui/window/PracticeRoom.h"
#include "ui/window/UnsavedWork.h"

namespace ui::window {
namespace {

constexpr double kSecondsPerMinute = 60.0;

}  // namespace

using kit::Actions;
using kit::MessageBar;

LessonController::LessonController(PracticeState& state, PracticeRoom& room, kit::Actions& actions,
                                   practice::ViewMenu& viewMenu, kit::MessageBar& messages,
                                   catalog::LessonsPage& lessons, const Navigation& navigation, BurControl& bur,
                                   ExerciseView& exercise)
    : QObject(&room), m_state(state), m_room(room), m_actions(actions), m_viewMenu(viewMenu), m_messages(messages),
      m_lessons(lessons), m_navigation(navigation), m_bur(bur), m_exercise(exercise),
      m_clock([&state] { return state.session.recordedS; })
{}

void LessonController::begin(const lessons::Assignment& assignment)
{
    const bool isRepeated = m_state.assignment && lessons::isSameLesson(*m_state.assignment, assignment);
    m_state.assignment = assignment;
    m_state.isGraded = false;
    m_state.isOver = false;
    m_state.isExamRefused = false;
    m_clock.begin(assignment.lesson ? assignment.lesson->minutes * kSecondsPerMinute : 0.0);
    m_messages.withdraw(MessageBar::Topic::Lesson);
    setUsedUp(false);
    setAids(assignment.lesson ? assignment.lesson->aids : lessons::Aids{});
    m_room.panel().setLesson(m_state.lesson());
    m_actions.fixture->setChecked(false);
    m_lessons.setPresent(assignment.lesson ? assignment.lesson->id : std::string());
    m_room.panel().hand().begin(m_state.aids.depthStop && !assignment.exercise, lessons::depthToCutMm(assignment));
    m_bur.beginTask(assignment.lesson ? assignment.lesson->task : lessons::Task::RemoveDecay);
    m_viewMenu.showNeighbours(assignment.neighbours != nullptr);
    if (!isRepeated)
        m_viewMenu.outlineIdeal(lessons::beginsWithOutline(assignment));
    m_exercise.showHistory();
    if (!assignment.lesson) {
        m_room.lesson().setPractice();
        return;
    }
    // A new lesson begins without the section and the colours that were on in the lesson before.
    m_actions.section->setChecked(false);
    m_room.setSectionVisible(false);
    m_viewMenu.colourAgainstIdeal(assignment.lesson->task == lessons::Task::TraceShape);
    m_room.lesson().setLesson(*assignment.lesson);
    if (!assignment.lesson->burs.empty())
        if (const auto bur = core::bur::findBur(assignment.lesson->burs.front()))
            m_bur.chooseBur(static_cast<int>(*bur));
}

void LessonController::setAids(const lessons::Aids& aids)
{
    m_state.aids = aids;
    showIdeal();
    Actions::setAllowed(m_actions.section, aids.section);
    Actions::setAllowed(m_actions.turnSection, aids.section);
    Actions::setAllowed(m_actions.radiograph, aids.radiograph);
    Actions::setAllowed(m_actions.depthColours, aids.heatMap);
    Actions::setAllowed(m_actions.mirror, aids.mirror);
    Actions::setAllowed(m_actions.burColour, aids.burColour && aids.ideal);
    Actions::setAllowed(m_actions.fixture, aids.fixture);
    const auto& assignment = m_state.assignment;
    m_actions.allowBurs(assignment && assignment->lesson ? assignment->lesson->burs : std::vector<std::string>{});
    m_room.panel().setTold(aids.depthGauge, aids.depthGauge && aids.radiograph);
    m_room.section().setFiguresShown(aids.depthGauge);
    if (!aids.section) {
        m_actions.section->setChecked(false);
        m_room.setSectionVisible(false);
    }
    if (!aids.radiograph)
        emit radiographLocked();
    emit changed();
}

void LessonController::showIdeal()
{
    const bool mayBeSeen = m_state.aids.ideal;
    const bool isExam = m_state.isExam();
    lessons::Aids given = m_state.aids;
    given.ideal = mayBeSeen && m_state.ideal != nullptr;
    Actions::setAllowed(m_actions.idealColours, given.heatMap && given.ideal,
                        mayBeSeen ? tr("Only a tooth with decay has an ideal preparation.") : QString());
    Actions::setAllowed(m_actions.outline, given.ideal && !isExam,
                        isExam      ? tr("The outline is not available in an exam.")
                        : mayBeSeen ? tr("This tooth has no ideal preparation.")
                                    : QString());
    m_viewMenu.setAllowed(given);
    m_room.section().setIdeal(given.ideal ? m_state.ideal : nullptr);
}

void LessonController::setUsedUp(bool usedUp)
{
    m_state.isUsedUp = usedUp;
    Actions::setAllowed(m_actions.reload, !usedUp, text::usedUpWords());
    emit changed();
}

void LessonController::follow()
{
    if (!m_state.assignment)
        return;
    // Free practice continues after its grade.
    const bool isOver = m_state.isGraded && m_state.assignment->lesson;
    const bool isWorking = !isOver && (m_state.isExam() || m_navigation.isInRoom());
    if (m_state.session.isFull && m_state.session.toothGeneration == m_state.ownGeneration && !m_state.isOver)
        endAtLimit();
    const bool isTimeOver = m_clock.advance(isWorking);
    if (isWorking)
        m_room.lesson().setTime(m_clock.workedS());
    if (isTimeOver)
        endTime();
    m_room.lesson().follow(m_state.session.wholeMm3, m_state.session.removedMm3,
                           m_room.panel().hand().isDeep(m_state.servo));
}

/// Handles the end of the lesson's time. An exam ends and is graded. Practice shows a message and continues.
void LessonController::endTime()
{
    if (!m_state.isExam()) {
        m_messages.say({MessageBar::Kind::News,
                        tr("The time for this lesson is over. Continue as long as you like, or press G for the grade."),
                        {},
                        {},
                        {},
                        MessageBar::Topic::Lesson});
        return;
    }
    endExam();
    // The message stays on every page until the user closes it.
    m_messages.say([] {
        return MessageBar::Message{
            MessageBar::Kind::Warning, tr("The time for this exam is over: cutting is disabled."), {}, {}, {},
            MessageBar::Topic::Tooth};
    });
    emit gradeRequested();
}

/// Ends an attempt that is as long as a recording may be, such as that of a program that was left open for a day.
void LessonController::endAtLimit()
{
    if (m_state.isExam()) {
        endTime();
        return;
    }
    m_state.isOver = true;
    m_bur.stopAtEnd();
    m_messages.say([] {
        return MessageBar::Message{MessageBar::Kind::Warning,
                                   tr("This attempt has lasted six hours, the longest that Cusp records: cutting is "
                                      "disabled. Press G for the grade, or R for another attempt."),
                                   {},
                                   {},
                                   {},
                                   MessageBar::Topic::Tooth};
    });
    emit changed();
}

void LessonController::endExam()
{
    if (!m_state.isExam())
        return;
    m_state.isOver = true;
    m_clock.stop();
    m_room.lesson().conclude(m_state.isExamRefused ? practice::LessonStrip::Ending::Refused
                                                   : practice::LessonStrip::Ending::WithScore);
    m_room.setHintVisible(false);
    m_bur.stopAtEnd();
    emit changed();
}

void LessonController::refuseExam()
{
    m_state.isExamRefused = true;
    endExam();
    setUsedUp(true);
    say(text::begunElsewhereWords());
}

void LessonController::startAgain(CommandSender& commands, UnsavedWork& unsaved)
{
    const bool isExercise = m_exercise.isShown();
    const bool hasWork = isExercise || m_state.ownWork() != core::terrain::PerMaterial{};
    if (m_state.isExam() && m_state.isOver && !m_state.isGraded && hasWork) {
        emit roomRequested();
        say(tr("This exam is over but not graded yet. Press G to grade it."));
    } else if (isExercise || m_state.isExam()) {
        m_lessons.begin(*m_state.assignment->lesson, [this] { emit attemptAgainRequested(); });
    } else if (m_state.isGraded || m_state.isOver) {
        unsaved.leaveWork([this] { emit attemptAgainRequested(); });
    } else {
        emit roomRequested();
        if (!commands.send(core::session::Reload{}))
            return;
        m_messages.say({MessageBar::Kind::News, tr("The tooth was reset."), {}, tr("Restore my work"), [&commands] {
                            commands.send(core::session::Undo{});
                        }});
    }
}

void LessonController::showBegunAgain()
{
    emit roomRequested();
    say(m_state.isExam()              ? tr("Another attempt at the exam begins.")
        : m_exercise.isShown()        ? tr("The exercise starts again.")
        : m_state.lesson() == nullptr ? tr("Another attempt begins.")
                                      : tr("Another attempt at the lesson begins."));
}

void LessonController::say(const QString& sentence)
{
    m_messages.say({MessageBar::Kind::News, sentence, {}, {}, {}});
}

}  // namespace ui::window
