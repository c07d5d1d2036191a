// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/terrain/Tooth.h"

/// Properties of a tooth's columns for grading.
namespace core::grading {

[[nodiscard]] inline bool wasSolid(const terrain::ToothAnatomy& anatomy, std::size_t k)
{
    return anatomy.top[k] > anatomy.bottom[k];
}

/// Returns the current top of a column, or the under surface of the tooth if it was cut through.
[[nodiscard]] inline float endOf(const terrain::Tooth& tooth, std::size_t k)
{
    return tooth.isSolid(k) ? tooth.top[k] : tooth.anatomy->bottom[k];
}

[[nodiscard]] inline bool isCut(const terrain::Tooth& tooth, std::size_t k)
{
    return wasSolid(*tooth.anatomy, k) && endOf(tooth, k) < tooth.anatomy->top[k];
}

/// Returns the area of a column, seen from above, if a cut down to the height `end` opened its pulp; otherwise 0. mm2
[[nodiscard]] inline double pulpExposedMm2(const terrain::ToothAnatomy& anatomy, std::size_t k, float end)
{
    const bool isOpen = end < anatomy.top[k] && terrain::hasPulp(anatomy, k) && end <= anatomy.layers[k].pulpRoof;
    return isOpen ? static_cast<double>(anatomy.areaMm2[k]) : 0.0;
}

/// The decay left in a column; none if floor >= roof.
struct Decay
{
    float floor = 0.0F;
    float roof = 0.0F;
    [[nodiscard]] bool any() const { return roof > floor; }
};

[[nodiscard]] inline Decay decayIn(const terrain::Tooth& tooth, std::size_t k)
{
    if (!tooth.isSolid(k))
        return {};
    const terrain::ColumnLayers& column = tooth.anatomy->layers[k];
    return {std::max(column.cariesFloor, tooth.bottom[k]), std::min(column.cariesRoof, tooth.top[k])};
}

}  // namespace core::grading
