// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <glm/vec3.hpp>

namespace haptics {

/// One reading of a device. Positions are float, as recordings store them: the servo computes from exactly these bits.
struct DeviceSample
{
    glm::vec3 tipInToothMm{0.0F};
    bool present = true;  ///< false: no reading this tick, or none newer than 10 ms; the servo waits 10 ms more for one
    float delayS = 0.0F;  ///< measured, from a reading until the force that answers it acts; 0 if there is none
    std::optional<bool> pedal{};  ///< true while the pedal is down; empty if there is no pedal
};

/// Anything a hand can hold, or that plays a hand. Called from the servo thread only, once a tick.
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
};

}  // namespace haptics
