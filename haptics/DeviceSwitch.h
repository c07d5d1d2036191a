// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>

#include "haptics/HapticDevice.h"
#include "haptics/pedal/FootPedal.h"

namespace haptics {

/// Forwards the calls of the servo to one of several devices, which the ui thread selects.
///
/// After a change there is no reading for kPause, and the previous device gets a force of zero. So the servo treats the
/// position of the next device as a new start, and the force does not jump.
///
/// A foot pedal replaces the device's own pedal, and sets the speed of the bur.
class DeviceSwitch final : public HapticDevice
{
public:
    /// Longer than the time for which the servo bridges missing readings (ServoTick::step()).
    static constexpr std::chrono::milliseconds kPause{20};

    /// @param first   the device that is selected at the start
    /// @param period  shortest time between two calls of exchange()
    DeviceSwitch(HapticDevice& first, std::chrono::microseconds period) noexcept;

    /// Selects a device. It must outlive this object, or be replaced before the last call. Any thread.
    void select(HapticDevice& device) noexcept { m_selected.store(&device, std::memory_order_release); }
    /// Returns the device of the last select().
    [[nodiscard]] HapticDevice& selected() const noexcept { return *m_selected.load(std::memory_order_acquire); }

    /// Lets a pedal control the bur, whatever the device. Any thread.
    /// @param pedal  must outlive this; null: the device's own pedal controls the bur, if it has one
    void setPedal(const FootPedal* pedal) noexcept { m_pedal.store(pedal, std::memory_order_release); }
    [[nodiscard]] bool hasPedal() const noexcept { return m_pedal.load(std::memory_order_acquire) != nullptr; }

    void seeBur(const glm::dvec3& tipMm) noexcept override;
    DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override;
    void give(const glm::dvec3& forceN) noexcept override;
    bool waitForReading(std::chrono::steady_clock::time_point due) noexcept override;
    void takeOver() noexcept override { m_current->takeOver(); }

private:
    void followSelection() noexcept;
    [[nodiscard]] DeviceSample withPedal(DeviceSample sample) noexcept;

    std::atomic<HapticDevice*> m_selected;
    std::atomic<const FootPedal*> m_pedal{nullptr};
    HapticDevice* m_current;  ///< servo thread: the device that moves the bur
    int m_ticksOfPause;
    int m_ticksLeft = 0;                ///< of the pause
    std::uint8_t m_speedPercent = 100;  ///< speed that the pedal requested last
};

}  // namespace haptics
