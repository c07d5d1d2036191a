// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QObject>

#include "app/attempt/AttemptContext.h"
#include "app/attempt/AttemptController.h"
#include "app/attempt/ScoreAnalysis.h"
#include "app/pages/AttemptHistoryController.h"
#include "app/pages/ReportController.h"
#include "core/recording/Recording.h"
#include "database/AttemptRecord.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Opens the score of an earlier attempt on the score page. Ui thread.
class OpenedScoreController final : public QObject
{
    Q_OBJECT

public:
    OpenedScoreController(const AttemptContext& context, AttemptController& attempts);

    /// Sets the list of attempts that scores are opened from; null: there is no database.
    void setHistory(AttemptHistoryController* history);
    /// Whether an exam is running, in which earlier attempts stay closed. Then the window says so.
    [[nodiscard]] bool isRefusedInExam();
    /// Whether the score page shows an earlier attempt, and not the work graded last.
    [[nodiscard]] bool isShown() const;

    /// Returns the recording of the attempt that is shown; null if none is shown, or it has none.
    [[nodiscard]] const core::recording::Recording* recording() const { return m_recording ? &*m_recording : nullptr; }
    /// Returns what a report of the shown attempt is about.
    [[nodiscard]] ReportController::Subject subject() const;
    /// Forgets the recording and its analysis.
    void forget();
    /// Leaves the score page to the work graded last.
    void close();

private:
    void showAttempt(const database::AttemptRecord& attempt, const core::recording::Recording& recording);
    void showSheet(const database::AttemptRecord& attempt, const lessons::ScoreSheet& sheet,
                   const std::function<QString()>& work);

    AttemptContext m_context;
    AttemptController& m_attempts;
    AttemptHistoryController* m_history = nullptr;
    std::optional<core::recording::Recording> m_recording;
    ScoreAnalysis m_analysis;
};

}  // namespace app
