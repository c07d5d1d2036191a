// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/teeth/Arch.h"
#include "ui/render/ArchRenderer.h"
#include "ui/tooth/Camera.h"

/// How the whole mouth is looked at, in a window or in a picture.
namespace ui::tooth {

/// As wide as a mouth opens without strain: some 40 mm between the incisors, 25 degrees.
inline constexpr double kMouthOpenRad = 0.44;
/// From where it is looked at first.
inline constexpr double kMouthAzimuthDeg = 26.0;
inline constexpr double kMouthElevationDeg = 14.0;

struct Jaws
{
    bool upper = false;
    bool lower = false;
    bool operator==(const Jaws&) const = default;
};

/// The jaws that are drawn for an eye this high: both, or steeply from above or below only the one that faces it.
[[nodiscard]] Jaws jawsSeen(double elevationDeg);

[[nodiscard]] std::vector<core::teeth::ArchPiece> piecesOf(std::span<const core::teeth::ArchPiece> mouth, Jaws jaws);

/// Middle of a tooth's crown in the frame it stands in, mm.
[[nodiscard]] glm::dvec3 crownMiddleMm(const core::teeth::ArchPiece& tooth);

/// Makes what is left of a mouth the camera's subject; the camera goes back to its own start.
void showPieces(Camera& camera, std::span<const core::teeth::ArchPiece> shown);

/// Seen through this camera under the dentist's lamp, which turns with the eye.
[[nodiscard]] render::ArchScene mouthThrough(const Camera& camera);

}  // namespace ui::tooth
