// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "core/grading/IdealCavity.h"
#include "core/terrain/Tooth.h"

namespace core::grading {

/// The effect of an attempt on a tooth. Every value is a sum, minimum or maximum over columns: exact for the model, and
/// the same bits on every machine. Not measured, because a height map cannot represent them: undercuts and walls past
/// 90 degrees.
struct Measures
{
    /// Volume removed of each material, mm3: caries, enamel, dentin, pulp.
    terrain::PerMaterial removedMm3{};

    /// Volume of the lesion before cutting, mm3.
    double lesionMm3 = 0.0;
    /// Part of lesionMm3 that may stay (decayGoesDownTo()), mm3; 0 if the decay has no zones.
    double decayToKeepMm3 = 0.0;
    /// Volume of the lesion still in the tooth, mm3.
    double cariesLeftMm3 = 0.0;
    /// cariesLeftMm3 in per cent of lesionMm3; 0 for a tooth without a lesion.
    double cariesLeftPercent = 0.0;
    /// Volume of the largest remaining piece of the lesion, mm3; columns belong together if they share an edge and
    /// their decay overlaps in height.
    double largestIslandMm3 = 0.0;

    /// Volume of sound enamel and dentin straight above decay that must be removed, mm3: an upright handpiece cannot
    /// reach the decay without removing them.
    double accessMm3 = 0.0;
    /// Volume of sound enamel and dentin removed elsewhere, beside or below the lesion, mm3.
    double overcutMm3 = 0.0;

    /// Largest lowering of the surface, mm; the full height of the tooth for a column that was cut through.
    double deepestCutMm = 0.0;
    /// Area, seen from above, of the columns cut down to or through the pulp, mm2.
    double pulpExposedMm2 = 0.0;
    /// Area, seen from above, of holes through the tooth that were not asked for, mm2.
    double perforatedMm2 = 0.0;
    /// There is a pulp and a cut; otherwise remainingOverPulpMm has no meaning.
    bool hasRemainingOverPulp = false;
    /// Shortest distance in any direction from a cut surface to the pulp, mm; 0 where it is exposed. All material in
    /// between counts, dentin or remaining decay. Nodes are points: exact to one cell sideways. Distances over 5 mm are
    /// reported as 5.
    double remainingOverPulpMm = 0.0;

    /// The columns where these are worst, for a section through them; empty if there is none: most decay left, most
    /// overcut, deepestCutMm, the cut nearest to the pulp or deepest in it.
    std::optional<std::size_t> cariesLeftNode;
    std::optional<std::size_t> overcutNode;
    std::optional<std::size_t> deepestCutNode;
    std::optional<std::size_t> pulpNode;

    bool operator==(const Measures&) const = default;
};

/// Returns the volume that column k adds to overcutMm3 with its top at `top` (kEmptyTop if it is cut through), mm3.
[[nodiscard]] double overcutOf(const terrain::ToothAnatomy& anatomy, std::size_t k, float top);

/// Measures a finished or running attempt. A few milliseconds at 150 x 150. Any thread that owns the tooth.
/// @param ideal  over the tooth's grid: its holes are no perforations. May be null
[[nodiscard]] Measures measure(const terrain::Tooth& tooth, const IdealTop& ideal = nullptr);

}  // namespace core::grading
