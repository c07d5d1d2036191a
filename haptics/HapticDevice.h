// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <thread>

#include <glm/vec3.hpp>

namespace haptics {

/// One reading of a device. Positions are float, as in recordings: the servo computes from exactly these bits.
struct DeviceSample
{
    glm::vec3 tipInToothMm{0.0F};
    bool present = true;  ///< false: no reading in this tick, or none newer than 10 ms; the servo waits 10 ms more
                          ///< before it treats the device as lost
    float delayS = 0.0F;  ///< measured, from a reading until the force that answers it acts; 0 if unknown
    std::optional<bool> pedal{};      ///< true while the pedal is down; empty if there is no pedal
    std::uint8_t speedPercent = 100;  ///< speed of the turning bur that the pedal requests, 1 to 100
};

/// A device that moves the bur: real or simulated. Called by the servo thread only, each function once per tick.
class HapticDevice
{
public:
    HapticDevice() = default;
    HapticDevice(const HapticDevice&) = delete;
    HapticDevice& operator=(const HapticDevice&) = delete;
    virtual ~HapticDevice() = default;

    /// Receives the position of the tip of the bur, tooth frame, mm, before exchange(). Only a simulated hand uses it.
    virtual void seeBur(const glm::dvec3& /*tipMm*/) noexcept {}
    /// Applies the force of the last tick to the hand and returns its new position. Never allocates, locks or waits.
    /// @param forceOnHandN  tooth frame, newtons
    virtual DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept = 0;
    /// Applies the force that answers the position of this tick, at its end. For devices with their own thread for the
    /// hardware, which do not have to wait for the next tick. Never allocates, locks or waits.
    virtual void give(const glm::dvec3& /*forceOnHandN*/) noexcept {}
    /// Waits between two ticks: until `due` or, for a device that sets the pace, until it has a new position.
    /// @returns whether there is a new position
    virtual bool waitForReading(std::chrono::steady_clock::time_point due) noexcept
    {
        std::this_thread::sleep_until(due);
        return false;
    }
    /// Starts anew. Called before the first exchange() after another device moved the bur (DeviceSwitch). A button that
    /// is already pressed counts as released.
    virtual void takeOver() noexcept {}
};

}  // namespace haptics
