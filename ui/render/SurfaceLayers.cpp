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
constexpr int kRimRings = 3;          ///< rings of nodes beyond the last solid node in which layers are defined

/// Computes the mean of a value over the marked nodes among a node and its eight neighbours. Returns false if none is
/// marked.
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

/// Smooths the outline of lesions, which would show the corners of the lattice's columns. Extends a lesion's heights a
/// little beyond it, and stores the share of decayed columns around each node as its extent.
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
            // Between open and closed columns the roof rises out of the tooth gradually. It then crosses the surface
            // along a line and not along the corners of the columns.
            const float closed = middle / found;
            const float isOpen = glm::smoothstep(0.25F, 0.75F, open / found);
            here.x = glm::mix(closed + 0.5F * depth, wholeTop[k] + kAboveOpenMm, isOpen);
            here.y = glm::mix(closed - 0.5F * depth, wholeTop[k] - depth, isOpen);
        }
    }
}

/// Copies layers from solid nodes to the rim and to the nodes beyond it that texture filtering mixes in.
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
                layers.upper[k].z = lowestDej;  // avoids a speck of dentin where enamel ends on the rim
                reached[k] = 1;
            }
        }
        known = std::move(reached);
    }
}

/// Makes the roof and the floor of the pulp meet in the nodes around it.
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
