// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace haptics {

/// A histogram of any number of tick times in constant memory. Each bin is 0.3 % wider than the one before. One thread.
class TickTimes
{
public:
    void add(double microseconds) noexcept;
    void add(const TickTimes& others) noexcept;

    /// Returns the time that is longer than a share (0 to 1) of the ticks, microseconds, exact to 0.3 % and 0.01; 0
    /// without ticks.
    [[nodiscard]] double percentileUs(double share) const noexcept;
    /// Returns the longest time, exact.
    [[nodiscard]] double longestUs() const noexcept { return m_longest; }

private:
    static constexpr int kBinsAnOctave = 256;
    static constexpr double kLeastUs = 0.01;
    static constexpr int kOctaves = 27;  ///< up to more than a second

    std::array<std::uint64_t, kBinsAnOctave * kOctaves> m_bins{};
    std::uint64_t m_count = 0;
    double m_longest = 0.0;
};

}  // namespace haptics
