// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Application.h"
#include "core/history/MomentId.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"

#include <algorithm>
#include <array>
#include <set>

#include <QCoreApplication>
#include <QDateTime>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QStandardPaths>
#include <QThreadPool>
#include <QUrl>

#include "app/attempt/Demonstration.h"
#include "app/devices/PenSetup.h"
#include "app/school/DailyBackup.h"
#include "app/school/SchoolSettings.h"
#include "app/threads/Background.h"
#include "core/grading/Measures.h"
#include "core/guidance/Fixture.h"
#include "core/preparation/CapturedIdeal.h"
#include "core/recording/Replay.h"
#include "core/settings/StabilityBound.h"
#include "database/Outbox.h"
#include "database/Passwords.h"
#include "database/sql/Attempts.h"
#include "database/sql/Backups.h"
#include "database/sql/Classes.h"
#include "database/sql/Feedback.h"
#include "database/sql/Logins.h"
#include "haptics/falcon/FalconFeel.h"
#include "lessons/Assignment.h"
#include "lessons/LessonCatalog.h"
#include "lessons/LessonPack.h"
#include "lessons/LessonReader.h"
#include "lessons/ScoreSheetJson.h"
#include "ui/admin/AdminPage.h"
#include "ui/devices/DevicesPage.h"
#include "ui/kit/AppSettings.h"
#include "ui/render/WholeSurface.h"
#include "ui/scoring/ScorePage.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/ValidationTexts.h"
#include "ui/tooth/ToothView.h"
#include "ui/tooth/Viewpoint.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using core::session::UiChannels;
using database::sql::DatabaseContext;
using database::sql::Logins;
using ui::text::FailedOperation;
using Keeping = ui::scoring::ScorePage::Keeping;

constexpr std::chrono::microseconds kServoPeriod = 1ms;
constexpr std::chrono::microseconds kSessionPeriod = 10ms;
constexpr int kHistoryLength = 12;
constexpr int kMostKnownAttempts = 200;
constexpr double kMnPerN = 1000.0;
constexpr double kMsPerS = 1000.0;
constexpr int kSpareTooth = 36;  ///< FDI number
constexpr int kAttemptWatchMs = 50;
constexpr int kJournalWatchMs = 500;
constexpr int kBackupWatchMs = 3'600'000;
constexpr int kSettleMs = 20;
constexpr int kMostTakeUpLooks = 250;
constexpr std::size_t kCommandsOfATooth = 16;  ///< another tooth comes with its bur, its aids and more
constexpr int kSettledLooks = 3;               ///< in a row that find the bur out of the tooth
constexpr int kMostSettleLooks = 25;
constexpr int kLongestLookMs = 1500;   ///< for what a page shows of the school
constexpr int kLongestCheckMs = 6000;  ///< for whether an attempt is left: a busy computer answers late
constexpr int kDemoBeatMs = 16;
constexpr int kPictureDelayMs = 200;  ///< between two looks whether the picture is ready
constexpr int kPictureFrames = 5;     ///< looks until all that was cut has been drawn

QString dataFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
}

/// Each person's attempts that were not finished lie in a folder of their own: nobody takes up another's.
std::filesystem::path journalFolder(const QString& stationFolder, const database::Login& who)
{
    const QString name =
        who.isGuest() ? QStringLiteral("unfinished") : "unfinished/" + QString::fromStdString(who.uid());
    return std::filesystem::path(QDir(stationFolder).filePath(name).toStdU16String());
}

/// In the language of the moment.
std::function<QStringList()> notesOf(const core::teeth::ToothReport& report)
{
    return [report] { return ui::text::scanNotes(report); };
}

/// What the attempt of a recording was made for. The file of an expert's attempt lies beside the lesson of today.
core::Result<lessons::Assignment> playedFor(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy,
                                            const std::string& lessonJson)
{
    auto assignment = lessons::assignmentOf(anatomy, lessonJson);
    if (assignment && assignment->lesson && assignment->lesson->expert)
        for (const lessons::CatalogEntry& entry : lessons::readCatalog(lessons::teachersFolder()))
            if (!entry.isFaulty() && entry.read.lesson->id == assignment->lesson->id && entry.read.lesson->expert)
                assignment->lesson->expert = entry.read.lesson->expert;
    return assignment;
}

/// Something is the matter with the school's file itself.
bool isOfTheFile(core::ErrorCode code)
{
    using core::ErrorCode;
    return code == ErrorCode::FileMissing || code == ErrorCode::FileUnreadable || code == ErrorCode::FileUnwritable ||
           code == ErrorCode::BadStructure || code == ErrorCode::WrongKind;
}

/// The database was not asked at all: it says nothing of who may come in.
bool isAway(core::ErrorCode code)
{
    using core::ErrorCode;
    return code == ErrorCode::ConnectionLost || code == ErrorCode::ServerRefuses || code == ErrorCode::Busy ||
           code == ErrorCode::OpenElsewhere || isOfTheFile(code);
}

/// What had been expected of an old attempt; what was to cost most is not kept.
std::optional<ui::scoring::ScorePrediction> expectationOf(const database::AttemptRecord& attempt)
{
    if (!attempt.expectedTenths)
        return std::nullopt;
    return ui::scoring::ScorePrediction{*attempt.expectedTenths, {}};
}

constexpr double kStiffnessNPerMm = core::contact::ForceSettings{}.stiffnessNPerMm;
constexpr double kServoPeriodS = std::chrono::duration<double>(kServoPeriod).count();

/// @param hasForce  the hand that moves the bur feels a force
/// @param scale     how far it moves for one millimetre of the bur
core::servo::ServoSettings settingsFor(bool hasForce, double scale = 1.0)
{
    core::servo::ServoSettings settings;
    if (hasForce)
        haptics::falcon::addFalconFeel(settings.force, scale);
    return settings;
}

}  // namespace

core::Result<std::unique_ptr<Application>> Application::make(const WindowOptions& options)
{
    auto tick = core::servo::makeServoTick(settingsFor(options.simulatedDevice));
    if (!tick)
        return tl::unexpected(tick.error());
    return std::unique_ptr<Application>(new Application(options, std::move(*tick)));
}

Application::Application(const WindowOptions& options, std::unique_ptr<core::servo::ServoTick> tick)
    : m_options(options), m_pointer(m_links.pointer, kStiffnessNPerMm, kServoPeriodS),
      m_simulatedHand(m_demoWish, kStiffnessNPerMm, kServoPeriodS),
      m_bur(options.simulatedDevice ? static_cast<haptics::HapticDevice&>(m_simulatedHand) : m_pointer, kServoPeriod),
      m_servo(m_bur, std::move(tick), m_servoLinks, m_links.servo, kServoPeriod),
      m_session(m_servoLinks, m_links, settingsFor(options.simulatedDevice)), m_follower(m_session),
      m_window(std::make_unique<ui::window::MainWindow>(m_links)),
      m_presets(*m_window, [this] { return m_school.user; })
{
    using ui::window::MainWindow;
    connect(m_window.get(), &MainWindow::toothChosen, this, [this](int fdi) { openTooth({fdi}); });
    connect(m_window.get(), &MainWindow::lessonChosen, this, &Application::openLesson);
    connect(m_window.get(), &MainWindow::lessonsRequested, this, &Application::showLessons);
    connect(m_window.get(), &MainWindow::knownAttemptsRequested, this, &Application::tellKnownAttempts);
    connect(m_window.get(), &MainWindow::unpackRequested, this, &Application::unpack);
    connect(m_window.get(), &MainWindow::lessonFolderRequested, this, [this] {
        const QString folder = lessons::teachersFolder();
        QDir().mkpath(folder);
        if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
            m_window->showMessage(tr("No program answers here that shows folders. Your own lessons are in %1.")
                                      .arg(QDir::toNativeSeparators(folder)));
    });
    connectPresets();
    connect(m_window.get(), &MainWindow::forecastGiven, this,
            [this](const ui::scoring::ScorePrediction& expected) { finish(expected); });
    connect(m_window.get(), &MainWindow::scanChosen, this,
            [this](const QString& path) { openTooth({std::filesystem::path(path.toStdU16String())}); });
    connect(m_window.get(), &MainWindow::scanUnitChosen, this, [this](const QString& unit) {
        if (const auto known = core::mesh::parseUnit(unit.toStdString()))
            openTooth(m_source, *known);
    });
    connect(m_window.get(), &MainWindow::gradeRequested, this, &Application::grade);
    connect(m_window.get(), &MainWindow::recordingSaveRequested, this, &Application::saveRecording);
    connect(m_window.get(), &MainWindow::referenceSaveRequested, this, &Application::saveReference);
    connect(m_window.get(), &MainWindow::recordingOpenRequested, this, &Application::openRecording);
    connect(m_window.get(), &MainWindow::besideRequested, this, &Application::openBeside);
    connect(m_window.get(), &MainWindow::expertRequested, this, &Application::openExpert);
    connect(m_window.get(), &MainWindow::resumeRequested, this, &Application::resumeUnfinished);
    connect(m_window.get(), &MainWindow::discardRequested, this, &Application::discardUnfinished);
    connect(m_window.get(), &MainWindow::replayStopRequested, this, &Application::stopReplay);
    m_window->setHistorySource({[this] { return m_session.historySoFar(); },
                                [this](core::history::MomentId id) { return m_session.momentHeights(id); }});
    connect(m_window.get(), &MainWindow::takeBackRequested, this, &Application::takeBack);
    connect(m_window.get(), &MainWindow::attemptAgainRequested, this, [this] {
        m_loads.begin();
        m_presets.readAgain();
        const auto again = [this, load = m_loads.latest()] {
            m_presets.whenRead([this, load] {
                if (!m_loads.isLatest(load))
                    return;
                begin(lessons::Assignment(m_attempt.assignment()), {}, false);
                m_window->showBegunAnew();
            });
        };
        if (m_attempt.assignment().lesson)
            whereAllowed(m_attempt.assignment().lesson->id, again);
        else
            again();
    });
    connect(m_window.get(), &MainWindow::fixtureRequested, this, &Application::holdHand);
    connect(m_window.get(), &MainWindow::momentRequested, this, &Application::showMoment);
    ui::scoring::ScorePage& page = m_window->scorePage();
    for (ScoreAnalysis* explainer : {&m_explainer, &m_openedExplainer})
        connectExplainer(*explainer);
    connect(&page, &ui::scoring::ScorePage::replayRequested, this, [this] {
        if (m_opened)
            playOpened({});
    });
    if (options.showsRound)
        m_tour = std::make_unique<TourController>(*m_window);
    m_cards = std::make_unique<ReportController>(*m_window, [this] { return shownCard(); });
    connectDoor();
    m_journalWatch.setInterval(kJournalWatchMs);
    connect(&m_journalWatch, &QTimer::timeout, this, &Application::watchJournal);
    m_lookAgain.setInterval(m_options.retry);
    m_lookAgain.setSingleShot(true);
    connect(&m_lookAgain, &QTimer::timeout, this, [this] {
        if (!m_unfinished)
            offerUnfinished();
    });
    m_attemptWatch.setInterval(kAttemptWatchMs);
    connect(&m_attemptWatch, &QTimer::timeout, this, &Application::watchAttempt);
    m_attemptWatch.start();

    m_demoBeat.setInterval(kDemoBeatMs);
    connect(&m_demoBeat, &QTimer::timeout, this, &Application::letHandDecide);
    m_devices =
        std::make_unique<DeviceController>(*m_window, DeviceController::Hands{m_bur, m_pointer, m_simulatedHand},
                                           options.devices, options.simulatedDevice);
    connect(m_devices.get(), &DeviceController::inUseChanged, this, &Application::followHand);
    connect(m_devices.get(), &DeviceController::simulatedChanged, this, &Application::beginForAnotherHand);
    followHand();
    m_headTracking = std::make_unique<HeadTrackingController>(*m_window);
    connectPen(*m_window);
    m_pedals = std::make_unique<PedalController>(*m_window, m_bur, [this] { return m_devices->isSimulated(); });
    m_sound = std::make_unique<SoundController>(*m_window, m_links.sound, options.audioPort);
    static_cast<void>(m_links.commands.tryPush(core::servo::SetBur{1}));
    static_cast<void>(m_links.commands.tryPush(core::servo::SetDrill{true}));
    m_servo.publishSound(m_links.sound);
    startLoops();
}

