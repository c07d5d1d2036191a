// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/TriangleMesh.h"

namespace core::mesh {

/// The part of a mesh above a height, with new vertices where its edges cross that plane and no others than it uses. It
/// is open where the plane cuts it (findHoles()).
[[nodiscard]] TriangleMesh clippedBelow(const TriangleMesh& mesh, double height);

}  // namespace core::mesh
