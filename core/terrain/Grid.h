// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <cstddef>

#include <glm/vec2.hpp>

namespace core::terrain {

inline constexpr int kMinGridSide = 64;
inline constexpr int kMaxGridSide = 1024;
inline constexpr int kDefaultGridSide = 150;

/// A square lattice of nodes over the tooth, seen along -z. Node (i, j) is at origin + cell * (i, j) and represents the
/// square cell around it; i runs along +x and is the fast index.
struct Grid
{
    int side = kDefaultGridSide;    ///< nodes a side, 64 .. 1024
    double cellMm = 0.07;           ///< distance between neighbours
    glm::dvec2 originMm{0.0, 0.0};  ///< node (0, 0) in the tooth frame

    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(side) * static_cast<std::size_t>(side); }
    [[nodiscard]] std::size_t index(int i, int j) const
    {
        assert(contains(i, j));
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(side) + static_cast<std::size_t>(i);
    }
    [[nodiscard]] bool contains(int i, int j) const { return i >= 0 && j >= 0 && i < side && j < side; }
    [[nodiscard]] glm::dvec2 nodeMm(int i, int j) const { return {originMm.x + cellMm * i, originMm.y + cellMm * j}; }
    [[nodiscard]] glm::dvec2 nodeMm(std::size_t index) const
    {
        const auto row = static_cast<std::size_t>(side);
        return nodeMm(static_cast<int>(index % row), static_cast<int>(index / row));
    }
    [[nodiscard]] glm::dvec2 middleMm() const { return originMm + 0.5 * cellMm * (side - 1); }
    /// Returns the continuous lattice coordinates of a point: integers on nodes.
    [[nodiscard]] glm::dvec2 latticeOf(glm::dvec2 pointMm) const
    {
        return {(pointMm.x - originMm.x) / cellMm, (pointMm.y - originMm.y) / cellMm};
    }
    bool operator==(const Grid&) const = default;
};

}  // namespace core::terrain
