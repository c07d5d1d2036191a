// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace core::drilling {

/// Above the head there is only the shank; inside its radius the upper side of the bur never ends.
inline constexpr double kShankTopMm = 1.0e3;

/// What sticks out of the chuck of a friction-grip handpiece, from the tip, mm: no bur goes deeper, for then the head
/// of the handpiece lies on the tooth.
inline constexpr double kChuckMm = 8.0;

/// One axisymmetric bur. Heights are above its tip, radii from its axis, mm. US numbers and sizes: teeth.md section 6.
struct Bur
{
    std::string_view id;    ///< what the command line and recordings call it: "330"
    std::string_view name;  ///< "pear, No. 330"
    double headRadiusMm = 0.0;
    double headLengthMm = 0.0;
    double shankRadiusMm = 0.0;  ///< neck just above the head
    /// The end: a flat disc whose rim is rounded with this radius, up to headRadiusMm. A ball is all corner, a straight
    /// fissure bur has none.
    double cornerMm = 0.0;
    /// Half outline of the head from (0, 0) at the tip to the shank, as points (radius, height), heights never falling.
    struct Point
    {
        double radiusMm;
        double heightMm;
    };
    std::vector<Point> outline;

    [[nodiscard]] double flatRadiusMm() const { return headRadiusMm - cornerMm; }
    /// Height of the underside at radius r <= headRadiusMm: the lowest point of the head there.
    [[nodiscard]] double undersideMm(double radiusMm) const;
    /// Height of the upper side at radius r <= headRadiusMm; kShankTopMm where the shank continues it.
    [[nodiscard]] double upperSideMm(double radiusMm) const;
};

/// The burs that exist, in the order a chooser shows them: round 2, pear 330, long pear 245, straight fissure 57.
[[nodiscard]] std::span<const Bur> burs();

/// Index into burs() by id, or UnknownName naming those there are.
[[nodiscard]] Result<std::size_t> findBur(std::string_view id);

}  // namespace core::drilling
