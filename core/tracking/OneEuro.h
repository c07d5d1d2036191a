// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

namespace core::tracking {

/// A One-Euro filter of one value (Casiez, Roussel and Vogel 2012): a low-pass filter whose cutoff rises with the speed
/// of the value, for little noise at rest and little delay in motion.
class OneEuro
{
public:
    struct Settings
    {
        double leastHz = 1.0;    ///< cutoff at rest
        double perSpeed = 0.05;  ///< rise of the cutoff, Hz for one unit per second
        double speedHz = 1.0;    ///< cutoff of the speed
    };

    explicit OneEuro(const Settings& settings) : m_settings(settings) {}

    /// Resets the filter to a value.
    void restart(double value)
    {
        m_raw = m_value = value;
        m_speed = 0.0;
    }
    /// @param seconds  since the last value, > 0
    double take(double value, double seconds)
    {
        m_speed += share(m_settings.speedHz, seconds) * ((value - m_raw) / seconds - m_speed);
        m_raw = value;
        m_value += share(m_settings.leastHz + m_settings.perSpeed * std::abs(m_speed), seconds) * (value - m_value);
        return m_value;
    }
    [[nodiscard]] double value() const { return m_value; }
    [[nodiscard]] double speed() const { return m_speed; }  ///< units a second

    /// Returns the share of a step by which a first-order low-pass filter moves in a time.
    [[nodiscard]] static double share(double cutoffHz, double seconds)
    {
        const double turns = 2.0 * std::numbers::pi * cutoffHz * seconds;
        return turns / (turns + 1.0);
    }

private:
    Settings m_settings;
    double m_raw = 0.0;
    double m_value = 0.0;
    double m_speed = 0.0;
};

}  // namespace core::tracking
