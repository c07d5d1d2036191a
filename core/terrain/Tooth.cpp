// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/terrain/Tooth.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace core::terrain {
namespace {

/// Returns the length of the overlap of [lowA, highA] and [lowB, highB], at least 0.
double overlap(float lowA, float highA, float lowB, float highB)
{
    const float low = std::max(lowA, lowB);
    const float high = std::min(highA, highB);
    return high > low ? static_cast<double>(high) - static_cast<double>(low) : 0.0;
}

std::size_t at(Material material)
{
    return static_cast<std::size_t>(material);
}

std::uint64_t mix(std::uint64_t hash, std::uint32_t word)
{
    for (int byte = 0; byte < 4; ++byte) {
        hash ^= (word >> (8 * byte)) & 0xFFU;
        hash *= 0x100000001B3ULL;
    }
    return hash;
}

}  // namespace

bool isAlmostSameTooth(const ToothAnatomy& a, const ToothAnatomy& b)
{
    constexpr float kRoundingMm = 0.001F;
    const auto isNear = [](float one, float other) { return one == other || std::abs(one - other) <= kRoundingMm; };
    const auto isNearLayer = [&](const ColumnLayers& one, const ColumnLayers& other) {
        return isNear(one.cariesRoof, other.cariesRoof) && isNear(one.cariesFloor, other.cariesFloor) &&
               isNear(one.dej, other.dej) && isNear(one.pulpRoof, other.pulpRoof) &&
               isNear(one.pulpFloor, other.pulpFloor);
    };
    return a.grid == b.grid && a.hasDecayZones == b.hasDecayZones &&
           std::equal(a.top.begin(), a.top.end(), b.top.begin(), b.top.end(), isNear) &&
           std::equal(a.bottom.begin(), a.bottom.end(), b.bottom.begin(), b.bottom.end(), isNear) &&
           std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), b.layers.end(), isNearLayer);
}

bool isSameTooth(const ToothAnatomy& a, const ToothAnatomy& b)
{
    return &a == &b || (a.grid == b.grid && a.top == b.top && a.bottom == b.bottom && a.layers == b.layers &&
                        a.hasDecayZones == b.hasDecayZones);
}

bool hasDecay(const ToothAnatomy& anatomy)
{
    return std::any_of(anatomy.layers.begin(), anatomy.layers.end(),
                       [](const ColumnLayers& column) { return column.cariesFloor < column.cariesRoof; });
}

Tooth restored(std::shared_ptr<const ToothAnatomy> anatomy, std::vector<float> top)
{
    assert(anatomy != nullptr && top.size() == anatomy->grid.count());
    Tooth tooth(std::move(anatomy));
    tooth.top = std::move(top);
    for (std::size_t k = 0; k < tooth.top.size(); ++k)
        if (tooth.top[k] <= kEmptyTop)
            tooth.bottom[k] = kEmptyBottom;
    return tooth;
}

std::vector<std::uint8_t> perforations(const Tooth& tooth)
{
    const Grid& grid = tooth.grid();
    const ToothAnatomy& anatomy = *tooth.anatomy;
    // An empty node connected with an initially empty node is outside. Any other empty node belongs to a hole.
    std::vector<std::uint8_t> outside(grid.count(), 0);
    std::vector<std::size_t> reached;
    bool anyGone = false;
    for (std::size_t k = 0; k < grid.count(); ++k) {
        if (anatomy.top[k] <= anatomy.bottom[k]) {
            outside[k] = 1;
            reached.push_back(k);
        } else {
            anyGone = anyGone || !tooth.isSolid(k);
        }
    }
    if (!anyGone)
        return {};
    const auto side = static_cast<std::size_t>(grid.side);
    while (!reached.empty()) {
        const std::size_t k = reached.back();
        reached.pop_back();
        const int i = static_cast<int>(k % side);
        const int j = static_cast<int>(k / side);
        for (int dj = -1; dj <= 1; ++dj)
            for (int di = -1; di <= 1; ++di) {
                if (!grid.contains(i + di, j + dj))
                    continue;
                const std::size_t next = grid.index(i + di, j + dj);
                if (outside[next] == 0 && !tooth.isSolid(next)) {
                    outside[next] = 1;
                    reached.push_back(next);
                }
            }
    }
    std::vector<std::uint8_t> holes(grid.count(), 0);
    bool any = false;
    for (std::size_t k = 0; k < grid.count(); ++k) {
        holes[k] = outside[k] == 0 && !tooth.isSolid(k) ? 1 : 0;
        any = any || holes[k] != 0;
    }
    return any ? holes : std::vector<std::uint8_t>{};
}

Material materialAt(const ColumnLayers& column, float z)
{
    if (z > column.cariesFloor && z <= column.cariesRoof)
        return Material::Caries;
    if (z > column.pulpFloor && z <= column.pulpRoof)
        return Material::Pulp;
    return z > column.dej ? Material::Enamel : Material::Dentin;
}

