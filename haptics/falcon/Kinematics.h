// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "haptics/falcon/Calibration.h"

/// The Novint Falcon's mechanism: three legs, each an arm on a motor and a parallelogram, carry the grip without
/// turning it (Stamper 1997, chapters 3 and 4).
///
/// Device frame, mm, as the user sees it: x right, y up, z out of the device; origin in the base plane, on the axis.
/// No function allocates.
namespace haptics::falcon {

/// Middle of the work area: about 50 mm of way to each side.
inline constexpr glm::dvec3 kCentreMm{0.0, 0.0, 125.0};
inline constexpr double kReachMm = 45.0;  ///< radius of the ball around it that the grip is sure to reach

/// The tooth stands upright before the user, its origin in the middle of the work area: tooth +x is right, +z is up,
/// and +y leads into the device.
[[nodiscard]] constexpr glm::dvec3 deviceFromTooth(const glm::dvec3& toothMm)
{
    return kCentreMm + glm::dvec3(toothMm.x, toothMm.z, -toothMm.y);
}
[[nodiscard]] constexpr glm::dvec3 toothFromDevice(const glm::dvec3& deviceMm)
{
    const glm::dvec3 apart = deviceMm - kCentreMm;
    return {apart.x, -apart.z, apart.y};
}

/// The three arms, from the outward direction towards +z, radians.
struct Arms
{
    glm::dvec3 angleRad;
    std::array<glm::dvec3, 3> perMm;  ///< gradient of each angle over the grip's place, rad/mm
};

/// Inverse kinematics, closed form. Nothing where a leg does not reach.
[[nodiscard]] std::optional<Arms> armsAt(const glm::dvec3& gripMm, const Geometry& geometry = {}) noexcept;

/// Forward kinematics by Newton's method in full steps to 1e-9 rad: two or three from a place a tick ago. From far away
/// a step that would lead out of reach is halved.
/// (libnifalcon's half steps to 0.01 rad lag behind a moving grip by a whole tick.) Nothing if no grip position has
/// these angles.
/// @param nearMm  where to begin
[[nodiscard]] std::optional<glm::dvec3> gripAt(const glm::dvec3& angleRad, const glm::dvec3& nearMm,
                                               const Geometry& geometry = {}) noexcept;

/// Returns the counts of the encoders at these angles, unrounded, of a Falcon with the usual values.
[[nodiscard]] glm::dvec3 countsAt(const glm::dvec3& angleRad) noexcept;

/// Returns the angles of the arms at these counts.
[[nodiscard]] inline glm::dvec3 anglesAt(const glm::dvec3& counts, const Calibration& calibration) noexcept
{
    return calibration.homeRad + counts * calibration.countRad;
}

/// Returns the torques of the three arms, in Nm, that press with a force on whoever holds the grip: the transpose of
/// the Jacobian times the force.
/// @param forceN  device frame
[[nodiscard]] glm::dvec3 torquesNm(const Arms& arms, const glm::dvec3& forceN) noexcept;

/// Greatest motor command, either way.
inline constexpr double kMostCommand = 4095.0;

/// Returns the commands of the three motors for a force on whoever holds the grip. If one would exceed kMostCommand,
/// all are reduced by the same factor, so that the direction of the force is kept. Zero for a force that is not finite.
/// @param forceN  device frame
[[nodiscard]] std::array<std::int16_t, 3> motorCommands(const Arms& arms, const glm::dvec3& forceN,
                                                        const Calibration& calibration) noexcept;

/// The nearest angles that the encoders can tell; they count from 35 degrees.
/// @param share  of a count, for encoders finer or coarser than the device's
[[nodiscard]] glm::dvec3 roundedToCounts(const glm::dvec3& angleRad, double share = 1.0) noexcept;

}  // namespace haptics::falcon