Application::~Application()
{
    *m_backupIsStopped = true;
    m_admin.reset();
    // A load still under way would come back to nobody.
    QThreadPool::globalInstance()->waitForDone();
    stopLoops();
    m_replay.reset();
    m_sound.reset();
    m_pedals.reset();
    m_headTracking.reset();
    m_devices.reset();
    // The window has asked about the work on the table before it let itself be closed.
    stopJournal(true);
    m_tour.reset();
    m_people.reset();
    m_letters.reset();
    m_school.service = nullptr;
    m_service.reset();
}

void Application::show()
{
    m_window->show();
    if (m_options.picture.isEmpty()) {
        openDatabase();
        if (!m_options.asksWho)
            keepJournal();
    } else
        QTimer::singleShot(kPictureDelayMs, this, &Application::drawPicture);
    if (m_options.recording.isEmpty())
        openTooth(m_options.source);
    else
        openRecording(m_options.recording);
}

void Application::startLoops()
{
    if (m_servoThread)
        return;
    m_servoThread = std::make_unique<LoopThread>(m_servo, kServoPeriod, LoopThread::Urgency::RealTime);
    m_sessionThread = std::make_unique<LoopThread>(m_session, kSessionPeriod, LoopThread::Urgency::Normal);
    m_servoThread->start(QThread::TimeCriticalPriority);
    m_sessionThread->start();
    m_followerThread = std::make_unique<LoopThread>(m_follower, core::session::LiveAssessmentLoop::kPeriod,
                                                    LoopThread::Urgency::Normal);
    m_followerThread->start();
}

void Application::stopLoops()
{
    m_followerThread.reset();
    m_servoThread.reset();
    m_sessionThread.reset();
    m_links.sound.publish({});  // the handpiece runs down
}

/// Without a database the student can still drill and be graded; only nothing is kept.
void Application::openDatabase()
{
    const QString where =
        m_options.database.isEmpty() ? QDir(dataFolder()).filePath(QStringLiteral("cusp.sqlite")) : m_options.database;
    const auto address = database::Address::parse(where);
    if (!address) {
        m_whyNoDesk = address.error();
        m_window->showError(m_whyNoDesk, FailedOperation::KeepingGrades, where);
        return;
    }
    m_where = address->isServer() ? address->shown() : QDir::toNativeSeparators(address->file);
    m_stationFolder = address->isServer() ? dataFolder() : QFileInfo(address->file).absolutePath();
    m_address = *address;
    makeStationFolder();
    m_window->setRecoveryFolder(m_stationFolder);
    m_service = std::make_unique<SchoolService>(*address, m_stationFolder, m_options.opening, m_options.retry);
    m_school.service = m_service.get();
    m_letters = std::make_unique<AttemptUploader>(*m_service);
    connect(m_letters.get(), &AttemptUploader::kept, this, &Application::takeKept);
    connect(m_letters.get(), &AttemptUploader::refused, this, &Application::takeRefused);
    connect(m_school.service, &SchoolService::delivered, this, [this](const QString& uid) {
        if (m_graded && m_graded->record.uid == uid.toStdString()) {
            m_graded->keeping = Keeping::Kept;
            tellHistory();
        }
        m_window->readAttemptsAgain();
    });
    connect(m_school.service, &SchoolService::damaged, this,
            [this](const core::Error& error) { m_window->showError(error, FailedOperation::SendingAttempt); });
    connect(m_school.service, &SchoolService::unanswered, m_window.get(), &ui::window::MainWindow::showUnanswered);
    connect(m_school.service, &SchoolService::answered, m_window.get(), &ui::window::MainWindow::forgetUnanswered);
    connect(m_school.service, &SchoolService::isBack, this, [this] {
        if (m_school.user.isGuest())
            return;
        m_presets.refresh();
        m_window->readAgain();
    });
    connect(m_school.service, &SchoolService::waitOn, this, [this](int count) {
        m_window->showMessage(tr("%n attempt(s) on this computer cannot be sent to this school: the student is "
                                 "unknown, or another station.key signed them. They stay on this computer.",
                                 nullptr, count));
    });
    connect(m_school.service, &SchoolService::waitForOthers, this, [this](int count, const QString& schools) {
        m_window->showMessage(
            //: %1: a file's name, or the address of a server
            tr("%n attempt(s) on this computer wait for another school: %1. If that is this one under an "
               "earlier name, \"cusp db send\" brings them here.",
               nullptr, count)
                .arg(schools));
    });
    connect(m_school.service, &SchoolService::disabled, this, [this] {
        if (m_school.user.isGuest())  // has been shown out already
            return;
        leave();
        m_window->sayAtDoor([] { return tr("This account was disabled, and you were logged out. Ask an admin."); });
    });
    connect(m_school.service, &SchoolService::refused, this, &Application::leaveWithAnotherRole);
    connect(m_school.service, &SchoolService::otherSchool, this, [this] {
        const bool wasIn = !m_school.user.isGuest();
        if (wasIn)
            leave();
        m_school.service->takeOtherSchool();
        openSchool();
        if (wasIn)
            m_window->sayAtDoor(
                [] { return tr("Another school is now where yours was, and you were logged out. Log in again."); });
    });
    m_admin = std::make_unique<AdminController>(
        *m_window, *m_school.service,
        AdminController::Place{*address, m_stationFolder,
                               [this] { return m_window->devicesPage().handName(m_devices->hand()); },
                               1.0 / std::chrono::duration<double>(kServoPeriod).count()},
        [this] { return m_school.user; });
    connect(m_admin.get(), &AdminController::restoreRequested, this, [this](const QString& backup) {
        const database::Login who = m_school.user;
        leave();
        m_backup = backup;
        restore(who);
    });
    connect(m_admin.get(), &AdminController::idleMinutesChanged, this,
            [this](int minutes) { m_window->setIdleLimit(std::chrono::minutes(minutes)); });
    m_people =
        std::make_unique<AttemptHistoryController>(*m_window, *m_school.service, [this] { return m_school.user; });
    connect(m_people.get(), &AttemptHistoryController::replayRequested, this,
            [this](const core::recording::Recording& recording, const database::AttemptRecord& attempt,
                   const QString& whose) {
                if (isHiddenByExam())
                    return;
                const int load = m_loads.begin();
                inBackground(
                    this,
                    [anatomy = recording.anatomy(), workOut = surfaceWorker()] {
                        workOut(anatomy);
                        return anatomy;
                    },
                    [this, load, recording, attempt, whose](const auto&) {
                        if (!m_loads.isLatest(load) || !play(recording, {}, whose))
                            return;
                        m_playedFrom = PlayedFrom::Attempts;
                        m_people->followReplay(attempt);
                    });
            });
    connect(
        m_people.get(), &AttemptHistoryController::besideRequested, this,
        [this](const core::recording::Recording& recording, const QString& name) { putBeside(recording, name, {}); });
    connect(m_people.get(), &AttemptHistoryController::scoreRequested, this, &Application::showAttempt);
    connect(m_people.get(), &AttemptHistoryController::sheetRequested, this, &Application::showSheet);
    m_backupWatch.setObjectName(QStringLiteral("backupWatch"));
    m_backupWatch.setInterval(kBackupWatchMs);
    connect(&m_backupWatch, &QTimer::timeout, this, &Application::backUpToday);
    m_openWatch.setInterval(m_options.retry);
    connect(&m_openWatch, &QTimer::timeout, this, &Application::openSchool);
    connect(m_window.get(), &ui::window::MainWindow::openAgainRequested, this, &Application::openSchool);
    connect(m_window.get(), &ui::window::MainWindow::restoreRequested, this, [this] { restore(m_school.user); });
    tellMayEdit();  // nobody is known yet
    openSchool();
    if (m_options.asksWho)
        m_window->askLogin();
}

/// Whoever names a file has its folder.
void Application::makeStationFolder() const
{
    if (m_options.database.isEmpty() || m_address->isServer())
        QDir().mkpath(m_stationFolder);
}

void Application::openSchool()
{
    makeStationFolder();  // the disk may be writable by now
    m_window->setOpening(true);
    m_school.service->open(this, [this](const SchoolService::Opening& opening) { takeOpening(opening); });
}

/// Where the file is not what it was, the door tells what there is to go back to.
void Application::refuseAtDoor(const core::Error& why)
{
    if (!m_school.service || m_address->isServer() || !isOfTheFile(why.code)) {
        m_window->refuseLogin(why);
        return;
    }
    m_school.service->open(this, [this, why](const SchoolService::Opening& opening) {
        if (opening.status)
            m_window->refuseLogin(why);
        else
            takeOpening(opening);
    });
}

void Application::takeOpening(const SchoolService::Opening& opening)
{
    m_window->setOpening(false);
    m_backup = opening.soundBackup;
    const QDateTime backupMade = database::sql::madeAt(m_backup);
    if (!opening.status) {
        const core::Error& error = opening.status.error();
        m_window->setUnreachable(error, m_where, backupMade);
        if (!m_options.asksWho && !m_openWatch.isActive())
            m_window->showError(error, FailedOperation::KeepingGrades, m_options.database);
        // A server may come back; a file that cannot be used does not by itself.
        if (error.code == core::ErrorCode::ConnectionLost || error.code == core::ErrorCode::ServerRefuses ||
            error.code == core::ErrorCode::Busy || error.code == core::ErrorCode::OpenElsewhere)
            m_openWatch.start();
        return;
    }
    m_openWatch.stop();
    m_presets.setSchool(m_school.service);
    m_window->setUnreachable({}, m_where, backupMade);
    m_isOnNetworkDrive = !opening.notice.empty();
    const bool wasNew = m_window->isNewSchool();
    m_window->setNewSchool(opening.isNew);
    backUpToday();
    m_backupWatch.start();
    tellMayEdit();
    if (m_window->isAtDoor() && wasNew != opening.isNew)
        m_window->askLogin();
}

void Application::restore(const database::Login& who)
{
    m_school.service->restore(this, who, m_backup, [this](const SchoolService::Opening& opening) {
        const QDateTime made = database::sql::madeAt(m_backup).toLocalTime();
        takeOpening(opening);
        m_window->sayAtDoor([made, restored = opening.restored, isOpen = opening.status.has_value(),
                             replaced = QFileInfo(opening.replaced).fileName()] {
            if (!restored)
                return (isOpen ? tr("The backup was not restored; nothing has been changed. %1")
                               : tr("The backup was not restored. %1"))
                    .arg(AdminController::whyNotRestored(restored.error()));
            const QString when = QLocale().toString(made, QLocale::ShortFormat);
            //: %2: a file's name
            return replaced.isEmpty() ? tr("The backup of %1 was restored.").arg(when)
                                      : tr("The backup of %1 was restored. The previous file is kept next to it as %2.")
                                            .arg(when, replaced);
        });
    });
}

/// Once a day, beside everything else. What comes in the way comes again in an hour, and stands on the admin's page.
void Application::backUpToday()
{
    const QDateTime now = QDateTime::currentDateTimeUtc();
    if (m_isBackingUp || m_window->isNewSchool() || !isBackupDue(*m_address, now))
        return;
    m_isBackingUp = true;
    m_school.service->askBeside(
        this,
        [address = *m_address, folder = m_stationFolder, now,
         isStopped = m_backupIsStopped](const DatabaseContext& school) {
            return makeBackup(school, address, folder, now, [isStopped] { return !*isStopped; });
        },
        [this](const core::Result<QString>& made) {
            m_isBackingUp = false;
            if (!made && m_school.user.role() == database::Role::Admin)
                m_window->showMessage(tr("Today's backup was not made. %1")
                                          .arg(ui::text::errorText(made.error(), FailedOperation::ReadingSchool)));
        });
}

