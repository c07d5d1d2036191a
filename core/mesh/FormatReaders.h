// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/mesh/MeshReader.h"

/// One reader per format; readMesh() chooses. `name` is the name of the file in the error sentences.
namespace core::mesh {

/// Wavefront OBJ: v and f lines with any of v, v/vt, v//vn, v/vt/vn and negative indices; polygons; continued lines.
/// Everything else (materials, groups, comments, curves) is ignored.
[[nodiscard]] Result<MeshFile> readObj(std::string_view text, std::string_view name);

/// STL, binary where the stated count fits the size, ASCII where it begins with "solid".
[[nodiscard]] Result<MeshFile> readStl(std::string_view bytes, std::string_view name);

/// PLY 1.0, ASCII and binary in both byte orders; the elements "vertex" (x, y, z) and "face" (a list of indices); all
/// others are ignored.
[[nodiscard]] Result<MeshFile> readPly(std::string_view bytes, std::string_view name);

/// Returns the error "scan.obj has more than 5000000 triangles, ..."
[[nodiscard]] tl::unexpected<Error> tooManyTriangles(std::string_view name);

/// Returns the error "scan.obj has faces, but each has fewer than three corners, ..."
[[nodiscard]] tl::unexpected<Error> onlyThinFaces(std::string_view name);

/// Returns the warning "2 faces with fewer than three corners were passed over".
[[nodiscard]] std::string thinFaces(std::size_t count);

}  // namespace core::mesh
