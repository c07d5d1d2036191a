// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/terrain/NodeRect.h"

/// Closes the drawn surface where the height maps end: around the tooth and around a perforation. For display only: a
/// sewn node has no thickness, so it adds no volume, and contact and cutting ignore it. Any thread; works on the
/// caller's own maps.
namespace core::terrain {

/// Gives every empty node with a solid one among its eight neighbours a common height for the top and the bottom
/// surface: the mean of those neighbours' tops and bottoms. Then the four corners of every lattice square that touches
/// the tooth have a height, and the two surfaces meet.
///
/// @param rect   nodes whose top or bottom changed; sewn nodes up to one node around them are updated
/// @param sewn   [side * side] heights, kEmptyTop where nothing is sewn; resized if necessary
/// @return number of sewn nodes within the rectangle grown by one node
std::size_t sewRim(const Grid& grid, std::span<const float> top, std::span<const float> bottom, const NodeRect& rect,
                   std::vector<float>& sewn);

/// Normals with |z| below this count as steep.
inline constexpr float kSteepNormalZ = 0.75F;
/// Distance around a node that calmSteepNormals() uses, nodes.
inline constexpr int kCalmReach = 4;

/// Smooths the normals of rims and walls: on a wall that is one cell wide they depend on the lattice, not on the tooth.
/// A steep normal is averaged with the steep ones around it of similar direction, weighted by nearness, steepness and
/// similarity, and normalised. The effect is blended in at the threshold, so that no edge is visible. The two walls of
/// a slit do not mix, and other normals are unchanged.
///
/// Chosen by appearance: taking x and y from the nearest normal that is not steep gives streaks on the walls of
/// cavities, and combs on steep flanks, because there is no such normal nearby.
///
/// @param normals  [side * side] unit vectors, zero where there is no surface
/// @param calm     the same size, written within the rectangle only
void calmSteepNormals(const Grid& grid, std::span<const glm::vec3> normals, const NodeRect& rect,
                      std::span<glm::vec3> calm);

}  // namespace core::terrain
