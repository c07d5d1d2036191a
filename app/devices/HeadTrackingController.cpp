// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/HeadTrackingController.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include <QDesktopServices>
#include <QFileInfo>
#include <QThreadPool>
#include <QUrl>

#include "app/devices/CameraCalibration.h"
#include "app/devices/HeadTrackingStore.h"
#include "core/base/WholeFile.h"
#include "core/tracking/PictureSource.h"
#include "core/tracking/TagCells.h"
#include "core/tracking/TagDetector.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/HeadTrackingCard.h"
#include "ui/devices/TagSheet.h"
#include "ui/kit/Actions.h"
#include "ui/kit/FileDialog.h"
#include "ui/kit/MessageBar.h"
#include "ui/text/ValidationTexts.h"
#include "ui/tooth/ToothView.h"

namespace app {
namespace {

using core::tracking::Head;
using core::tracking::Lean;
using core::tracking::TrackerStage;
using ui::devices::DevicesPage;
using ui::devices::HeadTrackingCard;
using ui::devices::HeadTrackingSettings;
using ui::kit::MessageBar;

constexpr int kShowMs = 40;
constexpr int kTagWatchMs = 500;
constexpr int kMissedAfter = 10;        ///< checks in a row without the tag after which a message is shown
constexpr int kCamerasEvery = 25;       ///< polls between two searches for cameras
constexpr double kToTheScreenS = 0.02;  ///< time from drawing a frame until the screen shows it
constexpr std::chrono::milliseconds kTrackerBeat{10};

core::tracking::TrackerLoop::Open sourceOf(const HeadTrackingSettings& settings)
{
    const QFileInfo file(settings.video);
    if (!settings.video.isEmpty() && file.isDir())
        return [path = settings.video.toStdString()] { return core::tracking::openFolder(path); };
    // Reading a pipe blocks until another program writes to it, and the window would wait for the blocked thread.
    if (!settings.video.isEmpty() && file.exists() && !file.isFile())
        return [path = settings.video.toStdString()]() -> core::Result<std::unique_ptr<core::tracking::PictureSource>> {
            return core::unexpected(
                core::ErrorCode::WrongKind,
                core::LocalizableText{"%1 is no video, or of a kind that cannot be read here.", {core::noted(path)}});
        };
    if (!settings.video.isEmpty())
        return [path = settings.video.toStdString()] { return core::tracking::openVideo(path); };
    const core::tracking::CameraWish wish{settings.width, settings.height, static_cast<double>(settings.hz)};
    return [number = settings.camera, wish] { return core::tracking::openCamera(number, wish); };
}

core::tracking::TrackerSettings trackerSettings(const HeadTrackingSettings& settings,
                                                const std::optional<core::tracking::CameraModel>& calibration)
{
    core::tracking::TrackerSettings wanted;
    wanted.id = settings.tagId;
    wanted.tagMm = settings.tagMm;
    wanted.fovDeg = settings.fovDeg;
    wanted.calibration = calibration;
    return wanted;
}

/// Returns whether the tracker must be restarted to change its settings from `a` to `b`.
bool concernsTracker(const HeadTrackingSettings& a, const HeadTrackingSettings& b)
{
    HeadTrackingSettings same = b;
    same.gain = a.gain;
    same.mirrored = a.mirrored;
    same.isWindow = a.isWindow;
    return !(a == same);
}

double secondsNow()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

HeadTrackingController::Tracker::Tracker(core::tracking::TrackerLoop::Open open,
                                         const core::tracking::TrackerSettings& settings)
    : loop(std::move(open), settings), thread(loop, kTrackerBeat, LoopThread::Urgency::Normal)
{
    // The tracker must not take time from the servo and the view.
    thread.start(QThread::LowPriority);
}

HeadTrackingController::HeadTrackingController(ui::window::MainWindow& window)
    : m_window(window), m_settings(storedHeadTracking())
{
    HeadTrackingCard& card = m_window.devicesPage().headTracking();
    card.setInBuild(core::tracking::hasTagDetector());
    m_settings.isOn = m_settings.isOn && core::tracking::hasTagDetector();
    readCalibration();
    showSettings();
    connectPage();
    m_poll.setInterval(kShowMs);
    connect(&m_poll, &QTimer::timeout, this, &HeadTrackingController::poll);
    m_watch.setInterval(kTagWatchMs);
    connect(&m_watch, &QTimer::timeout, this, &HeadTrackingController::watch);
    connect(m_window.actions().recentreHead, &QAction::triggered, this, [this] { m_view.recentre(); });
    restart();
}

HeadTrackingController::~HeadTrackingController()
{
    m_window.view().setHeadLean({});
}

void HeadTrackingController::connectPage()
{
    DevicesPage& page = m_window.devicesPage();
    const HeadTrackingCard* const card = &page.headTracking();
    connect(&page, &DevicesPage::opened, this, [this](bool isOpen) {
        m_isPageOpen = isOpen;
        m_polls = 0;
        if (isOpen)
            m_poll.start();
        else
            m_poll.stop();
        if (m_tracker)
            m_tracker->loop.showPictures(isOpen);
    });
    connect(card, &HeadTrackingCard::trackingChanged, this, &HeadTrackingController::turn);
    connect(card, &HeadTrackingCard::settingsChanged, this, &HeadTrackingController::change);
    connect(card, &HeadTrackingCard::recentreRequested, this, [this] { m_view.recentre(); });
    connect(card, &HeadTrackingCard::fieldOfViewRequested, this, &HeadTrackingController::measureFieldOfView);
    connect(card, &HeadTrackingCard::printRequested, this, &HeadTrackingController::askWhereToPrint);
}

void HeadTrackingController::turn(bool on)
{
    HeadTrackingSettings settings = m_settings;
    settings.isOn = on;
    change(settings);
}

void HeadTrackingController::change(const HeadTrackingSettings& settings)
{
    const bool isNew = concernsTracker(m_settings, settings);
    const bool isOtherSource = m_settings.camera != settings.camera || m_settings.video != settings.video;
    const bool isOtherLens = m_settings.fovDeg != settings.fovDeg || m_settings.calibration != settings.calibration;
    m_settings = settings;
    if (isOtherSource && !isOtherLens)
        recallLens(m_settings);
    readCalibration();
    storeHeadTracking(m_settings);
    showSettings();
    if (isNew)
        restart();
}

/// Reads the calibration file of the settings. If it cannot be used, shows a message and uses the field of view.
void HeadTrackingController::readCalibration()
{
    m_calibration.reset();
    if (m_settings.calibration.isEmpty())
        return;
    auto read = readCameraCalibration(m_settings.calibration);
    if (read) {
        m_calibration = *read;
        m_settings.fovDeg = std::clamp(std::round(read->fieldOfViewDeg()), HeadTrackingSettings::kLeastFovDeg,
                                       HeadTrackingSettings::kMostFovDeg);
        return;
    }
    m_window.messages().say([name = QFileInfo(m_settings.calibration).fileName(), error = read.error()] {
        return MessageBar::Message{MessageBar::Kind::Warning,
                                   //: %1: the name of a file
                                   tr("The calibration %1 cannot be used. The field of view counts.").arg(name),
                                   ui::text::faultWords(core::wordsOf(error)),
                                   {},
                                   {},
                                   MessageBar::Topic::Page};
    });
    m_settings.calibration.clear();
}

void HeadTrackingController::showSettings()
{
    m_window.devicesPage().headTracking().setSettings(m_settings);
    core::tracking::HeadViewSettings view;
    view.gain = m_settings.gain;
    view.isWindow = m_settings.isWindow;
    m_view.setSettings(view);
}

/// Computes the field of view of the camera from the size at which it sees the tag now, which the user holds at a
/// distance of HeadTrackingSettings::kMeasuredMm. Saves it in the settings.
void HeadTrackingController::measureFieldOfView()
{
    if (!m_tracker)
        return;
    const core::tracking::TrackerReport report = m_tracker->loop.report();
    const core::tracking::Picture& picture = report.picture;
    auto camera = core::tracking::CameraModel::withFieldOfView(picture.width, picture.height, m_settings.fovDeg);
    const auto focalPx = report.stage == TrackerStage::Tracking && picture.width > 0
                             ? camera.focalAt(report.tag.pose.positionMm, HeadTrackingSettings::kMeasuredMm)
                             : std::nullopt;
    if (focalPx)
        camera.focalPx = glm::dvec2(*focalPx);
    const double fovDeg = camera.fieldOfViewDeg();
    if (!focalPx || fovDeg < HeadTrackingSettings::kLeastFovDeg || fovDeg > HeadTrackingSettings::kMostFovDeg) {
        m_window.messages().say([] {
            return MessageBar::Message{MessageBar::Kind::Warning,
                                       tr("The field of view could not be measured. Hold the tag still at this "
                                          "distance, and check the edge of "
                                          "its black square."),
                                       {},
                                       {},
                                       {},
                                       MessageBar::Topic::Page};
        });
        return;
    }
    HeadTrackingSettings settings = m_settings;
    settings.fovDeg = std::round(fovDeg);
    change(settings);
    m_window.messages().say([degrees = settings.fovDeg] {
        return MessageBar::Message{MessageBar::Kind::News,
                                   //: %1: a number of degrees
                                   tr("The field of view is %1°. It is stored for this camera.").arg(degrees),
                                   {},
                                   {},
                                   {},
                                   MessageBar::Topic::Page};
    });
}

void HeadTrackingController::askWhereToPrint()
{
    auto* dialog = new ui::kit::FileDialog(&m_window, tr("Print the tag"), {}, tr("PDF document (*.pdf)"));
    dialog->askWhere(QStringLiteral("cusp-tag"), QStringLiteral("pdf"));
    connect(dialog, &QFileDialog::fileSelected, this, &HeadTrackingController::print);
    dialog->open();
}

/// Writes the sheet with the tag as a PDF and opens it.
void HeadTrackingController::print(const QString& path)
{
    const QByteArray bytes = ui::devices::TagSheet(m_settings.tagId, core::tracking::cellsOf(m_settings.tagId)).pdf();
    const auto written =
        core::writeWhole(path.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())}, "The sheet");
    if (!written) {
        m_window.messages().say([error = written.error()] {
            return MessageBar::Message{MessageBar::Kind::Error,
                                       tr("The sheet could not be written."),
                                       ui::text::faultWords(core::wordsOf(error)),
                                       {},
                                       {},
                                       MessageBar::Topic::Page};
        });
        return;
    }
    QDesktopServices::openUrl(QUrl::fromLocalFile(path));
    m_window.messages().say([path] {
        return MessageBar::Message{MessageBar::Kind::News,
                                   //: %1: a path
                                   tr("The sheet is in %1. Print it without scaling.").arg(path),
                                   {},
                                   {},
                                   {},
                                   MessageBar::Topic::Page};
    });
}

