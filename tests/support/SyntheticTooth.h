// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "core/terrain/Tooth.h"

namespace support {

/// A block of one material, or of layers, under any surface: the scenes of the contact and cutting tests.
struct Block
{
    int side = 150;
    double cellMm = 0.07;
    double bottomMm = -6.0;
    glm::dvec2 shiftMm{0.0, 0.0};  ///< moves the lattice under the scene
    std::function<double(double x, double y)> topMm = [](double, double) { return 0.0; };  ///< NaN: no material
    /// Enamel above this height, dentin below; the default is enamel all through.
    double dejMm = -100.0;
    double cariesFloorMm = 100.0;  ///< caries above this height; the default is none
};

/// Returns a block centred on the origin of the tooth frame.
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy> makeBlock(const Block& block);

/// Returns the block as an uncut tooth.
[[nodiscard]] core::terrain::Tooth blockTooth(const Block& block);

/// Returns a block of enamel, 64 cells a side: quick to work on.
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy> smallBlock(double cellMm = 0.12);

/// Calls `use` with the index and the position of each node of a grid.
template <class Use>
void eachNode(const core::terrain::Grid& grid, Use&& use)
{
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i)
            use(grid.index(i, j), grid.nodeMm(i, j));
}

/// Returns the node that is nearest to a point.
[[nodiscard]] std::size_t nodeAt(const core::terrain::Grid& grid, glm::dvec2 placeMm);

/// Height of a cut surface, mm. Where it is above the tooth, the tooth is uncut.
using Surface = std::function<double(glm::dvec2)>;

/// Returns the tooth with all material above a surface removed; loweredTop() returns only its top map.
[[nodiscard]] core::terrain::Tooth lowered(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy,
                                           const Surface& surface);
[[nodiscard]] std::vector<float> loweredTop(const core::terrain::ToothAnatomy& anatomy, const Surface& surface);

/// Returns a disc of 4 mm radius whose top waves along x by 0.3 mm, with enamel above -1. No lattice meets its rim
/// evenly.
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy> wavyDisc(int side, double cellMm);

/// Returns the disc with a hollow, half an ellipsoid 1.5 mm in radius and of this depth, off every node and axis.
[[nodiscard]] core::terrain::Tooth hollowed(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy,
                                            double deepMm);

/// Returns 64 x 64 cells of 0.1 mm around the origin, top 0, bottom -10, enamel above a height and dentin below. Tests
/// add pulp and decay.
[[nodiscard]] std::shared_ptr<core::terrain::ToothAnatomy> slab(float dejMm);

}  // namespace support