PerMaterial lengthsBetween(const ColumnLayers& column, float low, float high)
{
    PerMaterial length{};
    if (!(high > low))
        return length;
    if (Material material{}; isOneMaterial(column, low, high, material)) {
        length[at(material)] = static_cast<double>(high) - static_cast<double>(low);
        return length;
    }
    // The lesion first, then the parts of the column above and below it.
    const float lesionLow = std::clamp(column.cariesFloor, low, high);
    const float lesionHigh = std::clamp(column.cariesRoof, lesionLow, high);
    length[at(Material::Caries)] = static_cast<double>(lesionHigh) - static_cast<double>(lesionLow);
    const auto sound = [&](float from, float to) {
        const double pulp = overlap(from, to, column.pulpFloor, column.pulpRoof);
        const float junction = std::clamp(column.dej, from, to);
        const double pulpInEnamel = overlap(junction, to, column.pulpFloor, column.pulpRoof);
        length[at(Material::Pulp)] += pulp;
        length[at(Material::Enamel)] += static_cast<double>(to) - static_cast<double>(junction) - pulpInEnamel;
        length[at(Material::Dentin)] +=
            static_cast<double>(junction) - static_cast<double>(from) - (pulp - pulpInEnamel);
    };
    sound(low, lesionLow);
    sound(lesionHigh, high);
    return length;
}

MaterialSpans spansBetween(const ColumnLayers& column, float low, float high)
{
    MaterialSpans spans;
    if (!(high > low))
        return spans;
    std::array<float, 7> ends{};
    std::size_t count = 0;
    const auto cutAt = [&](float z) {
        if (z > low && z < high)
            ends.at(count++) = z;
    };
    if (column.cariesRoof > column.cariesFloor) {
        cutAt(column.cariesRoof);
        cutAt(column.cariesFloor);
    }
    if (column.pulpRoof > column.pulpFloor) {
        cutAt(column.pulpRoof);
        cutAt(column.pulpFloor);
    }
    cutAt(column.dej);
    ends.at(count++) = high;
    std::sort(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(count));
    float from = low;
    for (std::size_t k = 0; k < count; ++k) {
        const float to = ends.at(k);
        if (!(to > from))
            continue;
        // materialAt() assigns the upper end of an interval to that interval.
        const Material material = materialAt(column, to);
        if (spans.count > 0 && spans.span.at(static_cast<std::size_t>(spans.count - 1)).material == material)
            spans.span.at(static_cast<std::size_t>(spans.count - 1)).highMm = to;
        else
            spans.span.at(static_cast<std::size_t>(spans.count++)) = {material, from, to};
        from = to;
    }
    return spans;
}

bool hasPulp(const ToothAnatomy& anatomy, std::size_t k)
{
    const ColumnLayers& column = anatomy.layers[k];
    return anatomy.top[k] > anatomy.bottom[k] && column.pulpRoof > column.pulpFloor &&
           column.pulpRoof > anatomy.bottom[k] && column.pulpFloor < anatomy.top[k];
}

PerMaterial volumes(const Tooth& tooth)
{
    const ToothAnatomy& anatomy = *tooth.anatomy;
    PerMaterial sum{};
    for (std::size_t k = 0; k < tooth.top.size(); ++k) {
        if (!tooth.isSolid(k))
            continue;
        const PerMaterial length = lengthsBetween(anatomy.layers[k], tooth.bottom[k], tooth.top[k]);
        for (std::size_t m = 0; m < sum.size(); ++m)
            sum[m] += length[m] * static_cast<double>(anatomy.areaMm2[k]);
    }
    return sum;
}

void addRemoved(const ToothAnatomy& anatomy, std::size_t k, float top, PerMaterial& sum)
{
    if (!(top < anatomy.top[k]))
        return;
    const PerMaterial length = lengthsBetween(anatomy.layers[k], std::max(top, anatomy.bottom[k]), anatomy.top[k]);
    for (std::size_t m = 0; m < sum.size(); ++m)
        sum[m] += length[m] * static_cast<double>(anatomy.areaMm2[k]);
}

PerMaterial removedVolumes(const Tooth& tooth)
{
    PerMaterial sum{};
    for (std::size_t k = 0; k < tooth.top.size(); ++k)
        addRemoved(*tooth.anatomy, k, tooth.top[k], sum);
    return sum;
}

std::uint64_t stateHash(const Tooth& tooth)
{
    std::uint64_t hash = 0xCBF29CE484222325ULL;
    hash = mix(hash, static_cast<std::uint32_t>(tooth.grid().side));
    const auto cell = std::bit_cast<std::uint64_t>(tooth.grid().cellMm);
    hash = mix(mix(hash, static_cast<std::uint32_t>(cell)), static_cast<std::uint32_t>(cell >> 32U));
    for (const std::vector<float>* map : {&tooth.top, &tooth.bottom})
        for (const float height : *map)
            hash = mix(hash, std::bit_cast<std::uint32_t>(height));
    return hash;
}

}  // namespace core::terrain
