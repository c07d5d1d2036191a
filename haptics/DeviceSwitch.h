// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>

#include "haptics/HapticDevice.h"

namespace haptics {

/// Passes the calls of the servo on to one of several devices. The ui thread selects which.
///
/// After a change there is no reading for kPause, and the device before gets a force of zero. So the servo takes the
/// place of the next device as a new beginning, and the force does not jump.
class DeviceSwitch final : public HapticDevice
{
public:
    /// Longer than the servo bridges missing readings (ServoTick::step()).
    static constexpr std::chrono::milliseconds kPause{20};

    /// @param first   the device that is selected at first
    /// @param period  shortest time between two calls of exchange()
    DeviceSwitch(HapticDevice& first, std::chrono::microseconds period) noexcept;

    /// Any thread. The device must outlive this, or no call may come after another device was selected.
    void select(HapticDevice& device) noexcept { m_selected.store(&device, std::memory_order_release); }
    /// The device that select() was called with last.
    [[nodiscard]] HapticDevice& selected() const noexcept { return *m_selected.load(std::memory_order_acquire); }

    void seeBur(const glm::dvec3& tipMm) noexcept override;
    DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override;
    void give(const glm::dvec3& forceN) noexcept override;
    bool waitForReading(std::chrono::steady_clock::time_point due) noexcept override;
    void takeOver() noexcept override { m_current->takeOver(); }

private:
    void followSelection() noexcept;

    std::atomic<HapticDevice*> m_selected;
    HapticDevice* m_current;  ///< servo thread: the device that moves the bur
    int m_ticksOfPause;
    int m_ticksLeft = 0;  ///< of the pause
};

}  // namespace haptics
