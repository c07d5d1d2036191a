// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/falcon/Kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace haptics::falcon {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kLegRad[3] = {105.0 * kDegree, -15.0 * kDegree, -135.0 * kDegree};

constexpr double kMmPerM = 1000.0;

constexpr double kExactRad = 1.0e-9;
constexpr int kMostSteps = 60;  ///< from nearby two or three are enough

}  // namespace

std::optional<Arms> armsAt(const glm::dvec3& gripMm, const Geometry& geometry) noexcept
{
    Arms arms{};
    for (int leg = 0; leg < 3; ++leg) {
        const double cosLeg = std::cos(kLegRad[leg]);
        const double sinLeg = std::sin(kLegRad[leg]);
        const double cos3 = (geometry.f - geometry.s - sinLeg * gripMm.x + cosLeg * gripMm.y) / geometry.b;
        const double sin3 = std::sqrt(1.0 - cos3 * cos3);  // NaN out of reach, and so are all results
        // In the plane of the leg: arms of length a and l from the motor to (x, y).
        const double x = geometry.c - geometry.r + cosLeg * gripMm.x + sinLeg * gripMm.y;
        const double y = gripMm.z;
        const double l = geometry.de + geometry.b * sin3;
        const double reach = x * x + y * y + geometry.a * geometry.a - l * l;
        const double root = std::sqrt(4.0 * geometry.a * geometry.a * (x * x + y * y) - reach * reach);
        const double angle = 2.0 * std::atan((2.0 * geometry.a * y - root) / (reach + 2.0 * geometry.a * x));
        const double cos1 = std::cos(angle);
        const double sin1 = std::sin(angle);
        const double cos2 = (x - geometry.a * cos1) / l;
        const double sin2 = (y - geometry.a * sin1) / l;
        const double bend = geometry.a * (sin2 * cos1 - cos2 * sin1) * sin3;  // Stamper's equations 4.9 to 4.13
        const auto n = static_cast<std::size_t>(leg);
        arms.angleRad[leg] = angle;
        arms.perMm[n] =
            glm::dvec3(cos2 * sin3 * cosLeg - cos3 * sinLeg, cos2 * sin3 * sinLeg + cos3 * cosLeg, sin2 * sin3) / bend;
        if (!std::isfinite(angle))
            return std::nullopt;
    }
    return arms;
}

std::optional<glm::dvec3> gripAt(const glm::dvec3& angleRad, const glm::dvec3& nearMm,
                                 const Geometry& geometry) noexcept
{
    glm::dvec3 grip = nearMm;
    glm::dvec3 reached = nearMm;
    double missed = std::numeric_limits<double>::max();
    for (int step = 0; step < kMostSteps; ++step) {
        const std::optional<Arms> arms = armsAt(grip, geometry);
        if (!arms && step == 0)
            return std::nullopt;
        const glm::dvec3 missing = arms ? angleRad - arms->angleRad : glm::dvec3(0.0);
        const double misses = glm::dot(missing, missing);
        // A step from far away may leave the reachable region or increase the error. Half of the step is tried instead.
        if (!arms || misses > missed) {
            grip = 0.5 * (grip + reached);
            continue;
        }
        reached = grip;
        missed = misses;
        const auto& [g0, g1, g2] = arms->perMm;
        const glm::dvec3 g12 = glm::cross(g1, g2);
        grip += (missing.x * g12 + missing.y * glm::cross(g2, g0) + missing.z * glm::cross(g0, g1)) / glm::dot(g0, g12);
        if (misses < kExactRad * kExactRad)
            return grip;
    }
    return std::nullopt;
}

glm::dvec3 countsAt(const glm::dvec3& angleRad) noexcept
{
    return (angleRad - kHomeRad) / kCountRad;
}

glm::dvec3 torquesNm(const Arms& arms, const glm::dvec3& forceN) noexcept
{
    // The columns of the Jacobian are the inverse of the gradients.
    const auto& [g0, g1, g2] = arms.perMm;
    const glm::dvec3 g12 = glm::cross(g1, g2);
    const glm::dvec3 turns(glm::dot(g12, forceN), glm::dot(glm::cross(g2, g0), forceN),
                           glm::dot(glm::cross(g0, g1), forceN));
    return turns / (kMmPerM * glm::dot(g0, g12));
}

std::array<std::int16_t, 3> motorCommands(const Arms& arms, const glm::dvec3& forceN,
                                          const Calibration& calibration) noexcept
{
    glm::dvec3 commands = torquesNm(arms, forceN) * -calibration.commandPerNm;
    const double most = std::max({std::abs(commands.x), std::abs(commands.y), std::abs(commands.z)});
    if (!std::isfinite(most))
        return {};
    if (most > kMostCommand)
        commands *= kMostCommand / most;
    const auto rounded = [](double command) { return static_cast<std::int16_t>(std::lround(command)); };
    return {rounded(commands.x), rounded(commands.y), rounded(commands.z)};
}

glm::dvec3 roundedToCounts(const glm::dvec3& angleRad, double share) noexcept
{
    const double count = share * kCountRad;
    return kHomeRad + glm::round((angleRad - kHomeRad) / count) * count;
}

}  // namespace haptics::falcon
