// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/grading/Deviation.h"
#include "core/terrain/Tooth.h"

namespace core::grading {

/// Distance from the enamel-dentin junction, above or below, within which remaining decay is decay at the junction,
/// where it spreads and undermines. Deeper decay is decay on the floor.
inline constexpr double kAtJunctionMm = 0.5;

/// Radius around a column within which the lowest floor of the lesion applies, mm: a bur cannot follow the floor more
/// finely.
inline constexpr double kLesionReachMm = 0.8;

/// The decay that is left, for decay with zones (terrain::DecayZones).
struct DecayZonesLeft
{
    /// Share of the soft zone that is left, per cent; the node is where most of it is left.
    Placed softPercent;
    /// Area, seen from above, with leathery or soft decay left that is not over the pulp (isOverPulp()), mm2.
    Placed leatheryMm2;
    bool operator==(const DecayZonesLeft&) const = default;
};

/// A cut compared with the lesion that it was made for.
struct LesionCut
{
    /// Areas, seen from above, with decay left within kAtJunctionMm of the junction, and deeper, mm2; the node is where
    /// most of it is left.
    Placed junctionMm2;
    Placed floorMm2;
    /// Distance of the cut from the smallest cavity, mm, seen from above. At least kStrayMm2 of the cut are as far
    /// away. Only places that were lowered by kStrayDepthMm or more count.
    Placed beyondMm;
    /// Depth of the cut below the smallest cavity, mm: below its lowest place within kLesionReachMm. At least kLocalMm2
    /// of the cut are as deep. Places farther from the lesion do not count.
    Placed belowMm;
    /// As in Form.
    std::optional<Placed> ridgeMesialMm;
    std::optional<Placed> ridgeDistalMm;
    /// Largest loss of one of the ridges compared with the smallest cavity, mm, 0 or more; 0 if there are none.
    Placed ridgeLostMm;
    std::optional<DecayZonesLeft> zones = {};  ///< empty if the decay has no zones
    bool operator==(const LesionCut&) const = default;
};

/// Measures a cut against the lesion of its tooth. Empty for a tooth without a lesion. Some milliseconds at 150 x 150.
/// Any thread that owns the tooth.
[[nodiscard]] std::optional<LesionCut> measureLesionCut(const terrain::Tooth& tooth);

}  // namespace core::grading
