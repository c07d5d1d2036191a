// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/Result.h"
#include "core/base/Rng.h"
#include "core/teeth/OcclusalField.h"
#include "core/teeth/RootDesign.h"

namespace core::teeth {

/// Four values around the tooth: distal, buccal, mesial, lingual; with a smooth wave between them.
using FourSides = std::array<double, 4>;

/// A groove that continues over the edge of the occlusal table to the side of the crown.
struct SideGroove
{
    double angleDeg = 0.0;  ///< from distal towards buccal
    double depthMm = 0.0;
    double widthDeg = 8.0;
};

/// A curved furrow on the side that separates a tubercle from its cusp, such as Carabelli's.
struct SideFurrow
{
    double angleDeg = 0.0;
    double widthDeg = 14.0;
    double place = 0.85;  ///< share of the distance from the centre to the height of contour
    double depthMm = 0.0;
};

/// The parameters of the crown of a premolar or molar. Mean tooth, design frame of Lobe. The values of 36 and 24 were
/// fitted to scans, the others follow the anatomy of docs/teeth.md.
struct PosteriorDesign
{
    /// Radius of the height of contour seen from above, every 22.5 degrees from distal (0) over buccal (90) and mesial
    /// (180) to lingual (270). Control values of a periodic cubic B-spline.
    std::array<double, 16> outline{};
    FourSides contourZ{};      ///< height of the greatest bulge
    FourSides domeRise{};      ///< height of the side above the contour without cusps
    FourSides domePower{};     ///< small: tapering sides, large: upright sides
    double shoulderMm = 0.45;  ///< softness of the transition from the sides to the occlusal table
    double blendMm = 0.35;     ///< softness of the transition between lobes above the fissure
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

/// Returns the mean design of a premolar or molar. If `vary` is true, the generator chooses natural variants
/// (Carabelli's cusp, a missing distolingual one, two- or three-cusped 35); otherwise the mean.
[[nodiscard]] PosteriorDesign posteriorDesign(int fdi, Rng& rng, bool vary);

}  // namespace core::teeth
