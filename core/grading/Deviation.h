// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/base/Result.h"
#include "core/grading/Preparation.h"
#include "core/terrain/Tooth.h"

/// The deviation of a cut tooth from the ideal preparation. Sums, minima and maxima over columns in index order, with
/// no library function but the square root: the same bits on every machine. Not measured, because a height map cannot
/// represent them: undercuts, and walls that converge towards the occlusal, which read as upright.
///
/// A column represents its cell, and is cut or not: the place of an upright wall is known to half a cell. For a wall at
/// an angle to the lattice this averages out; along the lattice it adds up in volumes, widths and outlines.
namespace core::grading {

/// A value and the node of the grid where it is most visible.
struct Placed
{
    double value = 0.0;
    std::size_t node = 0;
    bool operator==(const Placed&) const = default;
};

/// Depth that defines the outline of a cut, mm: a shallower mark is a scratch. At a wall that leans out by 10 degrees
/// that is 0.02 mm inside its upper edge.
inline constexpr double kOutlineDepthMm = 0.1;

/// Margin of the floor, mm: columns nearer than this, along x or y, to a column that is no Floor do not count for the
/// floor, because a wall that is a cell off is an error of the outline and not of the depth. If there are no others,
/// they count.
inline constexpr double kFloorMarginMm = 0.2;

/// Height above the ideal floor at which the axial wall of a box is measured, mm: above the rounded edge between floor
/// and wall.
inline constexpr double kAxialWallMm = 0.3;

/// Distance along x or y between the two places of a step of the floor, mm.
inline constexpr double kStepRunMm = 0.2;

/// Area from which on a place that is too deep counts, mm2: about that of a small bur's end.
inline constexpr double kLocalMm2 = 0.5;

/// Depth and area from which on a cut elsewhere is more than a scratch that is polished away, mm and mm2.
inline constexpr double kStrayDepthMm = 0.2;
inline constexpr double kStrayMm2 = 0.1;

/// Distance between places for the slope of a floor, mm.
inline constexpr double kSlopeRunMm = 0.3;

/// One of several separate pieces of a floor, such as one of a row of pits.
struct PieceError
{
    double meanMm = 0.0;   ///< mean error in height, as below: negative is too deep
    double depthMm = 0.0;  ///< mean depth of the ideal there, below the uncut surface
    std::size_t node = 0;  ///< a node in it
    bool operator==(const PieceError&) const = default;
};

/// Depth of the floor against the ideal (docs/teeth.md, "Ideal preparations": depth of the floor).
/// The error of a column is its height minus the ideal height: negative is too deep.
struct DepthError
{
    double meanMm = 0.0;        ///< mean of the absolute error
    double signedMm = 0.0;      ///< mean of the error
    double p95Mm = 0.0;         ///< 95th percentile of the absolute error by area
    Placed tooDeepMm;           ///< largest depth of the floor below the ideal, 0 or more
    Placed tooShallowMm;        ///< largest height of the floor above the ideal, 0 or more
    double deepP95Mm = 0.0;     ///< 95 % of the floor's area are no deeper below the ideal than this
    double shallowP95Mm = 0.0;  ///< 95 % of the floor's area are no higher above the ideal than this
    Placed gougeMm;             ///< an area of kLocalMm2 of the floor, its edge included, is this deep below the ideal
                                ///< or deeper
    /// For a floor in separate pieces, the piece with the largest mean error; empty for a floor in one piece. Pieces
    /// that share an edge or a corner of their columns are one.
    std::optional<PieceError> worstPiece;
    bool operator==(const DepthError&) const = default;
};

/// Length of wall over which its mean is taken for the roughness, mm.
inline constexpr double kRoughStretchMm = 2.0;

/// Distance between the outline of the cut and that of the ideal, seen from above. A wall over-extended by 0.5 mm is a
/// moderate error (docs/facts/teaching.md, section 4). The distance is measured from each point of either outline to
/// the other, so that a missing arm and an extra one both count; weighted by length.
struct OutlineDeviation
{
    double meanMm = 0.0;    ///< mean of the absolute distance
    double signedMm = 0.0;  ///< mean; positive where the cut is over-extended
    double p95Mm = 0.0;     ///< 95th percentile of the absolute distance by length
    Placed overMm;          ///< largest distance of the cut beyond the ideal, 0 or more
    Placed underMm;         ///< largest distance of the cut behind the ideal, 0 or more
    /// Root mean square distance of the cut's outline from the ideal one, minus the mean along kRoughStretchMm of the
    /// same wall: 0 for a smooth wall in the wrong place. The node is where the wall deviates most.
    Placed roughnessMm;
    bool operator==(const OutlineDeviation&) const = default;
};

/// The evenness of a floor, after the form of the ideal floor has been subtracted. A floor should be flat, parallel to
/// the occlusal plane, with steps under 0.25 mm (docs/teeth.md, "Ideal preparations").
struct FloorForm
{
    double flatnessMm = 0.0;  ///< root mean square distance, along z, from the plane that fits the depth error best
    double slopeDeg = 0.0;    ///< of most of the floor: a gouge or a step does not tilt it
    Placed stepMm;            ///< largest change of the remainder within kStepRunMm along x or y
    /// Mean depth of the floor below the enamel-dentin junction, mm (0.1 to 0.5 is ideal: docs/teeth.md); negative in
    /// enamel. If there is a pulpal floor, the gingival floor of a box does not count. Empty if the floor is over no
    /// junction.
    std::optional<double> intoDentinMm;
    bool operator==(const FloorForm&) const = default;
};

/// The direction in which a wall of the cut faces, in the tooth frame.
enum class Side { MinusX, PlusX, MinusY, PlusY };

/// Measures of a cut, or of an ideal, on its own.
struct Form
{
    /// The shortest width of cut across the isthmus of the preparation, mm; 0 where the cut is interrupted there
    /// (docs/teeth.md, "Ideal preparations"). Empty for a preparation without an isthmus, and without any cut.
    std::optional<Placed> isthmusMm;
    /// The marginal ridges that are left: least distance along x from the edge of the cut to the mesial and distal
    /// outline of the tooth, mm, over the middle half of the tooth's rows, between the cusps (docs/teeth.md, "Ideal
    /// preparations"). Empty if it is unknown which side is mesial, or if there is no cut.
    std::optional<Placed> ridgeMesialMm;
    std::optional<Placed> ridgeDistalMm;
    /// Mean distance along Preparation::Box::outwards, mm, in the middle half of the box, from the surface of the uncut
    /// tooth at the level of the ideal's gingival floor to the axial wall kAxialWallMm above that floor
    /// (docs/teeth.md). A shell left in front of the box does not count as the wall. 0 where nothing is cut. Empty for
    /// a preparation without a box.
    std::optional<Placed> axialDepthMm;
    /// Narrowest width of the oblique ridge between the cuts on both sides of its crest, across the crest, mm; 0 where
    /// the crest itself is cut. Empty if there is no cut near one of the sides.
    std::optional<Placed> obliqueRidgeMm;
    /// The mean angle of the walls on each side of the cut from upright, degrees, by Side; positive if the wall opens
    /// towards the occlusal (docs/teeth.md, "Ideal preparations"). The node is one on the wall.
    ///
    /// Measured between 2 and 75 % of the depth, so that neither a bevel nor the fillet of a round-ended bur counts. A
    /// column on the slope of a wall is an exact point of it: the change of the columns' distance with their depth
    /// along a short stretch of wall gives the angle (least squares, with the direction and the bend of the stretch
    /// free). If the stretches give no angle, because a steep wall runs along the lattice, the angle follows from the
    /// area of the slope seen from above over its area seen from the side: right on average, but for a wall exactly
    /// along the lattice it may be off by a cell over its height, 3 degrees on 1.5 mm at 150. A height is taken as that
    /// of its node: in a map of means over the cells an upright wall leans by that much.
    std::array<std::optional<Placed>, 4> wallDeg;
    bool operator==(const Form&) const = default;
};

/// Width of the zone around a shape of the practice pad in which a cut costs no points.
struct Leeway
{
    double sidesMm = 0.25;
    double bottomMm = 0.25;
    bool operator==(const Leeway&) const = default;
};

/// The zones of the practice pad (docs/facts/teaching.md, section 5). Target: the volume that the ideal removes. Leeway
/// bottom: the volume below the target, down to Leeway::bottomMm. Leeway sides: columns beside the target within
/// Leeway::sidesMm of its edge, down to where the leeway bottom of the nearest target column ends. Container: the rest;
/// its bottom is below target or leeway sides, its sides are beside them.
struct Zones
{
    double targetMm3 = 0.0;
    double leewaySidesMm3 = 0.0;
    double leewayBottomMm3 = 0.0;
    double targetRemovedMm3 = 0.0;
    double leewaySidesRemovedMm3 = 0.0;
    double leewayBottomRemovedMm3 = 0.0;
    Placed containerSidesMm3;                   ///< removed; the node of the deepest cut
    Placed containerBottomMm3;                  ///< likewise
    std::optional<std::size_t> targetLeftNode;  ///< the node with most of the target left
    bool operator==(const Zones&) const = default;
};

/// A cut tooth compared with an ideal preparation. Empty members could not be measured.
struct Deviation
{
    double idealMm3 = 0.0;          ///< volume that the ideal removes
    double removedMm3 = 0.0;        ///< volume removed
    double overcutBesideMm3 = 0.0;  ///< removed from columns that the ideal keeps
    double overcutBelowMm3 = 0.0;   ///< removed below the ideal
    double undercutMm3 = 0.0;       ///< part of the ideal that is left: under-cut, not a retentive undercut
    /// 2 |A and B| / (|A| + |B|) and |A and B| / |A or B| of removed and ideal volume. Empty if both are 0.
    std::optional<double> dice;
    std::optional<double> iou;
    /// The columns of the deepest cut beyond the ideal, and with most of the ideal left.
    std::optional<std::size_t> overcutNode;
    std::optional<std::size_t> undercutNode;

