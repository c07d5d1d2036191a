// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/teeth/MeshBuilder.h"
#include "core/teeth/RootDesign.h"

namespace core::teeth {

/// Adds the roots below a ring at the CEJ and closes the mesh.
///
/// @param cervix      ring at the CEJ, vertex k at angle 360 k / size degrees from distal to buccal
/// @param lengthMm    of the longest root, CEJ to apex
void addRoots(MeshBuilder& builder, const MeshBuilder::Ring& cervix, const RootDesign& design, double lengthMm,
              const MeshDetail& detail);

}  // namespace core::teeth
