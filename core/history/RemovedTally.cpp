// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/RemovedTally.h"
#include "core/servo/ServoState.h"

#include <algorithm>

#include "core/grading/Columns.h"
#include "core/grading/Measures.h"

namespace core::history {

using servo::kTileSide;

RemovedTally::RemovedTally(std::shared_ptr<const terrain::ToothAnatomy> anatomy) : m_anatomy(std::move(anatomy)) {}

const Removed& RemovedTally::of(const TiledHeights& top)
{
    const int side = top.tilesPerSide();
    m_known.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    m_removed.volumesMm3 = {};
    m_removed.overcutMm3 = 0.0;
    m_removed.pulpExposedMm2 = 0.0;
    int columnsGone = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            Known& known = m_known[static_cast<std::size_t>(y * side + x)];
            if (const std::shared_ptr<const Tile>& tile = top.tile(x, y); known.tile != tile)
                known = reckon(x, y, tile);
            for (std::size_t m = 0; m < known.removedMm3.size(); ++m)
                m_removed.volumesMm3[m] += known.removedMm3[m];
            m_removed.overcutMm3 += known.overcutMm3;
            m_removed.pulpExposedMm2 += known.pulpExposedMm2;
            columnsGone += known.columnsGone;
        }
    }
    // This searches the whole map, so it runs only when the columns have changed.
    if (columnsGone != m_columnsGone)
        m_removed.perforated = !terrain::perforations(terrain::restored(m_anatomy, top.flat())).empty();
    m_columnsGone = columnsGone;
    return m_removed;
}

RemovedTally::Known RemovedTally::reckon(int tileX, int tileY, const std::shared_ptr<const Tile>& tile) const
{
    const terrain::Grid& grid = m_anatomy->grid;
    Known known{tile};
    const int endI = std::min((tileX + 1) * kTileSide, grid.side);
    const int endJ = std::min((tileY + 1) * kTileSide, grid.side);
    for (int j = tileY * kTileSide; j < endJ; ++j) {
        for (int i = tileX * kTileSide; i < endI; ++i) {
            const auto inTile = static_cast<std::size_t>((j % kTileSide) * kTileSide + i % kTileSide);
            const std::size_t k = grid.index(i, j);
            terrain::addRemoved(*m_anatomy, k, (*tile)[inTile], known.removedMm3);
            known.overcutMm3 += grading::overcutOf(*m_anatomy, k, (*tile)[inTile]);
            known.pulpExposedMm2 += grading::pulpExposedMm2(*m_anatomy, k, (*tile)[inTile]);
            if ((*tile)[inTile] <= terrain::kEmptyTop && m_anatomy->top[k] > m_anatomy->bottom[k])
                ++known.columnsGone;
        }
    }
    return known;
}

}  // namespace core::history
