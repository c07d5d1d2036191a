// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <QList>
#include <QObject>

#include "app/attempt/AttemptContext.h"
#include "app/attempt/AttemptObserver.h"
#include "app/attempt/OpenedScoreController.h"
#include "app/attempt/ScoreAnalysis.h"
#include "app/pages/ReportController.h"
#include "app/school/AttemptUploader.h"
#include "core/grading/Exercise.h"
#include "database/AttemptRecord.h"
#include "lessons/ClassStanding.h"
#include "lessons/ScoreSheet.h"
#include "ui/scoring/ScorePage.h"

namespace app {

/// Grades the current attempt: waits until the bur has left the tooth, asks for the expected score, marks the work,
/// shows the score and saves it. Ui thread.
class GradingController final : public QObject
{
    Q_OBJECT

public:
    /// The other controllers of an attempt; they outlive this one.
    struct Others
    {
        AttemptController& attempts;
        ResumeController& resume;
        AttemptObserver& observer;
        OpenedScoreController& opened;
    };
    GradingController(const AttemptContext& context, const Others& others);

    /// Sets where grades are sent to; null: there is no database.
    void setUploader(AttemptUploader* uploader);

    /// Returns what a report of the grade is about; empty if nothing was graded.
    [[nodiscard]] std::optional<ReportController::Subject> subject() const;
    /// Returns the recording and the record of the graded attempt; null if nothing was graded.
    [[nodiscard]] const core::recording::Recording* recording() const
    {
        return m_graded ? &m_graded->recording : nullptr;
    }
    [[nodiscard]] const database::AttemptRecord* record() const { return m_graded ? &m_graded->record : nullptr; }
    /// Whether the current work is graded as it is now, and its grade is on the disk or in the database.
    [[nodiscard]] bool isSaved() const;
    /// Whether the grade is a guest's, who could log in to save it.
    [[nodiscard]] bool isGuests() const { return m_graded && m_graded->keeping == Keeping::Guest; }
    /// Saves a guest's grade for the user who has logged in, unless that user has no attempt left. If the database does
    /// not answer, the grade is saved.
    void saveGuestsGrade();
    /// Handles that the database has an attempt now.
    void handleDelivered(const std::string& uid);

private:
    using Keeping = ui::scoring::ScorePage::Keeping;

    void requestGrade();
    void settle(int looks, int settled);
    void gradeNow();
    void finish(const std::optional<ui::scoring::ScorePrediction>& expected);
    [[nodiscard]] database::AttemptRecord recordOf(const core::session::AttemptSnapshot& done,
                                                   const lessons::Conduct& conduct, const lessons::ScoreSheet& sheet,
                                                   const std::optional<ui::scoring::ScorePrediction>& expected) const;
    void saveGrade();
    void saveExam();
    void showExamsScore(const std::string& uid);
    void recordGraded();
    void handleSaved(const PendingAttempt& letter, bool isAgain);
    void handleRefused(const PendingAttempt& letter, bool isAgain, const core::Error& why);
    void handleAnswer(const PendingAttempt& letter, Keeping keeping);
    [[nodiscard]] bool isAsGraded() const;
    void endJournal(const PendingAttempt& letter);
    void showGrade();
    void updateKeeping();
    void updateHistory();

    /// The latest grade. The same work is not graded twice.
    struct Graded
    {
        std::uint64_t generation = 0;
        std::uint64_t hash = 0;
        lessons::ScoreSheet sheet;
        database::AttemptRecord record;
        Keeping keeping{};
        QList<database::AttemptRecord> history;
        lessons::ClassStanding standing;
        std::optional<ui::scoring::ScorePrediction> expected;
        ui::scoring::ScoredWork work;
        core::recording::Recording recording;
        std::optional<core::grading::Practised> practised;  ///< of an exercise, which leaves no mark on the tooth
        bool isOverLimit = false;                           ///< of a guest who logged in for it and had no attempt left
    };

    AttemptContext m_context;
    AttemptController& m_attempts;
    ResumeController& m_resume;
    AttemptObserver& m_observer;
    OpenedScoreController& m_opened;
    AttemptUploader* m_uploader = nullptr;
    std::optional<Graded> m_graded;
    std::string m_scoreToShow;  ///< uid of the exam whose score is shown when it is saved
    ScoreAnalysis m_analysis;   ///< of m_graded
};

}  // namespace app
