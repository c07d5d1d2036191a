// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStringList>
#include <QTest>

#include "tests/support/Suite.h"
#include "tests/ui/PageTest.h"
#include "tests/ui/Pictures.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/HandList.h"
#include "ui/devices/HeadTrackingCard.h"
#include "ui/devices/TagPicture.h"
#include "ui/kit/TabularDigitsLabel.h"

using core::tracking::CameraInfo;
using core::tracking::PictureTrouble;
using core::tracking::TrackerReport;
using core::tracking::TrackerStage;
using ui::devices::DevicesPage;
using ui::devices::HandList;
using ui::devices::HeadTrackingCard;
using ui::devices::HeadTrackingSettings;
using ui::devices::Sign;
using ui::devices::TagPicture;

namespace {

const std::vector<CameraInfo> kCameras{{0, "Built-in camera"}, {2, "Camera on the screen"}};
constexpr TagPicture::Corners kCorners{glm::dvec2(780.0, 330.0), glm::dvec2(905.0, 345.0), glm::dvec2(900.0, 220.0),
                                       glm::dvec2(772.0, 210.0)};

/// Returns a picture of a room that gets lighter to the right, with a tag on a head.
core::tracking::Picture room(int width = 1280, int height = 720)
{
    core::tracking::Picture picture;
    picture.width = width;
    picture.height = height;
    picture.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const double scale = width / 1280.0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double u = x / scale;
            const double v = y / scale;
            const bool isHead = (u - 840.0) * (u - 840.0) / 1.3e4 + (v - 400.0) * (v - 400.0) / 3.6e4 < 1.0;
            const bool isPaper = u > 755.0 && u < 922.0 && v > 192.0 && v < 362.0;
            const bool isTag = u > 776.0 && u < 902.0 && v > 214.0 && v < 340.0;
            const bool isCell = u > 808.0 && u < 840.0 && v > 246.0 && v < 308.0;
            const double level = isCell || (isPaper && !isTag) ? 225.0
                                 : isTag                       ? 25.0
                                 : isHead                      ? 150.0
                                                               : 40.0 + u / 16.0;
            picture
                .pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
                static_cast<std::uint8_t>(level);
        }
    return picture;
}

TrackerReport at(TrackerStage stage)
{
    TrackerReport report;
    report.stage = stage;
    if (stage == TrackerStage::NoCamera)
        report.error = {core::ErrorCode::Busy,
                        {},
                        {"Camera %1 gives no pictures. Close other programs that use it, or choose another one.",
                         {core::noted("0")}}};
    return report;
}

TrackerReport tracking()
{
    TrackerReport report = at(TrackerStage::Tracking);
    report.sameTags = 1;
    report.hz = 29.8;
    report.findMs = 0.6;
    report.poseMs = 0.5;
    report.latencyMs = 24.2;
    report.seenShare = 0.98;
    report.jitterMm = 0.034;
    report.tag.tag.cornersPx = kCorners;
    report.picture = room();
    return report;
}

}  // namespace

