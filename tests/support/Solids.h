// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/mesh/TriangleMesh.h"

/// Closed meshes of known volume, counter-clockwise from outside, and files of them.
namespace support {

/// Returns a box from the origin to the given corner.
[[nodiscard]] core::mesh::TriangleMesh box(float x, float y, float z);
/// Returns a cone with its base circle in z = 0 and its apex at z = height.
[[nodiscard]] core::mesh::TriangleMesh cone(float radius, float height, int segments = 720);
/// Returns the part of a sphere above z = 0 when its top is at z = height.
[[nodiscard]] core::mesh::TriangleMesh sphereCap(float sphereRadius, float height, int segments = 720, int rings = 200);
/// Returns a box whose roof falls from z at x = 0 to 0 at the other end: half its volume.
[[nodiscard]] core::mesh::TriangleMesh wedge(float x, float y, float z);

[[nodiscard]] core::mesh::TriangleMesh turned(core::mesh::TriangleMesh mesh, double radiansAboutZ);
[[nodiscard]] core::mesh::TriangleMesh moved(core::mesh::TriangleMesh mesh, glm::vec3 by);
[[nodiscard]] core::mesh::TriangleMesh scaled(core::mesh::TriangleMesh mesh, float by);
[[nodiscard]] core::mesh::TriangleMesh insideOut(core::mesh::TriangleMesh mesh);
[[nodiscard]] core::mesh::TriangleMesh joined(core::mesh::TriangleMesh mesh, const core::mesh::TriangleMesh& other);

/// Returns the mesh without the faces in its lowest plane, so that it is open at the bottom.
[[nodiscard]] core::mesh::TriangleMesh withoutBase(core::mesh::TriangleMesh mesh);
/// Returns the mesh with all vertices below a height moved up to it, like a scan that ends there.
[[nodiscard]] core::mesh::TriangleMesh clampedAt(core::mesh::TriangleMesh mesh, float lowestZ);

[[nodiscard]] std::string asObj(const core::mesh::TriangleMesh& mesh);
[[nodiscard]] std::string asAsciiStl(const core::mesh::TriangleMesh& mesh);
[[nodiscard]] std::string asBinaryStl(const core::mesh::TriangleMesh& mesh);
[[nodiscard]] std::string asAsciiPly(const core::mesh::TriangleMesh& mesh);
[[nodiscard]] std::string asBinaryPly(const core::mesh::TriangleMesh& mesh, bool bigEndian);

}  // namespace support
