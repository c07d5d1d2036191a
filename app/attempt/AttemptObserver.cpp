// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/attempt/AttemptObserver.h"

#include <algorithm>
#include <filesystem>

#include <QDateTime>

#include "core/grading/Exercise.h"
#include "core/history/MomentId.h"
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

AttemptObserver::AttemptObserver(const Parts& parts)
    : m_window(parts.window), m_channels(parts.channels), m_session(parts.session), m_assessment(parts.assessment),
      m_devices(parts.devices), m_attempt(parts.attempt), m_attempts(parts.attempts), m_resume(parts.resume),
      m_limit(parts.limit), m_school(parts.school)
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
    return mostOf(m_cutWith).value_or(m_devices.hand());
}

ui::render::Stereo AttemptObserver::picture() const
{
    return mostOf(m_cutIn).value_or(m_window.view().settings().presentation.stereo);
}

void AttemptObserver::observe()
{
    if (!m_attempt.isResting()) {
        m_attempts.sendParameters();
        // An exercise is done by touching.
        const bool isExercise =
            m_attempt.assignment().lesson && lessons::isExercise(m_attempt.assignment().lesson->task);
        if (const core::servo::ServoState& servo = m_channels.servo.latest();
            servo.cutting || (isExercise && servo.touching)) {
            ++m_cutIn[m_window.view().settings().presentation.stereo];
            ++m_cutWith[m_devices.cutsWith()];
        }
    }
    if (m_attempt.isResting() || !m_attempt.assignment().lesson)
        return;
    const core::session::Findings findings = m_assessment.findings();
    if (findings.generation != m_attempt.generation())
        return;
    watchExam(findings);
    if (findings.practised)
        m_window.showPractised(*findings.practised);
    if (const auto violation = m_attempt.nextViolation(findings.infractions)) {
        const bool canTakeBack = core::history::lastBefore(m_session.historySoFar(), violation->tick).has_value();
        m_window.tellInfraction(*violation, canTakeBack);
    }
}

/// The first cut of an exam counts as an attempt, whether or not it is graded. A student who opened their last attempt
/// in two windows begins it in one of them.
void AttemptObserver::watchExam(const core::session::Findings& findings)
{
    const bool isBegun =
        findings.process.firstCutS || (findings.practised && core::grading::isBegun(*findings.practised));
    if (!m_attempt.isExam() || !isBegun || !m_school.isLoggedIn() || m_uploader == nullptr)
        return;
    const std::filesystem::path journal = m_resume.fileOf(m_attempt.generation());
    if (journal.empty() || !m_attempt.startExam())  // the journal has yet to read this tooth
        return;
    // Taken up after a kill it is told of again, and is the same one.
    const database::ExamStart start{database::uidOf("exam " + m_school.user.uid() + ' ' + journal.filename().string()),
                                    m_attempt.assignment().lesson->id,
                                    QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()};
    if (m_attempt.exam() == CurrentAttempt::Exam::Counted) {
        m_uploader->send(m_school.user, start);
        return;
    }
    m_limit.ask(start.lessonId, [this, who = m_school.user, start, generation = m_attempt.generation()](bool may) {
        if (may)
            m_uploader->send(who, start);
        if (m_attempt.answerExam(generation, may))
            m_window.refuseExam();
    });
}

}  // namespace app
