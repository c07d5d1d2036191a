// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/Result.h"
#include "core/base/Rng.h"
#include "core/teeth/OcclusalField.h"
#include "core/teeth/RootDesign.h"

namespace core::teeth {

/// Four values round the tooth: distal, buccal, mesial, lingual; in between a smooth wave.
using FourSides = std::array<double, 4>;

/// A groove that runs over the edge of the occlusal table on to the side of the crown.
struct SideGroove
{
    double angleDeg = 0.0;  ///< from distal towards buccal
    double depthMm = 0.0;
    double widthDeg = 8.0;
};

/// A curved furrow on the side that sets a tubercle off from its cusp, as Carabelli's.
struct SideFurrow
{
    double angleDeg = 0.0;
    double widthDeg = 14.0;
    double place = 0.85;  ///< share of the way from the centre to the height of contour
    double depthMm = 0.0;
};

/// Everything that makes the crown of a premolar or molar that tooth and not its neighbour. Mean tooth, design frame of
/// Lobe. The figures of 36 and 24 were fitted to scans, the others follow the anatomy of docs/teeth.md.
struct PosteriorDesign
{
    /// Radius of the height of contour seen from above, every 22.5 degrees from distal (0) over buccal (90) and mesial
    /// (180) to lingual (270). Control values of a periodic cubic B-spline.
    std::array<double, 16> outline{};
    FourSides contourZ{};      ///< height of the greatest bulge
    FourSides domeRise{};      ///< how far the side would rise above the contour, were there no cusps
    FourSides domePower{};     ///< small: tapering sides, large: upright ones
    double shoulderMm = 0.45;  ///< how softly the sides turn into the occlusal table
    double blendMm = 0.35;     ///< how softly lobe meets lobe above the fissure
    double furrows = 0.05;     ///< supplemental ridges and furrows, see OcclusalField
    double cervixX = 0.0;      ///< centre of the section at the CEJ
    double cervixY = 0.0;
    double cervixPower = 2.3;  ///< superellipse of that section
    double fissureMm = 0.7;    ///< depth of the main fissures below the groove floor
    double mouthMm = 0.27;     ///< their width at the floor
    std::vector<Lobe> lobes;
    std::vector<SideGroove> sideGrooves;
    std::vector<SideFurrow> sideFurrows;
    RootDesign roots;
};

/// The mean design of a premolar or molar, with the variants that nature has (Carabelli's cusp, a missing distolingual
/// one, two- or three-cusped 35) chosen by the generator; its mean is chosen where `vary` is false.
[[nodiscard]] PosteriorDesign posteriorDesign(int fdi, Rng& rng, bool vary);

}  // namespace core::teeth
