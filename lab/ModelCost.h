// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "core/terrain/Tooth.h"
#include "haptics/simulated/TickTimes.h"

namespace lab {

/// Slots that are milled into a tooth to compare models of it, each into a whole one: straight down into its middle,
/// then outwards, in as many directions evenly around. A millisecond and 5 um from one place to the next.
inline constexpr std::size_t kSlots = 8;

/// What a model of a tooth takes, and what the slots took from it.
struct ModelCost
{
    std::size_t bytes = 0;     ///< of the tooth, cut and uncut
    haptics::TickTimes times;  ///< thread CPU time a tick: contact and removal
    std::array<double, kSlots> removedMm3{};
};

/// The height stack as we ship it: continuous contact searches the anchor, then the drill cuts all the way to the
/// device, as in material that yields at once.
[[nodiscard]] ModelCost millHeightStack(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy,
                                        std::size_t bur);

/// A dense voxel model (VoxelTooth) on the same grid: one count of what is in the bur, and its removal.
[[nodiscard]] ModelCost millVoxels(const core::terrain::ToothAnatomy& anatomy, std::size_t bur);

/// Root mean square over the slots of what `cost` removed more or less than `right`, per cent of that.
[[nodiscard]] double volumeErrorPercent(const ModelCost& cost, const ModelCost& right);

}  // namespace lab
