// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/terrain/Grid.h"

namespace core::terrain {

/// Nodes beginI <= i < endI, beginJ <= j < endJ.
struct NodeRect
{
    int beginI = 0;
    int beginJ = 0;
    int endI = 0;
    int endJ = 0;
    [[nodiscard]] bool isEmpty() const { return endI <= beginI || endJ <= beginJ; }
    bool operator==(const NodeRect&) const = default;
};

[[nodiscard]] inline NodeRect wholeOf(const Grid& grid)
{
    return {0, 0, grid.side, grid.side};
}

/// Returns the rectangle with `nodes` more on every side, clipped to the grid.
[[nodiscard]] inline NodeRect grown(const NodeRect& rect, int nodes, const Grid& grid)
{
    return {std::max(rect.beginI - nodes, 0), std::max(rect.beginJ - nodes, 0), std::min(rect.endI + nodes, grid.side),
            std::min(rect.endJ + nodes, grid.side)};
}

/// Returns the smallest rectangle that contains both; an empty one adds nothing.
[[nodiscard]] inline NodeRect united(const NodeRect& a, const NodeRect& b)
{
    if (a.isEmpty())
        return b;
    if (b.isEmpty())
        return a;
    return {std::min(a.beginI, b.beginI), std::min(a.beginJ, b.beginJ), std::max(a.endI, b.endI),
            std::max(a.endJ, b.endJ)};
}

}  // namespace core::terrain
