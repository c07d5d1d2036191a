// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/terrain/Tooth.h"

namespace core::grading {

/// The outline of a cut, where the surface has been lowered by kOutlineDepthMm, seen from above, finer than the grid.
///
/// The depth of a column, up to twice kOutlineDepthMm, is averaged over its neighbours (1 2 1 along x and along y) and
/// interpolated linearly between nodes. So an upright wall is midway between the last cut column and the first uncut
/// one, and a wall at an angle to the lattice is a line without steps.
class Outline
{
public:
    /// @param end  heights at which the columns end, [side * side]; columns that were empty from the start do not count
    Outline(const terrain::ToothAnatomy& anatomy, std::span<const float> end);

    struct Segment
    {
        glm::dvec2 fromMm;
        glm::dvec2 toMm;
        glm::dvec2 outwards;  ///< unit vector, towards the uncut side
        std::size_t node;     ///< nearest
        [[nodiscard]] glm::dvec2 middleMm() const { return 0.5 * (fromMm + toMm); }
        [[nodiscard]] double lengthMm() const;
        [[nodiscard]] double distanceMm(glm::dvec2 pointMm) const;
    };
    [[nodiscard]] std::span<const Segment> segments() const { return m_segments; }

    /// Returns the distance to the nearest point of the outline. The outline must not be empty.
    [[nodiscard]] double distanceMm(glm::dvec2 pointMm) const;

    /// Calls visit(segment) for each segment whose middle is within a distance of a point.
    template <class Visit>
    void forEachWithin(glm::dvec2 pointMm, double distanceMm, const Visit& visit) const
    {
        const glm::ivec2 low = binAt(pointMm - distanceMm);
        const glm::ivec2 high = binAt(pointMm + distanceMm);
        for (int b = low.y; b <= high.y; ++b)
            for (int a = low.x; a <= high.x; ++a)
                for (const Segment& segment : inBin(a, b)) {
                    const glm::dvec2 way = segment.middleMm() - pointMm;
                    if (glm::dot(way, way) <= distanceMm * distanceMm)
                        visit(segment);
                }
    }

    /// Returns how far inside the outline a place is, as a depth in mm: 0 on it, kOutlineDepthMm at most.
    [[nodiscard]] double insideMm(glm::dvec2 pointMm) const;
    [[nodiscard]] double insideMm(int i, int j) const { return m_depth[m_grid.index(i, j)] - m_level; }
    /// Returns the node nearest to a place, clamped to the grid.
    [[nodiscard]] std::size_t nodeAt(glm::dvec2 pointMm) const;

private:
    void trace(int i, int j);
    /// Returns the square of cells around a place, clamped to the grid.
    [[nodiscard]] glm::ivec2 binAt(glm::dvec2 pointMm) const;
    /// Returns the segments that begin in square (a, b).
    [[nodiscard]] std::span<const Segment> inBin(int a, int b) const
    {
        const std::size_t bin =
            static_cast<std::size_t>(b) * static_cast<std::size_t>(m_binsASide) + static_cast<std::size_t>(a);
        return std::span(m_segments).subspan(m_binBegins[bin], m_binBegins[bin + 1] - m_binBegins[bin]);
    }

    terrain::Grid m_grid;
    double m_level;
    std::vector<double> m_depth;      ///< [side * side]
    std::vector<Segment> m_segments;  ///< square by square
    int m_binsASide = 0;
    std::vector<std::size_t> m_binBegins;  ///< index of the first segment of each square; then the number of segments
};

}  // namespace core::grading
