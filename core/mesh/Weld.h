// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/TriangleMesh.h"

namespace core::mesh {

/// Joins vertices of equal position (bit for bit, but -0 equals 0) and drops those that no triangle uses. STL repeats
/// every corner and OBJ exporters cut along texture seams; without this neither has neighbours.
/// Triangles keep their number and order, also those that collapse. Linear time.
void weldByPosition(TriangleMesh& mesh);

}  // namespace core::mesh
