// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/terrain/Tooth.h"

/// Teeth for tests of measures, and functions that cut them without a bur.
namespace support {

/// Returns a generated tooth as the program builds it. It is built once for each set of arguments. Main thread.
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy> builtTooth(int fdi, int side = 150,
                                                                            std::uint64_t seed = 0);
/// Returns a generated tooth without a lesion, likewise.
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy> soundTooth(int fdi, int side = 150,
                                                                            std::uint64_t seed = 0);

/// Returns the slab of SyntheticTooth.h with enamel down to -2, pulp from -7 to -5 in the nodes 20 .. 43 and decay from
/// -3 to -1 in the nodes `first` .. `last`, in both directions.
[[nodiscard]] std::shared_ptr<core::terrain::ToothAnatomy> decayedSlab(int first, int last);

/// A rectangle of nodes. Both ends are included.
struct Nodes
{
    int lowI = 0;
    int highI = 0;
    int lowJ = 0;
    int highJ = 0;
};

/// Returns the nodes of the grid that are up to `reach` nodes away in each direction.
[[nodiscard]] Nodes around(const core::terrain::Grid& grid, int i, int j, int reach);

template <class Use>
void eachOf(const core::terrain::Grid& grid, const Nodes& nodes, Use&& use)
{
    for (int j = nodes.lowJ; j <= nodes.highJ; ++j)
        for (int i = nodes.lowI; i <= nodes.highI; ++i)
            use(grid.index(i, j));
}

/// Sets the top of these columns to a height.
void cut(core::terrain::Tooth& tooth, const Nodes& nodes, float toMm);

/// Removes the whole column k.
void cutThrough(core::terrain::Tooth& tooth, std::size_t k);

}  // namespace support
