// SPDX-License-Identifier: GPL-3.0-or-later
// The devices of a station in the whole program, with a force device that a test plays.
#include <cmath>

#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QRadioButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QToolButton>

#include <glm/geometric.hpp>

#include "tests/app/ProgramWindow.h"
#include "tests/app/ScriptedDevice.h"
#include "tests/support/OpenGlMain.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/HandList.h"
#include "ui/kit/AppSettings.h"
#include "ui/kit/ConfirmOverlay.h"
#include "ui/people/LoginPage.h"
#include "ui/scoring/ScorePage.h"
#include "ui/tooth/ToothView.h"

using core::session::DeviceSetup;
using core::session::DeviceStage;

class TestDevices : public support::ProgramWindow
{
    Q_OBJECT
private slots:
    void init()
    {
        QLocale::setDefault(QLocale("en_GB"));
        ui::kit::memory().clear();
        m_folder = std::make_unique<QTemporaryDir>();
        m_script = std::make_shared<support::DeviceScript>();
    }
    void cleanup() { m_application.reset(); }

    void theChoiceIsRememberedOnTheStation()
    {
        start();
        QVERIFY(!m_script->isRunning);
        openPage();
        WAIT_FOR(m_script->isRunning);  // to see whether it is plugged in
        use("arm");
        child<QRadioButton>("sideRight")->click();
        WAIT_FOR(m_script->setup().side == DeviceSetup::Side::Right);
        emit child<ui::devices::DevicesPage>()->firmwareChosen("arm", "/tmp/arm.bin");
        QCOMPARE(m_script->firmware(), std::string("/tmp/arm.bin"));
        actions().back->trigger();
        WAIT_FOR(m_script->isRunning);
        m_application.reset();
        QVERIFY(!m_script->isRunning);

        m_script = std::make_shared<support::DeviceScript>();
        start();
        QVERIFY(m_script->isRunning);
        QVERIFY(m_script->setup().side == DeviceSetup::Side::Right);
        QCOMPARE(m_script->firmware(), std::string("/tmp/arm.bin"));
        openPage();
        use("pointer");
        QVERIFY(m_script->isRunning);
        actions().back->trigger();
        WAIT_FOR(!m_script->isRunning);
    }

    void theHeightOfTheRestIsRememberedOnTheStation()
    {
        start();
        chooseArm();
        openPage();
        click("openHandGuide");
        core::session::DeviceReport report;
        report.stage = DeviceStage::Ready;
        report.tipMm = {0.0F, 0.0F, 12.0F};
        m_script->report(report);
        child<QRadioButton>("leftHand")->click();
        QVERIFY(child<ui::tooth::ToothView>()->isLeftHanded());
        click("guideNext");
        click("guideNext");
        WAIT_FOR(child<QLabel>("gripHeight")->text().contains("12 mm"));
        click("storeHeight");
        WAIT_FOR(m_script->setup().restMm > 11.9);
        m_application.reset();
        m_script = std::make_shared<support::DeviceScript>();
        start();
        QVERIFY(std::abs(m_script->setup().restMm - 12.0) < 1e-6);
        QVERIFY(child<ui::tooth::ToothView>()->isLeftHanded());
    }

    void theCurveOfThePenIsRememberedOnTheStation()
    {
        start();
        QCOMPARE(child<QDoubleSpinBox>("penCurve")->value(), 1.0);
        child<QDoubleSpinBox>("penCurve")->setValue(2.0);
        m_application.reset();
        start();
        QCOMPARE(child<QDoubleSpinBox>("penCurve")->value(), 2.0);
        m_application.reset();
        ui::kit::memory().setValue("pen/curve", 99.0);
        start();
        QCOMPARE(child<QDoubleSpinBox>("penCurve")->value(), 1.0);
    }

    void aReadyDeviceMovesTheBurAndIsNotedInTheAttempt()
    {
        start();
        logIn();
        chooseArm();
        QVERIFY(actions().bringHome->isVisible());
        QVERIFY(!child<QSlider>("feed")->isVisible());
        QVERIFY(child<QLabel>("forceDevice")->isVisible());
        QVERIFY(child<QToolButton>("deviceButton")->toolTip().contains("Test Arm"));
        cutWithArm();
        gradeUntil<ui::scoring::ScorePage>();
        WAIT_FOR_VALUE(deviceOfTheAttempt(), QString("arm"));
    }

