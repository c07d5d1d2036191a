// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/pedal/PedalShape.h"

#include <algorithm>
#include <cmath>

namespace haptics {
namespace {

constexpr double kFullPercent = 100.0;

}  // namespace

int PedalShape::update(double reading, double seconds) noexcept
{
    const double travel = m_settings.travelAt(reading);
    if (!(travel > m_settings.deadZone)) {
        m_hasRested = m_hasRested || std::isfinite(reading);
        m_beyondS = 0.0;
        m_percent = 0;
        return 0;
    }
    if (!m_hasRested)
        return 0;
    if (m_percent == 0) {
        const bool isBeyond = travel > m_settings.deadZone + kStartMargin;
        m_beyondS = isBeyond ? m_beyondS + std::max(0.0, seconds) : 0.0;
        if (m_beyondS < kStartsAfterS)
            return 0;
    }
    const double percent = kFullPercent * m_settings.speedAt(travel);
    const bool isEnd = percent >= kFullPercent;
    if (isEnd || m_percent == 0 || std::abs(percent - m_percent) >= kStepPercent)
        m_percent = std::clamp(static_cast<int>(std::lround(percent)), 1, static_cast<int>(kFullPercent));
    return m_percent;
}

}  // namespace haptics
