// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/terrain/NodeRect.h"

/// Closing the drawn surface where the height maps end: around the tooth and around a perforation. Only for looks: a
/// sewn node has no thickness, so it adds no volume, and neither contact nor cutting sees it. Any thread; works on the
/// caller's own maps.
namespace core::terrain {

/// Gives every empty node that has a solid one among its eight neighbours one height, common to the top and the bottom
/// surface: the mean of those neighbours' tops and bottoms. With it, the four corners of every lattice square that
/// touches the tooth have a height, and the two surfaces meet.
///
/// @param rect   nodes whose top or bottom changed; what is sewn up to one node around them is redone
/// @param sewn   [side * side] heights, kEmptyTop where nothing is sewn; brought to size when it is not yet
/// @return how many nodes are sewn within the rectangle grown by one node
std::size_t sewRim(const Grid& grid, std::span<const float> top, std::span<const float> bottom, const NodeRect& rect,
                   std::vector<float>& sewn);

/// Below this z a normal counts as steep: the surface rises by more than 70 degrees.
inline constexpr float kSteepNormalZ = 0.34F;

/// Calms the normals along the seam, where differences across the cliff to the sewn node say nothing about the
/// surface. For a steep node that is sewn or next to a sewn one, the nearest node that is not steep, searched outward
/// up to `reach` nodes, lends its normal's x and y; the result is brought back to length one.
///
/// @param normals  [side * side] unit vectors of the top surface, z up, zero where there is no surface
/// @return how many normals were changed
std::size_t repairRimNormals(const Grid& grid, std::span<const float> sewn, const NodeRect& rect,
                             std::span<glm::vec3> normals, int reach = 4);

}  // namespace core::terrain
