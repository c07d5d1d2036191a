// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "core/grading/IdealCavity.h"
#include "core/terrain/Tooth.h"

namespace core::grading {

/// What an attempt did to a tooth. Every figure is a sum, minimum or maximum over columns: exact for the model, the
/// same bits on every machine. Not measured, because a height map cannot hold it: undercuts, walls past 90 degrees.
struct Measures
{
    /// mm3 of each material removed: caries, enamel, dentin, pulp.
    terrain::PerMaterial removedMm3{};

    /// mm3 of the lesion before anything was cut.
    double lesionMm3 = 0.0;
    /// mm3 of it that need not be removed (decayGoesDownTo()); 0 where decay has no zones.
    double decayToKeepMm3 = 0.0;
    /// mm3 of the lesion still in the tooth.
    double cariesLeftMm3 = 0.0;
    /// cariesLeftMm3 in per cent of lesionMm3; 0 for a tooth without a lesion.
    double cariesLeftPercent = 0.0;
    /// mm3 of the largest piece of lesion left; columns hang together where they share an edge and their decay overlaps
    /// in height.
    double largestIslandMm3 = 0.0;

    /// mm3 of sound enamel and dentin that lie straight above decay that has to go: a handpiece held upright cannot
    /// reach the decay without taking them.
    double accessMm3 = 0.0;
    /// mm3 of sound enamel and dentin removed elsewhere: beside the lesion or below it.
    double overcutMm3 = 0.0;

    /// mm, largest lowering of the surface; over the full height of the tooth where a column was cut through.
    double deepestCutMm = 0.0;
    /// mm2, area of the columns, seen from above, that were cut down to pulp or through it.
    double pulpExposedMm2 = 0.0;
    /// mm2, area of the columns of holes that go right through the tooth, seen from above, where none was asked for.
    double perforatedMm2 = 0.0;
    /// True if there is a pulp and a cut; only then does remainingOverPulpMm say anything.
    bool hasRemainingOverPulp = false;
    /// mm, shortest straight distance in any direction from a cut surface to the pulp; 0 where it is exposed. What lies
    /// between, dentin or decay left behind, is counted. Nodes are points: true to one cell sideways. Distances over
    /// 5 mm read 5.
    double remainingOverPulpMm = 0.0;

    /// The columns where these are worst, for a section through them; nothing where there is none: most decay left,
    /// most overcut, deepestCutMm, the cut that is nearest to the pulp or deepest in it.
    std::optional<std::size_t> cariesLeftNode;
    std::optional<std::size_t> overcutNode;
    std::optional<std::size_t> deepestCutNode;
    std::optional<std::size_t> pulpNode;

    bool operator==(const Measures&) const = default;
};

/// mm3 that column k adds to overcutMm3 when its top is at `top` (kEmptyTop if it is cut through).
[[nodiscard]] double overcutOf(const terrain::ToothAnatomy& anatomy, std::size_t k, float top);

/// Measures a finished (or running) attempt. A few milliseconds at 150 x 150. Any thread that owns the tooth.
/// @param ideal  over the tooth's grid: what it cuts through is no perforation. May be null
[[nodiscard]] Measures measure(const terrain::Tooth& tooth, const IdealTop& ideal = nullptr);

}  // namespace core::grading
