// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/teeth/Arch.h"
#include "core/teeth/TriangleSamples.h"

namespace core::teeth {

/// "No value": far below every height.
inline constexpr double kNothingMm = -1.0e6;

/// Returns a smooth step from 0 to 1 between two places, with slope 0 at both ends.
[[nodiscard]] inline double eased(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Sets the normals to the mean of the adjacent triangles, weighted by area.
void smoothNormals(LookMesh& mesh);
/// Raises the bottoms of grooves hardly wider than a triangle, among the first `count` vertices: a coarse mesh samples
/// them unevenly, so that they look torn. Moves nothing else. Needs normals and updates them.
void softenGrooves(LookMesh& mesh, std::size_t count);
/// Darkens the grooves among the first `count` vertices and smooths their normals, in proportion to the distance by
/// which softenGrooves() would raise them. For a mesh fine enough to show its grooves. Moves nothing.
void shadeGrooves(LookMesh& mesh, std::size_t count);
/// Smooths normals and openness in the grooves of enamel: in a coarse mesh they vary from vertex to vertex and look
/// torn. Moves nothing.
void softenShade(LookMesh& mesh);
/// Sets the bounding sphere of the mesh.
void findBall(LookMesh& mesh);
/// Adds a mesh to a map of heights seen from the opposing jaw.
void addToSkyline(SampleMap& skyline, const LookMesh& mesh, const glm::dmat4& jawFromMesh);
/// Sets the openness of each vertex to the sky over such a map of the left half and its mirror image.
void findOpenness(LookMesh& mesh, const glm::dmat4& jawFromMesh, const SampleMap& skyline);

}  // namespace core::teeth
