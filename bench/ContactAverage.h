// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>

#include "lab/ContactScene.h"

namespace bench {

/// Two kinds of ground for the charts: ground that a height map can represent, and ground that it knows only to within
/// a cell.
enum class Ground { Smooth, Edged };

[[nodiscard]] inline Ground groundOf(const std::string& family)
{
    return family == "wall" || family == "pit corner" || family.starts_with("step") ? Ground::Edged : Ground::Smooth;
}

/// A mean over families in which each has the same weight, however many ticks it has.
class ContactAverage
{
public:
    void add(const lab::ContactErrors& errors)
    {
        m_square += errors.rmsUm * errors.rmsUm;
        m_lag += errors.lagUm;
        m_families += 1.0;
        m_times.add(errors.times);
    }
    [[nodiscard]] double rmsUm() const { return std::sqrt(m_square / m_families); }
    [[nodiscard]] double lagUm() const { return m_lag / m_families; }
    [[nodiscard]] double p99Us() const { return m_times.percentileUs(0.99); }

private:
    double m_square = 0.0;
    double m_lag = 0.0;
    double m_families = 0.0;
    haptics::TickTimes m_times;
};

inline constexpr double kChartStiffnessNPerMm = 2.0;
/// The displacement that a hand just notices: 0.1 N through that spring (docs/facts/haptics.md, section 7).
inline constexpr double kNoticedUm = 1000.0 * 0.1 / kChartStiffnessNPerMm;

}  // namespace bench