    void theMouseGoesOnWhileADeviceIsLost()
    {
        start();
        chooseArm();
        cutWithArm();
        const QString cut = removed();
        const std::uint64_t attempt = servo().toothGeneration;
        for (float z = 4.0F; z > -4.0F && !servo().touching; z -= 0.05F) {
            m_script->moveTo({2.0F, 1.0F, z});
            waitForTicks(20);
        }
        WAIT_FOR(servo().touching);
        m_script->stage(DeviceStage::Silent);
        waitForMessage("Test Arm");
        WAIT_FOR(child<QSlider>("feed")->isVisible());
        QVERIFY(!actions().bringHome->isVisible());
        // The bur is above the tooth, and nothing pushes it.
        WAIT_FOR(!servo().touching && heightOverTheTooth() > 0.3);
        QVERIFY(glm::length(servo().forceN) < 0.01);
        const QString lost = message();
        drill(2.0);
        QVERIFY(removed() != cut);
        QCOMPARE(servo().toothGeneration, attempt);

        m_script->moveTo({0.0F, 0.0F, 9.0F});
        m_script->stage(DeviceStage::Ready);
        WAIT_FOR(message() != lost);
        QVERIFY(message().contains("Test Arm"));
        WAIT_FOR(isOverTheTooth());
        QCOMPARE(servo().toothGeneration, attempt);
        QVERIFY(!child<QSlider>("feed")->isVisible());
    }

    void aDeviceThatWaitsForTheUserSaysSo()
    {
        start();
        chooseArm();
        m_script->stage(DeviceStage::Absent);
        waitForMessage("Test Arm");
        const QString lost = message();
        m_script->stage(DeviceStage::Homing);
        WAIT_FOR(message() != lost);
        QVERIFY(message().contains("Test Arm"));
        child<ui::kit::MessageBar>()->findChild<QPushButton*>("")->click();
        waitForPage<ui::devices::DevicesPage>();
        QVERIFY(child<QWidget>("homing")->isVisible());
        m_script->stage(DeviceStage::Ready);
        WAIT_FOR(child<QWidget>("liveTest")->isVisible());
    }

    void anOfferDoesNotHideThatADeviceIsLost()
    {
        start();
        chooseArm();
        using ui::kit::MessageBar;
        child<MessageBar>()->say(
            MessageBar::Message{MessageBar::Kind::Warning, QStringLiteral("An offer"), {}, {}, {}});
        // Each stage has a message of its own. The first of them may come after one that was there before.
        QStringList said;
        const auto isNew = [&] { return message().contains("Test Arm") && !said.contains(message()); };
        for (const DeviceStage stage : {DeviceStage::Absent, DeviceStage::Homing, DeviceStage::NeedsFirmware}) {
            m_script->stage(stage);
            WAIT_FOR(isNew());
            said << message();
        }
        child<MessageBar>()->dismiss();
        QCOMPARE(message(), QStringLiteral("An offer"));
    }

    void theGripButtonsAreTheWindowsActions()
    {
        start();
        chooseArm();
        cutWithArm();
        WAIT_FOR(actions().undo->isEnabled());
        QSignalSpy undo(actions().undo, &QAction::triggered);
        QSignalSpy mirror(actions().mirror, &QAction::triggered);
        QSignalSpy centre(actions().bringHome, &QAction::triggered);
        m_script->press(0);  // the pedal is the device's own business
        m_script->press(1);
        WAIT_FOR_VALUE(undo.count(), 1);
        m_script->press(2);
        WAIT_FOR_VALUE(mirror.count(), 1);
        m_script->press(3);
        WAIT_FOR_VALUE(centre.count(), 1);
        QCOMPARE(undo.count(), 1);
        // Where no tooth is seen, they do nothing.
        openPage();
        m_script->press(1);
        actions().back->trigger();
        WAIT_FOR(actions().bringHome->isVisible());  // the arm moves the bur again
        m_script->press(2);
        WAIT_FOR_VALUE(mirror.count(), 2);
        QCOMPARE(undo.count(), 1);
    }

    void theForceIsTriedOnThePageOnly()
    {
        start();
        chooseArm();
        openPage();
        WAIT_FOR(child<QPushButton>("pushLeft")->isVisible());
        QTest::mousePress(child<QPushButton>("pushLeft"), Qt::LeftButton);
        WAIT_FOR(m_script->testForce().x < -0.1);
        QTest::mouseRelease(child<QPushButton>("pushLeft"), Qt::LeftButton);
        WAIT_FOR(m_script->testForce() == glm::dvec3(0.0));
    }

    void anAttemptThatNobodyHasBegunFeelsAsTheDeviceCan()
    {
        start();
        const std::uint64_t before = servo().toothGeneration;
        chooseArm();
        WAIT_FOR(servo().toothGeneration > before);
        // And one that somebody has worked on stays.
        cutWithArm();
        const std::uint64_t worked = servo().toothGeneration;
        openPage();
        use("pointer");
        actions().back->trigger();
        WAIT_FOR(child<QSlider>("feed")->isVisible());
        waitForTicks(200);
        QCOMPARE(servo().toothGeneration, worked);
    }

