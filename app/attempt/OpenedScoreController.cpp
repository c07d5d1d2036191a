// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/attempt/OpenedScoreController.h"

#include "app/threads/Background.h"
#include "lessons/Assignment.h"
#include "ui/scoring/ScorePage.h"
#include "ui/text/LessonTexts.h"

namespace app {
namespace {

using ui::text::FailedOperation;

/// Returns the score that the student expected. The criterion that they expected to cost most is not saved.
std::optional<ui::scoring::ScorePrediction> expectationOf(const database::AttemptRecord& attempt)
{
    if (!attempt.expectedTenths)
        return std::nullopt;
    return ui::scoring::ScorePrediction{*attempt.expectedTenths, {}};
}

}  // namespace

OpenedScoreController::OpenedScoreController(const AttemptContext& context, AttemptController& attempts)
    : m_context(context), m_attempts(attempts)
{
    m_analysis.showOn(m_context.window.scorePage(), [this] { return isShown(); });
    connect(&m_analysis, &ScoreAnalysis::failed, this, [this](const core::Error& error) {
        if (isShown())
            m_context.window.showError(error, FailedOperation::Marking);
    });
    connect(&m_attempts, &AttemptController::cleared, this, &OpenedScoreController::forget);
}

void OpenedScoreController::setHistory(AttemptHistoryController* history)
{
    m_history = history;
    if (history == nullptr)
        return;
    connect(history, &AttemptHistoryController::scoreRequested, this, &OpenedScoreController::showAttempt);
    connect(history, &AttemptHistoryController::sheetRequested, this, &OpenedScoreController::showSheet);
}

ReportController::Subject OpenedScoreController::subject() const
{
    return {*m_history->talkedAbout(), m_history->nameOfTalkedAbout(), m_context.school.user, m_context.school.service};
}

void OpenedScoreController::forget()
{
    m_recording.reset();
    m_analysis.forget();
}

void OpenedScoreController::close()
{
    forget();
    if (m_history)
        m_history->talkAbout({});
}

/// Marks the attempt again from its recording: the score is the same, and shows where and when points were lost.
void OpenedScoreController::showAttempt(const database::AttemptRecord& attempt,
                                        const core::recording::Recording& recording)
{
    if (isRefusedInExam())
        return;
    const int load = m_context.loads.begin();
    m_context.window.showBusy(tr("Preparing the score card …"));
    inBackground(
        this,
        [recording, workOut = m_attempts.surfaceWorker()] {
            workOut(recording.anatomy());  // it may be played next
            return lessons::markAgain(recording);
        },
        [this, load, attempt, recording](const core::Result<lessons::Remarked>& marked) {
            if (!m_context.loads.isLatest(load))
                return;
            if (!marked) {
                m_context.window.showError(marked.error(), FailedOperation::Marking);
                m_history->openSheet(attempt);
                return;
            }
            const auto assignment = lessons::assignmentOf(recording.anatomy(), recording.lesson());
            const ui::scoring::ScoredWork work{std::make_shared<const core::terrain::Tooth>(marked->outcome.tooth),
                                               assignment ? assignment->shownIdeal() : nullptr,
                                               marked->mark.measured,
                                               marked->conduct.infractions,
                                               marked->conduct.aids,
                                               lessons::presetUsed(recording),
                                               assignment ? assignment->exercise : std::nullopt};
            m_context.window.showOldScore(
                [lesson = assignment ? assignment->lesson : std::nullopt, tooth = recording.anatomy()] {
                    return lesson ? ui::text::said(lesson->title) : ui::text::toothTitle(*tooth);
                },
                marked->mark.sheet, {attempt}, expectationOf(attempt), work);
            m_recording = recording;
            m_history->talkAbout(attempt);
            m_context.window.scorePage().setPerson(
                attempt.person == m_context.school.user.person() ? QString() : m_history->nameOfTalkedAbout());
            if (assignment)
                m_analysis.explain(*assignment, recording, work.tooth, marked->conduct);
        });
}

/// Shows a score without its recording: it cannot be marked again or played.
void OpenedScoreController::showSheet(const database::AttemptRecord& attempt, const lessons::ScoreSheet& sheet,
                                      const std::function<QString()>& work)
{
    if (isRefusedInExam())
        return;
    m_context.loads.begin();
    m_context.window.showOldScore(work, sheet, {attempt}, expectationOf(attempt), {});
    m_recording.reset();
    m_analysis.forget();
    m_history->talkAbout(attempt);
    m_context.window.scorePage().setPerson(
        attempt.person == m_context.school.user.person() ? QString() : m_history->nameOfTalkedAbout());
}

bool OpenedScoreController::isRefusedInExam()
{
    if (!m_context.window.isExamRunning())
        return false;
    m_context.window.stopBusy();
    m_context.window.showMessage(
        tr("Earlier attempts are not available during an exam. Press G to finish the exam, or start another lesson."));
    return true;
}

bool OpenedScoreController::isShown() const
{
    return m_history && m_history->talkedAbout();
}

}  // namespace app
