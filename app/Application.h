// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include <QObject>
#include <QString>
#include <QTimer>

#include "app/AdminController.h"
#include "app/AttemptHistoryController.h"
#include "app/PresetController.h"
#include "app/ReportController.h"
#include "app/ScoreAnalysis.h"
#include "app/TourController.h"
#include "app/attempt/CurrentAttempt.h"
#include "app/attempt/ResumableAttempts.h"
#include "app/devices/DeviceController.h"
#include "app/devices/HeadTrackingController.h"
#include "app/devices/PedalController.h"
#include "app/devices/SoundController.h"
#include "app/replay/ReplayController.h"
#include "app/school/AttemptUploader.h"
#include "app/school/GradedMarker.h"
#include "app/school/SchoolService.h"
#include "app/school/SchoolSession.h"
#include "app/threads/LatestRequest.h"
#include "app/threads/LoopThread.h"
#include "core/servo/ServoParameters.h"
#include "core/servo/ServoState.h"
#include "core/session/JournalLoop.h"
#include "core/session/LiveAssessmentLoop.h"
#include "core/session/SessionChannels.h"
#include "core/teeth/ToothBuilder.h"
#include "database/AttemptRecord.h"
#include "database/Person.h"
#include "haptics/DeviceSwitch.h"
#include "haptics/ServoLoop.h"
#include "haptics/pointer/PointerDevice.h"
#include "haptics/simulated/GuidedFalcon.h"
#include "haptics/simulated/IdealHand.h"
#include "lessons/Assignment.h"
#include "lessons/ClassStanding.h"
#include "ui/render/Presenter.h"
#include "ui/scoring/ScorePage.h"
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
    /// A simulated hand with a simulated Falcon does the work; the student watches.
    bool simulatedDevice = false;
    /// The force devices that this station can have.
    std::vector<DeviceRow> devices = stationDevices();
    /// The way to the audio outputs.
    ui::sound::SoundPlayer::MakePort audioPort = ui::sound::qtAudioPort;
};

using AnatomyPointer = std::shared_ptr<const core::terrain::ToothAnatomy>;

/// Builds the program behind the window and wires it: the loops and their threads, teeth, recordings, grades.
/// It holds no rule of its own: it chooses, constructs, connects, starts, stops. Ui thread.
class Application final : public QObject
{
    Q_OBJECT

public:
    /// Errors of the shipped settings only; what goes wrong later is said in the window.
    [[nodiscard]] static core::Result<std::unique_ptr<Application>> make(const WindowOptions& options);
    ~Application() override;

    void show();
    [[nodiscard]] ui::window::MainWindow& window() { return *m_window; }

    /// The error that ended the program before its window was closed; empty after a usual end.
    [[nodiscard]] const std::optional<core::Error>& endedBy() const { return m_endedBy; }

    /// Plays the attempt that was graded last, from a little before this moment.
    void showMoment(double seconds);

private:
    Application(const WindowOptions& options, std::unique_ptr<core::servo::ServoTick> tick);

