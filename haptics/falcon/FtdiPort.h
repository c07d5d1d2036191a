// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/base/Result.h"
#include "haptics/falcon/Packets.h"
#include "haptics/falcon/Usb.h"

struct libusb_device_handle;
struct libusb_transfer;

namespace haptics::falcon {

/// The FTDI chip between the USB and the Falcon's controller: its line settings, and bytes both ways.
///
/// Transfers are asynchronous. Some are always waiting for data, so that an answer costs one round trip. After open()
/// this class allocates nothing; libusb itself allocates for each transfer that it submits. One thread at a time.
class FtdiPort
{
public:
    /// Divisors of 3 MHz.
    enum class Baud : std::uint16_t {
        Hello = 0x4138,    ///< 9,600: greeting of a controller without firmware
        Loading = 0x0015,  ///< 142,857
        Running = 0x0002,  ///< 1,500,000
    };
    enum class Line : std::uint16_t { DtrOn = 0x0101, DtrOff = 0x0100, RtsOn = 0x0202, RtsOff = 0x0200 };

    /// Opens and claims a Falcon.
    /// @param serial  empty: the first that can be opened
    /// Errors: FileMissing (none is there), NotAllowed (no permission), Busy (another program uses it), ConnectionLost
    /// (any other error of the USB).
    [[nodiscard]] static core::Result<std::unique_ptr<FtdiPort>> open(const Usb& usb, const std::string& serial);
    /// Cancels pending transfers, waits for them and releases the device.
    ~FtdiPort();
    FtdiPort(const FtdiPort&) = delete;
    FtdiPort& operator=(const FtdiPort&) = delete;

    // Line settings. Errors: ConnectionLost.
    [[nodiscard]] core::Status setBaud(Baud baud);
    [[nodiscard]] core::Status setLatency(std::chrono::milliseconds latency);
    [[nodiscard]] core::Status setLine(Line line);
    /// Sets 8 data bits, no parity, 1 stop bit, no flow control.
    [[nodiscard]] core::Status setFormat();
    /// Empties the buffers of the chip, and discards received data.
    [[nodiscard]] core::Status purge();

    /// Starts to send. Returns false if the last send() is not finished or the device is gone.
    /// @param bytes  at most kMostBytes; copied
    [[nodiscard]] bool send(std::span<const std::uint8_t> bytes) noexcept;
    static constexpr std::size_t kMostBytes = 64;

    /// Waits until a transfer arrives or the time is over. Returns the transfer with the status bytes of its packets,
    /// or nothing. The bytes are valid until the next call.
    [[nodiscard]] std::span<const std::uint8_t> receive(std::chrono::microseconds patience) noexcept;

    [[nodiscard]] bool isSending() const noexcept { return m_isSending; }
    /// Returns whether the device was unplugged or the USB fails repeatedly.
    [[nodiscard]] bool isGone() const noexcept { return m_isGone; }
    [[nodiscard]] const std::string& serial() const noexcept { return m_serial; }
    /// Returns the number of other Falcons that were plugged in when this one was opened.
    [[nodiscard]] int others() const noexcept { return m_others; }

private:
    static constexpr std::size_t kReads = 4;
    struct Read
    {
        FtdiPort* port = nullptr;
        libusb_transfer* transfer = nullptr;
        bool isUnderWay = false;
        std::size_t size = 0;
        std::array<std::uint8_t, kUsbPacketBytes> bytes{};
    };

    FtdiPort(libusb_context* context, libusb_device_handle* handle, std::string serial);
    [[nodiscard]] core::Status prepare();
    [[nodiscard]] core::Status control(std::uint8_t request, std::uint16_t value);
    void handleEvents(std::chrono::microseconds patience) noexcept;
    void submit(Read& read) noexcept;
    void finish(Read& read) noexcept;
    void note(int transferStatus) noexcept;

    libusb_context* m_context;
    libusb_device_handle* m_handle;
    std::string m_serial;
    int m_others = 0;
    std::array<Read, kReads> m_reads;
    std::array<std::size_t, kReads> m_done{};  ///< ring of finished reads, in the order of their arrival
    std::size_t m_firstDone = 0;
    std::size_t m_doneCount = 0;
    Read* m_lent = nullptr;  ///< the read whose bytes receive() returned
    libusb_transfer* m_write = nullptr;
    std::array<std::uint8_t, kMostBytes> m_writeBytes{};
    bool m_isSending = false;
    bool m_isGone = false;
    bool m_isClosing = false;
    int m_failures = 0;  ///< in a row
};

}  // namespace haptics::falcon
