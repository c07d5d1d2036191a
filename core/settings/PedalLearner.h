// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace core::settings {

/// Finds the axis of a pedal, and its readings at rest and at full travel, while the user presses the pedal fully and
/// releases it. Pure.
class PedalLearner
{
public:
    /// Shorter movements are noise, in units of the axis.
    static constexpr double kLeastTravel = 0.3;
    static constexpr double kSettlesAfterS = 0.3;

    struct Learnt
    {
        int axis = 0;
        double restReading = 0.0;
        double fullReading = 0.0;
        bool operator==(const Learnt&) const = default;
    };

    /// Processes the next readings. Returns the result once an axis has been moved and has settled at its start.
    /// @param axes     readings, -1 to 1; the pedal must be released at the first call
    /// @param seconds  since the last call
    [[nodiscard]] std::optional<Learnt> update(std::span<const float> axes, double seconds);

    /// Returns the axis that has moved most so far; -1 before any has moved by kLeastTravel.
    [[nodiscard]] int movedAxis() const;

private:
    struct Axis
    {
        double first = 0.0;
        double farthest = 0.0;  ///< from the first reading
        double before = 0.0;
    };
    std::vector<Axis> m_axes;
    double m_settledS = 0.0;
};

}  // namespace core::settings
