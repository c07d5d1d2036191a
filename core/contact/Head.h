// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drilling/BurMask.h"

/// A bur's head over the columns around it. One formula for every kernel, for contact and for cutting: what stops the
/// bur must be, to the bit, what it cuts.
///
/// The functions are static, not merely inline: this header is compiled for several processors, and the linker must
/// never take the copy for one as the copy for all.
namespace core::contact {

/// A head with its axis at (u, v), in lattice units.
struct Head
{
    const drilling::BurMask& mask;
    float u;
    float v;
    float cell;  ///< mm
};

/// The table step that says "not under the head".
inline constexpr auto kOutside = static_cast<float>(drilling::BurMask::kOutside);

[[maybe_unused]] static inline Head headAt(const drilling::BurMask& mask, double cellMm, double u, double v) noexcept
{
    return {mask, static_cast<float>(u), static_cast<float>(v), static_cast<float>(cellMm)};
}

/// Squared distance, mm2, of any column of row j from the head's axis along +y.
[[maybe_unused]] static inline float dy2Of(int j, const Head& head) noexcept
{
    const float dy = (static_cast<float>(j) - head.v) * head.cell;
    return dy * dy;
}

/// Where column i of that row is looked up in the head's tables.
[[maybe_unused]] static inline std::size_t stepOf(int i, float dy2, const Head& head) noexcept
{
    const float dx = (static_cast<float>(i) - head.u) * head.cell;
    const float step = (dx * dx + dy2) * head.mask.r2ToStep;
    return static_cast<std::size_t>(step < kOutside ? step : kOutside);
}

/// How high its tip the head must keep to clear one column from above (Above, with the column's top), and the negative
/// of how low to clear it from beneath (Beneath, with its bottom): the larger, the more in the way.
enum class Side { Above, Beneath };

template <Side side>
[[maybe_unused]] static inline float valueOver(float height, int i, float dy2, const Head& head) noexcept
{
    const std::size_t step = stepOf(i, dy2, head);
    return side == Side::Above ? height - head.mask.underOfR2[step] : head.mask.upperOfR2[step] - height;
}

}  // namespace core::contact
