// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/history/TiledHeights.h"
#include "core/terrain/Tooth.h"

namespace core::history {

/// What has come off a tooth.
struct Removed
{
    terrain::PerMaterial volumesMm3{};
    double overcutMm3 = 0.0;  ///< of these, what grading::Measures counts as overcut
    bool perforated = false;  ///< a hole goes right through
    bool operator==(const Removed&) const = default;
};

/// What has been removed from a tooth, kept tile by tile: only tiles that have changed since are reckoned again, so
/// that a hundred questions a second cost little on any grid. Session thread.
class RemovedTally
{
public:
    RemovedTally() = default;
    explicit RemovedTally(std::shared_ptr<const terrain::ToothAnatomy> anatomy);

    /// What is gone where the top map is `top` (of the anatomy's grid). The same sums in the same order whatever was
    /// asked before.
    [[nodiscard]] const Removed& of(const TiledHeights& top);

private:
    struct Known
    {
        std::shared_ptr<const Tile> tile;  ///< held, so that no other tile can take its address
        terrain::PerMaterial removedMm3{};
        double overcutMm3 = 0.0;
        int columnsGone = 0;
    };

    [[nodiscard]] Known reckon(int tileX, int tileY, const std::shared_ptr<const Tile>& tile) const;

    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    std::vector<Known> m_known;  ///< one a tile
    Removed m_removed;
    int m_columnsGone = 0;  ///< when m_removed.perforated was found out
};

}  // namespace core::history
