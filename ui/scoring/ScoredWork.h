// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/grading/IdealCavity.h"
#include "core/grading/MeasureTable.h"
#include "core/grading/RuleChecker.h"
#include "core/terrain/Tooth.h"
#include "lessons/PresetFile.h"

namespace ui::scoring {

/// The graded tooth, with the data that shows where points were lost.
struct ScoredWork
{
    std::shared_ptr<const core::terrain::Tooth> tooth;
    core::grading::IdealTop ideal;  ///< the ideal surface; null: nothing had to be cut
    core::grading::Measured measured;
    std::vector<core::grading::Infraction> infractions{};
    std::uint8_t aids = 0;                              ///< bits of core::servo::Aid that were in use
    std::optional<::lessons::PresetUsed> preset{};      ///< the hardness preset in use; empty: unknown
    std::optional<core::grading::Exercise> exercise{};  ///< empty: not an exercise without cutting
};

/// Returns the height of a column above the ideal, mm; negative if it was cut too deep, 0 outside the tooth.
[[nodiscard]] float aboveIdeal(const ScoredWork& work, std::size_t k);

/// Returns the column with the largest deviation from the ideal; empty if there is none.
[[nodiscard]] std::optional<std::size_t> farthestOff(const ScoredWork& work);

}  // namespace ui::scoring
