// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <thread>

#include <glm/vec3.hpp>

namespace haptics {

/// One reading of a device. Positions are float, as recordings store them: the servo computes from exactly these bits.
struct DeviceSample
{
    glm::vec3 tipInToothMm{0.0F};
    bool present = true;  ///< false: no reading this tick, or none newer than 10 ms; the servo waits 10 ms more for one
    float delayS = 0.0F;  ///< measured, from a reading until the force that answers it acts; 0 if there is none
    std::optional<bool> pedal{};      ///< true while the pedal is down; empty if there is no pedal
    std::uint8_t speedPercent = 100;  ///< speed of the bur while it turns, 1 to 100: what the pedal asks for
};

/// Anything a hand can hold, or that plays a hand. Called from the servo thread only, each function once a tick.
class HapticDevice
{
public:
    HapticDevice() = default;
    HapticDevice(const HapticDevice&) = delete;
    HapticDevice& operator=(const HapticDevice&) = delete;
    virtual ~HapticDevice() = default;

    /// Tells the device where the tip of the bur is, tooth frame, before exchange(). Only a simulated hand uses it.
    virtual void seeBur(const glm::dvec3& /*tipMm*/) noexcept {}
    /// Gives the force of the last tick to the hand and takes its new position. Never allocates, locks or waits.
    /// @param forceOnHandN  tooth frame, newtons
    virtual DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept = 0;
    /// Gives the force that answers the position of this tick, at its end. For a device that exchanges with the
    /// hardware on a thread of its own: it need not wait for the next tick. Never allocates, locks or waits.
    virtual void give(const glm::dvec3& /*forceOnHandN*/) noexcept {}
    /// Waits between two ticks: until this time or, with a device that sets the pace, until it has a new position.
    /// @returns whether there is one
    virtual bool waitForReading(std::chrono::steady_clock::time_point due) noexcept
    {
        std::this_thread::sleep_until(due);
        return false;
    }
    /// Begins anew, before the first exchange() after another device moved the bur (DeviceSwitch). A hand that was
    /// pressing has let go.
    virtual void takeOver() noexcept {}
};

}  // namespace haptics
