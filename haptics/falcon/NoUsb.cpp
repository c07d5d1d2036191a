// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces Usb.cpp and FtdiPort.cpp if libusb is not installed.
#include "haptics/falcon/FtdiPort.h"
#include "haptics/falcon/Usb.h"

namespace haptics::falcon {

bool hasUsb() noexcept
{
    return false;
}

core::Result<std::unique_ptr<Usb>> Usb::open()
{
    return core::unexpected(
        core::ErrorCode::FileUnreadable,
        core::LocalizableText{"This program was built without libusb: force devices are left out."});
}

// In Usb.cpp the destructor is not trivial.
Usb::~Usb() {}  // NOLINT(modernize-use-equals-default)

std::vector<FoundFalcon> Usb::falcons() const
{
    return {};
}

// The code below is never reached: without a Usb there is no port.
core::Result<std::unique_ptr<FtdiPort>> FtdiPort::open(const Usb& /*usb*/, const std::string& /*serial*/)
{
    return core::unexpected(core::ErrorCode::FileMissing, core::LocalizableText{"No Falcon is plugged in."});
}
FtdiPort::~FtdiPort() = default;
core::Status FtdiPort::setBaud(Baud /*baud*/)
{
    return {};
}
core::Status FtdiPort::setLatency(std::chrono::milliseconds /*latency*/)
{
    return {};
}
core::Status FtdiPort::setLine(Line /*line*/)
{
    return {};
}
core::Status FtdiPort::setFormat()
{
    return {};
}
core::Status FtdiPort::purge()
{
    return {};
}
bool FtdiPort::send(std::span<const std::uint8_t> /*bytes*/) noexcept
{
    return false;
}
std::span<const std::uint8_t> FtdiPort::receive(std::chrono::microseconds /*patience*/) noexcept
{
    return {};
}

}  // namespace haptics::falcon
