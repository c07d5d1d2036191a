// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace core::bur {

/// Above the head there is only the shank; inside its radius the upper side of the bur never ends.
inline constexpr double kShankTopMm = 1.0e3;

/// What sticks out of the chuck of a friction-grip handpiece, from the tip, mm: no bur goes deeper, for then the head
/// of the handpiece lies on the tooth.
inline constexpr double kChuckMm = 8.0;

/// Whether an end whose flat disc has this radius counts as flat: a hundredth of a millimetre is rounding of a ball.
[[nodiscard]] constexpr bool isFlatEnd(double flatRadiusMm)
{
    return flatRadiusMm > 0.02;
}

/// Number of burs, from the first of burs(), that the panel shows by default. Benchmarks measure these.
inline constexpr std::size_t kCommonBurs = 4;

/// Commands, recordings and the servo's state name a bur by its index in one byte.
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

/// What a file calls it: "inverted-cone".
[[nodiscard]] std::string_view shapeWord(BurShape shape);

/// One axisymmetric bur. Heights are above its tip, radii from its axis, mm. Where the sizes are from: docs/burs.md.
struct Bur
{
    std::string id;  ///< its US number, or a diamond's in ISO makers' catalogues: "330". Command line, lessons
    BurShape shape = BurShape::Round;
    int grit = 0;         ///< of a diamond: its number in ISO 6360, such as 524; 0: carbide
    std::string iso6360;  ///< "806 314 001 524 014"; empty where it is not known
    double headRadiusMm = 0.0;
    double headLengthMm = 0.0;
    double shankRadiusMm = 0.0;  ///< neck just above the head
    /// The end: a flat disc whose rim is rounded with this radius, up to headRadiusMm or to the cone that goes on from
    /// there. A ball is all corner.
    double cornerMm = 0.0;
    /// Half outline of the head from (0, 0) at the tip to the shank, as points (radius, height), heights never falling.
    struct Point
    {
        double radiusMm;
        double heightMm;
    };
    std::vector<Point> outline{};
    /// Rise of the cone that goes on from the rounded rim, tangent to it, up to headRadiusMm; mm a mm. 0: the rim goes
    /// round to upright, and there is no cone.
    double coneSlope = 0.0;
    double coneFlatMm = 0.0;  ///< radius of the flat disc of a bur with a cone

    [[nodiscard]] bool hasCone() const { return coneSlope > 0.0; }
    [[nodiscard]] bool isDiamond() const { return grit != 0; }
    /// True if notches run across the blades.
    [[nodiscard]] bool isCrosscut() const;
    /// ISO size: the largest diameter in tenths of a millimetre, three digits.
    [[nodiscard]] std::string isoSize() const;
    /// Radius of the flat disc.
    [[nodiscard]] double flatRadiusMm() const { return hasCone() ? coneFlatMm : headRadiusMm - cornerMm; }
    /// True for a pear, a cylinder, a cone or a fissure bur, unless its end is a dome.
    [[nodiscard]] bool hasFlatEnd() const { return isFlatEnd(flatRadiusMm()); }
    /// How far beyond the flat disc the rounded rim goes, along the radius.
    [[nodiscard]] double bendMm() const;
    /// Height of the underside at radius r <= headRadiusMm: the lowest point of the head there.
    [[nodiscard]] double undersideMm(double radiusMm) const;
    /// Height of the upper side at radius r <= headRadiusMm; kShankTopMm where the shank continues it.
    [[nodiscard]] double upperSideMm(double radiusMm) const;
};

/// The burs that exist: those of core/bur/burs.txt, in its order, and the user's own behind them. The order is
/// part of the format of recordings, which name a bur by its index: new burs are appended to the file, and none is
/// moved or removed (docs/dev/formats.md).
[[nodiscard]] std::span<const Bur> burs();

/// "2, 330, 245": the ids of burs(), in their order.
[[nodiscard]] std::string burIds();

/// Index into burs() by id, or UnknownName naming those there are.
[[nodiscard]] Result<std::size_t> findBur(std::string_view id);

/// True for the index of a bur that addOwnBur() added.
[[nodiscard]] bool isOwnBur(std::size_t index);

/// Adds the user's own bur for as long as the program runs; its index. Call it before the first tooth is made: a tooth
/// knows the burs there were. At most one can be added (Busy), and with an id of its own (BadStructure).
[[nodiscard]] Result<std::size_t> addOwnBur(Bur bur);

}  // namespace core::bur
