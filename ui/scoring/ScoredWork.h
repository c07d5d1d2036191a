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

/// The tooth that a score was given for: what the card needs to show where points were lost.
struct ScoredWork
{
    std::shared_ptr<const core::terrain::Tooth> tooth;
    core::grading::IdealTop ideal;  ///< what was asked for; null: that nothing be cut
    core::grading::Measured measured;
    std::vector<core::grading::Infraction> infractions{};
    std::uint8_t aids = 0;                              ///< bits of core::servo::Aid that were in use
    std::optional<::lessons::PresetUsed> preset{};      ///< that it was made with; nothing where that is not known
    std::optional<core::grading::Exercise> exercise{};  ///< what was practised; nothing where something was to be cut
};

/// How far a column ends above the ideal, mm: negative where it was cut too deep. 0 outside the tooth.
[[nodiscard]] float aboveIdeal(const ScoredWork& work, std::size_t k);

/// The column with the largest deviation from the ideal; empty if there is none.
[[nodiscard]] std::optional<std::size_t> farthestOff(const ScoredWork& work);

}  // namespace ui::scoring
