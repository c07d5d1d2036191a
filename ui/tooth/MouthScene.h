// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/teeth/Arch.h"
#include "ui/render/ArchRenderer.h"
#include "ui/tooth/Camera.h"

/// The view of the whole mouth, in a window or in a picture.
namespace ui::tooth {

/// Opening of the jaws without strain: about 40 mm between the incisors, 25 degrees.
inline constexpr double kMouthOpenRad = 0.44;
/// The first viewpoint.
inline constexpr double kMouthAzimuthDeg = 26.0;
inline constexpr double kMouthElevationDeg = 14.0;

struct Jaws
{
    bool upper = false;
    bool lower = false;
    bool operator==(const Jaws&) const = default;
};

/// Returns the jaws to draw for this elevation: both, or steeply from above or below only the one that faces the eye.
[[nodiscard]] Jaws jawsSeen(double elevationDeg);

/// Returns the teeth of the mouth that belong to these jaws.
[[nodiscard]] std::vector<core::teeth::ArchPiece> piecesOf(std::span<const core::teeth::ArchPiece> mouth, Jaws jaws);

/// Returns the middle of a tooth's crown in the frame of the mouth, mm.
[[nodiscard]] glm::dvec3 crownMiddleMm(const core::teeth::ArchPiece& tooth);

/// Fits the camera to these pieces of the mouth, and resets it.
void showPieces(Camera& camera, std::span<const core::teeth::ArchPiece> shown);

/// Returns the scene for this camera, lit by the dentist's lamp, which turns with the eye.
[[nodiscard]] render::ArchScene mouthThrough(const Camera& camera);

}  // namespace ui::tooth
