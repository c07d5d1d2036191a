// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "core/base/Result.h"
#include "core/grading/Preparation.h"
#include "core/teeth/Block.h"
#include "core/terrain/Tooth.h"

/// Makers of ideal preparations: of practice blocks, of teeth by rule, and from attempts. Any thread that may wait.
namespace core::preparation {

/// A practice block and what is to be cut into it.
struct Block
{
    std::shared_ptr<const terrain::ToothAnatomy> anatomy;
    grading::Preparation ideal;
};

/// The shape over the grid of a block made to this design (teeth::buildTooth). A column belongs to it when its node
/// does; a wall is upright, and where a rounded edge joins it to the floor the part is Wall. The floor
/// of a junction block is the junction of its enamel and dentin. A block of layers is to be kept whole. The leeway
/// around the shape is set by the lesson.
[[nodiscard]] Result<grading::Preparation> blockPreparation(const teeth::BlockDesign& design,
                                                            const terrain::ToothAnatomy& anatomy);

/// Both at once.
[[nodiscard]] Result<Block> makeBlock(const teeth::BlockDesign& design, int gridSide = terrain::kDefaultGridSide,
                                      std::uint64_t seed = 0);

}  // namespace core::preparation
