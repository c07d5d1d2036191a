// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/teeth/AnteriorDesign.h"
#include "core/teeth/MeshBuilder.h"
#include "core/teeth/ToothTable.h"

namespace core::teeth {

/// Builds an incisor's or canine's crown as sections from the incisal edge down to the CEJ, and returns the ring there.
///
/// @param sizes  crown height and CEJ curve
[[nodiscard]] MeshBuilder::Ring buildAnteriorCrown(MeshBuilder& builder, const AnteriorDesign& design,
                                                   const ToothSizes& sizes, const MeshDetail& detail);

}  // namespace core::teeth
