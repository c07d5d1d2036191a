// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/terrain/Tooth.h"

/// Resamples a tooth to half or twice the number of nodes per side: the same surfaces, coarser or finer. Coarser: every
/// second node represents its column. Finer: the nodes stay, and new ones between them have the mean of their
/// neighbours. A column's area is distributed to the columns that replace it; at the rim, where the coarser lattice has
/// none, it is lost. Any thread.
namespace core::terrain {

enum class Sampling { Half, Double };  ///< approximate change of the number of nodes per side

[[nodiscard]] Grid resampled(const Grid& grid, Sampling sampling);

[[nodiscard]] std::shared_ptr<const ToothAnatomy> resampled(const ToothAnatomy& anatomy, Sampling sampling);

/// Returns a tooth on the grid of another anatomy.
/// @param anatomy  the tooth's own anatomy, resampled
[[nodiscard]] Tooth resampled(const Tooth& tooth, std::shared_ptr<const ToothAnatomy> anatomy, Sampling sampling);

/// Resamples heights over an anatomy's columns, such as an ideal surface; kEmptyTop where there is none.
[[nodiscard]] std::vector<float> resampledTop(const ToothAnatomy& anatomy, std::span<const float> top,
                                              Sampling sampling);

/// Resamples labels of columns: a new column has the label of the one before it.
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
