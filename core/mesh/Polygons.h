// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/mesh/MeshReader.h"

namespace core::mesh {

/// A face of more than three corners, which a reader has stored as a fan from its first corner.
struct Polygon
{
    std::uint32_t firstTriangle = 0;
    std::uint32_t corners = 0;
};

/// Cuts polygons again whose fan would be wrong (or, with many corners, consist of needles): by ears, in the coordinate
/// plane in which the polygon is largest. The number and order of the triangles stay. A polygon that crosses itself
/// stays a fan, with a warning that gives their number.
///
/// All vertices of the polygons must exist. Time in proportion to corners times notches; a file that would take more
/// than some seconds is refused with one sentence.
[[nodiscard]] Status cutPolygons(MeshFile& file, const std::vector<Polygon>& polygons, std::string_view name);

}  // namespace core::mesh
