// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/terrain/Resample.h"

#include <algorithm>
#include <array>
#include <utility>

namespace core::terrain {
namespace {

/// The old nodes at or around a new one.
struct Around
{
    std::array<std::size_t, 4> node{};
    std::size_t count = 0;
};

/// Returns the surrounding nodes that contain tooth.
Around around(const ToothAnatomy& anatomy, int i, int j, Sampling sampling)
{
    Around found;
    const auto take = [&](int atI, int atJ) {
        const std::size_t k = anatomy.grid.index(atI, atJ);
        if (anatomy.top[k] > anatomy.bottom[k])
            found.node.at(found.count++) = k;
    };
    if (sampling == Sampling::Half) {
        take(2 * i, 2 * j);
        return found;
    }
    for (int atJ = j / 2; atJ <= (j + 1) / 2; ++atJ)
        for (int atI = i / 2; atI <= (i + 1) / 2; ++atI)
            take(atI, atJ);
    return found;
}

float mean(const Around& of, const auto& value)
{
    float sum = 0.0F;
    for (std::size_t n = 0; n < of.count; ++n)
        sum += value(of.node.at(n));
    return sum / static_cast<float>(of.count);
}

/// Averages a layer with two interfaces. The thickness is the mean over all columns, with 0 for a column without the
/// layer. The height of its middle is the mean over the columns that have the layer.
void meanLens(const Around& of, const auto& roof, const auto& floor, float& meanRoof, float& meanFloor)
{
    float thick = 0.0F;
    float middle = 0.0F;
    int has = 0;
    for (std::size_t n = 0; n < of.count; ++n) {
        const std::size_t k = of.node.at(n);
        if (!(roof(k) > floor(k)))
            continue;
        thick += roof(k) - floor(k);
        middle += 0.5F * (roof(k) + floor(k));
        ++has;
    }
    if (has == 0)
        return;
    middle /= static_cast<float>(has);
    thick /= static_cast<float>(of.count);
    meanRoof = middle + 0.5F * thick;
    meanFloor = middle - 0.5F * thick;
}

/// Divides the area of each old column equally among the new columns within its cell that contain tooth.
void shareAreas(const ToothAnatomy& anatomy, Sampling sampling, ToothAnatomy& made)
{
    const Grid& grid = anatomy.grid;
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const float area = anatomy.areaMm2[grid.index(i, j)];
            if (!(area > 0.0F))
                continue;
            std::array<std::pair<std::size_t, float>, 9> to{};
            std::size_t count = 0;
            float sum = 0.0F;
            const auto take = [&](int atI, int atJ, float share) {
                if (!made.grid.contains(atI, atJ))
                    return;
                const std::size_t k = made.grid.index(atI, atJ);
                if (!(made.top[k] > made.bottom[k]))
                    return;
                to.at(count++) = {k, share};
                sum += share;
            };
            if (sampling == Sampling::Half) {
                for (int atJ = j / 2; atJ <= (j + 1) / 2; ++atJ)
                    for (int atI = i / 2; atI <= (i + 1) / 2; ++atI)
                        take(atI, atJ, 1.0F);
            } else {
                for (int dj = -1; dj <= 1; ++dj)
                    for (int di = -1; di <= 1; ++di)
                        take(2 * i + di, 2 * j + dj, (di == 0 ? 1.0F : 0.5F) * (dj == 0 ? 1.0F : 0.5F));
            }
            for (std::size_t n = 0; n < count; ++n)
                made.areaMm2[to.at(n).first] += area * to.at(n).second / sum;
        }
}

}  // namespace

Grid resampled(const Grid& grid, Sampling sampling)
{
    Grid made = grid;
    made.side = sampling == Sampling::Half ? (grid.side + 1) / 2 : 2 * grid.side - 1;
    made.cellMm = sampling == Sampling::Half ? 2.0 * grid.cellMm : 0.5 * grid.cellMm;
    return made;
}

std::shared_ptr<const ToothAnatomy> resampled(const ToothAnatomy& anatomy, Sampling sampling)
{
    auto made = std::make_shared<ToothAnatomy>();
    made->name = anatomy.name;
    made->fdi = anatomy.fdi;
    made->seed = anatomy.seed;
    made->lying = anatomy.lying;
    made->hasDecayZones = anatomy.hasDecayZones;
    made->grid = resampled(anatomy.grid, sampling);
    const std::size_t count = made->grid.count();
    made->top.assign(count, kEmptyTop);
    made->bottom.assign(count, kEmptyBottom);
    made->layers.resize(count);
    made->areaMm2.assign(count, 0.0F);
    for (int j = 0; j < made->grid.side; ++j)
        for (int i = 0; i < made->grid.side; ++i) {
            const Around here = around(anatomy, i, j, sampling);
            if (here.count == 0)
                continue;
            const std::size_t to = made->grid.index(i, j);
            made->top[to] = mean(here, [&](std::size_t k) { return anatomy.top[k]; });
            made->bottom[to] = mean(here, [&](std::size_t k) { return anatomy.bottom[k]; });
            ColumnLayers& column = made->layers[to];
            const auto& layers = anatomy.layers;
            // Outside the tooth, a layer has the value of the tooth's end.
            column.dej =
                mean(here, [&](std::size_t k) { return std::clamp(layers[k].dej, anatomy.bottom[k], anatomy.top[k]); });
            meanLens(
                here, [&](std::size_t k) { return layers[k].cariesRoof; },
                [&](std::size_t k) { return layers[k].cariesFloor; }, column.cariesRoof, column.cariesFloor);
            meanLens(
                here, [&](std::size_t k) { return layers[k].pulpRoof; },
                [&](std::size_t k) { return layers[k].pulpFloor; }, column.pulpRoof, column.pulpFloor);
        }
    shareAreas(anatomy, sampling, *made);
    return made;
}

std::vector<float> resampledTop(const ToothAnatomy& anatomy, std::span<const float> top, Sampling sampling)
{
    const Grid grid = resampled(anatomy.grid, sampling);
    std::vector<float> made(grid.count(), kEmptyTop);
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const Around here = around(anatomy, i, j, sampling);
            std::size_t through = 0;
            for (std::size_t n = 0; n < here.count; ++n)
                through += top[here.node.at(n)] > anatomy.bottom[here.node.at(n)] ? 0 : 1;
            if (here.count == 0 || (through > 0 && 2 * through >= here.count))
                continue;
            made[grid.index(i, j)] = mean(here, [&](std::size_t k) { return std::max(top[k], anatomy.bottom[k]); });
        }
    return made;
}

Tooth resampled(const Tooth& tooth, std::shared_ptr<const ToothAnatomy> anatomy, Sampling sampling)
{
    return restored(std::move(anatomy), resampledTop(*tooth.anatomy, tooth.top, sampling));
}

}  // namespace core::terrain
