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
    eachNode(tooth->grid, [&](std::size_t k, const glm::dvec2& at) {
        const double top = block.topMm(at.x, at.y);
        if (!(top > block.bottomMm))
            return;
        tooth->top[k] = static_cast<float>(top);
        tooth->bottom[k] = static_cast<float>(block.bottomMm);
        tooth->areaMm2[k] = static_cast<float>(block.cellMm * block.cellMm);
        tooth->layers[k] = {100.0F, static_cast<float>(block.cariesFloorMm), static_cast<float>(block.dejMm), 0.0F,
                            0.0F};
    });
    return tooth;
}

core::terrain::Tooth blockTooth(const Block& block)
{
    return core::terrain::Tooth(makeBlock(block));
}

std::shared_ptr<const core::terrain::ToothAnatomy> smallBlock(double cellMm)
{
    return makeBlock({.side = 64, .cellMm = cellMm});
}

std::shared_ptr<const core::terrain::ToothAnatomy> wavyDisc(int side, double cellMm)
{
    return makeBlock(
        {.side = side,
         .cellMm = cellMm,
         .topMm = [](double x, double y) { return x * x + y * y < 16.0 ? 0.3 * std::sin(x) : std::nan(""); },
         .dejMm = -1.0});
}

std::size_t nodeAt(const core::terrain::Grid& grid, glm::dvec2 placeMm)
{
    const glm::dvec2 at = grid.latticeOf(placeMm);
    return grid.index(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y)));
}

std::vector<float> loweredTop(const core::terrain::ToothAnatomy& anatomy, const Surface& surface)
{
    std::vector<float> top = anatomy.top;
    eachNode(anatomy.grid, [&](std::size_t k, const glm::dvec2& at) {
        if (top[k] > anatomy.bottom[k])
            top[k] = std::min(top[k], static_cast<float>(surface(at)));
    });
    return top;
}

core::terrain::Tooth lowered(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, const Surface& surface)
{
    core::terrain::Tooth tooth(anatomy);
    tooth.top = loweredTop(*anatomy, surface);
    return tooth;
}

core::terrain::Tooth hollowed(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, double deepMm)
{
    return core::terrain::restored(anatomy, loweredTop(*anatomy, [deepMm](glm::dvec2 place) {
                                       const glm::dvec2 at = place - glm::dvec2(0.31, -0.17);
                                       const double r2 = 2.25 - at.x * at.x - at.y * at.y;
                                       return r2 > 0.0 ? -deepMm / 1.5 * std::sqrt(r2) : 100.0;
                                   }));
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
