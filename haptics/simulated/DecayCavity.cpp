// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/simulated/DecayCavity.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/bur/Reach.h"
#include "core/grading/IdealCavity.h"
#include "haptics/simulated/BurFootprint.h"

namespace haptics {
namespace {

using core::terrain::ColumnLayers;

constexpr float kPulpMarginMm = 0.3F;    ///< dentin that is left over the pulp
constexpr float kThroughMm = 0.5F;       ///< tooth that is left below a cut
constexpr float kDeeperMm = 0.05F;       ///< the tip may go so far below the decay that it clears, if that is enough
constexpr float kDecayMarginMm = 0.02F;  ///< depth below the decay, so that no trace remains

/// Returns the lowest permitted height of the cavity in each column. All the decay of the column is above it.
std::vector<float> limits(const core::terrain::ToothAnatomy& anatomy)
{
    std::vector<float> limit(anatomy.grid.count());
    for (std::size_t k = 0; k < limit.size(); ++k) {
        const ColumnLayers& layers = anatomy.layers[k];
        limit[k] = anatomy.bottom[k] + kThroughMm;
        if (core::terrain::hasPulp(anatomy, k))
            limit[k] = std::max(limit[k], layers.pulpRoof + kPulpMarginMm);
        if (const float down = core::grading::decayGoesDownTo(anatomy, k); layers.cariesRoof > down)
            limit[k] = std::min(limit[k], down - kDecayMarginMm);
    }
    return limit;
}

/// Returns the columns with decay to be removed, deepest first.
std::vector<std::size_t> deepestFirst(const core::terrain::ToothAnatomy& anatomy)
{
    std::vector<std::size_t> decayed;
    for (std::size_t k = 0; k < anatomy.grid.count(); ++k)
        if (const float down = core::grading::decayGoesDownTo(anatomy, k);
            anatomy.layers[k].cariesRoof > down && anatomy.top[k] > down)
            decayed.push_back(k);
    std::stable_sort(decayed.begin(), decayed.end(), [&](std::size_t a, std::size_t b) {
        return core::grading::decayGoesDownTo(anatomy, a) < core::grading::decayGoesDownTo(anatomy, b);
    });
    return decayed;
}

}  // namespace

std::vector<float> decayCavity(const core::terrain::ToothAnatomy& anatomy, const core::bur::Bur& bur)
{
    const core::terrain::Grid& grid = anatomy.grid;
    const std::vector<FootprintPart> head = footprint(bur, grid);
    const std::vector<float> limit = limits(anatomy);
    const auto lowestTip = static_cast<float>(core::bur::lowestTipMm(anatomy));
    std::vector<float> top = anatomy.top;
    // Returns the amount of sound tooth that is cut if the tip is at this position; empty if the cut is forbidden.
    const auto costOf = [&](int i, int j, float tipMm) -> std::optional<float> {
        float cost = 0.0F;
        for (const FootprintPart& part : head) {
            if (!grid.contains(i + part.i, j + part.j))
                continue;
            const std::size_t k = grid.index(i + part.i, j + part.j);
            const float cutMm = tipMm + part.heightMm;
            if (anatomy.top[k] <= anatomy.bottom[k] || cutMm >= top[k])
                continue;
            if (cutMm < limit[k])
                return std::nullopt;
            cost += top[k] - cutMm;
        }
        return cost;
    };
    for (const std::size_t decayed : deepestFirst(anatomy)) {
        const float floorMm = core::grading::decayGoesDownTo(anatomy, decayed) - kDecayMarginMm;
        if (top[decayed] <= floorMm)
            continue;
        const int i = static_cast<int>(decayed) % grid.side;
        const int j = static_cast<int>(decayed) / grid.side;
        const FootprintPart* best = nullptr;
        float least = std::numeric_limits<float>::max();
        // The tooth below the decay is sound, so the flat part of the head is used where possible.
        for (const float mostMm : {kDeeperMm, std::numeric_limits<float>::max()}) {
            for (const FootprintPart& part : head) {
                const float tipMm = floorMm - part.heightMm;
                if (part.heightMm > mostMm || !grid.contains(i - part.i, j - part.j) || tipMm < lowestTip)
                    continue;
                const auto cost = costOf(i - part.i, j - part.j, tipMm);
                if (cost && *cost < least) {
                    least = *cost;
                    best = &part;
                }
            }
            if (best != nullptr)
                break;
        }
        if (best == nullptr)
            continue;
        for (const FootprintPart& part : head)
            if (grid.contains(i - best->i + part.i, j - best->j + part.j)) {
                float& column = top[grid.index(i - best->i + part.i, j - best->j + part.j)];
                column = std::min(column, floorMm - best->heightMm + part.heightMm);
            }
    }
    return top;
}

}  // namespace haptics
