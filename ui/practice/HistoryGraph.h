// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/history/UndoTree.h"

namespace ui::practice {

/// One row of the undo history: a moment, its branch lane and the lines to its neighbours. Oldest first.
struct HistoryRow
{
    core::history::MomentInfo moment;
    int parent = -1;  ///< row of the previous moment in its branch; -1: unknown
    int lane = 0;
    /// Volume removed since the parent, mm³. Negative if material was restored.
    core::terrain::PerMaterial takenMm3{};
    /// Lanes in which a line comes from the row above, and continues to the row below.
    std::vector<int> fromAbove;
    std::vector<int> toBelow;
};

/// Returns the rows of the undo history. The branch that began first keeps its lane. Another branch takes the first
/// lane that is free from the row below its start to its own last row.
/// @param moments  as returned by UndoTree::list
[[nodiscard]] std::vector<HistoryRow> historyRows(std::span<const core::history::MomentInfo> moments);

}  // namespace ui::practice
