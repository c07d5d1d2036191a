// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/tracking/CameraModel.h"
#include "core/tracking/Picture.h"
#include "core/tracking/Pose.h"

namespace lab {

/// A printed tag of the family 36h11 on a white card.
struct PrintedTag
{
    int id = 0;
    double edgeMm = 50.0;   ///< of the black square
    double marginMm = 3.0;  ///< width of the card beyond the white border of the tag
    core::tracking::Pose pose;
};

/// The scene in front of a camera, and the quality of its picture. Grey levels are 0 to 255.
struct TagScene
{
    core::tracking::CameraModel camera;
    std::optional<PrintedTag> tag;
    bool hasClutter = true;     ///< behind the tag: squares, lines and strokes; otherwise uniform grey
    std::uint64_t clutter = 1;  ///< seed of the clutter
    double blurPx = 0.7;        ///< standard deviation of the blur of tag and card
    glm::dvec2 motionPx{0.0};   ///< movement of the tag during the exposure; its pose is that of the middle
    double noise = 2.5;         ///< standard deviation of each pixel, grey levels
    std::uint64_t grain = 1;    ///< seed of the noise
    double lightFall = 0.3;     ///< share of the light lost from the left side of the picture to the right
};

/// Renders a picture by ray casting, with 25 rays per pixel near the tag.
[[nodiscard]] core::tracking::Picture render(const TagScene& scene);

/// Returns the corners of the black square, in the order of core::tracking::SeenTag.
[[nodiscard]] std::array<glm::dvec2, 4> cornersOf(const PrintedTag& tag, const core::tracking::CameraModel& camera);

/// Returns the mean length of the edges of the black square in the picture.
[[nodiscard]] double edgePxOf(const PrintedTag& tag, const core::tracking::CameraModel& camera);

/// Returns the pose of a tag that faces the camera and is then rotated by roll, pitch and yaw, in this order.
[[nodiscard]] core::tracking::Pose facing(const glm::dvec3& positionMm, double yawDeg, double pitchDeg, double rollDeg);

/// Returns the angle between the normal of a tag and the line of sight to its centre: 0 for a tag seen straight on.
[[nodiscard]] double tiltDeg(const core::tracking::Pose& pose);

}  // namespace lab
