// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <glm/vec2.hpp>

#include "core/terrain/Tooth.h"

namespace lab {

/// A block under any surface and of any layers, 10.5 mm wide about the origin, for trials.
/// @param side   columns a side
/// @param shift  of the lattice under the scene, in cells
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy>
layeredBlock(const std::function<double(glm::dvec2)>& heightMm,
             const std::function<core::terrain::ColumnLayers(glm::dvec2)>& layers,
             int side = core::terrain::kDefaultGridSide, glm::dvec2 shift = {0.0, 0.0});

/// A block of enamel alone.
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy>
enamelBlock(const std::function<double(glm::dvec2)>& heightMm, int side = core::terrain::kDefaultGridSide,
            glm::dvec2 shift = {0.0, 0.0});

/// The layers of a column that is one material all through; pulp and caries too.
[[nodiscard]] core::terrain::ColumnLayers allOf(core::terrain::Material material);

inline constexpr double kBlockExtentMm = 10.5;
inline constexpr float kBlockBottomMm = -60.0F;

}  // namespace lab
