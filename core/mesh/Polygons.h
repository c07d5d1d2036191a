// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/mesh/MeshReader.h"

namespace core::mesh {

/// A face of more than three corners, which a reader has put down as a fan from its first corner.
struct Polygon
{
    std::uint32_t firstTriangle = 0;
    std::uint32_t corners = 0;
};

/// Cuts the polygons anew where their fan would be wrong (or, of many corners, made of needles): by ears, in the
/// coordinate plane that shows the polygon largest. Keeps the number and order of the triangles. One that crosses
/// itself stays a fan, and a warning says how many.
///
/// Every vertex that the polygons name must be there. Time in proportion to corners times notches; a file that would
/// take more than some seconds is refused with a sentence.
[[nodiscard]] Status cutPolygons(MeshFile& file, const std::vector<Polygon>& polygons, std::string_view name);

}  // namespace core::mesh
