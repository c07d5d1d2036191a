// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/Result.h"

struct libusb_context;
struct libusb_device;

/// Falcons on the USB, by libusb. A program without libusb finds none and returns an error.
namespace haptics::falcon {

/// Returns whether this program was built with libusb.
[[nodiscard]] bool hasUsb() noexcept;

/// The text of a udev rule that lets the user at the computer open a Falcon, and the file for it.
inline constexpr const char* kUdevRule =
    R"(SUBSYSTEM=="usb", ATTR{idVendor}=="0403", ATTR{idProduct}=="cb48", MODE="0660", GROUP="plugdev", TAG+="uaccess")";
inline constexpr const char* kUdevFile = "/etc/udev/rules.d/70-cusp-falcon.rules";

struct FoundFalcon
{
    std::string serial;  ///< empty if the device cannot be opened
    core::Status access;
};

/// The USB of this computer. One thread at a time.
class Usb
{
public:
    /// Opens the USB. Error FileUnreadable if there is none, or the program was built without libusb.
    [[nodiscard]] static core::Result<std::unique_ptr<Usb>> open();
    ~Usb();
    Usb(const Usb&) = delete;
    Usb& operator=(const Usb&) = delete;

    /// Returns the Falcons that are plugged in. Opens each for a moment to read its serial number.
    [[nodiscard]] std::vector<FoundFalcon> falcons() const;

    [[nodiscard]] libusb_context* context() const { return m_context; }

private:
    explicit Usb(libusb_context* context) : m_context(context) {}

    libusb_context* m_context;
};

}  // namespace haptics::falcon
