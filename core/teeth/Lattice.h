// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/terrain/Grid.h"

namespace core::teeth {

/// No value here. Far above every height, as kEmptyBottom is.
inline constexpr float kNoValue = 1.0e6F;

/// Every stride-th node of a grid. What lies under a tooth's surface is smooth, so it is worked out on nodes about
/// 0.15 mm apart whatever the grid and interpolated: the same tooth at every grid side, and the cost of rolling
/// millimetre balls over it stays bounded.
class Lattice
{
public:
    explicit Lattice(const terrain::Grid& grid, double spacingMm = 0.15);

    [[nodiscard]] int side() const { return m_side; }
    [[nodiscard]] int stride() const { return m_stride; }
    [[nodiscard]] double cellMm() const { return m_cellMm; }
    [[nodiscard]] std::size_t index(int a, int b) const
    {
        return static_cast<std::size_t>(b) * static_cast<std::size_t>(m_side) + static_cast<std::size_t>(a);
    }
    [[nodiscard]] std::size_t count() const { return index(0, m_side); }

    /// The values of a grid's map at the lattice's nodes; `beyond` where a node lies past the grid.
    [[nodiscard]] std::vector<float> pick(std::span<const float> map, float beyond) const;
    /// As pick(), but the lowest value of the grid's nodes around each of the lattice's: a groove narrower than the
    /// lattice is not stepped over.
    [[nodiscard]] std::vector<float> pickLowest(std::span<const float> map, float beyond) const;
    /// Value of a lattice field at grid node (i, j), bilinear over those corners that have a value; kNoValue if none.
    [[nodiscard]] float at(std::span<const float> field, int i, int j) const;

    /// Lower envelope of balls: min over nodes p of z(p) - sqrt(radius(p)^2 - |q-p|^2) for |q-p| <= radius(p); the
    /// surface that a cutter of that radius leaves below z (grey erosion). Nodes with z == kNoValue carry no ball.
    [[nodiscard]] std::vector<float> ballsBelow(std::span<const float> z, std::span<const float> radiusMm) const;

    /// Grey closing by a flat disc: fills what is narrower than the disc, leaves the rest. Nodes at or below
    /// `emptyBelow` are outside the tooth: they neither fill nor are filled.
    [[nodiscard]] std::vector<float> close(std::span<const float> z, double radiusMm, float emptyBelow) const;

    /// Mean over a disc of the nodes above `emptyBelow`, those at or below it are left as they are.
    [[nodiscard]] std::vector<float> smooth(std::span<const float> z, double radiusMm, float emptyBelow) const;

private:
    terrain::Grid m_grid;
    int m_stride;
    int m_side;
    double m_cellMm;
};

/// Marks the nodes of a tooth with 1, [side * side].
[[nodiscard]] std::vector<std::uint8_t> solidNodes(std::span<const float> top, std::span<const float> bottom);

/// What lies beyond a grid.
enum class Beyond { Unmarked, Marked };

/// Distance in mm from each node marked 1 to the outline of the marked set (half a cell before the nearest unmarked
/// node), 0 on unmarked nodes; more than the grid is wide where no node is unmarked. Exact Euclidean (Felzenszwalb,
/// Huttenlocher 2012).
[[nodiscard]] std::vector<float> distanceInside(const terrain::Grid& grid, std::span<const std::uint8_t> marked,
                                                Beyond beyond = Beyond::Unmarked);

}  // namespace core::teeth
