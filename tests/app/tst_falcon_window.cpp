// SPDX-License-Identifier: GPL-3.0-or-later
// An emulated Falcon in the whole program, driven through libusb's own functions: selected on the page, homed, used in
// a lesson, unplugged and plugged in again.
#include <QLabel>
#include <QSlider>

#include <glm/geometric.hpp>

#include "haptics/falcon/Kinematics.h"
#include "tests/app/ProgramWindow.h"
#include "tests/support/OpenGlMain.h"
#include "tests/support/falcon/EmulatedFalcon.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/HandList.h"
#include "ui/kit/AppSettings.h"

using namespace std::chrono_literals;
using haptics::falcon::Button;
using support::emulatedBus;
using support::EmulatedFalcon;

class TestFalconWindow : public support::ProgramWindow
{
    Q_OBJECT
private slots:
    void init()
    {
        QLocale::setDefault(QLocale("en_GB"));
        ui::kit::memory().clear();
        m_folder = std::make_unique<QTemporaryDir>();
    }
    void cleanup()
    {
        m_application.reset();
        emulatedBus().clear();
    }

    void aLessonIsDrilledWithTheFalcon()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("FT1");
        falcon.startFirmware();
        app::WindowOptions options;
        options.source = {36};
        begin(options);
        waitForTooth();

        // Selects the Falcon and homes it by hand.
        actions().devices->trigger();
        waitForPage<ui::devices::DevicesPage>();
        child<ui::devices::HandList>("hands")->selectHand("falcon");
        click("deviceNext");
        WAIT_FOR(homed(falcon));
        actions().back->trigger();
        openLesson(std::string("decay-36-small"));
        falcon.moveTip({0.0, 0.0, 6.0}, 100ms);
        WAIT_FOR(isAt(falcon));
        QVERIFY(child<QLabel>("forceDevice")->isVisible());

        // The bur cuts while the button of the grip is held, and the hand feels the tooth.
        const QString before = removed();
        falcon.setButton(Button::Centre, true);
        for (double z = 2.0; z > -5.0 && removed() == before; z -= 0.1) {
            falcon.moveTip({0.0, 0.0, z}, 5ms);
            waitForTicks(30);
        }
        WAIT_FOR(removed() != before);
        WAIT_FOR(falcon.state().forceN.y > 0.05 || servo().touching);
        const std::uint64_t attempt = servo().toothGeneration;

        // The Falcon is unplugged in the middle of a cut: the bur is lifted, and the mouse takes over.
        falcon.unplug();
        waitForMessage("Falcon");
        WAIT_FOR(child<QSlider>("feed")->isVisible());
        WAIT_FOR(!servo().touching);
        QCOMPARE(servo().toothGeneration, attempt);
        const QString lost = message();
        falcon.setButton(Button::Centre, false);

        // The Falcon is plugged in again.
        falcon.plug();
        falcon.moveTip({0.0, 0.0, 8.0}, 5ms);
        WAIT_FOR(homed(falcon) && message() != lost);
        falcon.moveTip({1.0, 0.0, 8.0}, 100ms);
        WAIT_FOR(isAt(falcon));
        QCOMPARE(servo().toothGeneration, attempt);

        // The buttons of the grip undo and redo.
        WAIT_FOR(actions().undo->isEnabled());
        falcon.setButton(Button::Minus, true);
        WAIT_FOR_VALUE(removed(), before);
        falcon.setButton(Button::Minus, false);
    }

    void theToothComesToTheHeightOfTheRest()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("FT1");
        falcon.startFirmware();
        ui::kit::memory().setValue("devices/hand", "falcon");
        app::WindowOptions options;
        options.source = {36};
        begin(options);
        waitForTooth();
        WAIT_FOR(homed(falcon));
        actions().devices->trigger();
        waitForPage<ui::devices::DevicesPage>();
        falcon.moveTip({0.0, 0.0, 20.0}, 100ms);
        click("openHandGuide");
        click("guideNext");
        click("guideNext");
        WAIT_FOR(child<QLabel>("gripHeight")->text().contains("20 mm above"));
        click("storeHeight");
        WAIT_FOR(child<QLabel>("restHeight")->text().contains("20 mm above"));
        actions().back->trigger();  // to the devices
        actions().back->trigger();  // to the tooth
        // The hand is now 6 mm above the top of the tooth.
        falcon.moveTip({0.0, 0.0, 26.0}, 100ms);
        WAIT_FOR(glm::distance(servo().deviceMm, glm::dvec3(0.0, 0.0, 6.0)) < 0.7);
    }

    void theForceIsZeroWhenTheWindowCloses()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("FT1");
        falcon.startFirmware();
        ui::kit::memory().setValue("devices/hand", "falcon");
        app::WindowOptions options;
        options.source = {36};
        begin(options);
        waitForTooth();
        WAIT_FOR(homed(falcon));
        for (double z = 2.0; z > -5.0 && falcon.state().motorsAreZero(); z -= 0.1) {
            falcon.moveTip({0.0, 0.0, z}, 5ms);
            waitForTicks(30);
        }
        WAIT_FOR(!falcon.state().motorsAreZero());
        m_application.reset();
        QVERIFY(falcon.state().motorsAreZero());
        QVERIFY(!falcon.state().claimed);
    }

private:
    /// Moves the grip past its index marks once. Returns whether the device is homed.
    static bool homed(EmulatedFalcon& falcon)
    {
        if (!falcon.state().allHomed())
            falcon.pullOutAndPushIn();
        return falcon.state().allHomed();
    }
    [[nodiscard]] bool isAt(EmulatedFalcon& falcon) const
    {
        const glm::dvec3 tip = haptics::falcon::toothFromDevice(falcon.state().gripMm);
        return glm::distance(servo().deviceMm, tip) < 0.2;
    }
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestFalconWindow>(argc, argv);
}

#include "tst_falcon_window.moc"
