// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/TriangleMesh.h"

namespace core::mesh {

/// Merges vertices of equal position (bit for bit, but -0 equals 0) and drops unused ones. STL repeats every corner and
/// OBJ exporters cut along texture seams; without this their triangles have no neighbours. The number and order of
/// triangles stay, including those that collapse. Linear time.
void weldByPosition(TriangleMesh& mesh);

}  // namespace core::mesh
