// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/Result.h"

namespace core::tracking {

/// The mapping of directions to pixels by a camera: a pinhole with the distortion of a lens (Brown 1966: radial k1, k2,
/// k3 and tangential p1, p2, in the order of OpenCV). The centre of the first pixel is at (0.5, 0.5).
struct CameraModel
{
    static constexpr double kUsualFovDeg = 60.0;

    int width = 0;  ///< of the pictures that it applies to
    int height = 0;
    glm::dvec2 focalPx{0.0};
    glm::dvec2 centrePx{0.0};
    std::array<double, 5> distortion{};  ///< k1, k2, p1, p2, k3

    /// Returns a camera without distortion.
    /// @param fovDeg  horizontal field of view
    [[nodiscard]] static CameraModel withFieldOfView(int width, int height, double fovDeg);
    /// Checks the model. Error OutOfRange with one sentence.
    [[nodiscard]] Status check() const;

    [[nodiscard]] double fieldOfViewDeg() const;
    /// Returns the pixel of a point; camera frame, z > 0.
    [[nodiscard]] glm::dvec2 pixelOf(const glm::dvec3& pointMm) const;
    /// Returns the direction of a pixel: x / z and y / z of every point seen there.
    [[nodiscard]] glm::dvec2 directionOf(const glm::dvec2& pixel) const;
    /// Returns the focal length with which a tag is at its measured distance from the camera; empty if there is none.
    /// For a camera without distortion.
    /// @param positionMm  of the tag, computed with this camera
    [[nodiscard]] std::optional<double> focalAt(const glm::dvec3& positionMm, double distanceMm) const;
};

}  // namespace core::tracking
