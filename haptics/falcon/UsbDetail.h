// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/base/Result.h"

struct libusb_context;
struct libusb_device;
struct libusb_device_handle;

/// Helper functions around libusb for Usb and FtdiPort.
namespace haptics::falcon {

/// The devices on the USB at the time of construction.
class DeviceList
{
public:
    explicit DeviceList(libusb_context* context);
    ~DeviceList();
    DeviceList(const DeviceList&) = delete;
    DeviceList& operator=(const DeviceList&) = delete;

    /// Returns the devices with the ids of a Falcon. Valid as long as the list.
    [[nodiscard]] std::vector<libusb_device*> falcons() const;

private:
    libusb_device** m_devices = nullptr;
    std::ptrdiff_t m_count = 0;
};

using OpenedDevice = std::unique_ptr<libusb_device_handle, void (*)(libusb_device_handle*)>;

[[nodiscard]] core::Result<OpenedDevice> openDevice(libusb_device* device);
/// Returns the serial number; empty if there is none or it cannot be read.
[[nodiscard]] std::string serialOf(libusb_device_handle* handle);
/// Returns the error for an error code of libusb.
[[nodiscard]] core::Error usbError(int code);

}  // namespace haptics::falcon