class TestHeadTrackingCard : public support::PageTest<DevicesPage>
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        openPage();
        m_page->setChosen("pointer");
        m_page->show();
        child<HandList>()->selectHand(ui::devices::kHeadTracking);
        card().setCameras(kCameras);
        // As in the window, the shortcuts of the tooth are disabled on this page.
        for (QAction* action : {m_actions->drill, m_actions->pauseReplay, m_actions->slower, m_actions->faster})
            action->setEnabled(false);
    }
    void cleanup() { m_window.reset(); }

    void itIsNoHand()
    {
        QCOMPARE(m_page->shownHand(), QString(ui::devices::kHeadTracking));
        QVERIFY(card().isVisible());
        QVERIFY(follow().isVisible());
        QVERIFY(!child<QPushButton>("deviceNext")->isVisible());
        for (const char* part : {"firmware", "setup", "liveTest", "rule"})
            QVERIFY2(!child<QWidget>(part)->isVisible(), part);
        QSignalSpy wanted(m_page, &DevicesPage::handRequested);
        child<HandList>()->setFocus();
        QTest::keyClick(child<HandList>(), Qt::Key_Return);
        QCOMPARE(wanted.count(), 0);
        QVERIFY(follow().hasFocus());
        child<HandList>()->selectHand("pointer");
        QVERIFY(!card().isVisible());
        QVERIFY(!follow().isVisible());
        QVERIFY(child<QPushButton>("deviceNext")->isVisible());
    }

    void theSwitchTurnsItOnAndOff()
    {
        QSignalSpy turned(&card(), &HeadTrackingCard::trackingChanged);
        QSignalSpy changed(&card(), &HeadTrackingCard::settingsChanged);
        QVERIFY(row().sign == Sign::Off);
        follow().setFocus();
        QTest::keyClick(&follow(), Qt::Key_Space);
        QCOMPARE(turned.count(), 1);
        QCOMPARE(turned.front().front().toBool(), true);
        QVERIFY(card().settings().isOn);
        QVERIFY(row().sign == Sign::Working);
        follow().click();
        QCOMPARE(turned.count(), 2);
        QCOMPARE(turned.back().front().toBool(), false);
        QCOMPARE(changed.count(), 0);
        turnOn();
        QVERIFY(follow().isChecked());
        QCOMPARE(turned.count(), 2);
    }

    void eachStateHasItsSignAndWords()
    {
        turnOn();
        QStringList states;
        QStringList helps;
        const auto check = [&](const TrackerReport& report, Sign sign) {
            card().setTracking(report);
            QVERIFY(row().sign == sign);
            QCOMPARE(row().state, textOf("deviceState"));
            QVERIFY(!textOf("deviceHelp").isEmpty());
            QCOMPARE(follow().accessibleDescription(), textOf("deviceState"));
            QCOMPARE(support::controlsWithoutNames(*m_window), QStringList());
            states << textOf("deviceState");
            helps << textOf("deviceHelp");
        };
        check(at(TrackerStage::Opening), Sign::Working);
        check(at(TrackerStage::NoCamera), Sign::Attention);
        QVERIFY(textOf("deviceHelp").contains("Close other programs"));
        check(at(TrackerStage::NoTag), Sign::Attention);
        check(tracking(), Sign::Ready);
        check(at(TrackerStage::Ended), Sign::Attention);
        for (const PictureTrouble trouble : {PictureTrouble::Dark, PictureTrouble::Bright, PictureTrouble::Frozen}) {
            TrackerReport report = at(TrackerStage::NoTag);
            report.trouble = trouble;
            check(report, Sign::Attention);
        }
        TrackerReport several = tracking();
        several.sameTags = 2;
        check(several, Sign::Attention);
        card().setSettings({});
        states << textOf("deviceState");
        helps << textOf("deviceHelp");
        QCOMPARE(states.removeDuplicates(), 0);
        QCOMPARE(helps.removeDuplicates(), 0);
    }

    void aProgramWithoutItSaysSo()
    {
        const QString before = textOf("deviceState");
        card().setInBuild(false);
        QVERIFY(row().sign == Sign::Missing);
        QVERIFY(textOf("deviceState") != before);
        QVERIFY(!follow().isEnabled());
        for (const char* part : {"trackingLive", "trackingSetup"})
            QVERIFY2(!child<QWidget>(part)->isVisible(), part);
    }

    void thePictureHasTheOutlineOfTheTag()
    {
        QVERIFY(!picture().hasPicture());
        turnOn();
        card().setTracking(tracking());
        QVERIFY(picture().hasPicture());
        QCOMPARE(picture().outline().size(), qsizetype{4});
        const QString withTag = picture().accessibleName();
        TrackerReport lost = at(TrackerStage::NoTag);
        lost.picture = room();
        lost.tag.tag.cornersPx = kCorners;  // where it was seen last
        card().setTracking(lost);
        QVERIFY(picture().hasPicture());
        QVERIFY(picture().outline().isEmpty());
        QVERIFY(picture().accessibleName() != withTag);
        // A report without a picture changes only the values.
        TrackerReport blind = tracking();
        blind.picture = {};
        card().setTracking(blind);
        QVERIFY(picture().hasPicture());
        card().setTracking(at(TrackerStage::NoCamera));
        QVERIFY(!picture().hasPicture());
        QCOMPARE(picture().accessibleName(), textOf("deviceState"));
    }

    void thePictureIsAMirrorUnlessTheUserWantsNone()
    {
        turnOn();
        card().setTracking(tracking());
        const QSignalSpy changed(&card(), &HeadTrackingCard::settingsChanged);
        const auto isTagAtTheRight = [&] {
            return picture().outline().boundingRect().center().x() > picture().width() / 2.0;
        };
        const auto isLightAtTheRight = [&] {
            const QImage image = picture().grab().toImage();
            const int y = image.height() / 10;
            return pictures::mean(image, pictures::around(image.width() * 0.8, y, 3)).brightness() >
                   pictures::mean(image, pictures::around(image.width() * 0.2, y, 3)).brightness();
        };
        QVERIFY(!isTagAtTheRight());
        QVERIFY(!isLightAtTheRight());
        child<QCheckBox>("mirrored")->click();
        QVERIFY(isTagAtTheRight());
        QVERIFY(isLightAtTheRight());
        QCOMPARE(changed.count(), 1);
        QVERIFY(!card().settings().mirrored);
    }

    void theFiguresAreThoseOfTheReport()
    {
        turnOn();
        const QString none = figure("trackingRate");
        card().setTracking(tracking());
        QCOMPARE(figure("trackingRate"), QString("30"));
        QCOMPARE(figure("trackingSeen"), QString("98"));
        QCOMPARE(figure("trackingFind"), QString("1.1"));
        QCOMPARE(figure("trackingLatency"), QString("24"));
        QCOMPARE(figure("trackingJitter"), QString("0.03"));
        TrackerReport video = tracking();
        video.latencyMs = 0.0;
        card().setTracking(video);
        QCOMPARE(figure("trackingLatency"), none);
        card().setTracking(at(TrackerStage::NoCamera));
        QCOMPARE(figure("trackingRate"), none);
    }

    void theHeadIsCentredWhileItIsFollowed()
    {
        QSignalSpy recentred(&card(), &HeadTrackingCard::recentreRequested);
        auto* button = child<QPushButton>("recentre");
        QVERIFY(!button->isEnabled());
        turnOn();
        card().setTracking(tracking());
        QVERIFY(button->isEnabled());
        button->click();
        QCOMPARE(recentred.count(), 1);
        card().setTracking(at(TrackerStage::NoTag));
        QVERIFY(!button->isEnabled());
    }

    void theFieldOfViewIsMeasuredWhileTheTagIsSeen()
    {
        QSignalSpy wanted(&card(), &HeadTrackingCard::fieldOfViewRequested);
        auto* const button = child<QPushButton>("measureFieldOfView");
        QVERIFY(!button->isEnabled());
        HeadTrackingSettings settings;
        settings.isOn = true;
        card().setSettings(settings);
        card().setTracking(at(TrackerStage::Tracking));
        QVERIFY(button->isEnabled());
        button->click();
        QCOMPARE(wanted.count(), 1);
        card().setTracking(at(TrackerStage::NoTag));
        QVERIFY(!button->isEnabled());
    }

    void theTagIsPrintedBySomebodyElse()
    {
        QSignalSpy printed(&card(), &HeadTrackingCard::printRequested);
        click("printTag");
        QCOMPARE(printed.count(), 1);
    }

    void theSettingsAreTheUsers()
    {
        HeadTrackingSettings settings;
        settings.isOn = true;
        settings.camera = 2;
        settings.width = 640;
        settings.height = 480;
        settings.hz = 60;
        settings.tagId = 17;
        settings.tagMm = 42.5;
        settings.fovDeg = 70.0;
        settings.gain = 3.0;
        QSignalSpy changed(&card(), &HeadTrackingCard::settingsChanged);
        card().setSettings(settings);
        QCOMPARE(changed.count(), 0);
        QCOMPARE(camera().currentData().toInt(), 2);
        QCOMPARE(child<QComboBox>("pictureSize")->currentData().toSize(), QSize(640, 480));
        QCOMPARE(child<QSpinBox>("tagNumber")->value(), 17);
        QCOMPARE(child<QComboBox>("pictureRate")->currentData().toInt(), 60);
        for (const auto& [name, value] : {std::pair("tagEdge", 42.5), {"fieldOfView", 70.0}, {"gain", 3.0}})
            QCOMPARE(child<QDoubleSpinBox>(name)->value(), value);

        choose(camera(), 0);
        choose(*child<QComboBox>("pictureSize"), 2);
        choose(*child<QComboBox>("pictureRate"), 0);
        child<QSpinBox>("tagNumber")->setValue(3);
        child<QDoubleSpinBox>("tagEdge")->setValue(60.0);
        child<QDoubleSpinBox>("fieldOfView")->setValue(55.0);
        child<QDoubleSpinBox>("gain")->setValue(1.5);
        choose(*child<QComboBox>("wayOfView"), 1);
        QCOMPARE(changed.count(), 8);
        settings.camera = 0;
        settings.width = 1920;
        settings.height = 1080;
        settings.hz = 15;
        settings.tagId = 3;
        settings.tagMm = 60.0;
        settings.fovDeg = 55.0;
        settings.gain = 1.5;
        settings.isWindow = true;
        QVERIFY(changed.back().front().value<HeadTrackingSettings>() == settings);
        QVERIFY(card().settings() == settings);
    }

    void aNumberIsTakenWhenItIsWhole()
    {
        QSignalSpy changed(&card(), &HeadTrackingCard::settingsChanged);
        auto* edge = child<QDoubleSpinBox>("tagEdge");
        edge->setFocus();
        edge->selectAll();
        QTest::keyClicks(edge, "120");
        QCOMPARE(changed.count(), 0);
        QTest::keyClick(edge, Qt::Key_Return);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(card().settings().tagMm, 120.0);
    }

    void aCameraThatIsUnpluggedStaysChosen()
    {
        HeadTrackingSettings settings;
        settings.camera = 2;
        card().setSettings(settings);
        QSignalSpy changed(&card(), &HeadTrackingCard::settingsChanged);
        const QString name = camera().currentText();
        card().setCameras({kCameras.front()});
        QCOMPARE(camera().currentData().toInt(), 2);
        QVERIFY(camera().currentText() != name);
        card().setCameras({});
        QCOMPARE(camera().currentData().toInt(), 2);
        card().setCameras(kCameras);
        QCOMPARE(camera().currentText(), name);
        QCOMPARE(changed.count(), 0);
    }

    void aCalibrationTakesThePlaceOfTheFieldOfView()
    {
        QSignalSpy changed(&card(), &HeadTrackingCard::settingsChanged);
        turnOn();
        card().setTracking(at(TrackerStage::Tracking));
        auto& lens = *child<QComboBox>("lens");
        choose(lens, lens.count() - 1);
        auto* dialog = child<QFileDialog>();
        QVERIFY(dialog != nullptr);
        QCOMPARE(changed.count(), 0);
        emit dialog->fileSelected("/tmp/camera.json");
        dialog->close();
        QCOMPARE(changed.count(), 1);
        QCOMPARE(card().settings().calibration, QString("/tmp/camera.json"));
        QCOMPARE(lens.currentText(), QString("camera.json"));
        QVERIFY(!child<QDoubleSpinBox>("fieldOfView")->isEnabled());
        QVERIFY(!child<QPushButton>("measureFieldOfView")->isEnabled());
        choose(lens, 0);
        QCOMPARE(card().settings().calibration, QString());
        QVERIFY(child<QDoubleSpinBox>("fieldOfView")->isEnabled());
        QVERIFY(child<QPushButton>("measureFieldOfView")->isEnabled());
    }

    void aSlowCameraIsSaid()
    {
        turnOn();
        TrackerReport report = tracking();
        card().setTracking(report);
        const QString help = textOf("deviceHelp");
        report.hz = 14.0;
        card().setTracking(report);
        QVERIFY(textOf("deviceHelp") != help);
        QVERIFY(textOf("deviceHelp").contains("14"));
        // A video is played at the rate of its recording.
        HeadTrackingSettings video = card().settings();
        video.video = "/tmp/head.mp4";
        card().setSettings(video);
        QCOMPARE(textOf("deviceHelp"), help);
    }

    void aVideoOrAFolderStandsInForACamera_data()
    {
        QTest::addColumn<int>("fromTheEnd");
        QTest::addColumn<QString>("path");
        QTest::addRow("video") << 2 << "/tmp/head.mp4";
        QTest::addRow("folder") << 1 << "/tmp/head-pictures";
    }
    void aVideoOrAFolderStandsInForACamera()
    {
        QFETCH(int, fromTheEnd);
        QFETCH(QString, path);
        QSignalSpy changed(&card(), &HeadTrackingCard::settingsChanged);
        choose(camera(), camera().count() - fromTheEnd);
        auto* dialog = child<QFileDialog>();
        QVERIFY(dialog != nullptr);
        QCOMPARE(camera().currentData().toInt(), 0);
        QCOMPARE(changed.count(), 0);
        emit dialog->fileSelected(path);
        dialog->close();
        QCOMPARE(changed.count(), 1);
        QCOMPARE(card().settings().video, path);
        QCOMPARE(camera().currentText(), QFileInfo(path).fileName());
        QVERIFY(!child<QComboBox>("pictureSize")->isEnabled());
        choose(camera(), 1);
        QCOMPARE(card().settings().video, QString());
        QCOMPARE(card().settings().camera, 2);
        QVERIFY(child<QComboBox>("pictureSize")->isEnabled());
    }

    /// Draws every state for inspection, if CUSP_PICTURES is set.
    void everyStateCanBeDrawn_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::addColumn<QSize>("size");
        for (const bool isDark : {false, true})
            for (const QSize size : {QSize(1280, 800), QSize(1920, 1080), QSize(853, 520)})
                QTest::addRow("%s, %d", isDark ? "dark" : "light", size.width()) << isDark << size;
    }
    void everyStateCanBeDrawn()
    {
        QFETCH(bool, isDark);
        QFETCH(QSize, size);
        const auto reset = qScopeGuard([] { ui::kit::applyTheme(*qApp, ui::kit::ThemeChoice::Light); });
        ui::kit::applyTheme(*qApp, isDark ? ui::kit::ThemeChoice::Dark : ui::kit::ThemeChoice::Light);
        init();
        m_window->resize(size);
        m_page->resize(size);
        const auto draw = [&](const QString& name) {
            for (int n = 0; n < 3; ++n)  // a layout may trigger another one
                QCoreApplication::processEvents();
            const QImage image = m_window->grab().toImage();
            pictures::keep(image, QStringLiteral("head-tracking-%1-%2-%3")
                                      .arg(name, isDark ? "dark" : "light", QString::number(size.width())));
            QCOMPARE(image.deviceIndependentSize().toSize(), size);
            QVERIFY2(isWhollyShown(), qPrintable(name));
        };
        draw("off");
        turnOn();
        for (const auto& [name, report] : {std::pair("camera", at(TrackerStage::NoCamera)), {"tracking", tracking()}}) {
            card().setTracking(report);
            draw(name);
        }
        TrackerReport lost = at(TrackerStage::NoTag);
        lost.hz = 29.8;
        lost.findMs = 5.2;
        lost.latencyMs = 28.0;
        lost.picture = room(640, 480);
        card().setTracking(lost);
        draw("lost");
        card().setInBuild(false);
        draw("left-out");
    }

