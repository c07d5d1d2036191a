// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "core/terrain/Grid.h"
#include "core/terrain/Tooth.h"

namespace ui::render {

/// The layers of a tooth as textures with interpolation: [side * side] of the drawn lattice, mm.
struct SurfaceLayers
{
    std::vector<glm::vec4> upper;  ///< roof and floor of the decay, enamel-dentin junction, roof of the pulp
    /// x: floor of the pulp. y: share of decayed columns around a node, one half on the outline of a lesion. z: 0. w:
    /// share of columns around it with open decay.
    std::vector<glm::vec4> lower;
};

/// Computes the layers. A node without decay or pulp, or beyond the rim, needs heights to interpolate with its
/// neighbours: roof and floor of the layer meet there.
/// @param lattice  every `stride`-th node of the anatomy's grid
/// @param wholeTop, wholeBottom  of the uncut tooth, over the lattice
/// @param dej      the drawn enamel-dentin junction, over the lattice
[[nodiscard]] SurfaceLayers makeLayers(const core::terrain::ToothAnatomy& anatomy, const core::terrain::Grid& lattice,
                                       int stride, const std::vector<float>& wholeTop,
                                       const std::vector<float>& wholeBottom, const std::vector<float>& dej);

}  // namespace ui::render
