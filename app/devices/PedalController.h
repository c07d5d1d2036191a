// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include <QObject>
#include <QTimer>

#include "app/devices/ControllerStore.h"
#include "haptics/DeviceSwitch.h"
#include "haptics/pedal/ControllerInput.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Connects foot pedals and gamepads with the program: the chosen pedal runs the bur, a gamepad moves it, and buttons
/// trigger the actions that the user has assigned to them. Shows all of them on the page of devices and saves the
/// settings. Ui thread.
///
/// When the chosen pedal is unplugged, the bur stops at once. The controller then switches the drill off and shows a
/// message. A user who switches the drill on again works without the pedal.
class PedalController final : public QObject
{
    Q_OBJECT

public:
    /// @param bur          must outlive the controller
    /// @param isSimulated  returns whether the simulated hand is in use, which works without a pedal
    PedalController(ui::window::MainWindow& window, haptics::DeviceSwitch& bur, std::function<bool()> isSimulated);
    /// Call it when no thread reads the switch any more.
    ~PedalController() override;

private:
    void connectPage();
    void poll();
    void choosePedal();
    void takeControllers(const std::vector<core::session::Controller>& controllers);
    void followPedal(const core::session::ControllerReport& report);
    void losePedal();
    void regainPedal();
    void switchDrill(bool on);
    void pressButtons(const core::session::Controller& controller, const std::vector<std::uint32_t>& before);
    void press(ui::devices::ControllerAction action);
    void pressFixed(std::size_t button);
    void steer(const std::vector<core::session::Controller>& controllers);
    [[nodiscard]] const ui::devices::ControllerSettings& settingsOf(const core::session::Controller& controller);

    ui::window::MainWindow& m_window;
    haptics::DeviceSwitch& m_bur;
    std::function<bool()> m_isSimulated;
    ChosenPedal m_chosen;
    std::map<QString, ui::devices::ControllerSettings>
        m_settings;  ///< settings of each kind of controller that has been plugged in, by GUID
    std::map<int, std::vector<std::uint32_t>>
        m_presses;  ///< presses of each button that have been handled, by instance of the controller
    haptics::FootPedal m_pedal;
    haptics::ControllerInput m_input;
    QTimer m_poll;
    bool m_works = false;        ///< the chosen pedal runs the bur
    bool m_isLost = false;       ///< the chosen pedal was unplugged while it ran the bur
    bool m_mustStop = false;     ///< the drill has to be switched off because the pedal was unplugged
    bool m_hasStopped = false;   ///< the drill was switched off because the pedal was unplugged
    int m_viewpoint = 0;         ///< index of the viewpoint that a button showed last
    std::set<int> m_restedPads;  ///< instances of the gamepads whose trigger has been released since plugging in
};

}  // namespace app
