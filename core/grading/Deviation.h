// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/base/Result.h"
#include "core/grading/Preparation.h"
#include "core/terrain/Tooth.h"

/// How far a cut tooth is from the preparation that was asked for. Sums, minima and maxima over columns in index order,
/// with nothing from a mathematical library but the square root: the same bits on every machine. What a height map
/// cannot hold is not measured: undercuts, and walls that converge towards the occlusal, which read as upright.
///
/// A column stands for its cell, and is cut or not: where an upright wall stands is known to half a cell. Askew to the
/// lattice that evens out; along it, it is so much of volumes, widths and outlines.
namespace core::grading {

/// A figure and the node of the grid where it is to be seen best.
struct Placed
{
    double value = 0.0;
    std::size_t node = 0;
    bool operator==(const Placed&) const = default;
};

/// The outline of a cut is where the tooth has been lowered by so much, mm: what is shallower is a scratch. At a wall
/// that leans out by 10 degrees that is 0.02 mm inside its upper edge.
inline constexpr double kOutlineDepthMm = 0.1;

/// Columns of the floor nearer than this, along x or y, to one that is no Floor do not speak for the floor: a wall that
/// stands a cell aside is the outline's fault and not the depth's. Where nothing else is left, they do.
inline constexpr double kFloorMarginMm = 0.2;

/// Height above the ideal floor at which the axial wall of a box is measured, mm: above the round between floor and
/// wall.
inline constexpr double kAxialWallMm = 0.3;

/// Two places of the floor so far apart along x or y make a step.
inline constexpr double kStepRunMm = 0.2;

/// A place that is too deep counts from this area on, mm2: about that of a small bur's end.
inline constexpr double kLocalMm2 = 0.5;

/// So deep and so large, a cut elsewhere is more than a scratch that is polished away: mm and mm2.
inline constexpr double kStrayDepthMm = 0.2;
inline constexpr double kStrayMm2 = 0.1;

/// The slope of a floor is that between places so far apart.
inline constexpr double kSlopeRunMm = 0.3;

/// One of several separate pieces of a floor, such as a pit of a row of pits.
struct PieceError
{
    double meanMm = 0.0;   ///< of the error in height, as below: negative is too deep
    double depthMm = 0.0;  ///< mean depth of the ideal there, below the uncut surface
    std::size_t node = 0;  ///< a node in it
    bool operator==(const PieceError&) const = default;
};

/// Depth of the floor against the ideal (docs/teeth.md, "Ideal preparations": depth of the floor).
/// The error of a column is its height less the ideal one: negative is too deep.
struct DepthError
{
    double meanMm = 0.0;        ///< of the error's size
    double signedMm = 0.0;      ///< of the error itself
    double p95Mm = 0.0;         ///< 95 % of the floor's area are off by no more than this
    Placed tooDeepMm;           ///< most that the floor lies too low, 0 or more
    Placed tooShallowMm;        ///< most that it lies too high, 0 or more
    double deepP95Mm = 0.0;     ///< 95 % of the floor's area lie no lower than so much below the ideal
    double shallowP95Mm = 0.0;  ///< and no higher than so much above it
    Placed gougeMm;             ///< kLocalMm2 of the floor, its edge included, lie so much below the ideal, or more
    /// Of a floor in separate pieces, the one whose mean error is largest; nothing for a floor in one piece. Pieces
    /// that share an edge or a corner of their columns are one.
    std::optional<PieceError> worstPiece;
    bool operator==(const DepthError&) const = default;
};

/// The roughness of a wall is measured against the mean of a stretch of the same wall of this length, mm.
inline constexpr double kRoughStretchMm = 2.0;

/// Distance between the outline cut and the ideal one, seen from above. A wall 0.5 mm over-extended is a moderate error
/// (docs/facts/teaching.md, section 4). Each point of either outline is asked how far the other is, so that an arm
/// which is missing and one that is too much both count; weighted by length.
struct OutlineDeviation
{
    double meanMm = 0.0;    ///< of the distance's size
    double signedMm = 0.0;  ///< positive where the cut is over-extended
    double p95Mm = 0.0;     ///< 95 % of the length are off by no more than this
    Placed overMm;          ///< farthest that the cut goes beyond the ideal, 0 or more
    Placed underMm;         ///< farthest that it stays behind, 0 or more
    /// Root mean square distance of the cut's outline from the ideal one, less the mean along kRoughStretchMm of the
    /// same wall: 0 for a smooth wall in the wrong place. The node is where it sticks out or in most.
    Placed roughnessMm;
    bool operator==(const OutlineDeviation&) const = default;
};

/// A floor as such: what is left when the form that the ideal gives to it has been taken off. It is to
/// be flat, parallel to the occlusal plane, with steps under 0.25 mm (docs/teeth.md, "Ideal preparations").
struct FloorForm
{
    double flatnessMm = 0.0;  ///< root mean square distance, along z, from the plane that fits the depth error best
    double slopeDeg = 0.0;    ///< of most of the floor: a gouge or a step does not tilt it
    Placed stepMm;            ///< largest change of the rest within kStepRunMm along x or y
    /// Mean depth of the floor below the enamel-dentin junction, mm (0.1 to 0.5 is ideal: docs/teeth.md); negative in
    /// enamel. Where there is a pulpal floor, the gingival floor of a box does not count. Nothing where the floor lies
    /// over no junction.
    std::optional<double> intoDentinMm;
    bool operator==(const FloorForm&) const = default;
};

/// The way in which a wall of the cut stands, in the tooth frame.
enum class Side { MinusX, PlusX, MinusY, PlusY };

/// What can be said of a cut, or of an ideal, by itself.
struct Form
{
    /// mm, the shortest run of cut across the isthmus of the preparation, 0 where the cut is interrupted there
    /// (docs/teeth.md, "Ideal preparations"). Nothing for a preparation without an isthmus, and without any cut.
    std::optional<Placed> isthmusMm;
    /// mm, least distance along x from the edge of the cut to the mesial and distal outline of the tooth, over the
    /// middle half of the tooth's rows, between the cusps: the marginal ridge that is left
    /// (docs/teeth.md, "Ideal preparations"). Only for a tooth of which it is known where mesial is, and with a cut
    /// there.
    std::optional<Placed> ridgeMesialMm;
    std::optional<Placed> ridgeDistalMm;
    /// mm, mean distance along Preparation::Box::outwards, in the middle half of the box, from the surface of the uncut
    /// tooth at the level of the ideal's gingival floor to the axial wall kAxialWallMm above that floor
    /// (docs/teeth.md). A shell that is left before the box does not count as the wall. 0 where nothing is cut. Nothing
    /// for a preparation without a box.
    std::optional<Placed> axialDepthMm;
    /// mm, narrowest width of the oblique ridge between the cuts on both sides of its crest, across the crest; 0 where
    /// the crest itself is cut. Nothing where no cut is near on one of the sides.
    std::optional<Placed> obliqueRidgeMm;
    /// Degrees from upright, positive where the wall opens towards the occlusal, of the walls that stand on each side
    /// of the cut, by Side (docs/teeth.md, "Ideal preparations"); the node is one on it.
    ///
    /// Between 2 and 75 % of the depth, so that neither a bevel nor the fillet of a round-ended bur counts. A column on
    /// the slope of a wall is an exact point of it: how the columns of a short stretch of wall recede with their depth
    /// gives the angle (least squares, with the direction and the bend of the stretch free). Where the stretches say
    /// nothing, since a steep wall stands along the lattice, the angle is that of the area which the slope covers seen
    /// from above over its area seen from the side: right on the average, but a wall that stands exactly along the
    /// lattice may be off by a cell over its height, 3 degrees on 1.5 mm at 150. A height is taken as that of its node:
    /// in a map of means over the cells an upright wall leans by as much.
    std::array<std::optional<Placed>, 4> wallDeg;
    bool operator==(const Form&) const = default;
};

/// Widths of the band around a shape of the practice pad in which a cut is forgiven.
struct Leeway
{
    double sidesMm = 0.25;
    double bottomMm = 0.25;
    bool operator==(const Leeway&) const = default;
};

/// The zones of the practice pad (docs/facts/teaching.md, section 5). Target: what the ideal takes away. Leeway bottom:
/// what lies below the target, down to Leeway::bottomMm. Leeway sides: columns beside the target within Leeway::sidesMm
/// of its edge, down to where the leeway bottom of the nearest target column ends. Container: all the rest; its bottom
/// lies below target or leeway sides, its sides beside them.
struct Zones
{
    double targetMm3 = 0.0;
    double leewaySidesMm3 = 0.0;
    double leewayBottomMm3 = 0.0;
    double targetRemovedMm3 = 0.0;
    double leewaySidesRemovedMm3 = 0.0;
    double leewayBottomRemovedMm3 = 0.0;
    Placed containerSidesMm3;                   ///< removed; the node where it was cut deepest
    Placed containerBottomMm3;                  ///< the same
    std::optional<std::size_t> targetLeftNode;  ///< where most of the target is left
    bool operator==(const Zones&) const = default;
};

/// A cut tooth against an ideal preparation. What is absent could not be measured.
struct Deviation
{
    double idealMm3 = 0.0;          ///< what the ideal takes away
    double removedMm3 = 0.0;        ///< what was taken away
    double overcutBesideMm3 = 0.0;  ///< taken away from columns that the ideal keeps
    double overcutBelowMm3 = 0.0;   ///< taken away below the ideal
    double undercutMm3 = 0.0;       ///< of the ideal, still there: under-cut, not a retentive undercut
    /// 2 |A and B| / (|A| + |B|) and |A and B| / |A or B| of removed and ideal volume. Nothing
    /// where neither is anything.
    std::optional<double> dice;
    std::optional<double> iou;
    /// Where a column was cut deepest beyond the ideal, and where most of the ideal is left.
    std::optional<std::size_t> overcutNode;
    std::optional<std::size_t> undercutNode;

