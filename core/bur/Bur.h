// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace core::bur {

/// Height of the upper side within the radius of the shank, where it has no end.
inline constexpr double kShankTopMm = 1.0e3;

/// Length of a bur outside the chuck of a friction-grip handpiece, from the tip, mm. No bur cuts deeper: then the head
/// of the handpiece touches the tooth.
inline constexpr double kChuckMm = 8.0;

/// Returns whether an end whose flat disc has this radius counts as flat: a hundredth of a millimetre is a rounding
/// error of a ball.
[[nodiscard]] constexpr bool isFlatEnd(double flatRadiusMm)
{
    return flatRadiusMm > 0.02;
}

/// Number of burs, from the first of burs(), that the panel shows by default. Benchmarks measure these.
inline constexpr std::size_t kCommonBurs = 4;

/// Limit of the number of burs: commands, recordings and the servo's state store the index in one byte.
inline constexpr std::size_t kMostBurs = 256;

/// Shape of a bur, for display.
enum class BurShape {
    Round,
    InvertedCone,
    Straight,
    StraightCrosscut,
    DomedCrosscut,
    Tapered,
    TaperedCrosscut,
    Pear,
    LongPear,
    Egg,
    Flame,
    Cylinder,
    RoundEndTaper,
    Chamfer,
};
inline constexpr std::size_t kBurShapes = 14;

/// Returns the name of a shape in files, such as "inverted-cone".
[[nodiscard]] std::string_view shapeWord(BurShape shape);

/// One axisymmetric bur. Heights are above its tip, radii from its axis, mm. docs/burs.md has the sources of the sizes.
struct Bur
{
    std::string id;  ///< its US number, or a diamond's in ISO makers' catalogues: "330". For command line and lessons
    BurShape shape = BurShape::Round;
    int grit = 0;         ///< for a diamond: its number in ISO 6360, such as 524; 0: carbide
    std::string iso6360;  ///< "806 314 001 524 014"; empty if unknown
    double headRadiusMm = 0.0;
    double headLengthMm = 0.0;
    double shankRadiusMm = 0.0;  ///< neck just above the head
    /// The end: a flat disc whose rim is rounded with this radius, up to headRadiusMm or to the adjoining cone. A ball
    /// has no flat part.
    double cornerMm = 0.0;
    /// Half outline of the head from (0, 0) at the tip to the shank, as points (radius, height) with non-decreasing
    /// heights.
    struct Point
    {
        double radiusMm;
        double heightMm;
    };
    std::vector<Point> outline{};
    /// Slope of the cone that adjoins the rounded rim, tangent to it, up to headRadiusMm; mm per mm. 0: there is no
    /// cone, and the rim ends upright.
    double coneSlope = 0.0;
    double coneFlatMm = 0.0;  ///< radius of the flat disc of a bur with a cone

    [[nodiscard]] bool hasCone() const { return coneSlope > 0.0; }
    [[nodiscard]] bool isDiamond() const { return grit != 0; }
    /// Returns whether notches run across the blades.
    [[nodiscard]] bool isCrosscut() const;
    /// Returns the ISO size: the largest diameter in tenths of a millimetre, three digits.
    [[nodiscard]] std::string isoSize() const;
    /// Returns the radius of the flat disc.
    [[nodiscard]] double flatRadiusMm() const { return hasCone() ? coneFlatMm : headRadiusMm - cornerMm; }
    /// Returns true for a pear, a cylinder, a cone or a fissure bur, unless its end is a dome.
    [[nodiscard]] bool hasFlatEnd() const { return isFlatEnd(flatRadiusMm()); }
    /// Returns the width of the rounded rim beyond the flat disc, along the radius.
    [[nodiscard]] double bendMm() const;
    /// Returns the height of the underside at radius r <= headRadiusMm: the lowest point of the head there.
    [[nodiscard]] double undersideMm(double radiusMm) const;
    /// Returns the height of the upper side at radius r <= headRadiusMm; kShankTopMm where the shank continues it.
    [[nodiscard]] double upperSideMm(double radiusMm) const;
};

/// Returns all burs: those of core/bur/burs.txt, in its order, then the user's own. The order is part of the format of
/// recordings, which refer to a bur by its index: new burs are appended to the file, and none is moved or removed
/// (docs/dev/formats.md).
[[nodiscard]] std::span<const Bur> burs();

/// Returns the ids of burs(), in their order: "2, 330, 245".
[[nodiscard]] std::string burIds();

/// Returns the index into burs() of an id. UnknownName lists the known ids.
[[nodiscard]] Result<std::size_t> findBur(std::string_view id);

/// Returns whether an index is that of a bur added by addOwnBur().
[[nodiscard]] bool isOwnBur(std::size_t index);

/// Adds the user's own bur until the program ends, and returns its index. Call before the first tooth is built: a tooth
/// uses the burs known at that time. At most one can be added (Busy), with an id of its own (BadStructure).
[[nodiscard]] Result<std::size_t> addOwnBur(Bur bur);

}  // namespace core::bur
