// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>

namespace haptics {

/// Speed of the bur that a foot pedal requests. The thread that reads the pedal writes the speed, and the servo reads
/// it. Neither thread waits for the other.
class FootPedal
{
public:
    static constexpr int kFull = 100;

    /// Sets how far the pedal is pressed.
    /// @param percent  of the full speed; 0 stops the bur
    void set(int percent) noexcept
    {
        m_percent.store(static_cast<std::uint8_t>(std::clamp(percent, 0, kFull)), std::memory_order_relaxed);
    }
    [[nodiscard]] std::uint8_t percent() const noexcept { return m_percent.load(std::memory_order_relaxed); }

private:
    std::atomic<std::uint8_t> m_percent{0};
};

}  // namespace haptics
