// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace core::teeth {

/// A map of values over a rectangle, with nodes cellMm apart.
struct SampleMap
{
    glm::dvec2 lowMm{0.0};
    double cellMm = 0.3;
    int columns = 0;
    int rows = 0;
    std::vector<double> values;

    SampleMap(glm::dvec2 low, glm::dvec2 high, double cell, double empty)
        : lowMm(low), cellMm(cell), columns(static_cast<int>(std::ceil((high.x - low.x) / cell)) + 1),
          rows(static_cast<int>(std::ceil((high.y - low.y) / cell)) + 1),
          values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), empty)
    {}

    [[nodiscard]] double& at(int column, int row)
    {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)];
    }
    [[nodiscard]] double at(int column, int row) const
    {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)];
    }
    [[nodiscard]] glm::dvec2 nodeMm(int column, int row) const { return lowMm + cellMm * glm::dvec2(column, row); }
    [[nodiscard]] int columnOf(double x) const
    {
        return std::clamp(static_cast<int>(std::lround((x - lowMm.x) / cellMm)), 0, columns - 1);
    }
    [[nodiscard]] int rowOf(double y) const
    {
        return std::clamp(static_cast<int>(std::lround((y - lowMm.y) / cellMm)), 0, rows - 1);
    }
};

/// Calls take(value of the map, z) at every node under the triangle, with corners as (x, y of the map, z).
template <class Take>
void sampleTriangle(SampleMap& map, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const Take& take)
{
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area == 0.0)
        return;
    const auto cells = [&](double mm, double low) { return (mm - low) / map.cellMm; };
    const int firstColumn = std::max(0, static_cast<int>(std::ceil(cells(std::min({a.x, b.x, c.x}), map.lowMm.x))));
    const int lastColumn =
        std::min(map.columns - 1, static_cast<int>(std::floor(cells(std::max({a.x, b.x, c.x}), map.lowMm.x))));
    const int firstRow = std::max(0, static_cast<int>(std::ceil(cells(std::min({a.y, b.y, c.y}), map.lowMm.y))));
    const int lastRow =
        std::min(map.rows - 1, static_cast<int>(std::floor(cells(std::max({a.y, b.y, c.y}), map.lowMm.y))));
    for (int row = firstRow; row <= lastRow; ++row) {
        for (int column = firstColumn; column <= lastColumn; ++column) {
            const glm::dvec2 p = map.nodeMm(column, row);
            const double u = ((p.x - a.x) * (c.y - a.y) - (c.x - a.x) * (p.y - a.y)) / area;
            const double v = ((b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y)) / area;
            if (u >= -1.0e-9 && v >= -1.0e-9 && u + v <= 1.0 + 1.0e-9)
                take(map.at(column, row), a.z + u * (b.z - a.z) + v * (c.z - a.z));
        }
    }
}

}  // namespace core::teeth
