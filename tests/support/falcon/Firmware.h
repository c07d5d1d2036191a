// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

#include "core/base/Rng.h"
#include "haptics/falcon/Packets.h"

namespace support::falcon {

/// The Falcon's controller while its firmware runs: one answer for each request, and homing.
///
/// Written from libnifalcon's description of the frames, without the driver's codec, so that a mistake in the codec is
/// found.
class Firmware
{
public:
    static constexpr std::size_t kFrameBytes = 16;
    static constexpr double kBaud = 1.5e6;
    using Frame = std::array<std::uint8_t, kFrameBytes>;

    /// @param counts  of the legs, measured from their index marks. The encoders begin at another zero.
    void start(core::Rng& rng, const glm::dvec3& counts);
    /// Moves the legs. With the homing bit set and mains power, an index mark that is passed becomes the zero.
    void moveLegs(const glm::dvec3& counts, bool mains);
    void setButtons(std::uint8_t buttons) { m_buttons = buttons; }

    /// Returns true if this byte completes a request, which is now in force. answer() is what the firmware sends.
    [[nodiscard]] bool receive(std::uint8_t byte);
    [[nodiscard]] Frame answer() const;

    [[nodiscard]] const std::array<std::int16_t, 3>& motors() const { return m_motors; }
    [[nodiscard]] haptics::falcon::Leds leds() const { return m_leds; }
    [[nodiscard]] bool homing() const { return m_homing; }
    [[nodiscard]] const std::array<bool, 3>& homed() const { return m_homed; }
    [[nodiscard]] bool allHomed() const { return m_homed[0] && m_homed[1] && m_homed[2]; }
    /// Returns the readings of the encoders.
    [[nodiscard]] std::array<std::int16_t, 3> counts() const;

private:
    void takeRequest();

    Frame m_frame{};
    std::size_t m_size = 0;
    std::array<std::int16_t, 3> m_motors{};
    haptics::falcon::Leds m_leds{};
    bool m_homing = false;
    std::array<bool, 3> m_homed{};
    std::uint8_t m_buttons = 0;
    glm::dvec3 m_legs{0.0};
    glm::dvec3 m_zero{0.0};
};

}  // namespace support::falcon
