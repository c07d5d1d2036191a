// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/terrain/Tooth.h"

/// Teeth to measure, and ways to cut them that need no bur.
namespace support {

/// A tooth of the generator as the program builds it, made once for each set of numbers and kept. Main thread.
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy> builtTooth(int fdi, int side = 150,
                                                                            std::uint64_t seed = 0);
/// The same without a lesion.
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy> soundTooth(int fdi, int side = 150,
                                                                            std::uint64_t seed = 0);

/// The slab of SyntheticTooth.h, enamel down to -2, with pulp from -7 to -5 in the nodes 20 .. 43 and decay from -3 to
/// -1 in the nodes `first` .. `last`, in both directions.
[[nodiscard]] std::shared_ptr<core::terrain::ToothAnatomy> decayedSlab(int first, int last);

/// Nodes, both ends included.
struct Nodes
{
    int lowI = 0;
    int highI = 0;
    int lowJ = 0;
    int highJ = 0;
};

/// The nodes up to `reach` away from one, in both directions, that a grid has.
[[nodiscard]] Nodes around(const core::terrain::Grid& grid, int i, int j, int reach);

template <class Use>
void eachOf(const core::terrain::Grid& grid, const Nodes& nodes, Use&& use)
{
    for (int j = nodes.lowJ; j <= nodes.highJ; ++j)
        for (int i = nodes.lowI; i <= nodes.highI; ++i)
            use(grid.index(i, j));
}

/// Puts the top of these columns at a height.
void cut(core::terrain::Tooth& tooth, const Nodes& nodes, float toMm);

/// Leaves nothing of column k.
void cutThrough(core::terrain::Tooth& tooth, std::size_t k);

/// Where node k of a grid stands.
[[nodiscard]] glm::dvec2 placeOf(const core::terrain::Grid& grid, std::size_t k);

}  // namespace support
