// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include <QObject>
#include <QTimer>

#include "app/attempt/AttemptContext.h"
#include "app/attempt/AttemptController.h"
#include "app/attempt/ResumableAttempts.h"
#include "app/pages/LessonsController.h"
#include "app/school/AttemptUploader.h"
#include "app/threads/LoopThread.h"
#include "core/session/JournalLoop.h"

namespace app {

/// Writes the user's attempts to this computer's disk while they work, and offers the newest one that was not finished:
/// to be resumed, or to be discarded. Attempts of a simulated hand are not written. Ui thread.
class ResumeController final : public QObject
{
    Q_OBJECT

public:
    /// @param retry  the time after which a request that the database did not answer is repeated
    ResumeController(const AttemptContext& context, AttemptController& attempts, LessonsController& lessons,
                     std::chrono::milliseconds retry);
    ~ResumeController() override;

    /// Sets the folder of this computer's own files.
    void setStationFolder(const QString& folder) { m_stationFolder = folder; }
    /// Sets the uploader of graded attempts; null: there is no database.
    void setUploader(const AttemptUploader* uploader) { m_uploader = uploader; }

    /// Starts the journal of the user, and offers the attempt that they did not finish.
    void startJournal();
    /// Stops the journal.
    /// @param isDiscarded  the journal's attempt is not offered again
    void stopJournal(bool isDiscarded);
    [[nodiscard]] bool isRunning() const { return m_journal != nullptr; }
    /// Returns the journal's file of an attempt; empty if there is none, or none yet.
    [[nodiscard]] std::filesystem::path fileOf(std::uint64_t generation) const;
    /// Looks for another unfinished attempt, unless one is offered.
    void offerAnother();

signals:
    /// Emitted when a resumed exam, whose score was seen, has to be graded at once.
    void gradeRequested();

private:
    void leaveOut(std::uint64_t generation);
    void watchJournal();
    void offerUnfinished();
    void searchUnfinished(const database::KnownAttempts& known);
    void showOffer();
    void requestResume();
    void rebuild(int load);
    void resume(std::unique_ptr<core::session::ResumableAttempt> attempt);
    void gradeResumed(int looks);
    void discard();

    AttemptContext m_context;
    AttemptController& m_attempts;
    LessonsController& m_lessons;
    const AttemptUploader* m_uploader = nullptr;
    QString m_stationFolder;
    QTimer m_watch;
    QTimer m_lookAgain;  ///< until the database can say whether an attempt is saved
    std::unique_ptr<core::session::JournalLoop> m_journal;
    std::optional<core::recording::FoundAttempt> m_unfinished;  ///< the one that is offered
    std::optional<GradedMarker>
        m_seenOfUnfinished;  ///< the score of m_unfinished, which the student saw and which was saved nowhere

    // Threads last: they are joined before what they run on goes away.
    std::unique_ptr<LoopThread> m_journalThread;
    std::unique_ptr<LoopThread> m_syncThread;
};

}  // namespace app
