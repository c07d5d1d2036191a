// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/Lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core::teeth {
namespace {

struct Step
{
    int a;
    int b;
};

std::vector<Step> disc(double radiusCells)
{
    std::vector<Step> steps;
    const int reach = static_cast<int>(std::floor(radiusCells));
    for (int b = -reach; b <= reach; ++b)
        for (int a = -reach; a <= reach; ++a)
            if (a * a + b * b <= radiusCells * radiusCells)
                steps.push_back({a, b});
    return steps;
}

/// Computes the squared distance transform of one line: out[q] = min over p of (q-p)^2 + f[p].
void squaredDistance(std::span<const double> f, std::span<double> out, std::vector<int>& hull,
                     std::vector<double>& from)
{
    const int n = static_cast<int>(f.size());
    const auto value = [&](int p) { return f[static_cast<std::size_t>(p)]; };
    hull.assign(1, 0);
    from.assign(1, -std::numeric_limits<double>::infinity());
    for (int q = 1; q < n; ++q) {
        const auto meet = [&](int p) {
            return ((value(q) + 1.0 * q * q) - (value(p) + 1.0 * p * p)) / (2.0 * (q - p));
        };
        while (hull.size() > 1 && meet(hull.back()) <= from.back()) {
            hull.pop_back();
            from.pop_back();
        }
        from.push_back(meet(hull.back()));
        hull.push_back(q);
    }
    std::size_t k = 0;
    for (int q = 0; q < n; ++q) {
        while (k + 1 < hull.size() && from[k + 1] < q)
            ++k;
        const double step = q - hull[k];
        out[static_cast<std::size_t>(q)] = step * step + value(hull[k]);
    }
}

}  // namespace

Lattice::Lattice(const terrain::Grid& grid, double spacingMm)
    : m_grid(grid), m_stride(std::max(1, static_cast<int>(std::lround(spacingMm / grid.cellMm)))),
      m_side((grid.side - 1 + m_stride - 1) / m_stride + 1), m_cellMm(grid.cellMm * m_stride)
{}

std::vector<float> Lattice::pick(std::span<const float> map, float beyond) const
{
    std::vector<float> field(count(), beyond);
    for (int b = 0; b * m_stride < m_grid.side; ++b)
        for (int a = 0; a * m_stride < m_grid.side; ++a)
            field[index(a, b)] = map[m_grid.index(a * m_stride, b * m_stride)];
    return field;
}

std::vector<float> Lattice::pickLowest(std::span<const float> map, float beyond) const
{
    std::vector<float> field = pick(map, beyond);
    const int around = m_stride / 2;
    for (int b = 0; b * m_stride < m_grid.side; ++b) {
        for (int a = 0; a * m_stride < m_grid.side; ++a) {
            float& lowest = field[index(a, b)];
            if (lowest <= beyond)
                continue;
            for (int j = b * m_stride - around; j <= b * m_stride + around; ++j)
                for (int i = a * m_stride - around; i <= a * m_stride + around; ++i)
                    if (m_grid.contains(i, j) && map[m_grid.index(i, j)] > beyond)
                        lowest = std::min(lowest, map[m_grid.index(i, j)]);
        }
    }
    return field;
}

float Lattice::at(std::span<const float> field, int i, int j) const
{
    const int a = std::min(i / m_stride, m_side - 2);
    const int b = std::min(j / m_stride, m_side - 2);
    const float u = static_cast<float>(i - a * m_stride) / static_cast<float>(m_stride);
    const float v = static_cast<float>(j - b * m_stride) / static_cast<float>(m_stride);
    float sum = 0.0F;
    float weights = 0.0F;
    const auto corner = [&](int da, int db, float weight) {
        const float value = field[index(a + da, b + db)];
        if (value == kNoValue || weight == 0.0F)
            return;
        sum += weight * value;
        weights += weight;
    };
    corner(0, 0, (1.0F - u) * (1.0F - v));
    corner(1, 0, u * (1.0F - v));
    corner(0, 1, (1.0F - u) * v);
    corner(1, 1, u * v);
    return weights > 0.0F ? sum / weights : kNoValue;
}