private:
    [[nodiscard]] HeadTrackingCard& card() const { return m_page->headTracking(); }
    [[nodiscard]] QCheckBox& follow() const { return *child<QCheckBox>("followHead"); }
    [[nodiscard]] TagPicture& picture() const { return *child<TagPicture>(); }
    [[nodiscard]] QComboBox& camera() const { return *child<QComboBox>("camera"); }
    [[nodiscard]] QString figure(const char* name) const { return child<ui::kit::TabularDigitsLabel>(name)->text(); }
    [[nodiscard]] HandList::Row row() const
    {
        for (const HandList::Row& one : child<HandList>()->rows())
            if (one.id == QLatin1String(ui::devices::kHeadTracking))
                return one;
        return {};
    }
    void turnOn() const
    {
        HeadTrackingSettings settings;
        settings.isOn = true;
        card().setSettings(settings);
    }
    /// Selects an entry as the user does.
    static void choose(QComboBox& list, int entry)
    {
        list.setCurrentIndex(entry);
        emit list.activated(entry);
    }
    /// Returns whether no card is wider than the scroll area, which scrolls only vertically.
    [[nodiscard]] bool isWhollyShown() const
    {
        for (const char* name : {"trackingLive", "trackingSetup"})
            if (const auto* part = child<QWidget>(name); part->isVisible()) {
                const QWidget* const port = card().parentWidget()->parentWidget();
                if (part->mapTo(port, QPoint(part->width(), 0)).x() > port->width() ||
                    part->width() < part->minimumSizeHint().width() ||
                    part->height() < part->minimumSizeHint().height())
                    return false;
            }
        return true;
    }
};

CUSP_TEST(TestHeadTrackingCard)
#include "tst_head_tracking_card.moc"
