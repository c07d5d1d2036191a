// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>

#include "app/LoginController.h"
#include "app/PictureWriter.h"
#include "app/SchoolController.h"
#include "app/attempt/AttemptContext.h"
#include "app/attempt/AttemptController.h"
#include "app/attempt/AttemptObserver.h"
#include "app/attempt/CurrentAttempt.h"
#include "app/attempt/GradingController.h"
#include "app/attempt/OpenedScoreController.h"
#include "app/attempt/ResumeController.h"
#include "app/attempt/SimulatedHand.h"
#include "app/devices/DeviceController.h"
#include "app/devices/HeadTrackingController.h"
#include "app/devices/PedalController.h"
#include "app/devices/SoundController.h"
#include "app/pages/AdminController.h"
#include "app/pages/AttemptHistoryController.h"
#include "app/pages/LessonsController.h"
#include "app/pages/PresetController.h"
#include "app/pages/ReportController.h"
#include "app/pages/TourController.h"
#include "app/replay/PlaybackController.h"
#include "app/school/AttemptLimit.h"
#include "app/school/SchoolSession.h"
#include "app/threads/LatestRequest.h"
#include "app/threads/SessionThreads.h"
#include "core/session/LiveAssessmentLoop.h"
#include "core/session/SessionChannels.h"
#include "core/session/SessionLoop.h"
#include "core/teeth/ToothBuilder.h"
#include "haptics/DeviceSwitch.h"
#include "haptics/ServoLoop.h"
#include "haptics/pointer/PointerDevice.h"
#include "haptics/simulated/GuidedFalcon.h"
#include "ui/sound/QtAudioPort.h"
#include "ui/window/MainWindow.h"

namespace app {

/// What the command line asks of the window.
struct WindowOptions
{
    core::teeth::ToothSource source;  ///< the tooth to begin with
    core::teeth::BuildOptions build;
    QString recording;                         ///< play this instead of beginning with a tooth
    QString database;                          ///< a file or a server's address; empty: the user's own file
    database::sql::Database::Options opening;  ///< for tests
    /// How long the login waits for a database that hangs.
    std::chrono::milliseconds loginPatience{12'000};
    /// The time after which a failed request to the database is repeated.
    std::chrono::milliseconds retry = SchoolService::kRetry;
    bool asksWho = false;     ///< begin at the login; else as a guest
    bool showsRound = false;  ///< whoever has not seen the tour
    QString picture;          ///< draw the tooth, or the end of the recording, into this file and quit
    /// The id of the hand to work with in this run, one of handIds(); empty: the one that was chosen in the last run.
    QString device;
    /// The force devices that this station can have.
    std::vector<DeviceRow> devices = stationDevices();
    /// The way to the audio outputs.
    ui::sound::SoundPlayer::MakePort audioPort = ui::sound::qtAudioPort;
};

/// The program behind the window: constructs the loops, their threads and the controllers, connects, starts and stops
/// them. It holds no rule of its own; docs/ARCHITECTURE.md names the controller of each. Ui thread.
class Application final : public QObject
{
    Q_OBJECT

public:
    /// Errors of the shipped settings only; later errors are shown in the window.
    [[nodiscard]] static core::Result<std::unique_ptr<Application>> make(const WindowOptions& options);
    ~Application() override;

    void show();
    [[nodiscard]] ui::window::MainWindow& window() { return *m_window; }

    /// The error that ended the program before its window was closed; empty after a usual end.
    [[nodiscard]] const std::optional<core::Error>& endedBy() const { return m_endedBy; }

    /// Plays the attempt that was graded last, from a little before this moment.
    void showMoment(double seconds) { m_playback.showMoment(seconds); }

private:
    Application(const WindowOptions& options, std::unique_ptr<core::servo::ServoTick> tick);

    void connectControllers();
    void openDatabase();
    void endWith(const core::Error& error);

    WindowOptions m_options;
    std::optional<core::Error> m_endedBy;

    // The loops, and the channels between them.
    core::session::UiChannels m_channels;
    core::servo::ServoChannels m_servoChannels;
    core::rt::TripleBuffer<core::servo::PointerInput> m_simulatedInput;
    haptics::PointerDevice m_pointer;
    haptics::GuidedFalcon m_simulatedFalcon;
    haptics::DeviceSwitch m_bur;
    haptics::ServoLoop m_servo;
    core::session::SessionLoop m_session;
    core::session::LiveAssessmentLoop m_assessment;

    // What the controllers share.
    SchoolSession m_school;
    LatestRequest m_loads;
    CurrentAttempt m_attempt;
    std::unique_ptr<ui::window::MainWindow> m_window;
    SessionThreads m_threads;

    // The controllers: each knows those above it.
    PresetController m_presets;
    std::unique_ptr<DeviceController> m_devices;
    std::unique_ptr<HeadTrackingController> m_headTracking;
    std::unique_ptr<PedalController> m_pedals;
    std::unique_ptr<SoundController> m_sound;
    AttemptLimit m_limit;
    LessonsController m_lessons;
    AttemptContext m_context;  ///< the parts that the controllers below share
    AttemptController m_attempts;
    SimulatedHand m_simulatedHand;
    ResumeController m_resume;
    AttemptObserver m_observer;
    OpenedScoreController m_opened;
    GradingController m_grading;
    PlaybackController m_playback;
    SchoolController m_data;
    LoginController m_login;
    ReportController m_reports;
    std::unique_ptr<TourController> m_tour;               ///< null: nobody is shown round unasked
    std::unique_ptr<PictureWriter> m_picture;             ///< null: the program has a window to work in
    std::unique_ptr<AttemptHistoryController> m_history;  ///< null: there is no database
    std::unique_ptr<AdminController> m_admin;             ///< the same
};

}  // namespace app
