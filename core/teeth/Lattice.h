// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/terrain/Grid.h"

namespace core::teeth {

/// "No value": far above every height, like kEmptyBottom.
inline constexpr float kNoValue = 1.0e6F;

/// Every stride-th node of a grid. The tissues below a tooth's surface are smooth, so they are computed on nodes about
/// 0.15 mm apart whatever the grid, and interpolated: the same tooth at every grid side, and bounded cost of rolling
/// millimetre balls over it.
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

    /// Returns the values of a grid's map at the lattice's nodes; `beyond` for nodes outside the grid.
    [[nodiscard]] std::vector<float> pick(std::span<const float> map, float beyond) const;
    /// Like pick(), but returns the lowest value of the grid's nodes around each lattice node, so that a groove
    /// narrower than the lattice is not missed.
    [[nodiscard]] std::vector<float> pickLowest(std::span<const float> map, float beyond) const;
    /// Returns the value of a lattice field at grid node (i, j), bilinear over the corners that have a value; kNoValue
    /// if none.
    [[nodiscard]] float at(std::span<const float> field, int i, int j) const;

    /// Returns the lower envelope of balls: min over nodes p of z(p) - sqrt(radius(p)^2 - |q-p|^2) for |q-p| <=
    /// radius(p); the surface that a cutter of that radius leaves below z (grey erosion). Nodes with z == kNoValue have
    /// no ball.
    [[nodiscard]] std::vector<float> ballsBelow(std::span<const float> z, std::span<const float> radiusMm) const;

    /// Returns the grey closing by a flat disc: fills openings narrower than the disc. Nodes at or below `emptyBelow`
    /// are outside the tooth and are ignored.
    [[nodiscard]] std::vector<float> close(std::span<const float> z, double radiusMm, float emptyBelow) const;

    /// Returns the mean over a disc of the nodes above `emptyBelow`; the other nodes are unchanged.
    [[nodiscard]] std::vector<float> smooth(std::span<const float> z, double radiusMm, float emptyBelow) const;

private:
    terrain::Grid m_grid;
    int m_stride;
    int m_side;
    double m_cellMm;
};

/// Returns 1 for the nodes of a tooth, [side * side].
[[nodiscard]] std::vector<std::uint8_t> solidNodes(std::span<const float> top, std::span<const float> bottom);

/// The state of nodes beyond a grid.
enum class Beyond { Unmarked, Marked };

/// Returns the distance in mm from each node marked 1 to the outline of the marked set (half a cell before the nearest
/// unmarked node), 0 on unmarked nodes; more than the width of the grid if no node is unmarked. Exact Euclidean
/// (Felzenszwalb, Huttenlocher 2012).
[[nodiscard]] std::vector<float> distanceInside(const terrain::Grid& grid, std::span<const std::uint8_t> marked,
                                                Beyond beyond = Beyond::Unmarked);

}  // namespace core::teeth
