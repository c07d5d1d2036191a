// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/servo/ServoState.h"
#include "core/terrain/Grid.h"

namespace core::history {

using Tile = std::array<float, static_cast<std::size_t>(servo::kTileSide) * servo::kTileSide>;

/// A height map in immutable shared tiles: copying it copies pointers, changing it replaces only the changed tiles. So
/// the moments of an undo history share all that they have in common.
class TiledHeights
{
public:
    TiledHeights() = default;
    TiledHeights(const terrain::Grid& grid, std::span<const float> heights);

    /// Replaces one tile. flat() ignores its cells beyond the grid.
    void setTile(int tileX, int tileY, const Tile& heights);
    /// Replaces the tiles in which `heights` differs.
    void update(std::span<const float> heights);
    /// Returns the whole map, row by row.
    [[nodiscard]] std::vector<float> flat() const;

    [[nodiscard]] int tilesPerSide() const { return m_tilesPerSide; }
    [[nodiscard]] const std::shared_ptr<const Tile>& tile(int tileX, int tileY) const;
    /// Returns all tiles, row by row.
    [[nodiscard]] std::span<const std::shared_ptr<const Tile>> tiles() const { return m_tiles; }

private:
    [[nodiscard]] Tile cutOut(std::span<const float> heights, int tileX, int tileY) const;

    terrain::Grid m_grid;
    int m_tilesPerSide = 0;
    std::vector<std::shared_ptr<const Tile>> m_tiles;
};

/// Returns the group of patches that changes one map into the other: the tiles that are not shared. Empty if there are
/// none.
[[nodiscard]] std::vector<servo::TilePatch> patchesBetween(const TiledHeights& from, const TiledHeights& to,
                                                           std::uint64_t tick, std::uint64_t generation);

}  // namespace core::history
