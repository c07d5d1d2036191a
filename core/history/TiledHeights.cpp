// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/TiledHeights.h"

#include <algorithm>
#include <cassert>

namespace core::history {
namespace {

using servo::kTileSide;

}  // namespace

TiledHeights::TiledHeights(const terrain::Grid& grid, std::span<const float> heights)
    : m_grid(grid), m_tilesPerSide((grid.side + kTileSide - 1) / kTileSide)
{
    assert(heights.size() == grid.count());
    m_tiles.reserve(static_cast<std::size_t>(m_tilesPerSide) * static_cast<std::size_t>(m_tilesPerSide));
    for (int y = 0; y < m_tilesPerSide; ++y)
        for (int x = 0; x < m_tilesPerSide; ++x)
            m_tiles.push_back(std::make_shared<const Tile>(cutOut(heights, x, y)));
}

Tile TiledHeights::cutOut(std::span<const float> heights, int tileX, int tileY) const
{
    Tile tile;
    tile.fill(terrain::kEmptyTop);
    const int firstI = tileX * kTileSide;
    const int firstJ = tileY * kTileSide;
    const int columns = std::min(kTileSide, m_grid.side - firstI);
    for (int j = firstJ; j < std::min(firstJ + kTileSide, m_grid.side); ++j)
        std::copy_n(heights.begin() + static_cast<std::ptrdiff_t>(m_grid.index(firstI, j)), columns,
                    tile.begin() + static_cast<std::ptrdiff_t>((j - firstJ) * kTileSide));
    return tile;
}

const std::shared_ptr<const Tile>& TiledHeights::tile(int tileX, int tileY) const
{
    return m_tiles[static_cast<std::size_t>(tileY * m_tilesPerSide + tileX)];
}

void TiledHeights::setTile(int tileX, int tileY, const Tile& heights)
{
    m_tiles[static_cast<std::size_t>(tileY * m_tilesPerSide + tileX)] = std::make_shared<const Tile>(heights);
}

void TiledHeights::update(std::span<const float> heights)
{
    for (int y = 0; y < m_tilesPerSide; ++y) {
        for (int x = 0; x < m_tilesPerSide; ++x) {
            const Tile now = cutOut(heights, x, y);
            if (now != *tile(x, y))
                setTile(x, y, now);
        }
    }
}

std::vector<float> TiledHeights::flat() const
{
    std::vector<float> heights(m_grid.count());
    for (int j = 0; j < m_grid.side; ++j) {
        for (int x = 0; x < m_tilesPerSide; ++x) {
            const int firstI = x * kTileSide;
            const int columns = std::min(kTileSide, m_grid.side - firstI);
            const Tile& from = *tile(x, j / kTileSide);
            std::copy_n(from.begin() + static_cast<std::ptrdiff_t>((j % kTileSide) * kTileSide), columns,
                        heights.begin() + static_cast<std::ptrdiff_t>(m_grid.index(firstI, j)));
        }
    }
    return heights;
}

std::vector<servo::TilePatch> patchesBetween(const TiledHeights& from, const TiledHeights& to, std::uint64_t tick,
                                             std::uint64_t generation)
{
    assert(from.tilesPerSide() == to.tilesPerSide());
    std::vector<servo::TilePatch> group;
    for (int y = 0; y < to.tilesPerSide(); ++y) {
        for (int x = 0; x < to.tilesPerSide(); ++x) {
            if (from.tile(x, y) == to.tile(x, y))
                continue;
            servo::TilePatch& patch = group.emplace_back();
            patch.tick = tick;
            patch.toothGeneration = generation;
            patch.tileX = static_cast<std::uint16_t>(x);
            patch.tileY = static_cast<std::uint16_t>(y);
            patch.top = *to.tile(x, y);
        }
    }
    if (!group.empty())
        group.back().last = true;
    return group;
}

}  // namespace core::history
