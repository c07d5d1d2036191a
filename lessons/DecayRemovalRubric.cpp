// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/DecayRemovalRubric.h"

#include <array>
#include <cmath>
#include <string>

namespace lessons {

std::span<const RubricField> decayRemovalFields()
{
    using Rubric = DecayRemovalRubric;
    static constexpr std::array<RubricField, 12> kFields{{
        {"caries_free", "%", &Rubric::cariesFreePercent, 0.0, 100.0, false},
        {"caries_points", "points/%", &Rubric::pointsPerCariesPercent, 0.0, 100.0, false},
        {"caries_max", "points", &Rubric::cariesMaxPoints, 0.0, 100.0, true},
        {"sound_free", "mm3", &Rubric::soundFreeMm3, 0.0, 500.0, false},
        {"sound_free_per_cavity", "mm3/mm3", &Rubric::soundFreePerCavityMm3, 0.0, 10.0, false},
        {"sound_points", "points/mm3", &Rubric::pointsPerSoundMm3, 0.0, 100.0, false},
        {"sound_max", "points", &Rubric::soundMaxPoints, 0.0, 100.0, true},
        {"pulp_free", "mm2", &Rubric::pulpFreeMm2, 0.0, 10.0, false},
        {"pulp_max", "points", &Rubric::pulpMaxPoints, 0.0, 100.0, true},
        {"perforation_free", "mm2", &Rubric::perforationFreeMm2, 0.0, 10.0, false},
        {"perforation_max", "points", &Rubric::perforationMaxPoints, 0.0, 100.0, true},
        {"pass_mark", "points", &Rubric::passMark, 0.0, 100.0, true},
    }};
    return kFields;
}

core::Status validate(const DecayRemovalRubric& rubric)
{
    for (const RubricField& field : decayRemovalFields()) {
        const double value = rubric.*field.value;
        if (!std::isfinite(value) || value < field.minimum || value > field.maximum)
            return core::unexpected(core::ErrorCode::OutOfRange,
                                    std::string("rubric decay_removal: ") + field.id + " is " + std::to_string(value) +
                                        ", it must lie between " + std::to_string(field.minimum) + " and " +
                                        std::to_string(field.maximum) + " " + field.unit);
        if (field.whole && value != std::floor(value))
            return core::unexpected(core::ErrorCode::BadNumber, std::string("rubric decay_removal: ") + field.id +
                                                                    " is " + std::to_string(value) +
                                                                    ", it must be a whole number of points");
    }
    return {};
}

ScoreSheet grade(const core::grading::Measures& measures, const DecayRemovalRubric& rubric)
{
    const double cavityMm3 = measures.lesionMm3 + measures.accessMm3;
    const double soundFreeMm3 = rubric.soundFreeMm3 + rubric.soundFreePerCavityMm3 * cavityMm3;
    ScoreSheet sheet;
    sheet.rubricId = "decay_removal";
    sheet.rubricVersion = 2;
    sheet.passMark = static_cast<int>(rubric.passMark);
    sheet.criteria = {
        {"caries_left", measures.cariesLeftPercent, "%", rubric.cariesFreePercent, PointRule::PerUnit,
         rubric.pointsPerCariesPercent, static_cast<int>(rubric.cariesMaxPoints), false, 0},
        {"sound_tissue", measures.overcutMm3, "mm3", soundFreeMm3, PointRule::PerUnit, rubric.pointsPerSoundMm3,
         static_cast<int>(rubric.soundMaxPoints), false, 0},
        {"pulp_exposure", measures.pulpExposedMm2, "mm2", rubric.pulpFreeMm2, PointRule::Once, 0.0,
         static_cast<int>(rubric.pulpMaxPoints), true, 0},
        {"perforation", measures.perforatedMm2, "mm2", rubric.perforationFreeMm2, PointRule::Once, 0.0,
         static_cast<int>(rubric.perforationMaxPoints), true, 0},
    };
    addUp(sheet);
    return sheet;
}

}  // namespace lessons
