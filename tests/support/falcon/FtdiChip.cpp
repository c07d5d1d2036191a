// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/falcon/FtdiChip.h"

#include <algorithm>
#include <cmath>

#include "tests/support/falcon/Misuse.h"

namespace support::falcon {
namespace {

constexpr std::size_t kSendBuffer = 128;
constexpr std::size_t kReceiveBuffer = 384;
constexpr std::size_t kMostUnderWay = 16384;

constexpr std::uint8_t kVendorOut = 0x40;
constexpr std::uint8_t kVendorIn = 0xC0;
constexpr std::uint16_t kEightN1 = 0x0008;

constexpr double kBaseBaud = 3.0e6;
constexpr int kBitsPerByte = 10;  ///< with start and stop bit

constexpr std::uint8_t kModemStatus = 0x01;
constexpr std::uint8_t kSenderEmpty = 0x60;
constexpr std::uint8_t kDataReady = 0x01;

double baudOf(std::uint16_t value, std::uint16_t index)
{
    constexpr double kEighths[] = {0.0, 0.5, 0.25, 0.125, 0.375, 0.625, 0.75, 0.875};
    const unsigned code = (value >> 14U) | (index & 1U) << 2U;
    const unsigned whole = value & 0x3FFFU;
    if (whole == 0 && code == 0)
        return kBaseBaud;
    if (whole == 1 && code == 0)
        return 2.0e6;
    return kBaseBaud / (whole + kEighths[code]);
}

}  // namespace

bool isSameBaud(double one, double other)
{
    return std::abs(one - other) <= 0.03 * std::max(one, other);
}

FtdiChip::FtdiChip(std::uint64_t seed) : m_rng(seed), m_sent(kMostUnderWay), m_received(kReceiveBuffer) {}

std::optional<std::size_t> FtdiChip::control(std::uint8_t type, std::uint8_t request, std::uint16_t value,
                                             std::uint16_t index, std::span<std::uint8_t> data)
{
    if (type == kVendorIn && request == 10 && !data.empty()) {
        data[0] = static_cast<std::uint8_t>(m_latency.count());
        return 1;
    }
    if (type == kVendorIn && request == 5 && data.size() >= kStatusBytes) {
        data[0] = kModemStatus;
        data[1] = kSenderEmpty;
        return kStatusBytes;
    }
    if (type != kVendorOut)
        return std::nullopt;
    switch (request) {
    case 0:
        if (value > 2)
            return std::nullopt;
        if (value != 2)
            m_received.clear();
        if (value != 1)
            m_sent.clear();
        return 0;
    case 1:
        if ((value & 0x0100U) != 0)
            m_dtr = (value & 0x0001U) != 0;
        if ((value & 0x0200U) != 0)
            m_rts = (value & 0x0002U) != 0;
        return 0;
    case 2:
        return 0;
    case 3:
        m_baud = baudOf(value, index);
        return 0;
    case 4:
        m_eightN1 = value == kEightN1;
        return 0;
    case 9:
        if (value == 0 || value > 255)
            return std::nullopt;
        m_latency = std::chrono::milliseconds(value);
        return 0;
    default:
        return std::nullopt;
    }
}

Clock::duration FtdiChip::byteTime(double baud) const
{
    if (m_pace == Pace::Fast)
        return {};
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kBitsPerByte / baud));
}

Time FtdiChip::write(std::span<const std::uint8_t> bytes, Time now)
{
    if (bytes.size() > kMostUnderWay - m_sent.size())
        abortFor("more than 16384 bytes are on their way to the Falcon: the program does not wait for its transfers");
    for (const std::uint8_t byte : bytes) {
        m_sentUntil = std::max(m_sentUntil, now) + byteTime(m_baud);
        m_sent.push({m_sentUntil, byte, m_eightN1 ? m_baud : 0.0});
    }
    return m_sent.size() <= kSendBuffer ? now : std::max(now, m_sent[m_sent.size() - kSendBuffer - 1].at);
}

void FtdiChip::receive(std::uint8_t byte, double baud, Time from, std::uint8_t errors)
{
    m_receivedUntil = std::max(m_receivedUntil, from) + byteTime(baud);
    if (!m_eightN1 || !isSameBaud(baud, m_baud)) {
        byte = static_cast<std::uint8_t>(m_rng.below(256));
        errors = static_cast<std::uint8_t>(errors | kFraming);
    }
    if (m_received.full()) {
        m_overrun = true;
        return;
    }
    m_received.push({m_receivedUntil, byte, baud, errors});
}

void FtdiChip::dropLine()
{
    m_sent.clear();
    m_received.clear();
    m_sentUntil = {};
    m_receivedUntil = {};
}

Time FtdiChip::nextPacket() const
{
    Time next = m_lastPacket + m_latency;
    if (m_received.size() >= kDataBytes)
        next = std::min(next, m_received[kDataBytes - 1].at);
    if (m_pace == Pace::Fast && !m_received.empty())
        next = std::min(next, m_received[0].at);
    return next;
}

std::size_t FtdiChip::takePacket(std::span<std::uint8_t> packet, Time now)
{
    std::size_t size = kStatusBytes;
    std::uint8_t line = kSenderEmpty;
    while (size < kPacketBytes && !m_received.empty() && m_received[0].at <= now) {
        const LineByte received = m_received.pop();
        packet[size++] = received.byte;
        line = static_cast<std::uint8_t>(line | kDataReady | received.errors);
    }
    if (m_overrun && size > kStatusBytes) {
        line = static_cast<std::uint8_t>(line | kOverrun);
        m_overrun = false;
    }
    packet[0] = kModemStatus;
    packet[1] = line;
    m_lastPacket = now;
    return size;
}

}  // namespace support::falcon
