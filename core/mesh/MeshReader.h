// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"
#include "core/mesh/TriangleMesh.h"

namespace core::mesh {

/// Largest mesh that is read. Ten times the densest tooth scan we know of; at this size reading stays under 1.5 GiB.
inline constexpr std::size_t kMaxTriangles = 5'000'000;
inline constexpr std::size_t kMaxVertices = 3 * kMaxTriangles;
/// Largest file that is read: it is held in memory meanwhile.
inline constexpr std::uintmax_t kMaxFileBytes = 1ULL << 30U;

enum class MeshFormat { Obj, Stl, Ply };

/// A mesh as in its file: file units, file axes, every coordinate finite, every index valid. Polygons are cut into
/// triangles (cutPolygons()). Nothing is welded or repaired yet.
struct MeshFile
{
    TriangleMesh mesh;
    /// The point of the file at which the mesh has its origin. Zero, unless the coordinates of the file are so large
    /// that they would be rounded: 10 mm at 1e6 mm from the origin are 80 steps of a float.
    glm::dvec3 originInFile{0.0};
    MeshFormat format = MeshFormat::Obj;
    std::vector<std::string> warnings;  ///< what was ignored, one sentence each
};

/// Reads an OBJ, STL or PLY file, distinguished by the suffix.
///
/// Our own readers, because Assimp 5.2.5 (Debian 12) did not hold: with its OBJ reader 10 million triangles took
/// 2180 MiB before a single vertex was ours, and 700 mutated files of a few hundred bytes crashed its PLY reader 22
/// times, hung it for over 5 s 48 times and gave face indices out of range 6 times.
/// Accepts any file, also malicious ones: bounded time and memory (kMaxTriangles), one sentence on failure.
[[nodiscard]] Result<MeshFile> readMesh(const std::filesystem::path& path);

/// Reads a mesh from memory. `name` is the name of the file in the error sentences.
[[nodiscard]] Result<MeshFile> readMesh(std::string_view bytes, MeshFormat format, std::string_view name);

}  // namespace core::mesh