    void theSimulatedHandIsChosenAndLeft()
    {
        start();
        drill(-2.0);
        WAIT_FOR_VALUE(journals().size(), 1);
        const std::uint64_t own = servo().toothGeneration;
        openPage();
        hands().selectHand("simulated");
        click("deviceNext");
        WAIT_FOR(child<ui::kit::ConfirmOverlay>("workQuestion") != nullptr);
        click("questionDiscard");
        WAIT_FOR(servo().toothGeneration > own);
        waitForTooth();
        WAIT_FOR(removed() != "0.00");  // it drills by itself
        QVERIFY(journals().isEmpty());
        const std::uint64_t simulated = servo().toothGeneration;
        openPage();
        use("pointer");
        WAIT_FOR(servo().toothGeneration > simulated);
        waitForTooth();
        WAIT_FOR_VALUE(removed(), QString("0.00"));
        waitForTicks(300);
        QCOMPARE(removed(), QString("0.00"));
        drill(-2.0);
        WAIT_FOR_VALUE(journals().size(), 1);
        // The next run is a student's again.
        QVERIFY(ui::kit::memory().value("devices/hand").toString() != "simulated");
    }

private:
    void start()
    {
        app::WindowOptions options;
        options.source = {36};
        options.devices = {support::scriptedRow(m_script)};
        begin(options);
        waitForTooth();
        WAIT_FOR(servo().tick > 0);
    }
    /// As the admin who creates the school.
    void logIn() const
    {
        window().account().askLogin();
        emit window().loginPage().schoolRequested({"admin", "Ada", "Admin", database::Role::Admin}, "correct horse");
        WAIT_FOR_VALUE(actions().account->text(), QString("admin"));
        actions().back->trigger();
        waitForTooth();
    }
    /// Of the only attempt in the database; empty: there is none.
    [[nodiscard]] QString deviceOfTheAttempt() const
    {
        QString device;
        {
            QSqlDatabase school = QSqlDatabase::addDatabase("QSQLITE", "look");
            school.setDatabaseName(m_folder->filePath("school.sqlite"));
            if (school.open())
                if (QSqlQuery query("SELECT device FROM attempts", school); query.next())
                    device = query.value(0).toString();
        }
        QSqlDatabase::removeDatabase("look");
        return device;
    }
    void openPage() const
    {
        actions().devices->trigger();
        waitForPage<ui::devices::DevicesPage>();
    }
    [[nodiscard]] ui::devices::HandList& hands() const { return *child<ui::devices::HandList>("hands"); }
    void use(const QString& hand) const
    {
        hands().selectHand(hand);
        click("deviceNext");
        WAIT_FOR(isChosen(hand));
    }
    [[nodiscard]] bool isChosen(const QString& hand) const
    {
        for (const auto& row : hands().rows())
            if (row.isChosen)
                return row.id == hand;
        return false;
    }
    /// The arm is ready, and is used in the practice room.
    void chooseArm() const
    {
        m_script->stage(DeviceStage::Ready);
        openPage();
        use("arm");
        actions().back->trigger();
        waitForTooth();
        WAIT_FOR(isOverTheTooth());
        waitForTooth();
    }
    [[nodiscard]] bool isOverTheTooth() const
    {
        return glm::distance(servo().anchorMm, glm::dvec3(m_script->tip())) < 0.05;
    }
    /// Of the tip of the bur, mm.
    [[nodiscard]] double heightOverTheTooth() const
    {
        const core::terrain::Tooth& tooth = *window().view().tooth();
        const glm::dvec2 node = tooth.anatomy->grid.latticeOf(glm::dvec2(servo().anchorMm));
        const std::size_t k = tooth.anatomy->grid.index(qRound(node.x), qRound(node.y));
        return servo().anchorMm.z - static_cast<double>(tooth.top.at(k));
    }
    /// Brings the arm into the tooth with its pedal down, until something is removed, and out again.
    void cutWithArm() const
    {
        const QString before = removed();
        m_script->moveTo({-2.0F, 1.0F, 4.0F});
        WAIT_FOR(isOverTheTooth());
        m_script->isPedalDown = true;
        for (float z = 1.0F; z > -4.0F && removed() == before; z -= 0.1F) {
            m_script->moveTo({-2.0F, 1.0F, z});
            waitForTicks(20);
        }
        WAIT_FOR(removed() != before);
        m_script->isPedalDown = false;
        m_script->moveTo({-2.0F, 1.0F, 6.0F});
        WAIT_FOR(isOverTheTooth());
        waitForStrokeEnd();
    }

    std::shared_ptr<support::DeviceScript> m_script;
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestDevices>(argc, argv);
}

#include "tst_devices.moc"
