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
    /// Shorter movements are noise.
    static constexpr double kLeastTravel = 0.3;
    static constexpr double kSettlesAfterS = 0.3;

    struct Learnt
    {
        int axis = 0;
        double restReading = 0.0;
        double fullReading = 0.0;
        bool operator==(const Learnt&) const = default;
    };

    /// Takes the next readings. Returns the result once an axis has been moved and has settled at where it began.
    /// @param axes     readings, -1 to 1; those of the first call are of a released pedal
    /// @param seconds  since the last call
    [[nodiscard]] std::optional<Learnt> update(std::span<const float> axes, double seconds);

    /// Returns the axis that has moved most by now; -1 before any has moved by kLeastTravel.
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
