// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <QString>

#include "lessons/ScoreSheet.h"
#include "ui/scoring/ScoredWork.h"

namespace ui::scoring {

/// Returns the difference between the points that a student expected and the score, in words.
[[nodiscard]] QString expectationWords(int expectedTenths, int totalTenths);

/// Returns the criterion that a student expected to cost most, and the one that did, in words.
/// @param expected  id of a criterion; the sheet may not contain it
[[nodiscard]] QString expectedWorstWords(const std::string& expected, const ::lessons::ScoreSheet& sheet);

/// Returns the result of an exercise. Empty if the exercise is unknown.
[[nodiscard]] QString practisedWords(const ScoredWork& work);

/// Returns the column below a point that should have been touched and was not. Empty if there is none.
[[nodiscard]] std::optional<std::size_t> missedNode(const ScoredWork& work);

/// Returns the rubric of a score: its name, version and the beginning of its hash.
[[nodiscard]] QString rubricWords(const ::lessons::ScoreSheet& sheet);

}  // namespace ui::scoring
