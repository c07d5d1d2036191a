// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace core::settings {

/// Settings that convert the travel of a pedal into the speed of the bur. Readings are those of an axis, -1 to 1.
struct PedalSettings
{
    static constexpr double kLeastTravel = 0.1;  ///< between the readings of a released and of a pressed pedal
    static constexpr double kMostDeadZone = 0.5;
    static constexpr double kLeastCurve = 0.5;
    static constexpr double kMostCurve = 3.0;

    double restReading = -1.0;  ///< of the released pedal
    double fullReading = 1.0;   ///< of the fully pressed pedal
    bool isInverted = false;    ///< the bur is fastest while the pedal is released
    double deadZone = 0.08;     ///< share of the travel in which the bur is stopped
    double curve = 1.0;         ///< exponent: 1 is linear; a larger value gives slow speeds more of the travel
    bool operator==(const PedalSettings&) const = default;

    /// Returns the share of the travel for a reading, 0 to 1. 0 for a reading that is not finite, and if there is
    /// less than kLeastTravel between the two readings.
    [[nodiscard]] double travelAt(double reading) const noexcept;
    /// Returns the share of the full speed for a share of the travel, 0 to 1.
    [[nodiscard]] double speedAt(double travel) const noexcept;
};

}  // namespace core::settings
