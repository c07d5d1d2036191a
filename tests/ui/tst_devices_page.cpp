// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QRadioButton>
#include <QSignalSpy>
#include <QStringList>
#include <QTest>

#include <glm/geometric.hpp>

#include "tests/support/Suite.h"
#include "tests/ui/PageTest.h"
#include "tests/ui/Pictures.h"
#include "ui/devices/ButtonLights.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/ForceTest.h"
#include "ui/devices/HandList.h"
#include "ui/devices/HomingMarks.h"
#include "ui/devices/LiveTest.h"

using core::session::DeviceReport;
using core::session::DeviceSetup;
using core::session::DeviceStage;
using ui::devices::DevicesPage;
using ui::devices::FirmwareFile;
using ui::devices::HandList;
using ui::devices::Sign;

Q_DECLARE_METATYPE(core::session::DeviceStage)
Q_DECLARE_METATYPE(core::session::DeviceSetup)

namespace {

const QString kArm = QStringLiteral("arm");

ui::devices::DeviceKind arm()
{
    ui::devices::DeviceKind kind;
    kind.id = kArm;
    kind.name = QStringLiteral("Test Arm");
    kind.rule = QStringLiteral("a rule of one line, which is as long as such rules are: SUBSYSTEM, ATTR and TAG");
    kind.ruleFile = QStringLiteral("/etc/rules.d/arm");
    kind.ruleCommand = QStringLiteral("cusp arm rules");
    return kind;
}

DeviceReport at(DeviceStage stage)
{
    DeviceReport report;
    report.stage = stage;
    return report;
}

DeviceReport ready()
{
    DeviceReport report = at(DeviceStage::Ready);
    report.serial = "12PZ657E";
    report.homed = {true, true, true};
    report.tipMm = {12.0F, -8.0F, 20.0F};
    report.buttons = 0b0101;
    report.exchange.requests = 123'456;
    report.exchange.answers = 123'440;
    report.exchange.lost = 16;
    report.exchange.rejected = 2;
    report.exchange.rateHz = 997.6;
    report.exchange.roundTripUs = 420.0;
    report.exchange.slowTripUs = 910.0;
    report.exchange.intervals.at(18) = 40;
    report.exchange.intervals.at(19) = 300;
    report.exchange.intervals.at(20) = 560;
    report.exchange.intervals.at(21) = 90;
    report.exchange.intervals.back() = 3;
    return report;
}

DeviceReport notAllowed()
{
    DeviceReport report = at(DeviceStage::Unavailable);
    report.error.code = core::ErrorCode::NotAllowed;
    report.error.detail = "The device may not be opened.";
    return report;
}

}  // namespace