    void endWith(const core::Error& error);
    void openDatabase();
    void makeStationFolder() const;
    void openSchool();
    void refuseAtDoor(const core::Error& why);
    void takeOpening(const SchoolService::Opening& opening);
    /// @param who  wants it; a guest, where there is nobody to ask
    void restore(const database::Login& who);
    void backUpToday();
    void tellIdleLimit();
    void changePassword(const QString& old, const QString& password);
    void connectDoor();
    void readOwnHash();
    void unlockAlone(const QString& password, const core::Error& why);
    void askAtDoor(const std::function<core::Result<database::Login>(const database::sql::DatabaseContext&)>& work,
                   const std::function<void(const core::Error&)>& refuse = {});
    void enter(const database::Login& who);
    void forgetWrongAlone();
    void endNewSchool();
    void leave();
    void leaveWithAnotherRole();
    void becomeGuest();
    void raisePasswordCost();
    void tellMayEdit();
    void openLesson(const lessons::Lesson& lesson);
    void showLessons();
    void askWhetherAllowed(const std::string& lessonId, const std::function<void(bool)>& decide);
    void whereAllowed(
        const std::string& lessonId, const std::function<void()>& go, const std::function<void()>& refuse = [] {});
    void tellKnownAttempts(const lessons::Lesson& lesson);
    void openTooth(const core::teeth::ToothSource& source, const std::optional<core::mesh::LengthUnit>& unit = {},
                   const std::optional<core::settings::FeelPreset>& tried = {});
    void connectPresets();
    void feel(const core::settings::FeelPreset& preset);
    /// Nobody has begun to work on what lies on the table.
    [[nodiscard]] bool isUntouched() const;
    void beginAsItFeels();
    void feelByHand(const core::settings::FeelPreset& preset);
    void tellNumbers();
    void refuse(const core::Error& error, ui::text::FailedOperation failed, const QString& file);
    void takeTooth(const core::teeth::BuiltTooth& built);
    void begin(const lessons::Assignment& assignment, const std::function<QStringList()>& notes, bool unitInDoubt);
    [[nodiscard]] std::function<void(const AnatomyPointer&)> surfaceWorker() const;
    void lay(const lessons::Assignment& assignment, const core::servo::ServoSettings& settings,
             const std::function<QStringList()>& notes, bool unitInDoubt);
    void watchAttempt();
    void noteExam(const core::session::Findings& findings);
    void tellExam(const database::Login& who, const database::ExamStart& start);
    [[nodiscard]] bool isHiddenByExam();
    void holdHand(bool wanted);
    void takeBack(std::uint64_t tick);
    void grade();
    void settle(int looks, int settled);
    void gradeNow();
    void finish(const std::optional<ui::scoring::ScorePrediction>& expected);
    [[nodiscard]] database::AttemptRecord recordOf(const core::session::AttemptSnapshot& done,
                                                   const lessons::ScoreSheet& sheet,
                                                   const std::optional<ui::scoring::ScorePrediction>& expected) const;
    void connectExplainer(ScoreAnalysis& explainer);
    void showGrade();
    void keepGrade();
    void keepExam();
    void showExamsScore(const std::string& uid);
    void noteGraded();
    void takeKept(const PendingAttempt& letter, bool isAgain);
    void takeRefused(const PendingAttempt& letter, bool isAgain, const core::Error& why);
    void takeAnswer(const PendingAttempt& letter, ui::scoring::ScorePage::Keeping keeping);
    [[nodiscard]] bool isAsGraded() const;
    void endJournal(const PendingAttempt& letter);
    void keepGuestsGrade();
    void tellKeeping();
    void tellHistory();
    [[nodiscard]] std::optional<ReportController::Subject> shownCard() const;
    void showAttempt(const database::AttemptRecord& attempt, const core::recording::Recording& recording);
    void showSheet(const database::AttemptRecord& attempt, const lessons::ScoreSheet& sheet,
                   const std::function<QString()>& work);
    [[nodiscard]] bool isOldShown() const;
    void openBeside(const QString& path);
    void putBeside(const core::recording::Recording& recording, const QString& name, const QString& path);
    void openExpert();
    void unpack(const QString& pack, const QString& name);
    void openExpertAt(const lessons::Assignment& assignment);
    void openDemonstration(const lessons::Assignment& assignment);
    void showExpert(const core::recording::Recording& recording, const QString& name, const QString& path);
    using UseRecording = std::function<void(const core::recording::Recording&)>;
    using ReadRecording = std::function<core::Result<core::recording::Recording>()>;
    void readRecording(const QString& path, const UseRecording& use);
    /// @param read  from another thread
    void readRecording(const QString& path, const UseRecording& use, const ReadRecording& read);
    void saveRecording(const QString& path);
    void saveReference(const QString& path);
    void openRecording(const QString& path);
    void keepJournal();
    void stopJournal(bool putAway);
    void clearTable();
    void watchJournal();
    void offerUnfinished();
    void lookForUnfinished(const KnownAttempts& known);
    void gradeTakenUp(int looks);
    void tellUnfinished();
    void resumeUnfinished();
    void rebuildUnfinished(int load);
    void takeUp(std::unique_ptr<core::session::ResumableAttempt> attempt);
    void discardUnfinished();
    /// @param momentS  plays from a little before this moment; empty: from the beginning
    /// @returns false if it cannot be played; the window then shows why
    bool play(const core::recording::Recording& recording, std::optional<double> momentS = {},
              const QString& whose = {});
    void playOpened(std::optional<double> momentS);
    void putReplayAway();
    void stopReplay();
    void drawPicture();
    void letHandDecide();
    void followHand();
    void beginForAnotherHand();
    void startLoops();
    void stopLoops();

    WindowOptions m_options;
    core::teeth::ToothSource m_source;                               ///< of the tooth taken last
    std::shared_ptr<const core::terrain::ToothAnatomy> m_practised;  ///< that was practised on last without a lesson
    std::optional<core::Error> m_endedBy;
    core::session::UiChannels m_links;
    core::servo::ServoChannels m_servoLinks;
    core::rt::TripleBuffer<core::servo::PointerInput> m_demoWish;  ///< of m_demoHand
    std::optional<haptics::IdealHand> m_demoHand;
    std::uint8_t m_demoBur = 0;  ///< that it holds
    haptics::PointerDevice m_pointer;
    haptics::GuidedFalcon m_simulatedHand;
    haptics::DeviceSwitch m_bur;
    haptics::ServoLoop m_servo;
    core::session::SessionLoop m_session;
    core::session::LiveAssessmentLoop m_follower;
    std::unique_ptr<ui::window::MainWindow> m_window;
    std::unique_ptr<DeviceController> m_devices;
    std::unique_ptr<HeadTrackingController> m_headTracking;
    std::unique_ptr<PedalController> m_pedals;
    std::unique_ptr<SoundController> m_sound;
    std::unique_ptr<SchoolService> m_service;  ///< null: nothing is saved
    SchoolSession m_school;
    std::unique_ptr<AttemptUploader> m_letters;          ///< null where m_service is
    std::unique_ptr<AttemptHistoryController> m_people;  ///< the same
    std::unique_ptr<AdminController> m_admin;            ///< the same
    std::optional<database::Address> m_address;
    std::shared_ptr<std::atomic<bool>> m_backupIsStopped = std::make_shared<std::atomic<bool>>(false);
    std::unique_ptr<ReportController> m_cards;
    std::unique_ptr<TourController> m_tour;  ///< null: nobody is shown round unasked
    QString m_stationFolder;                 ///< of this computer's own files: journals, outbox, key
    core::Error m_whyNoDesk;
    QString m_where;             ///< the database, to read
    QString m_backup;            ///< that can be put in the place of the database; empty: none
    QTimer m_openWatch;          ///< tries again what a server or another program has held up
    QTimer m_backupWatch{this};  ///< a window may stay open for weeks
    bool m_isBackingUp = false;  ///< today's backup, which a slow disk may take long for
    int m_doorTurn = 0;          ///< grows when nobody waits for an answer at the door any more
    bool m_isOnNetworkDrive = false;
    std::string m_ownHash;  ///< of the password of who works here: unlocks his place where the database is away
    int m_wrongAlone = 0;   ///< so many passwords in a row did not fit that
    std::chrono::steady_clock::time_point m_nextAlone;
    bool m_hasTimedCost = false;
    bool m_keepsOnLogin = false;  ///< the grade that a guest was shown becomes that of who logs in now

