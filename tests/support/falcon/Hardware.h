// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "tests/support/falcon/Arm.h"
#include "tests/support/falcon/BootLoader.h"
#include "tests/support/falcon/Faults.h"
#include "tests/support/falcon/Firmware.h"
#include "tests/support/falcon/FtdiChip.h"

namespace support {

/// Moments in the life of a connection at which the device can be made to vanish.
enum class Moment : std::uint8_t {
    Open,       ///< of libusb_open
    Claim,      ///< of libusb_claim_interface
    Query,      ///< the boot loader has received its query
    Autobaud,   ///< it has received the 'A'
    ImageByte,  ///< it has received a byte of the image
    Homing,     ///< a request with the homing bit while a leg is not homed
    Exchange,   ///< any request
};

enum class Accident : std::uint8_t {
    Unplug,
    PowerLoss,            ///< the firmware is gone; USB stays
    PowerLossWithReplug,  ///< the firmware is gone, and the device enumerates again
};

/// One answer as the firmware composed it, before any fault.
struct SentAnswer
{
    std::uint64_t number = 0;  ///< of all answers since the program began, from 1
    falcon::Time at{};
    glm::dvec3 gripMm{0.0};  ///< device frame
    std::array<std::int16_t, 3> counts{};
};

namespace falcon {

/// The Falcon behind its USB plug: chip, controller, arm and faults. Bytes and time in, bytes out; no libusb, no clock,
/// no lock. After the constructor only the control of the arm allocates.
class Hardware
{
public:
    static constexpr std::size_t kRemembered = 256;

    explicit Hardware(std::uint64_t seed);

    /// Handles all events that are due. Stops early at an accident.
    void advance(Time now);
    /// Returns the time of the next event, if there is no other input. It may be in the past.
    [[nodiscard]] Time nextEvent() const;
    /// Handles a USB control request. Returns empty if the chip stalls.
    std::optional<std::size_t> control(std::uint8_t type, std::uint8_t request, std::uint16_t value,
                                       std::uint16_t index, std::span<std::uint8_t> data, Time now);
    FtdiChip chip;
    Arm arm;
    Faults faults;
    BootLoader loader;
    Firmware firmware;

    void setMains(bool on);
    void setButton(haptics::falcon::Button button, bool down);
    void startFirmware();
    /// Cuts the power of the controller, which returns to the boot loader.
    void losePower();
    /// Resets the chip as by plugging it in.
    void resetChip(Pace pace);

    void plan(Accident what, Moment when, int count);
    /// Must be called at each occurrence.
    void reach(Moment moment);
    /// Returns the accident that has just happened, once.
    [[nodiscard]] std::optional<Accident> takeAccident();

    [[nodiscard]] bool firmwareRuns() const { return m_running; }
    [[nodiscard]] bool mains() const { return m_mains; }
    [[nodiscard]] std::uint64_t requests() const { return m_requests; }
    [[nodiscard]] std::uint64_t answers() const { return m_answers; }
    [[nodiscard]] int loads() const { return m_loads; }
    [[nodiscard]] std::optional<Time> lastRequest() const { return m_lastRequest; }
    [[nodiscard]] std::optional<Time> lastNonZero() const { return m_lastNonZero; }
    /// Returns the last answers, newest last.
    [[nodiscard]] const Ring<SentAnswer>& history() const { return m_history; }

private:
    struct Plan
    {
        Accident what;
        Moment when;
        int count;
    };

    void takeByte(const LineByte& received);
    void takeBootByte(const LineByte& received);
    void takeRequest(Time at);
    void send(const Firmware::Frame& frame, Time from);

    std::uint64_t m_seed;
    bool m_running = false;
    bool m_mains = true;
    std::uint8_t m_buttons = 0;
    int m_untilDropped = 0;  ///< bytes of the request until the one that is lost
    std::uint64_t m_requests = 0;
    std::uint64_t m_answers = 0;
    int m_loads = 0;
    std::optional<Time> m_lastRequest;
    std::optional<Time> m_lastNonZero;
    std::optional<Plan> m_plan;
    std::optional<Accident> m_accident;
    Ring<SentAnswer> m_history;
};

}  // namespace falcon
}  // namespace support
