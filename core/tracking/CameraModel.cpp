// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/CameraModel.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace core::tracking {
namespace {

constexpr int kUndistortSteps = 20;
constexpr int kLargestPx = 16384;
constexpr double kMostDistortion = 5.0;

glm::dvec2 distorted(const glm::dvec2& straight, const std::array<double, 5>& k)
{
    const double r2 = glm::dot(straight, straight);
    const double radial = 1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
    const double xy = straight.x * straight.y;
    return straight * radial + glm::dvec2(2.0 * k[2] * xy + k[3] * (r2 + 2.0 * straight.x * straight.x),
                                          k[2] * (r2 + 2.0 * straight.y * straight.y) + 2.0 * k[3] * xy);
}

}  // namespace

CameraModel CameraModel::withFieldOfView(int width, int height, double fovDeg)
{
    const double focal = 0.5 * width / std::tan(glm::radians(fovDeg) / 2.0);
    return {width, height, glm::dvec2(focal), 0.5 * glm::dvec2(width, height), {}};
}

Status CameraModel::check() const
{
    if (width < 1 || height < 1 || width > kLargestPx || height > kLargestPx)
        return unexpected(ErrorCode::OutOfRange, "The size of the pictures must be 1 to 16384 pixels a side.");
    const auto isFocal = [&](double px) { return px > 0.1 * width && px < 20.0 * width; };
    if (!isFocal(focalPx.x) || !isFocal(focalPx.y))
        return unexpected(ErrorCode::OutOfRange,
                          "The focal length of a camera must be 0.1 to 20 times the width of its pictures.");
    if (!(centrePx.x > 0.0 && centrePx.x < width && centrePx.y > 0.0 && centrePx.y < height))
        return unexpected(ErrorCode::OutOfRange, "The optical centre of a camera must lie within its pictures.");
    for (const double k : distortion)
        if (!(std::abs(k) < kMostDistortion))
            return unexpected(ErrorCode::OutOfRange, "The coefficients of a lens must lie between -5 and 5.");
    return {};
}

double CameraModel::fieldOfViewDeg() const
{
    return glm::degrees(2.0 * std::atan(0.5 * width / focalPx.x));
}

glm::dvec2 CameraModel::pixelOf(const glm::dvec3& pointMm) const
{
    return centrePx + focalPx * distorted(glm::dvec2(pointMm) / pointMm.z, distortion);
}

glm::dvec2 CameraModel::directionOf(const glm::dvec2& pixel) const
{
    const glm::dvec2 bent = (pixel - centrePx) / focalPx;
    // Solves by fixed-point iteration, which converges because the distortion of a usable lens is small.
    glm::dvec2 straight = bent;
    for (int n = 0; n < kUndistortSteps; ++n)
        straight += bent - distorted(straight, distortion);
    return straight;
}

std::optional<double> CameraModel::focalAt(const glm::dvec3& positionMm, double distanceMm) const
{
    // The size of the tag in pixels determines z / focal length, and so x and y. The distance then gives z.
    const double z2 = distanceMm * distanceMm - positionMm.x * positionMm.x - positionMm.y * positionMm.y;
    if (!(z2 > 0.0) || !(positionMm.z > 0.0))
        return std::nullopt;
    return focalPx.x * std::sqrt(z2) / positionMm.z;
}

}  // namespace core::tracking
