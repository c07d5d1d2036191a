// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/SurfaceLayers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/common.hpp>

namespace ui::render {
namespace {

constexpr int kDecayReach = 3;        ///< nodes over which the outline of a lesion is smoothed
constexpr float kAboveOpenMm = 0.3F;  ///< where the roof of an open lesion is drawn: clear of the surface
constexpr int kRimRings = 3;          ///< beyond the last solid node, in which layers are known

/// Mean of a value over the nodes among the eight around one (and itself) that are marked. False when none is.
template <class Value>
bool meanAround(const core::terrain::Grid& lattice, int i, int j, const std::vector<std::uint8_t>& marked,
                const Value& value, glm::vec4& mean)
{
    glm::vec4 sum{0.0F};
    float found = 0.0F;
    for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
            if (!lattice.contains(i + di, j + dj) || marked[lattice.index(i + di, j + dj)] == 0)
                continue;
            sum += value(lattice.index(i + di, j + dj));
            found += 1.0F;
        }
    }
    if (found > 0.0F)
        mean = sum / found;
    return found > 0.0F;
}

/// A lesion is whole columns of the lattice; its outline would be their corners. So its heights are carried a little
/// beyond it, and how far it reaches is told by the share of decayed columns around each node.
void softenDecay(const core::terrain::Grid& lattice, const std::vector<float>& wholeTop,
                 const std::vector<std::uint8_t>& caries, SurfaceLayers& layers)
{
    const std::vector<glm::vec4> own = layers.upper;
    std::array<float, kDecayReach + 1> fade;
    for (std::size_t d = 0; d < fade.size(); ++d)
        fade[d] = std::exp(-0.35F * static_cast<float>(d * d));
    const auto weightOf = [&](int di, int dj) {
        return fade[static_cast<std::size_t>(std::abs(di))] * fade[static_cast<std::size_t>(std::abs(dj))];
    };
    for (int j = 0; j < lattice.side; ++j) {
        for (int i = 0; i < lattice.side; ++i) {
            const std::size_t k = lattice.index(i, j);
            float depth = 0.0F;
            float weights = 0.0F;
            float open = 0.0F;
            float middle = 0.0F;
            float found = 0.0F;
            for (int dj = -kDecayReach; dj <= kDecayReach; ++dj) {
                for (int di = -kDecayReach; di <= kDecayReach; ++di) {
                    if (!lattice.contains(i + di, j + dj))
                        continue;
                    const std::size_t n = lattice.index(i + di, j + dj);
                    const float weight = weightOf(di, dj);
                    weights += weight;
                    if (caries[n] == 0)
                        continue;
                    const float roof = std::min(own[n].x, wholeTop[n]);
                    depth += weight * (roof - own[n].y);
                    middle += weight * 0.5F * (roof + own[n].y);
                    open += own[n].x >= wholeTop[n] ? weight : 0.0F;
                    found += weight;
                }
            }
            glm::vec4& here = layers.upper[k];
            if (found == 0.0F) {
                here.x = here.y = 0.0F;
                continue;
            }
            depth /= found;
            layers.lower[k].y = found / weights;
            layers.lower[k].w = open / weights;
            // Between columns that are open and such that are not, the roof rises out of the tooth bit by bit: its way
            // through the surface is then a line and not their corners.
            const float closed = middle / found;
            const float isOpen = glm::smoothstep(0.25F, 0.75F, open / found);
            here.x = glm::mix(closed + 0.5F * depth, wholeTop[k] + kAboveOpenMm, isOpen);
            here.y = glm::mix(closed - 0.5F * depth, wholeTop[k] - depth, isOpen);
        }
    }
}

/// Gives the rim, and what a texture mixes in beyond it, the layers of the solid nodes beside them, like their heights.
void spreadBeyondRim(const core::terrain::Grid& lattice, std::vector<std::uint8_t> known, SurfaceLayers& layers)
{
    const int side = lattice.side;
    for (int ring = 0; ring < kRimRings; ++ring) {
        const std::vector<glm::vec4> own = layers.upper;
        std::vector<std::uint8_t> reached = known;
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                const std::size_t k = lattice.index(i, j);
                if (known[k] != 0)
                    continue;
                float lowestDej = 1.0e9F;
                const auto layersOf = [&](std::size_t n) {
                    lowestDej = std::min(lowestDej, own[n].z);
                    return own[n];
                };
                if (!meanAround(lattice, i, j, known, layersOf, layers.upper[k]))
                    continue;
                layers.upper[k].z = lowestDej;  // no speck of dentin where enamel ends on the rim
                reached[k] = 1;
            }
        }
        known = std::move(reached);
    }
}

/// Closes the pulp around the nodes that have one.
void closePulp(const core::terrain::Grid& lattice, const std::vector<std::uint8_t>& pulp, SurfaceLayers& layers)
{
    const int side = lattice.side;
    const std::vector<glm::vec4> own = layers.upper;
    const std::vector<glm::vec4> ownLower = layers.lower;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const std::size_t k = lattice.index(i, j);
            if (pulp[k] != 0)
                continue;
            glm::vec4 middle{0.0F};
            const auto middleOf = [&](std::size_t n) { return glm::vec4(0.5F * (own[n].w + ownLower[n].x)); };
            meanAround(lattice, i, j, pulp, middleOf, middle);
            layers.upper[k].w = layers.lower[k].x = middle.x;
        }
    }
}

}  // namespace

SurfaceLayers makeLayers(const core::terrain::ToothAnatomy& anatomy, const core::terrain::Grid& lattice, int stride,
                         const std::vector<float>& wholeTop, const std::vector<float>& wholeBottom,
                         const std::vector<float>& dej)
{
    const int side = lattice.side;
    SurfaceLayers layers;
    const std::size_t count = lattice.count();
    layers.upper.assign(count, glm::vec4(0.0F));
    layers.lower.assign(count, glm::vec4(0.0F));
    std::vector<std::uint8_t> known(count, 0);
    std::vector<std::uint8_t> caries(count, 0);
    std::vector<std::uint8_t> pulp(count, 0);
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const std::size_t k = lattice.index(i, j);
            if (wholeTop[k] <= wholeBottom[k])
                continue;
            const core::terrain::ColumnLayers& column = anatomy.layers[anatomy.grid.index(i * stride, j * stride)];
            layers.upper[k] = {column.cariesRoof, column.cariesFloor, dej[k], column.pulpRoof};
            layers.lower[k].x = column.pulpFloor;
            known[k] = 1;
            caries[k] = column.cariesRoof > column.cariesFloor ? 1 : 0;
            pulp[k] = column.pulpRoof > column.pulpFloor ? 1 : 0;
        }
    }
    softenDecay(lattice, wholeTop, caries, layers);
    spreadBeyondRim(lattice, std::move(known), layers);
    closePulp(lattice, pulp, layers);
    return layers;
}

}  // namespace ui::render
