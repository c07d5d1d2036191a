// SPDX-License-Identifier: GPL-3.0-or-later
// A foot pedal and a gamepad in the whole program, simulated by SDL's virtual joysticks.
#include <cmath>

#include <glm/geometric.hpp>

#include "tests/app/ProgramWindow.h"
#include "tests/support/OpenGlMain.h"
#include "tests/support/VirtualController.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/HandList.h"
#include "ui/devices/PedalCard.h"
#include "ui/kit/AppSettings.h"
#include "ui/tooth/ToothView.h"

using core::session::PedalStage;
using support::VirtualController;
using ui::devices::ControllerAction;
using ui::devices::ControllerSettings;
using ui::devices::PedalCard;

class TestPedal : public support::ProgramWindow
{
    Q_OBJECT
private slots:
    void initTestCase() { QCOMPARE(SDL_InitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER), 0); }
    void cleanupTestCase() { SDL_QuitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER); }
    void init()
    {
        QLocale::setDefault(QLocale("en_GB"));
        ui::kit::memory().clear();
        m_folder = std::make_unique<QTemporaryDir>();
    }
    void cleanup()
    {
        m_application.reset();
        m_pedal.reset();
    }

    void thePedalRunsTheBurAndStopsItWhenItIsUnplugged()
    {
        start();
        waitForTooth();
        plugInPedal();
        // The hand presses on the tooth, but the pedal is up: nothing is cut.
        press({1.5, 1.0, -1.0});
        WAIT_FOR(servo().touching);
        waitForTicks(200);
        QVERIFY(!servo().drillOn);
        QVERIFY(!hasCut());
        m_pedal->setAxis(0, 0.05);
        WAIT_FOR(servo().drillOn && servo().burRpm > 0.0);
        const double half = servo().burRpm;
        m_pedal->setAxis(0, 1.0);
        WAIT_FOR(servo().burRpm > 1.5 * half);
        WAIT_FOR(hasCut());

        m_pedal.reset();
        WAIT_FOR(!servo().drillOn);
        waitForMessage("unplugged");
        WAIT_FOR(!actions().drill->isChecked());
        release();
        m_pedal = pedal();
        WAIT_FOR(actions().drill->isChecked());
        waitForMessage("again");
        QVERIFY(!servo().drillOn);
        m_pedal->setAxis(0, 1.0);
        WAIT_FOR(servo().drillOn);
    }

    void withoutThePedalTheMouseGoesOn()
    {
        start();
        waitForTooth();
        plugInPedal();
        m_pedal.reset();
        WAIT_FOR(!actions().drill->isChecked());
        actions().drill->trigger();
        WAIT_FOR(servo().drillSwitchedOn);
        drill(1.5);
        QVERIFY(hasCut());
    }

    void theChoiceIsRememberedOnTheStation()
    {
        start();
        waitForTooth();
        plugInPedal();
        m_application.reset();
        start();
        waitForTooth();
        WAIT_FOR(card().state().report.pedal == PedalStage::Ready);
        m_pedal->setAxis(0, 1.0);
        WAIT_FOR(servo().drillOn && servo().burRpm > 0.0);
        m_pedal->setAxis(0, -1.0);
        WAIT_FOR(!servo().drillOn);
    }

    void aGamepadDrillsWithoutAMouse()
    {
        VirtualController pad("A pad", SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6, 15);
        pad.setAxis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, -1.0);
        pad.setAxis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -1.0);
        start();
        waitForTooth();
        WAIT_FOR(!card().state().report.controllers.empty());
        const QString whole = removed();
        const glm::dvec3 before = servo().anchorMm;
        pad.setAxis(SDL_CONTROLLER_AXIS_LEFTX, 1.0);
        WAIT_FOR(glm::distance(servo().anchorMm, before) > 0.3);
        pad.setAxis(SDL_CONTROLLER_AXIS_LEFTX, 0.0);
        pad.setAxis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 1.0);
        WAIT_FOR(removed() != whole);
        pad.setAxis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -1.0);
        waitForStrokeEnd();
        WAIT_FOR(actions().undo->isEnabled());
        tap(pad, SDL_CONTROLLER_BUTTON_B);
        WAIT_FOR_VALUE(removed(), whole);
        const double azimuthDeg = window().view().camera().azimuthDeg();
        pad.setAxis(SDL_CONTROLLER_AXIS_RIGHTX, 1.0);
        WAIT_FOR(std::abs(window().view().camera().azimuthDeg() - azimuthDeg) > 10.0);
        pad.setAxis(SDL_CONTROLLER_AXIS_RIGHTX, 0.0);
        const std::uint8_t bur = servo().burIndex;
        tap(pad, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER);
        WAIT_FOR(servo().burIndex != bur);
        const bool hasMirror = actions().mirror->isChecked();
        tap(pad, SDL_CONTROLLER_BUTTON_X);
        WAIT_FOR(actions().mirror->isChecked() != hasMirror);
        // Moves the focus through the panel and back.
        window().activateWindow();
        WAIT_FOR(window().isActiveWindow());
        window().view().setFocus();
        WAIT_FOR(window().view().hasFocus());
        tap(pad, SDL_CONTROLLER_BUTTON_DPAD_DOWN);
        WAIT_FOR(QApplication::focusWidget() != nullptr && QApplication::focusWidget() != &window().view());
        tap(pad, SDL_CONTROLLER_BUTTON_BACK);
        WAIT_FOR(window().view().hasFocus());
    }

private:
    void start()
    {
        app::WindowOptions options;
        options.source = {36};
        begin(options);
    }
    [[nodiscard]] PedalCard& card() const { return window().devicesPage().pedals(); }
    static std::unique_ptr<VirtualController> pedal()
    {
        auto made = std::make_unique<VirtualController>("A pedal", SDL_JOYSTICK_TYPE_THROTTLE, Uint16{2}, Uint16{2});
        made->setAxis(0, -1.0);
        return made;
    }
    /// Plugs in a pedal that is configured to run the bur.
    void plugInPedal()
    {
        m_pedal = pedal();
        WAIT_FOR(card().shown() != nullptr);
        const QString guid = QString::fromStdString(card().shown()->guid);
        ControllerSettings settings;
        settings.axis = 0;
        emit card().settingsChanged(guid, settings);
        emit card().pedalChosen(guid, "A pedal");
        WAIT_FOR(card().state().report.pedal == PedalStage::Ready);
    }
    /// Holds a gamepad button until the program has seen it, and releases it.
    void tap(VirtualController& pad, int button) const
    {
        const auto isHeld = [this, button] {
            return card().shown() != nullptr && card().shown()->isHeld(static_cast<std::size_t>(button));
        };
        pad.setButton(button, true);
        WAIT_FOR(isHeld());
        pad.setButton(button, false);
        WAIT_FOR(!isHeld());
    }

    std::unique_ptr<VirtualController> m_pedal;
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestPedal>(argc, argv);
}

#include "tst_pedal.moc"
