// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "core/bur/BurMask.h"

/// A bur's head over the columns around it. One formula for all kernels, for contact and for cutting: what stops the
/// bur must be, bit for bit, what it cuts.
///
/// The functions are static, not only inline: this header is compiled for several processors, and the linker must never
/// use the copy for one as the copy for all.
namespace core::contact {

/// A head with its axis at (u, v), in lattice units.
struct BurHead
{
    const bur::BurMask& mask;
    float u;
    float v;
    float cell;  ///< mm
    float radius2;
    float flat;
    float corner;
    float corner2;
    float bend;
    float cone;
};

inline constexpr auto kLastStep = static_cast<float>(bur::BurMask::kTableSteps);

[[maybe_unused]] static inline BurHead headAt(const bur::BurMask& mask, double cellMm, double u, double v) noexcept
{
    const auto corner = static_cast<float>(mask.cornerMm);
    return {mask,
            static_cast<float>(u),
            static_cast<float>(v),
            static_cast<float>(cellMm),
            mask.radiusMm * mask.radiusMm,
            static_cast<float>(mask.flatMm),
            corner,
            corner * corner,
            std::min(corner, static_cast<float>(mask.bendMm)),
            static_cast<float>(mask.coneSlope)};
}

/// Returns the squared distance of any column of row j from the head's axis along +y, mm2.
[[maybe_unused]] static inline float dy2Of(int j, const BurHead& head) noexcept
{
    const float dy = (static_cast<float>(j) - head.v) * head.cell;
    return dy * dy;
}

/// Returns the squared distance of column i of that row from the axis, mm2.
[[maybe_unused]] static inline float r2Of(int i, float dy2, const BurHead& head) noexcept
{
    const float dx = (static_cast<float>(i) - head.u) * head.cell;
    return dx * dx + dy2;
}

/// Returns the height of the head's underside above its tip.
[[maybe_unused]] static inline float underAt(float r2, const BurHead& head) noexcept
{
    if (!(r2 <= head.radius2))
        return bur::BurMask::kAbsent;
    const float past = std::sqrt(r2) - head.flat;
    const float out = past > 0.0F ? past : 0.0F;
    const float round = out < head.bend ? out : head.bend;
    return head.corner - std::sqrt(head.corner2 - round * round) + head.cone * (out - round);
}

/// Returns the height of the head's upper side above its tip.
[[maybe_unused]] static inline float upperAt(float r2, const BurHead& head) noexcept
{
    if (!(r2 <= head.radius2))
        return -bur::BurMask::kAbsent;
    const float step = r2 * head.mask.r2ToStep;
    return head.mask.upperOfR2[static_cast<std::size_t>(step < kLastStep ? step : kLastStep)];
}

/// The limit that one column sets for the height of the tip: the lowest height that clears it from above (Above, with
/// the column's top), or the negative of the highest that clears it from below (Beneath, with its bottom). The larger,
/// the more restrictive.
enum class Side { Above, Beneath };

template <Side side>
[[maybe_unused]] static inline float valueOver(float height, int i, float dy2, const BurHead& head) noexcept
{
    const float r2 = r2Of(i, dy2, head);
    return side == Side::Above ? height - underAt(r2, head) : upperAt(r2, head) - height;
}

}  // namespace core::contact