    std::optional<DepthError> depth;  ///< empty for an ideal without Floor
    /// Absolute error in height of the box's gingival floor, mm: 95 % of its area are off by no more than this. The
    /// node is that of the largest error. Empty for an ideal without a box.
    std::optional<Placed> gingivalFloorErrorMm;
    std::optional<OutlineDeviation> outline;  ///< empty unless both ideal and cut have an outline
    /// Distance of the cut outside the ideal outline from that outline, mm. At least kStrayMm2 of the cut are as far
    /// away. Only places that were lowered by kStrayDepthMm or more count.
    Placed beyondMm;
    std::optional<FloorForm> floor;  ///< empty unless three columns of the Floor, not in a row, are cut
    Form form;                       ///< of the cut
    Form idealForm;                  ///< of the ideal, measured the same way
    /// Enamel without dentin below it, mm3, which would break away (docs/teeth.md, "Ideal preparations"); the node is
    /// where its height is greatest. Remaining enamel counts if one of these is true:
    ///  - decay is left straight below it;
    ///  - its rod was cut through between it and the enamel-dentin junction, or ends there on decay that is left. Rods
    /// run about at right angles to the junction: the foot of a rod is the nearest point of the junction. In slices of
    /// 0.05 mm.
    /// Empty for a tooth without enamel on dentin.
    std::optional<Placed> unsupportedEnamelMm3;
    std::optional<Zones> zones;  ///< only if a leeway was given

    /// Side of +y: 1 buccal, -1 lingual, 0 unknown (a scan, a block).
    int buccalSign = 0;

    [[nodiscard]] double overcutMm3() const { return overcutBesideMm3 + overcutBelowMm3; }
    bool operator==(const Deviation&) const = default;
};

/// Measures a tooth against an ideal preparation for its anatomy. A few milliseconds at 150 x 150. Any thread that owns
/// the tooth. Errors, one sentence each: an ideal for another grid or with values that are not numbers (BadStructure,
/// BadNumber), or a leeway below zero (OutOfRange).
///
/// The ideal is clamped to the range between the surface of the uncut tooth and its under surface. A column that was
/// cut through ends at the under surface.
[[nodiscard]] Result<Deviation> measureDeviation(const terrain::Tooth& tooth, const Preparation& ideal,
                                                 const std::optional<Leeway>& leeway = {});

}  // namespace core::grading
