// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/falcon/Packets.h"

#include <algorithm>

namespace haptics::falcon {
namespace {

constexpr std::uint8_t kFrameStart = '<';
constexpr std::uint8_t kFrameEnd = '>';
constexpr std::uint8_t kZero = 'A';  ///< the byte of value 0

// Positions in a frame. Three numbers of four bytes each begin at 1.
constexpr std::size_t kStatusAt = 13;
constexpr std::size_t kUnknownAt = 14;
constexpr std::size_t kEndAt = 15;

// Bits of byte 13 of a request.
constexpr unsigned kHomingBit = 1;
constexpr unsigned kGreenBit = 2;
constexpr unsigned kBlueBit = 4;
constexpr unsigned kRedBit = 8;

// Bits of byte 13 of an answer.
constexpr unsigned kButtonBits = 0x0F;
constexpr unsigned kFirstHomedBit = 0x10;
constexpr unsigned kMostStatus = 0x7F;

// Bits of the second status byte (Linux, ftdi_sio.h).
constexpr unsigned kOverrunBit = 0x02;
constexpr unsigned kParityBit = 0x04;
constexpr unsigned kFramingBit = 0x08;
constexpr unsigned kBreakBit = 0x10;

/// Returns whether a byte is valid at this position of an answer.
bool isInRange(std::size_t at, std::uint8_t byte)
{
    if (at == 0)
        return byte == kFrameStart;
    if (at == kEndAt)
        return byte == kFrameEnd;
    if (byte < kZero)
        return false;
    if (at == kUnknownAt)  // libnifalcon ignores it: any value
        return true;
    return byte <= kZero + (at == kStatusAt ? kMostStatus : 0x0FU);
}

/// Writes a signed number as four bytes, lowest four bits first.
void putNumber(std::int16_t number, std::uint8_t* to)
{
    const auto bits = static_cast<std::uint16_t>(number);
    for (unsigned n = 0; n < 4; ++n)
        to[n] = static_cast<std::uint8_t>(kZero + ((bits >> (4 * n)) & 0x0FU));
}

std::int16_t numberAt(const std::uint8_t* from)
{
    unsigned bits = 0;
    for (unsigned n = 0; n < 4; ++n)
        bits |= static_cast<unsigned>(from[n] - kZero) << (4 * n);
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(bits));
}

Answer decoded(const Frame& frame)
{
    Answer answer;
    const auto status = static_cast<unsigned>(frame[kStatusAt] - kZero);
    for (std::size_t leg = 0; leg < 3; ++leg) {
        answer.counts[leg] = numberAt(frame.data() + 1 + 4 * leg);
        answer.homed[leg] = (status & (kFirstHomedBit << leg)) != 0;
    }
    answer.buttons = static_cast<std::uint8_t>(status & kButtonBits);
    return answer;
}

}  // namespace

Frame encode(const Request& request) noexcept
{
    Frame frame{};
    frame[0] = kFrameStart;
    for (std::size_t leg = 0; leg < 3; ++leg)
        putNumber(request.motors[leg], frame.data() + 1 + 4 * leg);
    frame[kStatusAt] =
        static_cast<std::uint8_t>(kZero + (request.homing ? kHomingBit : 0U) + (request.leds.green ? kGreenBit : 0U) +
                                  (request.leds.blue ? kBlueBit : 0U) + (request.leds.red ? kRedBit : 0U));
    frame[kUnknownAt] = kZero;
    frame[kEndAt] = kFrameEnd;
    return frame;
}

std::optional<UsbPacket> takePacket(std::span<const std::uint8_t>& transfer) noexcept
{
    if (transfer.empty())
        return std::nullopt;
    const auto packet = transfer.first(std::min(transfer.size(), kUsbPacketBytes));
    transfer = transfer.subspan(packet.size());
    if (packet.size() <= kUsbStatusBytes)
        return UsbPacket{};  // without data the error bits may be old ones (ftdi_sio.c ignores them too)
    const unsigned line = packet[1];
    return UsbPacket{packet.subspan(kUsbStatusBytes),
                     {.overrun = (line & kOverrunBit) != 0,
                      .parity = (line & kParityBit) != 0,
                      .framing = (line & kFramingBit) != 0,
                      .lineBreak = (line & kBreakBit) != 0}};
}

FrameReader::Received FrameReader::read(std::span<const std::uint8_t> transfer) noexcept
{
    Received received;
    while (const auto packet = takePacket(transfer)) {
        if (packet->errors.any()) {
            received.errors.overrun |= packet->errors.overrun;
            received.errors.parity |= packet->errors.parity;
            received.errors.framing |= packet->errors.framing;
            received.errors.lineBreak |= packet->errors.lineBreak;
            dropIncomplete();
            m_dropped += packet->data.size();
            continue;
        }
        auto bytes = packet->data;
        while (const auto answer = next(bytes)) {
            ++received.answers;
            received.newest = *answer;
        }
    }
    return received;
}

std::optional<Answer> FrameReader::next(std::span<const std::uint8_t>& bytes) noexcept
{
    while (!bytes.empty()) {
        const std::uint8_t byte = bytes.front();
        bytes = bytes.subspan(1);
        if (!isInRange(m_size, byte)) {
            dropIncomplete();
            if (byte != kFrameStart) {
                ++m_dropped;
                continue;
            }
        }
        m_frame[m_size++] = byte;
        if (m_size == kFrameBytes) {
            m_size = 0;
            return decoded(m_frame);
        }
    }
    return std::nullopt;
}

void FrameReader::dropIncomplete() noexcept
{
    m_dropped += m_size;
    m_size = 0;
}

}  // namespace haptics::falcon
