// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Scenes.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/teeth/ToothBuilder.h"
#include "tests/support/SyntheticTooth.h"

namespace support {
namespace {

using core::terrain::ToothAnatomy;

std::shared_ptr<const ToothAnatomy> built(int fdi, int side, std::uint64_t seed, bool isSound)
{
    static std::map<std::tuple<int, int, std::uint64_t, bool>, std::shared_ptr<const ToothAnatomy>> kept;
    auto& anatomy = kept[{fdi, side, seed, isSound}];
    if (anatomy == nullptr) {
        core::teeth::BuildOptions options;
        options.gridSide = side;
        options.seed = seed;
        if (isSound)
            options.caries.reset();
        anatomy = core::teeth::buildTooth({fdi}, options).value().anatomy;
    }
    return anatomy;
}

}  // namespace

std::shared_ptr<const ToothAnatomy> builtTooth(int fdi, int side, std::uint64_t seed)
{
    return built(fdi, side, seed, false);
}

std::shared_ptr<const ToothAnatomy> soundTooth(int fdi, int side, std::uint64_t seed)
{
    return built(fdi, side, seed, true);
}

std::shared_ptr<ToothAnatomy> decayedSlab(int first, int last)
{
    auto anatomy = slab(-2.0F);
    eachOf(anatomy->grid, {20, 43, 20, 43}, [&](std::size_t k) {
        anatomy->layers[k].pulpRoof = -5.0F;
        anatomy->layers[k].pulpFloor = -7.0F;
    });
    eachOf(anatomy->grid, {first, last, first, last}, [&](std::size_t k) {
        anatomy->layers[k].cariesRoof = -1.0F;
        anatomy->layers[k].cariesFloor = -3.0F;
    });
    return anatomy;
}

Nodes around(const core::terrain::Grid& grid, int i, int j, int reach)
{
    return {std::max(0, i - reach), std::min(grid.side - 1, i + reach), std::max(0, j - reach),
            std::min(grid.side - 1, j + reach)};
}

void cut(core::terrain::Tooth& tooth, const Nodes& nodes, float toMm)
{
    eachOf(tooth.grid(), nodes, [&](std::size_t k) { tooth.top[k] = toMm; });
}

void cutThrough(core::terrain::Tooth& tooth, std::size_t k)
{
    tooth.top[k] = core::terrain::kEmptyTop;
    tooth.bottom[k] = core::terrain::kEmptyBottom;
}

}  // namespace support
