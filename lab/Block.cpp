// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/Block.h"

namespace lab {

std::shared_ptr<const core::terrain::ToothAnatomy> enamelBlock(const std::function<double(glm::dvec2)>& heightMm,
                                                               int side, glm::dvec2 shift)
{
    constexpr float kBottomMm = -60.0F;
    auto tooth = std::make_shared<core::terrain::ToothAnatomy>();
    tooth->name = "scene";
    tooth->grid.side = side;
    tooth->grid.cellMm = kBlockExtentMm / side;
    tooth->grid.originMm = glm::dvec2(-0.5 * tooth->grid.cellMm * (side - 1)) + shift * tooth->grid.cellMm;
    const std::size_t count = tooth->grid.count();
    tooth->top.resize(count);
    tooth->bottom.assign(count, kBottomMm);
    tooth->areaMm2.assign(count, static_cast<float>(tooth->grid.cellMm * tooth->grid.cellMm));
    core::terrain::ColumnLayers enamel;
    enamel.dej = kBottomMm;
    tooth->layers.assign(count, enamel);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            tooth->top[tooth->grid.index(i, j)] = static_cast<float>(heightMm(tooth->grid.nodeMm(i, j)));
    return tooth;
}

}  // namespace lab
