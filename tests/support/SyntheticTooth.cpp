// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/SyntheticTooth.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

std::shared_ptr<const core::terrain::ToothAnatomy> smallBlock(double cellMm)
{
    Block block;
    block.side = 64;
    block.cellMm = cellMm;
    return makeBlock(block);
}

std::shared_ptr<const core::terrain::ToothAnatomy> wavyDisc(int side, double cellMm)
{
    Block block;
    block.side = side;
    block.cellMm = cellMm;
    block.dejMm = -1.0;
    block.topMm = [](double x, double y) { return x * x + y * y < 16.0 ? 0.3 * std::sin(x) : std::nan(""); };
    return makeBlock(block);
}

core::terrain::Tooth hollowed(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, double deepMm)
{
    std::vector<float> top = anatomy->top;
    for (int j = 0; j < anatomy->grid.side; ++j)
        for (int i = 0; i < anatomy->grid.side; ++i) {
            const std::size_t k = anatomy->grid.index(i, j);
            const glm::dvec2 at = anatomy->grid.nodeMm(i, j) - glm::dvec2(0.31, -0.17);
            const double r2 = 2.25 - at.x * at.x - at.y * at.y;
            if (r2 > 0.0 && top[k] > anatomy->bottom[k])
                top[k] = std::min(top[k], static_cast<float>(-deepMm / 1.5 * std::sqrt(r2)));
        }
    return core::terrain::restored(anatomy, std::move(top));
}

std::shared_ptr<core::terrain::ToothAnatomy> slab(float dejMm)
{
    auto anatomy = std::make_shared<core::terrain::ToothAnatomy>();
    anatomy->grid.side = 64;
    anatomy->grid.cellMm = 0.1;
    anatomy->grid.originMm = glm::dvec2(-3.15);
    anatomy->top.assign(anatomy->grid.count(), 0.0F);
    anatomy->bottom.assign(anatomy->grid.count(), -10.0F);
    anatomy->areaMm2.assign(anatomy->grid.count(), 0.01F);
    anatomy->layers.assign(anatomy->grid.count(), core::terrain::ColumnLayers{0.0F, 0.0F, dejMm, 0.0F, 0.0F});
    return anatomy;
}

}  // namespace support
