// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/history/UndoTree.h"

namespace ui::practice {

/// A moment in the picture of the undo history: one row each, oldest first, branches in lanes side by side.
struct HistoryRow
{
    core::history::MomentInfo moment;
    int parent = -1;  ///< row that it follows from; -1: none that is known
    int lane = 0;
    /// What came off since the moment that it follows from; negative where something was put back.
    core::terrain::PerMaterial takenMm3{};
    /// Lanes in which a line comes from the row above, and goes to the row below.
    std::vector<int> fromAbove;
    std::vector<int> toBelow;
};

/// The line that began first keeps its lane; a branch takes the first that is free from the row below its beginning to
/// its own last one.
/// @param moments  UndoTree::list
[[nodiscard]] std::vector<HistoryRow> historyRows(std::span<const core::history::MomentInfo> moments);

}  // namespace ui::practice
