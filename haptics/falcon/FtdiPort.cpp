// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/falcon/FtdiPort.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <libusb-1.0/libusb.h>

#include "haptics/falcon/UsbDetail.h"

namespace haptics::falcon {
namespace {

using core::ErrorCode;
using core::LocalizableText;

constexpr int kInterface = 0;
constexpr std::uint8_t kOutEndpoint = 0x02;
constexpr std::uint8_t kInEndpoint = 0x81;
constexpr unsigned kControlMs = 1000;
/// After so many failures in a row, a device counts as unplugged.
constexpr int kMostFailures = 20;
constexpr std::chrono::milliseconds kCloses{1000};

// Requests of the FTDI chip (Linux, ftdi_sio.h).
constexpr std::uint8_t kToDevice = 0x40;
constexpr std::uint8_t kReset = 0;
constexpr std::uint16_t kPurgeReceived = 1;
constexpr std::uint16_t kPurgeToSend = 2;
constexpr std::uint8_t kModem = 1;
constexpr std::uint8_t kFlow = 2;
constexpr std::uint8_t kBaud = 3;
constexpr std::uint8_t kData = 4;
constexpr std::uint16_t kEightBits = 8;
constexpr std::uint8_t kLatency = 9;

}  // namespace

core::Result<std::unique_ptr<FtdiPort>> FtdiPort::open(const Usb& usb, const std::string& serial)
{
    const DeviceList devices(usb.context());
    core::Error why = core::unexpected(ErrorCode::FileMissing, LocalizableText{"No Falcon is plugged in."}).value();
    const std::vector<libusb_device*> falcons = devices.falcons();
    for (libusb_device* const device : falcons) {
        auto opened = openDevice(device);
        if (!opened) {
            why = opened.error();
            continue;
        }
        const std::string itsSerial = serialOf(opened->get());
        if (!serial.empty() && itsSerial != serial) {
            why = core::unexpected(
                      ErrorCode::FileMissing,
                      LocalizableText{"No Falcon with the serial number %1 is plugged in.", {core::noted(serial)}})
                      .value();
            continue;
        }
        std::unique_ptr<FtdiPort> port(new FtdiPort(usb.context(), opened->release(), itsSerial));
        if (auto ready = port->prepare(); !ready) {
            why = ready.error();
            continue;
        }
        port->m_others = static_cast<int>(falcons.size()) - 1;
        return port;
    }
    return tl::unexpected(why);
}

FtdiPort::FtdiPort(libusb_context* context, libusb_device_handle* handle, std::string serial)
    : m_context(context), m_handle(handle), m_serial(std::move(serial))
{}

FtdiPort::~FtdiPort()
{
    m_isClosing = true;
    for (Read& read : m_reads)
        if (read.isUnderWay)
            libusb_cancel_transfer(read.transfer);
    if (m_isSending)
        libusb_cancel_transfer(m_write);
    const auto until = std::chrono::steady_clock::now() + kCloses;
    const auto isBusy = [&] {
        return m_isSending || std::any_of(m_reads.begin(), m_reads.end(), [](const Read& r) { return r.isUnderWay; });
    };
    while (isBusy() && std::chrono::steady_clock::now() < until)
        handleEvents(std::chrono::milliseconds(10));
    // If libusb has not returned a transfer, freeing it would be unsafe, so its memory is leaked.
    for (Read& read : m_reads)
        if (read.transfer != nullptr && !read.isUnderWay)
            libusb_free_transfer(read.transfer);
    if (m_write != nullptr && !m_isSending)
        libusb_free_transfer(m_write);
    libusb_release_interface(m_handle, kInterface);
    libusb_close(m_handle);
}

core::Status FtdiPort::prepare()
{
    // Not every system has kernel drivers to detach.
    static_cast<void>(libusb_set_auto_detach_kernel_driver(m_handle, 1));
    if (const int code = libusb_claim_interface(m_handle, kInterface); code != LIBUSB_SUCCESS)
        return tl::unexpected(usbError(code));
    m_write = libusb_alloc_transfer(0);
    for (Read& read : m_reads) {
        read.port = this;
        read.transfer = libusb_alloc_transfer(0);
        if (read.transfer == nullptr || m_write == nullptr)
            return tl::unexpected(usbError(LIBUSB_ERROR_NO_MEM));
        libusb_fill_bulk_transfer(
            read.transfer, m_handle, kInEndpoint, read.bytes.data(), static_cast<int>(read.bytes.size()),
            [](libusb_transfer* transfer) {
                Read& done = *static_cast<Read*>(transfer->user_data);
                done.port->finish(done);
            },
            &read, 0);
    }
    for (Read& read : m_reads)
        submit(read);
    return m_isGone ? tl::unexpected(usbError(LIBUSB_ERROR_NO_DEVICE)) : core::Status{};
}

core::Status FtdiPort::control(std::uint8_t request, std::uint16_t value)
{
    const int code = libusb_control_transfer(m_handle, kToDevice, request, value, 0, nullptr, 0, kControlMs);
    if (code == LIBUSB_ERROR_NO_DEVICE)
        m_isGone = true;
    return code < 0 ? tl::unexpected(usbError(code)) : core::Status{};
}

core::Status FtdiPort::setBaud(Baud baud)
{
    return control(kBaud, static_cast<std::uint16_t>(baud));
}

core::Status FtdiPort::setLatency(std::chrono::milliseconds latency)
{
    return control(kLatency, static_cast<std::uint16_t>(latency.count()));
}

core::Status FtdiPort::setLine(Line line)
{
    return control(kModem, static_cast<std::uint16_t>(line));
}

core::Status FtdiPort::setFormat()
{
    if (auto done = control(kFlow, 0); !done)
        return done;
    return control(kData, kEightBits);
}

core::Status FtdiPort::purge()
{
    if (auto done = control(kReset, kPurgeReceived); !done)
        return done;
    if (auto done = control(kReset, kPurgeToSend); !done)
        return done;
    // Data that is still on its way is in reads that have ended or will end at once.
    handleEvents(std::chrono::microseconds(0));
    while (!receive(std::chrono::microseconds(0)).empty()) {
    }
    return {};
}

bool FtdiPort::send(std::span<const std::uint8_t> bytes) noexcept
{
    if (m_isSending || m_isGone || m_isClosing || bytes.empty() || bytes.size() > kMostBytes)
        return false;
    std::copy(bytes.begin(), bytes.end(), m_writeBytes.begin());
    libusb_fill_bulk_transfer(
        m_write, m_handle, kOutEndpoint, m_writeBytes.data(), static_cast<int>(bytes.size()),
        [](libusb_transfer* transfer) {
            FtdiPort& port = *static_cast<FtdiPort*>(transfer->user_data);
            port.m_isSending = false;
            port.note(transfer->status);
        },
        this, 0);
    if (const int code = libusb_submit_transfer(m_write); code != LIBUSB_SUCCESS) {
        note(code == LIBUSB_ERROR_NO_DEVICE ? LIBUSB_TRANSFER_NO_DEVICE : LIBUSB_TRANSFER_ERROR);
        return false;
    }
    m_isSending = true;
    return true;
}

std::span<const std::uint8_t> FtdiPort::receive(std::chrono::microseconds patience) noexcept
{
    if (Read* const lent = std::exchange(m_lent, nullptr))
        submit(*lent);
    const auto until = std::chrono::steady_clock::now() + patience;
    for (auto left = patience; m_doneCount == 0 && !m_isGone;
         left = std::chrono::duration_cast<std::chrono::microseconds>(until - std::chrono::steady_clock::now())) {
        handleEvents(std::max(left, std::chrono::microseconds(0)));
        if (left.count() <= 0)
            break;
    }
    if (m_doneCount == 0)
        return {};
    m_lent = &m_reads[m_done[m_firstDone]];
    m_firstDone = (m_firstDone + 1) % kReads;
    --m_doneCount;
    return {m_lent->bytes.data(), m_lent->size};
}

/// Handles events of libusb until at least one has occurred or the time is over.
void FtdiPort::handleEvents(std::chrono::microseconds patience) noexcept
{
    constexpr std::int64_t kUsPerS = 1'000'000;
    timeval time{};
    time.tv_sec = static_cast<decltype(time.tv_sec)>(patience.count() / kUsPerS);
    time.tv_usec = static_cast<decltype(time.tv_usec)>(patience.count() % kUsPerS);
    if (const int code = libusb_handle_events_timeout_completed(m_context, &time, nullptr);
        code != LIBUSB_SUCCESS && code != LIBUSB_ERROR_INTERRUPTED)
        note(LIBUSB_TRANSFER_ERROR);
}

void FtdiPort::submit(Read& read) noexcept
{
    if (m_isClosing || m_isGone)
        return;
    const int code = libusb_submit_transfer(read.transfer);
    read.isUnderWay = code == LIBUSB_SUCCESS;
    if (!read.isUnderWay)
        m_isGone = true;  // a missing read would never come back
}

/// Called by libusb when a read has ended, with or without an error.
void FtdiPort::finish(Read& read) noexcept
{
    read.isUnderWay = false;
    note(read.transfer->status);
    read.size = static_cast<std::size_t>(std::max(0, read.transfer->actual_length));
    if (read.transfer->status != LIBUSB_TRANSFER_COMPLETED || read.size == 0) {
        submit(read);
        return;
    }
    m_done[(m_firstDone + m_doneCount) % kReads] = static_cast<std::size_t>(&read - m_reads.data());
    ++m_doneCount;
}

void FtdiPort::note(int transferStatus) noexcept
{
    if (transferStatus == LIBUSB_TRANSFER_COMPLETED)
        m_failures = 0;
    else if (transferStatus == LIBUSB_TRANSFER_NO_DEVICE || ++m_failures >= kMostFailures)
        m_isGone = true;
}

}  // namespace haptics::falcon
