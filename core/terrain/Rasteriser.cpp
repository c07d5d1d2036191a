// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/terrain/Rasteriser.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/terrain/NodeRect.h"
#include "core/terrain/Tooth.h"

namespace core::terrain {
namespace {

using Whole = std::int64_t;

// Steps of the integer lattice per cell. A grid is at most 2^10 cells wide, so coordinates are below 2^31 and the
// products of edge functions below 2^62.
constexpr Whole kStep = Whole{1} << 20;
constexpr Whole kSamples = 16;  // per side of a cell at the rim
constexpr Whole kSampleStep = kStep / kSamples;

struct Point
{
    Whole x;
    Whole y;
};

Whole floorDivide(Whole a, Whole b)
{
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

Whole ceilDivide(Whole a, Whole b)
{
    return -floorDivide(-a, b);
}

/// A triangle over the integer lattice, counter-clockwise seen from above.
struct FlatTriangle
{
    std::array<Point, 3> corner;
    std::array<double, 3> z;
    Whole doubledArea;
    Point low;
    Point high;

    /// Returns the weight of corner k: twice the area of (p, corner k+1, corner k+2). Inside, no weight is negative.
    [[nodiscard]] Whole weight(std::size_t k, Point p) const
    {
        const Point& a = corner[(k + 1) % 3];
        const Point& b = corner[(k + 2) % 3];
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    }
};

class MeshOverGrid
{
public:
    MeshOverGrid(const mesh::TriangleMesh& mesh, const Grid& grid) : m_mesh(mesh)
    {
        m_points.reserve(mesh.vertices.size());
        for (const glm::vec3& vertex : mesh.vertices) {
            const glm::dvec2 lattice = grid.latticeOf({vertex.x, vertex.y});
            assert(lattice.x > -1.0 && lattice.y > -1.0 && lattice.x < grid.side && lattice.y < grid.side);
            m_points.push_back({std::llround(lattice.x * static_cast<double>(kStep)),
                                std::llround(lattice.y * static_cast<double>(kStep))});
        }
    }

    /// Calls visit(triangle) for each triangle that is not vertical.
    template <class Visit>
    void forEachTriangle(Visit visit) const
    {
        for (const auto& t : m_mesh.triangles) {
            FlatTriangle flat{{m_points[t[0]], m_points[t[1]], m_points[t[2]]},
                              {m_mesh.vertices[t[0]].z, m_mesh.vertices[t[1]].z, m_mesh.vertices[t[2]].z},
                              0,
                              {},
                              {}};
            flat.doubledArea = flat.weight(0, flat.corner[0]);
            if (flat.doubledArea == 0)
                continue;
            if (flat.doubledArea < 0) {
                std::swap(flat.corner[1], flat.corner[2]);
                std::swap(flat.z[1], flat.z[2]);
                flat.doubledArea = -flat.doubledArea;
            }
            const auto& c = flat.corner;
            flat.low = {std::min({c[0].x, c[1].x, c[2].x}), std::min({c[0].y, c[1].y, c[2].y})};
            flat.high = {std::max({c[0].x, c[1].x, c[2].x}), std::max({c[0].y, c[1].y, c[2].y})};
            visit(flat);
        }
    }

private:
    const mesh::TriangleMesh& m_mesh;
    std::vector<Point> m_points;
};

/// Calls visit(i, j, w) for every point (i * step + offset, j * step + offset) of a lattice in the triangle, edges
/// included, and in the rectangle. w are the weights of the corners.
template <class Visit>
void forEachPointIn(const FlatTriangle& t, Whole step, Whole offset, const NodeRect& within, Visit visit)
{
    const Whole beginI = std::max<Whole>(within.beginI, ceilDivide(t.low.x - offset, step));
    const Whole beginJ = std::max<Whole>(within.beginJ, ceilDivide(t.low.y - offset, step));
    const Whole lastI = std::min<Whole>(within.endI - 1, floorDivide(t.high.x - offset, step));
    const Whole lastJ = std::min<Whole>(within.endJ - 1, floorDivide(t.high.y - offset, step));
    if (beginI > lastI)
        return;
    for (Whole j = beginJ; j <= lastJ; ++j) {
        const Point start{beginI * step + offset, j * step + offset};
        std::array<Whole, 3> w{t.weight(0, start), t.weight(1, start), t.weight(2, start)};
        for (Whole i = beginI; i <= lastI; ++i) {
            if ((w[0] | w[1] | w[2]) >= 0)
                visit(static_cast<int>(i), static_cast<int>(j), w);
            for (std::size_t k = 0; k < 3; ++k)
                w[k] -= (t.corner[(k + 2) % 3].y - t.corner[(k + 1) % 3].y) * step;
        }
    }
}

bool isSolid(const HeightMaps& maps, std::size_t index)
{
    return maps.top[index] > maps.bottom[index];
}

void findHeights(const MeshOverGrid& mesh, HeightMaps& maps)
{
    mesh.forEachTriangle([&](const FlatTriangle& t) {
        const double perArea = 1.0 / static_cast<double>(t.doubledArea);
        forEachPointIn(t, kStep, 0, wholeOf(maps.grid), [&](int i, int j, const std::array<Whole, 3>& w) {
            const double height = (static_cast<double>(w[0]) * t.z[0] + static_cast<double>(w[1]) * t.z[1] +
                                   static_cast<double>(w[2]) * t.z[2]) *
                                  perArea;
            const std::size_t k = maps.grid.index(i, j);
            maps.top[k] = std::max(maps.top[k], static_cast<float>(height));
            maps.bottom[k] = std::min(maps.bottom[k], static_cast<float>(height));
        });
    });
}

/// Returns whether the triangle contains the point with these weights. Of two triangles on either side of a shared
/// edge, exactly one contains a point on it. Of all triangles around a corner, exactly one contains the corner.
bool holds(const FlatTriangle& t, const std::array<Whole, 3>& w)
{
    for (std::size_t k = 0; k < 3; ++k) {
        if (w[k] > 0)
            continue;
        const Point& a = t.corner[(k + 1) % 3];
        const Point& b = t.corner[(k + 2) % 3];
        if (!(b.y > a.y || (b.y == a.y && b.x > a.x)))
            return false;
    }
    return true;
}

/// Marks the nodes with an odd number of triangles, where the surface has no underside.
std::vector<std::uint8_t> nodesWithoutUnderside(const MeshOverGrid& mesh, const Grid& grid)
{
    std::vector<std::uint8_t> odd(grid.count(), 0);
    mesh.forEachTriangle([&](const FlatTriangle& t) {
        forEachPointIn(t, kStep, 0, wholeOf(grid), [&](int i, int j, const std::array<Whole, 3>& w) {
            if (holds(t, w))
                odd[grid.index(i, j)] ^= 1U;
        });
    });
    return odd;
}

constexpr std::int32_t kNotAtRim = -1;

/// Numbers the cells at the edge of the silhouette: solid nodes with an empty one among their eight neighbours, and
/// empty nodes with a solid one.
std::vector<std::int32_t> numberRimCells(const HeightMaps& maps)
{
    const Grid& grid = maps.grid;
    std::vector<std::int32_t> number(grid.count(), kNotAtRim);
    std::int32_t count = 0;
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const bool here = isSolid(maps, grid.index(i, j));
            bool rim = false;
            for (int dj = -1; dj <= 1 && !rim; ++dj)
                for (int di = -1; di <= 1 && !rim; ++di)
                    rim = (grid.contains(i + di, j + dj) && isSolid(maps, grid.index(i + di, j + dj))) != here;
            if (rim)
                number[grid.index(i, j)] = count++;
        }
    return number;
}

/// One bit for each sample of a cell, row by row: set if the sample is in the silhouette.
using Coverage = std::array<std::uint16_t, kSamples>;

std::vector<Coverage> sampleRimCells(const MeshOverGrid& mesh, const Grid& grid, const std::vector<std::int32_t>& rim)
{
    std::vector<Coverage> coverage(static_cast<std::size_t>(*std::max_element(rim.begin(), rim.end()) + 1));
    // Samples are at the centres of the 16 x 16 parts of the square around a node.
    const Whole offset = (kSampleStep - kStep) / 2;
    mesh.forEachTriangle([&](const FlatTriangle& t) {
        const auto cellOf = [&](Whole x) { return static_cast<int>(floorDivide(x + kStep / 2, kStep)); };
        const int beginI = std::max(cellOf(t.low.x), 0);
        const int beginJ = std::max(cellOf(t.low.y), 0);
        const int lastI = std::min(cellOf(t.high.x), grid.side - 1);
        const int lastJ = std::min(cellOf(t.high.y), grid.side - 1);
        for (int j = beginJ; j <= lastJ; ++j)
            for (int i = beginI; i <= lastI; ++i) {
                const std::int32_t number = rim[grid.index(i, j)];
                if (number == kNotAtRim)
                    continue;
                Coverage& cell = coverage[static_cast<std::size_t>(number)];
                constexpr int n = kSamples;
                forEachPointIn(t, kSampleStep, offset, {i * n, j * n, (i + 1) * n, (j + 1) * n},
                               [&](int a, int b, const std::array<Whole, 3>&) {
                                   cell[static_cast<std::size_t>(b - j * n)] |=
                                       static_cast<std::uint16_t>(1U << static_cast<unsigned>(a - i * n));
                               });
            }
    });
    return coverage;
}

/// Assigns each covered sample of an empty cell to the nearest surrounding solid node.
void shareOut(const Coverage& cell, const HeightMaps& maps, int i, int j, float sampleArea, std::vector<float>& area)
{
    struct Neighbour
    {
        std::size_t index;
        int a;  // in samples from the first sample of the cell, times 2 to be whole
        int b;
    };
    std::array<Neighbour, 8> solid{};
    std::size_t count = 0;
    constexpr int n = kSamples;
    for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di)
            if (maps.grid.contains(i + di, j + dj) && isSolid(maps, maps.grid.index(i + di, j + dj)))
                solid[count++] = {maps.grid.index(i + di, j + dj), n - 1 + 2 * n * di, n - 1 + 2 * n * dj};
    for (int b = 0; b < n; ++b)
        for (int a = 0; a < n; ++a) {
            if (((cell[static_cast<std::size_t>(b)] >> static_cast<unsigned>(a)) & 1U) == 0)
                continue;
            std::size_t nearest = 0;
            int least = std::numeric_limits<int>::max();
            for (std::size_t k = 0; k < count; ++k) {
                const int da = 2 * a - solid[k].a;
                const int db = 2 * b - solid[k].b;
                if (da * da + db * db < least) {
                    least = da * da + db * db;
                    nearest = solid[k].index;
                }
            }
            area[nearest] += sampleArea;
        }
}

void measureSilhouette(const MeshOverGrid& mesh, HeightMaps& maps)
{
    const Grid& grid = maps.grid;
    const double cellArea = grid.cellMm * grid.cellMm;
    const auto sampleArea = static_cast<float>(cellArea / static_cast<double>(kSamples * kSamples));
    const std::vector<std::int32_t> rim = numberRimCells(maps);
    const std::vector<Coverage> coverage = sampleRimCells(mesh, grid, rim);
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            const bool solid = isSolid(maps, k);
            if (rim[k] == kNotAtRim) {
                maps.areaMm2[k] = solid ? static_cast<float>(cellArea) : 0.0F;
                continue;
            }
            const Coverage& cell = coverage[static_cast<std::size_t>(rim[k])];
            if (!solid) {
                shareOut(cell, maps, i, j, sampleArea, maps.areaMm2);
                continue;
            }
            int covered = 0;
            for (const std::uint16_t row : cell)
                covered += std::popcount(row);
            maps.areaMm2[k] += sampleArea * static_cast<float>(covered);
        }
}

}  // namespace

