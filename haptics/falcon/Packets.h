// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

/// The bytes that the Novint Falcon and the computer exchange while it runs, without the USB transfers that carry them.
///
/// Request and answer are frames of 16 bytes: '<', 14 bytes of 'A' plus a value, '>'. The controller sends one answer
/// for each request and nothing else. The layout is that of libnifalcon (FalconFirmwareNovintSDK.cpp). Its header
/// describes other bits for the LEDs and for homing than its code sends; the code has been used with devices.
///
/// No function allocates, locks or waits. Any thread, one at a time for each FrameReader.
namespace haptics::falcon {

inline constexpr std::size_t kFrameBytes = 16;
using Frame = std::array<std::uint8_t, kFrameBytes>;

struct Leds
{
    bool red = false;
    bool green = false;
    bool blue = false;
    friend bool operator==(const Leds&, const Leds&) = default;
};

/// One request. Legs are numbered as in libnifalcon: top, right, left, seen by the user who faces the device.
struct Request
{
    std::array<std::int16_t, 3> motors{};  ///< command of each motor, in the controller's units; sent as given
    Leds leds{};
    bool homing = true;  ///< the device is homed only while this bit is set, according to libnifalcon
};

/// The buttons of the standard grip, as bits of Answer::buttons.
enum class Button : std::uint8_t {
    Plus = 1,     ///< right
    Forward = 2,  ///< towards the device
    Centre = 4,
    Minus = 8,  ///< left
};

/// One answer.
struct Answer
{
    std::array<std::int16_t, 3> counts{};  ///< encoder counts, in the order of Request::motors
    std::uint8_t buttons = 0;              ///< bits of Button
    std::array<bool, 3> homed{};           ///< the leg has passed its index mark, from where its count is measured

    [[nodiscard]] bool isDown(Button button) const { return (buttons & static_cast<std::uint8_t>(button)) != 0; }
    [[nodiscard]] bool allHomed() const { return homed[0] && homed[1] && homed[2]; }
    friend bool operator==(const Answer&, const Answer&) = default;
};

[[nodiscard]] Frame encode(const Request& request) noexcept;

/// Bytes in one packet of a transfer from the FTDI chip (full speed USB), and how many of them are its status.
inline constexpr std::size_t kUsbPacketBytes = 64;
inline constexpr std::size_t kUsbStatusBytes = 2;

/// Errors of the serial line between the controller and the FTDI chip.
struct LineErrors
{
    bool overrun = false;  ///< the chip's buffer was full and bytes were lost
    bool parity = false;
    bool framing = false;  ///< a byte without its stop bit: the two sides use different baud rates, or there was noise
    bool lineBreak = false;

    [[nodiscard]] bool any() const { return overrun || parity || framing || lineBreak; }
    friend bool operator==(const LineErrors&, const LineErrors&) = default;
};

/// One packet of a transfer from the FTDI chip.
struct UsbPacket
{
    std::span<const std::uint8_t> data;  ///< without the status bytes; empty if the chip had no data
    LineErrors errors{};                 ///< about this data. Without data there are none.
};

/// Removes the first packet from a transfer and returns it; null at the end of the transfer.
/// @param transfer  a whole transfer or what is left of one: the packets have 64 bytes, the last one may have fewer
[[nodiscard]] std::optional<UsbPacket> takePacket(std::span<const std::uint8_t>& transfer) noexcept;

/// Finds answers in the received bytes, however they are split into reads, and among bytes that belong to none.
///
/// An answer is accepted if '<' is followed by 14 bytes in range and '>'. No byte in range equals '<', so lost or extra
/// bytes invalidate only the answer that contains them. The protocol has no checksum: if a byte is changed into another
/// one in range, the error is not detected.
class FrameReader
{
public:
    struct Received
    {
        int answers = 0;  ///< more than one: an answer was late or doubled
        Answer newest{};  ///< valid if there are answers
        LineErrors errors{};
    };

    /// Reads a whole transfer from the FTDI chip. Data with a line error is discarded, and so is the incomplete answer
    /// before it, because bytes may be missing or changed.
    [[nodiscard]] Received read(std::span<const std::uint8_t> transfer) noexcept;

    /// Removes bytes from the front up to the end of the next answer and returns the answer. Null if the bytes end
    /// before that; an incomplete answer continues with the next call.
    [[nodiscard]] std::optional<Answer> next(std::span<const std::uint8_t>& bytes) noexcept;

    /// Discards the incomplete answer. Call it after a timeout, so that later bytes do not complete an interrupted
    /// answer.
    void dropIncomplete() noexcept;

    /// Returns the number of bytes so far that are part of no answer, without those of the incomplete one.
    [[nodiscard]] std::uint64_t droppedBytes() const { return m_dropped; }
    [[nodiscard]] std::size_t incompleteBytes() const { return m_size; }

private:
    Frame m_frame{};
    std::size_t m_size = 0;  ///< bytes of the incomplete answer; each is in range
    std::uint64_t m_dropped = 0;
};

}  // namespace haptics::falcon
