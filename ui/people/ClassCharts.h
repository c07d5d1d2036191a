// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include <QString>

#include "database/ClassOverview.h"
#include "ui/charts/Chart.h"

/// Charts of a class at one lesson. Empty for fewer than lessons::kFewestPeople students.
namespace ui::people {

/// Returns a chart of the distribution of scores.
/// @param passMarkTenths  0: unknown
[[nodiscard]] charts::Chart distributionChart(const database::LessonResults& results, int passMarkTenths);
/// Returns a chart of the middle half of the class, attempt by attempt.
[[nodiscard]] charts::Chart learningChart(const database::LessonResults& results, int passMarkTenths);
/// Returns a chart of the points lost at each criterion.
/// @param names  of the criteria, by id
[[nodiscard]] charts::Chart difficultyChart(const database::LessonResults& results,
                                            const std::map<std::string, QString>& names);
/// Returns a sentence such as "18 of 23 passed, after 2.4 attempts on the average; first attempts came to 58.3", or the
/// reason why there are too few students for it.
[[nodiscard]] QString difficultyWords(const database::LessonDifficulty& difficulty);

}  // namespace ui::people
