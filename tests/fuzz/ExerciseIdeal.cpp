// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/Exercises.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "core/base/Bytes.h"
#include "core/bur/Bur.h"
#include "core/grading/Deviation.h"
#include "core/guidance/Fixture.h"
#include "core/guidance/Margin.h"
#include "core/preparation/CapturedIdeal.h"
#include "core/preparation/ToleranceBand.h"
#include "core/recording/Format.h"

namespace fuzz {
namespace {

using namespace core;
using preparation::CapturedIdeal;

constexpr std::size_t kHeader = 28;
constexpr std::size_t kMagicAndVersion = 12;
constexpr int kLargestGrid = 100;  // a larger one takes too long for a fuzzer

std::string withPayload(std::string_view bytes, std::string_view payload)
{
    ByteWriter out;
    out.putAll(std::span(bytes.data(), kMagicAndVersion));
    out.put(static_cast<std::uint64_t>(payload.size()));
    out.put(fnv1a(payload));
    out.putAll(std::span(payload.data(), payload.size()));
    return out.bytes();
}

/// Returns a slab with an empty rim, on the grid of the ideal.
terrain::ToothAnatomy slabOf(const terrain::Grid& grid)
{
    terrain::ToothAnatomy anatomy;
    anatomy.grid = grid;
    anatomy.top.assign(grid.count(), terrain::kEmptyTop);
    anatomy.bottom.assign(grid.count(), terrain::kEmptyBottom);
    anatomy.areaMm2.assign(grid.count(), 0.0F);
    anatomy.layers.assign(grid.count(), terrain::ColumnLayers{0.0F, 0.0F, -1.0F, -4.0F, -5.0F});
    for (int j = 2; j < grid.side - 2; ++j)
        for (int i = 2; i < grid.side - 2; ++i) {
            const std::size_t k = grid.index(i, j);
            anatomy.top[k] = 0.0F;
            anatomy.bottom[k] = -8.0F;
            anatomy.areaMm2[k] = static_cast<float>(grid.cellMm * grid.cellMm);
        }
    return anatomy;
}

void markBy(CapturedIdeal ideal)
{
    const auto anatomy = std::make_shared<const terrain::ToothAnatomy>(slabOf(ideal.grid));
    ideal.surface = preparation::surfaceHash(*anatomy);
    const auto made = preparationOf(ideal, *anatomy);
    promise(made.has_value());
    std::vector<float> half = anatomy->top;
    for (std::size_t k = 0; k < half.size(); ++k)
        if (half[k] > anatomy->bottom[k])
            half[k] = std::clamp(0.5F * (*made->top)[k], anatomy->bottom[k], half[k]);
    const auto deviation = measureDeviation(terrain::restored(anatomy, half), *made, grading::Leeway{});
    promise(deviation.has_value() && std::isfinite(deviation->overcutMm3() + deviation->undercutMm3));
    promise(!deviation->outline || std::isfinite(deviation->outline->meanMm));
    for (const float height :
         preparation::toleranceBand(*anatomy, *made, ideal.tolerances.outlineMm, ideal.tolerances.depthMm).deepestMm)
        promise(!std::isnan(height));
    const guidance::Fixture fixture(*anatomy, *made->top);
    const glm::dvec2 middle = ideal.grid.nodeMm(ideal.grid.side / 2, ideal.grid.side / 2);
    for (const double z : {-20.0, -1.0, 0.4}) {
        const glm::dvec3 force = fixture.forceN({middle.x, middle.y, z}, 1);
        promise(std::abs(force.x) + std::abs(force.y) <= 2.0 * guidance::Fixture::kMostN);  // false for NaN
        const auto margin = guidance::marginMm(*anatomy, *made->top, bur::burs()[1], {middle.x, middle.y, z});
        promise(!margin || std::isfinite(*margin));
    }
}

void readIdeal(std::string_view bytes)
{
    const auto ideal = preparation::capturedFrom(bytes);
    if (!ideal) {
        promise(ideal.error().detail.ends_with('.'));
        return;
    }
    const std::string saved = preparation::toBytes(*ideal);
    const auto again = preparation::capturedFrom(saved);
    promise(again && preparation::toBytes(*again) == saved);
    if (ideal->grid.side <= kLargestGrid)
        markBy(*ideal);
}

}  // namespace

void exerciseIdeal(std::string_view bytes)
{
    readIdeal(bytes);
    if (bytes.size() < kHeader)
        return;
    readIdeal(withPayload(bytes, bytes.substr(kHeader)));
    readIdeal(withPayload(bytes, recording::pack(bytes.substr(kHeader))));
}

std::string unpackedIdeal(std::string_view bytes)
{
    const auto raw = bytes.size() < kHeader
                         ? std::nullopt
                         : recording::unpack(bytes.substr(kHeader), preparation::kLargestCapturedBytes);
    return raw ? withPayload(bytes, *raw) : std::string(bytes);
}

}  // namespace fuzz