Grid fitGrid(glm::dvec2 lowMm, glm::dvec2 highMm, int side)
{
    Grid grid;
    grid.side = side;
    grid.cellMm = std::max(highMm.x - lowMm.x, highMm.y - lowMm.y) / (side - 1 - 2 * kGridMargin);
    grid.originMm = (lowMm + highMm) * 0.5 - 0.5 * grid.cellMm * (side - 1);
    return grid;
}

HeightMaps rasterise(const mesh::TriangleMesh& mesh, const Grid& grid, std::optional<double> closeAtMm)
{
    HeightMaps maps{grid, std::vector<float>(grid.count(), kEmptyTop), std::vector<float>(grid.count(), kEmptyBottom),
                    std::vector<float>(grid.count(), 0.0F)};
    const MeshOverGrid over(mesh, grid);
    findHeights(over, maps);
    const std::vector<std::uint8_t> open =
        closeAtMm ? nodesWithoutUnderside(over, grid) : std::vector<std::uint8_t>(grid.count(), 0);
    for (std::size_t k = 0; k < grid.count(); ++k) {
        if (open[k] != 0)
            maps.bottom[k] = std::min(maps.bottom[k], static_cast<float>(*closeAtMm));
        if (!isSolid(maps, k)) {
            maps.top[k] = kEmptyTop;
            maps.bottom[k] = kEmptyBottom;
        }
    }
    measureSilhouette(over, maps);
    return maps;
}

double volumeOf(const HeightMaps& maps)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < maps.top.size(); ++k)
        if (isSolid(maps, k))
            sum += (static_cast<double>(maps.top[k]) - static_cast<double>(maps.bottom[k])) *
                   static_cast<double>(maps.areaMm2[k]);
    return sum;
}

}  // namespace core::terrain
