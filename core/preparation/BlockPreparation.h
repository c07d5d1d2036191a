// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "core/base/Result.h"
#include "core/grading/Preparation.h"
#include "core/teeth/Block.h"
#include "core/terrain/Tooth.h"

/// Construction of ideal preparations: of practice blocks, of teeth by rule, and from attempts. Any thread but the ui
/// thread.
namespace core::preparation {

/// A practice block with its ideal preparation.
struct Block
{
    std::shared_ptr<const terrain::ToothAnatomy> anatomy;
    grading::Preparation ideal;
};

/// Returns the shape over the grid of a block of this design (teeth::buildTooth). A column belongs to the shape if its
/// node does; walls are upright, and a rounded edge between wall and floor is Wall. The floor of a junction block is
/// the junction of its enamel and dentin. A block of layers is kept whole. The lesson sets the leeway around the shape.
[[nodiscard]] Result<grading::Preparation> blockPreparation(const teeth::BlockDesign& design,
                                                            const terrain::ToothAnatomy& anatomy);

/// Builds the block and its ideal.
[[nodiscard]] Result<Block> makeBlock(const teeth::BlockDesign& design, int gridSide = terrain::kDefaultGridSide,
                                      std::uint64_t seed = 0);

}  // namespace core::preparation
