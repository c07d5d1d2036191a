// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/tracking/CameraModel.h"
#include "core/tracking/Tag.h"

namespace core::tracking {

/// Returns both poses of a tag (Collins and Bartoli 2014, "Infinitesimal plane-based pose estimation", by OpenCV).
/// Empty if the corners are not those of a square in front of the camera.
/// @param edgeMm  edge of its black square
[[nodiscard]] std::optional<PosedTag> poseOf(const SeenTag& tag, const CameraModel& camera, double edgeMm);

}  // namespace core::tracking
