// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/bur/Bur.h"

namespace ui::render {

/// A vertex of a metal mesh, in mm in the frame of the handpiece: the tip of the bur is at the origin, its axis is +z,
/// and the handle points towards +x.
struct MetalVertex
{
    glm::vec3 position;
    glm::vec3 normal;
    float finish;  ///< 0 polished steel, 1 dark grip, 2 blades, 3 notched blades, 4 diamond, 5 ring of a grit's colour
    float aboutRad;  ///< angle about the axis of a turned part, from 0 to the full circle inclusive
};

/// Triangles of the instrument, counter-clockwise seen from outside.
struct SolidMesh
{
    std::vector<MetalVertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// Largest lift of shank and handpiece, mm. They are lifted so that they do not intersect a tooth with a deep cavity.
inline constexpr double kMostLiftMm = 6.0;
/// Height above the head at which the shank begins to widen, mm.
inline constexpr double kNeckMm = 1.0;

/// Returns the bur from its tip up: the head, and a neck long enough for any lift of the shank.
[[nodiscard]] SolidMesh burMesh(const core::bur::Bur& bur);
/// Returns the neck above the head and the shank (1.6 mm, friction grip) up to the chuck. Its lower end is round, so
/// that it meets the neck of burMesh() at any angle. The shank of a diamond has a ring below the chuck.
[[nodiscard]] SolidMesh shankMesh(const core::bur::Bur& bur);

/// Returns a turbine handpiece above the chuck: head, neck and handle at the natural angle.
[[nodiscard]] SolidMesh handpieceMesh();

/// Returns a dental mirror without its glass: the cup and the handle. The middle of the glass is at the origin and
/// faces +z; the handle points to +x and back.
[[nodiscard]] SolidMesh mirrorMesh();

}  // namespace ui::render
