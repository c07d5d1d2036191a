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

/// Below this z, up or down, a normal counts as steep.
inline constexpr float kSteepNormalZ = 0.75F;
/// How far calmSteepNormals() looks around a node.
inline constexpr int kCalmReach = 4;

/// Calms the normals of rims and walls: on a wall that is one cell wide the lattice, not the tooth, says where each of
/// them points. A steep normal borrows from the steep ones around it that look its way, the more the nearer, the
/// steeper and the more alike they are, and is brought back to length one. It blends in where "steep" begins, so that
/// nothing shows there. The two walls of a slit do not mix, and what is not steep is left as it is.
///
/// Chosen by looking: to borrow x and y from the nearest node that is not steep leaves the walls of cavities in
/// streaks, and turns steep flanks into combs, because there is no such node near.
///
/// @param normals  [side * side] unit vectors, zero where there is no surface
/// @param calm     the same size, written within the rectangle only
void calmSteepNormals(const Grid& grid, std::span<const glm::vec3> normals, const NodeRect& rect,
                      std::span<glm::vec3> calm);

}  // namespace core::terrain
