// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/base/Result.h"
#include "core/grading/Measures.h"
#include "lessons/ScoreSheet.h"

namespace lessons {

/// Remove the decay, spare the tooth, keep away from the pulp and do not go through. Every number is the teacher's to
/// set; the defaults are estimates that no study backs yet.
struct DecayRemovalRubric
{
    double cariesFreePercent = 1.0;  ///< of the lesion, may stay
    double pointsPerCariesPercent = 2.0;
    double cariesMaxPoints = 60.0;
    /// Sound tissue that may go: this much, and this much more for each mm3 of the smallest cavity that clears the
    /// decay (the lesion and what lies straight above it). A 0.8 mm bur led 0.1 to 0.25 mm outside generated lesions of
    /// extent 0.3, 0.5 and 0.8 takes 5 to 8, 14 to 20 and 26 to 38 mm3; this allows 7, 16 and 37.
    double soundFreeMm3 = 6.0;
    double soundFreePerCavityMm3 = 1.0;
    double pointsPerSoundMm3 = 1.5;
    double soundMaxPoints = 40.0;
    double pulpFreeMm2 = 0.0;             ///< pulp may be exposed so far without it counting
    double pulpMaxPoints = 100.0;         ///< lost at once, and the attempt is failed
    double perforationFreeMm2 = 0.0;      ///< hole through the tooth that does not count
    double perforationMaxPoints = 100.0;  ///< lost at once, and the attempt is failed
    double passMark = 75.0;
    bool operator==(const DecayRemovalRubric&) const = default;
};

/// One number of the rubric: what page, file and test show and check.
struct RubricField
{
    const char* id;
    const char* unit;
    double DecayRemovalRubric::*value;
    double minimum;
    double maximum;
    bool whole;  ///< points and marks are integers
};

[[nodiscard]] std::span<const RubricField> decayRemovalFields();

/// Whether every number lies in its range (and is whole where it must be); the sentence names the first that does not.
[[nodiscard]] core::Status validate(const DecayRemovalRubric& rubric);

/// Grades an attempt: criteria "caries_left" (% of the lesion), "sound_tissue" (mm3 of enamel and dentin removed beside
/// and below the lesion; what lies straight above it has to go and is not counted; `free` grows with the lesion),
/// "pulp_exposure" and "perforation" (mm2, both critical).
[[nodiscard]] ScoreSheet grade(const core::grading::Measures& measures, const DecayRemovalRubric& rubric = {});

}  // namespace lessons
