// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Application.h"

#include <utility>

#include <QCoreApplication>
#include <QThreadPool>

#include "app/attempt/FeltSettings.h"
#include "app/devices/PenSetup.h"
#include "core/servo/ServoParameters.h"
#include "ui/devices/DevicesPage.h"
#include "ui/text/LessonTexts.h"

namespace app {
namespace {

using ui::window::MainWindow;

constexpr double kStiffnessNPerMm = core::contact::ForceSettings{}.stiffnessNPerMm;
constexpr double kServoPeriodS = std::chrono::duration<double>(SessionThreads::kServoPeriod).count();

/// Whether the simulated hand was asked for.
bool isSimulated(const WindowOptions& options)
{
    return options.device == QLatin1String(ui::devices::kSimulated);
}

}  // namespace

core::Result<std::unique_ptr<Application>> Application::make(const WindowOptions& options)
{
    auto tick = core::servo::makeServoTick(settingsFor(isSimulated(options)));
    if (!tick)
        return tl::unexpected(tick.error());
    return std::unique_ptr<Application>(new Application(options, std::move(*tick)));
}

Application::Application(const WindowOptions& options, std::unique_ptr<core::servo::ServoTick> tick)
    : m_options(options), m_pointer(m_channels.pointer, kStiffnessNPerMm, kServoPeriodS),
      m_simulatedFalcon(m_simulatedInput, kStiffnessNPerMm, kServoPeriodS),
      m_bur(isSimulated(options) ? static_cast<haptics::HapticDevice&>(m_simulatedFalcon) : m_pointer,
            SessionThreads::kServoPeriod),
      m_servo(m_bur, std::move(tick), m_servoChannels, m_channels.servo, SessionThreads::kServoPeriod),
      m_session(m_servoChannels, m_channels, settingsFor(isSimulated(options))), m_assessment(m_session),
      m_window(std::make_unique<MainWindow>(m_channels)), m_threads(m_servo, m_session, m_assessment, m_channels),
      m_presets(*m_window, [this] { return m_school.user; }),
      m_devices(std::make_unique<DeviceController>(
          *m_window, DeviceController::Hands{m_bur, m_pointer, m_simulatedFalcon}, options.devices, options.device)),
      m_headTracking(std::make_unique<HeadTrackingController>(*m_window)),
      m_pedals(std::make_unique<PedalController>(*m_window, m_bur, [this] { return m_devices->isSimulated(); })),
      m_sound(std::make_unique<SoundController>(*m_window, m_channels.sound, options.audioPort)),
      m_limit(m_school, m_loads),
      m_lessons(*m_window, m_school), m_context{*m_window, m_channels, m_session, m_assessment, *m_devices,
                                                m_presets, m_attempt,  m_loads,   m_limit,      m_school},
      m_attempts(m_context, options.build, !options.picture.isEmpty()),
      m_simulatedHand(m_context, m_attempts, m_simulatedInput),
      m_resume(m_context, m_attempts, m_lessons, options.retry), m_observer(m_context, m_attempts, m_resume),
      m_opened(m_context, m_attempts), m_grading(m_context, {m_attempts, m_resume, m_observer, m_opened}),
      m_playback(m_context, {m_servo, *m_sound, m_bur, m_attempts, m_opened, m_grading}, !options.picture.isEmpty()),
      m_data(*m_window, m_school, {options.database, options.opening, options.retry, options.asksWho}),
      m_login(m_context, {m_school, m_data, m_lessons, m_attempts, m_resume, m_grading}, options.loginPatience),
      m_reports(*m_window, [this] { return m_opened.isShown() ? m_opened.subject() : m_grading.subject(); })
{
    m_data.setParent(this);
    connectControllers();
    connectPen(*m_window);
    if (options.showsRound) {
        m_tour = std::make_unique<TourController>(*m_window);
        m_login.setTour(m_tour.get());
    }
    static_cast<void>(m_channels.commands.tryPush(core::servo::SetBur{1}));
    static_cast<void>(m_channels.commands.tryPush(core::servo::SetDrill{true}));
    m_servo.publishSound(m_channels.sound);
    m_threads.start();
}

Application::~Application()
{
    m_admin.reset();
    // A load still under way would come back to nobody.
    QThreadPool::globalInstance()->waitForDone();
    m_threads.stop();
    m_playback.stop();
    m_sound.reset();
    m_pedals.reset();
    m_headTracking.reset();
    m_devices.reset();
    // The window has asked about unsaved work before it let itself be closed.
    m_resume.stopJournal(true);
    m_tour.reset();
    m_history.reset();
    m_data.close();
}

void Application::connectControllers()
{
    connect(&m_limit, &AttemptLimit::usedUp, this, [this] {
        m_window->stopBusy();
        m_window->showMessage(ui::text::usedUpWords());
    });
    connect(&m_attempts, &AttemptController::cannotGoOn, this, &Application::endWith);
    connect(&m_login, &LoginController::left, this, [this] {
        if (m_history)
            m_history->forget();
    });
    m_simulatedHand.setLead([this] { return m_playback.leadMm(); });
}

void Application::show()
{
    m_window->show();
    if (m_options.picture.isEmpty()) {
        openDatabase();
        if (!m_options.asksWho)
            m_resume.startJournal();
    } else {
        m_picture = std::make_unique<PictureWriter>(*m_window, m_options.picture,
                                                    [this] { return m_attempt.hasTooth() || m_attempt.isResting(); });
        connect(m_picture.get(), &PictureWriter::saved, this, [] { QCoreApplication::exit(EXIT_SUCCESS); });
        connect(m_picture.get(), &PictureWriter::failed, this, &Application::endWith);
        m_picture->start();
    }
    if (m_options.recording.isEmpty())
        m_attempts.openTooth(m_options.source);
    else
        m_playback.openRecording(m_options.recording);
}

/// Starts the service of the database, and the controllers that need one.
void Application::openDatabase()
{
    if (!m_data.openDatabase())
        return;
    m_resume.setStationFolder(m_data.stationFolder());
    m_resume.setUploader(m_data.uploader());
    m_grading.setUploader(m_data.uploader());
    m_observer.setUploader(m_data.uploader());
    connect(m_data.service(), &SchoolService::delivered, this, [this](const QString& uid) {
        m_grading.handleDelivered(uid.toStdString());
        m_window->readAttemptsAgain();
    });
    m_admin = std::make_unique<AdminController>(
        *m_window, *m_data.service(),
        AdminController::Place{m_data.address(), m_data.stationFolder(),
                               [this] { return m_window->devicesPage().handName(m_devices->hand()); },
                               1.0 / kServoPeriodS},
        [this] { return m_school.user; });
    connect(m_admin.get(), &AdminController::restoreRequested, &m_login, &LoginController::leaveToRestore);
    connect(m_admin.get(), &AdminController::idleMinutesChanged, this,
            [this](int minutes) { m_window->account().idleLock().setLimit(std::chrono::minutes(minutes)); });
    m_history =
        std::make_unique<AttemptHistoryController>(*m_window, *m_data.service(), [this] { return m_school.user; });
    m_opened.setHistory(m_history.get());
    m_playback.setHistory(m_history.get());
    m_login.connectService();
    m_data.openSchool();
    if (m_options.asksWho)
        m_window->account().askLogin();
}

/// Ends the program, whose caller reports the error.
void Application::endWith(const core::Error& error)
{
    m_endedBy = error;
    QCoreApplication::exit(EXIT_FAILURE);
}

}  // namespace app
