// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/falcon/Hardware.h"

/// Novint Falcons without hardware. A program that links the object library `emulated_falcon` has its libusb functions
/// from here, so that the driver runs as it is: open, control requests, transfers, hot-plug.
///
/// A test plugs devices into emulatedBus(), which is empty at first, and then controls and inspects them, from any
/// thread. Mistakes in the use of libusb end the program with a message.
///
/// For a program that is not linked with it there is the shared library libemulated_falcon.so, see Preload.cpp.
namespace support {

class EmulatedBus;

/// The visible state of a device at one moment.
struct FalconState
{
    bool plugged = false;
    bool claimed = false;  ///< by this program
    bool mains = true;
    bool firmwareRuns = false;
    std::array<std::int16_t, 3> motors{};  ///< command in force
    haptics::falcon::Leds leds{};
    bool homing = false;  ///< the homing bit of the last request
    std::array<bool, 3> homed{};
    std::array<std::int16_t, 3> counts{};
    std::uint64_t requests = 0;  ///< received by the firmware
    std::uint64_t answers = 0;   ///< sent by it
    int queries = 0;             ///< received by the boot loader
    int loads = 0;               ///< images received completely
    std::size_t imageBytes = 0;  ///< received of the last image
    std::optional<falcon::Time> lastRequest;
    std::optional<falcon::Time> lastNonZero;  ///< last request whose motor commands were not all zero
    glm::dvec3 gripMm{0.0};                   ///< device frame
    glm::dvec3 forceN{0.0};                   ///< of the motors on the hand, device frame
    std::array<std::uint64_t, kFaults> faults{};

    [[nodiscard]] bool allHomed() const { return homed[0] && homed[1] && homed[2]; }
    [[nodiscard]] bool motorsAreZero() const { return motors == std::array<std::int16_t, 3>{}; }
};

/// One device: the controls and the inspection functions for a test.
class EmulatedFalcon
{
public:
    EmulatedFalcon(EmulatedBus& bus, std::string serial, int port);
    EmulatedFalcon(const EmulatedFalcon&) = delete;
    EmulatedFalcon& operator=(const EmulatedFalcon&) = delete;

    [[nodiscard]] const std::string& serial() const { return m_serial; }

    // Plug and power. A controller keeps its firmware while it is unplugged, until losePower().
    void plug();
    void unplug();
    void setMains(bool on);  ///< without it homing never completes and the motors have no force
    void losePower(bool replugs = false);
    /// @param count  1: at the first occurrence from now on
    void plan(Accident what, Moment when, int count = 1);

    // Results of the operating system.
    void setDenied(bool denied);          ///< libusb_open gives LIBUSB_ERROR_ACCESS
    void setBusy(bool busy);              ///< another program has claimed it
    void setKernelDriver(bool attached);  ///< a kernel driver is attached to it

    // Controller.
    void setBoot(const falcon::BootOptions& options);
    /// Starts the firmware, as if another program had loaded it.
    void startFirmware();
    void setButton(haptics::falcon::Button button, bool down);
    void setFault(Fault fault, double share);       ///< of the exchanges
    void setFaults(double share);                   ///< of the exchanges, all faults together
    void addFault(Fault fault, int exchanges = 1);  ///< in the next exchanges

    // Arm. The hand that moves it needs the time of the real clock.
    void moveTo(const glm::dvec3& deviceMm, std::chrono::milliseconds duration = {});
    void moveTip(const glm::dvec3& toothMm, std::chrono::milliseconds duration = {});
    void setHand(const std::optional<haptics::HandFigures>& hand);  ///< empty: the grip is where it was set
    void setCommandsPerNm(double commands);
    /// Moves the grip fully out and in again, past all index marks, and back. With the homing bit set the legs are
    /// homed after it. Without a hand only.
    void pullOutAndPushIn();

    // Inspection.
    [[nodiscard]] FalconState state();
    [[nodiscard]] std::vector<std::uint8_t> image();
    /// Returns up to Hardware::kRemembered answers, newest last.
    [[nodiscard]] std::vector<SentAnswer> history();

private:
    friend class EmulatedBus;
    friend struct UsbAccess;

    [[nodiscard]] FalconState stateNow() const;
    /// Runs `change` at the present time, with the bus locked.
    template <typename Change>
    void change(Change&& change);

    EmulatedBus& m_bus;
    const std::string m_serial;
    const int m_port;
    falcon::Pace m_pace = falcon::Pace::Real;
    falcon::Hardware m_hardware;
    bool m_plugged = false;
    int m_address = 0;
    bool m_claimed = false;
    bool m_denied = false;
    bool m_busy = false;
    bool m_kernelDriver = false;
};

/// Number of libusb objects that a program has not released.
struct UsbObjects
{
    int contexts = 0;
    int handles = 0;
    int transfers = 0;
    int deviceReferences = 0;  ///< held by the program
    int hotplugCallbacks = 0;
    friend bool operator==(const UsbObjects&, const UsbObjects&) = default;
};

class EmulatedBus
{
public:
    /// Makes a device and plugs it in. It lives until clear().
    EmulatedFalcon& plug(std::string serial, falcon::Pace pace = falcon::Pace::Real);
    /// Returns a device, or null if there is none. The device may be unplugged.
    [[nodiscard]] EmulatedFalcon* find(std::string_view serial);
    /// Unplugs and destroys all devices. Their remaining libusb objects answer LIBUSB_ERROR_NO_DEVICE.
    void clear();
    /// Sets whether there is USB. Without it libusb_init fails.
    void setUsbPresent(bool present);
    [[nodiscard]] UsbObjects objects();
    /// Sets a function that is called whenever time has passed for a device, with the bus locked: it must not use the
    /// bus.
    void setObserver(std::function<void(const EmulatedFalcon&, const FalconState&)> observer);

private:
    friend class EmulatedFalcon;
    friend struct UsbAccess;

    void advance(falcon::Time now);
    void attach(EmulatedFalcon& device);
    void detach(EmulatedFalcon& device);

    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::vector<std::unique_ptr<EmulatedFalcon>> m_devices;
    std::function<void(const EmulatedFalcon&, const FalconState&)> m_observer;
    bool m_usbPresent = true;
    int m_lastAddress = 0;
};

/// Returns the bus of this process.
[[nodiscard]] EmulatedBus& emulatedBus();

}  // namespace support
