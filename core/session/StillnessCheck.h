// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace core::session {

/// The steadiness of a hand.
struct Stillness
{
    double driftMm = 0.0;   ///< from the mean place of the first second to that of the last
    double tremorMm = 0.0;  ///< root mean square of the distance from the moving mean
};

/// Measures the steadiness of a hand for kDurationS. Pure; docs/hand-and-rest.md has the definitions.
class StillnessCheck
{
public:
    static constexpr double kDurationS = 8.0;
    static constexpr double kEdgeS = 1.0;      ///< length of the first and the last part
    static constexpr double kMeanS = 0.5;      ///< length of the window of the moving mean
    static constexpr double kLeastHz = 10.0;   ///< with fewer places per second there is no result
    static constexpr double kMostHz = 1000.0;  ///< places that come faster are ignored

    /// Adds a place of the hand. Ignores a place that is not finite or not later than the one before.
    /// @param timeS  since the start
    void add(double timeS, glm::dvec3 placeMm);
    [[nodiscard]] bool isOver() const { return m_timeS >= kDurationS; }
    /// Returns the share of the time that has passed, 0 to 1.
    [[nodiscard]] double progress() const;
    /// Returns the result. Empty if the time is not over, or if any part of it had too few places.
    [[nodiscard]] std::optional<Stillness> result() const;

private:
    struct Place
    {
        double timeS;
        glm::dvec3 placeMm;
    };
    std::vector<Place> m_places;
    double m_timeS = 0.0;
};

}  // namespace core::session
