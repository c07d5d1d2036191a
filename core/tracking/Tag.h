// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <glm/vec2.hpp>

#include "core/tracking/Pose.h"

namespace core::tracking {

/// Number of different tags in the family 36h11.
inline constexpr int kTagCount = 587;

/// A tag of the family 36h11 in a picture. Corners of its black square: lower left, lower right, upper right, upper
/// left of the upright tag. The centre of the first pixel is at (0.5, 0.5).
struct SeenTag
{
    int id = 0;
    std::array<glm::dvec2, 4> cornersPx{};
    int correctedBits = 0;  ///< of its code
    double margin = 0.0;    ///< contrast between its black and white cells, grey levels

    /// Returns the mean length of the four edges.
    [[nodiscard]] double edgePx() const;
    [[nodiscard]] glm::dvec2 centrePx() const;
};

/// A seen tag with its pose. A square seen almost straight on has two poses that explain it nearly as well.
struct PosedTag
{
    SeenTag tag;
    Pose pose;                    ///< the one with the smaller error
    Pose other;                   ///< its mirror image about the line of sight
    double reprojectionPx = 0.0;  ///< root mean square distance of the corners from their places by `pose`
    double otherPx = 0.0;         ///< the same for `other`
};

}  // namespace core::tracking