/// As the school has set it.
void Application::tellIdleLimit()
{
    m_school.service->ask(
        this, [who = m_school.user](const DatabaseContext& school) { return database::sql::readSettings(school, who); },
        [this](const core::Result<database::sql::SettingsMap>& settings) {
            if (settings)
                m_window->setIdleLimit(std::chrono::minutes(idleMinutesOf(*settings)));
        });
}

void Application::changePassword(const QString& old, const QString& password)
{
    m_school.service->ask(
        this,
        [who = m_school.user, old = old.toStdString(),
         next = password.toStdString()](const DatabaseContext& school) -> core::Result<bool> {
            if (auto done = Logins::changePassword(school, who, old, next); !done)
                return tl::unexpected(done.error());
            return true;
        },
        [this](const core::Result<bool>& done) {
            if (!done) {
                m_window->refuseLogin(done.error());
                return;
            }
            readOwnHash();
            m_window->setWho(m_school.user);
            m_window->showMessage(tr("Your password was changed."));
        });
}

void Application::connectDoor()
{
    using ui::window::MainWindow;
    connect(m_window.get(), &MainWindow::loginRequested, this, [this](const QString& name, const QString& password) {
        askAtDoor([name = name.toStdString(), password = password.toStdString()](
                      const DatabaseContext& school) { return Logins::login(school, name, password); },
                  [this, isOwner = name.toStdString() == m_school.user.username(), password](const core::Error& why) {
                      if (isOwner && isAway(why.code))
                          unlockAlone(password, why);
                      else
                          refuseAtDoor(why);
                  });
    });
    connect(m_window.get(), &MainWindow::codeRequested, this,
            [this](const QString& name, const QString& code, const QString& password) {
                askAtDoor([name = name.toStdString(), code = code.toStdString(), password = password.toStdString()](
                              const DatabaseContext& school) { return Logins::redeem(school, name, code, password); });
            });
    connect(m_window.get(), &MainWindow::schoolRequested, this,
            [this](const database::NewPerson& admin, const QString& password) {
                askAtDoor(
                    [admin, password = password.toStdString()](const DatabaseContext& school) {
                        return Logins::createFirstAdmin(school, admin, password, database::timedCost());
                    },
                    [this](const core::Error& why) {
                        if (why.code == core::ErrorCode::NotAllowed) {  // somebody was faster
                            endNewSchool();
                            tellMayEdit();
                            m_window->askLogin();
                        }
                        m_window->refuseLogin(why);
                    });
            });
    connect(m_window.get(), &MainWindow::guestRequested, this, &Application::becomeGuest);
    connect(m_window.get(), &MainWindow::logoutRequested, this, &Application::leave);
    connect(m_window.get(), &MainWindow::passwordChangeRequested, this, &Application::changePassword);
    connect(m_window.get(), &MainWindow::keepRequested, this, [this] {
        m_keepsOnLogin = true;
        m_window->askLoginToKeep();
    });
}

/// Lets in who has given the right answer; where there is no database to ask, says why. Who has gone from the door
/// meanwhile is not let in: by then somebody else may sit there.
/// @param refuse  does the latter; empty: at the door
void Application::askAtDoor(const std::function<core::Result<database::Login>(const DatabaseContext&)>& work,
                            const std::function<void(const core::Error&)>& refuse)
{
    const auto answer = [this, refuse, turn = ++m_doorTurn](const core::Result<database::Login>& who) {
        if (turn != m_doorTurn || !m_window->isAtDoor()) {
            if (who && m_window->isNewSchool())
                endNewSchool();
            return;
        }
        ++m_doorTurn;
        if (who)
            enter(*who);
        else if (refuse)
            refuse(who.error());
        else
            refuseAtDoor(who.error());
    };
    if (!m_school.service) {
        answer(tl::unexpected(m_whyNoDesk));
        return;
    }
    m_school.service->ask(this, work, answer);
    // A server that hangs says nothing at all. A file answers sooner or later: it may be large, and its disk have much
    // to do. But who has work behind the door is let to it without.
    if (m_address->isServer() || !m_school.user.isGuest())
        QTimer::singleShot(m_options.loginPatience, this, [answer, isServer = m_address->isServer()] {
            answer(core::unexpected(isServer ? core::ErrorCode::ConnectionLost : core::ErrorCode::Busy,
                                    "there was no answer"));
        });
}

void Application::readOwnHash()
{
    m_school.service->ask(
        this, [who = m_school.user](const DatabaseContext& school) { return Logins::ownHash(school, who); },
        [this, who = m_school.user](const core::Result<std::string>& hash) {
            if (hash && m_school.user == who)
                m_ownHash = *hash;
        });
}

/// Who left his place comes back to his work though the database is away: by the password it knew last. Who tries
/// others waits longer each time, as at the database.
/// @param why  it cannot be asked
void Application::unlockAlone(const QString& password, const core::Error& why)
{
    if (m_ownHash.empty()) {
        refuseAtDoor(why);
        return;
    }
    const auto now = std::chrono::steady_clock::now();
    if (now < m_nextAlone) {
        const auto wait = std::chrono::ceil<std::chrono::seconds>(m_nextAlone - now);
        m_window->refuseLogin({core::ErrorCode::TooSoon, "wait " + std::to_string(wait.count()) + " s"});
        return;
    }
    inBackground(
        this, [password = password.toStdString(), hash = m_ownHash] { return database::fits(password, hash); },
        [this, who = m_school.user](const core::Result<bool>& fits) {
            if (m_school.user != who)
                return;
            if (fits && *fits) {
                enter(who);
                return;
            }
            constexpr int kFreeTries = 3;
            constexpr int kMostDoublings = 10;
            if (++m_wrongAlone > kFreeTries)
                m_nextAlone = std::chrono::steady_clock::now() +
                              std::chrono::seconds(1 << std::min(m_wrongAlone - kFreeTries, kMostDoublings));
            m_window->refuseLogin(fits ? core::Error{core::ErrorCode::WrongLogin, "the password is wrong"}
                                       : fits.error());
        });
}

/// A person has logged in, or come back to the place he had locked.
void Application::enter(const database::Login& who)
{
    forgetWrongAlone();
    if (who.person() == m_school.user.person()) {
        m_window->setWho(who);
        return;
    }
    if (m_window->isNewSchool())
        endNewSchool();
    m_school.user = who;
    m_lessonsRead = {};
    m_ownHash.clear();
    readOwnHash();
    m_byHand.reset();
    m_presets.refresh();
    // What was practised without a login is nobody's, unless its grade is what he logs in for.
    const bool keeps = std::exchange(m_keepsOnLogin, false) && m_window->keepsOnLogin() && m_graded &&
                       m_graded->keeping == Keeping::Guest;
    if (!keeps && m_attempt.assignment().anatomy)
        clearTable();
    m_window->setWho(who);
    tellMayEdit();
    tellIdleLimit();
    keepJournal();
    if (keeps)
        keepGuestsGrade();
    else
        m_window->openHome();
    if (m_tour && !keeps)
        m_tour->welcome(m_school.service, m_school.user);
    if (who.role() == database::Role::Admin && m_school.service)
        raisePasswordCost();
    if (m_isOnNetworkDrive && who.role() == database::Role::Admin)
        m_window->showWarning(tr("The school's database is on a network drive, where only one computer at a time can "
                                 "use it. For several computers, use a PostgreSQL server."));
}

/// What one person has mistyped makes no other wait.
void Application::forgetWrongAlone()
{
    m_wrongAlone = 0;
    m_nextAlone = {};
}

/// Somebody has been entered. Nobody puts what was there before in the place of what has just been begun.
void Application::endNewSchool()
{
    m_window->setNewSchool(false);
    m_backup.clear();
    m_window->setUnreachable({}, m_where, {});
}

/// Computers get faster, and who guesses passwords has them first.
void Application::raisePasswordCost()
{
    if (std::exchange(m_hasTimedCost, true))
        return;
    inBackground(
        this, [] { return database::timedCost(); },
        [this](const database::PasswordCost& cost) {
            m_school.service->ask(
                this,
                [who = m_school.user, cost](const DatabaseContext& school) {
                    return database::sql::raisePasswordCost(school, who, cost);
                },
                [](const core::Status&) {});
        });
}

/// The attempt stays on the disk, in the folder of who made it, and is offered to him when he is back.
void Application::leave()
{
    if (m_school.service && !m_school.user.isGuest())
        m_school.service->ask(
            this,
            [who = m_school.user](const DatabaseContext& school) -> core::Result<bool> {
                if (auto noted = Logins::logout(school, who); !noted)
                    return tl::unexpected(noted.error());
                return true;
            },
            [](const core::Result<bool>&) {});
    // The note that it is graded may still be on its way: behind a replay, say.
    const bool isKept = isAsGraded() && (m_graded->keeping == Keeping::Waiting || m_graded->keeping == Keeping::Kept);
    stopJournal(isKept);
    m_loads.begin();  // what was being made for him opens for nobody else
    m_window->stopBusy();
    m_school.user = {};
    m_lessonsRead = {};
    m_ownHash.clear();
    forgetWrongAlone();
    m_byHand.reset();
    m_presets.refresh();
    m_window->leaveAll();
    if (m_people)
        m_people->forget();
    m_window->setWho(m_school.user);
    tellMayEdit();
    clearTable();
    m_window->askLogin();
}

/// The window shows the pages of the role in which somebody has logged in.
void Application::leaveWithAnotherRole()
{
    if (m_school.user.isGuest())
        return;
    m_school.service->ask(
        this,
        [who = m_school.user](const DatabaseContext& school) {
            return database::sql::authorize(school, who, database::Operation::ReadSettings);
        },
        [this, who = m_school.user](const core::Result<database::sql::AuthorizedUser>& now) {
            if (!now || m_school.user != who || now->role == who.role())
                return;
            leave();
            m_window->sayAtDoor([] { return tr("Your role was changed, and you were logged out. Log in again."); });
        });
}

/// Where there is a school its lessons, and its exams, are changed by who teaches.
void Application::tellMayEdit()
{
    const bool teaches =
        m_school.user.role() == database::Role::Instructor || m_school.user.role() == database::Role::Admin;
    m_window->setMayEdit(!m_school.service || m_window->isNewSchool() || teaches);
}

void Application::becomeGuest()
{
    ++m_doorTurn;
    m_keepsOnLogin = false;
    m_window->setWho(m_school.user);
    if (m_journal)  // he has only looked at the door
        return;
    keepJournal();
    if (m_tour)
        m_tour->welcome(nullptr, m_school.user);
}

/// A whole tooth, to nobody's credit.
void Application::clearTable()
{
    m_graded.reset();
    m_opened.reset();
    m_openedExplainer.forget();
    m_tried.reset();
    if (!m_attempt.assignment().anatomy)  // it is still being made
        return;
    // The tooth of a lesson may have no decay to be taken out.
    if (const auto practice = lessons::practiceOn(m_practised ? m_practised : m_attempt.assignment().anatomy))
        begin(*practice, {}, false);
}

void Application::connectPresets()
{
    using ui::window::MainWindow;
    connect(m_window.get(), &MainWindow::presetFelt, this, &Application::feel);
    connect(m_window.get(), &MainWindow::feelRequested, this, &Application::feelByHand);
    connect(m_window.get(), &MainWindow::presetTrialRequested, this, [this](const core::settings::FeelPreset& preset) {
        m_triedKind = {};
        openTooth(core::teeth::parseSource(core::teeth::blockName(core::teeth::BlockShape::Layers)), {}, preset);
    });
    connect(m_window.get(), &MainWindow::trialBlockChosen, this,
            [this](const core::settings::ToothKind& kind) { m_triedKind = kind; });
    connect(&m_presets, &PresetController::inUseChanged, this, [this] {
        m_byHand.reset();
        // What nobody has begun to work on begins anew, as it feels now.
        if (!m_attempt.assignment().lesson && !m_tried && !m_window->isBusy() && isUntouched())
            beginAsItFeels();
    });
    m_window->showFeel(m_presets.inUse(), m_presets.inUse());
}

