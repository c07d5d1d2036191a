// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <QObject>
#include <QString>
#include <QTimer>

#include "app/devices/StationDevices.h"
#include "core/session/DeviceReport.h"
#include "haptics/DeviceSwitch.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Decides which hand moves the bur: mouse or pen, the simulated hand, or a force device while it is ready.
///
/// Starts, watches and stops the force devices of this computer, shows them on the page of devices and saves the user's
/// choice. While that page is open, the pointer moves the bur, and the user can try a device without a tooth. Ui
/// thread.
class DeviceController final : public QObject
{
    Q_OBJECT

public:
    /// The switch that selects the hand, and the two hands that are not force devices. All of them must outlive the
    /// controller.
    struct Hands
    {
        haptics::DeviceSwitch& bur;
        haptics::HapticDevice& pointer;
        haptics::HapticDevice& simulated;
    };
    /// Takes the hand that was chosen in the last run.
    /// @param chosen  id of the hand for this run; empty, or one that this program cannot use: the one of the last run
    DeviceController(ui::window::MainWindow& window, const Hands& hands, std::vector<DeviceRow> rows,
                     const QString& chosen);
    /// Stops the devices. No thread reads the switch any more.
    ~DeviceController() override;

    /// Returns the id of the hand that moves the bur now: "pointer", "simulated" or the id of a kind of force device.
    [[nodiscard]] const QString& inUse() const { return m_inUse; }
    /// Returns the id of the hand that attempts are made with. Unlike inUse(), it does not change while a page covers
    /// the tooth and the pointer moves the bur.
    [[nodiscard]] QString hand() const;
    /// Returns the name of the device that an attempt is stored with: the id of the hand in use or, if that is the
    /// pointer, "mouse", "pen", "keyboard" or "gamepad".
    [[nodiscard]] QString cutsWith() const;
    [[nodiscard]] bool isSimulated() const;
    /// Returns whether the hand in use feels a force.
    [[nodiscard]] bool hasForce() const;
    /// Returns whether the chosen hand feels a force: it is the simulated hand, or a force device that is ready. Unlike
    /// hasForce(), this does not change while a page covers the tooth.
    [[nodiscard]] bool isForceChosen() const;
    /// Returns the distance in millimetres that the chosen hand moves for one millimetre of the bur.
    [[nodiscard]] double scale() const;

signals:
    /// Emitted when another hand moves the bur, and when the user has chosen another hand.
    void inUseChanged();
    /// Emitted when the user has chosen the simulated hand, or another hand in its place. The current attempt starts
    /// again.
    void simulatedChanged();

private:
    struct Device
    {
        DeviceRow row;
        std::unique_ptr<haptics::ForceDevice> device;  ///< null until it is first started
        core::session::DeviceSetup setup;
        QString firmware;
        bool isRunning = false;
    };
    void recall();
    void connectPage();
    void startWanted();
    void start(Device& device);
    void stop(Device& device);
    void poll();
    void want(const QString& id);
    void choose(const QString& id);
    void follow();
    void use(const QString& id);
    void say(const Device& device, bool isReady);
    void askForUser(const Device& device, const core::session::DeviceReport& report);
    void pressButtons(const core::session::DeviceReport& report);
    void showState(const Device* device, const core::session::DeviceReport& report);
    [[nodiscard]] const Device* find(const QString& id) const;
    [[nodiscard]] Device* find(const QString& id);

    ui::window::MainWindow& m_window;
    Hands m_hands;
    std::vector<Device> m_devices;
    QString m_chosen;
    QString m_inUse;
    bool m_isPageOpen = false;
    bool m_wasReady = false;                   ///< the chosen device was ready at the last poll
    bool m_isLost = false;                     ///< the chosen device was in use and is not ready any more
    core::session::DeviceStage m_stage{};      ///< stage of the chosen device at the last poll
    std::array<std::uint32_t, 4> m_presses{};  ///< presses of its grip buttons that have been handled
    QTimer m_poll;
};

}  // namespace app
