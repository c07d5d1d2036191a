// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grading/Outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/grading/Columns.h"
#include "core/grading/Deviation.h"

namespace core::grading {
namespace {

constexpr int kBinSide = 8;

/// Applies the weights 1 2 1 over neighbours `stride` apart, along rows or columns. Beyond the border the values are 0.
void blur(std::vector<double>& map, const terrain::Grid& grid, bool alongX)
{
    const auto side = static_cast<std::size_t>(grid.side);
    const std::size_t step = alongX ? 1 : side;
    const std::size_t next = alongX ? side : 1;
    for (std::size_t line = 0; line < side; ++line) {
        double before = 0.0;
        for (std::size_t n = 0; n < side; ++n) {
            double& here = map[line * next + n * step];
            const double after = n + 1 < side ? map[line * next + (n + 1) * step] : 0.0;
            const double was = here;
            here = 0.25 * (before + after) + 0.5 * was;
            before = was;
        }
    }
}

double distance2(glm::dvec2 point, const Outline::Segment& segment)
{
    const glm::dvec2 along = segment.toMm - segment.fromMm;
    const double length2 = glm::dot(along, along);
    const double share = length2 > 0.0 ? std::clamp(glm::dot(point - segment.fromMm, along) / length2, 0.0, 1.0) : 0.0;
    const glm::dvec2 way = point - (segment.fromMm + along * share);
    return glm::dot(way, way);
}

}  // namespace

double Outline::Segment::lengthMm() const
{
    const glm::dvec2 along = toMm - fromMm;
    return std::sqrt(glm::dot(along, along));
}

double Outline::Segment::distanceMm(glm::dvec2 pointMm) const
{
    return std::sqrt(distance2(pointMm, *this));
}

Outline::Outline(const terrain::ToothAnatomy& anatomy, std::span<const float> end)
    : m_grid(anatomy.grid), m_level(kOutlineDepthMm), m_depth(anatomy.grid.count(), 0.0)
{
    for (std::size_t k = 0; k < m_depth.size(); ++k)
        if (wasSolid(anatomy, k))
            m_depth[k] = std::clamp(static_cast<double>(anatomy.top[k]) - static_cast<double>(end[k]), 0.0,
                                    2.0 * kOutlineDepthMm);
    blur(m_depth, m_grid, true);
    blur(m_depth, m_grid, false);

    const int cells = m_grid.side - 1;
    m_binsASide = (cells + kBinSide - 1) / kBinSide;
    for (int b = 0; b < m_binsASide; ++b) {
        for (int a = 0; a < m_binsASide; ++a) {
            m_binBegins.push_back(m_segments.size());
            for (int j = b * kBinSide; j < std::min(cells, (b + 1) * kBinSide); ++j)
                for (int i = a * kBinSide; i < std::min(cells, (a + 1) * kBinSide); ++i)
                    trace(i, j);
        }
    }
    m_binBegins.push_back(m_segments.size());
}

glm::ivec2 Outline::binAt(glm::dvec2 pointMm) const
{
    const glm::dvec2 bin = m_grid.latticeOf(pointMm) / static_cast<double>(kBinSide);
    return {glm::clamp(bin, glm::dvec2(0.0), glm::dvec2(m_binsASide - 1))};
}

/// Adds the segments of the square between node (i, j) and the next nodes (marching squares). If two opposite corners
/// are inside, the mean of the four decides whether they are connected.
void Outline::trace(int i, int j)
{
    // Corners of the square, counter-clockwise from (i, j).
    constexpr std::array<std::array<int, 2>, 4> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    std::array<double, 4> inside{};
    int count = 0;
    for (std::size_t c = 0; c < 4; ++c) {
        inside.at(c) = insideMm(i + kCorners.at(c)[0], j + kCorners.at(c)[1]);
        count += inside.at(c) > 0.0 ? 1 : 0;
    }
    if (count == 0 || count == 4)
        return;
    const glm::dvec2 gradient(inside[1] - inside[0] + inside[2] - inside[3],
                              inside[3] - inside[0] + inside[2] - inside[1]);
    const double steepness = std::sqrt(glm::dot(gradient, gradient));
    const glm::dvec2 outwards = steepness > 0.0 ? -gradient / steepness : glm::dvec2(1.0, 0.0);

    std::array<glm::dvec2, 4> crossing{};
    std::size_t crossings = 0;
    for (std::size_t c = 0; c < 4; ++c) {
        const std::size_t d = (c + 1) % 4;
        if ((inside.at(c) > 0.0) == (inside.at(d) > 0.0))
            continue;
        const double share = inside.at(c) / (inside.at(c) - inside.at(d));
        const glm::dvec2 from = m_grid.nodeMm(i + kCorners.at(c)[0], j + kCorners.at(c)[1]);
        const glm::dvec2 to = m_grid.nodeMm(i + kCorners.at(d)[0], j + kCorners.at(d)[1]);
        crossing.at(crossings++) = from + (to - from) * share;
    }
    const auto add = [&](std::size_t a, std::size_t b) {
        const glm::dvec2 middle = 0.5 * (crossing.at(a) + crossing.at(b));
        m_segments.push_back({crossing.at(a), crossing.at(b), outwards, nodeAt(middle)});
    };
    if (crossings == 2) {
        add(0, 1);
        return;
    }
    // A saddle: the outline crosses all four sides, 0 below, 1 right, 2 above, 3 left.
    const bool middleIsInside = inside[0] + inside[1] + inside[2] + inside[3] > 0.0;
    const bool firstIsInside = inside[0] > 0.0;
    if (middleIsInside == firstIsInside) {
        add(0, 1);
        add(2, 3);
    } else {
        add(3, 0);
        add(1, 2);
    }
}

double Outline::distanceMm(glm::dvec2 pointMm) const
{
    // Searches in rings around the square of the point: the squares of ring n are at least n - 1 squares away.
    const glm::ivec2 own = binAt(pointMm);
    const double binMm = kBinSide * m_grid.cellMm;
    double best = std::numeric_limits<double>::infinity();
    for (int ring = 0; ring < m_binsASide; ++ring) {
        const double atLeast = binMm * std::max(0, ring - 1);
        if (best <= atLeast * atLeast)
            break;
        for (int b = std::max(0, own.y - ring); b <= std::min(m_binsASide - 1, own.y + ring); ++b) {
            const bool isEnd = b == own.y - ring || b == own.y + ring;
            for (int a = own.x - ring; a <= own.x + ring; a += isEnd || ring == 0 ? 1 : 2 * ring)
                if (a >= 0 && a < m_binsASide)
                    for (const Segment& segment : inBin(a, b))
                        best = std::min(best, distance2(pointMm, segment));
        }
    }
    return std::sqrt(best);
}

double Outline::insideMm(glm::dvec2 pointMm) const
{
    const glm::dvec2 at = glm::clamp(m_grid.latticeOf(pointMm), glm::dvec2(0.0), glm::dvec2(m_grid.side - 1));
    const int i = std::min(static_cast<int>(at.x), m_grid.side - 2);
    const int j = std::min(static_cast<int>(at.y), m_grid.side - 2);
    const double u = at.x - i;
    const double v = at.y - j;
    return (1.0 - v) * ((1.0 - u) * insideMm(i, j) + u * insideMm(i + 1, j)) +
           v * ((1.0 - u) * insideMm(i, j + 1) + u * insideMm(i + 1, j + 1));
}

std::size_t Outline::nodeAt(glm::dvec2 pointMm) const
{
    const glm::dvec2 at = glm::clamp(m_grid.latticeOf(pointMm) + 0.5, glm::dvec2(0.0), glm::dvec2(m_grid.side - 1));
    return m_grid.index(static_cast<int>(at.x), static_cast<int>(at.y));
}

}  // namespace core::grading
