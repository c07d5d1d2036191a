// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/attempt/AttemptObserver.h"

#include <algorithm>
#include <filesystem>

#include <QDateTime>

#include "core/grading/Exercise.h"
#include "core/history/MomentId.h"
#include "core/recording/OriginNotes.h"
#include "database/Passwords.h"
#include "ui/tooth/ToothView.h"

namespace app {
namespace {

constexpr int kObservePeriodMs = 50;

/// Returns the key that was counted most often; empty if there is none.
template <class Key>
std::optional<Key> mostOf(const std::map<Key, int>& counts)
{
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most != counts.end() ? std::optional(most->first) : std::nullopt;
}

}  // namespace

AttemptObserver::AttemptObserver(const AttemptContext& context, AttemptController& attempts, ResumeController& resume)
    : m_context(context), m_attempts(attempts), m_resume(resume)
{
    connect(&m_attempts, &AttemptController::loaded, this, [this] {
        m_cutIn.clear();
        m_cutWith.clear();
    });
    m_timer.setInterval(kObservePeriodMs);
    connect(&m_timer, &QTimer::timeout, this, &AttemptObserver::observe);
    m_timer.start();
}

QString AttemptObserver::hand() const
{
    return mostOf(m_cutWith).value_or(m_context.devices.hand());
}

ui::render::Stereo AttemptObserver::picture() const
{
    return mostOf(m_cutIn).value_or(m_context.window.view().settings().presentation.stereo);
}

void AttemptObserver::observe()
{
    if (!m_context.attempt.isResting()) {
        m_attempts.sendParameters();
        // An exercise is done by touching.
        const bool isExercise =
            m_context.attempt.assignment().lesson && lessons::isExercise(m_context.attempt.assignment().lesson->task);
        if (const core::servo::ServoState& servo = m_context.channels.servo.latest();
            servo.cutting || (isExercise && servo.touching)) {
            ++m_cutIn[m_context.window.view().settings().presentation.stereo];
            ++m_cutWith[m_context.devices.cutsWith()];
        }
    }
    if (m_context.attempt.isResting() || !m_context.attempt.assignment().lesson)
        return;
    const core::session::Findings findings = m_context.assessment.findings();
    if (findings.generation != m_context.attempt.generation())
        return;
    watchExam(findings);
    if (findings.practised)
        m_context.window.exerciseView().setPractised(*findings.practised);
    if (const auto violation = m_context.attempt.nextViolation(findings.infractions)) {
        const bool canTakeBack =
            core::history::lastBefore(m_context.session.historySoFar(), violation->tick).has_value();
        m_context.window.infractionView().show(*violation, canTakeBack);
    }
}

/// Counts an exam as an attempt from its first cut on, whether or not it is graded. If the student has no attempt left,
/// for example because another station counted the last one, the exam is refused.
void AttemptObserver::watchExam(const core::session::Findings& findings)
{
    const bool isBegun =
        findings.process.firstCutS || (findings.practised && core::grading::isBegun(*findings.practised));
    if (!m_context.attempt.isExam() || !isBegun || !m_context.school.isLoggedIn() || m_uploader == nullptr)
        return;
    const std::filesystem::path journal = m_resume.fileOf(m_context.attempt.generation());
    if (journal.empty() || !m_context.attempt.startExam())  // the journal has not written this tooth yet
        return;
    // A resumed exam is reported again under the same uid, so that it counts once.
    const database::ExamStart start{
        database::uidOf("exam " + m_context.school.user.uid() + ' ' + journal.filename().string()),
        m_context.attempt.assignment().lesson->id, QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()};
    // The school compares the recording with the start.
    m_context.window.send(core::session::AddNote{core::recording::examNote(start.uid)});
    if (m_context.attempt.exam() == CurrentAttempt::Exam::Counted) {
        m_uploader->send(m_context.school.user, start);
        return;
    }
    m_context.limit.ask(start.lessonId, [this, who = m_context.school.user, start,
                                         generation = m_context.attempt.generation()](bool may) {
        if (may)
            m_uploader->send(who, start);
        if (m_context.attempt.answerExam(generation, may))
            m_context.window.lessonController().refuseExam();
    });
}

}  // namespace app
