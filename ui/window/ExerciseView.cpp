// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ExerciseView.h"

#include <QAction>

#include "core/teeth/Block.h"
#include "ui/kit/Actions.h"
#include "ui/practice/ExerciseCard.h"
#include "ui/practice/HistoryPanel.h"
#include "ui/practice/LessonStrip.h"
#include "ui/practice/SidePanel.h"
#include "ui/tooth/ToothView.h"
#include "ui/window/CommandSender.h"
#include "ui/window/PracticeRoom.h"
#include "ui/window/ReplayView.h"

namespace ui::window {

ExerciseView::ExerciseView(const PracticeState& state, PracticeRoom& room, kit::Actions& actions,
                           tooth::ToothView& view, const ReplayView& replay, CommandSender& commands)
    : QObject(&room), m_state(state), m_room(room), m_actions(actions), m_view(view), m_replay(replay),
      m_card(new practice::ExerciseCard(actions.grade, &room))
{
    room.setExercise(m_card);
    connect(m_card, &practice::ExerciseCard::answered, this,
            [&commands](std::size_t pad, core::terrain::Material said) {
                commands.send(core::session::AddNote{core::grading::answerNote(pad, said)});
            });
    connect(&room.lesson(), &practice::LessonStrip::stepShown, this, &ExerciseView::mark);
    connect(&replay, &ReplayView::pointsChanged, this, &ExerciseView::mark);
}

bool ExerciseView::isShown() const
{
    return m_card->isVisibleTo(&m_room);
}

void ExerciseView::begin()
{
    const bool isThere =
        m_state.isAssigned() && m_state.assignment->exercise && !m_state.isReplaying && m_state.tooth != nullptr;
    if (isThere && m_generation != m_state.ownGeneration) {
        m_generation = m_state.ownGeneration;
        m_touched.reset();
        m_card->begin(*m_state.assignment->exercise);
    }
    m_card->setVisible(isThere);
    if (isThere)
        m_room.setHintVisible(false);
    mark();
}

void ExerciseView::setServo(const core::servo::ServoState& servo)
{
    if (m_card->isVisible())
        m_card->setServo(servo);
}

void ExerciseView::setPractised(const core::grading::Practised& practised)
{
    if (!isShown())
        return;
    m_card->setPractised(practised);
    if (const auto* touched = std::get_if<core::grading::Touched>(&practised);
        touched != nullptr && m_touched != *touched) {
        m_touched = *touched;
        mark();
    }
}

void ExerciseView::conclude()
{
    if (!isShown())
        return;
    m_card->conclude();
    mark();
}

/// Returns the outlines and names of the pads. Until the exercise has a grade, only these are shown.
tooth::ExerciseMarks ExerciseView::marksOfPads() const
{
    tooth::ExerciseMarks marks;
    const glm::dvec2 half(0.5 * core::teeth::kPadWidthMm, 0.5 * core::teeth::kPadLengthMm);
    for (std::size_t pad = 0; pad < core::grading::kPads; ++pad) {
        const glm::dvec2 middle(core::teeth::kPadX.at(pad), 0.0);
        marks.pads.push_back({practice::padName(pad), middle - half, middle + half});
    }
    marks.showsHeight = !m_actions.bringHome->isVisible();  // a force device lets the hand feel the height
    return marks;
}

void ExerciseView::mark()
{
    const bool isBlind = isBlindfolded();
    tooth::ExerciseMarks marks = isBlind ? marksOfPads() : tooth::ExerciseMarks{};
    ReplayView::Points points = m_replay.points();
    marks.points = std::move(points.replayed);
    if (const auto* touch =
            isShown() ? std::get_if<core::grading::PointsToTouch>(&*m_state.assignment->exercise) : nullptr)
        for (std::size_t k = 0; k < touch->pointsMm.size(); ++k)
            marks.points.push_back({touch->pointsMm[k], touch->reachMm, m_touched && m_touched->atS.at(k)});
    if (m_state.isAssigned() && m_state.ideal != nullptr && !m_state.isReplaying && !m_state.isExam())
        m_room.lesson().markPlaces(marks, *m_state.tooth, *m_state.ideal);
    m_view.setExercise(marks);
    if (m_replay.beside() != nullptr)
        m_replay.beside()->setExercise(isBlind ? marks : tooth::ExerciseMarks{std::move(points.beside), {}, false});
    m_room.panel().setBlindfold(isBlind);
    showHistory();
    emit changed();
}

void ExerciseView::showHistory()
{
    m_room.history().setVisible(!m_state.isReplaying && !isBlindfolded() && !m_state.isExam() &&
                                m_actions.history->isChecked());
}

bool ExerciseView::isBlindfolded() const
{
    const bool areUnnamed =
        m_state.assignment && m_state.assignment->exercise && m_generation == m_state.ownGeneration &&
        std::holds_alternative<core::grading::PadsToName>(*m_state.assignment->exercise) && !m_card->isConcluded();
    // A replay of such a block must not show the tissues either.
    return areUnnamed && (isShown() || (m_state.isReplaying && m_state.tooth != nullptr &&
                                        m_state.tooth->name == m_state.assignment->anatomy->name));
}

}  // namespace ui::window