/// In the middle of an attempt: what differs goes to the servo as numbers, and so onto the recording.
void Application::feel(const core::settings::FeelPreset& preset)
{
    const lessons::Lesson* lesson = m_attempt.assignment().lesson ? &*m_attempt.assignment().lesson : nullptr;
    if (m_replay || (lesson != nullptr && lesson->exam) || !core::settings::checkStability(preset))
        return;
    m_numbers = core::servo::parametersOf(
        lessons::servoSettings(lesson, settingsFor(m_devices->isForceChosen(), m_devices->scale()), preset,
                               m_tried ? m_triedKind : core::settings::ToothKind{}));
    tellNumbers();
}

/// What was turned in the console or the settings holds until it is turned back, for other teeth as well.
void Application::feelByHand(const core::settings::FeelPreset& preset)
{
    core::settings::FeelPreset asKept = preset;
    asKept.hash = m_presets.inUse().hash;
    m_byHand = asKept == m_presets.inUse() ? std::nullopt : std::optional(preset);
    // An attempt that nobody has begun to work on is made with the whole preset, and says so.
    const bool isWhole = lessons::hashed(preset).hash == preset.hash;
    if (isWhole && isUntouched() && !m_attempt.assignment().exercise)
        beginAsItFeels();
    else
        feel(preset);
}

/// What is whole because it was undone could be redone, and what has a grade is an attempt already.
bool Application::isUntouched() const
{
    const auto tooth = m_session.toothSoFar();
    return !m_replay && !m_attempt.isGraded() && tooth && tooth->anatomy == m_attempt.assignment().anatomy &&
           tooth->top == tooth->anatomy->top && m_session.historySoFar().size() <= 1;
}

/// The same once more. What was found of a scan is not found again, and still to be answered.
void Application::beginAsItFeels()
{
    begin(lessons::Assignment(m_attempt.assignment()), std::function<QStringList()>(m_notes), m_isUnitInDoubt);
}

/// What the servo has not been told yet; the rest later, where there is no room.
void Application::tellNumbers()
{
    for (std::size_t k = 0; k < m_numbers.size(); ++k)
        if (m_numbers.at(k) != m_numbersTold.at(k)) {
            const core::servo::SetParameter number{static_cast<std::uint8_t>(k), static_cast<float>(m_numbers.at(k))};
            if (!m_links.commands.tryPush(number))
                return;
            m_numbersTold.at(k) = m_numbers.at(k);
        }
}

void Application::openTooth(const core::teeth::ToothSource& source, const std::optional<core::mesh::LengthUnit>& unit,
                            const std::optional<core::settings::FeelPreset>& tried)
{
    const int load = m_loads.begin();
    const auto* fdi = std::get_if<int>(&source.what);
    const auto* path = std::get_if<std::filesystem::path>(&source.what);
    const QString file = path == nullptr ? QString() : QFileInfo(*path).filePath();
    m_window->showBusy(fdi != nullptr    ? tr("Making tooth %1 …").arg(*fdi)
                       : path != nullptr ? tr("Reading %1 …").arg(QFileInfo(file).fileName())
                                         : tr("Making a practice block …"));
    core::teeth::BuildOptions build = m_options.build;
    if (unit)
        build.placement.unit = unit;
    m_presets.readAgain();
    inBackground(
        this,
        [source, build, workOut = surfaceWorker()] {
            auto built = core::teeth::buildTooth(source, build);
            if (built)
                workOut(built->anatomy);
            return built;
        },
        [this, load, source, file, tried](const core::Result<core::teeth::BuiltTooth>& built) {
            m_presets.whenRead([this, load, source, file, tried, built] {
                // What was asked for since does not end the wait for the program's first tooth: without one nothing
                // could be practised on.
                const bool isFirstWanted = load == 1 && !m_attempt.assignment().anatomy && !m_replay;
                if (!m_loads.isLatest(load) && !isFirstWanted)
                    return;
                if (!built) {
                    refuse(built.error(), file.isEmpty() ? FailedOperation::MakingTooth : FailedOperation::OpeningScan,
                           file);
                    return;
                }
                m_source = source;
                m_tried = tried;
                if (!tried && file.isEmpty())  // a scan may be of somebody's patient
                    m_practised = built->anatomy;
                takeTooth(*built);
                if (tried)
                    m_window->beginTrial();
            });
        });
}

void Application::openLesson(const lessons::Lesson& lesson)
{
    const int load = m_loads.begin();
    m_window->showBusy(tr("Preparing the lesson …"));
    m_presets.readAgain();
    whereAllowed(lesson.id, [this, load, lesson] {
        inBackground(
            this,
            [lesson, drawn = QRandomGenerator::global()->generate64(), workOut = surfaceWorker()] {
                auto assigned = lessons::assign(lesson, drawn);
                if (assigned)
                    workOut(assigned->assignment.anatomy);
                return assigned;
            },
            [this, load, id = lesson.id](const core::Result<lessons::Assigned>& assigned) {
                m_presets.whenRead([this, load, id, assigned] {
                    if (!m_loads.isLatest(load))
                        return;
                    if (!assigned) {
                        refuse(assigned.error(), FailedOperation::OpeningLesson, QString::fromStdString(id));
                        return;
                    }
                    m_tried.reset();
                    begin(assigned->assignment, notesOf(assigned->report), false);
                });
            });
    });
}

/// A teacher's folder may have changed since it was read last.
void Application::showLessons()
{
    const auto show = [this, who = m_school.user] {
        inBackground(
            this, [] { return lessons::readCatalog(lessons::teachersFolder()); },
            [this, who](std::vector<lessons::CatalogEntry>& entries) {
                if (m_school.user != who)
                    return;
                m_window->setLessons(std::move(entries), m_lessonsRead.standings, m_lessonsRead.given);
                m_window->setFeedback(m_lessonsRead.feedback);
                tellUnfinished();  // who put the offer away finds it here again
            });
    };
    if (!m_school.service || m_school.user.isGuest()) {
        show();
        return;
    }
    // Lessons are files: they do not wait for a server that does not answer.
    const auto isAnswered = std::make_shared<bool>(false);
    QTimer::singleShot(kLongestLookMs, this, [isAnswered, show] {
        if (!*isAnswered)
            show();
    });
    m_school.service->ask(
        this,
        [who = m_school.user](const DatabaseContext& school) -> core::Result<LessonsRead> {
            const auto standings = database::sql::standingsOf(school, who, who.person());
            if (!standings)
                return tl::unexpected(standings.error());
            LessonsRead found;
            for (const database::LessonStanding& one : *standings)
                found.standings[one.lessonId] = {one.attempts, one.bestTenths, one.passed,
                                                 QString::fromStdString(one.lastUtc)};
            if (who.role() != database::Role::Student)
                return found;
            auto feedback = database::sql::feedbackFor(school, who, who.person());
            if (!feedback)
                return tl::unexpected(feedback.error());
            found.feedback = std::move(*feedback);
            const auto classes = database::sql::listClasses(school, who);
            const auto given = database::sql::listAssignments(school, who);
            if (!classes || !given)
                return tl::unexpected(classes ? given.error() : classes.error());
            for (const database::ClassAssignment& one : *given) {
                const auto ofClass = std::find_if(classes->begin(), classes->end(),
                                                  [&](const auto& other) { return other.id == one.classId; });
                ui::catalog::Given& here = found.given[one.lessonId];
                if (ofClass != classes->end())
                    here.className += (here.className.isEmpty() ? QString() : QStringLiteral(", ")) +
                                      QString::fromStdString(ofClass->name);
                const QDateTime due = QDateTime::fromString(QString::fromStdString(one.dueUtc), Qt::ISODate);
                if (ofClass != classes->end())
                    here.classes.emplace_back(QString::fromStdString(ofClass->name), due);
                if (due.isValid() && (!here.due.isValid() || due < here.due))
                    here.due = due;
                const auto left = database::sql::attemptsLeft(school, who, one.lessonId);
                if (!left)
                    return tl::unexpected(left.error());
                here.attemptsLeft = *left;
            }
            return found;
        },
        [this, show, isAnswered, who = m_school.user](const core::Result<LessonsRead>& found) {
            *isAnswered = true;
            if (m_school.user != who)
                return;
            if (found)
                m_lessonsRead = *found;
            else  // what was read before may be old, but is no "not tried yet"
                m_window->showError(found.error(), FailedOperation::ReadingSchool);
            show();
        });
}

/// Whether the student may still try this lesson, once. Nobody waits for a server that does not answer: then he may.
void Application::askWhetherAllowed(const std::string& lessonId, const std::function<void(bool)>& decide)
{
    if (!m_school.service || m_school.user.role() != database::Role::Student) {
        decide(true);
        return;
    }
    const auto once = [decide, isDecided = std::make_shared<bool>(false)](bool may) {
        if (!std::exchange(*isDecided, true))
            decide(may);
    };
    m_school.service->ask(
        this,
        [who = m_school.user, lessonId](const DatabaseContext& school) {
            return database::sql::attemptsLeft(school, who, lessonId);
        },
        [once](const core::Result<std::optional<int>>& left) {
            once(!left || !left->has_value() || left->value() > 0);
        });
    QTimer::singleShot(kLongestCheckMs, this, [once] { once(true); });
}

/// Goes on where the student may still try this lesson; else says so.
void Application::whereAllowed(const std::string& lessonId, const std::function<void()>& go,
                               const std::function<void()>& refuse)
{
    askWhetherAllowed(lessonId, [this, go, refuse, load = m_loads.latest()](bool may) {
        if (!m_loads.isLatest(load))
            return;
        if (may) {
            go();
            return;
        }
        refuse();
        m_window->stopBusy();
        m_window->showMessage(ui::text::usedUpWords());
    });
}

/// Into the teacher's folder, where a lesson can be changed.
void Application::unpack(const QString& pack, const QString& name)
{
    inBackground(
        this,
        [pack, name]() -> core::Result<lessons::ReadLesson> {
            const QString folder = lessons::teachersFolder();
            const auto files = lessons::readPack(pack);
            if (!files)
                return tl::unexpected(files.error());
            if (auto put = lessons::putInto(folder, *files); !put)
                return tl::unexpected(put.error());
            return lessons::readLesson(QDir(folder).filePath(name));
        },
        [this](const core::Result<lessons::ReadLesson>& unpacked) {
            if (unpacked && unpacked->lesson) {
                m_window->editLesson(*unpacked);
                return;
            }
            m_window->showMessage(
                tr("The pack was not unpacked, so its lesson cannot be changed. %1")
                    .arg(unpacked ? QString() : ui::text::faultWords(core::wordsOf(unpacked.error()))));
        });
}

/// What the score sheets say that was measured of attempts at exactly this lesson: one's own, and a teacher's those of
/// his classes.
void Application::tellKnownAttempts(const lessons::Lesson& lesson)
{
    m_window->setKnownAttempts({});
    if (!m_school.service || m_school.user.isGuest())
        return;
    m_school.service->ask(
        this,
        [who = m_school.user, id = lesson.id, hash = lesson.hash](const DatabaseContext& school) {
            return database::sql::sheetsOfLesson(school, who, id, hash, kMostKnownAttempts);
        },
        [this](const core::Result<std::vector<database::sql::KeptSheet>>& sheets) {
            std::vector<ui::lessoneditor::MeasuredAttempt> known;
            for (const database::sql::KeptSheet& sheet : sheets.value_or(std::vector<database::sql::KeptSheet>{}))
                known.push_back({QString::fromStdString(sheet.finishedUtc), lessons::measuredIn(sheet.json)});
            m_window->setKnownAttempts(std::move(known));
        });
}

void Application::endWith(const core::Error& error)
{
    m_endedBy = error;
    QCoreApplication::exit(EXIT_FAILURE);
}

