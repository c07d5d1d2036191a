// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <glm/vec2.hpp>

#include "core/terrain/Tooth.h"

namespace lab {

/// A block of enamel under any surface, 10.5 mm wide about the origin, for trials.
/// @param side   columns a side
/// @param shift  of the lattice under the scene, in cells
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy>
enamelBlock(const std::function<double(glm::dvec2)>& heightMm, int side = core::terrain::kDefaultGridSide,
            glm::dvec2 shift = {0.0, 0.0});

inline constexpr double kBlockExtentMm = 10.5;

}  // namespace lab
