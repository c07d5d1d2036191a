// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace core::settings {

/// Settings that convert the pressure of a pen into the force of the bur.
struct PenSettings
{
    static constexpr double kLeastCurve = 0.5;
    static constexpr double kMostCurve = 3.0;
    static constexpr double kLeastShare = 0.05;  ///< for the lightest touch

    double curve = 1.0;  ///< exponent: 1 is linear; with a larger value a light touch gives less force
    bool operator==(const PenSettings&) const = default;

    /// Returns the share of the full force for a pressure, kLeastShare to 1.
    /// @param pressure  0 to 1, clamped; kLeastShare if it is not a number
    [[nodiscard]] double shareAt(double pressure) const noexcept;
};

}  // namespace core::settings