/// Said in the window, and if nothing lies on the table yet, a tooth of our own is put there. Where only a picture was
/// requested, the program ends.
void Application::refuse(const core::Error& error, FailedOperation failed, const QString& file)
{
    if (!m_options.picture.isEmpty()) {
        endWith(error);
        return;
    }
    m_window->showError(error, failed, file);
    if (!m_attempt.assignment().anatomy && !m_replay)
        openTooth({kSpareTooth});
}

void Application::takeTooth(const core::teeth::BuiltTooth& built)
{
    const auto practice = lessons::practiceOn(built.anatomy);
    if (practice)
        begin(*practice, notesOf(built.report), built.report.placement.unitDoubtful);
    else
        refuse(practice.error(), FailedOperation::MakingTooth, {});
}

void Application::begin(const lessons::Assignment& assignment, const std::function<QStringList()>& notes,
                        bool unitInDoubt)
{
    const bool isExam = assignment.lesson && assignment.lesson->exam;
    const core::settings::FeelPreset usual = m_tried.value_or(m_presets.inUse());
    const core::settings::FeelPreset preset = m_tried || isExam ? usual : m_byHand.value_or(m_presets.inUse());
    const core::servo::ServoSettings settings =
        lessons::servoSettings(assignment.lesson ? &*assignment.lesson : nullptr,
                               settingsFor(m_devices->isForceChosen(), m_devices->scale()), preset);
    auto servo = core::servo::makeServoTick(settings);
    if (!servo) {
        refuse(servo.error(), FailedOperation::OpeningLesson,
               assignment.lesson ? QString::fromStdString(assignment.lesson->id) : QString());
        return;
    }
    if (!m_window->canSend(kCommandsOfATooth))
        return;
    lay(assignment, settings, notes, unitInDoubt);
    // A block on which a preset is tried is nobody's work.
    if (m_tried && m_journal)
        m_journal->leaveOut(m_attempt.generation());
    m_window->showFeel(preset, usual);
    m_window->send(core::session::ReplaceTooth{
        std::make_unique<core::terrain::Tooth>(m_attempt.assignment().anatomy), m_attempt.generation(),
        m_attempt.assignment().lesson ? m_attempt.assignment().lesson->json : "", std::move(*servo)});
}

/// For what makes or reads a tooth beside the window: how it is drawn is worked out there too, and not while the window
/// waits.
std::function<void(const AnatomyPointer&)> Application::surfaceWorker() const
{
    return [light = ui::tooth::operatingLight(m_window->view().isLeftHanded())](const AnatomyPointer& anatomy) {
        ui::render::workOutSurface(anatomy, light);
    };
}

/// Shows another tooth. The session loop is given it afterwards.
void Application::lay(const lessons::Assignment& assignment, const core::servo::ServoSettings& settings,
                      const std::function<QStringList()>& notes, bool unitInDoubt)
{
    if (m_replay) {
        putReplayAway();
        m_window->setReplaying(false);
        startLoops();
    }
    m_explainer.forget();
    m_attempt.begin(++m_generation, assignment, settings);
    m_notes = notes;
    m_isUnitInDoubt = unitInDoubt;
    m_numbers = core::servo::parametersOf(m_attempt.settings());
    m_numbersTold = m_numbers;
    m_window->setAssignment(m_attempt.assignment());
    m_window->setHandpieces(m_attempt.settings().handpieces);
    holdHand(false);
    m_cutIn.clear();
    m_cutWith.clear();
    m_follower.watch(m_attempt.generation(), lessons::examinationOf(m_attempt.assignment()));
    m_demoHand.reset();
    m_window->showTooth(m_attempt.assignment().anatomy, m_attempt.generation(), notes, unitInDoubt);
}

void Application::letHandDecide()
{
    if (m_replay && m_replay->isLeading()) {  // it goes along willingly
        const glm::dvec3 shown = m_links.servo.latest().anchorMm;
        m_demoWish.publish({.targetMm = glm::dvec2(shown), .hoverMm = shown.z, .pushing = false});
    }
    const auto tooth = m_session.toothSoFar();
    if (m_replay || m_attempt.assignment().exercise || !tooth || tooth->anatomy != m_attempt.assignment().anatomy)
        return;
    const core::servo::ServoState& state = m_links.servo.latest();
    if (!m_demoHand || std::exchange(m_demoBur, state.burIndex) != state.burIndex)
        m_demoHand = handFor(m_attempt.assignment(), state.burIndex);
    m_demoWish.publish(m_demoHand->decide(state, *tooth));
}

/// Another hand has the bur.
void Application::followHand()
{
    if (m_devices->isSimulated())
        m_demoBeat.start();
    else
        m_demoBeat.stop();
    // An attempt that nobody has worked on begins anew, so that it feels as the device can make it felt.
    const bool isExam = m_attempt.assignment().lesson && m_attempt.assignment().lesson->exam;
    const core::contact::ForceSettings felt = settingsFor(m_devices->isForceChosen(), m_devices->scale()).force;
    if (!m_devices->isSimulated() && m_attempt.settings().force.workAreaMm != felt.workAreaMm && !isExam &&
        !m_attempt.assignment().exercise && !m_window->isBusy() && isUntouched())
        beginAsItFeels();
}

/// The user has chosen the simulated hand, whose work is nobody's, or has left it.
void Application::beginForAnotherHand()
{
    m_loads.begin();
    const std::optional<lessons::Lesson> lesson = m_attempt.assignment().lesson;
    if (m_devices->isSimulated()) {
        stopJournal(true);
        if (lesson && lesson->exam)
            clearTable();
        else if (m_attempt.assignment().anatomy)
            beginAsItFeels();
    } else {
        const std::uint64_t nobodys = m_attempt.generation();
        clearTable();
        keepJournal();
        m_journal->leaveOut(nobodys);
        if (lesson && !lesson->exam)
            openLesson(*lesson);
    }
    m_window->showBegunAnew();
}

/// In practice a breach of the lesson's rules stops the bur and is explained. In an exam it is only noted.
void Application::watchAttempt()
{
    if (!m_replay) {
        tellNumbers();
        // An exercise is done by touching.
        const bool isExercise =
            m_attempt.assignment().lesson && lessons::isExercise(m_attempt.assignment().lesson->task);
        if (const core::servo::ServoState& servo = m_links.servo.latest();
            servo.cutting || (isExercise && servo.touching)) {
            ++m_cutIn[m_window->view().settings().presentation.stereo];
            ++m_cutWith[m_devices->cutsWith()];
        }
    }
    if (m_replay || !m_attempt.assignment().lesson)
        return;
    const core::session::Findings findings = m_follower.findings();
    if (findings.generation != m_attempt.generation())
        return;
    noteExam(findings);
    if (findings.practised)
        m_window->showPractised(*findings.practised);
    if (const auto violation = m_attempt.nextViolation(findings.infractions)) {
        const bool canTakeBack = core::history::lastBefore(m_session.historySoFar(), violation->tick).has_value();
        m_window->tellInfraction(*violation, canTakeBack);
    }
}

/// What is found of an attempt that is not the one on the score page waits until it is.
void Application::connectExplainer(ScoreAnalysis& explainer)
{
    const auto isShown = [this, isOfOpened = &explainer == &m_openedExplainer] { return isOldShown() == isOfOpened; };
    ui::scoring::ScorePage& page = m_window->scorePage();
    connect(&explainer, &ScoreAnalysis::noiseFound, &page, [&page, isShown](const lessons::GridSensitivity& noise) {
        if (isShown())
            page.setNoise(noise);
    });
    connect(&explainer, &ScoreAnalysis::momentsProgress, &page, [&page, isShown](double share) {
        if (isShown())
            page.setMomentsProgress(share);
    });
    connect(&explainer, &ScoreAnalysis::momentsFound, &page,
            [&page, isShown](const lessons::PointLossTimeline& moments) {
                if (isShown())
                    page.setMoments(moments.ofCriteria);
            });
    connect(&explainer, &ScoreAnalysis::failed, this, [this, &page, isShown](const core::Error& error) {
        if (!isShown())
            return;
        page.setMomentsProgress({});
        m_window->showError(error, FailedOperation::Marking);
    });
}

/// Once it is begun in earnest, the school knows of an exam: it counts as an attempt, whether or not a score comes of
/// it. Who has opened his last one in two windows begins it in one of them.
void Application::noteExam(const core::session::Findings& findings)
{
    const bool isBegun =
        findings.process.firstCutS || (findings.practised && core::grading::isBegun(*findings.practised));
    if (!m_attempt.isExam() || !isBegun || !m_school.isLoggedIn() || !m_journal)
        return;
    const std::filesystem::path journal = m_journal->fileOf(m_attempt.generation());
    if (journal.empty() || !m_attempt.startExam())  // it has yet to hear of this tooth
        return;
    // Taken up after a kill it is told of again, and is the same one.
    const database::ExamStart start{database::uidOf("exam " + m_school.user.uid() + ' ' + journal.filename().string()),
                                    m_attempt.assignment().lesson->id,
                                    QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()};
    if (m_attempt.exam() == CurrentAttempt::Exam::Counted) {
        tellExam(m_school.user, start);
        return;
    }
    askWhetherAllowed(start.lessonId,
                      [this, who = m_school.user, start, generation = m_attempt.generation()](bool may) {
                          if (may)
                              tellExam(who, start);
                          if (m_attempt.answerExam(generation, may))
                              m_window->refuseExam();
                      });
}

/// Where the school's server is away it lies in the outbox, as a graded attempt does. What the disk refuses is offered
/// to it again.
void Application::tellExam(const database::Login& who, const database::ExamStart& start)
{
    m_school.service->keep(this, who, start, [this, who, start](const core::Status& kept) {
        if (!kept)
            QTimer::singleShot(m_options.retry, this, [this, who, start] { tellExam(who, start); });
    });
}

/// Within the outline of what is to be cut, or nowhere.
void Application::holdHand(bool wanted)
{
    const core::grading::IdealTop ideal = wanted ? m_attempt.assignment().shownIdeal() : nullptr;
    std::unique_ptr<const core::guidance::Fixture> fixture;
    if (ideal)
        fixture = std::make_unique<const core::guidance::Fixture>(*m_attempt.assignment().anatomy, *ideal);
    m_window->send(core::session::SetFixture{std::move(fixture)});
}

/// To the last moment before a tick, on the way that led here.
void Application::takeBack(std::uint64_t tick)
{
    if (const auto last = core::history::lastBefore(m_session.historySoFar(), tick))
        static_cast<void>(m_links.commands.tryPush(core::session::GoTo{*last}));
}

/// What is cut while the grade is worked out would be no part of it, and no other attempt either: the bur is out of the
/// tooth first. Whose hand holds it there is not waited for.
void Application::settle(int looks, int settled)
{
    const core::servo::ServoState& servo = m_links.servo.latest();
    const bool isOut = !(servo.touching && servo.drillOn);
    settled = isOut ? settled + 1 : 0;
    if (settled >= kSettledLooks || looks >= kMostSettleLooks) {
        gradeNow();
        m_attempt.stopSettling();
        return;
    }
    QTimer::singleShot(kSettleMs, this, [this, looks, settled, generation = m_attempt.generation()] {
        if (generation != m_attempt.generation())
            return;
        if (!m_replay)
            settle(looks + 1, settled);
        else
            m_attempt.stopSettling();
    });
}

void Application::grade()
{
    if (!m_attempt.settle())
        return;
    m_window->view().release();
    settle(0, 0);
}

