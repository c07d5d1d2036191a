// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/BreakOff.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace core::cutting {
namespace {

struct Direction
{
    int di;
    int dj;
    double cells;
};
constexpr double kDiagonal = 1.4142135623730951;
constexpr std::array<Direction, 8> kDirections{{{1, 0, 1.0},
                                                {1, 1, kDiagonal},
                                                {0, 1, 1.0},
                                                {-1, 1, kDiagonal},
                                                {-1, 0, 1.0},
                                                {-1, -1, kDiagonal},
                                                {0, -1, 1.0},
                                                {1, -1, kDiagonal}}};

/// Returns the number of columns from the cut column (i, j) on that are too thin to stand; 0 if they stand.
/// @param base  set to the height of the ground below them
int thinColumns(const terrain::Tooth& tooth, int i, int j, const Direction& towards, double slenderness, double& base)
{
    const terrain::Grid& grid = tooth.grid();
    const double mmHigh = slenderness * grid.cellMm * towards.cells;  // for each column of width
    // A perforated column does not exist: the columns beside it stand no higher than their own length.
    auto ground = static_cast<double>(tooth.top[grid.index(i, j)]);
    double lowest = 1.0e9;  // top of the columns so far
    for (int count = 0;; ++count) {
        const int nextI = i + towards.di * (count + 1);
        const int nextJ = j + towards.dj * (count + 1);
        const bool isThere = grid.contains(nextI, nextJ) && tooth.isSolid(grid.index(nextI, nextJ));
        const auto next = static_cast<double>(isThere ? tooth.top[grid.index(nextI, nextJ)] : terrain::kEmptyTop);
        if (count > 0 && lowest - std::max(ground, next) > mmHigh * count) {
            base = std::max(ground, next);
            return count;
        }
        // With one more column the wall is wider. Checks whether it is high enough to break if no column is behind it.
        lowest = std::min(lowest, next);
        if (isThere)
            ground = std::max(ground, static_cast<double>(tooth.bottom[grid.index(nextI, nextJ)]));
        if (!(lowest - ground > mmHigh * (count + 1)))
            return 0;
    }
}

/// Lowers column (i, j) to `base` and adds the removed volume to `broken`.
void lower(contact::LiveTooth& live, int i, int j, double base, terrain::PerMaterial& broken) noexcept
{
    const terrain::Tooth& tooth = live.tooth();
    const std::size_t k = tooth.grid().index(i, j);
    const float to = std::max(static_cast<float>(base), tooth.bottom[k]);
    const terrain::PerMaterial length = terrain::lengthsBetween(tooth.anatomy->layers[k], to, tooth.top[k]);
    for (std::size_t m = 0; m < length.size(); ++m)
        broken[m] += length[m] * static_cast<double>(tooth.anatomy->areaMm2[k]);
    live.lower(i, j, to);
}

/// Marks the cut columns of row j, from i0 on, that have a neighbour higher by more than `rise`: only there can a wall
/// be too thin. For most columns of a cut this is the only test, so it is made for many columns at a time.
void markEdges(const terrain::Tooth& tooth, int j, int i0, int i1, float rise,
               std::array<std::uint8_t, terrain::kMaxGridSide>& marks) noexcept
{
    const terrain::Grid& grid = tooth.grid();
    const float* own = tooth.top.data() + grid.index(0, j);
    const float* before = tooth.top.data() + grid.index(0, std::max(0, j - 1));
    const float* behind = tooth.top.data() + grid.index(0, std::min(grid.side - 1, j + 1));
    const float* uncut = tooth.anatomy->top.data() + grid.index(0, j);
    const auto markFrom = [&](int from, int end, int left, int right) {
        for (int i = from; i < end; ++i) {
            const float rows[] = {before[i - left], before[i],        before[i + right], own[i - left],
                                  own[i + right],   behind[i - left], behind[i],         behind[i + right]};
            float highest = rows[0];
            for (const float top : rows)
                highest = top > highest ? top : highest;
            marks[static_cast<std::size_t>(i)] =
                static_cast<std::uint8_t>((own[i] < uncut[i] ? 1 : 0) & (highest - own[i] > rise ? 1 : 0));
        }
    };
    const int last = grid.side - 1;
    if (i0 == 0)
        markFrom(0, 1, 0, 1);
    markFrom(std::max(1, i0), std::min(last, i1 + 1), 1, 1);
    if (i1 == last)
        markFrom(last, last + 1, 1, 0);
}

}  // namespace

terrain::PerMaterial breakOff(contact::LiveTooth& live, double slenderness, CutRect& changed) noexcept
{
    const terrain::Tooth& tooth = live.tooth();
    terrain::PerMaterial broken{};
    const CutRect cut = changed;
    const auto rise = static_cast<float>(slenderness * tooth.grid().cellMm);
    std::array<std::uint8_t, terrain::kMaxGridSide> marks;
    for (int j = cut.j0; j <= cut.j1; ++j) {
        markEdges(tooth, j, cut.i0, cut.i1, rise, marks);
        for (int i = cut.i0; i <= cut.i1; ++i) {
            if (marks[static_cast<std::size_t>(i)] == 0)
                continue;
            for (const Direction& towards : kDirections) {
                double base = 0.0;
                const int count = thinColumns(tooth, i, j, towards, slenderness, base);
                for (int step = 1; step <= count; ++step) {
                    const int atI = i + towards.di * step;
                    const int atJ = j + towards.dj * step;
                    lower(live, atI, atJ, base, broken);
                    changed = {std::min(changed.i0, atI), std::min(changed.j0, atJ), std::max(changed.i1, atI),
                               std::max(changed.j1, atJ)};
                }
                if (count > 0)  // breaking off may have created another edge
                    markEdges(tooth, j, i, cut.i1, rise, marks);
            }
        }
    }
    return broken;
}

}  // namespace core::cutting
