// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/falcon/Usb.h"

#include <libusb-1.0/libusb.h>

#include "haptics/falcon/UsbDetail.h"

namespace haptics::falcon {
namespace {

using core::ErrorCode;
using core::LocalizableText;
using core::noted;
using core::unexpected;

}  // namespace

bool hasUsb() noexcept
{
    return true;
}

core::Result<std::unique_ptr<Usb>> Usb::open()
{
    libusb_context* context = nullptr;
    if (const int code = libusb_init(&context); code != LIBUSB_SUCCESS)
        return unexpected(ErrorCode::FileUnreadable,
                          LocalizableText{"The USB of this computer cannot be used (%1). The mouse works without it.",
                                          {noted(libusb_error_name(code))}});
    return std::unique_ptr<Usb>(new Usb(context));
}

Usb::~Usb()
{
    libusb_exit(m_context);
}

std::vector<FoundFalcon> Usb::falcons() const
{
    std::vector<FoundFalcon> found;
    for (libusb_device* const device : DeviceList(m_context).falcons()) {
        auto opened = openDevice(device);
        if (opened)
            found.push_back({serialOf(opened->get()), {}});
        else
            found.push_back({{}, tl::unexpected(opened.error())});
    }
    return found;
}

DeviceList::DeviceList(libusb_context* context)
{
    m_count = libusb_get_device_list(context, &m_devices);
}

DeviceList::~DeviceList()
{
    if (m_count >= 0)
        libusb_free_device_list(m_devices, 1);
}

std::vector<libusb_device*> DeviceList::falcons() const
{
    constexpr std::uint16_t kVendor = 0x0403;
    constexpr std::uint16_t kProduct = 0xCB48;
    std::vector<libusb_device*> found;
    for (std::ptrdiff_t n = 0; n < m_count; ++n) {
        libusb_device_descriptor descriptor{};
        if (libusb_get_device_descriptor(m_devices[n], &descriptor) == LIBUSB_SUCCESS &&
            descriptor.idVendor == kVendor && descriptor.idProduct == kProduct)
            found.push_back(m_devices[n]);
    }
    return found;
}

core::Error usbError(int code)
{
    switch (code) {
    case LIBUSB_ERROR_ACCESS:
        return unexpected(
                   ErrorCode::NotAllowed,
                   LocalizableText{
                       "You have no permission to use the Falcon. Install the rule that %1 prints, then unplug the "
                       "Falcon and plug it in again.",
                       {noted("\"cusp falcon rules\"")}})
            .value();
    case LIBUSB_ERROR_BUSY:
        return unexpected(ErrorCode::Busy, LocalizableText{"Another program uses the Falcon. Close that program."})
            .value();
    case LIBUSB_ERROR_NOT_SUPPORTED:
        return unexpected(ErrorCode::NotAllowed,
                          LocalizableText{"Another driver of the system holds the Falcon. Give it the driver WinUSB."})
            .value();
    default:
        return unexpected(ErrorCode::ConnectionLost,
                          LocalizableText{
                              "The USB connection to the Falcon failed (%1). Unplug the Falcon and plug it in again.",
                              {noted(libusb_error_name(code))}})
            .value();
    }
}

core::Result<OpenedDevice> openDevice(libusb_device* device)
{
    libusb_device_handle* handle = nullptr;
    if (const int code = libusb_open(device, &handle); code != LIBUSB_SUCCESS)
        return tl::unexpected(usbError(code));
    return OpenedDevice(handle, &libusb_close);
}

std::string serialOf(libusb_device_handle* handle)
{
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(libusb_get_device(handle), &descriptor) != LIBUSB_SUCCESS ||
        descriptor.iSerialNumber == 0)
        return {};
    unsigned char text[128]{};
    const int size = libusb_get_string_descriptor_ascii(handle, descriptor.iSerialNumber, text, sizeof(text));
    std::string serial;
    for (int n = 0; n < size; ++n)
        serial += text[n] > ' ' && text[n] < 0x7F ? static_cast<char>(text[n]) : '?';
    return serial;
}

}  // namespace haptics::falcon
