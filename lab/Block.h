// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <glm/vec2.hpp>

#include "core/terrain/Tooth.h"

namespace lab {

/// Builds a block with any surface and layers, 10.5 mm wide about the origin, for trials.
/// @param side   columns per side
/// @param shift  shift of the lattice under the scene, in cells
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy>
layeredBlock(const std::function<double(glm::dvec2)>& heightMm,
             const std::function<core::terrain::ColumnLayers(glm::dvec2)>& layers,
             int side = core::terrain::kDefaultGridSide, glm::dvec2 shift = {0.0, 0.0});

/// Builds a block of enamel.
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy>
enamelBlock(const std::function<double(glm::dvec2)>& heightMm, int side = core::terrain::kDefaultGridSide,
            glm::dvec2 shift = {0.0, 0.0});

/// Returns the layers of a column of one material, also pulp or caries.
[[nodiscard]] core::terrain::ColumnLayers allOf(core::terrain::Material material);

inline constexpr double kBlockExtentMm = 10.5;
inline constexpr float kBlockBottomMm = -60.0F;

}  // namespace lab
