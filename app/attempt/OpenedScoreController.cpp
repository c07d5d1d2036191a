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

OpenedScoreController::OpenedScoreController(ui::window::MainWindow& window, AttemptController& attempts,
                                             LatestRequest& loads, const SchoolSession& school)
    : m_window(window), m_attempts(attempts), m_loads(loads), m_school(school)
{
    m_analysis.showOn(m_window.scorePage(), [this] { return isShown(); });
    connect(&m_analysis, &ScoreAnalysis::failed, this, [this](const core::Error& error) {
        if (isShown())
            m_window.showError(error, FailedOperation::Marking);
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
    return {*m_history->talkedAbout(), m_history->nameOfTalkedAbout(), m_school.user, m_school.service};
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

/// Marks the attempt again from its recording, which gives the same score and shows where and when it was lost.
void OpenedScoreController::showAttempt(const database::AttemptRecord& attempt,
                                        const core::recording::Recording& recording)
{
    if (isRefusedInExam())
        return;
    const int load = m_loads.begin();
    m_window.showBusy(tr("Preparing the score card …"));
    inBackground(
        this,
        [recording, workOut = m_attempts.surfaceWorker()] {
            workOut(recording.anatomy());  // it may be played next
            return lessons::markAgain(recording);
        },
        [this, load, attempt, recording](const core::Result<lessons::Remarked>& marked) {
            if (!m_loads.isLatest(load))
                return;
            if (!marked) {
                m_window.showError(marked.error(), FailedOperation::Marking);
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
            m_window.showOldScore(
                [lesson = assignment ? assignment->lesson : std::nullopt, tooth = recording.anatomy()] {
                    return lesson ? ui::text::said(lesson->title) : ui::text::toothTitle(*tooth);
                },
                marked->mark.sheet, {attempt}, expectationOf(attempt), work);
            m_recording = recording;
            m_history->talkAbout(attempt);
            m_window.scorePage().setPerson(attempt.person == m_school.user.person() ? QString()
                                                                                    : m_history->nameOfTalkedAbout());
            if (assignment)
                m_analysis.explain(*assignment, recording, work.tooth, marked->conduct);
        });
}

/// Without a recording nothing can be marked again or played.
void OpenedScoreController::showSheet(const database::AttemptRecord& attempt, const lessons::ScoreSheet& sheet,
                                      const std::function<QString()>& work)
{
    if (isRefusedInExam())
        return;
    m_loads.begin();
    m_window.showOldScore(work, sheet, {attempt}, expectationOf(attempt), {});
    m_recording.reset();
    m_analysis.forget();
    m_history->talkAbout(attempt);
    m_window.scorePage().setPerson(attempt.person == m_school.user.person() ? QString()
                                                                            : m_history->nameOfTalkedAbout());
}

bool OpenedScoreController::isRefusedInExam()
{
    if (!m_window.isExamRunning())
        return false;
    m_window.stopBusy();
    m_window.showMessage(
        tr("Earlier attempts are not available during an exam. Press G to finish the exam, or start another lesson."));
    return true;
}

bool OpenedScoreController::isShown() const
{
    return m_history && m_history->talkedAbout();
}

}  // namespace app