    PresetController m_presets;
    std::optional<core::settings::FeelPreset> m_tried;   ///< in place of it, on the block that lies on the table
    core::settings::ToothKind m_triedKind;               ///< what that block is made of
    std::optional<core::settings::FeelPreset> m_byHand;  ///< in place of m_presets.inUse(), but in exams
    core::servo::ServoParameters m_numbers{};            ///< that the servo is to have
    core::servo::ServoParameters m_numbersTold{};        ///< that it has, or has been sent
    std::function<QStringList()> m_notes;                ///< on its scan
    bool m_isUnitInDoubt = false;                        ///< of that
    std::uint64_t m_generation = 0;                      ///< of the newest tooth shown
    int m_pictureLooks = 0;
    LatestRequest m_loads;
    CurrentAttempt m_attempt;
    /// The grade given last: the same work is not graded twice.
    struct Graded
    {
        std::uint64_t generation = 0;
        std::uint64_t hash = 0;
        lessons::ScoreSheet sheet;
        database::AttemptRecord record;
        ui::scoring::ScorePage::Keeping keeping{};
        QList<database::AttemptRecord> history;
        lessons::ClassStanding standing;
        std::optional<ui::scoring::ScorePrediction> expected;
        ui::scoring::ScoredWork work;
        core::recording::Recording recording;
        std::optional<core::grading::Practised> practised;  ///< of an exercise, which leaves no mark on the tooth
        bool isOverLimit = false;  ///< a guest's, who has logged in for it and had no attempt left
    };
    struct LessonsRead
    {
        std::map<std::string, ui::catalog::Standing> standings;
        std::map<std::string, ui::catalog::Given> given;
        std::vector<database::Feedback> feedback;
    };
    LessonsRead m_lessonsRead;  ///< of who works here, as the database said last
    std::optional<Graded> m_graded;
    std::string m_scoreToShow;                           ///< uid of the exam whose score is shown when it is kept
    std::optional<core::recording::Recording> m_opened;  ///< of the score card that is shown, where it is an old one
    /// Where the attempt that is played was asked for; the way back leads there.
    enum class PlayedFrom : std::uint8_t { Elsewhere, ScoreCard, Attempts };
    PlayedFrom m_playedFrom = PlayedFrom::Elsewhere;
    ScoreAnalysis m_explainer;        ///< of m_graded
    ScoreAnalysis m_openedExplainer;  ///< of m_opened
    QTimer m_journalWatch;
    QTimer m_lookAgain;  ///< for unfinished attempts of which the school could not say whether they are kept
    std::unique_ptr<core::session::JournalLoop> m_journal;      ///< null: nothing is kept
    std::optional<core::recording::FoundAttempt> m_unfinished;  ///< the one that is offered
    /// It is an exam whose score was seen, and is kept nowhere.
    std::optional<GradedMarker> m_seenOfUnfinished;
    QTimer m_attemptWatch;
    std::map<ui::render::Stereo, int> m_cutIn;  ///< looks at the attempt that found it being cut, by what it is seen in
    std::map<QString, int> m_cutWith;           ///< the same, by the hand that moves the bur
    QTimer m_demoBeat;
    std::unique_ptr<ReplayController> m_replay;
    std::shared_ptr<const core::terrain::ToothAnatomy> m_replayed;
    core::servo::ServoState m_handAtRest;  ///< the student's servo as it was when a replay began

    // Threads last: they are joined before what they run on goes away.
    std::unique_ptr<LoopThread> m_servoThread;
    std::unique_ptr<LoopThread> m_sessionThread;
    std::unique_ptr<LoopThread> m_followerThread;
    std::unique_ptr<LoopThread> m_journalThread;
    std::unique_ptr<LoopThread> m_syncThread;
};

}  // namespace app
