// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/teeth/Laid.h"
#include "core/terrain/Grid.h"
#include "core/terrain/Tooth.h"

namespace core::teeth {

enum class LayerRule {
    Anatomical,        ///< enamel thins from cusp to cervix, pulp chamber with horns
    ConstantDepth2011  ///< every layer a constant depth below the top and a constant distance from the side
};

struct LayerOptions
{
    LayerRule rule = LayerRule::Anatomical;
    int fdi = 0;             ///< FDI number; 0: unknown, the kind of tooth is then guessed from its crown
    std::uint64_t seed = 0;  ///< of the variation between people; 0: the mean of the tables
};

/// Computes enamel, dentin and pulp under the surface of a whole tooth (roots in `bottom`), tooth frame, mm.
///
/// Anatomical: enamel is everything closer to the outer surface than its thickness there, so thickness is measured
/// along the normal on a cusp, on an incline and on the side alike: 0 at the cemento-enamel junction (CEJ) and 0.05 +
/// 0.32 h at h mm above it on a molar (less on premolars, canines and incisors), towards the value of the fossa inside
/// the occlusal table. Fissures are closed first: the enamel-dentin junction dips under their mouth, not their base; at
/// least 0.2 mm of enamel stays below one. The pulp has a horn under each cusp; its walls keep 1 mm of dentin on every
/// side and end where a crown is cut off flat. Values: docs/teeth.md (Deutsch and Musikant 2004 for molar pulps).
///
/// A column has one junction, so enamel on the underside of a bulge is kept only if it fills the column. The junction
/// is then below the bottom by the thickness of the enamel there.
///
/// @param top, bottom  [side * side], kEmptyTop and kEmptyBottom outside the tooth
/// @return one entry per node, without caries; entries of empty columns are all zero. Any thread.
[[nodiscard]] std::vector<terrain::ColumnLayers> buildLayers(const terrain::Grid& grid, std::span<const float> top,
                                                             std::span<const float> bottom,
                                                             const LayerOptions& options);

/// Computes the tissues of a tooth placed on a side. Thickness of enamel and the pulp are defined in the tooth's own
/// frame: enamel is everything closer to the outer surface than its thickness there, and the pulp is that of the
/// upright tooth, along the direction of the bur.
///
/// A column has one junction and one part of pulp: the first in the direction of the bur. Behind them, enamel of the
/// far side is dentin in the model, except where a column is enamel throughout.
///
/// @param top, bottom  of the tooth on its side, [side * side]
/// @return one entry per node, without caries; entries of empty columns are all zero. Any thread.
[[nodiscard]] std::vector<terrain::ColumnLayers> buildLaidLayers(const LaidTooth& laid, const terrain::Grid& grid,
                                                                 std::span<const float> top,
                                                                 std::span<const float> bottom,
                                                                 const LayerOptions& options);

}  // namespace core::teeth
