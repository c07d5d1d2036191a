// SPDX-License-Identifier: GPL-3.0-or-later
// Head tracking in the whole program, with a video in place of the camera.
#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "app/devices/CameraCalibration.h"
#include "tests/app/PrintedScene.h"
#include "tests/app/ProgramWindow.h"
#include "tests/support/OpenGlMain.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/HandList.h"
#include "ui/devices/HeadTrackingCard.h"
#include "ui/kit/AppSettings.h"
#include "ui/tooth/ToothView.h"

using core::tracking::Picture;
using core::tracking::TrackerStage;
using ui::devices::HeadTrackingCard;
using ui::devices::HeadTrackingSettings;

namespace {

constexpr int kWide = 320;
constexpr int kHigh = 240;
constexpr int kTagId = 7;
constexpr int kHz = 30;
constexpr double kAwayMm = 100.0;  ///< to the user's left, which is to the right in the picture
constexpr double kFarMm = 400.0;

constexpr int kSteps = 12;

/// Returns pictures of a head that moves aside.
std::vector<Picture> headThatGoesAside()
{
    const support::PrintCamera camera(core::tracking::CameraModel::withFieldOfView(kWide, kHigh, 60.0));
    const support::TagPrint print{core::tracking::cellsOf(kTagId)};
    std::vector<Picture> pictures;
    for (int n = 0; n <= kSteps; ++n) {
        core::tracking::Pose pose;
        pose.positionMm = {kAwayMm * n / kSteps, 0.0, kFarMm};
        pose.rotation = glm::dmat3(glm::rotate(glm::dmat4(1.0), glm::radians(20.0), glm::dvec3(1.0, 0.0, 0.0)));
        pictures.push_back(camera.take(pose, print));
    }
    return pictures;
}

/// Returns a video of a head that is in the middle for two seconds, moves aside in one second, and stays there for six.
QByteArray videoOfAHead()
{
    const std::vector<Picture> pictures = headThatGoesAside();
    constexpr int kPictures = 9 * kHz;
    const support::Avi avi(kWide, kHigh, kPictures);
    QByteArray bytes = avi.header();
    for (int n = 0; n < kPictures; ++n)
        bytes +=
            avi.picture(pictures.at(static_cast<std::size_t>(std::clamp((n - 2 * kHz) * kSteps / kHz, 0, kSteps))));
    return bytes;
}

/// Returns the same pictures as images.
QList<QByteArray> picturesOfAHead()
{
    QList<QByteArray> images;
    for (const Picture& picture : headThatGoesAside())
        images << support::pgmOf(picture);
    return images;
}

}  // namespace

