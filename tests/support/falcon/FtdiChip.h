// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

#include "core/base/Rng.h"
#include "tests/support/falcon/Ring.h"

namespace support::falcon {

using Clock = std::chrono::steady_clock;
using Time = Clock::time_point;
inline constexpr Time kNever = Time::max();

enum class Pace {
    Real,  ///< bytes take their time at the baud rate, and answers wait for the latency timer
    Fast,  ///< bytes take no time, and the chip returns data as soon as it has any
};

/// A byte on the serial line between the chip and the controller.
struct LineByte
{
    Time at;  ///< time of its last bit
    std::uint8_t byte = 0;
    double baud = 0.0;        ///< 0: not sent as 8 data bits, no parity, 1 stop bit
    std::uint8_t errors = 0;  ///< bits of the second status byte
};

/// The FTDI USB-UART of the Falcon: control requests, status bytes, latency timer and the serial line's speed.
///
/// Facts: FTDI's data sheet of the FT232B, Linux ftdi_sio.h. Time is an argument: the chip has no clock. After the
/// constructor no function allocates.
class FtdiChip
{
public:
    static constexpr std::size_t kPacketBytes = 64;
    static constexpr std::size_t kStatusBytes = 2;
    static constexpr std::size_t kDataBytes = kPacketBytes - kStatusBytes;

    // Bits of the second status byte.
    static constexpr std::uint8_t kOverrun = 0x02;
    static constexpr std::uint8_t kParity = 0x04;
    static constexpr std::uint8_t kFraming = 0x08;
    static constexpr std::uint8_t kBreak = 0x10;

    explicit FtdiChip(std::uint64_t seed);

    void setPace(Pace pace) { m_pace = pace; }

    /// Handles a control request. Returns the number of bytes written to `data`; empty if the chip stalls.
    std::optional<std::size_t> control(std::uint8_t type, std::uint8_t request, std::uint16_t value,
                                       std::uint16_t index, std::span<std::uint8_t> data);
    /// Takes the bytes of an OUT transfer. Returns when the chip has room for the last one, which ends the transfer.
    Time write(std::span<const std::uint8_t> bytes, Time now);
    /// Returns when the next packet is ready, if no other event comes first.
    [[nodiscard]] Time nextPacket() const;
    /// Puts the packet that is ready into `packet` (kPacketBytes or more) and returns its size.
    std::size_t takePacket(std::span<std::uint8_t> packet, Time now);

    /// Returns when the next byte reaches the controller; kNever if none is on its way.
    [[nodiscard]] Time nextSent() const { return m_sent.empty() ? kNever : m_sent[0].at; }
    LineByte takeSent() { return m_sent.pop(); }
    /// Takes a byte from the controller, which begins to send it at `from` or when it has sent the byte before.
    void receive(std::uint8_t byte, double baud, Time from, std::uint8_t errors = 0);
    /// Drops the bytes that the controller was sending when it lost power.
    void dropLine();

    [[nodiscard]] bool dtr() const { return m_dtr; }
    [[nodiscard]] bool rts() const { return m_rts; }
    [[nodiscard]] double baud() const { return m_baud; }
    [[nodiscard]] std::chrono::milliseconds latency() const { return m_latency; }

private:
    [[nodiscard]] Clock::duration byteTime(double baud) const;

    Pace m_pace = Pace::Real;
    core::Rng m_rng;
    double m_baud = 9600.0;
    bool m_eightN1 = true;
    bool m_dtr = false;
    bool m_rts = false;
    std::chrono::milliseconds m_latency{16};
    Ring<LineByte> m_sent;      ///< to the controller
    Ring<LineByte> m_received;  ///< from the controller
    Time m_sentUntil{};
    Time m_receivedUntil{};
    Time m_lastPacket{};
    bool m_overrun = false;
};

/// Returns whether a receiver set to one baud rate understands the other.
[[nodiscard]] bool isSameBaud(double one, double other);

}  // namespace support::falcon
