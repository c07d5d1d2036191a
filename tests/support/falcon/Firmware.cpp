// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/falcon/Firmware.h"

#include <algorithm>
#include <cmath>

namespace support::falcon {
namespace {

constexpr std::uint8_t kStart = 0x3C;
constexpr std::uint8_t kEnd = 0x3E;
constexpr std::uint8_t kOffset = 0x41;
constexpr std::size_t kFlagsAt = 13;
constexpr double kFurthestZero = 3000.0;

bool isNibble(std::uint8_t byte)
{
    return byte >= kOffset && byte < kOffset + 16;
}

}  // namespace

void Firmware::start(core::Rng& rng, const glm::dvec3& counts)
{
    *this = Firmware{};
    m_legs = counts;
    for (int leg = 0; leg < 3; ++leg)
        m_zero[leg] = std::round(rng.uniform(-kFurthestZero, kFurthestZero));
}

void Firmware::moveLegs(const glm::dvec3& counts, bool mains)
{
    for (int leg = 0; leg < 3; ++leg) {
        const bool passed = (m_legs[leg] < 0.0) != (counts[leg] < 0.0);
        if (passed && m_homing && mains) {
            m_homed[static_cast<std::size_t>(leg)] = true;
            m_zero[leg] = 0.0;
        }
    }
    m_legs = counts;
}

bool Firmware::receive(std::uint8_t byte)
{
    if (byte == kStart)
        m_size = 0;
    else if (m_size == 0)
        return false;
    else if (m_size == kFrameBytes - 1 ? byte != kEnd : !isNibble(byte)) {
        m_size = 0;
        return false;
    }
    m_frame[m_size++] = byte;
    if (m_size < kFrameBytes)
        return false;
    m_size = 0;
    takeRequest();
    return true;
}

void Firmware::takeRequest()
{
    for (std::size_t motor = 0; motor < 3; ++motor) {
        int value = 0;
        for (std::size_t n = 4; n > 0; --n)
            value = value * 16 + (m_frame[4 * motor + n] - kOffset);
        m_motors[motor] = static_cast<std::int16_t>(value >= 0x8000 ? value - 0x10000 : value);
    }
    const unsigned flags = m_frame[kFlagsAt] - static_cast<unsigned>(kOffset);
    m_homing = (flags & 1U) != 0;
    m_leds = {.red = (flags & 8U) != 0, .green = (flags & 2U) != 0, .blue = (flags & 4U) != 0};
    if (!m_homing)
        m_homed = {};
}

std::array<std::int16_t, 3> Firmware::counts() const
{
    std::array<std::int16_t, 3> counts{};
    for (int leg = 0; leg < 3; ++leg)
        counts[static_cast<std::size_t>(leg)] =
            static_cast<std::int16_t>(std::clamp(std::round(m_legs[leg] - m_zero[leg]), -32768.0, 32767.0));
    return counts;
}

Firmware::Frame Firmware::answer() const
{
    Frame frame{};
    frame.front() = kStart;
    const auto shown = counts();
    unsigned flags = m_buttons & 0x0FU;
    for (std::size_t leg = 0; leg < 3; ++leg) {
        unsigned bits = static_cast<std::uint16_t>(shown[leg]);
        for (std::size_t n = 1; n <= 4; ++n, bits /= 16)
            frame[4 * leg + n] = static_cast<std::uint8_t>(kOffset + bits % 16);
        flags |= m_homed[leg] ? 0x10U << leg : 0U;
    }
    frame[kFlagsAt] = static_cast<std::uint8_t>(kOffset + flags);
    frame[kFlagsAt + 1] = kOffset;
    frame.back() = kEnd;
    return frame;
}

}  // namespace support::falcon