class TestDevicesPage : public support::PageTest<DevicesPage>
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        openPage();
        m_page->setKinds({arm()});
        m_page->setChosen(kArm);
        m_page->show();
        // As in the window, the shortcuts of the tooth are disabled on this page.
        for (QAction* action : {m_actions->drill, m_actions->pauseReplay, m_actions->slower, m_actions->faster})
            action->setEnabled(false);
    }
    void cleanup() { m_window.reset(); }

    void everyHandIsListedWithItsState()
    {
        m_page->setReport(kArm, at(DeviceStage::Absent));
        const QList<HandList::Row> rows = hands().rows();
        QCOMPARE(rows.size(), 6);
        QCOMPARE(rows.at(0).id, QString("pointer"));
        QCOMPARE(rows.at(1).id, QString("simulated"));
        QCOMPARE(rows.at(2).id, kArm);
        QCOMPARE(rows.at(2).name, QString("Test Arm"));
        QCOMPARE(rows.at(3).id, QString(ui::devices::kHeadTracking));
        QVERIFY(rows.at(3).isApart);
        QCOMPARE(rows.at(4).id, QString(ui::devices::kPedals));
        QCOMPARE(rows.at(5).id, QString(ui::devices::kSound));
        QVERIFY(!rows.at(5).isApart);
        QVERIFY(rows.at(2).sign == Sign::Missing);
        QVERIFY(rows.at(2).isChosen);
        QVERIFY(!rows.at(0).isChosen);
        QVERIFY(hands().item(2)->data(Qt::AccessibleTextRole).toString().contains(rows.at(2).state));
        m_page->setReport(kArm, ready());
        QVERIFY(hands().rows().at(2).sign == Sign::Ready);
        QVERIFY(hands().rows().at(2).state != rows.at(2).state);
    }

    void eachStageShowsItsOwnParts_data()
    {
        QTest::addColumn<DeviceStage>("stage");
        QTest::addColumn<bool>("isDenied");
        QTest::addColumn<QString>("part");
        QTest::newRow("absent") << DeviceStage::Absent << false << "";
        QTest::newRow("unavailable") << DeviceStage::Unavailable << false << "";
        QTest::newRow("not allowed") << DeviceStage::Unavailable << true << "rule";
        QTest::newRow("needs firmware") << DeviceStage::NeedsFirmware << false << "";
        QTest::newRow("loading") << DeviceStage::LoadingFirmware << false << "firmwareProgress";
        QTest::newRow("homing") << DeviceStage::Homing << false << "homing";
        QTest::newRow("ready") << DeviceStage::Ready << false << "liveTest";
        QTest::newRow("silent") << DeviceStage::Silent << false << "";
    }
    void eachStageShowsItsOwnParts()
    {
        QFETCH(DeviceStage, stage);
        QFETCH(bool, isDenied);
        QFETCH(QString, part);
        m_page->setReport(kArm, isDenied ? notAllowed() : at(stage));
        for (const char* name : {"rule", "firmwareProgress", "homing", "liveTest"})
            QVERIFY2(child<QWidget>(name)->isVisible() == (part == QLatin1String(name)), name);
        QVERIFY(child<QWidget>("firmware")->isVisible());
        QVERIFY(child<QWidget>("setup")->isVisible());
        QVERIFY(!textOf("deviceState").isEmpty());
        QCOMPARE(textOf("deviceState"), hands().rows().at(2).state);
        QCOMPARE(support::controlsWithoutNames(*m_window), QStringList());
        int filled = 0;
        for (const QPushButton* button : m_page->findChildren<QPushButton*>())
            filled += button->isVisible() && button->property("kind") == "filled" ? 1 : 0;
        QVERIFY2(filled <= 1, qPrintable(QString::number(filled)));
    }

    void everyStageHasASentenceOfItsOwn()
    {
        QStringList sentences;
        for (const DeviceStage stage :
             {DeviceStage::Absent, DeviceStage::Unavailable, DeviceStage::NeedsFirmware, DeviceStage::LoadingFirmware,
              DeviceStage::Homing, DeviceStage::Ready, DeviceStage::Silent}) {
            m_page->setReport(kArm, at(stage));
            sentences << textOf("deviceState");
        }
        m_page->setReport(kArm, notAllowed());
        sentences << textOf("deviceState");
        QCOMPARE(sentences.removeDuplicates(), 0);
    }

    void aSecondDeviceIsMentioned()
    {
        m_page->setReport(kArm, ready());
        const QString alone = textOf("deviceState");
        DeviceReport report = ready();
        report.others = 1;
        m_page->setReport(kArm, report);
        QVERIFY(textOf("deviceState").startsWith(alone));
        QVERIFY(textOf("deviceState") != alone);
    }

    void aCalibrationThatCannotBeUsedIsNamed()
    {
        m_page->setReport(kArm, ready());
        QVERIFY(!child<QLabel>("deviceHelp")->isVisible());
        ui::devices::DeviceKind kind = arm();
        kind.badCalibration = QStringLiteral("arm.json");
        m_page->setKinds({kind});
        m_page->setChosen(kArm);
        m_page->setReport(kArm, ready());
        QVERIFY(child<QLabel>("deviceHelp")->isVisible());
        QVERIFY(textOf("deviceHelp").contains(kind.badCalibration));
    }

    void homingFillsAMarkForEachArm()
    {
        DeviceReport report = at(DeviceStage::Homing);
        report.homed = {false, true, false};
        m_page->setReport(kArm, report);
        const auto* marks = child<ui::devices::HomingMarks>();
        QVERIFY((marks->homed() == std::array{false, true, false}));
        const QString one = marks->accessibleName();
        report.homed = {true, true, false};
        m_page->setReport(kArm, report);
        QVERIFY((marks->homed() == std::array{true, true, false}));
        QVERIFY(marks->accessibleName() != one);
    }

    void loadingShowsItsProgress()
    {
        DeviceReport report = at(DeviceStage::LoadingFirmware);
        report.progress = 0.45;
        m_page->setReport(kArm, report);
        QCOMPARE(child<QProgressBar>("firmwareProgress")->value(), 45);
        QVERIFY(textOf("deviceState").contains("45"));
    }

    void theButtonsOfTheGripLightUp()
    {
        m_page->setReport(kArm, ready());
        QCOMPARE(child<ui::devices::ButtonLights>()->held(), std::uint8_t{0b0101});
        QVERIFY(child<ui::devices::ButtonLights>()->accessibleName().contains("Drill"));
        QVERIFY(child<ui::devices::ButtonLights>()->accessibleName().contains("Mirror"));
    }

    void aForceIsTriedAsLongAsAButtonIsHeld_data()
    {
        QTest::addColumn<QString>("button");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("z");
        QTest::newRow("left") << "pushLeft" << -1.0 << 0.0 << 0.0;
        QTest::newRow("right") << "pushRight" << 1.0 << 0.0 << 0.0;
        QTest::newRow("away") << "pushAway" << 0.0 << 1.0 << 0.0;
        QTest::newRow("towards") << "pushTowards" << 0.0 << -1.0 << 0.0;
        QTest::newRow("up") << "pushUp" << 0.0 << 0.0 << 1.0;
        QTest::newRow("down") << "pushDown" << 0.0 << 0.0 << -1.0;
    }
    void aForceIsTriedAsLongAsAButtonIsHeld()
    {
        QFETCH(QString, button);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        m_page->setReport(kArm, ready());
        auto* push = child<QPushButton>(qPrintable(button));
        QVERIFY(m_page->testForce() == glm::dvec3(0.0));
        QTest::mousePress(push, Qt::LeftButton);
        QVERIFY(glm::distance(m_page->testForce(), ui::devices::ForceTest::kTestN * glm::dvec3(x, y, z)) < 1.0e-9);
        QVERIFY(glm::length(m_page->testForce()) <= 1.0);
        QTest::mouseRelease(push, Qt::LeftButton);
        QVERIFY(m_page->testForce() == glm::dvec3(0.0));
        push->setFocus();
        QTest::keyPress(push, Qt::Key_Space);
        QVERIFY(glm::length(m_page->testForce()) > 0.0);
        // A lost device receives no force, even while a key is held.
        m_page->setReport(kArm, at(DeviceStage::Silent));
        QVERIFY(m_page->testForce() == glm::dvec3(0.0));
        QTest::keyRelease(push, Qt::Key_Space);
    }

    void theNextStepUsesTheHandThatIsShown()
    {
        QSignalSpy wanted(m_page, &DevicesPage::handRequested);
        QSignalSpy back(m_actions->back, &QAction::triggered);
        m_page->setReport(kArm, ready());
        click("deviceNext");
        QCOMPARE(back.count(), 1);
        QCOMPARE(wanted.count(), 0);
        hands().setFocus();
        QTest::keyClick(&hands(), Qt::Key_Up);
        QTest::keyClick(&hands(), Qt::Key_Up);
        QCOMPARE(m_page->shownHand(), QString("pointer"));
        QTest::keyClick(&hands(), Qt::Key_Return);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted.front().front().toString(), QString("pointer"));
    }

    void theSimulatedHandMayBeFixed()
    {
        hands().selectHand("simulated");
        QVERIFY(child<QPushButton>("deviceNext")->isEnabled());
        m_page->setSimulatedFixed("Not during an exam.");
        QVERIFY(!child<QPushButton>("deviceNext")->isEnabled());
        QVERIFY(textOf("deviceHelp").contains("Not during an exam."));
        hands().selectHand("pointer");
        QVERIFY(child<QPushButton>("deviceNext")->isEnabled());
        m_page->setChosen("simulated");
        hands().selectHand("pointer");
        QVERIFY(!child<QPushButton>("deviceNext")->isEnabled());
    }

    void theSetupIsTheUsers()
    {
        DeviceSetup setup;
        setup.stand = DeviceSetup::Stand::OnItsBack;
        setup.side = DeviceSetup::Side::Left;
        setup.scale = 2.5;
        QSignalSpy changed(m_page, &DevicesPage::setupChanged);
        m_page->setSetup(kArm, setup);
        QCOMPARE(changed.count(), 0);
        QVERIFY(child<QRadioButton>("standOnItsBack")->isChecked());
        QVERIFY(child<QRadioButton>("sideLeft")->isChecked());
        QCOMPARE(child<QDoubleSpinBox>("scale")->value(), 2.5);
        const QString picture = child<QWidget>("placement")->accessibleDescription();
        child<QRadioButton>("standUpright")->click();
        child<QRadioButton>("sideRight")->click();
        child<QDoubleSpinBox>("scale")->setValue(1.5);
        QCOMPARE(changed.count(), 3);
        QCOMPARE(changed.back().front().toString(), kArm);
        const auto now = changed.back().at(1).value<DeviceSetup>();
        QVERIFY(now == (DeviceSetup{DeviceSetup::Stand::Upright, DeviceSetup::Side::Right, 1.5}));
        QVERIFY(child<QWidget>("placement")->accessibleDescription() != picture);
        QCOMPARE(child<QDoubleSpinBox>("scale")->minimum(), DeviceSetup::kLeastScale);
        QCOMPARE(child<QDoubleSpinBox>("scale")->maximum(), DeviceSetup::kMostScale);
    }

    void theFirmwareFileSaysWhatItIs()
    {
        m_page->setReport(kArm, at(DeviceStage::NeedsFirmware));
        QVERIFY(isFilled("chooseFirmware"));
        const QString none = textOf("firmwareName");
        FirmwareFile file;
        file.path = QStringLiteral("/tmp/letter.txt");
        file.error.code = core::ErrorCode::WrongKind;
        file.error.detail = "This is not firmware.";
        m_page->setFirmware(kArm, file);
        QVERIFY(textOf("firmwareName") != none);
        QVERIFY(textOf("firmwareFault").contains("This is not firmware."));
        QVERIFY(child<QLabel>("firmwareFault")->isVisible());
        file.error.detail.clear();
        file.sha256 = QString(64, 'b');
        m_page->setFirmware(kArm, file);
        QVERIFY(textOf("firmwareName").contains(file.sha256));
        QVERIFY(!child<QLabel>("firmwareFault")->isVisible());
        file.name = QStringLiteral("known.bin");
        m_page->setFirmware(kArm, file);
        QCOMPARE(textOf("firmwareName"), file.name);
    }

    void aFirmwareFileIsChosen()
    {
        QSignalSpy chosen(m_page, &DevicesPage::firmwareChosen);
        click("chooseFirmware");
        auto* dialog = child<QFileDialog>();
        QVERIFY(dialog != nullptr);
        emit dialog->fileSelected("/tmp/firmware.bin");
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.front().at(0).toString(), kArm);
        QCOMPARE(chosen.front().at(1).toString(), QString("/tmp/firmware.bin"));
        dialog->close();
    }

    void theRuleCanBeCopied()
    {
        m_page->setReport(kArm, notAllowed());
        QCOMPARE(child<QPlainTextEdit>("ruleText")->toPlainText(), arm().rule);
        QVERIFY(isFilled("copyRule"));
        click("copyRule");
        QCOMPARE(QGuiApplication::clipboard()->text(), arm().rule);
    }

    void aDeviceThatIsLeftOutOfTheProgramIsNotOffered()
    {
        ui::devices::DeviceKind kind = arm();
        kind.isInBuild = false;
        m_page->setKinds({kind});
        m_page->setChosen("pointer");
        hands().selectHand(kArm);
        QVERIFY(!child<QPushButton>("deviceNext")->isEnabled());
        QVERIFY(hands().rows().at(2).sign == Sign::Missing);
        for (const char* name : {"rule", "firmwareProgress", "homing", "liveTest", "firmware", "setup", "pen"})
            QVERIFY2(!child<QWidget>(name)->isVisible(), name);
    }

    void thePageTellsWhenItOpensAndCloses()
    {
        QSignalSpy opened(m_page, &DevicesPage::opened);
        m_page->hide();
        m_page->show();
        QCOMPARE(opened.count(), 2);
        QCOMPARE(opened.front().front().toBool(), false);
        QCOMPARE(opened.back().front().toBool(), true);
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
        openPage();
        m_page->setKinds({arm()});
        m_page->setChosen(kArm);
        m_window->resize(size);
        m_page->resize(size);
        const auto draw = [&](const QString& name) {
            for (int n = 0; n < 3; ++n)  // a layout may trigger another one
                QCoreApplication::processEvents();
            const QImage image = m_window->grab().toImage();
            pictures::keep(
                image,
                QStringLiteral("devices-%1-%2-%3").arg(name, isDark ? "dark" : "light", QString::number(size.width())));
            QCOMPARE(image.deviceIndependentSize().toSize(), size);
            QVERIFY2(isWhollyShown(), qPrintable(name));
        };
        const QStringList names{"absent", "unavailable", "firmware", "loading", "homing", "ready", "silent"};
        for (int stage = 0; stage < names.size(); ++stage) {
            DeviceReport report = stage == static_cast<int>(DeviceStage::Ready) ? ready() : at(DeviceStage(stage));
            report.progress = 0.45;
            if (report.stage == DeviceStage::Homing)
                report.homed = {true, false, true};
            if (report.stage == DeviceStage::Unavailable) {
                report.error.code = core::ErrorCode::Busy;
                report.error.detail = "Another program uses the device; close it.";
            }
            m_page->setReport(kArm, report);
            draw(names.at(stage));
        }
        m_page->setReport(kArm, notAllowed());
        m_page->setSetup(kArm, {DeviceSetup::Stand::OnItsBack, DeviceSetup::Side::Right, 2.0});
        draw("denied");
        hands().selectHand("pointer");
        draw("pointer");
        hands().selectHand("simulated");
        draw("simulated");
    }

private:
    [[nodiscard]] HandList& hands() const { return *child<HandList>(); }
    /// Returns whether no card is wider than the scroll area, which scrolls only vertically.
    [[nodiscard]] bool isWhollyShown() const
    {
        for (const char* name : {"rule", "homing", "liveTest", "firmware", "setup"})
            if (const auto* card = child<QWidget>(name); card->isVisible()) {
                const QWidget* const port = card->parentWidget()->parentWidget();
                if (card->mapTo(port, QPoint(card->width(), 0)).x() > port->width() ||
                    card->width() < card->minimumSizeHint().width() ||
                    card->height() < card->minimumSizeHint().height())
                    return false;
            }
        return true;
    }
    [[nodiscard]] bool isFilled(const char* button) const
    {
        return child<QPushButton>(button)->property("kind") == "filled";
    }
};

CUSP_TEST(TestDevicesPage)
#include "tst_devices_page.moc"
