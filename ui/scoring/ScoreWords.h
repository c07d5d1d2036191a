// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <QString>

#include "lessons/ScoreSheet.h"
#include "ui/scoring/ScoredWork.h"

namespace ui::scoring {

/// Returns how far the points that a student expected are from the score.
[[nodiscard]] QString expectationWords(int expectedTenths, int totalTenths);

/// Returns what a student expected to cost most, and what did cost most.
/// @param expected  id of a criterion; may be one that the sheet does not have
[[nodiscard]] QString expectedWorstWords(const std::string& expected, const ::lessons::ScoreSheet& sheet);

/// Returns the result of an exercise. Empty if the exercise is not known.
[[nodiscard]] QString practisedWords(const ScoredWork& work);

/// Returns the column under a point that had to be touched and was not. Empty if there is none.
[[nodiscard]] std::optional<std::size_t> missedNode(const ScoredWork& work);

/// Returns the rubric of a score: its name, version and the beginning of its hash.
[[nodiscard]] QString rubricWords(const ::lessons::ScoreSheet& sheet);

}  // namespace ui::scoring
