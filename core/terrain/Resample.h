// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/terrain/Tooth.h"

/// A tooth on a lattice of half or of twice the distance between nodes: the same surfaces, seen more coarsely or more
/// finely. Coarser, every second node speaks for its column. Finer, the nodes stay and between them lies the mean of
/// their neighbours. A column's area is shared out to the columns that come to stand for it; at the rim, where the
/// coarser lattice has none, it is lost. Any thread.
namespace core::terrain {

enum class Sampling { Half, Double };  ///< nodes along a side, about

[[nodiscard]] Grid resampled(const Grid& grid, Sampling sampling);

[[nodiscard]] std::shared_ptr<const ToothAnatomy> resampled(const ToothAnatomy& anatomy, Sampling sampling);

/// @param anatomy  the tooth's own anatomy, resampled
[[nodiscard]] Tooth resampled(const Tooth& tooth, std::shared_ptr<const ToothAnatomy> anatomy, Sampling sampling);

/// Heights over an anatomy's columns, kEmptyTop where there is nothing: an ideal surface.
[[nodiscard]] std::vector<float> resampledTop(const ToothAnatomy& anatomy, std::span<const float> top,
                                              Sampling sampling);

/// What is said of whole columns: between two, the one before speaks.
template <class T>
[[nodiscard]] std::vector<T> resampledLabels(const Grid& grid, const std::vector<T>& labels, Sampling sampling)
{
    const Grid to = resampled(grid, sampling);
    std::vector<T> made(to.count());
    for (int j = 0; j < to.side; ++j)
        for (int i = 0; i < to.side; ++i)
            made[to.index(i, j)] =
                labels[sampling == Sampling::Half ? grid.index(2 * i, 2 * j) : grid.index(i / 2, j / 2)];
    return made;
}

}  // namespace core::terrain