void HeadTrackingController::restart()
{
    m_watch.stop();
    // The tracker's thread can wait two seconds for a camera that has just stopped sending. A pool thread waits for it,
    // so that the window does not.
    if (m_tracker && !m_settings.isOn)
        QThreadPool::globalInstance()->start([ended = std::shared_ptr<Tracker>(std::move(m_tracker))] {});
    m_tracker.reset();
    m_withoutTag = 0;
    m_said = TrackerStage::Opening;
    m_window.messages().withdraw(MessageBar::Topic::Head);
    m_view.recentre();
    m_window.actions().recentreHead->setVisible(m_settings.isOn);
    if (!m_settings.isOn)
        return;  // leanNow() moves the view back smoothly
    m_tracker = std::make_unique<Tracker>(sourceOf(m_settings), trackerSettings(m_settings, m_calibration));
    m_watch.start();
    m_tracker->loop.showPictures(m_isPageOpen);
    m_window.view().setHeadLean([this](double seconds, bool touches) { return leanNow(seconds, touches); });
}

Lean HeadTrackingController::leanNow(double seconds, bool touches)
{
    return m_view.update(m_tracker ? m_tracker->loop.head() : Head{}, secondsNow() + kToTheScreenS, seconds, touches);
}

/// Shows a message, once, when the camera is lost or the tag has not been seen for a while. Does nothing while the page
/// of devices is open.
void HeadTrackingController::watch()
{
    const TrackerStage stage = m_tracker->loop.report().stage;
    m_withoutTag = stage == TrackerStage::NoTag ? m_withoutTag + 1 : 0;
    if (stage == m_said || m_isPageOpen || (stage == TrackerStage::NoTag && m_withoutTag < kMissedAfter))
        return;
    m_said = stage;
    m_window.messages().withdraw(MessageBar::Topic::Head);
    if (stage == TrackerStage::NoCamera || stage == TrackerStage::NoTag)
        say(m_tracker->loop.report());
}

void HeadTrackingController::say(const core::tracking::TrackerReport& report)
{
    m_window.messages().say([this, report] {
        MessageBar::Message message;
        message.kind = report.stage == TrackerStage::NoCamera ? MessageBar::Kind::Warning : MessageBar::Kind::News;
        message.sentence = report.stage == TrackerStage::NoCamera
                               ? tr("The view does not follow your head: the camera gives no pictures.")
                               : tr("The view does not follow your head: the tag is not seen.");
        message.actionText = tr("Show the device");
        message.action = [this] { m_window.actions().devices->trigger(); };
        message.topic = MessageBar::Topic::Head;
        return message;
    });
}

void HeadTrackingController::poll()
{
    HeadTrackingCard& card = m_window.devicesPage().headTracking();
    if (m_polls++ % kCamerasEvery == 0)
        card.setCameras(core::tracking::cameras());
    if (m_tracker)
        card.setTracking(m_tracker->loop.report());
}

}  // namespace app
