// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/simulated/TickTimes.h"

#include <algorithm>
#include <cmath>

namespace haptics {

void TickTimes::add(double microseconds) noexcept
{
    const double bin = kBinsAnOctave * std::log2(std::max(microseconds, kLeastUs) / kLeastUs);
    ++m_bins[static_cast<std::size_t>(std::min(bin, static_cast<double>(m_bins.size() - 1)))];
    ++m_count;
    m_longest = std::max(m_longest, microseconds);
}

void TickTimes::add(const TickTimes& others) noexcept
{
    for (std::size_t bin = 0; bin < m_bins.size(); ++bin)
        m_bins[bin] += others.m_bins[bin];
    m_count += others.m_count;
    m_longest = std::max(m_longest, others.m_longest);
}

double TickTimes::percentileUs(double share) const noexcept
{
    const double wanted = share * static_cast<double>(m_count);
    std::uint64_t passed = 0;
    for (std::size_t bin = 0; bin < m_bins.size(); ++bin) {
        passed += m_bins[bin];
        if (passed > 0 && static_cast<double>(passed) >= wanted)
            return std::min(m_longest, kLeastUs * std::exp2((static_cast<double>(bin) + 0.5) / kBinsAnOctave));
    }
    return m_longest;
}

}  // namespace haptics
