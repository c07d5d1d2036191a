// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/history/TiledHeights.h"
#include "core/terrain/Tooth.h"

namespace core::history {

/// What has been removed from a tooth, kept tile by tile: only tiles that have changed since are reckoned again, so
/// that a hundred questions a second cost little on any grid. Session thread.
class RemovedTally
{
public:
    RemovedTally() = default;
    explicit RemovedTally(std::shared_ptr<const terrain::ToothAnatomy> anatomy);

    /// Volume of each material, mm3, that is gone where the top map is `top` (of the anatomy's grid). The same sums in
    /// the same order whatever was asked before.
    [[nodiscard]] const terrain::PerMaterial& of(const TiledHeights& top);
    /// Columns that were cut through where of() was asked last.
    [[nodiscard]] int columnsGone() const { return m_columnsGone; }

private:
    struct Known
    {
        std::shared_ptr<const Tile> tile;  ///< held, so that no other tile can take its address
        terrain::PerMaterial removedMm3{};
        int columnsGone = 0;
    };

    [[nodiscard]] Known reckon(int tileX, int tileY, const std::shared_ptr<const Tile>& tile) const;

    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    std::vector<Known> m_known;  ///< one a tile
    terrain::PerMaterial m_sumMm3{};
    int m_columnsGone = 0;
};

}  // namespace core::history
