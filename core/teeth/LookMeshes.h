// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/teeth/Arch.h"
#include "core/teeth/TriangleSamples.h"

namespace core::teeth {

/// Nothing here: far below every height.
inline constexpr double kNothingMm = -1.0e6;

/// From 0 to 1 between two places, level at both ends.
[[nodiscard]] inline double eased(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Sets the normals to the mean of the triangles around, weighed by their area.
void smoothNormals(LookMesh& mesh);
/// Lifts the bottoms of grooves that are hardly wider than a triangle, among the first `count` vertices: a coarse mesh
/// meets them here and there, like a seam that is torn. Nothing else moves. Needs normals and renews them.
void softenGrooves(LookMesh& mesh, std::size_t count);
/// Darkens the grooves among the first `count` vertices and evens out their normals: the more, the further
/// softenGrooves() would lift them. For a mesh fine enough to show its grooves. Nothing moves.
void shadeGrooves(LookMesh& mesh, std::size_t count);
/// Evens out normals and openness in the grooves of enamel: what a coarse mesh says of them changes from vertex to
/// vertex, and looks torn. Nothing moves.
void softenShade(LookMesh& mesh);
/// Sets the ball around the mesh.
void findBall(LookMesh& mesh);
/// Adds what stands up from the jaw to a map of heights seen from the opposing jaw.
void addToSkyline(SampleMap& skyline, const LookMesh& mesh, const glm::dmat4& jawFromMesh);
/// Sets how open each vertex is to the sky over such a map of the left half and its mirror image.
void findOpenness(LookMesh& mesh, const glm::dmat4& jawFromMesh, const SampleMap& skyline);

}  // namespace core::teeth
