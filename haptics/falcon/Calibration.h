// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include <glm/vec3.hpp>

#include "core/base/Result.h"

namespace haptics::falcon {

/// Lengths of the mechanism, mm, in Stamper's letters (1997, chapter 3). The values are libnifalcon's.
struct Geometry
{
    double a = 60.0;        ///< arm
    double b = 102.5;       ///< parallelogram, long side
    double c = 14.43;       ///< grip: its joint, radially
    double de = 2 * 11.25;  ///< parallelogram, both short ends
    double f = -25.0;       ///< grip: its joint, sideways
    double r = 40.0;        ///< base: the arm's axis, radially
    double s = -23.09;      ///< base: the arm's axis, sideways
    bool operator==(const Geometry&) const = default;
};

/// Angle of the arm per encoder count: 320 slots, four edges each, a cable drive of 110 : 14.25.
inline constexpr double kCountRad = 2.0 * std::numbers::pi / (320.0 * 4.0 * 110.0 / 14.25);
/// Angle of an arm at the index mark of its encoder, where the count is 0.
inline constexpr double kHomeRad = 35.0 * std::numbers::pi / 180.0;

/// The values that differ between Falcons, or are not known well enough. `cusp falcon calibrate` measures the angle at
/// the index marks, the scale of the commands and the weight.
struct Calibration
{
    Geometry geometry{};
    double countRad = kCountRad;
    glm::dvec3 homeRad{kHomeRad};  ///< angle of each arm at its index mark
    /// Motor command for a torque of 1 Nm at an arm. libnifalcon sends 10,000; Martin and Hillier (ACRA 2009) measured
    /// 6,616, as quoted by RReichert/Falcon.
    double commandPerNm = 10000.0;
    double gripWeightN = 0.0;  ///< carried by the motors instead of the hand
    bool operator==(const Calibration&) const = default;
};

/// Checks the values. Error OutOfRange for a value that is impossible for a Falcon.
[[nodiscard]] core::Status check(const Calibration& calibration);

}  // namespace haptics::falcon
