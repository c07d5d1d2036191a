// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drilling/BreakOff.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace core::drilling {
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

/// How many columns from (i, j) on, which is cut, belong to something too thin to stand; 0 if it stands.
/// @param base  height of the ground that it stands on
int thinColumns(const terrain::Tooth& tooth, int i, int j, const Direction& towards, double slenderness, double& base)
{
    const terrain::Grid& grid = tooth.grid();
    const double mmHigh = slenderness * grid.cellMm * towards.cells;  // for each column of width
    // Of a perforated column nothing is left: what is beside it stands no higher than from its own bottom.
    auto ground = static_cast<double>(tooth.top[grid.index(i, j)]);
    double lowest = 1.0e9;  // of what stands
    for (int count = 0;; ++count) {
        const int nextI = i + towards.di * (count + 1);
        const int nextJ = j + towards.dj * (count + 1);
        const bool isThere = grid.contains(nextI, nextJ) && tooth.isSolid(grid.index(nextI, nextJ));
        const auto next = static_cast<double>(isThere ? tooth.top[grid.index(nextI, nextJ)] : terrain::kEmptyTop);
        if (count > 0 && lowest - std::max(ground, next) > mmHigh * count) {
            base = std::max(ground, next);
            return count;
        }
        // One more makes it wider: is that still high enough, if nothing stands behind it?
        lowest = std::min(lowest, next);
        if (isThere)
            ground = std::max(ground, static_cast<double>(tooth.bottom[grid.index(nextI, nextJ)]));
        if (!(lowest - ground > mmHigh * (count + 1)))
            return 0;
    }
}

/// Lowers column (i, j) to `base` and adds what that takes away.
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

}  // namespace

terrain::PerMaterial breakOff(contact::LiveTooth& live, double slenderness, CutRect& changed) noexcept
{
    const terrain::Tooth& tooth = live.tooth();
    terrain::PerMaterial broken{};
    const CutRect cut = changed;
    for (int j = cut.j0; j <= cut.j1; ++j) {
        for (int i = cut.i0; i <= cut.i1; ++i) {
            const std::size_t k = tooth.grid().index(i, j);
            if (!(tooth.top[k] < tooth.anatomy->top[k]))
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
            }
        }
    }
    return broken;
}

}  // namespace core::drilling
