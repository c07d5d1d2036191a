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

/// How a cut lies to the lesion it was made for.
struct LesionCut
{
    /// mm2, seen from above, in which decay is left within kAtJunctionMm of the junction, and deeper; the node is where
    /// most of it is left.
    Placed junctionMm2;
    Placed floorMm2;
    /// mm that kStrayMm2 of the cut are away from the smallest cavity, or farther, seen from above. Counted is what was
    /// lowered by kStrayDepthMm or more.
    Placed beyondMm;
    /// mm that kLocalMm2 of the cut lie below the lesion, or more: below the lowest floor of decay within
    /// kLesionReachMm. Nothing counts that is farther from the lesion.
    Placed belowMm;
    /// As in Form.
    std::optional<Placed> ridgeMesialMm;
    std::optional<Placed> ridgeDistalMm;
    /// mm, how much thinner one of them is than the smallest cavity would leave it, 0 or more; 0 where there are none.
    Placed ridgeLostMm;
    bool operator==(const LesionCut&) const = default;
};

/// Nothing for a tooth without a lesion. Some milliseconds at 150 x 150. Any thread that owns the tooth.
[[nodiscard]] std::optional<LesionCut> measureLesionCut(const terrain::Tooth& tooth);

}  // namespace core::grading
