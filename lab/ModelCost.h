// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "core/terrain/Tooth.h"
#include "haptics/simulated/TickTimes.h"

namespace lab {

/// Number of slots that are milled into a tooth to compare models of it, each into an uncut one: straight down into its
/// middle, then outwards, in evenly spaced directions. A millisecond and 5 um between positions.
inline constexpr std::size_t kSlots = 8;

/// The cost of a model of a tooth, and the volumes removed.
struct ModelCost
{
    std::size_t bytes = 0;     ///< for the tooth, cut and uncut
    haptics::TickTimes times;  ///< thread CPU time per tick: contact and removal
    std::array<double, kSlots> removedMm3{};
};

/// Mills the height stack: continuous contact searches the anchor, then the drill cuts all the way to the device, as in
/// material without resistance.
[[nodiscard]] ModelCost millHeightStack(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy,
                                        std::size_t bur);

/// Mills a dense voxel model (VoxelTooth) on the same grid: one count of the cubes in the bur, and their removal.
[[nodiscard]] ModelCost millVoxels(const core::terrain::ToothAnatomy& anatomy, std::size_t bur);

/// Returns the root mean square over the slots of the difference of `cost` from `right`, per cent of the latter.
[[nodiscard]] double volumeErrorPercent(const ModelCost& cost, const ModelCost& right);

}  // namespace lab
