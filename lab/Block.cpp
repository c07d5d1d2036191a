// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/Block.h"

namespace lab {

using core::terrain::ColumnLayers;
using core::terrain::Material;

std::shared_ptr<const core::terrain::ToothAnatomy> layeredBlock(const std::function<double(glm::dvec2)>& heightMm,
                                                                const std::function<ColumnLayers(glm::dvec2)>& layers,
                                                                int side, glm::dvec2 shift)
{
    auto tooth = std::make_shared<core::terrain::ToothAnatomy>();
    tooth->name = "scene";
    tooth->grid.side = side;
    tooth->grid.cellMm = kBlockExtentMm / side;
    tooth->grid.originMm = glm::dvec2(-0.5 * tooth->grid.cellMm * (side - 1)) + shift * tooth->grid.cellMm;
    const std::size_t count = tooth->grid.count();
    tooth->top.resize(count);
    tooth->bottom.assign(count, kBlockBottomMm);
    tooth->areaMm2.assign(count, static_cast<float>(tooth->grid.cellMm * tooth->grid.cellMm));
    tooth->layers.resize(count);
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const std::size_t k = tooth->grid.index(i, j);
            tooth->top[k] = static_cast<float>(heightMm(tooth->grid.nodeMm(i, j)));
            tooth->layers[k] = layers(tooth->grid.nodeMm(i, j));
        }
    }
    return tooth;
}

std::shared_ptr<const core::terrain::ToothAnatomy> enamelBlock(const std::function<double(glm::dvec2)>& heightMm,
                                                               int side, glm::dvec2 shift)
{
    return layeredBlock(
        heightMm, [](glm::dvec2) { return allOf(Material::Enamel); }, side, shift);
}

ColumnLayers allOf(Material material)
{
    constexpr float kFarUp = 1.0e3F;
    ColumnLayers layers;
    layers.dej = material == Material::Enamel ? kBlockBottomMm : kFarUp;
    if (material == Material::Caries) {
        layers.cariesRoof = kFarUp;
        layers.cariesFloor = kBlockBottomMm;
    }
    if (material == Material::Pulp) {
        layers.pulpRoof = kFarUp;
        layers.pulpFloor = kBlockBottomMm;
    }
    return layers;
}

}  // namespace lab