std::vector<float> Lattice::ballsBelow(std::span<const float> z, std::span<const float> radiusMm) const
{
    std::vector<float> lowest(count(), kNoValue);
    const auto cell = static_cast<float>(m_cellMm);
    for (int b = 0; b < m_side; ++b) {
        for (int a = 0; a < m_side; ++a) {
            const std::size_t centre = index(a, b);
            if (z[centre] == kNoValue)
                continue;
            const float radius = std::max(0.0F, radiusMm[centre]) / cell;
            const int reach = static_cast<int>(radius);
            for (int db = std::max(-reach, -b); db <= std::min(reach, m_side - 1 - b); ++db) {
                const float chord = radius * radius - static_cast<float>(db * db);
                const int width = static_cast<int>(std::sqrt(chord));
                for (int da = std::max(-width, -a); da <= std::min(width, m_side - 1 - a); ++da) {
                    const float depth = cell * std::sqrt(std::max(0.0F, chord - static_cast<float>(da * da)));
                    float& here = lowest[index(a + da, b + db)];
                    here = std::min(here, z[centre] - depth);
                }
            }
        }
    }
    return lowest;
}

std::vector<float> Lattice::close(std::span<const float> z, double radiusMm, float emptyBelow) const
{
    const std::vector<Step> steps = disc(radiusMm / m_cellMm);
    const auto sweep = [&](std::span<const float> from, auto better) {
        std::vector<float> to(from.begin(), from.end());
        for (int b = 0; b < m_side; ++b) {
            for (int a = 0; a < m_side; ++a) {
                float& best = to[index(a, b)];
                if (best <= emptyBelow)
                    continue;
                for (const Step& step : steps) {
                    const int na = a + step.a;
                    const int nb = b + step.b;
                    if (na < 0 || nb < 0 || na >= m_side || nb >= m_side)
                        continue;
                    const float there = from[index(na, nb)];
                    if (there > emptyBelow)
                        best = better(best, there);
                }
            }
        }
        return to;
    };
    const std::vector<float> raised = sweep(z, [](float x, float y) { return std::max(x, y); });
    return sweep(raised, [](float x, float y) { return std::min(x, y); });
}

std::vector<float> Lattice::smooth(std::span<const float> z, double radiusMm, float emptyBelow) const
{
    const std::vector<Step> steps = disc(radiusMm / m_cellMm);
    std::vector<float> mean(z.begin(), z.end());
    for (int b = 0; b < m_side; ++b) {
        for (int a = 0; a < m_side; ++a) {
            if (z[index(a, b)] <= emptyBelow)
                continue;
            double sum = 0.0;
            int nodes = 0;
            for (const Step& step : steps) {
                const int na = a + step.a;
                const int nb = b + step.b;
                if (na < 0 || nb < 0 || na >= m_side || nb >= m_side || z[index(na, nb)] <= emptyBelow)
                    continue;
                sum += static_cast<double>(z[index(na, nb)]);
                ++nodes;
            }
            mean[index(a, b)] = static_cast<float>(sum / nodes);
        }
    }
    return mean;
}

std::vector<std::uint8_t> solidNodes(std::span<const float> top, std::span<const float> bottom)
{
    std::vector<std::uint8_t> solid(top.size());
    for (std::size_t k = 0; k < solid.size(); ++k)
        solid[k] = top[k] > bottom[k] ? 1 : 0;
    return solid;
}

std::vector<float> distanceInside(const terrain::Grid& grid, std::span<const std::uint8_t> marked, Beyond beyond)
{
    // A frame of nodes around the grid represents the space outside it.
    const auto side = static_cast<std::size_t>(grid.side) + 2;
    const double far = 4.0 * static_cast<double>(side) * static_cast<double>(side);
    std::vector<double> squared(side * side, beyond == Beyond::Marked ? far : 0.0);
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i)
            squared[(static_cast<std::size_t>(j) + 1) * side + static_cast<std::size_t>(i) + 1] =
                marked[grid.index(i, j)] != 0 ? far : 0.0;

    std::vector<double> line(side);
    std::vector<double> result(side);
    std::vector<int> hull;
    std::vector<double> from;
    for (std::size_t i = 0; i < side; ++i) {
        for (std::size_t j = 0; j < side; ++j)
            line[j] = squared[j * side + i];
        squaredDistance(line, result, hull, from);
        for (std::size_t j = 0; j < side; ++j)
            squared[j * side + i] = result[j];
    }
    for (std::size_t j = 0; j < side; ++j) {
        const std::span<double> row(squared.data() + j * side, side);
        squaredDistance(row, result, hull, from);
        std::copy(result.begin(), result.end(), row.begin());
    }

    std::vector<float> distance(grid.count(), 0.0F);
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i)
            if (marked[grid.index(i, j)] != 0)
                distance[grid.index(i, j)] = static_cast<float>(
                    grid.cellMm *
                    (std::sqrt(squared[(static_cast<std::size_t>(j) + 1) * side + static_cast<std::size_t>(i) + 1]) -
                     0.5));
    return distance;
}

}  // namespace core::teeth
