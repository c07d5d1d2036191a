// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/base/Rng.h"
#include "lab/TagScene.h"
#include "tests/support/Checks.h"

/// Random scenes, by a seed, over the range that a camera meets.
namespace support {

inline core::tracking::CameraModel usualCamera()
{
    return core::tracking::CameraModel::withFieldOfView(1280, 720, core::tracking::CameraModel::kUsualFovDeg);
}

/// Returns a tag in front of the camera.
/// @param offset  offset of the tag from the middle of the picture, as shares of the distance
inline lab::PrintedTag tagBefore(double distanceMm, const glm::dvec2& offset, double tiltDeg, double tiltToDeg,
                                 double rollDeg)
{
    lab::PrintedTag tag;
    tag.pose = lab::facing(glm::dvec3(offset, 1.0) * distanceMm, tiltDeg * std::cos(tiltToDeg * kDegree),
                           tiltDeg * std::sin(tiltToDeg * kDegree), rollDeg);
    return tag;
}

/// Returns a tag anywhere in the picture, tilted in any direction.
inline lab::PrintedTag tagSomewhere(core::Rng& rng, double distanceMm, double tiltDeg)
{
    const glm::dvec2 offset(rng.uniform(-0.35, 0.35), rng.uniform(-0.18, 0.18));
    const double tiltTo = rng.uniform(0.0, 360.0);
    return tagBefore(distanceMm, offset, tiltDeg, tiltTo, rng.uniform(-30.0, 30.0));
}

/// Returns the value that a share of the values is below.
inline double percentile(std::vector<double> values, double share)
{
    if (values.empty())
        return 0.0;
    const auto k = std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k), values.end());
    return values[k];
}

}  // namespace support
