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

/// A height map as immutable shared tiles: copying it copies pointers, changing it replaces touched tiles only.
/// So the states of an undo history share all that they have in common.
class TiledHeights
{
public:
    TiledHeights() = default;
    TiledHeights(const terrain::Grid& grid, std::span<const float> heights);

    /// Replaces one tile; cells beyond the grid are ignored when reading back.
    void setTile(int tileX, int tileY, const Tile& heights);
    /// Replaces those tiles in which `heights` differs from what is held.
    void update(std::span<const float> heights);
    /// The whole map, row by row.
    [[nodiscard]] std::vector<float> flat() const;

    [[nodiscard]] int tilesPerSide() const { return m_tilesPerSide; }
    [[nodiscard]] const std::shared_ptr<const Tile>& tile(int tileX, int tileY) const;
    /// All tiles, row by row.
    [[nodiscard]] std::span<const std::shared_ptr<const Tile>> tiles() const { return m_tiles; }

private:
    [[nodiscard]] Tile cutOut(std::span<const float> heights, int tileX, int tileY) const;

    terrain::Grid m_grid;
    int m_tilesPerSide = 0;
    std::vector<std::shared_ptr<const Tile>> m_tiles;
};

/// The group of patches that turns one map into the other: tiles that are not shared, the last one closing the group.
/// Empty if there are none.
[[nodiscard]] std::vector<servo::TilePatch> patchesBetween(const TiledHeights& from, const TiledHeights& to,
                                                           std::uint64_t tick, std::uint64_t generation);

}  // namespace core::history
