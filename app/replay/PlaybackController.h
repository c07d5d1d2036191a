// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include <QObject>
#include <QString>

#include "app/attempt/AttemptContext.h"
#include "app/attempt/GradingController.h"
#include "app/attempt/OpenedScoreController.h"
#include "app/devices/SoundController.h"
#include "app/pages/AttemptHistoryController.h"
#include "app/replay/ReplayController.h"
#include "haptics/DeviceSwitch.h"
#include "haptics/ServoLoop.h"

namespace app {

/// Plays recordings in the practice room: a file, an earlier attempt, the graded attempt from a moment on, or an
/// expert's; alone or beside another one. Meanwhile the student's own attempt rests: window and sound get the states of
/// the replay from channels of its own. Ui thread.
class PlaybackController final : public QObject
{
    Q_OBJECT

public:
    /// What a replay works with besides the attempt; all of them outlive the controller.
    struct Others
    {
        haptics::ServoLoop& servo;
        SoundController& sound;
        haptics::DeviceSwitch& bur;
        AttemptController& attempts;
        OpenedScoreController& opened;
        GradingController& grading;
    };
    /// @param isForPicture  the program draws one picture and quits: recordings are played to their end at once
    PlaybackController(const AttemptContext& context, const Others& others, bool isForPicture);

    /// Sets the list of earlier attempts, which are played from there; null: there is no database.
    void setHistory(AttemptHistoryController* history);
    void openRecording(const QString& path);
    /// Plays the attempt whose score is shown, from a little before this moment.
    void showMoment(double seconds);
    /// Ends a replay without returning to the student's own work: the program quits.
    void stop() { m_replay.reset(); }
    /// Returns the place to which a force device leads the hand along the recording, tooth frame, mm; empty if it does
    /// not.
    [[nodiscard]] std::optional<glm::dvec3> leadMm();

private:
    using UseRecording = std::function<void(const core::recording::Recording&)>;
    using ReadRecording = std::function<core::Result<core::recording::Recording>()>;

    void playKept(const core::recording::Recording& recording, const database::AttemptRecord& attempt,
                  const QString& whose);
    void leaveToAnotherTooth();
    void openBeside(const QString& path);
    /// @param path  of the recording; empty: it is no file
    void compareWith(const core::recording::Recording& recording, const QString& name, const QString& path);
    void openExpert();
    void openExpertAt(const lessons::Assignment& assignment);
    void openDemonstration(const lessons::Assignment& assignment);
    void showExpert(const core::recording::Recording& recording, const QString& name, const QString& path);
    void readRecording(const QString& path, const UseRecording& use);
    /// @param read  called on another thread
    void readRecording(const QString& path, const UseRecording& use, const ReadRecording& read);
    /// @param momentS  plays from a little before this moment; empty: from the beginning
    /// @returns false if it cannot be played; the window then shows why
    bool play(const core::recording::Recording& recording, std::optional<double> momentS = {},
              const QString& whose = {});
    void playOpened(std::optional<double> momentS);
    void endReplay();
    void rest();
    void showOwn();
    void stopReplay();

    AttemptContext m_context;
    haptics::ServoLoop& m_servo;
    SoundController& m_sound;
    haptics::DeviceSwitch& m_bur;
    AttemptController& m_attempts;
    OpenedScoreController& m_opened;
    GradingController& m_grading;
    AttemptHistoryController* m_history = nullptr;
    bool m_isForPicture;
    /// Where the replay was requested, and where it returns to.
    enum class PlayedFrom : std::uint8_t { Elsewhere, ScoreCard, Attempts };
    PlayedFrom m_playedFrom = PlayedFrom::Elsewhere;
    core::session::UiChannels m_shown;  ///< that the replay writes
    std::unique_ptr<ReplayController> m_replay;
    std::shared_ptr<const core::terrain::ToothAnatomy> m_replayed;
};

}  // namespace app
