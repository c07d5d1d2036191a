// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/history/TiledHeights.h"
#include "core/terrain/Tooth.h"

namespace core::history {

/// The material removed from a tooth.
struct Removed
{
    terrain::PerMaterial volumesMm3{};
    double overcutMm3 = 0.0;      ///< part of volumesMm3 that grading::Measures counts as overcut
    double pulpExposedMm2 = 0.0;  ///< area of opened pulp, as in grading::Measures
    bool perforated = false;      ///< there is a hole through the tooth
    bool operator==(const Removed&) const = default;
};

/// Computes the material removed from a tooth, tile by tile: only changed tiles are computed again, so that a hundred
/// calls a second are cheap on any grid. Session thread.
class RemovedTally
{
public:
    RemovedTally() = default;
    explicit RemovedTally(std::shared_ptr<const terrain::ToothAnatomy> anatomy);

    /// Returns what has been removed from a tooth with this top map (of the anatomy's grid). Sums are in the same order
    /// whatever was requested before.
    [[nodiscard]] const Removed& of(const TiledHeights& top);

private:
    struct Known
    {
        std::shared_ptr<const Tile> tile;  ///< owned, so that no other tile can get its address
        terrain::PerMaterial removedMm3{};
        double overcutMm3 = 0.0;
        double pulpExposedMm2 = 0.0;
        int columnsGone = 0;
    };

    [[nodiscard]] Known reckon(int tileX, int tileY, const std::shared_ptr<const Tile>& tile) const;

    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    std::vector<Known> m_known;  ///< one per tile
    Removed m_removed;
    int m_columnsGone = 0;  ///< when m_removed.perforated was computed
};

}  // namespace core::history
