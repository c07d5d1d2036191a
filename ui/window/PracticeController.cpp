// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/PracticeController.h"

#include "core/bur/Bur.h"
#include "core/guidance/Margin.h"
#include "ui/inside/SectionView.h"
#include "ui/practice/HistoryPanel.h"
#include "ui/practice/Limit.h"
#include "ui/practice/SidePanel.h"
#include "ui/practice/ViewMenu.h"
#include "ui/tooth/ToothView.h"
#include "ui/window/AttemptNotes.h"
#include "ui/window/BurControl.h"
#include "ui/window/ExerciseView.h"
#include "ui/window/LessonController.h"
#include "ui/window/PracticeRoom.h"
#include "ui/window/ReplayView.h"

namespace ui::window {
namespace {

constexpr qint64 kGuideEveryMs = 100;

}  // namespace

PracticeController::PracticeController(core::session::UiChannels& links, PracticeState& state, PracticeRoom& room,
                                       tooth::ToothView& view, const practice::ViewMenu& viewMenu, BurControl& bur,
                                       ReplayView& replay, ExerciseView& exercise, LessonController& lesson,
                                       AttemptNotes& notes)
    : QObject(&room), m_channels(&links), m_state(state), m_room(room), m_view(view), m_viewMenu(viewMenu), m_bur(bur),
      m_replay(replay), m_exercise(exercise), m_lesson(lesson), m_notes(notes)
{}

void PracticeController::setTooth()
{
    m_pulp.emplace(*m_state.tooth);
}

void PracticeController::takeFrame(const core::servo::ServoState& servo)
{
    takeSession();
    m_state.servo = servo;
    const core::imaging::DepthReading reading = readDepth(servo);
    m_room.panel().setFigures(servo, m_state.session, reading);
    m_room.section().follow(m_view.tooth(), m_view.toothRevision(), servo, reading);
    showGuide(servo);
    m_exercise.setServo(servo);
    if (servo.cutting && !m_hasCut) {
        m_hasCut = true;
        m_room.setHintVisible(false);
    }
    m_bur.show(servo);
    if (servo.tick > 0)
        m_view.setDrillOn(servo.drillOn);
    emit frameTaken(servo);
}

/// Returns the depth of the bur and its distance from the pulp. The depth comes from the servo, which measures it at
/// steep walls too. Above the uncut surface there is no depth.
core::imaging::DepthReading PracticeController::readDepth(const core::servo::ServoState& servo) const
{
    const core::terrain::Tooth* tooth = m_view.tooth();
    core::imaging::DepthReading reading;
    if (tooth != nullptr && m_pulp && servo.tick > 0)
        reading =
            core::imaging::readDepth(*tooth, *m_pulp, servo.anchorMm, core::bur::burs()[servo.burIndex].headRadiusMm);
    reading.overTooth = servo.hasDepth && (servo.touching || reading.depthMm >= 0.0);
    reading.depthMm = servo.depthMm;
    if (!reading.overTooth && !servo.touching) {
        reading.dentinOverPulpMm.reset();
        reading.toPulpMm.reset();
    }
    return reading;
}

/// Shows how near the bur is to the ideal and, ten times a second, how much of the work is done.
void PracticeController::showGuide(const core::servo::ServoState& servo)
{
    const core::terrain::Tooth* tooth = m_view.tooth();
    if (tooth == nullptr || m_state.ideal == nullptr || !m_state.aids.ideal || servo.tick == 0) {
        m_view.setBurTint({});
        m_room.panel().setGuide({}, {});
        return;
    }
    std::optional<double> marginMm;
    if (m_viewMenu.settings().showsMargin && servo.burIndex < core::bur::burs().size())
        marginMm = core::guidance::marginMm(*tooth->anatomy, *m_state.ideal, core::bur::burs()[servo.burIndex],
                                            servo.anchorMm);
    m_view.setBurTint(practice::limitColour(marginMm));
    if (m_sinceGuide.isValid() && m_sinceGuide.elapsed() < kGuideEveryMs)
        return;
    m_sinceGuide.start();
    m_room.panel().setGuide(marginMm, core::guidance::progressOf(*tooth->anatomy, *m_state.ideal, tooth->top));
}

void PracticeController::showChannels(core::session::UiChannels& channels)
{
    m_channels = &channels;
    m_view.showChannels(channels);
}

void PracticeController::takeSession()
{
    const core::session::SessionState& now = m_channels->session.latest();
    const bool hasOtherSteps = now.undoSteps != m_state.session.undoSteps || now.redoSteps != m_state.session.redoSteps;
    showHarm(now);
    m_state.session = now;
    if (m_state.isReplaying) {
        m_replay.follow();
    } else if (m_state.session.toothGeneration == m_state.ownGeneration) {
        m_lesson.follow();
        m_room.history().follow(m_state.session.historyVersion);
    }
    if (hasOtherSteps)
        emit changed();
    m_notes.update();
}

/// Shows a notice when the pulp is opened or the tooth is perforated, but not when such a tooth is loaded. Does nothing
/// in a lesson, whose rules decide what is shown, and during an exam.
void PracticeController::showHarm(const core::session::SessionState& now)
{
    const bool inLesson =
        m_state.assignment && m_state.assignment->lesson && (!m_state.isReplaying || m_state.isExamRunning());
    const core::session::SessionState& before = m_state.session;
    if (now.toothGeneration != before.toothGeneration || inLesson)
        return;
    const auto isOpen = [](const core::session::SessionState& state) { return state.pulpExposedMm2 > 0.0; };
    const QString toDo = m_state.isReplaying ? QString() : tr("You can undo the stroke.");
    if (now.perforated && !before.perforated)
        m_room.showNotice(tr("Tooth perforated"), toDo);
    else if (isOpen(now) && !isOpen(before))
        m_room.showNotice(tr("Pulp opened"), toDo);
    else if (!now.perforated && !isOpen(now))
        m_room.hideNotice();
}

}  // namespace ui::window
