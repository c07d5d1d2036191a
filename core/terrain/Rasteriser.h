// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/TriangleMesh.h"
#include "core/terrain/Grid.h"

namespace core::terrain {

/// The height maps of a mesh, see ToothAnatomy: original surfaces and the area of silhouette of each column.
struct HeightMaps
{
    Grid grid;
    std::vector<float> top;      ///< mm, kEmptyTop outside, [side * side]
    std::vector<float> bottom;   ///< mm, kEmptyBottom outside, [side * side]
    std::vector<float> areaMm2;  ///< 0 outside, [side * side]
};

/// Free cells between the silhouette and the edge of the grid, on every side.
inline constexpr int kGridMargin = 2;

/// Returns the square grid centred on a box with kGridMargin free cells around it.
[[nodiscard]] Grid fitGrid(glm::dvec2 lowMm, glm::dvec2 highMm, int side);

/// Returns the highest and lowest surface of a mesh over every node.
///
/// Exact: integers decide which triangles cover a node (vertices snapped to a millionth of a cell), edges belong to
/// both their triangles, so no node between two of them is missed; the height is that of the triangle's plane, in
/// double precision. A vertical face covers nothing; its edges belong to its neighbours. A node where both surfaces
/// meet is empty. The silhouette at the rim is measured with 16 x 16 samples per cell, each assigned to the nearest
/// solid node.
///
/// @param grid       must cover the mesh (fitGrid)
/// @param closeAtMm  for a mesh open below: a column without an underside ends at this height. The underside is missing
///                   where a vertical line meets the mesh an odd number of times: within the rim of the opening. Beside
///                   it, an overhanging flank keeps its underside.
[[nodiscard]] HeightMaps rasterise(const mesh::TriangleMesh& mesh, const Grid& grid,
                                   std::optional<double> closeAtMm = std::nullopt);

/// Returns the sum of (top - bottom) * area over the columns, mm3.
[[nodiscard]] double volumeOf(const HeightMaps& maps);

}  // namespace core::terrain
