// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/TriangleMesh.h"

namespace core::mesh {

/// Returns the part of a mesh above a height, with new vertices where its edges cross that plane and without unused
/// ones. It is open at the cut (findHoles()).
[[nodiscard]] TriangleMesh clippedBelow(const TriangleMesh& mesh, double height);

}  // namespace core::mesh
