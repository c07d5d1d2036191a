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

/// Middle of the work area, device frame: about 50 mm of travel to each side.
inline constexpr glm::dvec3 kCentreMm{0.0, 0.0, 125.0};
inline constexpr double kReachMm = 45.0;  ///< radius of the sphere around it that the grip can always reach

/// Converts from the tooth frame. The tooth is upright in front of the user, its origin in the middle of the work area:
/// tooth +x is right, +z is up, and +y points into the device.
[[nodiscard]] constexpr glm::dvec3 deviceFromTooth(const glm::dvec3& toothMm)
{
    return kCentreMm + glm::dvec3(toothMm.x, toothMm.z, -toothMm.y);
}
[[nodiscard]] constexpr glm::dvec3 toothFromDevice(const glm::dvec3& deviceMm)
{
    const glm::dvec3 apart = deviceMm - kCentreMm;
    return {apart.x, -apart.z, apart.y};
}

/// The angles of the three arms, from the outward direction towards +z, radians.
struct Arms
{
    glm::dvec3 angleRad;
    std::array<glm::dvec3, 3> perMm;  ///< gradient of each angle with respect to the position of the grip, rad/mm
};

/// Inverse kinematics, closed form. Empty if a leg cannot reach the position.
[[nodiscard]] std::optional<Arms> armsAt(const glm::dvec3& gripMm, const Geometry& geometry = {}) noexcept;

/// Computes the position of the grip by Newton's method in full steps, to 1e-9 rad. Takes two or three steps from the
/// position of the last tick. A step from far away that would leave the reachable region is halved. (libnifalcon's half
/// steps to 0.01 rad lag behind a moving grip by a whole tick.) Empty if no position has these angles.
/// @param nearMm  start of the iteration
[[nodiscard]] std::optional<glm::dvec3> gripAt(const glm::dvec3& angleRad, const glm::dvec3& nearMm,
                                               const Geometry& geometry = {}) noexcept;

/// Returns the encoder counts at these angles, unrounded, for a Falcon with the default calibration.
[[nodiscard]] glm::dvec3 countsAt(const glm::dvec3& angleRad) noexcept;

/// Returns the angles of the arms at these counts.
[[nodiscard]] inline glm::dvec3 anglesAt(const glm::dvec3& counts, const Calibration& calibration) noexcept
{
    return calibration.homeRad + counts * calibration.countRad;
}

/// Returns the torques of the three arms, Nm, that exert a force on the hand at the grip: the transpose of the Jacobian
/// times the force.
/// @param forceN  device frame
[[nodiscard]] glm::dvec3 torquesNm(const Arms& arms, const glm::dvec3& forceN) noexcept;

/// Largest motor command in either direction.
inline constexpr double kMostCommand = 4095.0;

/// Returns the commands of the three motors for a force on the hand. If one would exceed kMostCommand, all are reduced
/// by the same factor, so that the direction is kept. Zero for a force that is not finite.
/// @param forceN  device frame
[[nodiscard]] std::array<std::int16_t, 3> motorCommands(const Arms& arms, const glm::dvec3& forceN,
                                                        const Calibration& calibration) noexcept;

/// Returns the nearest angles that the encoders can resolve; they count from 35 degrees.
/// @param share  of a count, for finer or coarser encoders than the device's
[[nodiscard]] glm::dvec3 roundedToCounts(const glm::dvec3& angleRad, double share = 1.0) noexcept;

}  // namespace haptics::falcon
