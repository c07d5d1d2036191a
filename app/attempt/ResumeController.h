// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include <QObject>
#include <QTimer>

#include "app/attempt/AttemptController.h"
#include "app/attempt/ResumableAttempts.h"
#include "app/pages/LessonsController.h"
#include "app/school/AttemptUploader.h"
#include "app/school/SchoolSession.h"
#include "app/threads/LoopThread.h"
#include "core/session/JournalLoop.h"

namespace app {

/// Writes the user's attempts to this computer's disk while they work, and offers the newest one that was not finished:
/// to be resumed, or to be discarded. What a simulated hand drills is nobody's work, and is not written. Ui thread.
class ResumeController final : public QObject
{
    Q_OBJECT

public:
    /// All of them outlive the controller.
    struct Parts
    {
        ui::window::MainWindow& window;
        core::session::SessionLoop& session;
        DeviceController& devices;
        PresetController& presets;
        CurrentAttempt& attempt;
        AttemptController& attempts;
        LatestRequest& loads;
        AttemptLimit& limit;
        LessonsController& lessons;
        const SchoolSession& school;
    };
    /// @param retry  the time after which a school that could not be asked is asked again
    ResumeController(const Parts& parts, std::chrono::milliseconds retry);
    ~ResumeController() override;

    /// Sets the folder of this computer's own files.
    void setStationFolder(const QString& folder) { m_stationFolder = folder; }
    /// Sets the uploader of graded attempts; null: there is no database.
    void setUploader(const AttemptUploader* uploader) { m_uploader = uploader; }

    /// Starts the journal of the user, and offers the attempt that they did not finish.
    void startJournal();
    /// Stops the journal.
    /// @param putAway  discards the attempt that it has; otherwise that is found again later
    void stopJournal(bool putAway);
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

    ui::window::MainWindow& m_window;
    core::session::SessionLoop& m_session;
    DeviceController& m_devices;
    PresetController& m_presets;
    CurrentAttempt& m_attempt;
    AttemptController& m_attempts;
    LatestRequest& m_loads;
    AttemptLimit& m_limit;
    LessonsController& m_lessons;
    const SchoolSession& m_school;
    const AttemptUploader* m_uploader = nullptr;
    QString m_stationFolder;
    QTimer m_watch;
    QTimer m_lookAgain;  ///< for attempts of which the school could not say whether they are saved
    std::unique_ptr<core::session::JournalLoop> m_journal;
    std::optional<core::recording::FoundAttempt> m_unfinished;  ///< the one that is offered
    std::optional<GradedMarker> m_seenOfUnfinished;             ///< its score was seen, and is saved nowhere

    // Threads last: they are joined before what they run on goes away.
    std::unique_ptr<LoopThread> m_journalThread;
    std::unique_ptr<LoopThread> m_syncThread;
};

}  // namespace app
