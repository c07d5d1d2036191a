// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <vector>

// The shared library hides everything but these functions.
#pragma GCC visibility push(default)
#include <libusb-1.0/libusb.h>
#pragma GCC visibility pop

#include "tests/support/falcon/EmulatedFalcon.h"
#include "tests/support/falcon/Misuse.h"

/// The objects behind libusb's pointers. The bus's mutex guards all of them.
struct libusb_device
{
    libusb_context* context = nullptr;          ///< each context has its own
    support::EmulatedFalcon* falcon = nullptr;  ///< null: unplugged, or the context has ended
    std::string serial;
    int port = 0;
    int address = 0;
    int references = 0;  ///< held by the program and by events that it has not received yet
};

struct libusb_device_handle
{
    libusb_device* device = nullptr;
    bool open = false;
    bool claimed = false;
    bool autoDetach = false;
    bool detached = false;  ///< a kernel driver, which comes back when the interface is released
    int configuration = 1;
};

namespace support {

struct HotplugCallback
{
    int number;
    int events;
    int vendor;
    int product;
    libusb_hotplug_callback_fn function;
    void* user;
};

struct HotplugEvent
{
    libusb_device* device;
    libusb_hotplug_event event;
};

struct UsbTransfer
{
    enum class State {
        Idle,
        Active,
        Done,  ///< its callback has not been called yet
        Freed,
    };

    State state = State::Idle;
    bool cancelled = false;
    falcon::Time deadline = falcon::kNever;
    falcon::Time sent = falcon::kNever;  ///< OUT: when the chip has taken all bytes
    libusb_transfer* usb = nullptr;
};

}  // namespace support

struct libusb_context
{
    int references = 0;
    std::vector<support::HotplugCallback> callbacks;
    int lastCallback = 0;
    std::deque<support::HotplugEvent> events;
    std::vector<support::UsbTransfer*> active;  ///< in the order of submission
    std::vector<support::UsbTransfer*> done;
    std::thread::id handler;  ///< thread that handles events
    bool interrupted = false;
};

namespace support {

/// State that the libusb functions share.
struct UsbAccess
{
    // Handles and transfers are never removed, so that the use of closed and freed ones is detected.
    std::vector<std::unique_ptr<libusb_context>> contexts;
    std::vector<std::unique_ptr<libusb_device_handle>> handles;
    std::unordered_map<const libusb_transfer*, UsbTransfer> transfers;
    std::vector<std::unique_ptr<libusb_device>> devices;
    libusb_context* defaultContext = nullptr;
    void (*onFirstInit)() = nullptr;  ///< called once, without the lock, before libusb_init does anything

    using Lock = std::unique_lock<std::mutex>;
    [[nodiscard]] static Lock lock() { return Lock(emulatedBus().m_mutex); }
    static std::condition_variable& changed() { return emulatedBus().m_changed; }
    static void advance(falcon::Time now) { emulatedBus().advance(now); }
    static bool usbPresent() { return emulatedBus().m_usbPresent; }

    static falcon::Hardware& hardware(EmulatedFalcon& device) { return device.m_hardware; }
    static bool& claimed(EmulatedFalcon& device) { return device.m_claimed; }
    static bool isDenied(const EmulatedFalcon& device) { return device.m_denied; }
    static bool isBusy(const EmulatedFalcon& device) { return device.m_busy; }
    static bool& kernelDriver(EmulatedFalcon& device) { return device.m_kernelDriver; }

    /// Makes the context's objects for a device that is plugged in.
    libusb_device& addDevice(libusb_context& context, EmulatedFalcon& falcon);
    void addDevices(libusb_context& context);

    /// Aborts if the pointer is not one that libusb gave out and that is still valid. Null is the default context.
    libusb_context& context(libusb_context* pointer);
    libusb_device& device(libusb_device* pointer);
    libusb_device_handle& handle(libusb_device_handle* pointer);
    UsbTransfer& transfer(libusb_transfer* pointer);

    void dropUnusedDevices();
};

[[nodiscard]] UsbAccess& usb();

// Called with the bus locked.
void usbArrived(EmulatedFalcon& device);
void usbLeft(EmulatedFalcon& device);
[[nodiscard]] UsbObjects usbObjects();

/// Calls the hot-plug callbacks that are due. Unlocks during the calls. Returns false if there was none.
bool tellHotplug(libusb_context& context, UsbAccess::Lock& lock);

}  // namespace support
