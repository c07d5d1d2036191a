// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "core/terrain/Grid.h"
#include "core/terrain/Tooth.h"

namespace ui::render {

/// The layers of a tooth as textures that are read between nodes: [side * side] of the lattice that is drawn, mm.
struct SurfaceLayers
{
    std::vector<glm::vec4> upper;  ///< roof and floor of the decay, enamel-dentin junction, roof of the pulp
    /// x: floor of the pulp. y: share of decayed columns around a node, one half on the outline of a lesion. w: share
    /// of columns around whose decay is open. z is 0.
    std::vector<glm::vec4> lower;
};

/// Makes the layers. A node without decay or pulp needs heights that its neighbours can be mixed with: the layer closes
/// there. So does a node beyond the rim.
/// @param lattice  every `stride`-th node of the anatomy's grid
/// @param wholeTop, wholeBottom  of the uncut tooth, over the lattice
/// @param dej      the enamel-dentin junction as it is drawn, over the lattice
[[nodiscard]] SurfaceLayers makeLayers(const core::terrain::ToothAnatomy& anatomy, const core::terrain::Grid& lattice,
                                       int stride, const std::vector<float>& wholeTop,
                                       const std::vector<float>& wholeBottom, const std::vector<float>& dej);

}  // namespace ui::render