    std::optional<DepthError> depth;  ///< nothing for an ideal without Floor
    /// mm, size of the error in height of the box's gingival floor: 95 % of its area are off by no more than this. The
    /// node is where it is largest. Nothing for an ideal without a box.
    std::optional<Placed> gingivalFloorErrorMm;
    std::optional<OutlineDeviation> outline;  ///< nothing unless both ideal and cut have an outline
    /// Distance of the cut outside the ideal outline from that outline, mm. At least kStrayMm2 of the cut are as far
    /// away. Only places that were lowered by kStrayDepthMm or more count.
    Placed beyondMm;
    std::optional<FloorForm> floor;  ///< nothing unless three columns of the Floor, not in a row, are cut
    Form form;                       ///< of the cut
    Form idealForm;                  ///< of the ideal, measured the same way
    /// mm3 of enamel that has lost its dentin (it breaks away: docs/teeth.md, "Ideal preparations"), and where
    /// its height is greatest. Counted is enamel still there of which one of these is true:
    ///  - decay is left straight below it;
    ///  - its rod was cut through on the way down to the enamel-dentin junction, or stands there on decay that is left.
    ///    Rods run about at right angles to the junction: the foot of a rod is the point of the junction that is
    ///    nearest. In slices of 0.05 mm.
    /// Nothing for a tooth without enamel on dentin.
    std::optional<Placed> unsupportedEnamelMm3;
    std::optional<Zones> zones;  ///< only if a leeway was given

    /// Of +y: 1 towards buccal, -1 towards lingual; 0 where nobody knows which side is which (a scan, a block).
    int buccalSign = 0;

    [[nodiscard]] double overcutMm3() const { return overcutBesideMm3 + overcutBelowMm3; }
    bool operator==(const Deviation&) const = default;
};

/// Measures a tooth against an ideal preparation for its anatomy. A few milliseconds at 150 x 150. Any thread that owns
/// the tooth. An error, one sentence, where the ideal is for another grid or holds what is no number (BadStructure,
/// BadNumber), or the leeway is below zero (OutOfRange).
///
/// The ideal is taken to lie between the surface of the uncut tooth and its under surface: what is beyond does not
/// count. A column cut through ends at the under surface.
[[nodiscard]] Result<Deviation> measureDeviation(const terrain::Tooth& tooth, const Preparation& ideal,
                                                 const std::optional<Leeway>& leeway = {});

}  // namespace core::grading