void Application::gradeNow()
{
    const auto tooth = m_session.toothSoFar();
    if (!tooth || m_session.recordedGeneration() != m_attempt.generation()) {
        m_window->showMessage(tr("The tooth is not ready yet. Try again in a moment."));
        return;
    }
    const std::uint64_t hash = core::terrain::stateHash(*tooth);
    std::optional<core::grading::Practised> practised;
    if (const core::session::Findings now = m_follower.findings(); now.generation == m_attempt.generation())
        practised = now.practised;
    if (m_graded && m_graded->generation == m_attempt.generation() && m_graded->hash == hash &&
        m_graded->practised == practised) {
        showGrade();
        if (m_graded->keeping == Keeping::Nowhere)
            keepGrade();  // what failed may work now
        m_explainer.tellAgain();
        return;
    }
    if (m_attempt.assignment().exercise && !(practised && core::grading::isBegun(*practised))) {
        m_window->showMessage(m_attempt.assignment().lesson &&
                                      m_attempt.assignment().lesson->task == lessons::Task::TellLayers
                                  ? tr("No pad has an answer yet. Choose below the view what each pad is made of.")
                                  : tr("This exercise has not been started yet, so there is nothing to grade."));
        return;
    }
    if (!m_attempt.assignment().exercise && tooth->top == tooth->anatomy->top) {
        m_window->showMessage(tr("Nothing has been cut yet, so there is nothing to grade."));
        return;
    }
    // To think about one's work takes no time from it; nor does what comes after the end of an exam.
    m_attempt.conclude([this] { return m_follower.conclude(); }, m_window->isExamOver());
    // That an exam was begun has been counted. What is cut on and graded again is one more attempt.
    const bool isAnother = m_attempt.isGraded();
    const bool isCounted = m_attempt.exam() == CurrentAttempt::Exam::Counted;
    if (!m_attempt.assignment().lesson)
        finish({});
    else if (m_attempt.seenBefore() && !isAnother)  // nobody expects what he has seen
        finish(m_attempt.seenBefore()->expectedTenths
                   ? std::optional(ui::scoring::ScorePrediction{*m_attempt.seenBefore()->expectedTenths, {}})
                   : std::nullopt);
    else if (m_attempt.assignment().lesson->exam && isCounted && !isAnother)
        m_window->askForecast();
    else
        whereAllowed(m_attempt.assignment().lesson->id, [this] { m_window->askForecast(); });
}

/// Marks the work as it was when the grade was asked for, keeps the grade and shows it.
void Application::finish(const std::optional<ui::scoring::ScorePrediction>& expected)
{
    const auto done = m_attempt.grade();
    if (!done)
        return;
    const core::session::Findings& found = done->findings;
    const lessons::Conduct conduct{found.process, found.infractions, found.aids, found.practised};
    const auto marked = lessons::mark(m_attempt.assignment(), done->tooth, conduct);
    if (!marked) {
        m_window->showError(marked.error(), FailedOperation::Marking);
        return;
    }
    const lessons::ScoreSheet& sheet = marked->sheet;
    const std::uint64_t hash = core::terrain::stateHash(done->tooth);
    m_graded = {m_attempt.generation(),
                hash,
                sheet,
                recordOf(*done, sheet, expected),
                Keeping::Nowhere,
                {},
                {},
                expected,
                {std::make_shared<const core::terrain::Tooth>(done->tooth), m_attempt.assignment().shownIdeal(),
                 marked->measured, found.infractions, found.aids,
                 // Of what is tried its card tells, and in a blind comparison nobody.
                 m_tried ? std::nullopt : std::optional(lessons::presetUsed(done->recording)),
                 m_attempt.assignment().exercise},
                done->recording,
                found.practised};
    const bool isExam = m_attempt.assignment().lesson && m_attempt.assignment().lesson->exam;
    if (isExam)
        keepExam();
    else {
        showGrade();
        keepGrade();
    }
    m_explainer.explain(m_attempt.assignment(), m_graded->recording, m_graded->work.tooth, conduct);
}