class TestHeadTracking : public support::ProgramWindow
{
    Q_OBJECT
private slots:
    void initTestCase() { m_bytes = videoOfAHead(); }
    void init()
    {
        ui::kit::memory().clear();
        m_folder = std::make_unique<QTemporaryDir>();
        m_video = m_folder->filePath(QStringLiteral("head.avi"));
        QFile file(m_video);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(m_bytes), m_bytes.size());
    }
    void cleanup() { m_application.reset(); }

    void theViewGoesWithTheHeadAndComesBack()
    {
        start();
        const double straightDeg = azimuthDeg();
        use({.isOn = true, .video = m_video, .tagId = kTagId});
        // A head 100 mm aside at 400 mm is at 14 degrees, which the view doubles. Moving to the left decreases the
        // azimuth.
        WAIT_FOR(azimuthDeg() < straightDeg - 20.0);
        QVERIFY(actions().recentreHead->isVisible());
        // The video ends, so the tag is no longer seen.
        WAIT_FOR(std::abs(azimuthDeg() - straightDeg) < 1e-9);
    }

    void turnedOffTheViewComesBack()
    {
        start();
        const double straightDeg = azimuthDeg();
        use({.isOn = true, .video = m_video, .tagId = kTagId});
        WAIT_FOR(azimuthDeg() < straightDeg - 5.0);
        use({.isOn = false, .video = m_video, .tagId = kTagId});
        WAIT_FOR(std::abs(azimuthDeg() - straightDeg) < 1e-9);
        QVERIFY(!actions().recentreHead->isVisible());
    }

    void recentringMakesAnotherMiddle()
    {
        start();
        const double straightDeg = azimuthDeg();
        use({.isOn = true, .video = m_video, .tagId = kTagId});
        WAIT_FOR(azimuthDeg() < straightDeg - 20.0);
        actions().recentreHead->trigger();
        WAIT_FOR(std::abs(azimuthDeg() - straightDeg) < 0.5);
    }

    void theScreenCanBeAWindow()
    {
        start();
        const double straightDeg = azimuthDeg();
        const glm::dvec3 eye = window().view().camera().eyeMm();
        use({.isOn = true, .video = m_video, .tagId = kTagId, .isWindow = true});
        WAIT_FOR(glm::distance(window().view().camera().eyeMm(), eye) > 5.0);
        QVERIFY(std::abs(azimuthDeg() - straightDeg) < 1e-6);
    }

    void thePageShowsWhatTheCameraSees()
    {
        start();
        actions().devices->trigger();
        waitForPage<ui::devices::DevicesPage>();
        window().findChild<ui::devices::HandList*>()->selectHand(QLatin1String(ui::devices::kHeadTracking));
        use({.video = m_video, .tagId = kTagId});
        QVERIFY(!card().followSwitch().isChecked());
        card().followSwitch().click();
        WAIT_FOR(card().state().report.stage == TrackerStage::Tracking);
        WAIT_FOR(card().state().report.hz > 1.0);
        QCOMPARE(card().state().report.sameTags, 1);
        QVERIFY(ui::kit::memory().value("head/on").toBool());
    }

    /// The tag in the video is at 400 mm, but the user enters 500 mm.
    void theFieldOfViewIsMeasuredAndStoredForTheCamera()
    {
        start();
        actions().devices->trigger();
        waitForPage<ui::devices::DevicesPage>();
        window().findChild<ui::devices::HandList*>()->selectHand(QLatin1String(ui::devices::kHeadTracking));
        use({.isOn = true, .video = m_video, .tagId = kTagId});
        WAIT_FOR(child<QPushButton>("measureFieldOfView")->isEnabled());
        click("measureFieldOfView");
        // The focal length is 277 px * 500 / 400, and half of the 320 px is seen at 24.8 degrees.
        WAIT_FOR(std::abs(card().settings().fovDeg - 49.6) < 1.5);
        const double measuredDeg = card().settings().fovDeg;
        HeadTrackingSettings other = card().settings();
        other.video.clear();
        other.camera = 998;
        use(other);
        QCOMPARE(card().settings().fovDeg, HeadTrackingSettings{}.fovDeg);
        other = card().settings();
        other.video = m_video;
        use(other);
        QCOMPARE(card().settings().fovDeg, measuredDeg);
    }

    void aFolderOfImagesStandsInForTheCamera()
    {
        start();
        const QString folder = m_folder->filePath("pictures");
        QVERIFY(QDir().mkpath(folder));
        const QList<QByteArray> pictures = picturesOfAHead();
        for (int n = 0; n < 6 * kHz; ++n) {
            QFile file(folder + QStringLiteral("/%1.pgm").arg(n, 4, 10, QChar('0')));
            QVERIFY(file.open(QIODevice::WriteOnly));
            QVERIFY(file.write(pictures.at(std::clamp(n - kHz, 0, static_cast<int>(pictures.size()) - 1))) > 0);
        }
        const double straightDeg = azimuthDeg();
        use({.isOn = true, .video = folder, .tagId = kTagId});
        WAIT_FOR(azimuthDeg() < straightDeg - 20.0);
    }

    void aCalibrationIsStoredForTheCamera()
    {
        start();
        const QString path = m_folder->filePath("camera.json");
        auto camera = core::tracking::CameraModel::withFieldOfView(kWide, kHigh, 50.0);
        QVERIFY(app::writeCameraCalibration(path, camera));
        use({.isOn = true, .video = m_video, .tagId = kTagId, .calibration = path});
        QCOMPARE(card().settings().fovDeg, 50.0);
        HeadTrackingSettings other = card().settings();
        other.video.clear();
        other.camera = 998;
        use(other);
        QCOMPARE(card().settings().calibration, QString());
        other = card().settings();
        other.video = m_video;
        use(other);
        QCOMPARE(card().settings().calibration, path);

        // The page warns of a calibration for another size of picture, and rejects a file that is not a calibration.
        camera = core::tracking::CameraModel::withFieldOfView(640, 480, 50.0);
        QVERIFY(app::writeCameraCalibration(path, camera));
        actions().devices->trigger();
        waitForPage<ui::devices::DevicesPage>();
        other.tagMm = 51.0;
        other.calibration = path;
        use(other);
        WAIT_FOR(card().state().report.stage == TrackerStage::NoCamera);
        QCOMPARE(card().state().report.error.code, core::ErrorCode::OutOfRange);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{");
        file.close();
        other.tagMm = 52.0;
        use(other);
        QCOMPARE(card().settings().calibration, QString());
        WAIT_FOR(card().state().report.stage == TrackerStage::Tracking);
        QVERIFY(!message().isEmpty());
    }

    void aMissingCameraIsSaidAndTheMouseWorks()
    {
        start();
        HeadTrackingSettings missing;
        missing.isOn = true;
        missing.camera = 999;
        use(missing);
        actions().devices->trigger();
        waitForPage<ui::devices::DevicesPage>();
        WAIT_FOR(card().state().report.stage == TrackerStage::NoCamera);
        QVERIFY(!card().state().report.error.detail.empty());
        actions().back->trigger();
        waitForTooth();
        drill(1.5);
        QVERIFY(removed() != "0.00");
    }

    void settingsAreRemembered()
    {
        start();
        const HeadTrackingSettings wanted{.isOn = true,
                                          .camera = 3,
                                          .video = m_video,
                                          .width = 640,
                                          .height = 480,
                                          .hz = 60,
                                          .tagId = kTagId,
                                          .tagMm = 60.0,
                                          .fovDeg = 70.0,
                                          .gain = 3.0,
                                          .isWindow = true,
                                          .mirrored = false};
        use(wanted);
        m_application.reset();
        start();
        QVERIFY(card().settings() == wanted);
    }

private:
    void start()
    {
        app::WindowOptions options;
        options.source = {36};
        begin(options);
        waitForTooth();
        WAIT_FOR(servo().tick > 0);
    }
    [[nodiscard]] HeadTrackingCard& card() const { return child<ui::devices::DevicesPage>()->headTracking(); }
    /// Applies settings as if the user had made them on the page.
    void use(const HeadTrackingSettings& settings) const { emit card().settingsChanged(settings); }
    [[nodiscard]] double azimuthDeg() const { return window().view().camera().azimuthDeg(); }

    QByteArray m_bytes;
    QString m_video;
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestHeadTracking>(argc, argv);
}

#include "tst_head_tracking.moc"
