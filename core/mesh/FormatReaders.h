// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include "core/mesh/MeshReader.h"

/// One reader per format; readMesh() chooses. `name` is the name of the file in the error sentences. `originInFile` is
/// subtracted from every coordinate before it is rounded to float.
namespace core::mesh {

/// The kind of a file shows in so many of its first bytes.
inline constexpr std::size_t kBytesThatTell = 4096;

/// Wavefront OBJ: v and f lines with any of v, v/vt, v//vn, v/vt/vn and negative indices; polygons. These lines may be
/// continued by a backslash. Everything else (materials, groups, comments, curves) is ignored.
[[nodiscard]] Result<MeshFile> readObj(std::string_view text, std::string_view name, const glm::dvec3& originInFile);

/// STL. Binary where the stated count fits the size, or where whole records fit it and the count is too small or cannot
/// be one; then with a warning. ASCII where the first word is "solid"; read word by word, wherever its lines end.
[[nodiscard]] Result<MeshFile> readStl(std::string_view bytes, std::string_view name, const glm::dvec3& originInFile);

/// PLY 1.0, ASCII and binary in both byte orders; the elements "vertex" (x, y, z), "face" (a list of indices) and
/// "tristrips" (a list of indices in which -1 ends a strip); all others are ignored.
[[nodiscard]] Result<MeshFile> readPly(std::string_view bytes, std::string_view name, const glm::dvec3& originInFile);

/// Returns whether a text begins like an ASCII STL: "solid", and a facet within its first bytes.
[[nodiscard]] bool looksLikeAsciiStl(std::string_view start);

/// Returns the error "scan.obj has more than 5000000 triangles, ..."
[[nodiscard]] tl::unexpected<Error> tooManyTriangles(std::string_view name);

/// Returns the error "scan.obj has faces, but each has fewer than three corners, ..."
[[nodiscard]] tl::unexpected<Error> onlyThinFaces(std::string_view name);

/// Returns the warning "2 faces with fewer than three corners were passed over".
[[nodiscard]] std::string thinFaces(std::size_t count);

}  // namespace core::mesh