database::AttemptRecord Application::recordOf(const core::session::AttemptSnapshot& done,
                                              const lessons::ScoreSheet& sheet,
                                              const std::optional<ui::scoring::ScorePrediction>& expected) const
{
    const auto preset = lessons::presetUsed(done.recording);
    database::AttemptRecord record;
    record.uid = database::newUid();
    record.finishedUtc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    record.tooth = m_attempt.assignment().anatomy->name;
    record.scoreTenths = sheet.totalTenths;
    record.passed = sheet.passed();
    record.passMarkTenths = sheet.passMarkTenths;
    record.rubricHash = sheet.rubricHash;
    if (expected)
        record.expectedTenths = expected->tenths;
    if (m_attempt.assignment().lesson) {
        record.lessonId = m_attempt.assignment().lesson->id;
        record.lessonHash = m_attempt.assignment().lesson->hash;
    }
    for (const lessons::Criterion& criterion : sheet.criteria)
        record.criteria.push_back({criterion.id, criterion.lostTenths, criterion.weightTenths});
    record.durationMs = std::llround(kMsPerS * done.findings.process.totalS);
    record.scoreSheetJson = lessons::toJson(sheet, preset).toStdString();
    record.stateHash =
        QStringLiteral("%1").arg(core::terrain::stateHash(done.tooth), 16, 16, QLatin1Char('0')).toStdString();
    const auto mostlyWith = std::max_element(m_cutWith.begin(), m_cutWith.end(),
                                             [](const auto& a, const auto& b) { return a.second < b.second; });
    record.device = (mostlyWith != m_cutWith.end() ? mostlyWith->first : m_devices->hand()).toStdString();
    record.method = m_attempt.settings().method;
    record.grid = m_attempt.assignment().anatomy->grid.side;
    const auto mostly = std::max_element(m_cutIn.begin(), m_cutIn.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
    record.viewMode =
        ui::render::idOf(mostly != m_cutIn.end() ? mostly->first : m_window->view().settings().presentation.stereo);
    record.seed = std::to_string(m_attempt.assignment().anatomy->seed);
    record.preset = preset.name.toStdString() + (preset.version > 0 ? " v" + std::to_string(preset.version) : "") +
                    (preset.isChanged ? ", changed" : "");
    record.presetHash = preset.hash.toStdString();
    record.program = CUSP_VERSION;
    if (const auto& force = done.findings.process.force) {
        record.meanForceMn = static_cast<int>(std::lround(force->meanN * kMnPerN));
        record.peakForceMn = static_cast<int>(std::lround(force->largestN * kMnPerN));
    }
    return record;
}

/// The grade that is shown goes into the outbox, and from there into the database.
void Application::keepGrade()
{
    // A guest could do an exam as often as he likes, and log in for the best; what he has taken up may be another
    // guest's; the simulated hand is nobody's, nor is the block on which a preset is tried.
    const bool isExam = m_attempt.assignment().lesson && m_attempt.assignment().lesson->exam;
    const bool isNobodys = m_devices->isSimulated() || m_tried || m_graded->isOverLimit ||
                           (m_school.user.isGuest() && (isExam || m_attempt.isResumed()));
    m_graded->keeping = !m_school.service || isNobodys ? Keeping::Nowhere
                        : m_school.user.isGuest()      ? Keeping::Guest
                                                       : Keeping::Pending;
    tellKeeping();
    if (m_graded->keeping != Keeping::Pending)
        noteGraded();
    else
        m_letters->send(std::make_shared<const PendingAttempt>(
            PendingAttempt{m_school.user, m_graded->record, m_graded->recording, m_graded->generation,
                           m_journal ? m_journal->fileOf(m_graded->generation) : std::filesystem::path()}));
}

/// Whose program is killed before his exam is kept has not seen its score, and may go on with it; whoever has seen it
/// may not, whatever the disk says.
void Application::keepExam()
{
    keepGrade();
    m_scoreToShow = m_graded->record.uid;
    if (m_graded->keeping != Keeping::Pending)
        showExamsScore(m_scoreToShow);
    else
        QTimer::singleShot(kLongestLookMs, this, [this, uid = m_scoreToShow] { showExamsScore(uid); });
}

void Application::showExamsScore(const std::string& uid)
{
    if (m_scoreToShow != uid || !m_graded || m_graded->record.uid != uid)
        return;
    m_scoreToShow.clear();
    noteGraded();
    showGrade();
}

/// On its recording, and so in its journal: it is not offered to be gone on with.
void Application::noteGraded()
{
    if (m_graded->generation == m_attempt.generation())
        static_cast<void>(m_links.commands.tryPush(core::session::AddNote{core::servo::kGradedNote}));
}

void Application::takeKept(const PendingAttempt& letter, bool isAgain)
{
    endJournal(letter);
    takeAnswer(letter, Keeping::Waiting);
    if (m_school.user != letter.who || m_letters->hasAnyOf(m_school.user))
        return;
    m_window->forgetNotKept();
    if (isAgain)
        m_window->showMessage(tr("The grade that could not be saved is now saved."));
}

void Application::takeRefused(const PendingAttempt& letter, bool isAgain, const core::Error& why)
{
    takeAnswer(letter, Keeping::Refused);
    if (m_school.user == letter.who && !isAgain)
        m_window->showNotKept(why);
}

/// Of the disk.
void Application::takeAnswer(const PendingAttempt& letter, Keeping keeping)
{
    if (m_graded && m_graded->record.uid == letter.record.uid) {
        m_graded->keeping = keeping;
        tellKeeping();
    }
    showExamsScore(letter.record.uid);
    m_window->setUnkeptGrades(m_letters->count());
}

/// The work that is graded is as it was, so that its journal has nothing that is not kept.
bool Application::isAsGraded() const
{
    const auto tooth = m_session.toothSoFar();
    return m_graded && m_graded->generation == m_attempt.generation() && tooth &&
           m_session.recordedGeneration() == m_attempt.generation() &&
           core::terrain::stateHash(*tooth) == m_graded->hash;
}

/// What is kept is not offered to be gone on with. What was cut on since is another attempt.
void Application::endJournal(const PendingAttempt& letter)
{
    if (letter.generation == m_attempt.generation()) {
        if (isAsGraded())
            noteGraded();
        if (m_attempt.isResumed() && !m_unfinished)
            offerUnfinished();  // others may be waiting
    } else if (!letter.journal.empty()) {
        // He has left the tooth meanwhile, perhaps for somebody else.
        QThreadPool::globalInstance()->start(
            [journal = letter.journal, events = letter.recording.events()] { endKept(journal, events); });
    }
}

/// A guest's grade becomes that of who has logged in for it, unless he has no attempt left. Where nobody can be asked
/// it is kept.
void Application::keepGuestsGrade()
{
    m_graded->keeping = Keeping::Pending;
    tellKeeping();
    m_school.service->ask(
        this,
        [who = m_school.user, lesson = m_graded->record.lessonId](const DatabaseContext& school) {
            return database::sql::attemptsLeft(school, who, lesson);
        },
        [this, who = m_school.user, record = m_graded->record,
         recording = m_graded->recording](const core::Result<std::optional<int>>& left) {
            const bool isOverLimit = who.role() == database::Role::Student && left && *left == 0;
            if (!m_graded || m_graded->record.uid != record.uid || m_school.user != who) {
                // He has gone on meanwhile.
                if (!isOverLimit)
                    m_letters->send(std::make_shared<const PendingAttempt>(PendingAttempt{who, record, recording}));
                return;
            }
            m_graded->isOverLimit = isOverLimit;
            keepGrade();
            if (!m_graded->isOverLimit || m_graded->generation != m_attempt.generation())
                return;
            m_window->setUsedUp(true);
            m_window->showOverLimit();
        });
}

/// Of the work on the table, in place of an old one that was opened.
void Application::showGrade()
{
    m_opened.reset();
    m_openedExplainer.forget();
    if (m_people)
        m_people->talkAbout({});
    m_window->showScore(m_graded->sheet, m_graded->history, m_graded->expected, m_graded->work);
    tellKeeping();
}

/// On the score page, where the grade it is about is shown.
void Application::tellKeeping()
{
    if (isOldShown())
        return;
    ui::scoring::ScorePage& page = m_window->scorePage();
    page.setHistory(m_graded->history);
    page.setKeeping(m_graded->keeping);
    if (m_graded->generation == m_attempt.generation() &&
        (m_graded->keeping == Keeping::Waiting || m_graded->keeping == Keeping::Kept))
        m_window->showWorkKept();
    if (m_graded->keeping == Keeping::Kept)
        page.setClass(m_graded->standing);
}

/// The grades before it, of the same lesson or without one of the same tooth; and where it stands in the class.
void Application::tellHistory()
{
    struct Found
    {
        std::vector<database::AttemptRecord> history;
        lessons::ClassStanding standing;
        std::optional<int> attemptsLeft;
    };
    m_school.service->ask(
        this,
        [who = m_school.user, record = m_graded->record,
         tenths = m_graded->sheet.totalTenths](const DatabaseContext& school) -> core::Result<Found> {
            Found found;
            auto history =
                database::sql::history(school, who, who.person(),
                                       {record.lessonId, record.lessonId.empty() ? record.tooth : "", kHistoryLength});
            const auto standing = database::sql::standingAmongClassmates(school, who, record.lessonId,
                                                                         record.rubricHash, record.device, tenths);
            if (!history || !standing)
                return tl::unexpected(history ? standing.error() : history.error());
            auto left = database::sql::attemptsLeft(school, who, record.lessonId);
            return Found{std::move(*history), *standing, left.value_or(std::nullopt)};
        },
        [this, uid = m_graded->record.uid](const core::Result<Found>& found) {
            if (!m_graded || m_graded->record.uid != uid)
                return;
            if (found) {
                m_graded->history = QList<database::AttemptRecord>(found->history.begin(), found->history.end());
                m_graded->standing = found->standing;
                m_window->lessonsPage().setAttemptsLeft(m_graded->record.lessonId, found->attemptsLeft);
                if (m_graded->generation == m_attempt.generation())
                    m_window->setUsedUp(m_school.user.role() == database::Role::Student && found->attemptsLeft == 0);
            } else {
                m_window->showError(found.error(), FailedOperation::KeepingGrades);
            }
            tellKeeping();
        });
}

/// On the score page, and not the work graded last.
bool Application::isOldShown() const
{
    return m_people && m_people->talkedAbout();
}

/// What the score card is about: an old attempt that was opened, or the work graded last.
std::optional<ReportController::Subject> Application::shownCard() const
{
    if (isOldShown())
        return ReportController::Subject{*m_people->talkedAbout(), m_people->nameOfTalkedAbout(), m_school.user,
                                         m_school.service};
    if (!m_graded)
        return {};
    return ReportController::Subject{m_graded->record, QString::fromStdString(m_school.user.fullName()), m_school.user,
                                     m_graded->keeping == Keeping::Kept ? m_school.service : nullptr};
}

/// In an exam nobody looks up what he did before, nor what was said of it.
bool Application::isHiddenByExam()
{
    if (!m_window->isExamRunning())
        return false;
    m_window->stopBusy();
    m_window->showMessage(
        tr("Earlier attempts are not available during an exam. Press G to finish the exam, or start another lesson."));
    return true;
}

/// One that was kept: marked again from its recording, which comes to the same, and shows where and when.
void Application::showAttempt(const database::AttemptRecord& attempt, const core::recording::Recording& recording)
{
    if (isHiddenByExam())
        return;
    const int load = m_loads.begin();
    m_window->showBusy(tr("Preparing the score card …"));
    inBackground(
        this,
        [recording, workOut = surfaceWorker()] {
            workOut(recording.anatomy());  // it may be played next
            return lessons::markAgain(recording);
        },
        [this, load, attempt, recording](const core::Result<lessons::Remarked>& marked) {
            if (!m_loads.isLatest(load))
                return;
            if (!marked) {
                m_window->showError(marked.error(), FailedOperation::Marking);
                m_people->openSheet(attempt);
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
            m_window->showOldScore(
                [lesson = assignment ? assignment->lesson : std::nullopt, tooth = recording.anatomy()] {
                    return lesson ? ui::text::said(lesson->title) : ui::text::toothTitle(*tooth);
                },
                marked->mark.sheet, {attempt}, expectationOf(attempt), work);
            m_opened = recording;
            m_people->talkAbout(attempt);
            m_window->scorePage().setPerson(attempt.person == m_school.user.person() ? QString()
                                                                                     : m_people->nameOfTalkedAbout());
            if (assignment)
                m_openedExplainer.explain(*assignment, recording, work.tooth, marked->conduct);
        });
}

/// One that was kept, without its recording: nothing can be marked again, nor played.
void Application::showSheet(const database::AttemptRecord& attempt, const lessons::ScoreSheet& sheet,
                            const std::function<QString()>& work)
{
    if (isHiddenByExam())
        return;
    m_loads.begin();
    m_window->showOldScore(work, sheet, {attempt}, expectationOf(attempt), {});
    m_opened.reset();
    m_openedExplainer.forget();
    m_people->talkAbout(attempt);
    m_window->scorePage().setPerson(attempt.person == m_school.user.person() ? QString()
                                                                             : m_people->nameOfTalkedAbout());
}

void Application::saveRecording(const QString& path)
{
    const auto recording = m_session.recordingSoFar();
    if (!recording)
        return;
    inBackground(
        this,
        [recording = *recording, path] {
            return core::recording::writeRecording(std::filesystem::path(path.toStdU16String()), recording);
        },
        [this, path](const core::Status& written) {
            if (written)
                m_window->showSaved(path);
            else
                m_window->showError(written.error(), FailedOperation::SavingRecording, path);
        });
}

/// The tooth as it stands, as an ideal for lessons to ask for.
void Application::saveReference(const QString& path)
{
    const auto tooth = m_session.toothSoFar();
    if (!tooth)
        return;
    inBackground(
        this,
        [tooth = *tooth, path] {
            const core::terrain::Tooth* const one = &tooth;
            const auto ideal = core::preparation::capture(
                std::span(&one, 1), {},
                {"an attempt of " + QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()});
            return ideal ? core::preparation::writeCaptured(std::filesystem::path(path.toStdU16String()), *ideal)
                         : core::Status(tl::unexpected(ideal.error()));
        },
        [this, path](const core::Status& written) {
            if (written)
                m_window->showMessage(tr("The reference was saved as %1. A lesson names it, or choose it in the editor "
                                         "of a lesson on this tooth.")
                                          .arg(QDir::toNativeSeparators(path)));
            else
                m_window->showError(written.error(), FailedOperation::SavingReference, path);
        });
}

void Application::openRecording(const QString& path)
{
    readRecording(path, [this](const core::recording::Recording& recording) { play(recording); });
}

/// Beside the attempt that is played.
void Application::openBeside(const QString& path)
{
    readRecording(path, [this, path](const core::recording::Recording& recording) {
        putBeside(recording, QFileInfo(path).completeBaseName(), path);
    });
}

/// @param path  of the recording, where it is a file's
void Application::putBeside(const core::recording::Recording& recording, const QString& name, const QString& path)
{
    if (!m_replay)
        return;
    if (const auto put = m_replay->putBeside(recording, name); !put)
        refuse(put.error(), FailedOperation::OpeningRecording, path);
}

/// At the lesson of the attempt that is played, or of the work on the table.
void Application::openExpert()
{
    if (!m_replay) {
        if (m_attempt.assignment().lesson)
            openExpertAt(m_attempt.assignment());
        return;
    }
    if (!m_replay->attempt().lesson())
        return;
    const int load = m_loads.begin();
    m_window->showBusy(tr("Preparing the lesson …"));
    inBackground(
        this,
        [anatomy = m_replayed, lesson = m_replay->attempt().lesson()->json] { return playedFor(anatomy, lesson); },
        [this, load](const core::Result<lessons::Assignment>& assignment) {
            if (!m_loads.isLatest(load))
                return;
            if (!assignment)
                refuse(assignment.error(), FailedOperation::OpeningLesson, {});
            else if (m_replay)
                openExpertAt(*assignment);
            else
                m_window->stopBusy();
        });
}

/// The one that the lesson names, or if it names none, what a simulated hand makes of it.
void Application::openExpertAt(const lessons::Assignment& assignment)
{
    if (!assignment.lesson->expert) {
        openDemonstration(assignment);
        return;
    }
    const QString path = QString::fromStdString(assignment.lesson->expert->file);
    readRecording(
        path,
        [this, path](const core::recording::Recording& recording) { showExpert(recording, tr("The expert"), path); },
        [assignment] { return lessons::readExpert(assignment); });
}

void Application::openDemonstration(const lessons::Assignment& assignment)
{
    const int load = m_loads.begin();
    m_window->showBusy(tr("A simulated hand does the lesson …"));
    inBackground(
        this,
        [assignment, workOut = surfaceWorker()]() -> std::optional<core::recording::Recording> {
            const auto outcome = demonstrate(assignment, false);
            workOut(assignment.anatomy);
            const auto marked = outcome ? lessons::markAgain(*outcome->recording)
                                        : core::Result<lessons::Remarked>(tl::unexpected(outcome.error()));
            return marked && marked->mark.sheet.passed() ? outcome->recording : std::nullopt;
        },
        [this, load](const std::optional<core::recording::Recording>& recording) {
            if (!m_loads.isLatest(load))
                return;
            if (recording)
                showExpert(*recording, tr("The simulated hand"), {});
            else
                m_window->stopBusy();
            m_window->showMessage(
                recording ? tr("No teacher has recorded this lesson, so a simulated hand shows it.")
                          : tr("No teacher has recorded this lesson, and the simulated hand cannot do it."));
        });
}

/// By itself, or beside the attempt that is played.
void Application::showExpert(const core::recording::Recording& recording, const QString& name, const QString& path)
{
    if (m_replay)
        putBeside(recording, name, path);
    else
        play(recording);
}

void Application::readRecording(const QString& path, const UseRecording& use)
{
    readRecording(path, use,
                  [path] { return core::recording::readRecording(std::filesystem::path(path.toStdU16String())); });
}

void Application::readRecording(const QString& path, const UseRecording& use, const ReadRecording& read)
{
    const int load = m_loads.begin();
    m_window->showBusy(tr("Reading %1 …").arg(QFileInfo(path).fileName()));
    inBackground(
        this,
        [read, workOut = surfaceWorker()] {
            auto recording = read();
            if (recording)
                workOut(recording->anatomy());
            return recording;
        },
        [this, load, path, use](const core::Result<core::recording::Recording>& recording) {
            if (!m_loads.isLatest(load))
                return;
            if (recording)
                use(*recording);
            else
                refuse(recording.error(), FailedOperation::OpeningRecording, path);
        });
}

/// From now on the attempt of who works here reaches the disk while it goes on; and what he did not finish last time is
/// offered. What a simulated hand drills is nobody's work.
void Application::keepJournal()
{
    if (m_devices->isSimulated())
        return;
    stopJournal(m_journal != nullptr && !m_school.user.isGuest());
    m_journal = std::make_unique<core::session::JournalLoop>(m_session, journalFolder(m_stationFolder, m_school.user));
    if (m_tried)
        m_journal->leaveOut(m_attempt.generation());
    m_journalThread =
        std::make_unique<LoopThread>(*m_journal, core::session::JournalLoop::kPeriod, LoopThread::Urgency::Normal);
    m_syncThread = std::make_unique<LoopThread>(m_journal->syncing(), core::session::JournalLoop::kSyncRest,
                                                LoopThread::Urgency::Normal);
    m_journalThread->start();
    m_syncThread->start();
    m_journalWatch.start();
    offerUnfinished();
}

/// @param putAway  the attempt is given up; else it stays to be found
void Application::stopJournal(bool putAway)
{
    m_journalWatch.stop();
    m_lookAgain.stop();
    m_syncThread.reset();
    m_journalThread.reset();
    if (m_journal && putAway)
        m_journal->putAway();
    m_journal.reset();
    m_window->forgetAttemptNotKept();
    m_unfinished.reset();
}

void Application::watchJournal()
{
    if (const auto failure = m_journal->failure())
        m_window->showError(*failure,
                            m_window->isExamRunning() ? FailedOperation::KeepingExam : FailedOperation::KeepingAttempt);
    else if (m_journal->isWell())
        m_window->forgetAttemptNotKept();
}

/// Where a student has no attempt left it could not be gone on with, and what the school has already is finished.
/// Nobody waits for a server that does not answer; what only its answer decides is looked for again.
void Application::offerUnfinished()
{
    if (!m_school.service || m_school.user.isGuest()) {
        lookForUnfinished({{}, std::set<std::string>()});
        return;
    }
    const auto isDecided = std::make_shared<bool>(false);
    m_school.service->ask(
        this, [who = m_school.user](const DatabaseContext& school) { return knownAttempts(school, who); },
        [this, isDecided, who = m_school.user](const core::Result<KnownAttempts>& known) {
            if (!std::exchange(*isDecided, true) && m_school.user == who)
                lookForUnfinished(known.value_or(KnownAttempts()));
        });
    QTimer::singleShot(kLongestCheckMs, this, [this, isDecided, who = m_school.user] {
        if (!std::exchange(*isDecided, true) && m_school.user == who)
            lookForUnfinished({});
    });
}

/// Offers the newest attempt that was not finished; of one that cannot be read it is told.
void Application::lookForUnfinished(const KnownAttempts& known)
{
    inBackground(
        this,
        [folder = journalFolder(m_stationFolder, m_school.user), outbox = QDir(m_stationFolder).filePath("outbox"),
         known, toBeKept = m_letters ? m_letters->journals() : std::set<std::filesystem::path>()] {
            return findUnfinished(folder, outbox, known, toBeKept);
        },
        [this, who = m_school.user](FoundUnfinished& found) {
            if (m_school.user != who)  // the search was for somebody who has left
                return;
            if (found.failure)
                m_window->showError(*found.failure, FailedOperation::ResumingAttempt);
            if (!found.attempt && m_unfinished)  // another search found it, and holds it
                return;
            m_unfinished = std::move(found.attempt);
            if (found.isUndecided && !m_unfinished)
                m_lookAgain.start();
            m_seenOfUnfinished = found.seen;
            tellUnfinished();
        });
}

/// By the name of its lesson, or of the tooth that was practised on.
void Application::tellUnfinished()
{
    if (!m_unfinished)
        return;
    const core::recording::Recording& recording = m_unfinished->recording;
    const auto given = m_lessonsRead.given.find(limitedLessonOf(recording));
    if (given != m_lessonsRead.given.end() && given->second.attemptsLeft == 0) {
        m_window->forgetUnfinished();
        return;
    }
    const lessons::ReadLesson read =
        lessons::readLessonText(QByteArray::fromStdString(recording.lesson()), QStringLiteral("lesson"));
    m_window->offerUnfinished(
        [read, anatomy = recording.anatomy()] {
            return read.lesson ? ui::text::said(read.lesson->title) : ui::text::toothTitle(*anatomy);
        },
        QDateTime::fromMSecsSinceEpoch(m_unfinished->begunUtcMs), read.lesson && read.lesson->exam);
}

void Application::resumeUnfinished()
{
    if (!m_unfinished)
        return;
    const int load = m_loads.begin();
    m_window->showBusy(tr("Resuming the attempt …"));
    if (const std::string lesson = limitedLessonOf(m_unfinished->recording); !lesson.empty())
        whereAllowed(
            lesson, [this, load] { rebuildUnfinished(load); },
            [this] {
                // The list of lessons may be read after this, and would offer the attempt again.
                m_unfinished.reset();
                m_window->forgetUnfinished();
            });
    else
        rebuildUnfinished(load);
}

void Application::rebuildUnfinished(int load)
{
    if (!m_unfinished)
        return;
    inBackground(
        this,
        [recording = m_unfinished->recording, workOut = surfaceWorker()] {
            workOut(recording.anatomy());
            return core::session::rebuild(recording);
        },
        [this, load,
         path = m_unfinished->path](core::Result<std::unique_ptr<core::session::ResumableAttempt>>& attempt) {
            if (!m_loads.isLatest(load) || !m_unfinished || m_unfinished->path != path)  // another is offered by now
                return;
            if (attempt)
                takeUp(std::move(*attempt));
            else
                m_window->showError(attempt.error(), FailedOperation::ResumingAttempt);
        });
}

void Application::takeUp(std::unique_ptr<core::session::ResumableAttempt> attempt)
{
    const auto assignment = lessons::assignmentOf(attempt->recording.anatomy(), attempt->recording.lesson());
    if (!assignment) {
        m_window->showError(assignment.error(), FailedOperation::ResumingAttempt);
        return;
    }
    if (!m_window->canSend(kCommandsOfATooth))
        return;  // it is still offered
    lay(*assignment, attempt->recording.settings(), {}, false);
    m_tried.reset();
    const core::settings::FeelPreset felt =
        core::settings::feltAs(m_presets.inUse(), m_attempt.settings().hardness, m_attempt.settings().force,
                               assignment->lesson ? assignment->lesson->kind : core::settings::ToothKind{});
    m_window->showFeel(felt, felt);
    m_attempt.resume(attempt->recording.ticks(), std::exchange(m_seenOfUnfinished, {}));
    const double recordedS = std::chrono::duration<double>(attempt->recording.duration()).count();
    double workedS = recordedS - attempt->restedS;
    // An exam's time goes on while its student is away, for whatever reason: he could think as long as he likes.
    if (assignment->lesson && assignment->lesson->exam)
        workedS = std::max(
            workedS, static_cast<double>(QDateTime::currentMSecsSinceEpoch() - m_unfinished->begunUtcMs) / kMsPerS);
    m_window->resumeClock(recordedS, workedS);
    m_journal->takeUp(m_attempt.generation(), std::move(*m_unfinished));
    m_unfinished.reset();
    m_window->forgetUnfinished();  // it is offered again where the list of lessons was read meanwhile
    const auto [bur, handpiece] = std::pair(attempt->bur, attempt->handpiece);
    m_window->send(core::session::ResumeAttempt{std::move(attempt), m_attempt.generation()});
    m_window->takeInHand(bur, handpiece);
    if (m_attempt.seenBefore()) {
        m_window->endExam();
        gradeTakenUp(0);
        return;
    }
    const bool hasLimit = m_attempt.settings().force.workAreaMm > 0.0;
    m_window->showMessage(m_devices->isForceChosen() && !hasLimit
                              ? tr("Your attempt continues where you stopped. It was begun with the mouse: the device "
                                   "has no soft limit at the end of its reach in this attempt.")
                              : tr("Your attempt continues where you stopped."));
}

/// An exam whose score was seen, and was kept nowhere: nothing is cut any more. Once the session has it.
void Application::gradeTakenUp(int looks)
{
    if (m_session.recordedGeneration() == m_attempt.generation() && m_session.toothSoFar()) {
        grade();
        return;
    }
    if (looks < kMostTakeUpLooks)
        QTimer::singleShot(kSettleMs, this, [this, looks, generation = m_attempt.generation()] {
            if (generation == m_attempt.generation())
                gradeTakenUp(looks + 1);
        });
}

/// It is kept for a week, in case the student thinks better of it. Others may be waiting.
void Application::discardUnfinished()
{
    if (m_unfinished)
        if (const auto kept = core::recording::discardJournal(m_unfinished->path))
            m_window->offerToBringBack([this, kept = *kept] {
                if (core::recording::bringBackJournal(kept))
                    offerUnfinished();
                else
                    m_window->showMessage(tr("The attempt is no longer there."));
            });
    m_unfinished.reset();
    offerUnfinished();
}

/// The student's own attempt stays in the two loops, which rest meanwhile.
bool Application::play(const core::recording::Recording& recording, std::optional<double> momentS, const QString& whose)
{
    // The button for the guidance is there while the hand in use has a force.
    auto replay = ReplayController::make(recording, m_links, *m_window, m_generation + 1, &m_bur);
    if (!replay) {
        refuse(replay.error(), FailedOperation::OpeningRecording, {});
        return false;
    }
    if (m_replay) {
        putReplayAway();
    } else {
        stopLoops();
        m_handAtRest = m_links.servo.latest();
        m_window->view().storeCamera();
    }
    ++m_generation;
    m_replay = std::move(*replay);
    m_replayed = recording.anatomy();
    m_window->setReplaying(true, m_replay->attempt().lengthS(), m_replay->attempt().ideal(),
                           m_replay->attempt().lesson(), whose);
    m_window->setHandpieces(recording.settings().handpieces);
    m_window->showTooth(m_replayed, m_generation, {});
    if (!m_options.picture.isEmpty())
        m_replay->goToEnd();
    if (momentS)
        m_replay->playTo(*momentS);
    m_replay->start();
    return true;
}

void Application::showMoment(double seconds)
{
    if (m_opened)
        playOpened(seconds);
    else if (m_graded && !m_replay && !isOldShown()) {
        if (!play(m_graded->recording, seconds))
            return;
        m_playedFrom = PlayedFrom::ScoreCard;
        if (m_people)
            m_people->followReplay(m_graded->record);
    }
}

/// The attempt whose score card is open; the way back leads there.
void Application::playOpened(std::optional<double> momentS)
{
    if (!play(*m_opened, momentS, m_people->whoseIsTalkedAbout()))
        return;
    m_playedFrom = PlayedFrom::ScoreCard;
    m_people->followReplay(m_people->talkedAbout());
}

/// Waits until the tooth is there and drawn as it ended, saves the picture and quits.
void Application::drawPicture()
{
    if (m_attempt.assignment().anatomy || m_replay)
        ++m_pictureLooks;
    if (m_pictureLooks < kPictureFrames) {
        QTimer::singleShot(kPictureDelayMs, this, &Application::drawPicture);
        return;
    }
    if (!m_window->view().isUsable())
        endWith({core::ErrorCode::FileUnwritable, "the picture could not be drawn, because this display has no OpenGL "
                                                  "3.3; use another display or xvfb-run"});
    else if (!m_window->view().picture().save(m_options.picture))
        endWith({core::ErrorCode::FileUnwritable, "the picture could not be written to " +
                                                      m_options.picture.toStdString() +
                                                      "; check the folder and that the name ends in .png"});
    else
        QCoreApplication::exit(EXIT_SUCCESS);
}

/// Afterwards nobody writes what the window reads, until loops start again.
void Application::putReplayAway()
{
    m_playedFrom = PlayedFrom::Elsewhere;
    if (m_people)
        m_people->followReplay({});
    m_replay.reset();
}

/// Back to the student's own work as it was left. Who has none gets the tooth of the recording, whole.
void Application::stopReplay()
{
    if (!m_replay)
        return;
    const PlayedFrom from = m_playedFrom;
    const auto goBack = [this, from] {
        if (from == PlayedFrom::ScoreCard && (m_opened || m_graded))
            m_window->backToScore();
        else if (from == PlayedFrom::Attempts)
            m_window->backToHistory();
        else
            return false;
        return true;
    };
    if (!m_attempt.assignment().anatomy) {
        if (const auto practice = lessons::practiceOn(m_replayed)) {
            begin(*practice, {}, false);
            m_window->showMessage(tr("The tooth is intact. You can start drilling."));
        }
        static_cast<void>(goBack());
        return;
    }
    putReplayAway();
    m_window->setReplaying(false);
    m_window->setHandpieces(m_attempt.settings().handpieces);
    m_links.servo.back() = m_handAtRest;
    m_links.servo.publish();
    for (core::servo::TilePatch late; m_links.patches.tryPop(late);) {
    }
    m_window->showTooth(m_attempt.assignment().anatomy, m_attempt.generation(), {});
    m_window->view().restoreCamera();
    // A tooth that was taken a moment before the replay may still be on its way to the session.
    if (const auto own = m_session.toothSoFar(); own && own->anatomy == m_attempt.assignment().anatomy)
        m_window->view().setHeights(own->top);
    startLoops();
    if (!goBack())
        m_window->showMessage(tr("You are back in your own work."));
}

}  // namespace app
