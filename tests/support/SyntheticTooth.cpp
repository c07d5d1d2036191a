// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/SyntheticTooth.h"

#include <cmath>

namespace support {

std::shared_ptr<const core::terrain::ToothAnatomy> makeBlock(const Block& block)
{
    using namespace core::terrain;
    auto tooth = std::make_shared<ToothAnatomy>();
    tooth->name = "block";
    tooth->grid.side = block.side;
    tooth->grid.cellMm = block.cellMm;
    tooth->grid.originMm = glm::dvec2(-0.5 * block.cellMm * (block.side - 1)) + block.shiftMm;
    const std::size_t count = tooth->grid.count();
    tooth->top.assign(count, kEmptyTop);
    tooth->bottom.assign(count, kEmptyBottom);
    tooth->areaMm2.assign(count, 0.0F);
    tooth->layers.assign(count, ColumnLayers{});
    for (int j = 0; j < block.side; ++j) {
        for (int i = 0; i < block.side; ++i) {
            const glm::dvec2 at = tooth->grid.nodeMm(i, j);
            const double top = block.topMm(at.x, at.y);
            if (!(top > block.bottomMm))
                continue;
            const std::size_t k = tooth->grid.index(i, j);
            tooth->top[k] = static_cast<float>(top);
            tooth->bottom[k] = static_cast<float>(block.bottomMm);
            tooth->areaMm2[k] = static_cast<float>(block.cellMm * block.cellMm);
            tooth->layers[k].dej = static_cast<float>(block.dejMm);
            tooth->layers[k].cariesRoof = 100.0F;
            tooth->layers[k].cariesFloor = static_cast<float>(block.cariesFloorMm);
        }
    }
    return tooth;
}

}  // namespace support
