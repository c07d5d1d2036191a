// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/grading/Deviation.h"
#include "core/terrain/Tooth.h"

namespace core::grading {

/// Decay left so near to the enamel-dentin junction, above or below it, is decay at the junction: there it spreads and
/// undermines. What lies deeper is decay on the floor.
inline constexpr double kAtJunctionMm = 0.5;

/// The floor of a lesion is followed by a bur no finer than this: next to a deep place its neighbours may be as deep.
inline constexpr double kLesionReachMm = 0.8;

/// What is left of decay that has zones (terrain::DecayZones).
struct DecayZonesLeft
{
    /// Per cent of the soft zone; the node is where most of it is left.
    Placed softPercent;
    /// mm2, seen from above, in which leathery or soft decay is left that does not lie over the pulp (isOverPulp()).
    Placed leatheryMm2;
    bool operator==(const DecayZonesLeft&) const = default;
};

/// How a cut lies to the lesion it was made for.
struct LesionCut
{
    /// mm2, seen from above, in which decay is left within kAtJunctionMm of the junction, and deeper; the node is where
    /// most of it is left.
    Placed junctionMm2;
    Placed floorMm2;
    /// Distance of the cut from the smallest cavity, mm, seen from above. At least kStrayMm2 of the cut are as far
    /// away. Only places that were lowered by kStrayDepthMm or more count.
    Placed beyondMm;
    /// Depth of the cut below the smallest cavity, mm: below the lowest of it within kLesionReachMm. At least kLocalMm2
    /// of the cut are as deep. Places farther from the lesion do not count.
    Placed belowMm;
    /// As in Form.
    std::optional<Placed> ridgeMesialMm;
    std::optional<Placed> ridgeDistalMm;
    /// mm, how much thinner one of them is than the smallest cavity would leave it, 0 or more; 0 where there are none.
    Placed ridgeLostMm;
    std::optional<DecayZonesLeft> zones = {};  ///< empty where decay has none
    bool operator==(const LesionCut&) const = default;
};

/// Measures how the cut in a tooth lies to its lesion. Returns nothing for a tooth without a lesion. Takes some
/// milliseconds at 150 x 150. Any thread that owns the tooth may call it.
[[nodiscard]] std::optional<LesionCut> measureLesionCut(const terrain::Tooth& tooth);

}  // namespace core::grading
